#include "ui/forces/force_table_model.h"

#include <utility>

namespace geargraph {

void ForceTableModel::show(const ForcesPtr& forces, ForceTableKind kind) {
  const bool isOther = std::exchange(m_kind, kind) != kind;
  m_forces = forces;
  showTable(std::shared_ptr<const ValueTable>(forces, table()), isOther);
}

}  // namespace geargraph

#include "moc_force_table_model.cpp"

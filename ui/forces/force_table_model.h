#pragma once

#include "ui/forces/value_table_model.h"
#include "ui/workbench/forces_service.h"

namespace geargraph {

/// One table of statics.
class ForceTableModel : public ValueTableModel {
  Q_OBJECT

 public:
  using ValueTableModel::ValueTableModel;

  /// The table of `forces` of this kind; without rows if there is none.
  void show(const ForcesPtr& forces, ForceTableKind kind);
  [[nodiscard]] ForceTableKind kind() const { return m_kind; }
  /// Null if there is none.
  [[nodiscard]] const ForceTable* table() const { return m_forces ? m_forces->table(m_kind) : nullptr; }

 private:
  ForcesPtr m_forces;
  ForceTableKind m_kind = ForceTableKind::joints;
};

}  // namespace geargraph

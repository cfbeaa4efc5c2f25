#pragma once

#include <QAbstractTableModel>
#include <set>

#include "ui/statics/forces_service.h"

namespace geargraph::inline forces {

/// One table of statics. Fractions stand beside their decimals; every cell explains its column as a tooltip.
class ForceTableModel : public QAbstractTableModel {
  Q_OBJECT

 public:
  using QAbstractTableModel::QAbstractTableModel;

  /// The table of `forces` of this kind; without rows where there is none.
  void show(const ForcesPtr& forces, ForceTableKind kind);
  [[nodiscard]] ForceTableKind kind() const { return m_kind; }
  /// Null where there is none.
  [[nodiscard]] const ForceTable* table() const { return m_forces ? m_forces->table(m_kind) : nullptr; }
  [[nodiscard]] std::set<ElementId> elementsAt(int row) const;

  [[nodiscard]] int rowCount(const QModelIndex& parent = {}) const override;
  [[nodiscard]] int columnCount(const QModelIndex& parent = {}) const override;
  [[nodiscard]] QVariant data(const QModelIndex& index, int role = Qt::DisplayRole) const override;
  [[nodiscard]] QVariant headerData(int section, Qt::Orientation orientation,
                                    int role = Qt::DisplayRole) const override;

 private:
  ForcesPtr m_forces;
  ForceTableKind m_kind = ForceTableKind::joints;
};

}  // namespace geargraph::inline forces

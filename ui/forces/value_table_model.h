#pragma once

#include <QAbstractTableModel>
#include <memory>
#include <set>

#include "core/teaching/force_tables/force_table.h"

namespace geargraph {

/// A table of values with definitions. Fractions are shown beside their decimals; the tool tip of a cell
/// explains its column.
class ValueTableModel : public QAbstractTableModel {
  Q_OBJECT

 public:
  using QAbstractTableModel::QAbstractTableModel;

  /// Shows a table; null: no rows. Selection and scroll position of views are kept if only numbers change;
  /// `isOther`: treat it as a different table, whatever its shape.
  void showTable(std::shared_ptr<const ValueTable> table, bool isOther = false);
  /// Null if there is none.
  [[nodiscard]] const std::shared_ptr<const ValueTable>& shownTable() const { return m_table; }
  /// The elements that are highlighted with a row.
  [[nodiscard]] std::set<ElementId> elementsAt(int row) const;
  /// The first row about one of these elements; -1: none.
  [[nodiscard]] int rowOf(const std::set<ElementId>& elements) const;

  [[nodiscard]] int rowCount(const QModelIndex& parent = {}) const override;
  [[nodiscard]] int columnCount(const QModelIndex& parent = {}) const override;
  [[nodiscard]] QVariant data(const QModelIndex& index, int role = Qt::DisplayRole) const override;
  [[nodiscard]] QVariant headerData(int section, Qt::Orientation orientation,
                                    int role = Qt::DisplayRole) const override;

 private:
  std::shared_ptr<const ValueTable> m_table;
};

}  // namespace geargraph

#pragma once

#include <QAbstractTableModel>
#include <memory>
#include <set>

#include "core/teaching/force_tables/force_table.h"

namespace geargraph::inline forces {

/// A table of values with definitions. Fractions stand beside their decimals; every cell explains its column
/// as a tooltip.
class ValueTableModel : public QAbstractTableModel {
  Q_OBJECT

 public:
  using QAbstractTableModel::QAbstractTableModel;

  /// Without rows where it is null. The selection and the scroll position of views stay while only numbers
  /// change; `isOther`: it is another table, whatever its shape.
  void showTable(std::shared_ptr<const ValueTable> table, bool isOther = false);
  /// Null where there is none.
  [[nodiscard]] const std::shared_ptr<const ValueTable>& shownTable() const { return m_table; }
  /// What lights up with a row.
  [[nodiscard]] std::set<ElementId> elementsAt(int row) const;
  /// The first row that is about one of these; -1: none is.
  [[nodiscard]] int rowOf(const std::set<ElementId>& elements) const;

  [[nodiscard]] int rowCount(const QModelIndex& parent = {}) const override;
  [[nodiscard]] int columnCount(const QModelIndex& parent = {}) const override;
  [[nodiscard]] QVariant data(const QModelIndex& index, int role = Qt::DisplayRole) const override;
  [[nodiscard]] QVariant headerData(int section, Qt::Orientation orientation,
                                    int role = Qt::DisplayRole) const override;

 private:
  std::shared_ptr<const ValueTable> m_table;
};

}  // namespace geargraph::inline forces

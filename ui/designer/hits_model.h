#pragma once

#include <QAbstractTableModel>
#include <vector>

#include "ui/designer/designer_services.h"

namespace geargraph::inline designer {

/// The gearboxes that were found, in the order of ranksBefore().
class HitsModel final : public QAbstractTableModel {
  Q_OBJECT

 public:
  enum Column { number, elements, error, efficiency, teeth, drawable, columns };
  /// By what a column is sorted: a number, or for teeth a text.
  static constexpr int SortRole = Qt::UserRole;

  using QAbstractTableModel::QAbstractTableModel;

  /// Forgets all.
  void startAnew(GearboxWishPtr wish);
  /// Puts each where it ranks.
  void add(const std::vector<GearboxPtr>& found);
  [[nodiscard]] const GearboxWishPtr& wish() const { return m_wish; }
  [[nodiscard]] const GearboxPtr& at(int row) const { return m_hits[static_cast<std::size_t>(row)]; }
  /// -1 if it is not in the list.
  [[nodiscard]] int rowOf(const GearboxPtr& gearbox) const;

  [[nodiscard]] int rowCount(const QModelIndex& parent = {}) const override;
  [[nodiscard]] int columnCount(const QModelIndex& parent = {}) const override;
  [[nodiscard]] QVariant data(const QModelIndex& index, int role = Qt::DisplayRole) const override;
  [[nodiscard]] QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

 private:
  [[nodiscard]] QString textAt(int row, int column) const;
  [[nodiscard]] QVariant sortKeyAt(int row, int column) const;

  GearboxWishPtr m_wish;
  std::vector<GearboxPtr> m_hits;
};

}  // namespace geargraph::inline designer

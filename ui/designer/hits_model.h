#pragma once

#include <QAbstractTableModel>
#include <QSortFilterProxyModel>
#include <optional>
#include <vector>

#include "ui/designer/designer_services.h"
#include "ui/designer/hit_filter.h"
#include "ui/designer/hit_words.h"

namespace geargraph {

/// The gearboxes that were found, in the order of ranksBefore(), and which of them are ticked for comparison.
class HitsModel final : public QAbstractTableModel {
  Q_OBJECT

 public:
  enum Column {
    number,
    levers,     ///< a picture
    schematic,  ///< a picture
    elements,   ///< dots, a column a gear
    error,
    efficiency,
    circulating,
    speed,
    torque,
    drawable,
    columns
  };
  /// By what a column is sorted.
  static constexpr int SortRole = Qt::UserRole;
  /// "0.005 %" and "in 8" of a column with a measure.
  static constexpr int ValueRole = Qt::UserRole + 1;
  static constexpr int GearRole = Qt::UserRole + 2;
  static constexpr int WarningRole = Qt::UserRole + 3;
  static constexpr std::size_t kMaxTicked = 2;

  using QAbstractTableModel::QAbstractTableModel;

  /// The measure of a column; none of a column of another kind.
  [[nodiscard]] static std::optional<HitMeasure> measureOf(int column);

  /// Forgets all.
  void startAnew(GearboxWishPtr wish);
  /// Puts each where it ranks.
  void add(const std::vector<GearboxPtr>& found);
  [[nodiscard]] const GearboxWishPtr& wish() const { return m_wish; }
  [[nodiscard]] const std::vector<GearboxPtr>& all() const { return m_hits; }
  [[nodiscard]] const GearboxPtr& at(int row) const { return m_hits[static_cast<std::size_t>(row)]; }
  /// -1 if it is not in the list.
  [[nodiscard]] int rowOf(const GearboxPtr& gearbox) const;

  /// Ticks a gearbox, or takes its tick; of three the one ticked first is let go.
  void setTicked(const GearboxPtr& gearbox, bool isTicked);
  /// In the order in which they were ticked.
  [[nodiscard]] const std::vector<GearboxPtr>& ticked() const { return m_ticked; }
  [[nodiscard]] bool isTicked(const GearboxPtr& gearbox) const;
  /// A picture has been drawn anew.
  void repaintPictures();

  [[nodiscard]] int rowCount(const QModelIndex& parent = {}) const override;
  [[nodiscard]] int columnCount(const QModelIndex& parent = {}) const override;
  [[nodiscard]] QVariant data(const QModelIndex& index, int role = Qt::DisplayRole) const override;
  bool setData(const QModelIndex& index, const QVariant& value, int role) override;
  [[nodiscard]] Qt::ItemFlags flags(const QModelIndex& index) const override;
  [[nodiscard]] QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

 signals:
  void tickedChanged();

 private:
  [[nodiscard]] QString textAt(int row, int column) const;
  [[nodiscard]] QVariant sortKeyAt(int row, int column) const;

  GearboxWishPtr m_wish;
  std::vector<GearboxPtr> m_hits;
  std::vector<GearboxPtr> m_ticked;
};

/// Those of the list that are shown, sorted by a column.
class ShownHits final : public QSortFilterProxyModel {
  Q_OBJECT

 public:
  explicit ShownHits(HitsModel* hits, QObject* parent = nullptr);

  /// Shows all again.
  void startAnew();
  void setFilter(const HitFilter& filter);
  [[nodiscard]] const HitFilter& filter() const { return m_filter; }
  void hideHit(const GearboxPtr& gearbox);
  /// Shows the gearbox that was hidden last. False if none is hidden.
  bool showLastHidden();
  void showAllHidden();
  [[nodiscard]] int hiddenCount() const { return static_cast<int>(m_hidden.size()); }
  [[nodiscard]] const GearboxPtr& at(const QModelIndex& index) const;

 signals:
  /// Other rows are shown, by a filter or because one was hidden.
  void choiceChanged();

 protected:
  [[nodiscard]] bool filterAcceptsRow(int row, const QModelIndex& parent) const override;

 private:
  void updateChoice();

  HitsModel* m_hits;
  HitFilter m_filter;
  std::vector<GearboxPtr> m_hidden;  ///< the last one hidden last
};

}  // namespace geargraph

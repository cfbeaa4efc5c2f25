#pragma once

#include <QSortFilterProxyModel>
#include <QStyledItemDelegate>
#include <QTableView>

#include "ui/designer/hits_model.h"

namespace geargraph::inline designer {

/// Paints the elements that gears engage as a table of dots, a column a gear; other cells as text.
class EngagedDelegate final : public QStyledItemDelegate {
  Q_OBJECT

 public:
  using QStyledItemDelegate::QStyledItemDelegate;
  void paint(QPainter* painter, const QStyleOptionViewItem& option, const QModelIndex& index) const override;
  [[nodiscard]] QSize sizeHint(const QStyleOptionViewItem& option, const QModelIndex& index) const override;

 protected:
  void initStyleOption(QStyleOptionViewItem* option, const QModelIndex& index) const override;
};

/// The list of what was found. Its rows keep their places on the screen while others come in.
class HitsTable final : public QTableView {
  Q_OBJECT

 public:
  explicit HitsTable(QWidget* parent = nullptr);

  void startAnew(GearboxWishPtr wish);
  void add(const std::vector<GearboxPtr>& found);
  [[nodiscard]] const HitsModel& hits() const { return m_hits; }
  /// Null if none is chosen.
  [[nodiscard]] GearboxPtr chosen() const;

 signals:
  void chosenChanged();
  /// Return, or a double click.
  void openWanted();

 protected:
  void keyPressEvent(QKeyEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;

 private:
  void fitRows();
  void copyRow();

  HitsModel m_hits;
  QSortFilterProxyModel m_order;
};

}  // namespace geargraph::inline designer

#pragma once

#include <QStyledItemDelegate>
#include <QTableView>

#include "ui/designer/hit_pictures.h"
#include "ui/designer/hits_model.h"

namespace geargraph {

/// Paints the cells of a gearbox: pictures, the engaged elements as a table of dots with a column a gear, and
/// measures with the gear where they are below.
class HitDelegate final : public QStyledItemDelegate {
  Q_OBJECT

 public:
  HitDelegate(HitPictures* pictures, QObject* parent) : QStyledItemDelegate(parent), m_pictures(pictures) {}

  void paint(QPainter* painter, const QStyleOptionViewItem& option, const QModelIndex& index) const override;
  [[nodiscard]] QSize sizeHint(const QStyleOptionViewItem& option, const QModelIndex& index) const override;
  /// The box of a row's tick in the cell of its number.
  [[nodiscard]] static QRect tickBox(const QRect& cell);

 private:
  void paintDots(QPainter& painter, const QStyleOptionViewItem& option, const Gearbox& hit) const;
  void paintNumber(QPainter& painter, const QStyleOptionViewItem& option, const QModelIndex& index) const;
  void paintMeasure(QPainter& painter, const QStyleOptionViewItem& option, const QModelIndex& index) const;

  HitPictures* m_pictures;
};

/// The list of what was found. Its rows keep their places on the screen while others come in.
class HitsTable final : public QTableView {
  Q_OBJECT

 public:
  explicit HitsTable(QWidget* parent = nullptr);

  void startAnew(const GearboxWishPtr& wish);
  void add(const std::vector<GearboxPtr>& found);
  [[nodiscard]] HitsModel& hits() { return m_hits; }
  [[nodiscard]] const HitsModel& hits() const { return m_hits; }
  [[nodiscard]] ShownHits& shown() { return m_shown; }
  [[nodiscard]] const HitPictures& pictures() const { return m_pictures; }
  /// Null if none is chosen.
  [[nodiscard]] GearboxPtr chosen() const;
  void choose(const GearboxPtr& gearbox);

 signals:
  void chosenChanged();
  /// Return, or a double click.
  void openWanted();
  /// Ctrl+F.
  void filterWanted();
  void picturesDrawn();

 protected:
  bool event(QEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void paintEvent(QPaintEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;

 private:
  void fitRows();
  void giveColumns();
  void copyRow();
  void toggleTick(const QModelIndex& index);
  void hideChosen();

  HitsModel m_hits;
  ShownHits m_shown;
  HitPictures m_pictures;
};

}  // namespace geargraph

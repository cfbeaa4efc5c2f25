#pragma once

#include <QFont>
#include <QHash>
#include <QHeaderView>
#include <QPixmap>
#include <QStyledItemDelegate>

#include "ui/selection/selection.h"

namespace geargraph::inline panels {

/// Paints the cells of the results: rates, formulas in the gear ratios, numbers.
class ResultsDelegate : public QStyledItemDelegate {
  Q_OBJECT

 public:
  ResultsDelegate(Selection* selection, QObject* parent);

  void paint(QPainter* painter, const QStyleOptionViewItem& option, const QModelIndex& index) const override;
  /// The pixels that the cell wants. Texts are measured once for a font.
  [[nodiscard]] int widthOf(const QModelIndex& index, const QFont& font) const;

 private:
  [[nodiscard]] int measured(const QModelIndex& index, const QString& text) const;

  Selection* m_selection;
  mutable QFont m_font;  ///< of the widths
  mutable QHash<QString, int> m_widths;
};

/// The heads of the columns: the rates of the inputs.
class ResultsHeader : public QHeaderView {
  Q_OBJECT

 public:
  explicit ResultsHeader(QWidget* parent);

 signals:
  void sectionHovered(int section);  ///< -1: none

 protected:
  void paintSection(QPainter* painter, const QRect& rect, int section) const override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void leaveEvent(QEvent* event) override;
};

/// Paints the absolute velocities: the link's disc before its name.
class LinkSpeedsDelegate : public QStyledItemDelegate {
  Q_OBJECT

 public:
  LinkSpeedsDelegate(Selection* selection, QObject* parent);
  void paint(QPainter* painter, const QStyleOptionViewItem& option, const QModelIndex& index) const override;
  [[nodiscard]] QSize sizeHint(const QStyleOptionViewItem& option, const QModelIndex& index) const override;

 private:
  Selection* m_selection;
};

/// A disc in the colour that the link has in every view.
void paintLinkDot(QPainter& painter, const QPointF& centre, int linkLabel);
/// The same as a picture of 12 by 12 logical pixels.
[[nodiscard]] QPixmap linkDot(int linkLabel, qreal pixelRatio);

}  // namespace geargraph::inline panels

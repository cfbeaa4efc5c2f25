#pragma once

#include <QFont>
#include <QHash>
#include <QHeaderView>
#include <QPixmap>
#include <QStyledItemDelegate>

#include "ui/document/selection.h"

namespace geargraph {

/// Paints the cells of the results: rates, formulas in the gear ratios, numbers.
class ResultsDelegate : public QStyledItemDelegate {
  Q_OBJECT

 public:
  ResultsDelegate(Selection* selection, QObject* parent);

  void paint(QPainter* painter, const QStyleOptionViewItem& option, const QModelIndex& index) const override;
  /// The preferred width of the cell in pixels. Widths of texts are cached per font.
  [[nodiscard]] int widthOf(const QModelIndex& index, const QFont& font) const;
  /// The width of a first cell without the name of its link, which a narrower column shortens first.
  [[nodiscard]] static int leastWidthOf(const QModelIndex& index, const QFont& font);

 private:
  [[nodiscard]] int measured(const QModelIndex& index, const QString& text) const;

  Selection* m_selection;
  mutable QFont m_font;  ///< of m_widths
  mutable QHash<QString, int> m_widths;
};

/// The column headings: the rates of the inputs.
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

/// Paints the absolute velocities, with a coloured dot before each link's name.
class LinkSpeedsDelegate : public QStyledItemDelegate {
  Q_OBJECT

 public:
  LinkSpeedsDelegate(Selection* selection, QObject* parent);
  void paint(QPainter* painter, const QStyleOptionViewItem& option, const QModelIndex& index) const override;
  [[nodiscard]] QSize sizeHint(const QStyleOptionViewItem& option, const QModelIndex& index) const override;

 private:
  Selection* m_selection;
};

/// Paints a dot in the colour that the link has in all views.
void paintLinkDot(QPainter& painter, const QPointF& centre, int colorNumber);
/// The same as a pixmap of 12 by 12 logical pixels.
[[nodiscard]] QPixmap linkDot(int colorNumber, qreal pixelRatio);

}  // namespace geargraph

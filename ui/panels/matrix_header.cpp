#include "ui/panels/matrix_header.h"

#include <QMouseEvent>
#include <QPainter>

#include "ui/models/matrix_model.h"
#include "ui/panels/rate_label.h"
#include "ui/theme/application_theme.h"

namespace geargraph {

void paintBracket(QPainter& painter, int x, int top, int bottom, int hook) {
  painter.drawPolyline(
      QPolygon({QPoint(x + hook, top), QPoint(x, top), QPoint(x, bottom), QPoint(x + hook, bottom)}));
}

MatrixHeader::MatrixHeader(Qt::Orientation orientation, std::function<bool(int section)> isHighlighted,
                           QWidget* parent)
    : QHeaderView(orientation, parent), m_isHighlighted(std::move(isHighlighted)) {
  setMouseTracking(true);
  setSectionResizeMode(QHeaderView::Fixed);
  setHighlightSections(false);
  setSectionsClickable(true);
  setMinimumSectionSize(8);
}

QSize MatrixHeader::sizeHint() const {
  if (orientation() == Qt::Horizontal) return {0, scaledPixels(30)};
  const int rows = count();
  const QString widest = rows == 0 ? QString() : model()->headerData(rows - 1, Qt::Vertical).toString();
  const bool rate = rows > 0 && model()->headerData(rows - 1, Qt::Vertical, MatrixModel::RateRole).toBool();
  const int width = rate ? static_cast<int>(paintRate(nullptr, font(), {}, widest))
                         : QFontMetrics(font()).horizontalAdvance(widest);
  return {width + 34 + kMatrixBracket, 0};
}

void MatrixHeader::paintSection(QPainter* painter, const QRect& rect, int section) const {
  const Theme theme = themeOf(palette());
  const bool across = orientation() == Qt::Horizontal;
  const bool highlighted = m_isHighlighted(section);
  const bool isPreview = model()->headerData(section, orientation(), MatrixModel::PreviewRole).toBool();

  painter->save();
  QFont labelFont = font();
  labelFont.setBold(highlighted);
  labelFont.setItalic(isPreview);
  painter->setFont(labelFont);
  painter->setPen(qColor(highlighted ? ColorRole::accent : ColorRole::secondary, theme));
  const QString text = model()->headerData(section, orientation()).toString();
  const bool last = across && section == count() - 1;
  const int margin = across ? (last ? kMatrixBracket : 0) : kMatrixBracket + 8;
  const QRect room = rect.adjusted(0, 0, -margin, 0);
  if (model()->headerData(section, orientation(), MatrixModel::RateRole).toBool()) {
    const double advance = paintRate(nullptr, labelFont, {}, text);
    const QFontMetricsF metrics(labelFont);
    const double base = QRectF(room).center().y() + (metrics.ascent() - metrics.descent()) / 2;
    const double left = across ? QRectF(room).center().x() - advance / 2 : room.right() - advance;
    paintRate(painter, labelFont, {left, base}, text);
  } else {
    painter->drawText(room, across ? int(Qt::AlignCenter) : int(Qt::AlignRight | Qt::AlignVCenter), text);
  }
  painter->restore();
}

void MatrixHeader::paintEvent(QPaintEvent* event) {
  QHeaderView::paintEvent(event);
  if (orientation() == Qt::Horizontal || count() == 0) return;
  QPainter painter(viewport());
  painter.setPen(QPen(qColor(ColorRole::ink, themeOf(palette())), 2));
  const int last = count() - 1;
  paintBracket(painter, viewport()->width() - kMatrixBracket + 5, sectionViewportPosition(0) + 1,
               sectionViewportPosition(last) + sectionSize(last) - 1, 7);
}

void MatrixHeader::mouseMoveEvent(QMouseEvent* event) {
  QHeaderView::mouseMoveEvent(event);
  const int section = logicalIndexAt(event->pos());
  if (section == m_hovered) return;
  m_hovered = section;
  emit sectionHovered(section);
}

void MatrixHeader::leaveEvent(QEvent* event) {
  QHeaderView::leaveEvent(event);
  m_hovered = -1;
  emit sectionHovered(-1);
}

}  // namespace geargraph

#include "moc_matrix_header.cpp"

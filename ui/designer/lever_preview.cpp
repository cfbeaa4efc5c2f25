#include "ui/designer/lever_preview.h"

#include <QPainter>
#include <algorithm>

#include "ui/canvas/mark_painter.h"
#include "ui/theme/theme_colors.h"

namespace geargraph::inline designer {

LeverPreview::LeverPreview(QWidget* parent) : QWidget(parent) {
  setObjectName(QStringLiteral("hitLevers"));
  setAccessibleName(tr("Lever diagram of the chosen gearbox in first gear"));
  setMinimumHeight(150);
  setBackgroundRole(QPalette::Base);
  setAutoFillBackground(true);
}

void LeverPreview::setDrawing(DisplayList drawing) {
  m_drawing = std::move(drawing);
  update();
}

void LeverPreview::paintEvent(QPaintEvent* /*event*/) {
  if (m_drawing.marks.empty()) return;
  constexpr double kLargest = 1.2;
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  const QRectF all = toQRect(extentOf(m_drawing));
  const QRectF room = QRectF(rect()).adjusted(8, 8, -8, -8);
  const double scale = std::min(
      {room.width() / std::max(all.width(), 1.0), room.height() / std::max(all.height(), 1.0), kLargest});
  painter.translate(room.center());
  painter.scale(scale, scale);
  painter.translate(-all.center());
  paintMarks(painter, m_drawing.marks, themeOf(palette()), scale);
}

}  // namespace geargraph::inline designer

#include "moc_lever_preview.cpp"

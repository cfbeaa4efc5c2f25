#include "ui/canvas/drawing_preview.h"

#include <QPainter>

#include "ui/canvas/mark_painter.h"
#include "ui/theme/theme_colors.h"

namespace geargraph {

DrawingPreview::DrawingPreview(QWidget* parent) : QWidget(parent) {
  setMinimumSize(120, 130);
  setBackgroundRole(QPalette::Base);
  setAutoFillBackground(true);
}

void DrawingPreview::setDrawing(DisplayList drawing) {
  m_drawing = std::move(drawing);
  update();
}

void DrawingPreview::paintEvent(QPaintEvent* /*event*/) {
  constexpr double kLargest = 1.2;
  constexpr double kMargin = 6;
  if (m_drawing.marks.empty()) return;
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  paintFitted(painter, m_drawing, QRectF(rect()).adjusted(kMargin, kMargin, -kMargin, -kMargin),
              themeOf(palette()), kLargest);
}

}  // namespace geargraph

#include "moc_drawing_preview.cpp"

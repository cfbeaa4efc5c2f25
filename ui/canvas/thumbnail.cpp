#include "ui/canvas/thumbnail.h"

#include <QPainter>

#include "core/presentation/drawing/digraph_drawing.h"
#include "core/presentation/drawing/layout.h"
#include "ui/canvas/mark_painter.h"

namespace geargraph {
namespace {
constexpr double kMargin = 24;         ///< sheet units round the drawing
constexpr double kLargestScale = 1.4;  ///< a lone node is not blown up
}  // namespace

std::optional<QImage> digraphThumbnail(const Mechanism& mechanism, Theme theme, QSize pixels) {
  if (mechanism.n() > kMaxThumbnailLinks) return std::nullopt;
  const DigraphGeometry geometry = digraphGeometry(mechanism, completedPositions(mechanism));
  const DisplayList drawing = digraphDrawing(geometry, {});
  const QRectF all = toQRect(extentOf(drawing)).adjusted(-kMargin, -kMargin, kMargin, kMargin);
  const double scale =
      std::min({pixels.width() / all.width(), pixels.height() / all.height(), kLargestScale});
  QImage image(pixels, QImage::Format_ARGB32_Premultiplied);
  image.fill(Qt::transparent);
  QPainter painter(&image);
  painter.setRenderHints(QPainter::Antialiasing | QPainter::TextAntialiasing);
  painter.translate(QPointF(pixels.width(), pixels.height()) / 2);
  painter.scale(scale, scale);
  painter.translate(-all.center());
  paintMarks(painter, drawing.marks, theme, scale);
  return image;
}

}  // namespace geargraph

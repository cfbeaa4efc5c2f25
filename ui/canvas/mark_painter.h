#pragma once

#include <QColor>
#include <QPointF>
#include <QRectF>
#include <vector>

#include "core/presentation/drawing/display_list.h"

class QPainter;

namespace geargraph::inline canvas {

[[nodiscard]] inline QColor toQColor(Color color) {
  return {color.red, color.green, color.blue};
}
[[nodiscard]] inline QPointF toQPoint(SheetPoint p) {
  return {p.x, p.y};
}
[[nodiscard]] inline SheetPoint toSheetPoint(QPointF p) {
  return {p.x(), p.y()};
}
[[nodiscard]] inline QRectF toQRect(const Extent& extent) {
  return {extent.left(), extent.top(), 2 * extent.halfWidth, 2 * extent.halfHeight};
}

/// Paints marks in their order, in sheet coordinates: what the screen, PDF and pictures share. `scale` is how
/// many pixels a unit of the sheet takes; what would be too small to be seen is left out.
void paintMarks(QPainter& painter, const std::vector<Mark>& marks, Theme theme, double scale);

}  // namespace geargraph::inline canvas

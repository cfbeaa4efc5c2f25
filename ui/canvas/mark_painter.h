#pragma once

#include <QColor>
#include <QPointF>
#include <QRectF>
#include <vector>

#include "core/presentation/drawing/display_list.h"

class QPainter;

namespace geargraph {

[[nodiscard]] inline QColor toQColor(Color color) {
  return {color.red, color.green, color.blue};
}
[[nodiscard]] inline QPointF toQPoint(CanvasPoint p) {
  return {p.x, p.y};
}
[[nodiscard]] inline CanvasPoint toSheetPoint(QPointF p) {
  return {p.x(), p.y()};
}
[[nodiscard]] inline QRectF toQRect(const Extent& extent) {
  return {extent.left(), extent.top(), 2 * extent.halfWidth, 2 * extent.halfHeight};
}

/// Paints marks in order, in sheet coordinates: for screen, PDF and pictures. `scale`: pixels per unit of the
/// sheet; marks too small to be visible are left out.
void paintMarks(QPainter& painter, const std::vector<Mark>& marks, Theme theme, double scale);

/// Paints a drawing in the middle of an area, as large as it fits, but at most `largest` pixels per unit of
/// the sheet. An empty one is not painted.
void paintFitted(QPainter& painter, const DisplayList& drawing, const QRectF& area, Theme theme,
                 double largest);

}  // namespace geargraph

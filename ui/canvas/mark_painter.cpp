#include "ui/canvas/mark_painter.h"

#include <QFont>
#include <QFontMetricsF>
#include <QPainter>
#include <QPainterPath>
#include <QTextLayout>
#include <algorithm>
#include <optional>

namespace geargraph {
namespace {

constexpr double kSmallestText = 4;     ///< px on screen
constexpr double kSmallestArrow = 0.2;  ///< scale
constexpr double kSmallestDash = 0.3;
constexpr double kThinnestLine = 0.7;    ///< px on screen
constexpr double kSmallestCircle = 1.2;  ///< px on screen, its radius: a smaller one is a dot

QPen penOf(const Stroke& stroke, Theme theme, double scale) {
  const double width = std::max(stroke.width, kThinnestLine / scale);
  QPen pen(toQColor(colorOf(stroke.tint, theme)), width, Qt::SolidLine, Qt::FlatCap, Qt::MiterJoin);
  const auto dashes = [&](const QList<qreal>& px) {
    QList<qreal> pattern;  // Qt counts in widths of the pen
    for (const qreal length : px) pattern << length / width;
    pen.setDashPattern(pattern);
  };
  if (scale < kSmallestDash) return pen;
  switch (stroke.dash) {
    case Dash::solid:
      break;
    case Dash::dashed:
      dashes({6.5, 4.5});
      break;
    case Dash::dashDotted:
      dashes({12, 3, 2, 3});
      break;
    case Dash::dotted:
      pen.setCapStyle(Qt::RoundCap);
      dashes({0.1, 6});
      break;
  }
  return pen;
}

constexpr double kBandWidth = 4;  ///< of soft strokes: wider ones are bands under other marks
constexpr double kBandOutline = 1.5;

constexpr double kLong = 1500;  ///< px on screen, of a line that is worth cutting

/// The part of a long line that can be seen, and how much of it is hidden before. Qt breaks a line into
/// dashes as a whole, thousands of them beyond the edges of the window.
struct VisiblePart {
  Curve curve;
  double hidden = 0;
};
std::optional<VisiblePart> visiblePart(const QPainter& painter, const Curve& curve, double width) {
  constexpr int kPieces = 32;
  const QRectF window = painter.worldTransform().inverted().mapRect(QRectF(painter.viewport()));
  const Extent seen =
      Extent{toSheetPoint(window.center()), window.width() / 2, window.height() / 2}.grown(width);
  int first = kPieces;
  int last = -1;
  double hidden = 0;
  double travelled = 0;
  for (int i = 0; i < kPieces; ++i) {
    const CanvasPoint from = curve.at(static_cast<double>(i) / kPieces);
    const CanvasPoint to = curve.at(static_cast<double>(i + 1) / kPieces);
    if (seen.meetsSegment(from, to)) {
      if (last < 0) hidden = travelled;
      first = std::min(first, i);
      last = i;
    }
    travelled += distance(from, to);
  }
  if (last < 0) return std::nullopt;
  return VisiblePart{
      curve.part(static_cast<double>(first) / kPieces, static_cast<double>(last + 1) / kPieces), hidden};
}

/// Draws a shape with the painter's pen and brush.
struct ShapePainter {
  QPainter& painter;

  void operator()(const Circle& circle) const {
    painter.drawEllipse(toQPoint(circle.center), circle.radius, circle.radius);
  }
  void operator()(const Box& box) const {
    painter.drawRoundedRect(toQRect(box.extent), box.corner, box.corner);
  }
  void operator()(const Polyline& line) const {
    // Qt paints a straight line in a third of the time of a polygon's side.
    if (line.points.size() == 2) {
      painter.drawLine(toQPoint(line.points[0]), toQPoint(line.points[1]));
      return;
    }
    QPolygonF points;
    for (const CanvasPoint p : line.points) points << toQPoint(p);
    line.closed ? painter.drawPolygon(points) : painter.drawPolyline(points);
  }
  void operator()(const Curve& curve) const {
    if (curve.isStraight()) {
      painter.drawLine(toQPoint(curve.from), toQPoint(curve.to));
      return;
    }
    QPainterPath path(toQPoint(curve.from));
    path.cubicTo(toQPoint(curve.leaving), toQPoint(curve.arriving), toQPoint(curve.to));
    painter.drawPath(path);
  }
};

/// The centre line of a stroke; empty for circles and boxes.
QPainterPath pathOf(const Shape& shape) {
  if (const auto* curve = std::get_if<Curve>(&shape)) {
    QPainterPath path(toQPoint(curve->from));
    path.cubicTo(toQPoint(curve->leaving), toQPoint(curve->arriving), toQPoint(curve->to));
    return path;
  }
  const auto* line = std::get_if<Polyline>(&shape);
  if (line == nullptr || line->points.size() < 2) return {};
  QPainterPath path(toQPoint(line->points.front()));
  for (std::size_t i = 1; i < line->points.size(); ++i) path.lineTo(toQPoint(line->points[i]));
  if (line->closed) path.closeSubpath();
  return path;
}

struct MarkPainter {
  QPainter& painter;
  Theme theme;
  double scale;
  MarkRole role;

  /// A circle of a pixel or two: Qt paints a square in a fraction of the time, and the difference cannot be
  /// seen.
  bool paintedAsDot(const Shape& shape, const QColor& color) const {
    const auto* circle = std::get_if<Circle>(&shape);
    if (circle == nullptr || circle->radius * scale >= kSmallestCircle) return false;
    const QPointF corner(circle->radius, circle->radius);
    painter.fillRect(QRectF(toQPoint(circle->center) - corner, toQPoint(circle->center) + corner), color);
    return true;
  }

  /// At high contrast a soft colour is hardly one: a band is its outline in the full colour.
  bool paintedAsOutline(const Stroke& stroke) const {
    if (theme != Theme::highContrast || !stroke.tint.soft || stroke.width < kBandWidth) return false;
    const QPainterPath path = pathOf(stroke.shape);
    if (path.isEmpty()) return false;
    QPainterPathStroker around;
    around.setWidth(stroke.width - kBandOutline);
    around.setCapStyle(Qt::FlatCap);
    around.setJoinStyle(Qt::MiterJoin);
    Tint full = stroke.tint;
    full.soft = false;
    painter.setPen(QPen(toQColor(colorOf(full, theme)), std::max(kBandOutline, kThinnestLine / scale)));
    painter.setBrush(Qt::NoBrush);
    painter.drawPath(around.createStroke(path).simplified());
    return true;
  }

  void operator()(const Stroke& stroke) const {
    if (paintedAsOutline(stroke)) return;
    if (paintedAsDot(stroke.shape, toQColor(colorOf(stroke.tint, theme)))) return;
    QPen pen = penOf(stroke, theme, scale);
    painter.setBrush(Qt::NoBrush);
    const auto* curve = std::get_if<Curve>(&stroke.shape);
    if (curve == nullptr || distance(curve->from, curve->to) * scale < kLong) {
      painter.setPen(pen);
      std::visit(ShapePainter{painter}, stroke.shape);
      return;
    }
    const std::optional<VisiblePart> part = visiblePart(painter, *curve, pen.widthF());
    if (!part) return;
    pen.setDashOffset(part->hidden / pen.widthF());
    painter.setPen(pen);
    ShapePainter{painter}(part->curve);
  }
  void operator()(const Fill& fill) const {
    if (role == MarkRole::arrowhead && scale < kSmallestArrow) return;
    const QColor color = toQColor(colorOf(fill.tint, theme));
    if (paintedAsDot(fill.shape, color)) return;
    painter.setPen(Qt::NoPen);
    painter.setBrush(color);
    std::visit(ShapePainter{painter}, fill.shape);
  }
  void operator()(const Text& text) const {
    if (text.size * scale < kSmallestText) return;
    QFont font = painter.font();
    font.setPixelSize(static_cast<int>(text.size));
    font.setBold(text.bold);
    painter.setFont(font);
    painter.setPen(toQColor(colorOf(text.tint, theme)));
    // Measured and painted, it is laid out once.
    QTextLayout layout(QString::fromStdString(text.text), font);
    layout.beginLayout();
    const QTextLine line = layout.createLine();
    layout.endLayout();
    const double baseline = text.center.y + QFontMetricsF(font).capHeight() / 2;
    layout.draw(&painter, {text.center.x - line.naturalTextWidth() / 2, baseline - line.ascent()});
  }
};

}  // namespace

void paintMarks(QPainter& painter, const std::vector<Mark>& marks, Theme theme, double scale) {
  for (const Mark& mark : marks) std::visit(MarkPainter{painter, theme, scale, mark.role}, mark.what);
}

void paintFitted(QPainter& painter, const DisplayList& drawing, const QRectF& area, Theme theme,
                 double largest) {
  if (drawing.marks.empty()) return;
  const QRectF all = toQRect(extentOf(drawing));
  const double scale = std::min(
      {area.width() / std::max(all.width(), 1.0), area.height() / std::max(all.height(), 1.0), largest});
  painter.save();
  painter.translate(area.center());
  painter.scale(scale, scale);
  painter.translate(-all.center());
  paintMarks(painter, drawing.marks, theme, scale);
  painter.restore();
}

}  // namespace geargraph

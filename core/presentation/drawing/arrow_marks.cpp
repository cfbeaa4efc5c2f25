#include "core/presentation/drawing/arrow_marks.h"

#include "core/presentation/drawing/digraph_geometry.h"
#include "core/presentation/drawing/emphasis.h"

namespace geargraph {
namespace {

/// Where the curve comes so near to its end, by its parameter. @pre it begins farther off
double parameterBefore(const Curve& curve, double gap) {
  if (curve.isStraight()) return 1 - gap / distance(curve.from, curve.to);
  double outside = 0;
  double inside = 1;
  for (int i = 0; i < 24; ++i) {
    const double middle = (outside + inside) / 2;
    (distance(curve.at(middle), curve.to) > gap ? outside : inside) = middle;
  }
  return outside;
}

}  // namespace

void Pen::put(MarkRole role, int z, std::variant<Stroke, Fill, Text> what) {
  Mark& mark = m_list.marks.emplace_back();
  mark.element = m_element;
  mark.role = role;
  mark.z = z;
  mark.what = std::move(what);
}

Polyline arrowhead(const Curve& curve) {
  const CanvasPoint tip = curve.to;
  const CanvasPoint along =
      curve.isStraight() ? curve.direction(1) : unit(tip - curve.at(parameterBefore(curve, 6)));
  const double size = std::min(kArrowLength, distance(curve.from, tip) * 0.6);
  const CanvasPoint base = tip - size * along;
  const CanvasPoint wing = (size / kArrowLength * kArrowHalfWidth) * turned(along);
  return {{tip, base + wing, base - wing}, true};
}

Curve shaft(const Curve& curve) {
  const double span = distance(curve.from, curve.to);
  if (span < 1e-9) return curve;
  return curve.part(0, parameterBefore(curve, std::min(kArrowLength * 0.8, span * 0.5)));
}

void drawArrow(Pen& pen, const Curve& curve, const Tint& tint, double width, Dash dash) {
  pen.put(MarkRole::line, kLineDepth, Stroke{shaft(curve), tint, width, dash});
  pen.put(MarkRole::arrowhead, kLineDepth, Fill{arrowhead(curve), tint});
}

void drawWalk(Pen& pen, const Curve& curve, int walk, const Tint& tint) {
  constexpr double kSize = 5;
  const CanvasPoint middle = curve.at(0.5);
  const CanvasPoint along = static_cast<double>(walk) * curve.direction(0.5);
  const CanvasPoint tip = middle + kSize * along;
  const CanvasPoint wing = kSize * turned(along);
  const CanvasPoint tail = middle - kSize * along;
  pen.put(MarkRole::walk, kLineDepth + 1,
          Fill{Polyline{{tip, tail + wing, middle - 0.4 * kSize * along, tail - wing}, true}, tint});
}

}  // namespace geargraph

#pragma once

#include "core/presentation/drawing/display_list.h"

namespace geargraph {

/// Adds marks of one element to a display list, which outlives it.
class Pen {
 public:
  Pen(DisplayList& list, ElementId element) : m_list(list), m_element(element) {}

  void put(MarkRole role, int z, std::variant<Stroke, Fill, Text> what);

 private:
  DisplayList& m_list;
  ElementId m_element;
};

/// A line with an arrowhead at its end.
void drawArrow(Pen& pen, const Curve& curve, const Tint& tint, double width, Dash dash);
/// A chevron on a line that shows the direction of a walk: along the line (+1) or against it (-1).
void drawWalk(Pen& pen, const Curve& curve, int walk, const Tint& tint);

/// The arrow's tip with its wings; the line ends inside of it.
[[nodiscard]] Polyline arrowhead(const Curve& curve);
/// The line without the part that the arrowhead covers, so that its blunt end does not show beside the tip.
[[nodiscard]] Curve shaft(const Curve& curve);

}  // namespace geargraph

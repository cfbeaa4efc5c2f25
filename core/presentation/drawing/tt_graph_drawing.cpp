#include "core/presentation/drawing/tt_graph_drawing.h"

#include "core/presentation/drawing/arrow_marks.h"
#include "core/presentation/drawing/coupling_marks.h"
#include "core/presentation/drawing/digraph_drawing.h"

namespace geargraph {
namespace {

constexpr double kTransferRing = 15.5;  ///< radius of the second ring
constexpr double kTransferWidth = 1.4;
constexpr double kHaloWidth = 9;
constexpr double kHitHalfWidth = 5;

struct LineStyle {
  double width;
  Dash dash;
};
LineStyle styleOf(TtLine kind) {
  switch (kind) {
    case TtLine::branch:
      return {kTurningWidth, Dash::solid};
    case TtLine::open:
      return {kChordWidth, Dash::dotted};
    default:
      return {kChordWidth, Dash::dashed};
  }
}

Tint tintOf(const TtLinePlace& line, const Emphasis& emphasis) {
  if (emphasis.walk != 0) {
    const bool second = line.kind == TtLine::headChord || emphasis.second;
    return second ? kSecondWalk : ColorRole::accent;
  }
  if (emphasis.selected) return ColorRole::accent;
  return line.kind == TtLine::open ? ColorRole::secondary : ColorRole::ink;
}

DisplayList drawingOf(const TtLinePlace& line, const Emphasis& emphasis) {
  DisplayList list;
  Pen pen(list, line.element);
  if (emphasis.any()) {
    pen.put(MarkRole::halo, kHaloDepth, Stroke{line.curve, ColorRole::halo, kHaloWidth, Dash::solid});
  }
  const Tint tint = tintOf(line, emphasis);
  const LineStyle style = styleOf(line.kind);
  if (line.kind == TtLine::open) {
    pen.put(MarkRole::line, kLineDepth, Stroke{line.curve, tint, style.width, style.dash});
  } else {
    drawArrow(pen, line.curve, tint, style.width, style.dash);
  }
  if (emphasis.walk != 0 && line.kind != TtLine::open) drawWalk(pen, line.curve, emphasis.walk, tint);
  pen.put(MarkRole::label, kLabelDepth, Text{line.label, line.labelCenter, kLabelSize, true, tint});
  list.outlines.push_back({line.element, kLineDepth, line.curve, kHitHalfWidth});
  list.outlines.push_back(
      {line.element, kLabelDepth, Box{ttLabelExtent(line.labelCenter, line.label), 0}, 0});
  return list;
}

DisplayList drawingOf(const NodePlace& node, bool isTransfer, const Emphasis& emphasis) {
  DisplayList list = nodeDrawing(node, emphasis);
  if (!isTransfer) return list;
  Pen pen(list, node.link);
  const Tint tint = emphasis.selected ? Tint(ColorRole::accent) : Tint::ofLink(node.label, node.color);
  pen.put(MarkRole::node, kNodeDepth,
          Stroke{Circle{node.center, kTransferRing}, tint, kTransferWidth, Dash::solid});
  return list;
}

}  // namespace

DisplayList ttGraphDrawing(const TtGraphGeometry& geometry, const Emphases& emphases) {
  DisplayList list;
  for (const TtLinePlace& line : geometry.lines) {
    list.append(drawingOf(line, emphasisOf(emphases, line.element)));
  }
  for (std::size_t i = 0; i < geometry.nodes.size(); ++i) {
    const NodePlace& node = geometry.nodes[i];
    list.append(drawingOf(node, geometry.isTransfer[i], emphasisOf(emphases, node.link)));
  }
  for (const ShiftElementPlace& coupling : geometry.couplings)
    list.append(couplingDrawing(coupling, emphasisOf(emphases, coupling.coupling)));
  list.sortByDepth();
  return list;
}

TtElements::TtElements(const TtGraphGeometry& geometry) {
  for (std::size_t i = 0; i < geometry.lines.size(); ++i) m_places[geometry.lines[i].element].push_back(i);
  for (std::size_t i = 0; i < geometry.nodes.size(); ++i) m_places[geometry.nodes[i].link].push_back(i);
  for (std::size_t i = 0; i < geometry.couplings.size(); ++i)
    m_places[geometry.couplings[i].coupling].push_back(i);
}

DisplayList TtElements::drawing(const TtGraphGeometry& geometry, const ElementId& element,
                                const Emphasis& emphasis) const {
  DisplayList list;
  const auto places = m_places.find(element);
  if (places == m_places.end()) return list;
  for (const std::size_t i : places->second) {
    if (element.kind == ElementKind::link) {
      list.append(drawingOf(geometry.nodes[i], geometry.isTransfer[i], emphasis));
    } else if (element.kind == ElementKind::coupling) {
      list.append(couplingDrawing(geometry.couplings[i], emphasis));
    } else {
      list.append(drawingOf(geometry.lines[i], emphasis));
    }
  }
  list.sortByDepth();
  return list;
}

}  // namespace geargraph

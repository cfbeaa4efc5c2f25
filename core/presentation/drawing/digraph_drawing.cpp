#include "core/presentation/drawing/digraph_drawing.h"

#include "core/foundations/base/translation.h"
#include "core/presentation/drawing/arrow_marks.h"
#include "core/presentation/drawing/coupling_marks.h"
#include "core/presentation/drawing/edge_routing.h"
#include "core/presentation/drawing/note_marks.h"

namespace geargraph {
namespace {

constexpr double kHaloWidth = 9;     ///< of the band along an arrow
constexpr double kHaloRing = 6;      ///< beyond a node's ring
constexpr double kHitHalfWidth = 5;  ///< of an arrow
constexpr double kHatchStep = 7;
constexpr double kHatchWidth = 1.4;
constexpr double kPreviewWidth = 3;

std::string labelText(int label) {
  return std::to_string(label);
}

/// Long labels have to fit into the disc.
double nodeLabelSize(int label) {
  if (label < 100) return 15;
  return label < 1000 ? 13 : 11;
}

void drawHatching(Pen& pen, const NodePlace& ground) {
  const CanvasPoint out = *ground.groundSide;
  const CanvasPoint along = turned(out);
  const CanvasPoint middle = ground.center + kGroundDistance * out;
  const double half = ground.groundHalfWidth;
  const Stroke base{Polyline{{middle - half * along, middle + half * along}, false}, ColorRole::secondary,
                    kHatchWidth, Dash::solid};
  pen.put(MarkRole::hatching, kLineDepth, base);
  for (double place = -half + kHatchStep; place <= half; place += kHatchStep) {
    const CanvasPoint start = middle + place * along;
    const CanvasPoint end = start + kHatchDepth * out - (kHatchDepth - 1) * along;
    pen.put(MarkRole::hatching, kLineDepth,
            Stroke{Polyline{{start, end}, false}, ColorRole::secondary, kHatchWidth, Dash::solid});
  }
}

void drawBadge(Pen& pen, const NodePlace& node) {
  const Box box{badgeExtent(node.badgeCenter), kBadgeHalfHeight};
  pen.put(MarkRole::input, kBadgeDepth, Fill{box, ColorRole::inputFill});
  pen.put(MarkRole::input, kBadgeDepth, Stroke{box, ColorRole::input, 1.2, Dash::solid});
  pen.put(MarkRole::input, kBadgeDepth,
          Text{translated("motor"), node.badgeCenter, kBadgeTextSize, false, ColorRole::inputInk});
}

}  // namespace

DisplayList nodeDrawing(const NodePlace& node, const Emphasis& emphasis) {
  DisplayList list;
  Pen pen(list, node.link);
  const Circle disc{node.center, kNodeRadius};
  if (emphasis.any()) {
    pen.put(MarkRole::halo, kHaloDepth, Fill{Circle{node.center, kNodeRadius + kHaloRing}, ColorRole::halo});
  }
  if (node.groundSide) drawHatching(pen, node);
  pen.put(MarkRole::node, kNodeDepth, Fill{disc, ColorRole::sheet});
  const Tint ring = emphasis.selected ? Tint(ColorRole::accent) : Tint::ofLink(node.label, node.color);
  pen.put(MarkRole::node, kNodeDepth, Stroke{disc, ring, kRingWidth, Dash::solid});
  const Tint ink = emphasis.selected ? ColorRole::accent : ColorRole::ink;
  pen.put(MarkRole::label, kNodeDepth,
          Text{labelText(node.label), node.center, nodeLabelSize(node.label), true, ink});
  // Names in every corner would be clutter: the paper's numbers carry the drawing.
  if (!node.name.empty() && emphasis.any()) {
    pen.put(MarkRole::name, kLabelDepth,
            Text{node.name, node.nameCenter, kNameSize, false, ColorRole::secondary});
  }
  list.outlines.push_back({node.link, kNodeDepth, Circle{node.center, kNodeRadius + kRingWidth / 2}, 0});
  if (node.input) {
    Pen badge(list, *node.input);
    drawBadge(badge, node);
    list.outlines.push_back({*node.input, kBadgeDepth, Box{badgeExtent(node.badgeCenter), 0}, 0});
  }
  return list;
}

DisplayList edgeDrawing(const EdgePlace& edge, const Emphasis& emphasis) {
  DisplayList list;
  Pen pen(list, edge.element);
  if (emphasis.any()) {
    pen.put(MarkRole::halo, kHaloDepth, Stroke{edge.curve, ColorRole::halo, kHaloWidth, Dash::solid});
  }
  const bool accented = emphasis.selected || emphasis.walk != 0;
  const Tint tint = accented ? ColorRole::accent : ColorRole::ink;
  drawArrow(pen, edge.curve, tint, edge.isMesh() ? kMeshWidth : kTurningWidth,
            edge.isMesh() ? Dash::dashed : Dash::solid);
  if (emphasis.walk != 0) drawWalk(pen, edge.curve, emphasis.walk, tint);
  pen.put(MarkRole::label, kLabelDepth,
          Text{labelText(edge.label), edge.labelCenter, kLabelSize, true, tint});
  list.outlines.push_back({edge.element, kLineDepth, edge.curve, kHitHalfWidth});
  list.outlines.push_back(
      {edge.element, kLabelDepth, Box{edgeLabelExtent(edge.labelCenter, edge.label), 0}, 0});
  return list;
}

DisplayList digraphDrawing(const DigraphGeometry& geometry, const Emphases& emphases) {
  DisplayList list;
  for (const EdgePlace& edge : geometry.edges)
    list.append(edgeDrawing(edge, emphasisOf(emphases, edge.element)));
  for (const NodePlace& node : geometry.nodes)
    list.append(nodeDrawing(node, emphasisOf(emphases, node.link)));
  for (const ShiftElementPlace& coupling : geometry.couplings)
    list.append(couplingDrawing(coupling, emphasisOf(emphases, coupling.coupling)));
  for (const NotePlace& note : geometry.notes)
    list.append(noteDrawing(note, emphasisOf(emphases, note.note)));
  list.sortByDepth();
  return list;
}

DisplayList digraphDrawing(const Mechanism& mechanism, const NodePositions& positions,
                           const Emphases& emphases) {
  return digraphDrawing(digraphGeometry(mechanism, positions), emphases);
}

Curve previewCourse(CanvasPoint tail, CanvasPoint end, bool endIsNode) {
  const Curve whole = Curve::straight(tail, end);
  return endIsNode ? trimmedAtRims(whole) : trimmedAtStart(whole);
}

DisplayList arrowPreview(ElementKind kind, const Curve& curve, bool valid) {
  DisplayList list;
  Pen pen(list, ElementId{});
  if (!valid) {
    pen.put(MarkRole::preview, kPreviewDepth,
            Stroke{curve, ColorRole::secondary, kPreviewWidth, Dash::dotted});
    return list;
  }
  const bool mesh = kind == ElementKind::gearMesh;
  pen.put(MarkRole::preview, kPreviewDepth,
          Stroke{shaft(curve), ColorRole::accent, mesh ? kMeshWidth : kTurningWidth,
                 mesh ? Dash::dashed : Dash::solid});
  pen.put(MarkRole::preview, kPreviewDepth, Fill{arrowhead(curve), ColorRole::accent});
  return list;
}

DisplayList linkPreview(CanvasPoint center) {
  DisplayList list;
  Pen pen(list, ElementId{});
  pen.put(MarkRole::preview, kPreviewDepth,
          Stroke{Circle{center, kNodeRadius}, ColorRole::secondary, kPreviewWidth, Dash::dotted});
  return list;
}

}  // namespace geargraph

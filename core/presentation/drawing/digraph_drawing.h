#pragma once

#include "core/presentation/drawing/digraph_geometry.h"
#include "core/presentation/drawing/display_list.h"
#include "core/presentation/drawing/emphasis.h"

namespace geargraph::inline drawing {

/// The marks and outlines of one node or arrow.
[[nodiscard]] DisplayList nodeDrawing(const NodePlace& node, const Emphasis& emphasis);
[[nodiscard]] DisplayList edgeDrawing(const EdgePlace& edge, const Emphasis& emphasis);

/// The whole digraph [AU, Fig. 2] in painting order.
[[nodiscard]] DisplayList digraphDrawing(const DigraphGeometry& geometry, const Emphases& emphases);
[[nodiscard]] DisplayList digraphDrawing(const Mechanism& mechanism, const NodePositions& positions,
                                         const Emphases& emphases);

/// An arrow while it is drawn: grey dots until it is valid, then as it will look, in accent.
[[nodiscard]] DisplayList arrowGhost(ElementKind kind, const Curve& curve, bool valid);
/// The course of a new arrow between two nodes, or from a node to the mouse.
[[nodiscard]] Curve ghostCourse(SheetPoint tail, SheetPoint end, bool endIsNode);
/// A link where it would come.
[[nodiscard]] DisplayList linkGhost(SheetPoint center);

}  // namespace geargraph::inline drawing

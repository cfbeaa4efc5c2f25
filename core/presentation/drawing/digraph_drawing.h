#pragma once

#include "core/presentation/drawing/digraph_geometry.h"
#include "core/presentation/drawing/display_list.h"
#include "core/presentation/drawing/emphasis.h"

namespace geargraph {

/// The marks and outlines of one node or arrow.
[[nodiscard]] DisplayList nodeDrawing(const NodePlace& node, const Emphasis& emphasis);
[[nodiscard]] DisplayList edgeDrawing(const EdgePlace& edge, const Emphasis& emphasis);

/// The whole digraph [AU, Fig. 2] in painting order.
[[nodiscard]] DisplayList digraphDrawing(const DigraphGeometry& geometry, const Emphases& emphases);
[[nodiscard]] DisplayList digraphDrawing(const Mechanism& mechanism, const NodePositions& positions,
                                         const Emphases& emphases);

/// The preview of an arrow being drawn: dotted grey until it is valid, then in its final form in the accent
/// colour.
[[nodiscard]] DisplayList arrowPreview(ElementKind kind, const Curve& curve, bool valid);
/// The course of such an arrow between two nodes, or from a node to the mouse pointer.
[[nodiscard]] Curve previewCourse(CanvasPoint tail, CanvasPoint end, bool endIsNode);
/// The preview of a new link.
[[nodiscard]] DisplayList linkPreview(CanvasPoint center);

}  // namespace geargraph

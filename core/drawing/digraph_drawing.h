#pragma once

#include <unordered_map>

#include "core/drawing/digraph_geometry.h"
#include "core/drawing/display_list.h"

namespace geargraph {

/// How an element stands out.
struct Emphasis {
  bool hovered = false;   ///< a halo alone
  bool selected = false;  ///< accent with a halo
  /// On a cycle that is shown: +1 where its walk runs along the arrow, -1 against it, 0 not on it.
  int walk = 0;

  [[nodiscard]] bool any() const { return hovered || selected || walk != 0; }
  friend bool operator==(const Emphasis&, const Emphasis&) = default;
};
/// Elements that are not in it are plain.
using Emphases = std::unordered_map<ElementId, Emphasis>;

// Depths of a drawing's marks.
constexpr int kHaloDepth = 0;
constexpr int kLineDepth = 10;
constexpr int kLabelDepth = 20;
constexpr int kNodeDepth = 30;
constexpr int kBadgeDepth = 40;
constexpr int kGhostDepth = 50;

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

}  // namespace geargraph

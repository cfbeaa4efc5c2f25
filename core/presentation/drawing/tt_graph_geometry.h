#pragma once

#include "core/presentation/drawing/digraph_geometry.h"
#include "core/presentation/drawing/tt_graph_lines.h"

namespace geargraph {

constexpr double kChordWidth = 1.3;  ///< the thin lines of the meshes

/// A line of the T-T graph, from rim to rim.
struct TtLinePlace {
  TtLine kind = TtLine::branch;
  ElementId element;  ///< a turning joint, or a mesh, which has two
  std::string label;
  int from = 0;  ///< ordinals of the links
  int to = 0;
  Curve curve;
  CanvasPoint labelCenter;
  bool labelCrowded = false;  ///< no place was free for it
  friend bool operator==(const TtLinePlace&, const TtLinePlace&) = default;
};

/// The geometry of a drawing of the T-T graph.
struct TtGraphGeometry {
  std::vector<NodePlace> nodes;              ///< in the document's order
  ByLink<bool> isTransfer;                   ///< the carrier arm of some mesh
  std::vector<TtLinePlace> lines;            ///< branches first
  std::vector<ShiftElementPlace> couplings;  ///< not part of the graph: additional equations
};

/// Places lines and labels for given nodes: branches straight, chords beside them, both bent around nodes
/// that they would run over; labels where they touch no line, node, badge or other label, if possible. Links
/// without a position are left out.
///
/// `graph` is null where the turning joints are no spanning tree.
/// Cost: near linear in links + joints + meshes for drawings of even density.
/// @pre `graph`, if any, is the mechanism's
[[nodiscard]] TtGraphGeometry ttGraphGeometry(const Mechanism& mechanism, const TtGraph* graph,
                                              const NodePositions& positions);

[[nodiscard]] Extent ttLabelExtent(CanvasPoint center, const std::string& label);

}  // namespace geargraph

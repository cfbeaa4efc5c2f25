#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "core/mechanism/model/mechanism.h"
#include "core/presentation/drawing/planar.h"

namespace geargraph::inline drawing {

using NodePositions = std::map<LinkId, SheetPoint>;

/// Sheets end here, on all sides: a file may hold any number as a place.
constexpr double kSheetEnd = 1e6;
[[nodiscard]] SheetPoint onSheet(SheetPoint place);

constexpr double kNodeRadius = 20;     ///< to the middle of the ring
constexpr double kRingWidth = 3;       //
constexpr double kTurningWidth = 2.2;  ///< the line of a turning joint
constexpr double kMeshWidth = 1.8;     //
constexpr double kArrowLength = 11;
constexpr double kArrowHalfWidth = 4.4;
constexpr double kLabelSize = 12;  ///< px of an arrow's label
constexpr double kNameSize = 10;
constexpr double kNoteTextSize = 12;

/// From the node's centre to the line that the hatching hangs on, and half that line's length.
constexpr double kGroundDistance = 29;
constexpr double kGroundHalfWidth = 22;
constexpr double kHatchDepth = 7;

/// A link's disc and what stands by it.
struct NodePlace {
  LinkId link;
  int label = 0;
  SheetPoint center;
  std::string name;                           ///< as shown, elided; empty where there is none or no room
  SheetPoint nameCenter;                      //
  std::optional<SheetPoint> groundSide;       ///< ground only: where the hatching is, a unit vector
  double groundHalfWidth = kGroundHalfWidth;  ///< of that hatching; less where arrows leave little room
  std::optional<JointId> input;               ///< the driven joint that moves this link
  SheetPoint badgeCenter;                     ///< of the "motor" badge, if there is an input
  bool badgeCrowded = false;                  ///< no place was free for it
  friend bool operator==(const NodePlace&, const NodePlace&) = default;
};

/// An arrow, from rim to rim.
struct EdgePlace {
  ElementId element;
  int label = 0;
  int tail = 0;  ///< ordinals of the links
  int head = 0;
  Curve curve;
  int detoursLooked = 0;  ///< how far round its course was sought
  double height = 0;      ///< how far arrows of the same two links pushed it aside
  SheetPoint labelCenter;
  bool labelCrowded = false;  ///< no place was free for it
  [[nodiscard]] bool isMesh() const { return element.kind == ElementKind::gearMesh; }
  friend bool operator==(const EdgePlace&, const EdgePlace&) = default;
};

/// A brake or a clutch in the digraph. They are no joints of it, so they have no arrow and no number: a
/// dashed line from a link to a piece of the frame, or between two links, with two plates that face each
/// other.
struct CouplingPlace {
  CouplingId coupling;
  CouplingKind kind = CouplingKind::brake;
  std::string name;   ///< as shown
  Curve line;         ///< brake: from the link's rim outward; clutch: from rim to rim
  SheetPoint plates;  ///< between both plates
  SheetPoint way;     ///< from the link's plate to the other one, a unit vector
  SheetPoint labelCenter;
  bool isEngaged = false;  ///< drawn closed
  friend bool operator==(const CouplingPlace&, const CouplingPlace&) = default;
};

/// A note on the sheet, line by line.
struct NotePlace {
  NoteId note;
  std::vector<std::string> lines;
  SheetPoint center;
  friend bool operator==(const NotePlace&, const NotePlace&) = default;
};

/// Where everything in a drawing of the digraph is.
struct DigraphGeometry {
  std::vector<NodePlace> nodes;  ///< of the links that have a position, in the document's order
  std::vector<EdgePlace> edges;  ///< between those, turning joints first
  std::vector<CouplingPlace> couplings;
  std::vector<NotePlace> notes;  ///< what their author wrote where: nothing else keeps out of their way

  [[nodiscard]] const NodePlace* node(LinkId link) const;
  [[nodiscard]] const EdgePlace* edge(const ElementId& element) const;
};

/// Places arrows, labels and badges for given nodes: arrows between the same two links are bent apart, an
/// arrow that would run over a third node is bent around it, and a label goes where it touches no line, node,
/// badge or other label, if there is such a place. The result depends on the arguments only.
///
/// Cost: near linear in links + joints + meshes for drawings of even density (bench: 1,000 links).
[[nodiscard]] DigraphGeometry digraphGeometry(const Mechanism& mechanism, const NodePositions& positions);

/// The same result, faster where few nodes have moved since `former` was made: for drags.
[[nodiscard]] DigraphGeometry digraphGeometry(const Mechanism& mechanism, const NodePositions& positions,
                                              const DigraphGeometry& former);

[[nodiscard]] Extent badgeExtent(SheetPoint center);
[[nodiscard]] Extent edgeLabelExtent(SheetPoint center, int label);
/// Half of a "motor" badge.
constexpr double kBadgeHalfWidth = 20;
constexpr double kBadgeHalfHeight = 9;
constexpr double kBadgeTextSize = 10;

}  // namespace geargraph::inline drawing

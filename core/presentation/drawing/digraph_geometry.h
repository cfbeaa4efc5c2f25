#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "core/mechanism/model/mechanism.h"
#include "core/presentation/drawing/planar.h"

namespace geargraph {

using NodePositions = std::map<LinkId, CanvasPoint>;

/// Positions on a sheet are limited to this on all sides, px: a file may contain any number.
constexpr double kSheetEnd = 1e6;
[[nodiscard]] CanvasPoint onSheet(CanvasPoint place);

constexpr double kNodeRadius = 20;     ///< px, to the middle of the ring
constexpr double kRingWidth = 3;       //
constexpr double kTurningWidth = 2.2;  ///< the line of a turning joint
constexpr double kMeshWidth = 1.8;     //
constexpr double kArrowLength = 11;
constexpr double kArrowHalfWidth = 4.4;
constexpr double kLabelSize = 12;  ///< px of an arrow's label
constexpr double kNameSize = 10;
constexpr double kNoteTextSize = 12;

/// From the node's centre to the base line of the hatching, and half that line's length.
constexpr double kGroundDistance = 29;
constexpr double kGroundHalfWidth = 22;
constexpr double kHatchDepth = 7;

/// A link's disc with its name, hatching and badge.
struct NodePlace {
  LinkId link;
  int label = 0;
  int color = 0;  ///< its number (Mechanism::colorNumber())
  CanvasPoint center;
  std::string name;                       ///< as shown, elided; empty if there is none or no room for it
  CanvasPoint nameCenter;                 //
  std::optional<CanvasPoint> groundSide;  ///< ground only: unit vector from the centre towards the hatching
  double groundHalfWidth = kGroundHalfWidth;  ///< of the hatching; smaller where arrows leave little room
  std::optional<JointId> input;               ///< the driven joint that moves this link
  CanvasPoint badgeCenter;                    ///< of the "motor" badge, if there is an input
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
  int detoursLooked = 0;  ///< size of the area searched for its course (Course::looked)
  double height = 0;      ///< initial sideways offset, because of other arrows of the same two links, px
  CanvasPoint labelCenter;
  bool labelCrowded = false;  ///< no place was free for it
  [[nodiscard]] bool isMesh() const { return element.kind == ElementKind::gearMesh; }
  friend bool operator==(const EdgePlace&, const EdgePlace&) = default;
};

/// A brake or a clutch in the digraph. They are no edges of it, so they have no arrow and no number: a dashed
/// line from a link to a piece of the frame, or between two links, with two plates that face each other.
struct ShiftElementPlace {
  ShiftElementId coupling;
  ShiftElementKind kind = ShiftElementKind::brake;
  std::string name;    ///< as shown
  Curve line;          ///< brake: from the link's rim outward; clutch: from rim to rim
  CanvasPoint plates;  ///< between both plates
  CanvasPoint way;     ///< from the link's plate to the other one, a unit vector
  CanvasPoint labelCenter;
  bool isEngaged = false;  ///< drawn closed
  friend bool operator==(const ShiftElementPlace&, const ShiftElementPlace&) = default;
};

/// A note on the sheet, split into lines.
struct NotePlace {
  NoteId note;
  std::vector<std::string> lines;
  CanvasPoint center;
  friend bool operator==(const NotePlace&, const NotePlace&) = default;
};

/// The geometry of a drawing of the digraph.
struct DigraphGeometry {
  std::vector<NodePlace> nodes;  ///< of the links that have a position, in the document's order
  std::vector<EdgePlace> edges;  ///< between those, turning joints first
  std::vector<ShiftElementPlace> couplings;
  std::vector<NotePlace> notes;  ///< placed by the user: nothing else keeps clear of them

  [[nodiscard]] const NodePlace* node(LinkId link) const;
  [[nodiscard]] const EdgePlace* edge(const ElementId& element) const;
};

/// Places arrows, labels and badges for given nodes: arrows between the same two links are bent apart, an
/// arrow that would run over a third node is bent around it, and a label is placed where it touches no line,
/// node, badge or other label, if possible. The result depends on the arguments only.
///
/// Cost: near linear in links + joints + meshes for drawings of even density (bench: 1,000 links).
[[nodiscard]] DigraphGeometry digraphGeometry(const Mechanism& mechanism, const NodePositions& positions);

/// The same result, faster if few nodes have moved since `former` was made: for drags.
[[nodiscard]] DigraphGeometry digraphGeometry(const Mechanism& mechanism, const NodePositions& positions,
                                              const DigraphGeometry& former);

[[nodiscard]] Extent badgeExtent(CanvasPoint center);
[[nodiscard]] Extent edgeLabelExtent(CanvasPoint center, int label);
/// Half of a "motor" badge.
constexpr double kBadgeHalfWidth = 20;
constexpr double kBadgeHalfHeight = 9;
constexpr double kBadgeTextSize = 10;

}  // namespace geargraph

#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/foundations/base/id.h"
#include "core/foundations/base/ordinal.h"
#include "core/foundations/base/shared_optional.h"
#include "core/mechanism/kinds/hand.h"
#include "core/mechanism/kinds/joint_kind.h"
#include "core/mechanism/kinds/pair_kind.h"
#include "core/mechanism/model/link_mass.h"
#include "core/mechanism/model/load.h"
#include "core/mechanism/model/number.h"

namespace geargraph {

/// A 3D file (STL, OBJ, PLY, GLB) attached to a link in addition to its gears. `file` is a path from the
/// folder of the document, with slashes, that stays inside it. A point p of the file is at position + R
/// (scale p) in the base frame, in the reference pose; R turns by `orientation` (degrees) about x, then y,
/// then z of the base frame.
struct LinkShape {
  std::string file;
  std::optional<NumberTriple> position = {};
  std::optional<NumberTriple> orientation = {};
  std::optional<Number> scale = {};
  UnknownMembers unknown = {};
  friend bool operator==(const LinkShape&, const LinkShape&) = default;
};

struct Link {
  LinkId id;
  std::string name;
  bool pinned = false;  ///< its gears keep their teeth while others are fitted (pins.h)
  std::vector<LinkShape> shapes = {};
  SharedOptional<LinkMass> mass = {};
  UnknownMembers unknown = {};
  friend bool operator==(const Link&, const Link&) = default;
};

/// A line that turning joints turn about and sliding joints slide along, in the reference pose, in the base
/// frame. Without point or direction it is placed automatically (placement). `direction` need not have
/// length 1.
struct Axis {
  AxisId id;
  std::optional<NumberTriple> point;
  std::optional<NumberTriple> direction;
  bool pinned = false;  ///< it keeps its place (pins.h)
  UnknownMembers unknown = {};
  friend bool operator==(const Axis&, const Axis&) = default;
};

/// How far a joint may turn from the reference pose, in degrees, or slide, in the document's unit, with the
/// sign of its speed; an end without a number is unlimited. @pre of a well-formed mechanism: low <= 0 <= high
/// and low < high
struct JointLimits {
  std::optional<Number> low = {};
  std::optional<Number> high = {};

  [[nodiscard]] bool any() const { return low || high; }
  friend bool operator==(const JointLimits&, const JointLimits&) = default;
};

/// The same limits for a joint of which tail and head are exchanged.
[[nodiscard]] JointLimits opposite(const JointLimits& limits);

/// A joint of one freedom, `kind`: a turning pair, or a sliding one (most are turning; the name is that of
/// the paper and of documents). Positive speed turns `head` about +direction of the axis relative to `tail`,
/// or slides it along +direction, in lengths a second; `offset` is where along the axis (from its point,
/// along the unit direction) the bearing is drawn.
struct TurningJoint {
  JointId id;
  LinkId tail;
  LinkId head;
  AxisId axis;
  Number offset;
  JointLimits limits = {};
  JointKind kind = JointKind::turning;
  UnknownMembers unknown = {};
  friend bool operator==(const TurningJoint&, const TurningJoint&) = default;
};

constexpr int kMinTeeth = 1;
constexpr int kMaxTeeth = 100'000;

/// A gear pair: two toothed wheels, one on each link. The paper's ratio i of the mesh is tailTeeth /
/// headTeeth.
struct GearMesh {
  MeshId id;
  LinkId tail;
  LinkId head;
  int tailTeeth = 20;
  int headTeeth = 20;
  std::optional<MeshKind> kind;
  std::optional<NumberTriple> pitchPoint;
  std::optional<Number> faceWidth;
  std::optional<WheelId> tailWheel;
  std::optional<WheelId> headWheel;
  bool pinned = false;  ///< it keeps its module (pins.h)
  /// Efficiency of the power through the teeth, seen from the carrier: above 0, at most 1. At most one of
  /// efficiency and friction is given.
  std::optional<Number> efficiency = {};
  std::optional<Number> friction = {};  ///< coefficient of friction of the teeth, 0 to 1
  /// Of the teeth of the tail's gear at its reference cylinder, degrees, 0 <= . < 90; none: straight.
  std::optional<Number> helixAngle = {};
  std::optional<Hand> hand = {};  ///< of that helix; none: right
  bool herringbone = false;       ///< the two halves of the face have opposite hands, `hand` the lower one
  std::optional<Number> module = {};         ///< normal module; none: from the centre distance
  std::optional<Number> pressureAngle = {};  ///< normal, degrees; none: that of GearDefaults
  bool crossed = false;                      ///< of a belt: its strands cross between the pulleys
  std::optional<Number> pitch = {};          ///< of a belt or rack: length of a tooth
  /// Running diameters of a belt's pulleys, instead of teeth: both or none. tailTeeth : headTeeth is then
  /// their ratio in lowest terms (settleWeights()).
  std::optional<Number> tailDiameter = {};
  std::optional<Number> headDiameter = {};
  std::optional<Number> lead = {};  ///< of a screw: its advance in one turn
  UnknownMembers unknown = {};
  friend bool operator==(const GearMesh&, const GearMesh&) = default;
};

/// The helix angle of the tail's gear at its reference cylinder, rad, positive for a right-hand helix, 0 for
/// straight teeth.
[[nodiscard]] double helixOf(const GearMesh& mesh);

/// Are the numbers of teeth of the mesh those that the document states? Else they are the weights of its row
/// only: 1 : 1 for pins, the ratio of the running diameters of a belt.
[[nodiscard]] bool statesTeeth(const GearMesh& mesh);
/// The ratio tailTeeth : headTeeth of a mesh that states no teeth, in lowest terms; none where it has no
/// such numbers from kMinTeeth to kMaxTeeth. @pre !statesTeeth(mesh)
[[nodiscard]] std::optional<std::pair<int, int>> weightsWithoutTeeth(const GearMesh& mesh);
/// Sets the teeth of a mesh that states none to its weights, where there are such.
void settleWeights(GearMesh& mesh);

/// The weights a : b of the row of a mesh, a w_tail = s b w_head, speeds of the two sides relative to the
/// carrier: `tail` : `head` pi^`pi`, whole numbers in lowest terms or the teeth. A side that slides has a
/// speed in lengths, and only beside one is there a power of pi.
struct MeshWeights {
  int tail = 1;
  int head = 1;
  int pi = 0;
  friend bool operator==(const MeshWeights&, const MeshWeights&) = default;
};
/// Gears have their teeth, a rack has z m / 2 : 1 or, by its pitch, z p / (2 pi) : 1, a screw lead / (2 pi) :
/// 1, the turning side first; `tailSlides` says which that is not. std::nullopt where a rack has neither
/// module nor pitch, a screw no lead, or the numbers are beyond kMaxTeeth.
[[nodiscard]] std::optional<MeshWeights> weightsOf(const GearMesh& mesh, bool tailSlides);

/// The kind that the document says, kUsualKind where it says none.
[[nodiscard]] inline MeshKind saidKind(const GearMesh& mesh) {
  return mesh.kind.value_or(kUsualKind);
}

/// The shape of a toothed wheel that meshes may name. Lengths are in the document's unit, `profileShift` and
/// `backlash` in modules.
struct Wheel {
  WheelId id;
  LinkId link;
  std::optional<Number> profileShift;
  std::optional<Number> bore;
  std::optional<Number> backlash;
  UnknownMembers unknown;
  friend bool operator==(const Wheel&, const Wheel&) = default;
};

struct GearDefaults {
  std::optional<Number> pressureAngle;  ///< degrees
  std::optional<Number> backlash;       ///< modules
  std::optional<Number> faceWidth;
  std::optional<Number> efficiency = {};  ///< for meshes that state neither efficiency nor friction
  std::optional<Number> friction = {};
  UnknownMembers unknown;
  friend bool operator==(const GearDefaults&, const GearDefaults&) = default;
};

/// A driven joint and its speed in rad/s.
struct Input {
  JointId joint;
  Number speed;
  UnknownMembers unknown;
  friend bool operator==(const Input&, const Input&) = default;
};

enum class ShiftElementKind { brake, clutch, freewheel };

/// The word of documents.
[[nodiscard]] std::string_view couplingKindName(ShiftElementKind kind);
/// The word of sentences with the coupling's id: "brake B", in the language in use.
[[nodiscard]] std::string couplingName(ShiftElementKind kind, std::string_view id);

/// A brake (one link, held to the ground when engaged), a clutch (two links that turn as one when engaged) or
/// a freewheel: the first of its links may not turn faster than the second in +direction of the axis of its
/// own joint, and while it is locked they turn as one.
struct ShiftElement {
  ShiftElementId id;
  ShiftElementKind kind = ShiftElementKind::brake;
  std::vector<LinkId> links;
  UnknownMembers unknown;
  friend bool operator==(const ShiftElement&, const ShiftElement&) = default;
};

/// Couplings that are engaged together, and the two links whose speeds define the ratio of the state.
struct ShiftState {
  std::string name;
  std::vector<ShiftElementId> engaged;
  std::optional<LinkId> drive;
  std::optional<LinkId> driven;
  std::optional<Number> direction = {};  ///< 1 or -1: the sense of `drive`, which freewheels obey; none: 1
  UnknownMembers unknown = {};
  friend bool operator==(const ShiftState&, const ShiftState&) = default;
};

struct CanvasPoint {
  double x = 0;
  double y = 0;
  friend bool operator==(const CanvasPoint&, const CanvasPoint&) = default;
};

/// A text of one or more lines on the sheet of the digraph, centred at `at` (notes.h).
struct CanvasNote {
  NoteId id;
  std::string text;
  CanvasPoint at;
  UnknownMembers unknown = {};
  friend bool operator==(const CanvasNote&, const CanvasNote&) = default;
};

/// The camera of the 3D view: it looks at `target` from this distance, azimuth about +z and elevation.
/// Lengths in the document's unit, angles in degrees.
struct ViewCamera {
  std::array<double, 3> target{};
  double azimuth = 0;
  double elevation = 0;
  double distance = 1;  ///< above 0
  UnknownMembers unknown = {};
  friend bool operator==(const ViewCamera&, const ViewCamera&) = default;
};

/// What the editor remembers of its drawings. No number of the analysis depends on it. Nodes of links that
/// are not in the document are kept but not drawn.
struct View {
  std::map<LinkId, CanvasPoint> nodes;    ///< centres of the digraph's nodes, x to the right, y down
  std::map<LinkId, CanvasPoint> ttNodes;  ///< the same of the T-T graph, of nodes that were dragged
  std::vector<CanvasNote> notes;          ///< on the digraph's sheet, in painting order
  std::optional<ViewCamera> camera;
  /// The numbers of the links' colours that are not their labels: links keep their colours while labels move.
  std::map<LinkId, int> colors;
  UnknownMembers unknown;

  /// The number of a link's colour, which drawings have a hue for: 0 for the ground.
  [[nodiscard]] int colorNumber(LinkId link, int label) const;
  friend bool operator==(const View&, const View&) = default;
};

/// The document: an immutable value that holds what the user drew and nothing computed from it.
///
/// Labels are not stored: links[0] is the ground, label 0; links 1..n; joints n+1..n+t and gear
/// meshes n+t+1..n+t+c in the order of their lists.
///
/// A Mechanism is always well formed: ids are unique in their lists, every reference names an element, teeth
/// are 1..100,000. It may still be invalid as a mechanism (validate.h): disconnected, with a loop of turning
/// joints, ... At least the ground exists.
struct Mechanism {
  std::string name;
  std::string notes;
  std::string unit = "mm";
  ByLink<Link> links;
  ByAxis<Axis> axes;
  ByJoint<TurningJoint> turningJoints;
  ByMesh<GearMesh> gearMeshes;
  ByWheel<Wheel> wheels;
  std::optional<GearDefaults> gearDefaults;
  std::optional<std::vector<Input>> inputs;
  ByCoupling<ShiftElement> couplings;
  std::vector<ShiftState> states;
  std::vector<ShiftElementId>
      engaged;  ///< couplings that are engaged now; the analysis applies to this state
  std::vector<Load> loads;
  std::optional<std::vector<HoldingTorque>> balances;
  /// None: open, and by stiffness where losses depend on it.
  std::optional<LoadSharing> sharing;
  std::optional<Number> driveTorque;    ///< at the drive of every state in the shift table, N m
  std::optional<Number> density;        ///< of all solids, kg/m³; none: kSteelDensity
  std::optional<NumberTriple> gravity;  ///< acceleration of free fall, m/s², base frame; none: no gravity
  View view;
  UnknownMembers unknown;

  friend bool operator==(const Mechanism&, const Mechanism&) = default;

  [[nodiscard]] int n() const { return static_cast<int>(links.size()) - 1; }  ///< moving links
  [[nodiscard]] int t() const { return static_cast<int>(turningJoints.size()); }
  [[nodiscard]] int c() const { return static_cast<int>(gearMeshes.size()); }

  /// The paper's labels of the elements at these positions of their lists.
  [[nodiscard]] int linkLabel(int position) const { return position; }
  [[nodiscard]] int colorNumber(int position) const {
    return view.colorNumber(links[static_cast<std::size_t>(position)].id, linkLabel(position));
  }
  [[nodiscard]] int jointLabel(int position) const { return n() + 1 + position; }
  [[nodiscard]] int meshLabel(int position) const { return n() + t() + 1 + position; }

  [[nodiscard]] const Link* find(LinkId id) const;
  [[nodiscard]] const Axis* find(AxisId id) const;
  [[nodiscard]] const TurningJoint* find(JointId id) const;
  [[nodiscard]] const GearMesh* find(MeshId id) const;
  [[nodiscard]] const Wheel* find(WheelId id) const;
  [[nodiscard]] const ShiftElement* find(ShiftElementId id) const;
  [[nodiscard]] const CanvasNote* find(NoteId id) const;
};

using MechanismPtr = std::shared_ptr<const Mechanism>;

[[nodiscard]] inline bool slides(const TurningJoint& joint) {
  return joint.kind == JointKind::sliding;
}
/// Has the mechanism a sliding joint? Cost: O(t).
[[nodiscard]] bool hasSlides(const Mechanism& mechanism);

/// Does the tail of a mesh slide in its carrier: is the joint by which the way to the head leaves it a
/// sliding one? Cost: O(t).
[[nodiscard]] bool tailSlides(const Mechanism& mechanism, const GearMesh& mesh);

/// A document with the ground and nothing else.
[[nodiscard]] Mechanism emptyMechanism();

/// The paper's label of a link, turning joint or mesh, as text: "4", "15"; an axis gives its id. std::nullopt
/// if the element is not in the mechanism. Cost: O(length of the list).
[[nodiscard]] std::optional<std::string> labelOf(const Mechanism& mechanism, const ElementId& element);

}  // namespace geargraph

#pragma once

#include <Eigen/Geometry>
#include <memory>
#include <optional>
#include <span>
#include <stop_token>
#include <string>
#include <variant>
#include <vector>

#include "core/machine/body_layout/arrangement.h"
#include "core/machine/solids/solid.h"
#include "core/machine/train/train.h"
#include "core/mechanism/model/mechanism.h"
#include "core/mechanism/placement/placement.h"

namespace geargraph {

/// Measures of a kit in mm; the mechanism's lengths are taken in its own unit, times `scale`.
struct KitOptions {
  double bedX = 220;  ///< the plate of the printer
  double bedY = 220;
  double play = 0.15;  ///< between two flanks, on either side of a tooth that stands in the middle of a space
  double bore = 0.2;   ///< by which a bore is wider than the shaft that turns in it, diameters
  double chamfer = 0.4;  ///< of the lowest layers, at 45 degrees; 0: none
  double gap = 2;        ///< between two parts on a plate
  double scale = 1;
  double tolerance = 0.004;  ///< chords of teeth, modules
};

/// By how much a bore that is pressed on its shaft is wider, and how far parts that are screwed onto each
/// other stay apart in the assembly, mm.
constexpr double kPressFit = 0.1;
constexpr double kFlush = 0.05;

enum class KitPartKind { wheel, ring, shaft, arm, pedestal, base, bridge, post, spacer, clip };

/// A part as it is printed.
struct KitPart {
  KitPartKind kind = KitPartKind::wheel;
  LinkOrdinal link = 0;
  std::string name;                    ///< in files: "3-wheel-7:head"
  std::shared_ptr<const Solid> solid;  ///< print frame: on z = 0, upright as it is printed
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();  ///< print frame to the assembly, mm
  std::optional<GearOrdinal> gear = {};
  std::string number = {};  ///< that is engraved; empty: none, or no room
  double diameter = 0;      ///< of shafts, posts, spacers and clips
  double inner = 0;         ///< of tubes
  double length = 0;
  double overhang = 0;  ///< of its flattest downward face, rad from the vertical
  bool isSnug = false;  ///< sits on its shaft by a flat
};

/// Screws that are bought: countersunk, cut their own thread in a hole of kTapHole.
struct KitScrew {
  double diameter = 3;
  double length = 0;
  int count = 0;
};

/// Where a pair of wheels is put together: this tooth goes into that space.
struct KitMark {
  MeshOrdinal mesh = 0;
  GearOrdinal toothGear;
  int tooth = 0;
  GearOrdinal spaceGear;
  int space = 0;  ///< the tooth before the space, in the sense of the gear's own frame
  int count = 1;  ///< of dots beside the tooth, of squares beside the space
  bool isToothMarked = false, isSpaceMarked = false;  ///< there was room to engrave it
};

/// A step of the assembly: these parts are added by moving them along `direction`; none for the first.
struct KitStep {
  std::vector<std::size_t> parts;
  Eigen::Vector3d direction = Eigen::Vector3d::Zero();
  bool isFree = true;  ///< the way was found clear of all parts before
};

struct PlacedPart {
  std::size_t part = 0;
  Eigen::Vector2d at = Eigen::Vector2d::Zero();  ///< of the origin of its print frame, turned by `turn`
  double turn = 0;
};

struct KitPlate {
  std::vector<PlacedPart> parts;
};

struct PrintKit {
  KitOptions options;
  Eigen::Vector3d up = Eigen::Vector3d::UnitZ();  ///< from the base to the rest, in the assembly
  std::vector<KitPart> parts;
  std::vector<KitScrew> screws;
  std::vector<KitMark> marks;
  std::vector<KitPlate> plates;
  std::vector<KitStep> steps;
  std::vector<std::string> notes;  ///< sentences about what differs from the train
  std::vector<GearSpec> gears;     ///< by gear of the train: in mm, with the play
};

/// Why there is no kit.
struct KitFailure {
  enum class Kind {
    stopped,
    gears,    ///< a wheel cannot be made: `diagnostics`
    layout,   ///< a part of this mechanism has no printable form here
    overlap,  ///< parts overlap when put together
    bed,      ///< a part is larger than the plate
  };
  Kind kind = Kind::layout;
  std::string message = {};
  Diagnostics diagnostics = {};
};

/// Displacements of all links from the reference pose, by link, in the document's unit.
using KitPose = ByLink<Eigen::Isometry3d>;

/// The parts of a train for a printer: wheels, shafts with a flat, arms and pedestals as flat plates,
/// bearings of the ground in a base and in bridges on posts.
///
/// Guaranteed: every part is one closed shell, lies flat on z = 0 and fits its plate; no two parts overlap in
/// the assembly, nor in any of `poses` (triangles against triangles, FCL). Profile shifts, phases and the
/// distances of axes are those of the train; only teeth are thinner, by `play` on the pitch circle. Not every
/// train has such a kit: belts, axes of several directions in the ground, arms at other angles than 0 and 90
/// degrees and the routed shells of several rings on one axis are rejected by name. `unit` is mm in one unit
/// of the document. Deterministic. Cost: some seconds, most of it for the order of assembly, O(parts^2)
/// translations of triangle meshes.
[[nodiscard]] std::variant<PrintKit, KitFailure> printKit(const Mechanism& mechanism,
                                                          const Placement& placement, const GearTrain& train,
                                                          const Arrangement& arrangement, double unit,
                                                          std::span<const KitPose> poses,
                                                          const KitOptions& options,
                                                          const std::stop_token& stop = {});

}  // namespace geargraph

#pragma once

#include <Eigen/Geometry>
#include <memory>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

#include "core/base/diagnostic.h"
#include "core/gears/deferred_solid.h"
#include "core/gears/gear_spec.h"
#include "core/mechanism/mechanism.h"
#include "core/placement/placement.h"

namespace geargraph {

/// A toothed wheel of the mechanism: what solid, and where it is in the reference pose.
struct TrainGear {
  /// "15:tail" after the label of its mesh; a wheel of several meshes: the id it has in the document, else
  /// the name by the first of them.
  std::string name;
  int link = 0;             ///< position: the gear moves with this link
  int axisClass = 0;        ///< of the placement
  std::vector<int> meshes;  ///< positions, in document order
  std::optional<WheelId> wheel;
  GearSpec spec;
  /// Gear frame (gear_spec.h) to base frame in the reference pose, turned so that its teeth mesh.
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
};

/// Two gears of the train in mesh.
struct TrainMesh {
  int mesh = 0;  ///< position in the document
  int tailGear = 0;
  int headGear = 0;
  Eigen::Vector3d
      pitchPoint;       ///< in the gears' plane; gears that the program stacked have left the document's
  double residual = 0;  ///< pitches by which the teeth miss each other, where a loop cannot be assembled
};

struct BodyPart;

/// Shafts, arms, hubs and bearings of a link: solids in the base frame at the reference pose, which move with
/// it.
struct LinkBody {
  int link = 0;
  double module = 1;                           ///< the smallest of its parts
  std::shared_ptr<const DeferredSolid> fine;   ///< chords within kBodyTolerance, made when asked for
  std::shared_ptr<const DeferredSolid> rough;  ///< within kFarthestTolerance
  std::shared_ptr<const std::vector<BodyPart>> recipe = {};  ///< what the solids are made of (BodyRecipe)

  [[nodiscard]] const Solid& solid() const { return *fine->solid(); }
};

/// The mechanism in three dimensions. Every mesh with a geometry has its two gears; a mesh without one is
/// left out (the placement says why).
struct GearTrain {
  std::vector<TrainGear> gears;
  std::vector<TrainMesh> meshes;
  std::vector<LinkBody> bodies;
  Diagnostics diagnostics;  ///< assembly, undercut, interference
  /// The train has more than kMostRoutedGears: its bodies are straight and may pass through each other.
  bool hasSimpleBodies = false;
};

/// Makes gears and bodies of a mechanism.
///
/// 1. Wheels: those that meshes name, else meshes on the same link, axis, tooth count and plane share one
///    (bevel: apex and cone), where the document leaves the plane open only if all in it pass each other
///    (wheel_sharing.h). Gears that would stand in one place are stacked along their axis, where the
///    document leaves their pitch point open.
/// 2. Shape: the module of meshing wheels is the smallest that one of their meshes asks for; the others get
///    their centre distance by profile shifts, as equal as the document's own shifts allow. Tips are
///    shortened for clearance, tips of rings kept off the pinion's fillets.
/// 3. Phase: phase.h; loops that cannot close give `assembly` with the nearest that can.
///    Faces of bevels that the document leaves open are shortened where their wheels would stand in others.
/// 4. Bodies: sized from the gears.
/// Trains of more than kMostRoutedGears (body_plan.h) keep their faces, and their bodies are simple.
///
/// Cost: under a millisecond for ten links, 0.4 s for a thousand: stacking and passing compare wheels in
///       pairs.
/// Of no use when `stop` was requested meanwhile, which ends any of it within some milliseconds.
/// @pre the mechanism is well formed and the placement is its own
[[nodiscard]] GearTrain trainOf(const Mechanism& mechanism, const Placement& placement,
                                const std::stop_token& stop = {});

class BodyCache;

/// The same for a picture: nothing is said of it, and bodies that an edit leaves as they are stay the same
/// solids.
[[nodiscard]] GearTrain shownTrain(const Mechanism& mechanism, const Placement& placement, BodyCache& bodies,
                                   const std::stop_token& stop = {});

/// The diagnostics of trainOf() alone, without making bodies, for the analysis; of trains of many wheels
/// (150) without those about the room of wheels and bodies. Those found so far where `stop` was requested
/// meanwhile. Cost: O(wheels + meshes) and some microseconds for the tooth of each wheel
/// (tests/bench/bench_gears.cpp); stacking wheels and planning bodies takes milliseconds more.
/// @pre as trainOf
[[nodiscard]] Diagnostics gearDiagnostics(const Mechanism& mechanism, const Placement& placement,
                                          const std::stop_token& stop = {});

}  // namespace geargraph

#pragma once

#include <stop_token>

#include "core/machine/arrangement/arrangement.h"
#include "core/machine/train/train.h"
#include "core/machine/train/train_wheels.h"
#include "core/mechanism/placement/placement.h"

namespace geargraph::inline bodies {

/// Makes gears and bodies of a mechanism.
///
/// 1. Wheels: those that meshes name, else meshes on the same link, axis, tooth count and plane share one
///    (bevel: apex and cone), where the document leaves the plane open only if all in it pass each other
///    (wheel_sharing.h). Gears that would stand in one place are stacked along their axis, where the
///    document leaves their pitch point open.
/// 2. Shape: the module of meshing wheels is the smallest that one of their meshes asks for; the others get
///    their centre distance by profile shifts, as equal as the document's own shifts allow. Tips are
///    shortened for clearance, tips of rings kept off the pinion's fillets.
/// 3. Phase: phase.h; in loops that cannot close a residual is left.
///    Faces of bevels that the document leaves open are shortened where their wheels would stand in others.
/// 4. Bodies: sized from the gears.
/// Trains of more than kMostRoutedGears keep their faces, and their bodies are simple.
///
/// Cost: under a millisecond for ten links, 0.4 s for a thousand: stacking and passing compare wheels in
///       pairs.
/// Of no use when `stop` was requested meanwhile, which ends any of it within some milliseconds.
/// For one use: what the views of a document share is in DerivedGeometry.
/// @pre the mechanism is well formed and the placement is its own
[[nodiscard]] GearTrain trainOf(const Mechanism& mechanism, const Placement& placement,
                                const std::stop_token& stop = {});

/// Assembly, undercut and interference of that train; for trains of more than kMostRoutedGears without those
/// about clearance between wheels and between bodies. Incomplete when `stop` was requested meanwhile. Cost:
/// O(wheels + meshes) and some microseconds for the tooth of each wheel (tests/bench/bench_gears.cpp);
/// stacking wheels and planning bodies takes milliseconds more.
/// @pre as trainOf
[[nodiscard]] Diagnostics trainDiagnostics(const Mechanism& mechanism, const Placement& placement,
                                           const std::stop_token& stop = {});

// The stages of both, each of which DerivedGeometry computes once. What they return is of no use when `stop`
// was requested meanwhile.

/// The wheels as they are shown, with the gears, meshes and bodies that they make, and the arrangement that
/// the bodies show.
struct AssembledTrain {
  TrainWheels wheels;
  GearTrain train;
  Arrangement arrangement;
};

/// 3. and 4. @pre the wheels are shaped and stacked
[[nodiscard]] AssembledTrain assembledTrain(const Mechanism& mechanism, const Placement& placement,
                                            TrainWheels wheels, const std::stop_token& stop = {});

/// trainDiagnostics() of a train that is there.
[[nodiscard]] Diagnostics diagnosticsOf(const Mechanism& mechanism, const Placement& placement,
                                        const AssembledTrain& assembled, const std::stop_token& stop = {});

/// The same at another place.
[[nodiscard]] TrainWheels moved(TrainWheels wheels, const Eigen::Vector3d& by);
[[nodiscard]] GearTrain moved(const GearTrain& train, const Eigen::Vector3d& by);
[[nodiscard]] Arrangement moved(Arrangement arrangement, const Eigen::Vector3d& by);

}  // namespace geargraph::inline bodies

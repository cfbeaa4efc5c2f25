#pragma once

#include <stop_token>

#include "core/machine/body_layout/arrangement.h"
#include "core/machine/train/train.h"
#include "core/machine/train/train_wheels.h"
#include "core/mechanism/placement/placement.h"

namespace geargraph {

/// Makes gears and bodies of a mechanism.
///
/// 1. Wheels: those that meshes name, else meshes on the same link, axis, tooth count and plane share one
///    (bevel: apex and cone); where the document leaves the plane open, only if no wheels in it interfere
///    (wheel_sharing.h). Gears that would overlap are stacked along their axis, where the document leaves
///    their pitch point open.
/// 2. Shape: the module of meshing wheels is the smallest that one of their meshes needs; the others get
///    their centre distance by profile shifts, as evenly as the document's own shifts allow. Tips are
///    shortened for clearance, tips of rings kept clear of the pinion's fillets.
/// 3. Phase: phase.h; loops that cannot be assembled keep a residual. Open face widths of bevels are reduced
///    where wheels would interfere.
/// 4. Bodies: sized from the gears. Trains of more than kMaxRoutedGears keep their face widths, and their
/// bodies are not routed.
///
/// Cost: under a millisecond for ten links, 0.4 s for a thousand: stacking and interference checks compare
/// wheels in pairs. The result is meaningless if `stop` was requested meanwhile, which ends any of it within
/// some milliseconds. For a single use; the views of a document share DerivedGeometry.
/// @pre the mechanism is well formed and the placement is its own
[[nodiscard]] GearTrain trainOf(const Mechanism& mechanism, const Placement& placement,
                                const std::stop_token& stop = {});

/// The diagnostics `assembly`, `undercut` and `interference` of that train; with more than kMaxRoutedGears
/// without those about clearance between wheels and between bodies. Incomplete if `stop` was requested
/// meanwhile. Cost: O(wheels + meshes) and some microseconds for the tooth of each wheel
/// (tests/bench/bench_gears.cpp); stacking wheels and planning bodies takes milliseconds more.
/// @pre as trainOf
[[nodiscard]] Diagnostics trainDiagnostics(const Mechanism& mechanism, const Placement& placement,
                                           const std::stop_token& stop = {});

// The stages of both, each of which DerivedGeometry computes once. Their results are meaningless if `stop`
// was requested meanwhile.

/// The final wheels, the gears, meshes and bodies made from them, and the arrangement of the bodies.
struct AssembledTrain {
  TrainWheels wheels;
  GearTrain train;
  Arrangement arrangement;
};

/// Steps 3 and 4 of trainOf(). @pre the wheels are shaped and stacked
[[nodiscard]] AssembledTrain assembledTrain(const Mechanism& mechanism, const Placement& placement,
                                            TrainWheels wheels, const std::stop_token& stop = {});

/// trainDiagnostics() for a train that has been made.
[[nodiscard]] Diagnostics diagnosticsOf(const Mechanism& mechanism, const Placement& placement,
                                        const AssembledTrain& assembled, const std::stop_token& stop = {});

/// The same translated by `by`.
[[nodiscard]] TrainWheels moved(TrainWheels wheels, const Eigen::Vector3d& by);
[[nodiscard]] GearTrain moved(const GearTrain& train, const Eigen::Vector3d& by);
[[nodiscard]] Arrangement moved(Arrangement arrangement, const Eigen::Vector3d& by);

}  // namespace geargraph

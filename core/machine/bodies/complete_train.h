#pragma once

#include <stop_token>

#include "core/machine/train/train.h"
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
/// 3. Phase: phase.h; loops that cannot close give `assembly` with the nearest that can.
///    Faces of bevels that the document leaves open are shortened where their wheels would stand in others.
/// 4. Bodies: sized from the gears.
/// Trains of more than kMostRoutedGears keep their faces, and their bodies are simple.
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

}  // namespace geargraph::inline bodies

#pragma once

#include "core/machine/teeth/gear_spec.h"
#include "core/machine/teeth/half_tooth.h"

namespace geargraph::inline teeth {

/// Fewest teeth that a standard rack can cut without undercut at the gear's shift: 2 (ha - x) / sin^2 a, for
/// bevels with z / cos d in place of z. Not rounded.
[[nodiscard]] double fewestTeethWithoutUndercut(const GearSpec& spec);

/// The shift from which the gear is not undercut: ha - z sin^2(a) / 2.
[[nodiscard]] double leastShiftWithoutUndercut(const GearSpec& spec);

/// Tips of an external pair at a working distance (in modules) that is not the sum of what the shifts add:
/// k = (a - a0) / m - (x1 + x2), 0 or below, keeps the clearance at the roots.
[[nodiscard]] double tipShortening(const GearSpec& a, const GearSpec& b, double distance);

/// How deep (radius in modules) a ring's tip may reach so that it stays off the pinion's fillet: it ends
/// where the line of action meets the pinion's form radius. `distance` in modules.
[[nodiscard]] double leastRingTip(const GearSpec& pinion, const GearSpec& ring, double distance);

/// Room between a pinion's tip and a ring's tip where they pass each other outside of the mesh (trochoid
/// interference), as an angle of the ring: below 0 they collide. README.md, section 2.
[[nodiscard]] double trochoidMargin(const GearSpec& pinion, const GearSpec& ring, double distance);

/// Mean number of pairs in contact: the path between the ends of the flanks along the line of action (bevels:
/// along its great circle), in base pitches. Below 1 the drive is interrupted. `distance`
/// of the axes in modules, unused for bevels. The teeth are those of the specs.
[[nodiscard]] double contactRatio(const GearSpec& a, const HalfTooth& toothA, const GearSpec& b,
                                  const HalfTooth& toothB, double distance);

}  // namespace geargraph::inline teeth

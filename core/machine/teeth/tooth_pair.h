#pragma once

#include "core/machine/teeth/gear_spec.h"
#include "core/machine/teeth/half_tooth.h"

namespace geargraph {

/// The smallest tooth count without undercut at the gear's profile shift: 2 (h - x) / sin^2 a, for bevels
/// with z / cos d in place of z. h is the depth of the rack's straight flank, which its rounded corner ends:
/// the addendum at 20 degrees. Not rounded.
[[nodiscard]] double fewestTeethWithoutUndercut(const GearSpec& spec);

/// The smallest profile shift without undercut, in modules: h - z sin^2(a) / 2.
[[nodiscard]] double leastShiftWithoutUndercut(const GearSpec& spec);

/// The tip shortening coefficient of an external pair at a working distance (in modules): k = (a - a0) / m -
/// (x1 + x2), at most 0, which keeps the clearance at the roots.
[[nodiscard]] double tipShortening(const GearSpec& a, const GearSpec& b, double distance);

/// The smallest tip radius (modules) of a ring that is clear of the pinion's fillet: contact ends where the
/// line of action intersects the pinion's form radius. `distance` in modules.
[[nodiscard]] double leastRingTip(const GearSpec& pinion, const GearSpec& ring, double distance);

/// The clearance between a pinion's tip and a ring's tip where they pass each other outside of the mesh
/// (trochoid interference), as an angle of the ring, rad: below 0 they interfere. README.md, section 2.
[[nodiscard]] double trochoidMargin(const GearSpec& pinion, const GearSpec& ring, double distance);

/// The transverse contact ratio: the path of contact between the ends of the flanks (bevels: along the great
/// circle of action), in base pitches. Below 1 contact is interrupted. `distance`: centre distance in
/// modules, unused for bevels. @pre the teeth are those of the specs
[[nodiscard]] double contactRatio(const GearSpec& a, const HalfTooth& toothA, const GearSpec& b,
                                  const HalfTooth& toothB, double distance);

/// contactRatio() by kinds: of two wheels on parallel axes, `b` a ring or not; of two bevels.
[[nodiscard]] double planeContactRatio(const GearSpec& a, const HalfTooth& toothA, const GearSpec& b,
                                       const HalfTooth& toothB, double distance);
[[nodiscard]] double bevelContactRatio(const GearSpec& a, const HalfTooth& toothA, const GearSpec& b,
                                       const HalfTooth& toothB, double distance);

}  // namespace geargraph

#pragma once

namespace geargraph {

/// inv a = tan a - a, the polar angle of the involute at pressure angle a.
[[nodiscard]] double involute(double angle);

/// The angle whose involute is `value`, by Newton's method. @pre value >= 0
[[nodiscard]] double inverseInvolute(double value);

/// The centre distance of a pair with given profile shifts, lengths in modules.
///
/// `teethSum` z1 + z2 for an external pair, z2 - z1 for a ring z2; `shiftSum` x1 + x2, or x2 - x1 for a ring.
/// inv aw = inv a + 2 tan a * shiftSum / teethSum, distance = teethSum cos a / (2 cos aw).
[[nodiscard]] double centreDistance(int teethSum, double shiftSum, double pressureAngle);

/// The inverse of centreDistance: the sum of the shifts for a given distance. Distances below the limit at
/// which the working pressure angle is 0 give the shift of that limit.
[[nodiscard]] double shiftSumFor(int teethSum, double distance, double pressureAngle);

/// Pressure angle at which a pair with this centre distance (in modules) works; 0 at and below the limit.
[[nodiscard]] double workingPressureAngle(int teethSum, double distance, double pressureAngle);

}  // namespace geargraph

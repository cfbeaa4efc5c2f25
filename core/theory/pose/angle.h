#pragma once

#include "core/foundations/base/rational.h"

namespace geargraph::inline pose {

/// The angle in rad, above -pi, to pi, that is left of turns and radians of any size. Whole turns are taken
/// off while the numbers are exact, with as many digits of pi as the radians ask for; so a large angle is as
/// precise as a small one.
/// Cost: some microseconds; O(b^2) for radians of b bits.
[[nodiscard]] double reducedAngle(const Rational& turns, const Rational& radians);

}  // namespace geargraph::inline pose

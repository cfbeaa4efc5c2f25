#pragma once

#include "core/foundations/base/rational.h"

namespace geargraph {

/// The angle 2 pi turns + radians, of any size, reduced to (-pi, pi], rad. Whole turns are subtracted in
/// exact arithmetic, with as many digits of pi as the size of the radians needs, so a large angle is as
/// precise as a small one.
/// Cost: some microseconds; O(b^2) for radians of b bits.
[[nodiscard]] double reducedAngle(const Rational& turns, const Rational& radians);

}  // namespace geargraph

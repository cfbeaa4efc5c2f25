#pragma once

#include "core/foundations/base/triple.h"
#include "core/mechanism/model/number.h"

namespace geargraph {

/// The value as a decimal of at most six digits if it is close to one; else exactly.
[[nodiscard]] Rational plainDecimal(double value);

[[nodiscard]] NumberTriple numbersOf(const ExactVector3& v);

}  // namespace geargraph

#pragma once

#include "core/foundations/base/triple.h"
#include "core/mechanism/model/number.h"

namespace geargraph::inline fitting {

/// The number as a person would have written it, a decimal of six digits, where it is one; else as it is.
[[nodiscard]] Rational plainDecimal(double value);

[[nodiscard]] NumberTriple numbersOf(const ExactVector3& v);

}  // namespace geargraph::inline fitting

#pragma once

#include <optional>
#include <span>

#include "core/foundations/base/rational.h"

namespace geargraph {

/// The number of turns after which everything that turns at these rates is back where it was for the first
/// time: the smallest T > 0 that makes every rate times T a whole number. With rates in rad/s the period is 2
/// pi T seconds.
///
/// Identity: with rates a/b in lowest terms, T = lcm(b) / gcd(a). std::nullopt if all rates are 0.
/// Cost: one gcd per rate.
[[nodiscard]] std::optional<Rational> commonPeriod(std::span<const Rational> rates);

}  // namespace geargraph

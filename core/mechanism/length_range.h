#pragma once

#include <cmath>
#include <cstdint>

#include "core/base/diagnostic.h"
#include "core/mechanism/mechanism.h"

namespace geargraph {

/// Lengths, coordinates and components of directions are no larger than this, in whatever unit: their squares
/// and products stay far from what a double or a float can hold, and every search over them ends.
constexpr std::int64_t kLargestLength = 1'000'000'000'000'000;

/// Is the number no larger than kLargestLength?
[[nodiscard]] inline bool isInRange(const Number& number) {
  return std::abs(number.value()) <= static_cast<double>(kLargestLength);
}

/// `schema` for every length, coordinate, component of a direction, position of a node or measure of a wheel
/// beyond +-kLargestLength, and for directions shorter than its inverse. Edits refuse what has any.
/// Cost: O(n + t + c).
[[nodiscard]] Diagnostics rangeDiagnostics(const Mechanism& mechanism);

}  // namespace geargraph

#pragma once

#include <optional>
#include <string_view>

#include "core/mechanism/model/number.h"

namespace geargraph {

// Numbers as people type them, for fields of the window and options of the command line. All are exact, but
// for conversions by pi, where a degree is 0.017453292519943295 rad: so ratios of typed angles and speeds
// stay exact, and the values are right to the last digit of a double.

enum class Quantity {
  number,
  angle,   ///< degrees
  speed,   ///< rad/s
  torque,  ///< N m
  force,   ///< N
};

/// A number or an expression of numbers: "12", "22/7", "2*3", "1/3+1/5" (arithmeticFromText()). A single
/// number keeps its spelling. std::nullopt for anything else.
[[nodiscard]] std::optional<Number> typedNumber(std::string_view text);

/// The same with a unit, converted; without one it is in the unit of the quantity (a number has none):
///
/// angle   deg °, rad, turn turns rev
/// speed   rad/s, rad/min, deg/s °/s, deg/min, rpm 1/min min-1 rev/min turns/min U/min, rev/s turns/s rps
/// torque  Nm, N m, N·m, mN m, kN m, N mm, N cm, lbf ft (lb ft, ft lbf), lbf in, ozf in, kgf m, kgf cm; a
/// power in
///         W, kW, MW, hp, PS at a speed: "2 kW @ 1500 rpm", "2 kW at 1500 rpm"
/// force   N, mN, kN, lbf, kgf
[[nodiscard]] std::optional<Number> quantityFromText(std::string_view text, Quantity quantity);

/// The same, std::nullopt without a unit too.
[[nodiscard]] std::optional<Number> withUnitFromText(std::string_view text, Quantity quantity);

/// An angle as the sum of its degrees and its radians, exactly. A unit is needed unless it is 0.
struct TypedAngle {
  Rational degrees;
  Rational radians;
};
[[nodiscard]] std::optional<TypedAngle> angleFromText(std::string_view text);

}  // namespace geargraph

#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/machine/measure/measure_spots.h"

namespace geargraph {

/// What a measured number is.
enum class MeasuredKind {
  distance,        ///< between two points, a point and a line, or two skew lines
  centreDistance,  ///< of parallel axes
  pitchRadius,     ///< from a pitch point to the axis of one of its wheels
  angle,           ///< between lines, 0 to 90 degrees
  along,           ///< between points, along the parallel axes that they lie on
  pitchDiameter,
  tipDiameter,
  rootDiameter,
  faceWidth,
};

/// A measured number in the document's unit of length; an angle in degrees.
struct MeasuredValue {
  MeasuredKind measure = MeasuredKind::distance;
  double value = 0;
  /// The square of a length that is known in fractions: the length is its root.
  std::optional<Rational> square = {};
  /// An angle in degrees that is known exactly: one of 0, 30, 45, 60 and 90, the only ones with a rational
  /// squared cosine that are rational parts of a turn.
  std::optional<int> degrees = {};
  /// Whose diameter it is, where a mesh has two; empty: there is no other.
  std::optional<LinkOrdinal> link = {};

  /// The length itself as a fraction, if it is one.
  [[nodiscard]] std::optional<Rational> fraction() const {
    return square ? square->squareRoot() : std::nullopt;
  }
};

/// What was measured in the reference pose.
struct Measurement {
  std::vector<MeasuredValue> values{};  ///< the one that matters most first
  Vector3 from{};                       ///< ends of the line that is measured; equal where there is none
  Vector3 to{};
};

/// The sizes at one spot: the pitch diameters of a mesh, the diameters of a wheel. Empty values: there is
/// nothing to measure before a second spot is chosen.
[[nodiscard]] Measurement measured(const Spot& spot);

/// From one spot to another.
///
/// Parallel axes: their centre distance. Axes that intersect: the angle. Skew axes: the shortest distance and
/// the angle. A pitch point and the axis of one of its wheels: pitch radius and diameter. Points: their
/// distance, and if they lie on parallel axes the centre distance, which comes first between wheels, and the
/// distance along them.
///
/// Whether lines are parallel is decided by placement/tolerance.h; they intersect if their distance is 0, or
/// at most kSameLine of that of their points, as rounded decimals leave it.
/// @pre both are of one train
[[nodiscard]] Measurement measured(const Spot& from, const Spot& to);

/// "centre distance", "pitch diameter of gear 3", in the language in use.
[[nodiscard]] std::string nameOf(const MeasuredValue& value);

/// The number with its unit, for people: "54 mm", "125/2 mm = 62.5 mm", "√2 mm ≈ 1.41421 mm"; six digits
/// where it is not known exactly.
[[nodiscard]] std::string textOf(const MeasuredValue& value, const std::string& unit);

}  // namespace geargraph

#include "core/mechanism/placement/axis_line.h"

#include <algorithm>
#include <cmath>

namespace geargraph {

ExactVector3 scaledToOne(const ExactVector3& direction) {
  const Rational largest = std::max({direction[0].abs(), direction[1].abs(), direction[2].abs()});
  return largest.inverse() * direction;
}

Vector3 unitDirection(const ExactVector3& direction) {
  return unit(toDoubles(scaledToOne(direction)));
}

Vector3 unitDirection(const NumberTriple& direction) {
  const Vector3 doubles = toDoubles(direction);
  const double square = dot(doubles, doubles);
  if (square == 1) return doubles;
  constexpr double kSmallest = 1e-200;  // whose digits are not lost below the smallest normal double
  constexpr double kLargest = 1e+200;
  return square > kSmallest && square < kLargest ? unit(doubles) : unitDirection(toFractions(direction));
}

ByAxis<AxisLine> givenLines(const Mechanism& mechanism) {
  std::vector<AxisLine> lines;
  lines.reserve(mechanism.axes.size());
  for (const Axis& axis : mechanism.axes) {
    AxisLine& line = lines.emplace_back();
    line.automatic = !axis.point || !axis.direction;
    if (line.automatic) continue;
    line.point = toDoubles(*axis.point);
    line.direction = unitDirection(*axis.direction);
  }
  return lines;
}

}  // namespace geargraph

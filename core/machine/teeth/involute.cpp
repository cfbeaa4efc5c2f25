#include "core/machine/teeth/involute.h"

#include <algorithm>
#include <cmath>

#include "core/foundations/base/contract.h"

namespace geargraph {

double involute(double angle) {
  return std::tan(angle) - angle;
}

double inverseInvolute(double value) {
  GEARGRAPH_REQUIRE(value >= 0);
  if (value == 0) return 0;
  // inv a = a^3/3 + ...; above about 50 degrees a = atan(a + inv a) is the better start.
  double angle = value < 0.3 ? std::cbrt(3 * value) : std::atan(value + 1.2);
  for (int step = 0; step < 12; ++step) {
    const double slope = std::tan(angle) * std::tan(angle);  // d inv / da
    const double next = angle - (involute(angle) - value) / slope;
    if (std::abs(next - angle) <= 1e-16 * angle) break;
    angle = next;
  }
  return angle;
}

double centreDistance(int teethSum, double shiftSum, double pressureAngle) {
  const double value = involute(pressureAngle) + 2 * std::tan(pressureAngle) * shiftSum / teethSum;
  const double working = inverseInvolute(std::max(value, 0.0));
  return teethSum * std::cos(pressureAngle) / (2 * std::cos(working));
}

double workingPressureAngle(int teethSum, double distance, double pressureAngle) {
  return std::acos(std::min(teethSum * std::cos(pressureAngle) / (2 * distance), 1.0));
}

double shiftSumFor(int teethSum, double distance, double pressureAngle) {
  const double working = workingPressureAngle(teethSum, distance, pressureAngle);
  return (involute(working) - involute(pressureAngle)) * teethSum / (2 * std::tan(pressureAngle));
}

}  // namespace geargraph

#include "core/theory/matroid/screw.h"

namespace geargraph {

Vector3Of<Vector3> offsetRotation(double phi) {
  const double c = std::cos(phi);
  const double s = std::sin(phi);
  return {Vector3{1, 0, 0}, Vector3{0, c, -s}, Vector3{0, s, c}};
}

Vector3 offsetDirection(double phi) {
  const Vector3Of<Vector3> rows = offsetRotation(phi);
  const Vector3 z{0, 0, 1};
  return {dot(rows[0], z), dot(rows[1], z), dot(rows[2], z)};
}

}  // namespace geargraph

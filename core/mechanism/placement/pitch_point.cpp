#include "core/mechanism/placement/pitch_point.h"

namespace geargraph {

Vector3 bevelPitchPoint(const GearPair<double>& pair, BevelSides sides, double module) {
  const Vector3 tail = unit(pair.tailDirection);
  const Vector3 head = unit(pair.headDirection);
  const double size = module / (2 * length(cross(tail, head)));
  return apexOf(pair) + size * ((sides.tail * static_cast<double>(pair.headTeeth)) * tail +
                                (sides.head * static_cast<double>(pair.tailTeeth)) * head);
}

std::optional<ExactVector3> bevelPitchPoint(const GearPair<Rational>& pair, BevelSides sides,
                                            const Rational& module) {
  const auto tailLength = dot(pair.tailDirection, pair.tailDirection).squareRoot();
  const auto headLength = dot(pair.headDirection, pair.headDirection).squareRoot();
  if (!tailLength || !headLength) return std::nullopt;
  const ExactVector3 tail = tailLength->inverse() * pair.tailDirection;
  const ExactVector3 head = headLength->inverse() * pair.headDirection;
  const ExactVector3 normal = cross(tail, head);
  const auto sine = dot(normal, normal).squareRoot();
  if (!sine) return std::nullopt;
  const Rational size = module / (Rational(2) * *sine);
  return apexOf(pair) +
         size * (Rational(sides.tail * pair.headTeeth) * tail + Rational(sides.head * pair.tailTeeth) * head);
}

}  // namespace geargraph

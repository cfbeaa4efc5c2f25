#include "core/mechanism/placement/pair_rule.h"

#include <numbers>

namespace geargraph {
namespace {

/// @tparam alike  both gears turn in the same direction
template <bool alike, class Scalar>
Vector3Of<Scalar> pointBetweenParallels(const GearPair<Scalar>& pair, const PitchPlace<Scalar>& place) {
  return parallelPitchPoint(pair, alike, place.level);
}

template <bool alike>
std::optional<ExactVector3> exactPointBetweenParallels(const GearPair<Rational>& pair,
                                                       const PitchPlace<Rational>& place) {
  return parallelPitchPoint(pair, alike, place.level);
}

Vector3 bevelPoint(const GearPair<double>& pair, const PitchPlace<double>& place) {
  return bevelPitchPoint(pair, place.sides, place.module);
}

std::optional<ExactVector3> exactBevelPoint(const GearPair<Rational>& pair,
                                            const PitchPlace<Rational>& place) {
  return bevelPitchPoint(pair, place.sides, place.module);
}

/// Running radii: as stated, else teeth times pitch, else half of the distance for both, so that the strands
/// are seen between the pulleys.
std::pair<double, double> runningRadii(const GearMesh& mesh, double distance) {
  if (mesh.tailDiameter && mesh.headDiameter)
    return {mesh.tailDiameter->value() / 2, mesh.headDiameter->value() / 2};
  const double perTooth =
      mesh.pitch ? mesh.pitch->value() / std::numbers::pi : distance / (mesh.tailTeeth + mesh.headTeeth);
  return {mesh.tailTeeth * perTooth / 2, mesh.headTeeth * perTooth / 2};
}

/// The circle of the pins: both axes see the same, whatever it is; here far enough out for the eccentricity.
std::pair<double, double> pinRadii(const GearMesh& /*mesh*/, double distance) {
  constexpr double kDistances = 4;
  return {kDistances * distance, kDistances * distance};
}

}  // namespace

constexpr PairRule kExternalRule{pointBetweenParallels<false, double>, exactPointBetweenParallels<false>};
constexpr PairRule kInternalRule{pointBetweenParallels<true, double>, exactPointBetweenParallels<true>};
constexpr PairRule kBevelRule{bevelPoint, exactBevelPoint};
constexpr PairRule kBeltRule{.radii = runningRadii};
constexpr PairRule kPinsRule{.radii = pinRadii};

KindTable<MeshKind, PairRule>& pairRules() {
  static constinit KindTable<MeshKind, PairRule> table(&kExternalRule, &kInternalRule, &kBevelRule,
                                                       &kBeltRule, &kPinsRule);
  return table;
}

const PairRule& pairRule(MeshKind kind) {
  return pairRules()[kind];
}

}  // namespace geargraph

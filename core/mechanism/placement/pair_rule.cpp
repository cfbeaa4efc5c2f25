#include "core/mechanism/placement/pair_rule.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/mechanism/placement/hypoid.h"

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

/// Of equal helix angles: transverse modules of the train's size. A stated module and helix angle make their
/// own.
Rational crossedHelicalDistance(const GearMesh& mesh, const Rational& module) {
  if (!mesh.module && !mesh.helixAngle) return module * Rational(mesh.tailTeeth + mesh.headTeeth, 2);
  const double helix = mesh.helixAngle ? std::abs(helixOf(mesh)) : std::numbers::pi / 4;
  const double normal = mesh.module ? mesh.module->value() : module.toDouble() * std::cos(helix);
  return Rational::fromDouble(normal / 2 *
                              (mesh.tailTeeth / std::cos(helix) + mesh.headTeeth / std::sin(helix)));
}

/// The pitch radius of the pinion, the wheel with fewer teeth.
Rational rackDistance(const GearMesh& mesh, const Rational& module) {
  Rational own = module;
  if (mesh.module) {
    own = mesh.module->exact();
  } else if (mesh.pitch) {
    own = Rational::fromDouble(mesh.pitch->value() / std::numbers::pi);
  }
  return own * Rational(std::min(mesh.tailTeeth, mesh.headTeeth), 2);
}

/// With the usual worm of ten modules.
Rational wormDistance(const GearMesh& mesh, const Rational& module) {
  const Rational axial = mesh.module ? mesh.module->exact() : module;
  return axial * Rational(10 + std::max(mesh.tailTeeth, mesh.headTeeth), 2);
}

/// A fifth of the gear's radius, as in axles.
Rational hypoidDistance(const GearMesh& mesh, const Rational& module) {
  const Rational own = mesh.module ? mesh.module->exact() : module;
  return own * Rational(std::max(mesh.tailTeeth, mesh.headTeeth), 10);
}

}  // namespace

constexpr PairRule kExternalRule{pointBetweenParallels<false, double>, exactPointBetweenParallels<false>};
constexpr PairRule kInternalRule{pointBetweenParallels<true, double>, exactPointBetweenParallels<true>};
constexpr PairRule kBevelRule{bevelPoint, exactBevelPoint};
constexpr PairRule kBeltRule{.radii = runningRadii};
constexpr PairRule kPinsRule{.radii = pinRadii};
constexpr PairRule kRackRule{.crossedDistance = rackDistance};
constexpr PairRule kScrewRule{};
constexpr PairRule kCrossedHelicalRule{
    .placeSkew = placeCrossing, .crossed = crossedHelicalWheels, .crossedDistance = crossedHelicalDistance};
constexpr PairRule kWormRule{
    .placeSkew = placeCrossing, .crossed = wormWheels, .crossedDistance = wormDistance};
constexpr PairRule kFaceGearRule{bevelPoint, exactBevelPoint};
constexpr PairRule kHypoidRule{.placeSkew = placeHypoid, .crossedDistance = hypoidDistance};

KindTable<MeshKind, PairRule>& pairRules() {
  static constinit KindTable<MeshKind, PairRule> table(
      &kExternalRule, &kInternalRule, &kBevelRule, &kBeltRule, &kPinsRule, &kRackRule, &kScrewRule,
      &kCrossedHelicalRule, &kWormRule, &kFaceGearRule, &kHypoidRule);
  return table;
}

const PairRule& pairRule(MeshKind kind) {
  return pairRules()[kind];
}

}  // namespace geargraph

#include "core/mechanism/placement/pair_rule.h"

namespace geargraph::inline placement {
namespace {

/// @tparam alike  both gears turn in the same direction
template <bool alike, class Scalar>
Triple<Scalar> pointBetweenParallels(const GearPair<Scalar>& pair, const PitchPlace<Scalar>& place) {
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

}  // namespace

constexpr PairRule kExternalRule{pointBetweenParallels<false, double>, exactPointBetweenParallels<false>};
constexpr PairRule kInternalRule{pointBetweenParallels<true, double>, exactPointBetweenParallels<true>};
constexpr PairRule kBevelRule{bevelPoint, exactBevelPoint};

KindTable<MeshKind, PairRule>& pairRules() {
  static constinit KindTable<MeshKind, PairRule> table(&kExternalRule, &kInternalRule, &kBevelRule);
  return table;
}

const PairRule& pairRule(MeshKind kind) {
  return pairRules()[kind];
}

}  // namespace geargraph::inline placement

#pragma once

#include <optional>
#include <utility>

#include "core/foundations/base/rational.h"
#include "core/foundations/base/triple.h"
#include "core/mechanism/kinds/pair_kind.h"
#include "core/mechanism/model/mechanism.h"
#include "core/mechanism/placement/crossing.h"
#include "core/mechanism/placement/pitch_point.h"

namespace geargraph {

/// What the pitch point of a pair depends on besides its axes and teeth.
template <class Scalar>
struct PitchPlace {
  Vector3Of<Scalar> level{};  ///< parallel axes: a point of the plane in which the pitch circles touch
  BevelSides sides;           ///< intersecting axes: the half axes of the wheels
  Scalar module{};            ///< intersecting axes
};

/// What placement knows of a kind of gear pair: where the two wheels touch, which gives the pitch radii and
/// with them the row of P and the ratio with its sign (mesh_geometry.h).
struct PairRule {
  /// @pre the axes are as the kind says, and distanceTeeth() is not 0
  Vector3 (*pitchPoint)(const GearPair<double>& pair, const PitchPlace<double>& place) = nullptr;
  /// The same in fractions; std::nullopt if it is irrational.
  std::optional<ExactVector3> (*exactPitchPoint)(const GearPair<Rational>& pair,
                                                 const PitchPlace<Rational>& place) = nullptr;
  /// Of wheels that do not touch, instead of a pitch point: how far the line of action passes from the axes
  /// of tail and head, which are `distance` apart. Their ratio is that of the weights.
  std::pair<double, double> (*radii)(const GearMesh& mesh, double distance) = nullptr;
  /// On skew axes, instead of a pitch point: as placeCrossing(), and the wheels on cylinders that the
  /// distance and the crossing angle leave.
  SkewPlacer placeSkew = nullptr;
  CrossedRule crossed = nullptr;
  /// On skew axes: how far apart they are put where the document leaves that open, crossing at right angles.
  /// `module`: of the train.
  Rational (*crossedDistance)(const GearMesh& mesh, const Rational& module) = nullptr;
};

[[nodiscard]] KindTable<MeshKind, PairRule>& pairRules();
[[nodiscard]] const PairRule& pairRule(MeshKind kind);

/// The rules of the kinds that are there; an added kind may use one of them.
extern const PairRule kExternalRule;
extern const PairRule kInternalRule;
extern const PairRule kBevelRule;
extern const PairRule kBeltRule;
extern const PairRule kPinsRule;
extern const PairRule kRackRule;
extern const PairRule kScrewRule;
extern const PairRule kCrossedHelicalRule;
extern const PairRule kWormRule;
extern const PairRule kFaceGearRule;
extern const PairRule kHypoidRule;

}  // namespace geargraph

#pragma once

#include <optional>
#include <span>
#include <stop_token>
#include <vector>

#include "core/foundations/base/rational.h"
#include "core/mechanism/placement/placement.h"
#include "core/theory/levers/mesh_groups.h"
#include "core/theory/matroid/kinematic_model.h"

namespace geargraph {

/// With more links on the main axis, or more coordinates of their points together, there is no plan.
constexpr int kMaxLeverLinks = 400;
constexpr std::size_t kMaxLeverCoordinates = 20'000;

/// Why a mechanism has no lever.
enum class LeverAbsence {
  none,        ///< it has at least one
  unsolvable,  ///< no tree of turning joints, or a mesh without geometry
  noMesh,      ///< no mesh joins two links on the ground's axis
  locked,      ///< no link of the main axis can turn
  directions,  ///< meshes of the main axis lead to links whose axes point elsewhere
  tooLarge,    ///< beyond kMaxLeverLinks or kMaxLeverCoordinates
};

/// A place on a lever. Several links at one point turn as one in every motion.
struct LeverPoint {
  std::vector<LinkOrdinal> links;  ///< ascending
  Rational at;                     ///< 0 at one end, 1 at the other
  /// Is the place on the line for all tooth counts? False: for those of the document only.
  bool isByMeshes = true;
  bool isOneByMeshes = true;  ///< do several links turn as one for all tooth counts?
};

/// A line with three or more points of links on the main axis: in every motion of the train the speed of a
/// link is an affine function of its place (a rank-2 flat of the matroid of the points).
struct Lever {
  std::vector<LeverPoint> points;  ///< by `at`, ascending; at 0 the end whose link comes first
  std::vector<int> groups;         ///< mesh groups all of whose links on the main axis are on it
  /// Do three of its points lie on a line for all tooth counts?
  bool isByMeshes = true;

  [[nodiscard]] const LeverPoint* pointOf(LinkOrdinal link) const;
};

/// The links of the main axis as points of an affine space (H. L. Benford, M. B. Leising, The lever analogy,
/// SAE 810102, 1981). The main axis is the class of coaxial joints at the ground with the most
/// links, the first of these in the document's order. Coordinates of a link are the factors with which its
/// speed follows from the speeds of `basis`; the ground is at the origin. A motion is an affine function on
/// the space, and the speed of a link about the main axis its value.
///
/// Identity  points of a mesh with links i, j, k of the axis: N_i (x_i - x_k) = s N_j (x_j - x_k).
/// Shape     one point a link of `links`, `freedom` coordinates each.
struct LeverPlan {
  LeverAbsence absence = LeverAbsence::unsolvable;
  AxisGroupOrdinal mainAxis = -1;  ///< speeds are about its line
  int freedom = 0;                 ///< of the train with the ground held: E
  std::vector<LinkOrdinal> links;  ///< of the main axis, the ground first, ascending
  /// The links whose speeds are the coordinates: of the main axis, the first that are independent. Where they
  /// are fewer than `freedom`, the other coordinates are 0: freedoms that do not reach the main axis.
  std::vector<LinkOrdinal> basis;
  std::vector<std::vector<Rational>> points;
  std::vector<MeshGroup> groups;
  std::vector<Lever> levers;  ///< in the order of their first meshes; without a mesh last
  /// The first mesh from a wheel on the main axis to one whose axis points elsewhere (a bevel pinion).
  std::optional<MeshOrdinal> turningAway;

  /// The position of a link in `links`; -1 for one that is not on the main axis.
  [[nodiscard]] int positionOf(LinkOrdinal link) const;
  /// Do these links, which share a point, turn as one for all tooth counts, as far as levers tell?
  [[nodiscard]] bool areOneByMeshes(const std::vector<LinkOrdinal>& shared) const;
  /// Links of the main axis that share a point, for each point with several, ascending.
  [[nodiscard]] std::vector<std::vector<LinkOrdinal>> coincident() const;
};

/// The main axis: see LeverPlan. -1 if no class of coaxial joints is at the ground.
/// @pre the placement has a tree
[[nodiscard]] AxisGroupOrdinal mainAxisOf(const Placement& placement);

/// The plan of the meshes and of the engaged couplings in `held` (engagement.h), each of which projects the
/// points along one direction. std::nullopt if `stop` was requested.
/// Cost: an exact elimination of the train, and links^2 times freedom for the lines.
/// @pre model and placement are of one mechanism
[[nodiscard]] std::optional<LeverPlan> leverPlanOf(const KinematicModel& model, const Placement& placement,
                                                   std::span<const KinematicModel::HeldRow> held = {},
                                                   const std::stop_token& stop = {});

}  // namespace geargraph

#pragma once

#include <optional>
#include <span>
#include <vector>

#include "core/foundations/exact/radical_columns.h"
#include "core/mechanism/model/mechanism.h"
#include "core/theory/matroid/kinematic_model.h"

namespace geargraph {

/// Where a torque of statics acts: in a turning joint, by its tail on its head about +direction of its axis;
/// or on a link about a direction of the base frame, with the reaction on the ground.
struct TorquePlace {
  JointOrdinal joint = -1;   ///< ordinal; -1: on a link
  LinkOrdinal link = 0;      ///< ordinal
  AxisOrdinal axis = -1;     ///< position of the document's axis that gives the direction; -1: in a joint
  ExactVector3 direction{};  ///< of any length above 0; on a link

  [[nodiscard]] bool inJoint() const { return joint >= 0; }
};

/// A torque of known size, N m.
struct AppliedTorque {
  TorquePlace place;
  Rational torque;
};

/// A force of known size, N, on a link, at a point of it in the reference pose (base frame, document's unit).
struct AppliedForce {
  LinkOrdinal link = 0;
  ExactVector3 force{};
  ExactVector3 point{};
};

/// What acts on a train and what holds it. Links, joints and couplings are positions.
struct StaticsProblem {
  std::vector<AppliedTorque> torques;
  std::vector<AppliedForce> forces;
  std::vector<TorquePlace> balances;  ///< where torques are to be found
  std::vector<int> engaged;           ///< couplings, ascending

  [[nodiscard]] bool hasLoads() const { return !torques.empty() || !forces.empty(); }
};

/// The place of a torque about an axis of the document on a link.
/// @pre the placement is the mechanism's and has a tree
[[nodiscard]] TorquePlace onLink(const Mechanism& mechanism, const Placement& placement, LinkOrdinal link,
                                 std::optional<AxisId> axis);

/// Adds the torques and forces of these loads, which refer to elements of the document, to the problem.
/// @pre the loads name elements of the mechanism; the placement has a tree
void addLoads(const Mechanism& mechanism, const Placement& placement, std::span<const Load> loads,
              StaticsProblem& problem);
/// Where the torques of these balances act. @pre as addLoads()
[[nodiscard]] std::vector<TorquePlace> placesOf(const Mechanism& mechanism, const Placement& placement,
                                                std::span<const HoldingTorque> balances);

/// Metres in one of the document's unit; std::nullopt if the unit is not known.
[[nodiscard]] std::optional<Rational> metresPerUnit(const Mechanism& mechanism);

/// The power of the loads for unit speeds, in both coordinates of a motion. The loads are in equilibrium with
/// the torques in meshes, couplings and balances if and only if all of them together do no work in any motion
/// (principle of virtual work).
struct LoadPower {
  /// By link v, the power for phi_v = 1 of the kinematic model, W per rad/s = N m.
  RadicalColumns byLink;
  /// By joint e: tau_e + ell_e, the torque in the joint and the power of the loads on the links beyond it for
  /// the joint's rate 1. ell_e = sum over the links l beyond e of u_e . (moment of the load of l about the
  /// joint's axis), with the joint's sign to the ground.
  RadicalColumns byJoint;

  /// Forces are left out where the unit of length is not known.
  /// Cost: O(joints to the ground) per load.
  [[nodiscard]] static LoadPower of(const Mechanism& mechanism, const KinematicModel& model,
                                    const Placement& placement, const StaticsProblem& problem);
};

/// The cosine of the angle between two directions of any length above 0; exact where it is rational.
[[nodiscard]] Real cosineBetween(const ExactVector3& a, const ExactVector3& b);

}  // namespace geargraph

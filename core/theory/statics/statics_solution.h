#pragma once

#include <algorithm>
#include <optional>
#include <span>
#include <stop_token>
#include <utility>
#include <vector>

#include "core/foundations/exact/elimination.h"
#include "core/foundations/exact/fields.h"
#include "core/theory/statics/held_parts.h"

namespace geargraph {

/// A motion that meshes, couplings and balances allow and in which the loads do work: so nothing holds them.
struct FreeMotion {
  ByJoint<Rational> rates;
  std::vector<int> joints;  ///< those that turn, ascending
};

/// The losses of a mesh: which gear drives, and the efficiency then.
struct MeshLoss {
  enum class Driver { none, tail, head };
  Driver driver = Driver::none;
  Rational efficiency = 1;
};

/// The torques in a train at rest or in steady motion, in fractions: (17*) tau + ell = P^T F, one equation
/// per turning joint, solved in axis-group coordinates (statics_system.h).
///
/// Unknowns are the meshes 0..c-1 (mu, torque per tooth), then the held parts (couplings, balances). One that
/// is 0 in every null vector is determined; a null vector is a self-stress: torques in equilibrium without
/// any load. Where the loads are not held, there are no values.
struct StaticsSolution {
  std::vector<HeldPart> held;
  int equations = 0;
  int unknowns = 0;
  int rank = 0;
  std::vector<Real> values;      ///< by unknown; 0 for what is free in self-stresses; empty where unbalanced
  std::vector<char> determined;  ///< by unknown
  /// By free unknown: the weights of its members, as (unknown, weight), ascending.
  std::vector<std::vector<std::pair<int, Rational>>> selfStresses;
  std::optional<FreeMotion> unheld;  ///< where the loads are not held
  bool isExact = true;               ///< no coefficient is rounded

  [[nodiscard]] bool isBalanced() const { return !unheld; }
  [[nodiscard]] int indeterminate() const { return static_cast<int>(selfStresses.size()); }
  /// Has every unknown a value: is none free, or was the share decided (stiffness.h)?
  [[nodiscard]] bool isDeterminate() const {
    return std::find(determined.begin(), determined.end(), 0) == determined.end();
  }
  [[nodiscard]] bool isDetermined(int unknown) const {
    return determined[static_cast<std::size_t>(unknown)] != 0;
  }
};

/// std::nullopt if `stop` was requested. `losses` by mesh, or empty: none.
/// Cost: one exact elimination, near linear in n + c; the self-stresses; where the loads are not held,
/// another elimination for the motion.
[[nodiscard]] std::optional<StaticsSolution> solveStatics(const KinematicModel& model,
                                                          std::vector<HeldPart> held,
                                                          const RadicalColumns& loads,
                                                          std::span<const MeshLoss> losses = {},
                                                          const std::stop_token& stop = {});

/// The transposed kinematics: torques that hold a torque 1 N m in each of the loaded joints, row by row,
/// balanced x loaded; (23*) tau_balanced = -K_r^T tau_loaded with K_r that of the rates, (23).
struct TorqueMatrix {
  std::vector<int> balanced;  ///< positions of held parts that are balances
  std::vector<int> loaded;    ///< joints
  std::vector<Rational> entries;
};
/// std::nullopt if `stop` was requested, or the balances do not hold these loads or are not determined by
/// them.
[[nodiscard]] std::optional<TorqueMatrix> torqueMatrix(const KinematicModel& model,
                                                       std::span<const HeldPart> held,
                                                       std::span<const int> loaded,
                                                       const std::stop_token& stop = {});

/// phi of the kinematic model for these rates of all joints (0 for the ground).
template <class Value>
[[nodiscard]] ByLink<Value> phiOf(const KinematicModel& model, SpanByJoint<const Value> rates) {
  ByLink<Value> phi(static_cast<std::size_t>(model.n()) + 1, Value(0));
  for (const LinkOrdinal link : model.tree().preorder()) {
    if (link == 0) continue;
    const JointOrdinal joint = model.tree().jointToParent(link);
    const KinematicModel::JointRate& rate = model.jointRate(joint);
    phi[link] = Value(rate.sign) * rates[joint];
    if (rate.parent != 0) phi[link] += phi[rate.parent];
  }
  return phi;
}

}  // namespace geargraph

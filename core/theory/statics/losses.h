#pragma once

#include <optional>
#include <span>
#include <stop_token>
#include <vector>

#include "core/machine/train/mesh_contact.h"
#include "core/theory/statics/stiffness.h"

namespace geargraph {

/// The efficiency of one mesh, of the power that crosses it seen from its carrier.
struct MeshEfficiency {
  Rational value = 1;    ///< where the tail's gear drives
  bool isGiven = false;  ///< an efficiency or a friction is stated for it; else it is 1
  bool isExact = true;   ///< false where it comes from friction, or from angles that are not rational
  /// Where the head's gear drives, if that differs: gears on skew axes. One that is not above 0 cannot drive.
  std::optional<Rational> backward = {};

  [[nodiscard]] const Rational& of(MeshLoss::Driver driver) const {
    return driver == MeshLoss::Driver::head && backward ? *backward : value;
  }
  [[nodiscard]] bool loses() const { return value != Rational(1) || (backward && *backward != Rational(1)); }
};

/// The efficiencies that the document states, by mesh: its own, else that of gearDefaults, else `otherwise`,
/// else 1. From a coefficient of friction mu it is 1 - mu H_v (toothLossFactor()), and 1 for a mesh without
/// contact. `contacts`: by mesh; needed where hasFriction().
///
/// Gears on skew axes slide along their teeth. With mu' = mu / cos(alpha_n), the helix angles counted so that
/// tan(beta_1) + tan(beta_2) > 0, and gear 1 driving,
///
///     eta_12 = (1 - mu' tan(beta_2)) / (1 + mu' tan(beta_1)),
///
/// which is not eta_21: of a worm with lead angle g, eta = (1 - mu' tan g) / (1 + mu' cot g) forward and
/// (1 - mu' cot g) / (1 + mu' tan g) backward, not above 0 (self-locking) where tan g <= mu'. A stated
/// efficiency is that with the gear of the larger |tan(beta)| driving, the worm; it gives mu', and so the
/// other direction.
[[nodiscard]] std::vector<MeshEfficiency> efficienciesOf(
    const Mechanism& mechanism, const Placement& placement,
    std::span<const std::optional<MeshContact>> contacts = {}, const std::optional<Rational>& otherwise = {});
/// Does the document state a coefficient of friction for some mesh?
[[nodiscard]] bool hasFriction(const Mechanism& mechanism);

/// The torques of one mesh at its ports, N m: on the tail's gear and on the head's, each about the line of
/// its axis class, seen from the carrier, which has the reactions of both.
struct PortTorques {
  Real tail;  ///< M_ik = -mu_c N_i, times the efficiency where the head's gear drives
  Real head;  ///< M_jk = s mu_c N_j, times the efficiency where the tail's gear drives
};
/// `losses` by mesh, or empty.
[[nodiscard]] PortTorques portTorques(const KinematicModel& model, const StaticsSolution& solution,
                                      std::span<const MeshLoss> losses, MeshOrdinal mesh);

/// +1 where the joint next to the gear on the way to the carrier points as the class's line does, -1 against
/// it: the sign with which port torques are shown.
[[nodiscard]] int orientationSignAt(const Placement& placement, LinkOrdinal gear, AxisGroupOrdinal axisGroup);

/// A steady motion: the rates of all joints, by joint.
using Motion = ByJoint<Rational>;

/// The power through each mesh, and the power fed by the held parts, in a motion.
struct MeshPowers {
  /// Pi_c = F_c (A_c theta'), W, by mesh: from the tail's gear to the head's, seen from the carrier, taken at
  /// the gear that drives.
  std::vector<Real> mesh;
  ByMesh<char> rolls;      ///< the gears turn against the carrier
  std::vector<Real> held;  ///< W by held part: fed into the train
};
[[nodiscard]] MeshPowers powersOf(const KinematicModel& model, const StaticsSolution& solution,
                                  const Motion& motion);

/// The power that loads feed into the train in a motion, W.
[[nodiscard]] Real powerOf(const KinematicModel& model, const RadicalColumns& loads, const Motion& motion);

/// Torques with losses: constant efficiencies eta_c on the power seen from each carrier (Pennestri and
/// Freudenstein, J. Mech. Design 115(3), 1993, 645-651). Kinematics are unchanged; the row of mesh c is
/// A_c + eta_c B_c where the tail's gear drives (Pi_c > 0), eta_c A_c + B_c where the head's does, A_c + B_c
/// where the mesh does not roll or bears nothing; A_c, B_c the tail's and the head's part of row c of P.
///
/// A pattern of drivers is accepted if its own solution reproduces it and every balance feeds or takes power
/// as in the train without losses. Whether that pattern is unique with several loads and motors is not
/// proven; the drivers that were accepted are in `losses`.
struct LossySolution {
  enum class Outcome {
    solved,
    selfLocking,   ///< no pattern is accepted: the balances cannot move the loads in this direction
    patternLimit,  ///< too many meshes to try all patterns
    undecided      ///< the loads are not held, or the load of a mesh that loses power is indeterminate
  };
  Outcome outcome = Outcome::undecided;
  ByMesh<MeshLoss> losses;  ///< of the accepted pattern
  StaticsSolution statics;  ///< with these losses; where solved
  MeshPowers powers;
};

/// With more meshes than this, not all patterns are tried.
constexpr int kMaxPatternMeshes = 14;

/// `lossless` is the solution of the same problem with no losses. `stiffness`: P, to decide indeterminate
/// load sharing by equal stiffness (stiffness.h); null: then the outcome is undecided where meshes that lose
/// power share loads. If the iteration does not converge, all patterns of the lossy meshes are tried, if
/// there are at most `mostPatternMeshes` (not above kMaxPatternMeshes) of these; with 0 none is tried, and
/// the outcome is patternLimit. std::nullopt if `stop` was requested. Cost: two or three eliminations; where
/// these cycle, one for each pattern.
[[nodiscard]] std::optional<LossySolution> solveWithLosses(const KinematicModel& model,
                                                           const StaticsSolution& lossless,
                                                           const RadicalColumns& loads, const Motion& motion,
                                                           std::span<const MeshEfficiency> efficiencies,
                                                           const CoefficientMatrix* stiffness = nullptr,
                                                           const std::stop_token& stop = {},
                                                           int mostPatternMeshes = kMaxPatternMeshes);

/// The power fed into, taken from and lost in a train, over its loads and balances, W.
struct PowerSums {
  Real fed;
  Real taken;
  Real lost;
  /// Power taken over power fed; std::nullopt if nothing is fed.
  [[nodiscard]] std::optional<Real> efficiency() const {
    return fed.isZero() ? std::nullopt : std::optional(taken / fed);
  }
};
/// `loads`: one entry per load, as each feeds or takes power by itself. `heldBy`: by load, the held part that
/// holds it alone (HeldPart::holds()), with which it is one source of power; -1 where there is none. Empty:
/// none has one.
[[nodiscard]] PowerSums powerSums(const KinematicModel& model, const LossySolution& solution,
                                  std::span<const RadicalColumns> loads, const Motion& motion,
                                  std::span<const int> heldBy = {});

/// The fraction of the losses, 0 to 1, from which on the train is self-locking: all 1 - eta_c are multiplied
/// by it. std::nullopt if `stop` was requested. Found by bisection to 1e-6.
/// @pre the train is self-locking with all its losses
[[nodiscard]] std::optional<double> selfLockingPart(const KinematicModel& model,
                                                    const StaticsSolution& lossless,
                                                    const RadicalColumns& loads, const Motion& motion,
                                                    std::span<const MeshEfficiency> efficiencies,
                                                    const CoefficientMatrix* stiffness = nullptr,
                                                    const std::stop_token& stop = {});

}  // namespace geargraph

#pragma once

#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "core/theory/statics/statics_solution.h"

namespace geargraph {

/// The force of one mesh, by the tail's gear on the head's, at the drawn pitch point (a bevel's: mid face),
/// in the reference pose.
struct ToothForce {
  double tangential = 0;  ///< F_c along e_c, N: MeshGeometry::normal
  Vector3 direction{};    ///< s_c: the unit vector of the separating force on the head, see below
  double separating = 0;  ///< |F_c| tan(alpha_w), N
  /// Of helical teeth: |F_c| tan(beta_w), N, and its direction on the head's gear, along the axes.
  double axial = 0;
  Vector3 axialDirection{};
  Vector3 force{};  ///< their sum, N, base frame
  Vector3 point{};  ///< where it acts: the pitch point; of a belt the middle of the strand that pulls
  bool isDetermined = true;
};

/// The tooth forces, by mesh:
///
///     F_c e_c + |F_c| tan(alpha_w) s_c + |F_c| tan(beta_w) a_c,      F_c = mu_c N_tail / (e_c . r_A)
///
/// r_A the moment arm of the tail's axis at the pitch point, in metres. s_c is in the plane of the axes,
/// perpendicular to the pitch line (parallel axes: radial; bevel: perpendicular to the line from the apex).
/// The gear with the smaller pitch radius is pushed towards its own axis, the other one the opposite way:
/// external, internal and bevel pairs alike. For a bevel the radial part F tan a cos d and the axial part
/// F tan a sin d follow.
///
/// a_c is along the axes, such that the force stands across helical teeth: a right-hand gear that drives is
/// pushed the way of its angular velocity. It does no work. Of spiral bevels a_c is along the line where the
/// cones touch, with the spiral angle for beta_w; a face gear pushes its pinion away along its radius.
///
/// Gears on skew axes: F_c e_c + |F_c| tan(alpha_n) N with e_c across the teeth and N the common
/// perpendicular; its parts are told as the tail's gear bears them: tangential F_c cos(beta_i), axial F_c
/// sin(beta_i). Of a hypoid N is the normal of the pitch plane, and what is told as axial is along the line
/// of the tail gear's cone.
///
/// Wheels that do not touch have no separating force. Of a belt that can only pull the strand on the other
/// side of the line of centres takes what would push: the tight strand alone, without pretension, F = M / r.
///
/// `pressureAngles`, `helixAngles` by mesh: alpha_w, and beta_w of the tail's gear (MeshContact), at which
/// the pair works, rad; no helix angles: all teeth are straight. Empty where the unit of length is not known.
/// Doubles, because tan is irrational.
[[nodiscard]] std::vector<ToothForce> toothForces(const Mechanism& mechanism, const KinematicModel& model,
                                                  const Placement& placement, std::span<const double> values,
                                                  std::span<const char> determined,
                                                  std::span<const double> pressureAngles,
                                                  std::span<const double> helixAngles = {});

/// The reaction in a turning joint, of the tail on the head, at the point where the joint is drawn: W_e of
///
///     W_e - sum over meshes c of T_ce W_c + sum over links l beyond e of L_l = 0      (14*)
///
/// Five of its six components are the reactions of an ideal bearing, the one about the axis is tau_e. It
/// depends on the tree as drawn: attaching a coaxial gear to another member changes reactions, but no torque.
struct BearingReaction {
  Vector3 point{};   ///< in the document's unit
  Vector3 force{};   ///< N; 0 where the unit is not known
  Vector3 moment{};  ///< N m, about the point
  bool isDetermined = true;
};

/// The forces of a solved problem on gears and bearings.
struct StaticsForces {
  ByMesh<ToothForce> meshes;          ///< empty where the unit of length is not known
  ByJoint<BearingReaction> bearings;  ///< empty likewise
};

/// `values`, `determined`: by unknown, as of StaticsSolution. `losses`: by mesh, or empty. The torque lost in
/// a mesh is a couple on the driven gear about its axis, with its reaction on the carrier.
/// Cost: O(n + c). @pre all of one mechanism
[[nodiscard]] StaticsForces forcesOf(const Mechanism& mechanism, const KinematicModel& model,
                                     const Placement& placement, const StaticsProblem& problem,
                                     std::span<const HeldPart> held, std::span<const double> values,
                                     std::span<const char> determined, std::span<const MeshLoss> losses,
                                     std::span<const double> pressureAngles,
                                     std::span<const double> helixAngles = {});

/// The vector of least length that has these components along the directions (of length 1), by Gram-Schmidt
/// orthogonalisation; a direction that depends linearly on those before it is ignored.
[[nodiscard]] Vector3 vectorOf(const std::vector<std::pair<Vector3, double>>& components);

}  // namespace geargraph

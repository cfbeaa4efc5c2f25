#pragma once

#include <optional>
#include <span>
#include <stop_token>
#include <vector>

#include "core/foundations/base/rational.h"
#include "core/mechanism/model/mechanism.h"
#include "core/theory/matroid/kinematic_model.h"

namespace geargraph {

/// How far a joint turns from stop to stop while all inputs are held, by the play of the teeth alone.
struct LostMotion {
  JointOrdinal joint;
  /// By mesh: the joint turns by weights[c] e_c. Empty if the meshes share their play
  /// (LostMotions::isShared).
  ByMesh<Rational> weights;
  /// From stop to stop with every mesh at its worst, rad: sum of |weights[c]| plays[c]. None for a train with
  /// shared play that is too large.
  std::optional<Rational> worst;
  /// The root of the sum of squares of the same parts, rad: what is likely where plays are independent. None
  /// where they are shared.
  std::optional<double> rootOfSquares;
  /// By mesh, rad: what `worst` loses if the mesh has no play. Empty like `worst`.
  ByMesh<Rational> parts;

  /// The mesh with the largest part; none where no mesh has any.
  [[nodiscard]] std::optional<MeshOrdinal> mostOf() const;
};

struct LostMotions {
  std::vector<JointOrdinal> held;  ///< the inputs
  /// By mesh: the range of e_c = N_tail (w_tail - w_carrier) - s N_head (w_head - w_carrier) as angles, rad:
  /// the backlash of its two wheels in modules, b_tail + b_head; 0 for a negative one.
  ByMesh<Rational> plays;
  /// Meshes that follow from others (equal planets) meet their stops together: what the train can do is a
  /// polytope, and its vertices are sought.
  bool isShared = false;
  std::vector<LostMotion> outputs;  ///< the joints that are no inputs, by label

  /// The most meshes of a train with shared play whose polytope is searched.
  static constexpr int kMaxSharedMeshes = 40;
};

/// Lost motion at every joint. Play of bearings, and that of teeth whose stated profile shifts do not fill
/// their centre distance, is not counted. A wheel that is thinner by b/2 modules on its pitch circle turns by
/// b/N, so that all numbers are exact.
///
/// Identity  weights[c] is the torque per tooth of mesh c under a torque of 1 at the joint (statics), but for
///           the sign.
/// Cost      an exact elimination, and a substitution for each mesh; with shared play a linear program in
///           fractions for each joint and mesh.
/// std::nullopt if `stop` was requested, or there are more than ExactSolution::kMaxExactEntries weights.
/// @pre the inputs are a valid set of the model (as engaged)
[[nodiscard]] std::optional<LostMotions> lostMotions(const Mechanism& mechanism, const KinematicModel& model,
                                                     std::span<const int> inputs,
                                                     const std::stop_token& stop = {});

}  // namespace geargraph

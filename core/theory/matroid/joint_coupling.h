#pragma once

#include <optional>
#include <vector>

#include "core/mechanism/graph/spanning_tree.h"
#include "core/theory/matroid/exact_solution.h"

namespace geargraph {

/// How the motors of a train and as many of its joints are coupled, exactly. From [AU, Eq. (23)]: rows of the
/// solution, as a square matrix A, and its inverse.
///
///     rates, angles   joints = A motors       motors = A^-1 joints
///     torques         motors = A^T joints     joints = A^-T motors    (without losses: equal power)
///
/// Angles are those from the reference pose, in which all are 0. Signs are those of the document's joints.
struct JointCoupling {
  std::vector<JointOrdinal> motors;    ///< the inputs, E of them, in column order
  std::vector<JointOrdinal> joints;    ///< E joints
  std::vector<Rational> motorToJoint;  ///< A, E x E, row by row: a row a joint, a column a motor
  std::vector<Rational> jointToMotor;  ///< A^-1, a row a motor, a column a joint

  [[nodiscard]] int size() const { return static_cast<int>(motors.size()); }
};

/// A row of the solution for any joint: how it turns with each input at 1 rad/s. An input's own is a row of
/// the unit matrix. @pre the solution has its matrix
[[nodiscard]] std::vector<Rational> gainsOf(const ExactSolution& solution, JointOrdinal joint);

/// std::nullopt if the speeds of the joints do not determine those of the motors.
/// Cost: O(E^3) exact operations. @pre as many joints as inputs, the solution has its matrix
[[nodiscard]] std::optional<JointCoupling> jointCoupling(const ExactSolution& solution,
                                                         std::vector<JointOrdinal> joints);

/// The joints that a controller most likely means: those from the ground to a link, if none is an input, they
/// are as many as the inputs and determine them; of several such links the one with the fewest meshes, then
/// the first. Where no link has such a chain, the first joints by label that are no inputs and determine the
/// motors, and then inputs. std::nullopt where there are no inputs.
[[nodiscard]] std::optional<std::vector<JointOrdinal>> usualJoints(const ExactSolution& solution,
                                                                   const SpanningTree& tree,
                                                                   const Mechanism& mechanism);

}  // namespace geargraph

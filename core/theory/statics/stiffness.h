#pragma once

#include <stop_token>

#include "core/theory/matroid/coefficient_matrix.h"
#include "core/theory/statics/statics_solution.h"

namespace geargraph {

/// Decides the self-stresses of a held train by an assumption: all teeth are equally stiff, there is no
/// clearance and the bodies are rigid. Then the sum of F_c^2 over the meshes is minimal: the solution is
/// orthogonal to every self-stress. Equal planets share equally. Exact where pitch radii are rational, else
/// mu_c takes the place of F_c. Self-stresses between couplings alone stay undetermined.
///
/// False where `stop` was requested. Cost: the cube of the number of self-stresses.
/// @pre solution.isBalanced()
[[nodiscard]] bool shareByStiffness(const KinematicModel& model, const CoefficientMatrix& matrix,
                                    StaticsSolution& solution, const std::stop_token& stop = {});

}  // namespace geargraph

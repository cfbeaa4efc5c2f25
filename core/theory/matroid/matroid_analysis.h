#pragma once

#include <optional>
#include <stop_token>
#include <vector>

#include "core/theory/matroid/dependencies.h"
#include "core/theory/matroid/input_choice.h"
#include "core/theory/matroid/live_solution.h"
#include "core/theory/matroid/locked_loops.h"

namespace geargraph::inline matroid {

/// What the matroid method says about a mechanism, live: everything but the exact and symbolic solutions
/// (exact_solution.h, symbolic_solution.h) and the list of input sets (input_sets.h).
struct MatroidAnalysis {
  int rank = 0;         ///< r of P
  int dof = 0;          ///< E = t - r [AU, Eq. (21)]
  int kutzbachDof = 0;  ///< n - c

  std::vector<char> dead;  ///< by joint: can never turn
  std::vector<char> idle;  ///< by joint: on no mesh's cycle
  std::vector<Redundancy> redundancies;
  std::vector<int> independentMeshes;  ///< the r others
  std::vector<LockedLoop> lockedLoops;
  std::vector<std::vector<int>> rigidBlocks;  ///< links

  bool inputsGiven = false;      ///< by the document
  InputChoice choice;            ///< the given inputs where they are valid, else the nearest valid set
  std::vector<Rational> speeds;  ///< of choice.joints: as given; 1 for those that were added

  /// Solved for `choice`. None where the document's inputs are not valid: a mechanism with errors gets no
  /// numbers.
  std::optional<LiveSolution> solution;
  std::vector<Vector3> linkVelocities;  ///< by link, base frame; with the solution

  /// redundant-mesh, locked, dead-joint, idle-joint, no-meshes, invalid-inputs.
  Diagnostics diagnostics;
};

/// Nothing where `stop` was requested.
/// Cost: near linear in n + t + c; what is redundant or locked costs more to explain.
[[nodiscard]] std::optional<MatroidAnalysis> analyzeMatroid(const Mechanism& mechanism,
                                                            const KinematicModel& model,
                                                            const Placement& placement,
                                                            const std::stop_token& stop = {});

}  // namespace geargraph::inline matroid

#pragma once

#include <optional>
#include <stop_token>
#include <vector>

#include "core/theory/matroid/dependencies.h"
#include "core/theory/matroid/input_choice.h"
#include "core/theory/matroid/live_solution.h"
#include "core/theory/matroid/locked_loops.h"

namespace geargraph {

/// The result of the matroid method after each edit: everything but the exact and symbolic solutions
/// (exact_solution.h, symbolic_solution.h) and the list of input sets (input_sets.h).
struct MatroidAnalysis {
  int rank = 0;         ///< r of P with the rows of engaged couplings below it
  int dof = 0;          ///< E = t - r [AU, Eq. (21)]
  int kutzbachDof = 0;  ///< n minus the equations of meshes and engaged couplings

  ByJoint<char> dead;  ///< can never turn
  ByJoint<char> idle;  ///< on no cycle of a mesh or of an engaged coupling
  std::vector<Redundancy> redundancies;
  std::vector<int> independentMeshes;  ///< those that are not redundant; their number is the rank of P
  std::vector<int> independentHeld;    ///< the equations of engaged couplings that are not redundant
  std::vector<LockedLoop> lockedLoops;
  std::vector<std::vector<int>> rigidBlocks;  ///< links

  bool inputsGiven = false;  ///< by the document
  /// The given inputs where they are valid, else the nearest valid set. While couplings are engaged, inputs
  /// that follow from those before them are valid and are not driven (choice.rejected).
  InputChoice choice;
  std::vector<Rational> speeds;  ///< of choice.joints: as given; 1 for those that were added

  /// For `choice`. None if the document's inputs are invalid: a mechanism with errors gets no numbers.
  std::optional<LiveSolution> solution;
  ByLink<Vector3> linkVelocities;  ///< base frame, rad/s; empty without the solution

  /// The independent meshes, then the independent couplings: the rows for solveSymbolic().
  [[nodiscard]] std::vector<int> independentEquations() const;

  /// redundant-mesh, redundant-coupling, locked, dead-joint, idle-joint, no-meshes, invalid-inputs.
  Diagnostics diagnostics;
};

/// std::nullopt if `stop` was requested.
/// Cost: near linear in n + t + c; explaining redundant equations and locked joints costs more.
[[nodiscard]] std::optional<MatroidAnalysis> analyzeMatroid(const Mechanism& mechanism,
                                                            const KinematicModel& model,
                                                            const Placement& placement,
                                                            const std::stop_token& stop = {});

}  // namespace geargraph

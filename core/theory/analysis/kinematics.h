#pragma once

#include <memory>
#include <optional>
#include <stop_token>
#include <vector>

#include "core/mechanism/placement/placed_mechanism.h"
#include "core/theory/analysis/agreement.h"
#include "core/theory/matroid/exact_solution.h"
#include "core/theory/matroid/matroid_analysis.h"
#include "core/theory/matroid/symbolic_solution.h"
#include "core/theory/ttgraph/substitution_steps.h"
#include "core/theory/ttgraph/tt_graph.h"
#include "core/theory/ttgraph/tt_solution.h"

namespace geargraph {

/// What both methods compute after every edit, fast enough for dragging, for the train as the document
/// engages its couplings.
struct LiveKinematics {
  PlacedMechanism placed;
  std::shared_ptr<const TtGraph> ttGraph;  ///< never null; complete or not
  std::optional<KinematicModel> model;     ///< none if a mesh has no geometry
  /// None without the model, where an engaged coupling closes a linkage, or where pi is mixed.
  std::optional<MatroidAnalysis> matroid;
  /// turning-loop of engaged couplings, pi-mixed: there is no matroid analysis then
  Diagnostics engagement;

  [[nodiscard]] const Placement& placement() const { return placed.placement(); }
};

using LiveKinematicsPtr = std::shared_ptr<const LiveKinematics>;

/// Null if `stop` was requested. Cost: near linear in n + t + c.
/// @pre the placement has a tree
[[nodiscard]] LiveKinematicsPtr liveKinematics(const PlacedMechanism& placed,
                                               const std::stop_token& stop = {});

struct SolveOptions {
  bool symbolic = true;
};

/// The exact and symbolic solutions by both methods, and their agreement, for the inputs that the live
/// analysis chose.
struct SolvedKinematics {
  /// With more entries than this (outputs x inputs) there is no symbolic solution, and a diagnostic
  /// symbolic-skipped.
  static constexpr std::size_t kMaxSymbolicEntries = 20'000;

  std::optional<ExactSolution> exact;        ///< none where a row has a power of pi,
  std::optional<PiSolution> pi;              ///< which is there then
  std::optional<SymbolicSolution> symbolic;  ///< none if switched off or over its budget
  SubstitutionPlan ttPlan;
  std::optional<RateMatrix<Rational>> ttExact;  ///< none above ExactSolution::kMaxExactEntries
  std::optional<RateMatrix<PiNumber>> ttPi;     ///< instead of it beside `pi`
  std::optional<RateMatrix<std::optional<RationalFunction>>>
      ttSymbolic;  ///< in the names i_k; with `symbolic`
  /// The chain (39)-(42) in the T-T graph's own names; with ttSymbolic.
  std::optional<std::vector<SubstitutionStep>> ttSteps;
  std::optional<Agreement> agreement;
  Diagnostics diagnostics;  ///< symbolic-skipped

  /// The inputs and outputs of the solution, whichever there is.
  [[nodiscard]] const std::vector<int>& inputs() const { return exact ? exact->inputs : pi->inputs; }
  [[nodiscard]] const std::vector<int>& outputs() const { return exact ? exact->outputs : pi->outputs; }
};

using SolvedKinematicsPtr = std::shared_ptr<const SolvedKinematics>;

/// Null if `stop` was requested.
/// Also where the inputs of the document are invalid, for the nearest valid set (MatroidAnalysis::choice).
/// @pre the live analysis of the same mechanism has a matroid analysis
[[nodiscard]] SolvedKinematicsPtr solvedKinematics(const Mechanism& mechanism, const LiveKinematics& live,
                                                   const SolveOptions& options = {},
                                                   const std::stop_token& stop = {});

}  // namespace geargraph

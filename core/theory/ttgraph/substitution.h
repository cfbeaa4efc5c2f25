#pragma once

#include <span>
#include <vector>

#include "core/theory/ttgraph/tt_graph.h"

namespace geargraph {

/// The order in which the terminal equations give the unknown joint rates, as in Eqs. (39)-(42) of [AU]: take
/// a mesh with one unknown left in its terminal and circuit equations, or a coupling with one left in its
/// circuit, solve, substitute, repeat. No arithmetic is needed for the order. Where every remaining equation
/// has two unknowns or more, the rest is coupled and has to be solved together.
///
/// Columns number the joints for the solution: coupled unknowns first, then those that substitution gives,
/// then the inputs.
struct SubstitutionPlan {
  struct Step {
    int equation = 0;  ///< a mesh, or from c() on an engaged coupling (TtGraph::heldCircuit())
    JointOrdinal joint = 0;
  };

  /// The circuits are too long to store: no steps and no columns; the solution is found by levels
  /// (level_system.h).
  bool byLevels = false;
  std::vector<int> inputs;            ///< joints, in the order asked for
  std::vector<int> outputs;           ///< the other joints, ascending: the unknowns
  std::vector<Step> steps;            ///< in order; of several solvable equations the first is taken
  std::vector<int> surplusEquations;  ///< all their joints were known when they were reached
  std::vector<int> coupledEquations;  ///< ascending
  int coupledUnknowns = 0;
  ByJoint<int> columnOf;
  std::vector<int> jointAt;  ///< by column

  [[nodiscard]] int firstInputColumn() const { return static_cast<int>(outputs.size()); }
};

constexpr long long kMaxCircuitTerms = 200'000;

/// With more circuit terms than `mostTerms` the plan is by levels. Cost: the circuit terms, and O(c log c).
/// @pre graph.isComplete(); the inputs are joints of the graph, each once
[[nodiscard]] SubstitutionPlan substitutionPlan(const TtGraph& graph, std::span<const int> inputs,
                                                long long mostTerms = kMaxCircuitTerms);

}  // namespace geargraph

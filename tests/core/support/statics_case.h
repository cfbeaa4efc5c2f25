#pragma once

#include <memory>
#include <vector>

#include "core/theory/statics/live_statics.h"
#include "core/theory/statics/statics_agreement.h"
#include "core/theory/statics/statics_report.h"
#include "tests/core/support/matroid_fixture.h"

namespace geargraph::test {

/// A mechanism with all that statics works on.
struct StaticsCase : Worked {
  TtGraph tt;

  explicit StaticsCase(Mechanism of)
      : Worked(std::move(of)), tt(mechanism, graph, tree, ReferenceLines(placement)) {}

  [[nodiscard]] int joint(const char* id) const {
    int position = 0;
    while (mechanism.turningJoints[static_cast<std::size_t>(position)].id != JointId(id)) ++position;
    return position;
  }
  [[nodiscard]] static TorquePlace at(int joint) { return TorquePlace{joint}; }
  [[nodiscard]] TorquePlace on(int link) const { return onLink(mechanism, placement, link, {}); }

  /// Balances in these joints, no loads.
  [[nodiscard]] static StaticsProblem balancedIn(const std::vector<int>& joints) {
    StaticsProblem problem;
    for (const int joint : joints) problem.balances.push_back(at(joint));
    return problem;
  }
  [[nodiscard]] LoadPower power(const StaticsProblem& problem) const {
    return LoadPower::of(mechanism, model, placement, problem);
  }
  [[nodiscard]] std::vector<HeldPart> held(const StaticsProblem& problem) const {
    return heldParts(mechanism, model, placement, problem);
  }
  [[nodiscard]] StaticsSolution solve(const StaticsProblem& problem) const {
    return *solveStatics(model, held(problem), power(problem).byLink);
  }
  [[nodiscard]] TtTorques solveByTtGraph(const StaticsProblem& problem,
                                         long long mostTerms = kMaxCircuitTerms) const {
    return *ttTorques(tt, chordsOf(held(problem)), power(problem).byJoint, {}, mostTerms);
  }
  /// The torque of a balance, by its position in the problem.
  [[nodiscard]] Real balance(const StaticsSolution& solution, int position) const {
    for (std::size_t part = 0; part < solution.held.size(); ++part) {
      if (solution.held[part].balance == position)
        return solution.values[static_cast<std::size_t>(model.c()) + part];
    }
    throw std::logic_error("no such balance");
  }
  /// The torque of a coupling about the first axis to the ground.
  [[nodiscard]] Real coupling(const StaticsSolution& solution, const char* id) const {
    for (std::size_t part = 0; part < solution.held.size(); ++part) {
      const HeldPart& held = solution.held[part];
      if (held.coupling < 0 || !held.isMain) continue;
      if (mechanism.couplings[static_cast<std::size_t>(held.coupling)].id == ShiftElementId(id))
        return solution.values[static_cast<std::size_t>(model.c()) + part];
    }
    throw std::logic_error("no such coupling");
  }
};

inline StaticsReport reportOf(const StaticsCase& train, const StaticsOptions& options = {}) {
  return *analyzeStatics(train.mechanism, train.model, train.placement, train.tt, train.analysis, options);
}

}  // namespace geargraph::test

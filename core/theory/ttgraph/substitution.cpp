#include "core/theory/ttgraph/substitution.h"

#include <functional>
#include <queue>

#include "core/foundations/base/contract.h"

namespace geargraph {
namespace {

class Planner {
 public:
  Planner(const TtGraph& graph, std::span<const int> inputs)
      : m_graph(graph), m_known(static_cast<std::size_t>(graph.graph().t()), 0) {
    m_plan.inputs.assign(inputs.begin(), inputs.end());
    for (const JointOrdinal joint : inputs) {
      GEARGRAPH_REQUIRE(m_known.at(static_cast<std::size_t>(joint)) == 0);
      m_known[joint] = 1;
    }
    for (JointOrdinal joint = 0; joint < graph.graph().t(); ++joint) {
      if (m_known[joint] == 0) m_plan.outputs.push_back(joint);
    }
  }

  SubstitutionPlan byLevels() {
    m_plan.byLevels = true;
    return std::move(m_plan);
  }

  SubstitutionPlan run() {
    index();
    while (!m_ready.empty()) {
      const int equation = m_ready.top();
      m_ready.pop();
      m_done[static_cast<std::size_t>(equation)] = 1;
      if (m_unknowns[static_cast<std::size_t>(equation)] == 0) {
        m_plan.surplusEquations.push_back(equation);
      } else {
        solve(equation);
      }
    }
    for (int equation = 0; equation < m_graph.equations(); ++equation) {
      if (m_done[static_cast<std::size_t>(equation)] == 0) m_plan.coupledEquations.push_back(equation);
    }
    numberColumns();
    return std::move(m_plan);
  }

 private:
  template <class Visit>
  void forJointsOf(int equation, const Visit& visit) const {
    const auto visitAll = [&](std::span<const CircuitTerm> terms) {
      for (const CircuitTerm& term : terms) visit(static_cast<std::size_t>(term.joint));
    };
    if (equation >= m_graph.graph().c()) return visitAll(m_graph.heldCircuit(equation).terms);
    visitAll(m_graph.tailCircuit(equation));
    visitAll(m_graph.headCircuit(equation));
  }

  void index() {
    const int equations = m_graph.equations();
    m_unknowns.assign(static_cast<std::size_t>(equations), 0);
    m_done.assign(static_cast<std::size_t>(equations), 0);
    m_equationsOf.resize(m_known.size());
    for (int equation = 0; equation < equations; ++equation) {
      int& unknowns = m_unknowns[static_cast<std::size_t>(equation)];
      forJointsOf(equation, [&](std::size_t joint) {
        if (m_known[joint] != 0) return;
        ++unknowns;
        m_equationsOf[joint].push_back(equation);
      });
      if (unknowns <= 1) m_ready.push(equation);
    }
  }

  void solve(int equation) {
    std::size_t joint = 0;
    forJointsOf(equation, [&](std::size_t candidate) {
      if (m_known[candidate] == 0) joint = candidate;
    });
    m_known[joint] = 1;
    m_plan.steps.push_back({equation, static_cast<int>(joint)});
    for (const int other : m_equationsOf[joint]) {
      if (--m_unknowns[static_cast<std::size_t>(other)] == 1) m_ready.push(other);
    }
  }

  void numberColumns() {
    m_plan.columnOf.resize(m_known.size());
    const auto add = [this](JointOrdinal joint) {
      m_plan.columnOf[joint] = static_cast<int>(m_plan.jointAt.size());
      m_plan.jointAt.push_back(joint);
    };
    for (const JointOrdinal joint : m_plan.outputs) {
      if (m_known[joint] == 0) add(joint);
    }
    m_plan.coupledUnknowns = static_cast<int>(m_plan.jointAt.size());
    for (const SubstitutionPlan::Step& step : m_plan.steps) add(step.joint);
    for (const JointOrdinal joint : m_plan.inputs) add(joint);
  }

  const TtGraph& m_graph;
  ByJoint<char> m_known;
  std::vector<int> m_unknowns;                  ///< by equation: its unknown joints
  std::vector<char> m_done;                     ///< by equation
  std::vector<std::vector<int>> m_equationsOf;  ///< by unknown joint
  std::priority_queue<int, std::vector<int>, std::greater<>> m_ready;
  SubstitutionPlan m_plan;
};

}  // namespace

SubstitutionPlan substitutionPlan(const TtGraph& graph, std::span<const int> inputs, long long mostTerms) {
  GEARGRAPH_REQUIRE(graph.isComplete());
  Planner planner(graph, inputs);
  return graph.longestCircuitTerms() > mostTerms ? planner.byLevels() : planner.run();
}

}  // namespace geargraph

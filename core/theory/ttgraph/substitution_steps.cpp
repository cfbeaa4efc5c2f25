#include "core/theory/ttgraph/substitution_steps.h"

#include <algorithm>

#include "core/theory/ttgraph/symbolic_system.h"

namespace geargraph::inline ttgraph {
namespace {

using System = TtSystem<RationalFunctionField>;
using Rows = SparseRows<RationalFunction>;

class Chain {
 public:
  Chain(const RationalFunctionField& field, const TtGraph& graph, const SubstitutionPlan& plan,
        const RateMatrix<std::optional<RationalFunction>>& solution)
      : m_field(field),
        m_graph(graph),
        m_plan(plan),
        m_solution(solution),
        m_numbers(graph, static_cast<int>(plan.outputs.size())),
        m_numberOf(plan.jointAt.size(), 0) {}

  std::vector<SubstitutionStep> run(const SymbolicSystem& symbolic) {
    const System& system = symbolic.system;
    for (const SubstitutionPlan::Step& step : m_plan.steps) {
      add(step.joint, {step.equation}, system.direct().rows, step.equation);
    }
    for (const auto& line : system.rest().lines) {
      const JointOrdinal joint = m_plan.jointAt[static_cast<std::size_t>(line.column)];
      if (line.core) {
        add(joint, system.coupledEquations(), system.rest().coreRows, line.row);
      } else {
        add(joint, {system.restEquation(line.row)}, system.rest().rows, line.row);
      }
    }
    if (!symbolic.withoutCoupled) addStanding(system.coupledEquations());
    return std::move(m_steps);
  }

 private:
  /// The coupled unknowns that never turn: no line gives them.
  void addStanding(const std::vector<int>& equations) {
    for (int column = 0; column < m_plan.coupledUnknowns; ++column) {
      const JointOrdinal joint = m_plan.jointAt[static_cast<std::size_t>(column)];
      if (m_numberOf[joint] != 0) continue;
      SubstitutionStep step;
      step.joint = joint;
      step.coupled = true;
      step.equations = equations;
      finish(std::move(step));
    }
  }

  void add(JointOrdinal joint, std::vector<int> equations, const Rows& rows, int row) {
    SubstitutionStep step;
    step.joint = joint;
    step.coupled = equations.size() > 1;
    step.equations = std::move(equations);
    const int column = m_plan.columnOf[joint];
    const RationalFunction divisor = m_field.negated(pivotOf(rows, row, column));
    for (int entry = rows.begin(row); entry < rows.end(row); ++entry) {
      if (rows.column(entry) == column) continue;
      step.before.push_back({m_plan.jointAt[static_cast<std::size_t>(rows.column(entry))],
                             m_field.quotient(rows.value(entry), divisor)});
    }
    finish(std::move(step));
  }

  void finish(SubstitutionStep step) {
    step.number = m_numbers.step(static_cast<int>(m_steps.size()));
    step.uses = usesOf(step);
    const auto output = std::lower_bound(m_plan.outputs.begin(), m_plan.outputs.end(), step.joint);
    step.after = m_solution.entries[static_cast<std::size_t>(output - m_plan.outputs.begin())];
    m_numberOf[step.joint] = step.number;
    m_steps.push_back(std::move(step));
  }

  /// As in Eq. (40): the unknown's circuit, the terminal equation, the other circuit, the steps put in.
  [[nodiscard]] std::vector<int> usesOf(const SubstitutionStep& step) const {
    std::vector<int> uses;
    for (const int equation : step.equations) {
      if (equation >= m_graph.graph().c()) {
        uses.push_back(m_numbers.heldCircuit(equation - m_graph.graph().c()));
        continue;
      }
      const MeshOrdinal mesh = equation;
      const auto tail = m_graph.tailCircuit(mesh);
      const bool inTail = std::any_of(tail.begin(), tail.end(),
                                      [&](const CircuitTerm& term) { return term.joint == step.joint; });
      const int first = m_numbers.tailCircuit(mesh);
      const int second = m_numbers.headCircuit(mesh);
      uses.insert(uses.end(), {inTail ? first : second, m_numbers.terminal(mesh), inTail ? second : first});
    }
    std::vector<int> earlier;
    for (const SolvedTerm& term : step.before) {
      const int number = m_numberOf[term.joint];
      if (number != 0) earlier.push_back(number);
    }
    std::sort(earlier.begin(), earlier.end());
    uses.insert(uses.end(), earlier.begin(), earlier.end());
    return uses;
  }

  const RationalFunctionField& m_field;
  const TtGraph& m_graph;
  const SubstitutionPlan& m_plan;
  const RateMatrix<std::optional<RationalFunction>>& m_solution;
  EquationNumbers m_numbers;
  ByJoint<int> m_numberOf;  ///< its step's number; 0 while it has none
  std::vector<SubstitutionStep> m_steps;
};

}  // namespace

std::optional<std::vector<SubstitutionStep>> substitutionSteps(
    const RatioRingPtr& ring, const TtGraph& graph, const SubstitutionPlan& plan,
    const RateMatrix<std::optional<RationalFunction>>& solution, const std::stop_token& stop) {
  if (plan.byLevels) return std::vector<SubstitutionStep>();
  const auto symbolic = symbolicSystem(ring, graph, plan, stop);
  if (!symbolic) return std::nullopt;
  return Chain(*symbolic->field, graph, plan, solution).run(*symbolic);
}

}  // namespace geargraph::inline ttgraph

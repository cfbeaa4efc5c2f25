#include "core/theory/ttgraph/substitution_steps.h"

#include <algorithm>
#include <map>
#include <set>

#include "core/theory/ttgraph/symbolic_system.h"

namespace geargraph {
namespace {

using System = TtSystem<RationalFunctionField>;
using Rows = SparseRows<RationalFunction>;

class SubstitutionChain {
 public:
  SubstitutionChain(const RationalFunctionField& field, const TtGraph& graph, const SubstitutionPlan& plan,
                    const RateMatrix<std::optional<RationalFunction>>& solution)
      : m_field(field),
        m_graph(graph),
        m_plan(plan),
        m_solution(solution),
        m_numbers(graph, static_cast<int>(plan.outputs.size())),
        m_numberOf(plan.jointAt.size(), 0) {}

  std::vector<SubstitutionStep> run(const SymbolicSystem& symbolic) {
    const System& system = symbolic.system;
    addDirect(system.direct().rows);
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

  /// The steps of the plan by link, and before a link's whatever it needs beyond one joint.
  void addDirect(const Rows& rows) {
    std::vector<const SubstitutionPlan::Step*> byLink;
    ByJoint<const SubstitutionPlan::Step*> stepOf(m_plan.jointAt.size(), nullptr);
    for (const SubstitutionPlan::Step& step : m_plan.steps) {
      byLink.push_back(&step);
      stepOf[step.joint] = &step;
    }
    std::ranges::stable_sort(byLink, {}, [&](const SubstitutionPlan::Step* step) {
      return m_graph.graph().turningEdge(step->joint).head;
    });

    const auto open = [&](const SubstitutionPlan::Step& step) {
      std::vector<const SubstitutionPlan::Step*> needed;
      for (int entry = rows.begin(step.equation); entry < rows.end(step.equation); ++entry) {
        const JointOrdinal joint = m_plan.jointAt[static_cast<std::size_t>(rows.column(entry))];
        const auto* const other = stepOf[joint];
        if (other != nullptr && other != &step && m_numberOf[joint] == 0) needed.push_back(other);
      }
      return needed;
    };
    for (const auto* const next : byLink) {
      std::vector<const SubstitutionPlan::Step*> waiting{next};
      while (!waiting.empty()) {
        const SubstitutionPlan::Step& step = *waiting.back();
        std::vector<const SubstitutionPlan::Step*> needed;
        if (m_numberOf[step.joint] == 0) needed = open(step);
        if (needed.size() > 1 || (needed.size() == 1 && !open(*needed.front()).empty())) {
          waiting.insert(waiting.end(), needed.rbegin(), needed.rend());
          continue;
        }
        waiting.pop_back();
        if (m_numberOf[step.joint] == 0) addDirect(rows, step, needed.empty() ? nullptr : needed.front());
      }
    }
  }

  void addDirect(const Rows& rows, const SubstitutionPlan::Step& planned,
                 const SubstitutionPlan::Step* inner) {
    if (const auto outer = m_outerOf.find(planned.joint); outer != m_outerOf.end()) {
      return addTurned(planned.joint, m_steps[outer->second]);
    }
    SubstitutionStep step = solvedFor(planned.joint, {planned.equation}, rows, planned.equation);
    if (inner != nullptr) {
      step.inner = inner->joint;
      step.equations.push_back(inner->equation);
      m_outerOf.emplace(inner->joint, m_steps.size());
      m_innerTerms = solvedFor(inner->joint, {}, rows, inner->equation).before;
    }
    finish(std::move(step));
    m_innerTerms.clear();
  }

  /// The equation of `outer` solved for its inner joint.
  void addTurned(JointOrdinal joint, const SubstitutionStep& outer) {
    SubstitutionStep step;
    step.joint = joint;
    step.turned = outer.number;
    step.equations = {outer.equations.front()};
    const auto own = std::ranges::find(outer.before, joint, &SolvedTerm::joint);
    step.before.push_back({outer.joint, m_field.quotient(m_field.one(), own->coefficient)});
    const RationalFunction divisor = m_field.negated(own->coefficient);
    for (const SolvedTerm& term : outer.before) {
      if (term.joint != joint)
        step.before.push_back({term.joint, m_field.quotient(term.coefficient, divisor)});
    }
    finish(std::move(step));
  }

  void add(JointOrdinal joint, std::vector<int> equations, const Rows& rows, int row) {
    finish(solvedFor(joint, std::move(equations), rows, row));
  }

  [[nodiscard]] SubstitutionStep solvedFor(JointOrdinal joint, std::vector<int> equations, const Rows& rows,
                                           int row) const {
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
    return step;
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
    if (step.turned != 0) return {step.turned};
    std::vector<int> uses;
    for (const int equation : step.equations) {
      const JointOrdinal unknown =
          step.inner >= 0 && equation == step.equations.back() ? step.inner : step.joint;
      if (equation >= m_graph.graph().c()) {
        uses.push_back(m_numbers.heldCircuit(equation - m_graph.graph().c()));
        continue;
      }
      const MeshOrdinal mesh = equation;
      const auto tail = m_graph.tailCircuit(mesh);
      const bool inTail = std::any_of(tail.begin(), tail.end(),
                                      [&](const CircuitTerm& term) { return term.joint == unknown; });
      const int first = m_numbers.tailCircuit(mesh);
      const int second = m_numbers.headCircuit(mesh);
      uses.insert(uses.end(), {inTail ? first : second, m_numbers.terminal(mesh), inTail ? second : first});
    }
    std::set<int> earlier;
    for (const auto* const terms : {&step.before, &m_innerTerms}) {
      for (const SolvedTerm& term : *terms) {
        const int number = m_numberOf[term.joint];
        if (number != 0) earlier.insert(number);
      }
    }
    uses.insert(uses.end(), earlier.begin(), earlier.end());
    return uses;
  }

  const RationalFunctionField& m_field;
  const TtGraph& m_graph;
  const SubstitutionPlan& m_plan;
  const RateMatrix<std::optional<RationalFunction>>& m_solution;
  EquationNumbers m_numbers;
  ByJoint<int> m_numberOf;                        ///< its step's number; 0 while it has none
  std::map<JointOrdinal, std::size_t> m_outerOf;  ///< by inner joint: the place of the step that it is in
  std::vector<SolvedTerm> m_innerTerms;           ///< of the step in work
  std::vector<SubstitutionStep> m_steps;
};

}  // namespace

std::optional<std::vector<SubstitutionStep>> substitutionSteps(
    const RatioRingPtr& ring, const TtGraph& graph, const SubstitutionPlan& plan,
    const RateMatrix<std::optional<RationalFunction>>& solution, const std::stop_token& stop) {
  if (plan.byLevels) return std::vector<SubstitutionStep>();
  const auto symbolic = symbolicSystem(ring, graph, plan, stop);
  if (!symbolic) return std::nullopt;
  return SubstitutionChain(*symbolic->field, graph, plan, solution).run(*symbolic);
}

}  // namespace geargraph

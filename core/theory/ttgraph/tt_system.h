#pragma once

#include <algorithm>
#include <optional>
#include <span>
#include <stop_token>
#include <utility>
#include <vector>

#include "core/foundations/exact/elimination.h"
#include "core/foundations/exact/fields.h"
#include "core/theory/ttgraph/substitution.h"

namespace geargraph {

/// Equations and columns that a system leaves out.
struct LeftOut {
  std::vector<char> equations;  ///< by equation, 1: its row is left out; empty: none
  std::vector<char> columns;  ///< by column, 1: its terms in the coupled rest, for its rate is 0; empty: none
};

/// The terminal equations with their circuits substituted, one row per mesh, over a field:
///
///     tail(mesh) * (tail circuit) + head(mesh) * (head circuit) = 0
///
/// and below them the circuits of engaged couplings, each a sum of branches that is 0; solved by
/// substitution, and by the common elimination where the rest is coupled.
///
/// `Weights` gives the two factors of a mesh: N_i and -s N_j, or i and -s.
template <class Field>
class TtSystem {
 public:
  using Value = typename Field::Value;

  /// `left` concerns the coupled rest only. std::nullopt if `stop` was requested.
  /// Cost: the circuit terms, and the elimination of the coupled rest.
  template <class Weights>
  [[nodiscard]] static std::optional<TtSystem> of(const Field& field, const TtGraph& graph,
                                                  const SubstitutionPlan& plan, const Weights& weights,
                                                  const LeftOut& left = {},
                                                  const std::stop_token& stop = {}) {
    TtSystem system(field, plan);
    system.m_direct.unknowns = system.m_direct.columns = static_cast<int>(plan.jointAt.size());
    for (int equation = 0; equation < graph.equations(); ++equation) {
      system.addRow(system.m_direct.rows, graph, equation, weights, {});
    }
    for (const SubstitutionPlan::Step& step : plan.steps) {
      system.m_direct.lines.push_back({plan.columnOf[step.joint], step.equation, false});
    }
    SparseRows<Value> rest;
    for (const int equation : plan.coupledEquations) {
      if (!left.equations.empty() && left.equations[static_cast<std::size_t>(equation)] != 0) continue;
      system.addRow(rest, graph, equation, weights, left.columns);
      system.m_restEquations.push_back(equation);
    }
    auto solved =
        eliminate(field, std::move(rest), plan.coupledUnknowns, static_cast<int>(plan.jointAt.size()), stop);
    if (!solved) return std::nullopt;
    system.m_rest = std::move(*solved);
    return system;
  }

  /// Replaces the field by an equal one that lives longer.
  void setField(const Field& field) { m_field = &field; }

  /// Unknowns that the equations leave open: too few inputs, or dependent ones. Ascending.
  [[nodiscard]] std::vector<int> openJoints() const {
    std::vector<int> joints;
    for (const int column : m_rest.freeColumns) joints.push_back(jointAt(column));
    std::sort(joints.begin(), joints.end());
    return joints;
  }

  /// Equations that gave no unknown: redundant where they hold, else the inputs contradict each other.
  /// Ascending.
  [[nodiscard]] std::vector<int> surplusEquations() const {
    std::vector<int> equations = m_plan->surplusEquations;
    for (const auto& check : m_rest.checks) {
      equations.push_back(m_restEquations[static_cast<std::size_t>(check.source)]);
    }
    std::sort(equations.begin(), equations.end());
    return equations;
  }

  /// The rates of all joints, by joint, for these input rates; open joints are at rest.
  /// Cost: the non-zeros.
  [[nodiscard]] ByJoint<Value> rates(std::span<const Value> inputRates) const {
    std::vector<Value> x = columns(inputRates);
    substitute(*m_field, m_direct, x);
    substitute(*m_field, m_rest, x);
    return byJoint(std::move(x));
  }

  /// The rates of all joints, and whether every equation that gave no unknown holds.
  [[nodiscard]] std::pair<ByJoint<Value>, bool> solve(std::span<const Value> inputRates) const {
    ByJoint<Value> found = rates(inputRates);
    const bool all = holds(found);
    return {std::move(found), all};
  }

  /// Do the surplus equations hold at these rates?
  [[nodiscard]] bool holds(const ByJoint<Value>& rates) const {
    std::vector<Value> x;
    for (const JointOrdinal joint : m_plan->jointAt) x.push_back(rates[joint]);
    for (const int equation : surplusEquations()) {
      if (!m_field->isZero(negatedRowSum(*m_field, m_direct.rows, equation, x))) return false;
    }
    return true;
  }

  /// Rows by equation, lines in the order of the plan's steps.
  [[nodiscard]] const Elimination<Value>& direct() const { return m_direct; }
  /// The coupled rest, in the same columns.
  [[nodiscard]] const Elimination<Value>& rest() const { return m_rest; }

  /// The equation of a row of the rest.
  [[nodiscard]] int restEquation(int row) const { return m_restEquations[static_cast<std::size_t>(row)]; }
  /// The equations that had to be solved together: those of the rest that gave no unknown one by one.
  /// Ascending.
  [[nodiscard]] std::vector<int> coupledEquations() const {
    std::vector<char> alone(m_restEquations.size(), 0);
    for (const auto& line : m_rest.lines) {
      if (!line.core) alone[static_cast<std::size_t>(line.row)] = 1;
    }
    std::vector<int> equations;
    for (std::size_t row = 0; row < alone.size(); ++row) {
      if (alone[row] == 0) equations.push_back(m_restEquations[row]);
    }
    return equations;
  }

  /// The values by column: those of the inputs, else 0.
  [[nodiscard]] std::vector<Value> columns(std::span<const Value> inputRates) const {
    std::vector<Value> x(m_plan->jointAt.size(), m_field->fromInteger(0));
    std::copy(inputRates.begin(), inputRates.end(), x.begin() + m_plan->firstInputColumn());
    return x;
  }

 private:
  TtSystem(const Field& field, const SubstitutionPlan& plan) : m_field(&field), m_plan(&plan) {}

  [[nodiscard]] JointOrdinal jointAt(int column) const {
    return m_plan->jointAt[static_cast<std::size_t>(column)];
  }

  [[nodiscard]] ByJoint<Value> byJoint(std::vector<Value> x) const {
    ByJoint<Value> rates(x.size());
    for (std::size_t column = 0; column < x.size(); ++column) {
      rates[jointAt(static_cast<int>(column))] = std::move(x[column]);
    }
    return rates;
  }

  template <class Weights>
  void addRow(SparseRows<Value>& rows, const TtGraph& graph, int equation, const Weights& weights,
              const std::vector<char>& left) const {
    const auto add = [&](std::span<const CircuitTerm> circuit, const Value& weight) {
      const Value negative = m_field->negated(weight);
      for (const CircuitTerm& term : circuit) {
        const int column = m_plan->columnOf[term.joint];
        if (!left.empty() && left[static_cast<std::size_t>(column)] != 0) continue;
        rows.add(column, term.coefficient > 0 ? weight : negative);
      }
    };
    if (equation >= graph.graph().c()) {
      add(graph.heldCircuit(equation).terms, m_field->fromInteger(1));
    } else {
      const auto [tail, head] = weights(*graph.terminal(equation));
      add(graph.tailCircuit(equation), tail);
      add(graph.headCircuit(equation), head);
    }
    rows.endRow();
  }

  const Field* m_field;
  const SubstitutionPlan* m_plan;
  Elimination<Value> m_direct;
  Elimination<Value> m_rest;
  std::vector<int> m_restEquations;  ///< by row of the rest
};

/// The factors of Eq. (26) in whole numbers: N_i w_ik - s N_j w_jk = 0.
template <class Field>
struct TeethWeights {
  const Field* field;
  [[nodiscard]] std::pair<typename Field::Value, typename Field::Value> operator()(
      const TerminalPair& pair) const {
    return {field->fromInteger(pair.tailTeeth),
            weightIn(*field, -static_cast<std::int64_t>(pair.sign) * pair.headTeeth, pair.pi)};
  }
};

}  // namespace geargraph

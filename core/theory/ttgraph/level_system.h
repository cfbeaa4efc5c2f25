#pragma once

#include <algorithm>
#include <map>
#include <optional>
#include <span>
#include <stop_token>
#include <utility>
#include <vector>

#include "core/foundations/base/contract.h"
#include "core/foundations/exact/elimination.h"
#include "core/theory/ttgraph/substitution.h"

namespace geargraph {

/// The equations of TtSystem for circuits that are too long to store: along a level, the velocities of its
/// branches add up like voltages, so each link has one unknown, its velocity along its own level relative to
/// the level's root link. A circuit is then a difference of two unknowns, and so is a branch.
template <class Field>
class LevelSystem {
 public:
  using Value = typename Field::Value;

  /// std::nullopt if `stop` was requested. Cost: O(n + c), and the elimination.
  template <class Weights>
  [[nodiscard]] static std::optional<LevelSystem> of(const Field& field, const TtGraph& graph,
                                                     const SubstitutionPlan& plan, const Weights& weights,
                                                     const std::stop_token& stop = {}) {
    LevelSystem system(field, graph);
    SparseRows<Value> rows;
    for (MeshOrdinal mesh = 0; mesh < graph.graph().c(); ++mesh) {
      const TerminalPair& pair = *graph.terminal(mesh);
      const TransferVertex& vertex = *graph.transferVertices().ofMesh[mesh];
      const auto [tail, head] = weights(pair);
      system.addDifference(rows, pair.tail, pair.carrier, vertex.tailLevel, tail);
      system.addDifference(rows, pair.head, pair.carrier, vertex.headLevel, head);
      rows.endRow();
    }
    for (const HeldCircuit& circuit : graph.held()) system.addHeld(rows, circuit);
    const int links = graph.graph().n();
    for (std::size_t input = 0; input < plan.inputs.size(); ++input) {
      const auto [edge, level, sense] = system.branch(plan.inputs[input]);
      system.addDifference(rows, edge.head, edge.tail, level, field.fromInteger(sense));
      rows.add(links + static_cast<int>(input), field.fromInteger(-1));
      rows.endRow();
    }
    auto solved =
        eliminate(field, std::move(rows), links, links + static_cast<int>(plan.inputs.size()), stop);
    if (!solved) return std::nullopt;
    system.m_system = std::move(*solved);
    return system;
  }

  /// The joints towards the ground of the links whose velocity the equations leave open, ascending.
  [[nodiscard]] std::vector<int> openJoints() const {
    std::vector<int> joints;
    for (const int column : m_system.freeColumns) joints.push_back(m_graph->tree().jointToParent(column + 1));
    std::sort(joints.begin(), joints.end());
    return joints;
  }

  /// Equations that gave no unknown. Ascending.
  [[nodiscard]] std::vector<int> surplusEquations() const {
    std::vector<int> equations;
    for (const auto& check : m_system.checks) {
      if (check.source < m_graph->equations()) equations.push_back(check.source);
    }
    std::sort(equations.begin(), equations.end());
    return equations;
  }

  /// The rates of all joints, by joint, and whether every equation that gave no unknown holds.
  /// Cost: the non-zeros.
  [[nodiscard]] std::pair<ByJoint<Value>, bool> solve(std::span<const Value> inputRates) const {
    std::vector<Value> x(static_cast<std::size_t>(m_system.columns), m_field->fromInteger(0));
    std::copy(inputRates.begin(), inputRates.end(), x.begin() + m_system.unknowns);
    substitute(*m_field, m_system, x);
    const bool holds = std::all_of(m_system.checks.begin(), m_system.checks.end(), [&](const auto& check) {
      return m_field->isZero(checkValue(*m_field, m_system, check, x));
    });
    ByJoint<Value> rates;
    for (JointOrdinal joint = 0; joint < m_graph->graph().t(); ++joint) {
      const auto [edge, level, sense] = branch(joint);
      Value rate = m_field->fromInteger(0);
      const auto add = [&, level = level](LinkOrdinal node, int factor) {
        if (isOn(node, level)) {
          m_field->subtractProduct(rate, m_field->fromInteger(-factor),
                                   x[static_cast<std::size_t>(node - 1)]);
        }
      };
      add(edge.head, sense);
      add(edge.tail, -sense);
      rates.push_back(std::move(rate));
    }
    return {std::move(rates), holds};
  }

 private:
  struct Branch {
    DigraphEdge edge;
    int level = 0;
    int sense = 1;
  };

  LevelSystem(const Field& field, const TtGraph& graph) : m_field(&field), m_graph(&graph) {}

  [[nodiscard]] Branch branch(JointOrdinal joint) const {
    const auto at = static_cast<std::size_t>(joint);
    return {m_graph->graph().turningEdge(joint), m_graph->levels().ofJoint[at],
            m_graph->levels().orientationSign(joint)};
  }

  /// Has the node an unknown on this level? The level's root link has none: it is the reference.
  [[nodiscard]] bool isOn(LinkOrdinal node, int level) const {
    if (node == 0) return false;
    const JointOrdinal joint = m_graph->tree().jointToParent(node);
    return m_graph->levels().ofJoint[joint] == level;
  }

  void addDifference(SparseRows<Value>& rows, LinkOrdinal node, int against, int level,
                     const Value& weight) const {
    if (isOn(node, level)) rows.add(node - 1, weight);
    if (isOn(against, level)) rows.add(against - 1, m_field->negated(weight));
  }

  /// The sum of the branches, each a difference of two unknowns: those shared by two neighbours cancel.
  void addHeld(SparseRows<Value>& rows, const HeldCircuit& circuit) const {
    std::map<int, int> factors;  // by node
    for (const CircuitTerm& term : circuit.terms) {
      const auto [edge, level, sense] = branch(term.joint);
      const int factor = term.coefficient * sense;
      if (isOn(edge.head, level)) factors[edge.head] += factor;
      if (isOn(edge.tail, level)) factors[edge.tail] -= factor;
    }
    for (const auto& [node, factor] : factors) {
      if (factor != 0) rows.add(node - 1, m_field->fromInteger(factor));
    }
    rows.endRow();
  }

  const Field* m_field;
  const TtGraph* m_graph;
  Elimination<Value> m_system;
};

}  // namespace geargraph

#include "core/theory/ttgraph/tt_solution.h"

#include "core/theory/ttgraph/level_system.h"
#include "core/theory/ttgraph/notation.h"
#include "core/theory/ttgraph/symbolic_system.h"
#include "core/theory/ttgraph/tt_system.h"

namespace geargraph {
namespace {

/// Solves the equations in this arithmetic, by circuits or where they are too long by levels, and gives the
/// system to `use`. False where `stop` was requested.
template <class Field, class Use>
bool withSystem(const Field& field, const TtGraph& graph, const SubstitutionPlan& plan,
                const std::stop_token& stop, const Use& use) {
  const TeethWeights<Field> weights{&field};
  if (plan.byLevels) {
    const auto system = LevelSystem<Field>::of(field, graph, plan, weights, stop);
    return system && use(*system);
  }
  const auto system = TtSystem<Field>::of(field, graph, plan, weights, {}, stop);
  return system && use(*system);
}

template <class Field>
std::optional<std::vector<typename Field::Value>> ratesIn(const Field& field, const TtGraph& graph,
                                                          const SubstitutionPlan& plan,
                                                          std::span<const typename Field::Value> inputRates,
                                                          const std::stop_token& stop) {
  std::optional<std::vector<typename Field::Value>> rates;
  withSystem(field, graph, plan, stop, [&](const auto& system) {
    rates = system.solve(inputRates).first;
    return true;
  });
  return rates;
}

/// An empty matrix of the plan's shape.
template <class Value>
RateMatrix<Value> shapeOf(const SubstitutionPlan& plan) {
  RateMatrix<Value> matrix{plan.outputs, plan.inputs, {}, true};
  matrix.entries.assign(plan.outputs.size(), std::vector<Value>(plan.inputs.size()));
  return matrix;
}

}  // namespace

std::optional<TtDetermination> ttDetermination(const TtGraph& graph, const SubstitutionPlan& plan,
                                               const std::stop_token& stop) {
  const ModularDoubleField field;
  // One draw of random input rates stands for all: a relation among them holds there by chance only.
  ResidueStream residues(field.prime(), 26);
  std::vector<ModularDouble> inputs(plan.inputs.size());
  for (ModularDouble& input : inputs) input = {1, residues.next()};
  TtDetermination result;
  const bool done = withSystem(field, graph, plan, stop, [&](const auto& system) {
    result = {system.openJoints(), !system.solve(inputs).second, system.surplusEquations()};
    return true;
  });
  return done ? std::optional(std::move(result)) : std::nullopt;
}

std::optional<std::vector<Rational>> ttRates(const TtGraph& graph, const SubstitutionPlan& plan,
                                             std::span<const Rational> inputRates,
                                             const std::stop_token& stop) {
  return ratesIn(RationalField(), graph, plan, inputRates, stop);
}

std::optional<std::vector<ModularDouble>> ttRates(const ModularDoubleField& field, const TtGraph& graph,
                                                  const SubstitutionPlan& plan,
                                                  std::span<const ModularDouble> inputRates,
                                                  const std::stop_token& stop) {
  return ratesIn(field, graph, plan, inputRates, stop);
}

std::optional<RateMatrix<Rational>> ttSolution(const TtGraph& graph, const SubstitutionPlan& plan,
                                               const std::stop_token& stop) {
  auto matrix = shapeOf<Rational>(plan);
  std::vector<Rational> unit(plan.inputs.size());
  const bool done = withSystem(RationalField(), graph, plan, stop, [&](const auto& system) {
    matrix.determined = system.openJoints().empty();
    for (std::size_t input = 0; input < plan.inputs.size(); ++input) {
      if (stop.stop_requested()) return false;
      unit[input] = 1;
      auto [rates, holds] = system.solve(unit);
      unit[input] = 0;
      matrix.determined = matrix.determined && holds;
      for (std::size_t output = 0; output < plan.outputs.size(); ++output) {
        matrix.entries[output][input] = std::move(rates[plan.outputs[output]]);
      }
    }
    return true;
  });
  return done ? std::optional(std::move(matrix)) : std::nullopt;
}

std::optional<RateMatrix<std::optional<RationalFunction>>> ttSymbolicSolution(const RatioRingPtr& ring,
                                                                              const TtGraph& graph,
                                                                              const SubstitutionPlan& plan,
                                                                              const std::stop_token& stop,
                                                                              ExpansionBudget budget) {
  if (plan.byLevels) return shapeOf<std::optional<RationalFunction>>(plan);
  const auto symbolic = symbolicSystem(ring, graph, plan, stop);
  if (!symbolic) return std::nullopt;
  const RationalFunctionField& field = *symbolic->field;
  auto matrix = shapeOf<std::optional<RationalFunction>>(plan);
  for (std::size_t input = 0; input < plan.inputs.size(); ++input) {
    std::vector<std::optional<RationalFunction>> x(plan.jointAt.size(), RationalFunction());
    x[static_cast<std::size_t>(plan.firstInputColumn()) + input] = field.one();
    const std::vector<char>& vanishing = symbolic->vanishing[input];
    if (!expand(field, symbolic->system.direct(), vanishing, x, budget, stop) ||
        !expand(field, symbolic->system.rest(), vanishing, x, budget, stop)) {
      return std::nullopt;
    }
    for (std::size_t output = 0; output < plan.outputs.size(); ++output) {
      const auto column = static_cast<std::size_t>(plan.columnOf[plan.outputs[output]]);
      const bool coupled = static_cast<int>(column) < plan.coupledUnknowns;
      if (symbolic->withoutCoupled && coupled && vanishing[column] == 0) continue;
      matrix.entries[output][input] = std::move(x[column]);
    }
  }
  return matrix;
}

RatioRingPtr ttRatioRing(const TtGraph& graph, RatioNaming naming) {
  std::vector<std::string> names;
  std::vector<RatioRing::Teeth> teeth;
  for (const RatioNames& name : ratioNames(graph.graph())) {
    names.push_back(naming == RatioNaming::matroid ? name.matroid : name.ttGraph);
  }
  for (MeshOrdinal mesh = 0; mesh < graph.graph().c(); ++mesh) {
    teeth.push_back({graph.terminal(mesh)->tailTeeth, graph.terminal(mesh)->headTeeth});
  }
  return std::make_shared<const RatioRing>(std::move(names), std::move(teeth));
}

}  // namespace geargraph

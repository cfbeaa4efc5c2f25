#include "core/ttgraph/tt_solution.h"

#include "core/ttgraph/notation.h"
#include "core/ttgraph/symbolic_system.h"
#include "core/ttgraph/tt_system.h"

namespace geargraph {
namespace {

using FusedSystem = TtSystem<FusedField>;

std::optional<FusedSystem> fusedSystem(const FusedField& field, const TtGraph& graph,
                                       const SubstitutionPlan& plan, const std::stop_token& stop) {
  return FusedSystem::of(field, graph, plan, TeethWeights<FusedField>{&field}, {}, stop);
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
  const FusedField field;
  const auto system = fusedSystem(field, graph, plan, stop);
  if (!system) return std::nullopt;
  TtDetermination result{system->openJoints(), false, system->surplusMeshes()};
  // One draw of random input rates stands for all: a relation among them holds there by chance only.
  ResidueStream residues(field.prime(), 26);
  std::vector<Fused> inputs(plan.inputs.size());
  for (Fused& input : inputs) input = {1, residues.next()};
  result.contradictory = !system->holds(system->rates(inputs));
  return result;
}

std::optional<std::vector<Rational>> ttRates(const TtGraph& graph, const SubstitutionPlan& plan,
                                             std::span<const Rational> inputRates,
                                             const std::stop_token& stop) {
  const RationalField field;
  const auto system =
      TtSystem<RationalField>::of(field, graph, plan, TeethWeights<RationalField>{&field}, {}, stop);
  if (!system) return std::nullopt;
  return system->rates(inputRates);
}

std::optional<std::vector<Fused>> ttRates(const FusedField& field, const TtGraph& graph,
                                          const SubstitutionPlan& plan, std::span<const Fused> inputRates,
                                          const std::stop_token& stop) {
  const auto system = fusedSystem(field, graph, plan, stop);
  if (!system) return std::nullopt;
  return system->rates(inputRates);
}

std::optional<RateMatrix<Rational>> ttSolution(const TtGraph& graph, const SubstitutionPlan& plan,
                                               const std::stop_token& stop) {
  const RationalField field;
  const auto system =
      TtSystem<RationalField>::of(field, graph, plan, TeethWeights<RationalField>{&field}, {}, stop);
  if (!system) return std::nullopt;
  auto matrix = shapeOf<Rational>(plan);
  matrix.determined = system->openJoints().empty();
  std::vector<Rational> unit(plan.inputs.size());
  for (std::size_t input = 0; input < plan.inputs.size(); ++input) {
    if (stop.stop_requested()) return std::nullopt;
    unit[input] = 1;
    std::vector<Rational> rates = system->rates(unit);
    unit[input] = 0;
    matrix.determined = matrix.determined && system->holds(rates);
    for (std::size_t output = 0; output < plan.outputs.size(); ++output) {
      matrix.entries[output][input] = std::move(rates[static_cast<std::size_t>(plan.outputs[output])]);
    }
  }
  return matrix;
}

std::optional<RateMatrix<std::optional<RationalFunction>>> ttSymbolicSolution(const RatioRingPtr& ring,
                                                                              const TtGraph& graph,
                                                                              const SubstitutionPlan& plan,
                                                                              const std::stop_token& stop,
                                                                              int budget) {
  const auto symbolic = symbolicSystem(ring, graph, plan, stop);
  if (!symbolic) return std::nullopt;
  const RationalFunctionField& field = *symbolic->field;
  auto matrix = shapeOf<std::optional<RationalFunction>>(plan);
  for (std::size_t input = 0; input < plan.inputs.size(); ++input) {
    std::vector<std::optional<RationalFunction>> x(plan.jointAt.size(), field.fromInteger(0));
    x[static_cast<std::size_t>(plan.firstInputColumn()) + input] = field.one();
    const std::vector<char>& vanishing = symbolic->vanishing[input];
    if (!expand(field, symbolic->system.direct(), vanishing, x, stop, budget) ||
        !expand(field, symbolic->system.rest(), vanishing, x, stop, budget)) {
      return std::nullopt;
    }
    for (std::size_t output = 0; output < plan.outputs.size(); ++output) {
      const auto column =
          static_cast<std::size_t>(plan.columnOf[static_cast<std::size_t>(plan.outputs[output])]);
      const bool coupled = static_cast<int>(column) < plan.coupledUnknowns;
      if (symbolic->withoutCoupled && coupled && vanishing[column] == 0) continue;
      matrix.entries[output][input] = std::move(x[column]);
    }
  }
  return matrix;
}

RatioRingPtr ttRatioRing(const TtGraph& graph, RatioNaming naming) {
  std::vector<std::string> names;
  std::vector<Rational> values;
  for (const RatioNames& name : ratioNames(graph.graph())) {
    names.push_back(naming == RatioNaming::matroid ? name.matroid : name.ttGraph);
  }
  for (int mesh = 0; mesh < graph.graph().c(); ++mesh) {
    values.emplace_back(graph.terminal(mesh)->tailTeeth, graph.terminal(mesh)->headTeeth);
  }
  return std::make_shared<const RatioRing>(std::move(names), std::move(values));
}

}  // namespace geargraph

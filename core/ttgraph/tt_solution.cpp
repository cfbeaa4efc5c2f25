#include "core/ttgraph/tt_solution.h"

#include <random>

#include "core/ttgraph/notation.h"
#include "core/ttgraph/ratio_weights.h"
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
  RateMatrix<Value> matrix{plan.outputs, plan.inputs, {}};
  matrix.entries.assign(plan.outputs.size(), std::vector<Value>(plan.inputs.size()));
  return matrix;
}

/// Ratios drawn at random, apart for the double and for the residue: what vanishes there vanishes
/// identically.
struct RandomRatioWeights {
  const FusedField* field;
  std::vector<Fused> ratios;  ///< by mesh

  RandomRatioWeights(const FusedField& fused, int meshes) : field(&fused) {
    std::mt19937_64 random(20141001);
    ResidueStream residues(fused.prime(), 45);
    for (int mesh = 0; mesh < meshes; ++mesh) {
      ratios.push_back({0.5 + static_cast<double>(random() % 1'000'003) / 1e6, residues.next()});
    }
  }
  [[nodiscard]] std::pair<Fused, Fused> operator()(const TerminalPair& pair) const {
    return {ratios[static_cast<std::size_t>(pair.mesh)], field->fromInteger(-pair.sign)};
  }
};

/// By mesh: 1 where the mesh is surplus.
std::vector<char> marked(const std::vector<int>& meshes, int count) {
  std::vector<char> marks(static_cast<std::size_t>(count), 0);
  for (const int mesh : meshes) marks[static_cast<std::size_t>(mesh)] = 1;
  return marks;
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
  std::vector<Rational> unit(plan.inputs.size());
  for (std::size_t input = 0; input < plan.inputs.size(); ++input) {
    if (stop.stop_requested()) return std::nullopt;
    unit[input] = 1;
    std::vector<Rational> rates = system->rates(unit);
    unit[input] = 0;
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
  // 1. Which meshes are redundant at the ratios' own values: they are left out.
  // 2. Which rates vanish identically: they are not computed.
  // 3. The same substitutions with functions, expanded line by line.
  const FusedField fused;
  const auto numeric = fusedSystem(fused, graph, plan, stop);
  if (!numeric) return std::nullopt;
  const std::vector<char> redundant = marked(numeric->surplusMeshes(), graph.graph().c());
  const auto generic =
      FusedSystem::of(fused, graph, plan, RandomRatioWeights(fused, graph.graph().c()), redundant, stop);
  const RationalFunctionField field(ring);
  const auto system =
      TtSystem<RationalFunctionField>::of(field, graph, plan, RatioWeights{&field}, redundant, stop);
  if (!generic || !system) return std::nullopt;

  auto matrix = shapeOf<std::optional<RationalFunction>>(plan);
  for (std::size_t input = 0; input < plan.inputs.size(); ++input) {
    std::vector<Fused> sample(plan.inputs.size());
    sample[input] = fused.one();
    std::vector<char> vanishing;
    const std::vector<Fused> rates = generic->rates(sample);
    for (const int joint : plan.jointAt) {
      vanishing.push_back(fused.isZero(rates[static_cast<std::size_t>(joint)]) ? 1 : 0);
    }
    std::vector<std::optional<RationalFunction>> x(plan.jointAt.size(), field.fromInteger(0));
    x[static_cast<std::size_t>(plan.firstInputColumn()) + input] = field.one();
    if (!expand(field, system->direct(), vanishing, x, stop, budget) ||
        !expand(field, system->rest(), vanishing, x, stop, budget)) {
      return std::nullopt;
    }
    for (std::size_t output = 0; output < plan.outputs.size(); ++output) {
      const int column = plan.columnOf[static_cast<std::size_t>(plan.outputs[output])];
      matrix.entries[output][input] = std::move(x[static_cast<std::size_t>(column)]);
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

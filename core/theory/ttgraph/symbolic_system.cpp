#include "core/theory/ttgraph/symbolic_system.h"

#include <random>
#include <utility>

namespace geargraph {
namespace {

/// The factors of Eq. (26) in the ratio of the mesh, the variable of its number: i w_ik - s w_jk = 0.
struct RatioWeights {
  const RationalFunctionField* field;
  [[nodiscard]] std::pair<RationalFunction, RationalFunction> operator()(const TerminalPair& pair) const {
    return {RationalFunction::variable(field->ring(), pair.mesh), field->fromInteger(-pair.sign)};
  }
};

/// The same at ratios drawn at random, apart for the double and for the residue: what vanishes there vanishes
/// identically.
struct RandomRatioWeights {
  const ModularDoubleField* field;
  ByMesh<ModularDouble> ratios;

  RandomRatioWeights(const ModularDoubleField& fused, int meshes) : field(&fused) {
    std::mt19937_64 random(20141001);
    ResidueStream residues(fused.prime(), 45);
    for (MeshOrdinal mesh = 0; mesh < meshes; ++mesh) {
      ratios.push_back({0.5 + static_cast<double>(random() % 1'000'003) / 1e6, residues.next()});
    }
  }
  [[nodiscard]] std::pair<ModularDouble, ModularDouble> operator()(const TerminalPair& pair) const {
    return {ratios[pair.mesh], field->fromInteger(-pair.sign)};
  }
};

/// By equation: 1 where it is redundant. None where `stop` was requested.
std::optional<std::vector<char>> redundantEquations(const ModularDoubleField& field, const TtGraph& graph,
                                                    const SubstitutionPlan& plan,
                                                    const std::stop_token& stop) {
  const auto system = TtSystem<ModularDoubleField>::of(field, graph, plan,
                                                       TeethWeights<ModularDoubleField>{&field}, {}, stop);
  if (!system) return std::nullopt;
  std::vector<char> redundant(static_cast<std::size_t>(graph.equations()), 0);
  for (const int equation : system->surplusEquations()) redundant[static_cast<std::size_t>(equation)] = 1;
  return redundant;
}

std::optional<std::vector<std::vector<char>>> vanishingRates(const ModularDoubleField& field,
                                                             const TtGraph& graph,
                                                             const SubstitutionPlan& plan,
                                                             const LeftOut& redundant,
                                                             const std::stop_token& stop) {
  const RandomRatioWeights weights(field, graph.graph().c());
  const auto system = TtSystem<ModularDoubleField>::of(field, graph, plan, weights, redundant, stop);
  if (!system) return std::nullopt;
  std::vector<std::vector<char>> vanishing;
  std::vector<ModularDouble> sample(plan.inputs.size());
  for (ModularDouble& input : sample) {
    if (stop.stop_requested()) return std::nullopt;
    input = field.one();
    const ByJoint<ModularDouble> rates = system->rates(sample);
    input = {};
    std::vector<char>& zeros = vanishing.emplace_back();
    for (const JointOrdinal joint : plan.jointAt) {
      zeros.push_back(field.isZero(rates[joint]) ? 1 : 0);
    }
  }
  return vanishing;
}

/// By column: 1 where the rate vanishes with every input.
std::vector<char> alwaysVanishing(const std::vector<std::vector<char>>& vanishing, std::size_t columns) {
  std::vector<char> always(columns, 1);
  for (const std::vector<char>& zeros : vanishing) {
    for (std::size_t column = 0; column < columns; ++column) always[column] &= zeros[column];
  }
  return always;
}

}  // namespace

std::optional<SymbolicSystem> symbolicSystem(const RatioRingPtr& ring, const TtGraph& graph,
                                             const SubstitutionPlan& plan, const std::stop_token& stop) {
  constexpr int kMaxTermsOfTheCore = 600;
  const ModularDoubleField fused;
  auto redundant = redundantEquations(fused, graph, plan, stop);
  if (!redundant) return std::nullopt;
  LeftOut left{std::move(*redundant), {}};
  auto vanishing = vanishingRates(fused, graph, plan, left, stop);
  if (!vanishing) return std::nullopt;
  left.columns = alwaysVanishing(*vanishing, plan.jointAt.size());

  std::stop_source enough;  // the caller's request, or the core's size
  const std::stop_callback forward(stop, [&] { enough.request_stop(); });
  auto field = std::make_unique<const RationalFunctionField>(ring);
  const RationalFunctionField bounded(ring, kMaxTermsOfTheCore, enough);
  const RatioWeights weights{field.get()};
  auto system = TtSystem<RationalFunctionField>::of(bounded, graph, plan, weights, left, enough.get_token());
  if (stop.stop_requested()) return std::nullopt;
  const bool withoutCoupled = !system;
  if (withoutCoupled) {
    for (const int equation : plan.coupledEquations) left.equations[static_cast<std::size_t>(equation)] = 1;
    system = TtSystem<RationalFunctionField>::of(*field, graph, plan, weights, left);
  }
  system->setField(*field);
  return SymbolicSystem{std::move(field), std::move(*vanishing), std::move(*system), withoutCoupled};
}

}  // namespace geargraph

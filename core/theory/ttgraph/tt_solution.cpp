#include "core/theory/ttgraph/tt_solution.h"

#include <algorithm>

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

/// The powers of pi in which the velocities of the branches are counted, so that every equation is one
/// between fractions: along a circuit they are the same, and a terminal equation with pi raises them. Empty
/// where none has pi.
ByJoint<int> powersOfPi(const TtGraph& graph) {
  const int meshes = graph.graph().c();
  bool hasPi = false;
  for (MeshOrdinal mesh = 0; mesh < meshes; ++mesh) hasPi = hasPi || graph.terminal(mesh)->pi != 0;
  if (!hasPi) return {};
  struct Entry {
    JointOrdinal joint = 0;
    int raised = 0;
  };
  std::vector<std::vector<Entry>> equations(static_cast<std::size_t>(graph.equations()));
  ByJoint<std::vector<int>> equationsOf(static_cast<std::size_t>(graph.graph().t()));
  const auto enter = [&](int equation, std::span<const CircuitTerm> circuit, int raised) {
    for (const CircuitTerm& term : circuit) {
      equations[static_cast<std::size_t>(equation)].push_back({term.joint, raised});
      equationsOf[term.joint].push_back(equation);
    }
  };
  for (MeshOrdinal mesh = 0; mesh < meshes; ++mesh) {
    enter(mesh, graph.tailCircuit(mesh), graph.terminal(mesh)->pi);
    enter(mesh, graph.headCircuit(mesh), 0);
  }
  for (int equation = meshes; equation < graph.equations(); ++equation)
    enter(equation, graph.heldCircuit(equation).terms, 0);

  ByJoint<int> powers(equationsOf.size(), 0);
  ByJoint<char> known(equationsOf.size(), 0);
  std::vector<JointOrdinal> queue;
  for (JointOrdinal seed = 0; seed < graph.graph().t(); ++seed) {
    if (known[seed] != 0) continue;
    known[seed] = 1;
    queue.assign(1, seed);
    while (!queue.empty()) {
      const JointOrdinal from = queue.back();
      queue.pop_back();
      for (const int equation : equationsOf[from]) {
        const std::vector<Entry>& entries = equations[static_cast<std::size_t>(equation)];
        const auto own = std::find_if(entries.begin(), entries.end(),
                                      [&](const Entry& entry) { return entry.joint == from; });
        for (const Entry& entry : entries) {
          if (known[entry.joint] != 0) continue;
          known[entry.joint] = 1;
          powers[entry.joint] = powers[from] - own->raised + entry.raised;
          queue.push_back(entry.joint);
        }
      }
    }
  }
  return powers;
}

/// The matrix in fractions, each entry as `entryOf(rate, joint, input)` makes it.
template <class Value, class EntryOf>
std::optional<RateMatrix<Value>> matrixOf(const TtGraph& graph, const SubstitutionPlan& plan,
                                          const std::stop_token& stop, const EntryOf& entryOf) {
  auto matrix = shapeOf<Value>(plan);
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
        const JointOrdinal joint = plan.outputs[output];
        matrix.entries[output][input] = entryOf(std::move(rates[joint]), joint, plan.inputs[input]);
      }
    }
    return true;
  });
  return done ? std::optional(std::move(matrix)) : std::nullopt;
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
  return matrixOf<Rational>(graph, plan, stop,
                            [](Rational rate, JointOrdinal /*of*/, JointOrdinal /*input*/) { return rate; });
}

std::optional<RateMatrix<PiNumber>> ttPiSolution(const TtGraph& graph, const SubstitutionPlan& plan,
                                                 const std::stop_token& stop) {
  const ByJoint<int> powers = powersOfPi(graph);
  return matrixOf<PiNumber>(graph, plan, stop,
                            [&](const Rational& rate, JointOrdinal of, JointOrdinal input) {
                              return PiNumber(rate, powers.empty() ? 0 : powers[of] - powers[input]);
                            });
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

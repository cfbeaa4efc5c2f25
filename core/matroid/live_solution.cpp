#include "core/matroid/live_solution.h"

namespace geargraph {
namespace {

Elimination<Fused> eliminated(const KinematicModel& model, const FusedField& field,
                              std::span<const int> inputs, const std::stop_token& stop, bool& stopped) {
  auto system = eliminate(field, inputRows(model, field, allMeshes(model), inputs, model.teeth(field)),
                          model.n(), model.n() + static_cast<int>(inputs.size()), stop);
  stopped = !system.has_value();
  return stopped ? Elimination<Fused>() : std::move(*system);
}

/// Do the inputs determine every link, and is no relation forced among them? `x` becomes a motion at random.
bool isDetermined(const FusedField& field, const Elimination<Fused>& system, std::vector<Fused>& x) {
  if (!system.freeColumns.empty()) return false;
  ResidueStream random(field.prime(), 0x696e70757473U);
  for (int column = system.unknowns; column < system.columns; ++column) x[column] = {0, random.next()};
  substitute(field, system, x);
  for (const auto& check : system.checks) {
    if (!field.isZero(checkValue(field, system, check, x))) return false;
  }
  return true;
}

void fillMatrix(const KinematicModel& model, const FusedField& field, const Elimination<Fused>& system,
                LiveSolution& solution) {
  const std::size_t columns = solution.inputs.size();
  if (solution.outputs.size() * columns > LiveSolution::kMostLiveEntries) return;
  solution.matrix.resize(solution.outputs.size() * columns);
  std::vector<Fused> x(static_cast<std::size_t>(system.columns));
  for (std::size_t j = 0; j < columns; ++j) {
    Fused& given = x[static_cast<std::size_t>(system.unknowns) + j];
    given = field.one();
    substitute(field, system, x);
    given = {};
    for (std::size_t i = 0; i < solution.outputs.size(); ++i) {
      solution.matrix[i * columns + j] = model.rateOf(field, solution.outputs[i], x).number;
    }
  }
}

/// The rates for the given speeds; a speed stands beside its own residue, so that sums that cancel are exact
/// zeros.
void fillRates(const KinematicModel& model, const FusedField& field, const Elimination<Fused>& system,
               std::span<const Rational> speeds, LiveSolution& solution) {
  std::vector<Fused> x(static_cast<std::size_t>(system.columns));
  for (std::size_t i = 0; i < speeds.size(); ++i) {
    const auto residue = field.prime().fromRational(speeds[i]);
    // A speed whose denominator the prime divides: any residue but 0 keeps the double alive.
    x[static_cast<std::size_t>(system.unknowns) + i] = {speeds[i].toDouble(),
                                                        residue.value_or(field.prime().one())};
  }
  substitute(field, system, x);
  solution.rates.resize(static_cast<std::size_t>(model.t()));
  for (int joint = 0; joint < model.t(); ++joint)
    solution.rates[joint] = model.rateOf(field, joint, x).number;
}

}  // namespace

std::optional<LiveSolution> solveLive(const KinematicModel& model, const FusedField& field,
                                      std::span<const int> inputs, std::span<const Rational> speeds,
                                      const std::stop_token& stop) {
  GEARGRAPH_REQUIRE(inputs.size() == speeds.size());
  bool stopped = false;
  const Elimination<Fused> system = eliminated(model, field, inputs, stop, stopped);
  std::vector<Fused> x(static_cast<std::size_t>(model.n()) + inputs.size());
  if (stopped || !isDetermined(field, system, x)) return std::nullopt;
  if (!system.checks.empty()) {
    const FusedField second(PrimeField::kSecondSeed);
    const Elimination<Fused> confirming = eliminated(model, second, inputs, stop, stopped);
    std::vector<Fused> y(x.size());
    if (stopped || !isDetermined(second, confirming, y)) return std::nullopt;
  }
  LiveSolution solution;
  solution.inputs.assign(inputs.begin(), inputs.end());
  solution.outputs = outputsOf(model, inputs);
  solution.rank = model.n() - static_cast<int>(inputs.size());
  solution.redundant = static_cast<int>(system.checks.size());
  solution.dead.resize(static_cast<std::size_t>(model.t()));
  for (int joint = 0; joint < model.t(); ++joint) {
    solution.dead[joint] = model.rateOf(field, joint, x).residue == 0 ? 1 : 0;
  }
  fillRates(model, field, system, speeds, solution);
  if (stop.stop_requested()) return std::nullopt;
  fillMatrix(model, field, system, solution);
  return solution;
}

std::vector<int> allMeshes(const KinematicModel& model) {
  std::vector<int> meshes;
  for (int mesh = 0; mesh < model.c(); ++mesh) meshes.push_back(mesh);
  return meshes;
}

std::vector<int> outputsOf(const KinematicModel& model, std::span<const int> inputs) {
  std::vector<char> isInput(static_cast<std::size_t>(model.t()), 0);
  for (const int joint : inputs) isInput[joint] = 1;
  std::vector<int> outputs;
  for (int joint = 0; joint < model.t(); ++joint) {
    if (isInput[joint] == 0) outputs.push_back(joint);
  }
  return outputs;
}

std::vector<Vector3> linkVelocities(const KinematicModel& model, const Placement& placement,
                                    std::span<const double> rates) {
  std::vector<Vector3> velocities(static_cast<std::size_t>(model.n()) + 1, Vector3{0, 0, 0});
  for (const int node : model.tree().preorder()) {
    if (node == 0) continue;
    const int joint = model.tree().jointToParent(node);
    const double speed = -model.tree().directionToGround(joint) * rates[static_cast<std::size_t>(joint)];
    const Vector3& direction = placement.axes[placement.tree->axisOf[joint]].direction;
    velocities[node] = velocities[model.tree().parent(node)] + speed * direction;
  }
  return velocities;
}

std::vector<Vector3> meshVelocities(const KinematicModel& model, const std::vector<Vector3>& links) {
  std::vector<Vector3> velocities;
  velocities.reserve(static_cast<std::size_t>(model.c()));
  for (const DigraphEdge& edge : model.graph().meshEdges())
    velocities.push_back(links[edge.head] - links[edge.tail]);
  return velocities;
}

}  // namespace geargraph

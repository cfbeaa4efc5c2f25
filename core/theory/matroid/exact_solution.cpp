#include "core/theory/matroid/exact_solution.h"

namespace geargraph {

std::optional<ExactSolution> solveExact(const KinematicModel& model, std::span<const int> inputs,
                                        std::span<const Rational> speeds, const std::stop_token& stop) {
  GEARGRAPH_REQUIRE(inputs.size() == speeds.size());
  if (model.hasPi()) return std::nullopt;
  const RationalField field;
  const auto system = eliminate(field, inputRows(model, field, allEquations(model), inputs), model.n(),
                                model.n() + static_cast<int>(inputs.size()), stop);
  if (!system) return std::nullopt;
  GEARGRAPH_REQUIRE(system->freeColumns.empty());

  ExactSolution solution;
  solution.inputs.assign(inputs.begin(), inputs.end());
  solution.outputs = outputsOf(model, inputs);
  std::vector<Rational> x(static_cast<std::size_t>(system->columns));
  for (std::size_t i = 0; i < speeds.size(); ++i) x[static_cast<std::size_t>(model.n()) + i] = speeds[i];
  substitute(field, *system, x);
  for (JointOrdinal joint = 0; joint < model.t(); ++joint)
    solution.rates.push_back(model.rateOf(field, joint, x));

  const std::size_t columns = inputs.size();
  if (solution.outputs.size() * columns > ExactSolution::kMaxExactEntries) return solution;
  solution.matrix.resize(solution.outputs.size() * columns);
  std::fill(x.begin(), x.end(), Rational(0));
  for (std::size_t j = 0; j < columns; ++j) {
    if (stop.stop_requested()) return std::nullopt;
    Rational& given = x[static_cast<std::size_t>(model.n()) + j];
    given = 1;
    substitute(field, *system, x);
    given = 0;
    for (std::size_t i = 0; i < solution.outputs.size(); ++i) {
      solution.matrix[i * columns + j] = model.rateOf(field, solution.outputs[i], x);
    }
  }
  return solution;
}

std::optional<PiSolution> solvePi(const KinematicModel& model, std::span<const int> inputs,
                                  std::span<const Rational> speeds, const std::stop_token& stop) {
  GEARGRAPH_REQUIRE(inputs.size() == speeds.size() && !model.mixedEquation());
  const RationalField field;
  const auto system = eliminate(field, inputRows(model, field, allEquations(model), inputs), model.n(),
                                model.n() + static_cast<int>(inputs.size()), stop);
  if (!system) return std::nullopt;
  GEARGRAPH_REQUIRE(system->freeColumns.empty());
  PiSolution solution;
  solution.inputs.assign(inputs.begin(), inputs.end());
  solution.outputs = outputsOf(model, inputs);
  solution.rates.resize(static_cast<std::size_t>(model.t()));
  const std::size_t columns = inputs.size();
  const bool hasMatrix = solution.outputs.size() * columns <= ExactSolution::kMaxExactEntries;
  if (hasMatrix) solution.matrix.resize(solution.outputs.size() * columns);
  std::vector<Rational> x(static_cast<std::size_t>(system->columns));
  for (std::size_t j = 0; j < columns; ++j) {
    if (stop.stop_requested()) return std::nullopt;
    Rational& given = x[static_cast<std::size_t>(model.n()) + j];
    given = 1;
    substitute(field, *system, x);
    given = 0;
    const auto rateOf = [&](JointOrdinal joint) {  // with this input at 1
      return PiNumber(model.rateOf(field, joint, x), model.piOf(joint) - model.piOf(inputs[j]));
    };
    for (std::size_t i = 0; hasMatrix && i < solution.outputs.size(); ++i)
      solution.matrix[i * columns + j] = rateOf(solution.outputs[i]);
    for (JointOrdinal joint = 0; joint < model.t(); ++joint)
      solution.rates[joint] += rateOf(joint) * PiNumber(speeds[j]);
  }
  return solution;
}

}  // namespace geargraph

#include "core/theory/matroid/live_solution.h"

#include <algorithm>
#include <memory_resource>
#include <numeric>

#include "core/foundations/base/scratch.h"

namespace geargraph {
namespace {

using System = Elimination<ModularDouble>;

std::optional<System> eliminated(const KinematicModel& model, const ModularDoubleField& field,
                                 std::span<const int> inputs, const std::stop_token& stop,
                                 std::pmr::memory_resource& memory) {
  std::pmr::vector<int> equations(static_cast<std::size_t>(model.equations()), &memory);
  std::iota(equations.begin(), equations.end(), 0);
  return eliminate(field, inputRows(model, field, equations, inputs, &memory), model.n(),
                   model.n() + static_cast<int>(inputs.size()), stop);
}

bool checksHold(const ModularDoubleField& field, const System& system, std::span<const ModularDouble> x,
                std::size_t width) {
  for (const auto& check : system.checks) {
    for (std::size_t k = 0; k < width; ++k) {
      if (!field.isZero(checkValue(field, system, check, x, width, k))) return false;
    }
  }
  return true;
}

/// Do the inputs determine every link, and is no relation forced among them? `x` becomes a motion at random.
bool isDetermined(const ModularDoubleField& field, const System& system, std::span<ModularDouble> x) {
  if (!system.freeColumns.empty()) return false;
  ResidueStream random(field.prime(), 0x696e70757473U);
  for (int column = system.unknowns; column < system.columns; ++column) x[column] = {0, random.next()};
  substitute(field, system, x);
  return checksHold(field, system, x, 1);
}

/// Fills in a solution from an eliminated system.
class Solver {
 public:
  Solver(const KinematicModel& model, const ModularDoubleField& field, const System& system,
         std::span<const Rational> speeds, LiveSolution& solution)
      : m_model(model),
        m_field(field),
        m_system(system),
        m_minusSpeeds(system.memory()),
        m_solution(solution),
        m_x(system.memory()),
        m_rates(system.memory()) {
    // Speeds beside their own residues, so that sums that cancel are exact zeros.
    m_minusSpeeds.reserve(speeds.size());
    for (const Rational& speed : speeds) {
      const auto residue = field.prime().fromRational(speed);
      // A speed whose denominator the prime divides: any residue but 0 keeps the double alive.
      m_minusSpeeds.push_back(field.negated({speed.toDouble(), residue.value_or(field.prime().one())}));
    }
    m_solution.dead.assign(static_cast<std::size_t>(model.t()), 1);
  }

  /// One motion for every input, all others at rest, a few at a time: the columns of the matrix. What stands
  /// still in all of them is dead; the rates are their sum, weighted with the speeds. False where a relation
  /// among the inputs is forced, or `stop` was requested.
  bool byColumns(const std::stop_token& stop) {
    const std::size_t inputs = m_solution.inputs.size();
    m_solution.matrix.resize(m_solution.outputs.size() * inputs);
    m_rates.assign(static_cast<std::size_t>(m_model.t()), ModularDouble());
    for (std::size_t first = 0; first < inputs; first += kMaxSideBySide) {
      if (stop.stop_requested()) return false;
      if (!takeColumns(first, std::min(kMaxSideBySide, inputs - first))) return false;
    }
    m_solution.rates.resize(m_rates.size());
    for (std::size_t joint = 0; joint < m_rates.size(); ++joint)
      m_solution.rates[joint] = m_rates[joint].number;
    return true;
  }

  /// Too large for a matrix: a motion at random, which shows what is dead, beside the one at the given
  /// speeds.
  bool byMotions() {
    m_x.resize(static_cast<std::size_t>(m_system.columns));
    if (!isDetermined(m_field, m_system, m_x)) return false;
    for (JointOrdinal joint = 0; joint < m_model.t(); ++joint) {
      if (m_model.rateOf(m_field, joint, m_x).residue != 0) m_solution.dead[joint] = 0;
    }
    for (std::size_t i = 0; i < m_minusSpeeds.size(); ++i)
      m_x[static_cast<std::size_t>(m_system.unknowns) + i] = m_field.negated(m_minusSpeeds[i]);
    substitute(m_field, m_system, m_x);
    m_solution.rates.resize(static_cast<std::size_t>(m_model.t()));
    for (JointOrdinal joint = 0; joint < m_model.t(); ++joint) {
      m_solution.rates[joint] = m_model.rateOf(m_field, joint, m_x).number;
    }
    return true;
  }

 private:
  bool takeColumns(std::size_t first, std::size_t width) {
    m_x.assign(static_cast<std::size_t>(m_system.columns) * width, ModularDouble());
    for (std::size_t k = 0; k < width; ++k) {
      m_x[(static_cast<std::size_t>(m_system.unknowns) + first + k) * width + k] = m_field.one();
    }
    substitute(m_field, m_system, m_x, width);
    if (!checksHold(m_field, m_system, m_x, width)) return false;
    std::size_t row = 0;
    for (JointOrdinal joint = 0; joint < m_model.t(); ++joint) {
      const bool isOutput = row < m_solution.outputs.size() && m_solution.outputs[row] == joint;
      for (std::size_t k = 0; k < width; ++k) {
        const ModularDouble rate = m_model.rateOf(m_field, joint, m_x, width, k);
        if (rate.residue != 0) {
          m_solution.dead[joint] = 0;
          m_field.subtractProduct(m_rates[static_cast<std::size_t>(joint)], m_minusSpeeds[first + k], rate);
        }
        if (isOutput) m_solution.matrix[row * m_solution.inputs.size() + first + k] = rate.number;
      }
      if (isOutput) ++row;
    }
    return true;
  }

  const KinematicModel& m_model;
  const ModularDoubleField& m_field;
  const System& m_system;
  std::pmr::vector<ModularDouble> m_minusSpeeds;
  LiveSolution& m_solution;
  std::pmr::vector<ModularDouble> m_x;
  std::pmr::vector<ModularDouble> m_rates;  ///< by joint: the sum so far
};

}  // namespace

std::optional<LiveSolution> solveLive(const KinematicModel& model, const ModularDoubleField& field,
                                      std::span<const int> inputs, std::span<const Rational> speeds,
                                      const std::stop_token& stop) {
  GEARGRAPH_REQUIRE(inputs.size() == speeds.size());
  Scratch<8192> scratch;
  const std::optional<System> system = eliminated(model, field, inputs, stop, scratch);
  if (!system || !system->freeColumns.empty()) return std::nullopt;
  LiveSolution solution;
  solution.inputs.assign(inputs.begin(), inputs.end());
  solution.outputs = outputsOf(model, inputs);
  solution.rank = model.n() - static_cast<int>(inputs.size());
  solution.redundant = static_cast<int>(system->checks.size());
  Solver solver(model, field, *system, speeds, solution);
  const bool small = solution.outputs.size() * inputs.size() <= LiveSolution::kMaxLiveEntries;
  if (!(small ? solver.byColumns(stop) : solver.byMotions())) return std::nullopt;
  if (!system->checks.empty()) {
    const ModularDoubleField second(PrimeField::kSecondSeed);
    const std::optional<System> confirming = eliminated(model, second, inputs, stop, scratch);
    std::vector<ModularDouble> x(static_cast<std::size_t>(model.n()) + inputs.size());
    if (!confirming || !isDetermined(second, *confirming, x)) return std::nullopt;
  }
  if (stop.stop_requested()) return std::nullopt;
  return solution;
}

std::vector<int> allEquations(const KinematicModel& model) {
  std::vector<int> equations(static_cast<std::size_t>(model.equations()));
  std::iota(equations.begin(), equations.end(), 0);
  return equations;
}

std::vector<int> outputsOf(const KinematicModel& model, std::span<const int> inputs) {
  Scratch<1024> scratch;
  std::pmr::vector<char> isInput(static_cast<std::size_t>(model.t()), 0, &scratch);
  for (const JointOrdinal joint : inputs) isInput[static_cast<std::size_t>(joint)] = 1;
  std::vector<int> outputs;
  outputs.reserve(isInput.size() - std::min(isInput.size(), inputs.size()));
  for (JointOrdinal joint = 0; joint < model.t(); ++joint) {
    if (isInput[static_cast<std::size_t>(joint)] == 0) outputs.push_back(joint);
  }
  return outputs;
}

std::vector<Vector3> linkVelocities(const KinematicModel& model, const Placement& placement,
                                    std::span<const double> rates) {
  std::vector<Vector3> velocities(static_cast<std::size_t>(model.n()) + 1, Vector3{0, 0, 0});
  for (const LinkOrdinal node : model.tree().preorder()) {
    if (node == 0) continue;
    const JointOrdinal joint = model.tree().jointToParent(node);
    if (placement.classes->classes[placement.classes->classOf[joint]].kind == JointKind::sliding) {
      velocities[node] = velocities[model.tree().parent(node)];
      continue;
    }
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

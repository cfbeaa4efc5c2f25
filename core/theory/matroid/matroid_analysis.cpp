#include "core/theory/matroid/matroid_analysis.h"

#include <algorithm>
#include <cmath>
#include <memory_resource>

#include "core/foundations/base/position_index.h"
#include "core/foundations/base/scratch.h"
#include "core/foundations/base/translation.h"
#include "core/theory/matroid/matroid_diagnostics.h"

namespace geargraph {
namespace {

/// The diagnostic where speeds or ratios are beyond what a double can hold: the numbers would be infinite.
std::optional<Diagnostic> overflowOf(const Mechanism& mechanism, const KinematicModel& model,
                                     const LiveSolution& solution, std::span<const Vector3> velocities) {
  const auto isFinite = [](double value) { return std::isfinite(value); };
  const auto beyond = [&](JointOrdinal joint, const char* sentence) {
    const ElementId id = model.graph().edgeId(joint);
    return Diagnostic{Code::schema,
                      filled(translated(sentence), {std::to_string(mechanism.jointLabel(joint))}),
                      {id},
                      {},
                      0,
                      0};
  };
  const auto ratio = std::find_if_not(solution.matrix.begin(), solution.matrix.end(), isFinite);
  if (ratio != solution.matrix.end()) {
    const auto row = static_cast<std::size_t>(ratio - solution.matrix.begin()) / solution.inputs.size();
    return beyond(
        solution.outputs[row],
        toTranslate("The ratio of an input to joint %1 is beyond the largest number that the analysis "
                    "can hold, 1.79e308. Tooth counts nearer to each other, or fewer meshes in a row, "
                    "give a ratio that it can."));
  }
  const auto rate = std::find_if_not(solution.rates.begin(), solution.rates.end(), isFinite);
  if (rate != solution.rates.end()) {
    return beyond(
        static_cast<int>(rate - solution.rates.begin()),
        toTranslate("The speed of joint %1 is beyond the largest number that the analysis can hold, "
                    "1.79e308. Lower the speeds of the inputs."));
  }
  for (std::size_t link = 1; link < velocities.size(); ++link) {
    if (std::all_of(velocities[link].begin(), velocities[link].end(), isFinite)) continue;
    return beyond(
        model.tree().jointToParent(static_cast<int>(link)),
        toTranslate("The speed of the link that turns about joint %1 is beyond the largest number that "
                    "the analysis can hold, 1.79e308. Lower the speeds of the inputs."));
  }
  return std::nullopt;
}

class Analyzer {
 public:
  Analyzer(const Mechanism& mechanism, const KinematicModel& model, const Placement& placement,
           const std::stop_token& stop)
      : m_mechanism(mechanism), m_model(model), m_placement(placement), m_stop(stop) {}

  std::optional<MatroidAnalysis> run() {
    takeInputs();
    if (!trySolving() && !chooseAndSolve()) return std::nullopt;
    if (!explain()) return std::nullopt;
    std::optional<Diagnostic> overflow;
    if (m_result.solution) {
      m_result.linkVelocities = linkVelocities(m_model, m_placement, m_result.solution->rates);
      overflow = overflowOf(m_mechanism, m_model, *m_result.solution, m_result.linkVelocities);
    }
    m_result.diagnostics = matroidDiagnostics(m_mechanism, m_model, m_placement, m_result, m_wanted, m_stop);
    if (overflow) {
      m_result.diagnostics.push_back(std::move(*overflow));
      m_result.solution.reset();  // of wrong numbers, none is shown
      m_result.linkVelocities.clear();
    }
    if (m_stop.stop_requested()) return std::nullopt;
    return std::move(m_result);
  }

 private:
  void takeInputs() {
    if (!m_mechanism.inputs) return;
    m_result.inputsGiven = true;
    const std::vector<Input>& inputs = *m_mechanism.inputs;
    constexpr std::size_t kFew = 8;  // found sooner by looking than by an index of all joints
    const bool few = inputs.size() <= kFew;
    const auto index = few ? PositionIndex<JointTag>() : PositionIndex<JointTag>(m_mechanism.turningJoints);
    m_wanted.reserve(inputs.size());
    m_speeds.reserve(inputs.size());
    for (const Input& input : inputs) {
      m_wanted.push_back(few ? jointOf(input.joint) : index.at(input.joint));
      m_speeds.push_back(input.speed.exact());
    }
  }

  /// In the digraph the ids stand closer together than in the document.
  [[nodiscard]] int jointOf(JointId id) const {
    JointOrdinal joint = 0;
    while (joint < m_model.t() && m_model.graph().edgeId(joint).id != id.atom()) ++joint;
    GEARGRAPH_REQUIRE(joint < m_model.t());
    return joint;
  }

  /// The usual case: the document's inputs are valid, and one elimination says everything.
  bool trySolving() {
    if (!m_result.inputsGiven) return false;
    m_result.solution = solveLive(m_model, m_field, m_wanted, m_speeds, m_stop);
    if (!m_result.solution) return false;
    m_result.rank = m_result.solution->rank;
    m_result.dead = std::move(m_result.solution->dead);
    m_result.idle = idleJoints(m_model);
    m_result.choice.joints = m_wanted;
    m_result.speeds = std::move(m_speeds);
    finishCounts();
    return true;
  }

  bool chooseAndSolve() {
    const auto structure = structureOf(m_model, m_field, m_stop);
    if (!structure) return false;
    m_result.rank = structure->rank;
    m_result.dead = structure->dead;
    m_result.idle = structure->idle;
    finishCounts();
    auto choice = chooseInputs(m_model, m_field, *structure, m_wanted, m_stop);
    if (!choice) return false;
    m_result.choice = std::move(*choice);
    for (const JointOrdinal joint : m_result.choice.joints) {
      const auto wanted = std::find(m_wanted.begin(), m_wanted.end(), joint);
      m_result.speeds.push_back(wanted == m_wanted.end()
                                    ? Rational(1)
                                    : m_speeds[static_cast<std::size_t>(wanted - m_wanted.begin())]);
    }
    if (m_result.inputsGiven && !areValidAsEngaged()) return true;
    m_result.solution = solveLive(m_model, m_field, m_result.choice.joints, m_result.speeds, m_stop);
    return m_result.solution.has_value();
  }

  /// Engaged couplings may take the choice from inputs that the train without them needs; none may be
  /// missing.
  [[nodiscard]] bool areValidAsEngaged() const {
    return !m_model.held().empty() && isValidAsEngaged(m_result.choice, m_wanted);
  }

  void finishCounts() {
    m_result.dof = m_model.t() - m_result.rank;
    m_result.kutzbachDof = m_model.n() - m_model.equations();
  }

  bool explain() {
    if (m_result.rank < m_model.equations()) {
      auto redundancies = redundanciesOf(m_model, m_field, m_stop);
      if (!redundancies) return false;
      m_result.redundancies = std::move(*redundancies);
    }
    Scratch<1024> scratch;
    std::pmr::vector<char> redundant(static_cast<std::size_t>(m_model.equations()), 0, &scratch);
    for (const Redundancy& redundancy : m_result.redundancies) redundant[redundancy.equation] = 1;
    m_result.independentMeshes.reserve(static_cast<std::size_t>(m_result.rank));
    for (MeshOrdinal mesh = 0; mesh < m_model.c(); ++mesh) {
      if (redundant[mesh] == 0) m_result.independentMeshes.push_back(mesh);
    }
    for (int equation = m_model.c(); equation < m_model.equations(); ++equation) {
      if (redundant[equation] == 0) m_result.independentHeld.push_back(equation);
    }
    if (std::find(m_result.dead.begin(), m_result.dead.end(), 1) == m_result.dead.end()) return true;
    auto loops = geargraph::lockedLoops(m_model, m_field, m_result.dead, m_stop);
    if (!loops) return false;
    m_result.lockedLoops = std::move(*loops);
    m_result.rigidBlocks = geargraph::rigidBlocks(m_model, m_result.dead);
    return true;
  }

  const Mechanism& m_mechanism;
  const KinematicModel& m_model;
  const Placement& m_placement;
  std::stop_token m_stop;
  ModularDoubleField m_field;
  std::vector<int> m_wanted;
  std::vector<Rational> m_speeds;
  MatroidAnalysis m_result;
};

}  // namespace

std::vector<int> MatroidAnalysis::independentEquations() const {
  std::vector<int> equations = independentMeshes;
  equations.insert(equations.end(), independentHeld.begin(), independentHeld.end());
  return equations;
}

std::optional<MatroidAnalysis> analyzeMatroid(const Mechanism& mechanism, const KinematicModel& model,
                                              const Placement& placement, const std::stop_token& stop) {
  return Analyzer(mechanism, model, placement, stop).run();
}

}  // namespace geargraph

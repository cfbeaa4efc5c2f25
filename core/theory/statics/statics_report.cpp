#include "core/theory/statics/statics_report.h"

#include <algorithm>

#include "core/foundations/base/position_index.h"
#include "core/foundations/base/translation.h"
#include "core/mechanism/model/slide_checks.h"
#include "core/theory/matroid/exact_solution.h"
#include "core/theory/states/engagement.h"
#include "core/theory/states/state_solution.h"
#include "core/theory/statics/problem_setup.h"
#include "core/theory/statics/statics_diagnostics.h"

namespace geargraph {
namespace {

/// The joints that are no balances, where every balance is one: what the transposed kinematics is about.
std::optional<std::pair<std::vector<int>, std::vector<int>>> jointsOf(const KinematicModel& model,
                                                                      const StaticsProblem& problem) {
  std::vector<int> balanced;
  for (const TorquePlace& place : problem.balances) {
    if (!place.inJoint()) return std::nullopt;
    balanced.push_back(place.joint);
  }
  return std::pair(balanced, outputsOf(model, balanced));
}

RadicalColumns opposite(const RadicalColumns& loads) {
  RadicalColumns reversed;
  for (const RadicalColumns::Column& column : loads.columns())
    for (const auto& [link, force] : column.entries) reversed.add(link, -force, column.square);
  return reversed;
}

class Analysis {
 public:
  Analysis(const Mechanism& mechanism, const KinematicModel& model, const Placement& placement,
           const TtGraph& ttGraph, const MatroidAnalysis& analysis, const StaticsOptions& options,
           const std::stop_token& stop)
      : m_mechanism(mechanism),
        m_model(model),
        m_placement(placement),
        m_ttGraph(ttGraph),
        m_analysis(analysis),
        m_options(options),
        m_stop(stop),
        m_matrix(mechanism, model, placement) {}

  std::optional<StaticsReport> run() {
    m_report.state = m_options.state;
    m_report.sharing = m_options.sharing ? m_options.sharing : m_mechanism.sharing;
    if (hasSlides(m_mechanism)) {
      add(slidesNotCovered(m_mechanism, translated("Torques and forces")));
      return std::move(m_report);
    }
    if (!takeMotion()) return std::nullopt;
    if (hasErrors(m_report.diagnostics)) return std::move(m_report);
    m_report.isSolved = true;
    setUpProblem(m_mechanism, m_model, m_placement, m_analysis, m_options, m_report);
    m_power = LoadPower::of(m_mechanism, m_model, m_placement, m_report.problem);
    if (m_options.losses) takeEfficiencies();
    if (!solve()) return std::nullopt;
    if (m_report.lossless.isBalanced() && !answer()) return std::nullopt;
    if (!solveTransposed()) return std::nullopt;
    if (m_stop.stop_requested()) return std::nullopt;
    return std::move(m_report);
  }

 private:
  [[nodiscard]] const ShiftState* state() const {
    return m_options.state < 0 ? nullptr : &m_mechanism.states[static_cast<std::size_t>(m_options.state)];
  }
  void add(Diagnostic diagnostic) { m_report.diagnostics.push_back(std::move(diagnostic)); }

  /// What follows once the loads are held. False where `stop` was requested.
  bool answer() {
    const std::size_t before = m_report.diagnostics.size();
    if (m_options.losses && !solveLosses()) return false;
    m_report.lacksLosses = lacksLosses();
    if (m_report.isShared && !takeAssumed()) return false;
    if (m_report.lossless.indeterminate() > 0)
      m_report.diagnostics.insert(m_report.diagnostics.begin() + static_cast<std::ptrdiff_t>(before),
                                  sharedLoads(m_mechanism, m_model, m_report));
    if (m_report.lacksLosses) {
      tellMissingLosses();
      return true;
    }
    takePowers();
    takeForces();
    takeSymbolicEfficiencies();
    return true;
  }

  /// False where `stop` was requested.
  bool takeMotion() {
    if (state() != nullptr) {
      auto solution = solveState(m_mechanism, m_model, m_placement, m_options.state, false, m_stop);
      if (!solution) return false;
      m_report.problem.engaged = solution->engaged;
      for (Diagnostic& diagnostic : solution->diagnostics) add(std::move(diagnostic));
      m_report.ratio = solution->ratio;
      if (solution->isSolved()) m_report.motion = std::move(solution->rates);
      m_report.idleMotion = std::move(solution->idleRates);
    } else if (m_report.problem.engaged = engagedCouplings(m_mechanism); m_analysis.solution) {
      auto solution = solveExact(m_model, m_analysis.choice.joints, m_analysis.speeds, m_stop);
      if (!solution) return false;
      m_report.motion = std::move(solution->rates);
    }
    if (!m_report.motion) add(noMotion(false));
    return true;
  }

  bool solve() {
    auto solution = solveStatics(m_model, m_report.held, m_power.byLink, {}, m_stop);
    if (!solution) return false;
    m_report.lossless = std::move(*solution);
    if (m_ttGraph.isComplete()) {
      const auto torques = ttTorques(m_ttGraph, chordsOf(m_report.held), m_power.byJoint, m_stop);
      if (!torques) return false;
      m_report.agreement = staticsAgreement(m_model, m_report.lossless, *torques);
    }
    if (!m_report.lossless.isBalanced()) {
      add(unbalancedLoads(m_mechanism, m_report));
      return true;
    }
    if (sharesByStiffness()) {
      if (!shareByStiffness(m_model, m_matrix, m_report.lossless, m_stop)) return false;
      m_report.isShared = m_report.lossless.isDeterminate();
    }
    if (m_report.motion && !m_report.idleMotion.empty() && !isIdle()) {
      m_report.motion.reset();
      for (LoadReport& load : m_report.loads) load.watts.reset();
      add(noMotion(false));
    }
    addDeadLoads();
    return true;
  }

  void addDeadLoads() {
    if (!m_model.held().empty()) return;  // a brake may carry the load, not the teeth
    for (const AppliedTorque& load : m_report.problem.torques) {
      if (!load.place.inJoint() || load.torque.isZero()) continue;
      if (m_analysis.dead[load.place.joint] == 0) continue;
      std::vector<int> meshes;
      for (const CutsetEquations::Term& term : cutsets().terms(load.place.joint))
        if (!m_report.lossless.values[static_cast<std::size_t>(term.mesh)].isZero() ||
            !m_report.lossless.isDetermined(term.mesh))
          meshes.push_back(term.mesh);
      add(deadLoad(m_mechanism, load.place.joint, meshes));
    }
  }

  [[nodiscard]] bool sharesByStiffness() const {
    if (m_report.lossless.indeterminate() == 0) return false;
    if (m_report.sharing) return m_report.sharing == LoadSharing::stiffness;
    return m_report.motion && mayLose(true);
  }

  /// Does nothing that turns freely bear anything? Then its rate changes no torque and no power.
  [[nodiscard]] bool isIdle() const {
    const StaticsSolution& solution = m_report.lossless;
    const auto isFree = [&](int unknown) {
      return solution.isDetermined(unknown) && solution.values[static_cast<std::size_t>(unknown)].isZero();
    };
    const MeshPowers powers = powersOf(m_model, solution, m_report.idleMotion);
    for (MeshOrdinal mesh = 0; mesh < m_model.c(); ++mesh)
      if (powers.rolls[mesh] != 0 && !isFree(mesh)) return false;
    if (std::any_of(powers.held.begin(), powers.held.end(), [](const Real& each) { return !each.isZero(); }))
      return false;
    return std::all_of(m_report.loads.begin(), m_report.loads.end(), [&](const LoadReport& load) {
      return powerOf(m_model, load.power, m_report.idleMotion).isZero();
    });
  }

  /// Is there a mesh that bears a load and loses power where it rolls? `shared`: of those that share loads.
  [[nodiscard]] bool mayLose(bool shared = false) const {
    if (!m_options.losses) return false;
    const StaticsSolution& solution = m_report.lossless;
    ByMesh<char> rolls(static_cast<std::size_t>(m_model.c()), 1);
    if (m_report.motion) rolls = powersOf(m_model, solution, *m_report.motion).rolls;
    for (MeshOrdinal mesh = 0; mesh < m_model.c(); ++mesh) {
      const bool bears = !solution.isDetermined(mesh) ||
                         (!shared && !solution.values[static_cast<std::size_t>(mesh)].isZero());
      if (bears && rolls[mesh] != 0 && m_efficiencies[mesh].value != Rational(1)) return true;
    }
    return false;
  }

  [[nodiscard]] bool lacksLosses() const {
    const bool isSolved = m_report.lossy && m_report.lossy->outcome == LossySolution::Outcome::solved;
    return !isSolved && mayLose();
  }

  /// The reason is in a diagnostic of its own, but for a motion that is missing.
  void tellMissingLosses() {
    for (LoadReport& load : m_report.loads) load.watts.reset();
    for (Diagnostic& diagnostic : m_report.diagnostics)
      if (diagnostic.code == Code::noMotion) diagnostic = noMotion(true);
  }

  /// What holds by the assumption of equal stiffness only. False where `stop` was requested.
  bool takeAssumed() {
    auto assumed = dependsOnShares(m_model, m_report.lossless, m_power.byLink, m_report.losses(), m_stop);
    if (!assumed) return false;
    m_report.assumed = std::move(*assumed);
    if (!m_report.losses().empty()) m_report.ranges = sharedRanges(m_model, *m_report.lossy);
    return true;
  }

  void takeEfficiencies() {
    if (hasFriction(m_mechanism)) (void)contacts();
    m_efficiencies = efficienciesOf(m_mechanism, m_placement, m_contacts, m_options.efficiency);
  }

  bool solveLosses() {
    const bool any = std::any_of(m_efficiencies.begin(), m_efficiencies.end(),
                                 [](const MeshEfficiency& each) { return each.isGiven; });
    if (!any) add(noEfficiency());
    if (!m_report.motion || !any) return true;
    const bool isAtRest = std::all_of(m_report.motion->begin(), m_report.motion->end(),
                                      [](const Rational& rate) { return rate.isZero(); });
    if (isAtRest && !lossyMeshes().empty()) add(noLossesAtRest());
    const CoefficientMatrix* const stiffness = m_report.isShared ? &m_matrix : nullptr;
    m_report.lossy = solveWithLosses(m_model, m_report.lossless, m_power.byLink, *m_report.motion,
                                     m_efficiencies, stiffness, m_stop);
    if (!m_report.lossy) return false;
    if (m_report.lossy->outcome == LossySolution::Outcome::selfLocking) {
      const auto part = selfLockingPart(m_model, m_report.lossless, m_power.byLink, *m_report.motion,
                                        m_efficiencies, stiffness, m_stop);
      if (!part) return false;
      add(selfLocking(m_mechanism, m_report, m_efficiencies, part));
    } else if (m_report.lossy->outcome == LossySolution::Outcome::patternLimit) {
      add(patternLimit(m_mechanism, lossyMeshes()));
    }
    return solveBackward(stiffness);
  }

  [[nodiscard]] std::vector<int> lossyMeshes() const {
    std::vector<int> meshes;
    for (MeshOrdinal mesh = 0; mesh < m_model.c(); ++mesh)
      if (m_efficiencies[mesh].value != Rational(1)) meshes.push_back(mesh);
    return meshes;
  }

  /// The same motion with every known torque reversed.
  bool solveBackward(const CoefficientMatrix* stiffness) {
    if (m_report.lossy->outcome == LossySolution::Outcome::undecided) return true;
    const RadicalColumns reversed = opposite(m_power.byLink);
    auto lossless = solveStatics(m_model, m_report.held, reversed, {}, m_stop);
    if (!lossless) return false;
    if (stiffness != nullptr && !shareByStiffness(m_model, *stiffness, *lossless, m_stop)) return false;
    m_report.backward =
        solveWithLosses(m_model, *lossless, reversed, *m_report.motion, m_efficiencies, stiffness, m_stop);
    if (!m_report.backward) return false;
    if (m_report.backward->outcome != LossySolution::Outcome::solved) return true;
    std::vector<RadicalColumns> loads;
    for (const LoadReport& load : m_report.loads) loads.push_back(opposite(load.power));
    m_report.backwardSums = powerSums(m_model, *m_report.backward, loads, *m_report.motion, holdersOfLoads());
    return true;
  }

  [[nodiscard]] std::vector<int> holdersOfLoads() const {
    std::vector<int> holders;
    for (const LoadReport& load : m_report.loads) holders.push_back(load.heldBy);
    return holders;
  }

  void takePowers() {
    if (!m_report.motion) return;
    std::vector<RadicalColumns> loads;
    for (const LoadReport& load : m_report.loads) loads.push_back(load.power);
    const bool isLossy = m_report.lossy && m_report.lossy->outcome == LossySolution::Outcome::solved;
    LossySolution shown;
    if (isLossy) {
      shown = *m_report.lossy;
    } else {
      shown.statics = m_report.lossless;
      shown.powers = powersOf(m_model, m_report.lossless, *m_report.motion);
    }
    m_report.powers = shown.powers;
    m_report.sums = powerSums(m_model, shown, loads, *m_report.motion, holdersOfLoads());
    const double fed = m_report.sums->fed.number();
    constexpr double kNoticeably = 1 + 1e-9;
    ByMesh<double> times(static_cast<std::size_t>(m_model.c()), 0);
    for (MeshOrdinal mesh = 0; mesh < m_model.c() && fed > 0; ++mesh) {
      if (!shown.statics.isDetermined(mesh)) continue;
      const double passed = std::abs(shown.powers.mesh[static_cast<std::size_t>(mesh)].number());
      if (passed > kNoticeably * fed) times[mesh] = passed / fed;
    }
    takeFlow(times);
    for (Diagnostic& each : recirculations(m_mechanism, times)) add(std::move(each));
  }

  /// Sets the entries of meshes to 0 that are named with their loop.
  void takeFlow(std::vector<double>& times) {
    const double fed = m_report.sums->fed.number();
    m_report.latentRatio = latentRatio(m_report.solution(), m_report.powers, m_report.sums->fed);
    m_report.flow = powerFlowSeenFrom(m_mechanism, m_model, m_placement, m_report, 0);
    m_report.circulations = circulationsOf(m_mechanism, m_model, m_placement, m_report.problem,
                                           m_report.lossless, *m_report.flow);
    if (!m_report.circulations || fed <= 0) return;
    constexpr double kNoticeable = 1e-3;
    for (const Circulation& each : *m_report.circulations) {
      if (each.power.number() <= kNoticeable * fed) continue;
      add(circulatingPower(m_mechanism, each, each.power.number() / fed));
      for (const MeshOrdinal mesh : each.meshes) times[static_cast<std::size_t>(mesh)] = 0;
    }
  }

  void takeForces() {
    if (!metresPerUnit(m_mechanism)) return;
    std::vector<double> angles;
    std::vector<double> helices;
    for (const std::optional<MeshContact>& contact : contacts()) {
      angles.push_back(contact ? contact->pressureAngle : 0);
      helices.push_back(contact ? contact->helix : 0);
    }
    m_report.forces = forcesOf(m_mechanism, m_model, m_placement, m_report.problem, m_report.held,
                               numbersOf(m_report.solution()), m_report.solution().determined,
                               m_report.losses(), angles, helices);
  }

  bool solveTransposed() {
    const auto joints = jointsOf(m_model, m_report.problem);
    if (!joints || !m_report.problem.engaged.empty() || joints->first.empty()) return true;
    if (joints->first.size() * joints->second.size() > ExactSolution::kMaxExactEntries) return true;
    m_report.balancedJoints = joints->first;
    m_report.matrix = torqueMatrix(m_model, m_report.held, joints->second, m_stop);
    if (m_stop.stop_requested()) return false;
    if (m_report.matrix && m_options.symbolic && !takeTtMatrix()) return false;
    constexpr std::size_t kMaxSymbolicEntries = 20'000;
    if (!m_report.matrix || !m_options.symbolic || m_report.matrix->entries.size() > kMaxSymbolicEntries)
      return true;
    m_report.symbolic = solveStaticsSymbolic(m_mechanism, cutsets(), m_analysis.independentMeshes,
                                             joints->first, joints->second, m_stop);
    if (m_report.symbolic && m_report.ttMatrix)
      m_report.ttSymbolic =
          solveStaticsSymbolic(m_mechanism, CutsetEquations(m_ttGraph), m_analysis.independentMeshes,
                               joints->first, joints->second, m_stop);
    return !m_stop.stop_requested();
  }

  /// The transposed solution by the T-T graph: a chain from each loaded joint. False where `stop` was
  /// requested.
  bool takeTtMatrix() {
    const TorqueMatrix& matroid = *m_report.matrix;
    if (!m_ttGraph.isComplete() || matroid.loaded.size() > kMaxTtColumns) return true;
    TorqueMatrix matrix{matroid.balanced, matroid.loaded, {}};
    matrix.entries.resize(matroid.entries.size());
    const std::vector<TtChord> chords = chordsOf(m_report.held);
    for (std::size_t column = 0; column < matrix.loaded.size(); ++column) {
      RadicalColumns load;
      load.add(matrix.loaded[column], 1);
      const auto torques = ttTorques(m_ttGraph, chords, load, m_stop);
      if (!torques) return false;
      if (!torques->isBalanced) return true;
      for (std::size_t row = 0; row < matrix.balanced.size(); ++row) {
        const auto& torque = torques->chords[static_cast<std::size_t>(matrix.balanced[row])].fraction();
        if (!torque) return true;
        matrix.entries[row * matrix.loaded.size() + column] = *torque;
      }
    }
    m_report.ttMatrix = std::move(matrix);
    return true;
  }

  struct DrivenJoints {
    std::vector<int> joints;
    std::vector<Rational> speeds;
  };
  /// What drives: the inputs, in a state the joint in which its drive turns on the ground.
  [[nodiscard]] std::optional<DrivenJoints> drivenJoints() const {
    if (state() == nullptr) return DrivenJoints{m_analysis.choice.joints, m_analysis.speeds};
    if (!state()->drive) return std::nullopt;
    const PositionIndex<LinkTag> links(m_mechanism.links);
    const int drive = links.at(*state()->drive);
    if (drive == 0) return std::nullopt;
    const JointOrdinal joint = m_model.tree().jointToParent(drive);
    if (m_model.jointRate(joint).parent != 0) return std::nullopt;
    return DrivenJoints{{joint}, {(*m_report.motion)[static_cast<std::size_t>(joint)]}};
  }

  void takeSymbolicEfficiencies() {
    if (!m_options.symbolic || !m_report.motion) return;
    const std::optional<DrivenJoints> driven = drivenJoints();
    const bool hasOne = std::any_of(m_report.loads.begin(), m_report.loads.end(),
                                    [](const LoadReport& load) { return load.heldBy >= 0; });
    if (!driven || hasOne || !m_report.idleMotion.empty()) return;
    const auto efficiency = [&](const std::optional<LossySolution>& solution,
                                bool isReversed) -> std::optional<RationalFunction> {
      if (!solution || solution->outcome != LossySolution::Outcome::solved) return std::nullopt;
      std::vector<RadicalColumns> loads;
      for (const LoadReport& load : m_report.loads)
        loads.push_back(isReversed ? opposite(load.power) : load.power);
      return symbolicEfficiency(m_mechanism, m_model,
                                {m_analysis.independentMeshes, driven->joints, driven->speeds, loads},
                                *solution, *m_report.motion, m_stop);
    };
    m_report.efficiency = efficiency(m_report.lossy, false);
    m_report.backwardEfficiency = efficiency(m_report.backward, true);
  }

  /// Of no use where `stop` was requested.
  const std::vector<std::optional<MeshContact>>& contacts() {
    if (m_contacts.empty()) m_contacts = meshContacts(m_mechanism, m_placement, m_stop);
    return m_contacts;
  }

  const CutsetEquations& cutsets() {
    if (!m_cutsets) m_cutsets.emplace(m_matrix);
    return *m_cutsets;
  }

  const Mechanism& m_mechanism;
  const KinematicModel& m_model;
  const Placement& m_placement;
  const TtGraph& m_ttGraph;
  const MatroidAnalysis& m_analysis;
  const StaticsOptions& m_options;
  std::stop_token m_stop;
  CoefficientMatrix m_matrix;
  std::optional<CutsetEquations> m_cutsets;
  LoadPower m_power;
  ByMesh<MeshEfficiency> m_efficiencies;
  std::vector<std::optional<MeshContact>> m_contacts;  ///< once they are asked for
  StaticsReport m_report;
};

/// Does the power of an element that is known depend on how loads are shared?
bool isAssumed(const Mechanism& mechanism, const StaticsReport& report, const ElementPower& element) {
  using Kind = ElementPower::Kind;
  if (report.assumed.empty() || !element.isDetermined) return false;
  if (element.kind == Kind::mesh) return report.isAssumed(element.position);
  for (std::size_t part = 0; part < report.held.size(); ++part) {
    if (!report.isAssumed(mechanism.c() + static_cast<int>(part))) continue;
    const HeldPart& held = report.held[part];
    if (held.coupling >= 0 && element.kind == Kind::coupling && held.coupling == element.position)
      return true;
    if (held.balance < 0) continue;
    const TorquePlace& place = report.problem.balances[static_cast<std::size_t>(held.balance)];
    const bool isThere = place.inJoint() ? element.kind == Kind::joint && place.joint == element.position
                                         : element.kind == Kind::balance && held.balance == element.position;
    if (isThere) return true;
  }
  return false;
}

}  // namespace

std::optional<StaticsReport> analyzeStatics(const Mechanism& mechanism, const KinematicModel& model,
                                            const Placement& placement, const TtGraph& ttGraph,
                                            const MatroidAnalysis& analysis, const StaticsOptions& options,
                                            const std::stop_token& stop) {
  return Analysis(mechanism, model, placement, ttGraph, analysis, options, stop).run();
}

std::optional<bool> StaticsReport::agreesInSymbols() const {
  if (!symbolic || !ttSymbolic || symbolic->skipped > 0 || ttSymbolic->skipped > 0) return std::nullopt;
  // Each has a ring of its own; its canonical text tells an entry.
  return std::equal(symbolic->matrix.begin(), symbolic->matrix.end(), ttSymbolic->matrix.begin(),
                    ttSymbolic->matrix.end(),
                    [](const auto& one, const auto& other) { return one->toText() == other->toText(); });
}

PowerFlow powerFlowSeenFrom(const Mechanism& mechanism, const KinematicModel& model,
                            const Placement& placement, const StaticsReport& report, LinkOrdinal observer) {
  PowerFlow flow = powerFlow(mechanism, model, placement, report.problem, report.solution(), report.losses(),
                             *report.motion, observer);
  for (ElementPower& element : flow.elements)
    element.isAssumed = element.isAssumed || isAssumed(mechanism, report, element);
  return flow;
}

std::vector<double> numbersOf(const StaticsSolution& solution) {
  std::vector<double> numbers;
  for (const Real& value : solution.values) numbers.push_back(value.number());
  return numbers;
}

}  // namespace geargraph

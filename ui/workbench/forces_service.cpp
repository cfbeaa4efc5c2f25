#include "ui/workbench/forces_service.h"

#include <algorithm>

#include "core/theory/statics/load_diagnostics.h"

namespace geargraph {
namespace {

/// Errors of the document leave nothing to solve; in a state the inputs do not count.
bool hasErrorsFor(const AnalysisSnapshot& snapshot, int state) {
  return std::any_of(snapshot.diagnostics.begin(), snapshot.diagnostics.end(), [&](const Diagnostic& each) {
    const bool isIdle = state >= 0 && each.code == Code::invalidInputs;
    return !isIdle && each.severity() == Severity::error;
  });
}

/// The train without the couplings that the document engages: a state engages its own. Of no use where `stop`
/// was requested.
SnapshotPtr released(const SnapshotPtr& snapshot, const std::stop_token& stop) {
  if (snapshot->mechanism->engaged.empty()) return snapshot;
  auto mechanism = std::make_shared<Mechanism>(*snapshot->mechanism);
  mechanism->engaged.clear();
  return analyzeLive(std::move(mechanism), snapshot->revision, stop);
}

std::optional<StaticsReport> solved(const ForcesQuestion& question, const AnalysisSnapshot& snapshot,
                                    const std::stop_token& stop) {
  if (snapshot.matroid() == nullptr || hasErrorsFor(snapshot, question.state)) return std::nullopt;
  const StaticsOptions options = optionsOf(question);
  return analyzeStatics(*snapshot.mechanism, *snapshot.kinematics->model, snapshot.kinematics->placement(),
                        *snapshot.kinematics->ttGraph, *snapshot.matroid(), options, stop);
}

std::optional<StateForces> shiftState(const ForcesQuestion& question, const AnalysisSnapshot& snapshot,
                                      const std::stop_token& stop) {
  if (snapshot.matroid() == nullptr || hasErrorsFor(snapshot, question.state))
    return StateForces{question.state, {}, {}};
  return solveShiftState(*snapshot.mechanism, *snapshot.kinematics->model, snapshot.kinematics->placement(),
                         *snapshot.kinematics->ttGraph, *snapshot.matroid(), question.state,
                         optionsOf(question), stop);
}

/// One request, answered in parts.
class Work {
 public:
  Work(const ForcesRequest& request, const ForcesService::Responder& respond)
      : m_request(request),
        m_mechanism(*request.snapshot->mechanism),
        m_stop(respond.stop()),
        m_respond(respond),
        m_forces(std::make_shared<Forces>()) {}

  void run() {
    const bool hasStates = !m_mechanism.states.empty();
    m_forces->snapshot = m_request.snapshot;
    m_forces->question = m_request.question;
    if (m_forces->question.state >= static_cast<int>(m_mechanism.states.size()))
      m_forces->question.state = -1;
    if (hasStates) m_open = released(m_request.snapshot, m_stop);
    if (m_stop.stop_requested()) return;
    m_forces->solved = m_forces->question.state >= 0 ? m_open : m_request.snapshot;
    m_forces->report = solved(m_forces->question, *m_forces->solved, m_stop);
    if (m_stop.stop_requested()) return;
    if (m_forces->report) addArrows();
    if (m_request.tables && m_forces->report) addTables();
    const bool areForStates = hasStates && m_mechanism.engaged.empty();
    if (!areForStates && !findAsEngaged()) return;
    if (hasStates && (m_request.tables || (areForStates && !m_mechanism.loads.empty()))) {
      m_respond.partly(std::make_shared<const Forces>(*m_forces));
      if (!solveStates(areForStates)) return;
    }
    m_respond(std::move(m_forces));
  }

 private:
  void addArrows() {
    auto arrows = stageForces(m_mechanism, m_forces->solved->kinematics->placement(), *m_forces->report);
    if (!arrows.empty())
      m_forces->arrows = std::make_shared<const std::vector<SceneForce>>(std::move(arrows));
  }

  void addTables() {
    const AnalysisSnapshot& snapshot = *m_forces->solved;
    std::vector<ForceTableKind> kinds = allForceTableKinds();
    kinds.push_back(ForceTableKind::needs);
    for (const ForceTableKind kind : kinds)
      m_forces->tables.push_back(forceTable(m_mechanism, *snapshot.kinematics->model,
                                            snapshot.kinematics->placement(), *m_forces->report, kind));
  }

  /// False where `stop` was requested.
  bool findAsEngaged() {
    if (m_mechanism.loads.empty()) return true;
    const bool isAnswered = m_forces->question == ForcesQuestion();
    const auto report =
        isAnswered ? std::optional<StaticsReport>() : solved(ForcesQuestion(), *m_request.snapshot, m_stop);
    if (m_stop.stop_requested()) return false;
    const auto& on = isAnswered ? m_forces->report : report;
    if (on) m_forces->diagnostics = solvedLoadDiagnostics(m_mechanism, *on);
    return true;
  }

  /// False where `stop` was requested.
  bool solveStates(bool areLoadsForThem) {
    std::vector<StateForces> states;
    ForcesQuestion each = m_forces->question;
    for (each.state = 0; each.state < static_cast<int>(m_mechanism.states.size()); ++each.state) {
      auto state = shiftState(each, *m_open, m_stop);
      if (!state || m_stop.stop_requested()) return false;
      states.push_back(std::move(*state));
    }
    m_forces->tables.push_back(shiftTable(m_mechanism, states));
    return !areLoadsForThem || m_mechanism.loads.empty() || findInStates();
  }

  /// The loads of the document as they are, in each state. False where `stop` was requested.
  bool findInStates() {
    std::vector<std::optional<StaticsReport>> reports;
    ForcesQuestion each;
    for (each.state = 0; each.state < static_cast<int>(m_mechanism.states.size()); ++each.state) {
      reports.push_back(solved(each, *m_open, m_stop));
      if (m_stop.stop_requested()) return false;
    }
    std::vector<const StaticsReport*> found;
    for (const auto& report : reports) found.push_back(report ? &*report : nullptr);
    m_forces->diagnostics = solvedLoadDiagnostics(m_mechanism, found);
    return true;
  }

  const ForcesRequest& m_request;
  const Mechanism& m_mechanism;
  std::stop_token m_stop;
  const ForcesService::Responder& m_respond;
  std::shared_ptr<Forces> m_forces;
  SnapshotPtr m_open;  ///< with nothing engaged, where there are states
};

void solve(const ForcesRequest& request, const ForcesService::Responder& respond) {
  Work(request, respond).run();
}

bool isSame(const ForcesRequest& before, const ForcesRequest& now) {
  return before.snapshot->mechanism == now.snapshot->mechanism &&
         before.snapshot->revision == now.snapshot->revision && before.question == now.question &&
         before.tables == now.tables;
}

}  // namespace

StaticsOptions optionsOf(const ForcesQuestion& question) {
  StaticsOptions options;
  options.state = question.state;
  options.losses = true;
  options.efficiency = question.efficiency;
  options.symbolic = false;
  return options;
}

const ForceTable* Forces::table(ForceTableKind kind) const {
  const auto found =
      std::find_if(tables.begin(), tables.end(), [&](const ForceTable& each) { return each.kind == kind; });
  return found == tables.end() ? nullptr : &*found;
}

ForcesService::ForcesService(QObject* parent) : Service(&solve, parent, {.same = &isSame}) {}

void ForcesService::follow(const SnapshotPtr& snapshot) {
  m_snapshot = snapshot;
  renew();
}

void ForcesService::ask(const ForcesQuestion& question) {
  m_question = question;
  renew();
}

void ForcesService::setWatched(const QObject* view, bool watched) {
  if (watched) {
    m_watching.insert(view);
  } else {
    m_watching.erase(view);
  }
  renew();
}

void ForcesService::renew() {
  if (!m_snapshot) return;
  if (!m_watching.empty() || !m_snapshot->mechanism->loads.empty()) {
    request({m_snapshot, m_question, !m_watching.empty()});
    return;
  }
  if (!isComplete()) cancel();
  forgetRequest();
  if (answer()) setAnswer(nullptr);
}

}  // namespace geargraph

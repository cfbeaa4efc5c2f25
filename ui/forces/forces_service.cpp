#include "ui/forces/forces_service.h"

#include <algorithm>

namespace geargraph::inline forces {
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

std::optional<StaticsReport> solved(const ForcesRequest& request, const AnalysisSnapshot& snapshot, int state,
                                    const std::stop_token& stop) {
  if (snapshot.matroid() == nullptr || hasErrorsFor(snapshot, state)) return std::nullopt;
  StaticsOptions options;
  options.state = state;
  options.losses = true;
  options.efficiency = request.efficiency;
  options.stiffness = request.stiffness;
  options.symbolic = false;
  return analyzeStatics(*snapshot.mechanism, *snapshot.kinematics->model, snapshot.kinematics->placement(),
                        *snapshot.kinematics->ttGraph, *snapshot.matroid(), options, stop);
}

void solve(const ForcesRequest& request, const ForcesService::Responder& respond) {
  const std::stop_token stop = respond.stop();
  const Mechanism& mechanism = *request.snapshot->mechanism;
  auto forces = std::make_shared<Forces>();
  forces->snapshot = request.snapshot;
  forces->state = request.state < static_cast<int>(mechanism.states.size()) ? request.state : -1;
  const SnapshotPtr open = mechanism.states.empty() ? nullptr : released(request.snapshot, stop);
  if (stop.stop_requested()) return;
  const AnalysisSnapshot& snapshot = forces->state >= 0 ? *open : *request.snapshot;
  forces->report = solved(request, snapshot, forces->state, stop);
  if (stop.stop_requested()) return;
  if (forces->report) {
    for (const ForceTableKind kind : allForceTableKinds())
      forces->tables.push_back(forceTable(mechanism, *snapshot.kinematics->model,
                                          snapshot.kinematics->placement(), *forces->report, kind));
  }
  if (open == nullptr || open->matroid() == nullptr) return respond(std::move(forces));
  respond.partly(std::make_shared<const Forces>(*forces));
  std::vector<StateForces> states;
  for (int state = 0; state < static_cast<int>(mechanism.states.size()); ++state) {
    states.push_back({state, solved(request, *open, state, stop)});
    if (stop.stop_requested()) return;
  }
  forces->tables.push_back(shiftTable(mechanism, states));
  respond(std::move(forces));
}

bool isSame(const ForcesRequest& before, const ForcesRequest& now) {
  return before.snapshot->mechanism == now.snapshot->mechanism &&
         before.snapshot->revision == now.snapshot->revision && before.state == now.state &&
         before.efficiency == now.efficiency && before.stiffness == now.stiffness;
}

}  // namespace

const ForceTable* Forces::table(ForceTableKind kind) const {
  const auto found =
      std::find_if(tables.begin(), tables.end(), [&](const ForceTable& each) { return each.kind == kind; });
  return found == tables.end() ? nullptr : &*found;
}

ForcesService::ForcesService(QObject* parent) : Service(&solve, parent, {.same = &isSame}) {}

}  // namespace geargraph::inline forces

#include "core/teaching/derivation/solved_statics.h"

#include <algorithm>

namespace geargraph {
namespace {

/// Errors of the mechanism leave nothing to solve; in a state the inputs do not count.
bool canSolve(const AnalysisSnapshot& snapshot, int state) {
  if (snapshot.matroid() == nullptr) return false;
  return std::none_of(snapshot.diagnostics.begin(), snapshot.diagnostics.end(), [&](const Diagnostic& each) {
    return each.severity() == Severity::error && (state < 0 || each.code != Code::invalidInputs);
  });
}

/// Under the document's loads, with the losses that it states. @pre canSolve()
std::optional<StaticsReport> reportOf(const AnalysisSnapshot& snapshot, int state, std::stop_token stop) {
  StaticsOptions options;
  options.state = state;
  options.losses = true;
  options.symbolic = false;
  return analyzeStatics(*snapshot.mechanism, *snapshot.kinematics->model, snapshot.kinematics->placement(),
                        *snapshot.kinematics->ttGraph, *snapshot.matroid(), options, std::move(stop));
}

/// With nothing engaged, for states that engage their own couplings; null where the time was over.
SnapshotPtr released(const SnapshotPtr& snapshot, const std::stop_token& stop) {
  if (snapshot->mechanism->engaged.empty()) return snapshot;
  auto mechanism = std::make_shared<Mechanism>(*snapshot->mechanism);
  mechanism->engaged.clear();
  return analyzeLive(std::move(mechanism), 0, stop);
}

/// @pre nothing is engaged in the snapshot
std::optional<std::vector<StateForces>> shiftOf(const AnalysisSnapshot& open,
                                                const std::optional<Rational>& efficiency,
                                                const std::stop_token& stop) {
  StaticsOptions options;
  options.losses = true;
  options.efficiency = efficiency;
  options.symbolic = false;
  std::vector<StateForces> states;
  for (int state = 0; state < static_cast<int>(open.mechanism->states.size()); ++state) {
    if (!canSolve(open, state)) {
      states.push_back({state, {}, {}});
      continue;
    }
    auto solved = solveShiftState(*open.mechanism, *open.kinematics->model, open.kinematics->placement(),
                                  *open.kinematics->ttGraph, *open.matroid(), state, options, stop);
    if (!solved) return std::nullopt;
    states.push_back(std::move(*solved));
  }
  return states;
}

}  // namespace

SolvedStaticsPtr solvedStatics(const SnapshotPtr& snapshot, const std::optional<std::string>& state,
                               bool allStates, const std::stop_token& stop) {
  auto statics = std::make_shared<SolvedStatics>();
  const std::vector<ShiftState>& states = snapshot->mechanism->states;
  const auto of = std::find_if(states.begin(), states.end(),
                               [&](const ShiftState& each) { return state && each.name == *state; });
  const int position = of == states.end() ? -1 : static_cast<int>(of - states.begin());
  const SnapshotPtr open = position >= 0 || allStates ? released(snapshot, stop) : nullptr;
  statics->snapshot = position >= 0 ? open : snapshot;
  if (statics->snapshot && canSolve(*statics->snapshot, position))
    statics->report = reportOf(*statics->snapshot, position, stop);
  if (allStates && open) {
    auto shift = shiftOf(*open, {}, stop);
    if (!shift) return nullptr;
    statics->states = std::move(*shift);
  }
  if (stop.stop_requested()) return nullptr;
  return statics;
}

std::optional<std::vector<StateForces>> solvedShift(const SnapshotPtr& snapshot,
                                                    const std::optional<Rational>& efficiency,
                                                    const std::stop_token& stop) {
  const SnapshotPtr open = released(snapshot, stop);
  return open ? shiftOf(*open, efficiency, stop) : std::nullopt;
}

}  // namespace geargraph

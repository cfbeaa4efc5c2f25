#pragma once

#include <memory>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

#include "core/teaching/force_tables/force_table.h"
#include "core/theory/analysis/analysis.h"

namespace geargraph {

/// The torques of a mechanism, for its tables and drawings.
struct SolvedStatics {
  /// The analysed train; for a state the train with nothing engaged, because the state engages its own
  /// couplings.
  SnapshotPtr snapshot;
  std::optional<StaticsReport> report;  ///< none if the mechanism has errors
  std::vector<StateForces> states;      ///< for the shift table; empty unless that was asked for
};
using SolvedStaticsPtr = std::shared_ptr<const SolvedStatics>;

/// Solves the statics under the document's loads, with its stated losses: of the train as engaged, or of the
/// state with this name; with `allStates` also of every state. Null if `stop` was requested.
[[nodiscard]] SolvedStaticsPtr solvedStatics(const SnapshotPtr& snapshot,
                                             const std::optional<std::string>& state = {},
                                             bool allStates = false, const std::stop_token& stop = {});

/// The statics of every state for the shift table, under the torque at its drive and other loads of the
/// document, with the losses that it states or, else, `efficiency` of every mesh. std::nullopt if `stop` was
/// requested.
[[nodiscard]] std::optional<std::vector<StateForces>> solvedShift(
    const SnapshotPtr& snapshot, const std::optional<Rational>& efficiency = {},
    const std::stop_token& stop = {});

}  // namespace geargraph

#pragma once

#include "core/theory/statics/statics_report.h"

namespace geargraph {

/// The torque at the drive of a state in the shift table, N m: that of the document, else that of its loads
/// on a link that drives states, if these are on one link; else 1. std::nullopt where loads are on the
/// state's driven link only: then the drive holds them.
[[nodiscard]] std::optional<Rational> driveTorqueOf(const Mechanism& mechanism, int state);

/// The statics of one state of a gearbox, for the shift table.
struct StateForces {
  int state = 0;                        ///< position in the document
  std::optional<StaticsReport> report;  ///< under the torque at its drive and other loads; none: not solved
  /// Under a torque at its drive alone, where other loads act too, or that torque does not feed power in.
  /// Efficiencies are of this one: with constant losses they are a property of the state.
  std::optional<StaticsReport> alone = {};

  [[nodiscard]] const StaticsReport& ofEfficiency() const { return alone ? *alone : *report; }
};

/// The torques at the ends of a state, from outside, about the directions of the links' own first axes, N m.
struct EndTorques {
  Real drive;
  Real driven;
  std::vector<Load> otherLoads;  ///< all others that act
};
/// std::nullopt if the report is not of a state with two ends, one of which holds the loads, or its torque is
/// not determined. @pre report.isAnswered()
[[nodiscard]] std::optional<EndTorques> endTorques(const Mechanism& mechanism, const StaticsReport& report);

/// Solves one state. `options`: losses, sharing and symbols; its drive torque takes the place of
/// driveTorqueOf(). std::nullopt if `stop` was requested.
/// Cost: as analyzeStatics(), twice where other loads act. @pre as analyzeStatics()
[[nodiscard]] std::optional<StateForces> solveShiftState(const Mechanism& mechanism,
                                                         const KinematicModel& model,
                                                         const Placement& placement, const TtGraph& ttGraph,
                                                         const MatroidAnalysis& analysis, int state,
                                                         StaticsOptions options = {},
                                                         const std::stop_token& stop = {});

}  // namespace geargraph

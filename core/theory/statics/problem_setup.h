#pragma once

#include "core/theory/statics/statics_report.h"

namespace geargraph {

/// Sets what acts on the train and what holds it: the loads, problem and held parts of the report, as the
/// options of the analysis ask, and adds the diagnostics about them.
/// Cost: O(joints to the ground) per load and end of a state.
/// @pre report.problem.engaged and report.motion are set; as analyzeStatics()
void setUpProblem(const Mechanism& mechanism, const KinematicModel& model, const Placement& placement,
                  const MatroidAnalysis& analysis, const StaticsOptions& options, StaticsReport& report);

}  // namespace geargraph

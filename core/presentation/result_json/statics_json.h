#pragma once

#include "core/foundations/files/json_writer.h"
#include "core/theory/analysis/analysis.h"
#include "core/theory/statics/statics_report.h"

namespace geargraph {

/// The object of `statics --json`, of one state or of none. Links, joints and meshes by label, axes and
/// couplings by id; torques, powers and efficiencies as fractions, as numbers if they are not exact, null if
/// they are not determined. `snapshot` may be null, and `report`, where the document has errors.
void writeStaticsJson(JsonWriter& json, const AnalysisSnapshot* snapshot, const StaticsReport* report,
                      int state, const Diagnostics& diagnostics);

}  // namespace geargraph

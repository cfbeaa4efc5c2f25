#pragma once

#include <QString>

#include "core/theory/analysis/analysis.h"

namespace geargraph {

/// The degrees of freedom in sentences: which joints each input drives, which turn together at fixed ratios,
/// which never turn. Empty if nothing is solved.
[[nodiscard]] QString freedomText(const AnalysisSnapshot& snapshot);

}  // namespace geargraph

#pragma once

#include <string>

#include "core/theory/analysis/analysis.h"

namespace geargraph::cli {

/// The analysis as text for a terminal: counts, elements with their labels, and the matrices in the paper's
/// form; of a matrix too large for a screen only the size is given.
[[nodiscard]] std::string analysisText(const SnapshotPtr& snapshot);

}  // namespace geargraph::cli

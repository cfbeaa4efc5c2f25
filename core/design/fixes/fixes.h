#pragma once

#include <functional>
#include <string>
#include <vector>

#include "core/foundations/base/expected.h"
#include "core/theory/analysis/analysis.h"

namespace geargraph::inline fixes {

/// A way to mend a finding: what a button says, "Delete joint 15", and the edit behind it.
struct Fix {
  std::string text;
  std::function<Expected<Mechanism>(const Mechanism&)> edit;
};

/// What would mend this finding of this snapshot (or of the train of its mechanism: assembly, undercut,
/// overlaps in 3D), the likeliest first, kMostFixes at most; empty where only a person can tell. Geometric
/// fixes have been tried: none is offered that leaves the finding, or that the edits refuse.
///
/// Cost: near linear in n + t + c for each try; some dozen tries for teeth that do not fit together.
[[nodiscard]] std::vector<Fix> fixesFor(const Diagnostic& diagnostic, const AnalysisSnapshot& snapshot);

constexpr std::size_t kMostFixes = 3;

}  // namespace geargraph::inline fixes

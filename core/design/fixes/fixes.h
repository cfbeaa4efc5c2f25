#pragma once

#include <functional>
#include <string>
#include <vector>

#include "core/foundations/base/expected.h"
#include "core/theory/analysis/analysis.h"

namespace geargraph {

/// A quick fix for a diagnostic: the text of a button, "Delete joint 15", and its edit.
struct Fix {
  std::string text;
  std::function<Expected<Mechanism>(const Mechanism&)> edit;
};

/// The quick fixes for this diagnostic of the snapshot (or of the train of its mechanism: assembly, undercut,
/// overlaps in 3D), the likeliest first, at most kMaxFixes; empty if only the user can decide. Geometric
/// fixes have been tried: none is offered that leaves the diagnostic, or that the edits reject.
///
/// Cost: near linear in n + t + c per try; some dozen tries for teeth that do not fit.
[[nodiscard]] std::vector<Fix> fixesFor(const Diagnostic& diagnostic, const AnalysisSnapshot& snapshot);

/// Do the fixes for this diagnostic take the bodies of several trains to try? Of large trains that takes a
/// second: not for the GUI thread.
[[nodiscard]] bool triesBodies(const Diagnostic& diagnostic);

constexpr std::size_t kMaxFixes = 3;

}  // namespace geargraph

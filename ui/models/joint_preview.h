#pragma once

#include <optional>

#include "core/theory/analysis/analysis.h"
#include "ui/tools/tool.h"

namespace geargraph::inline models {

/// What the matrices would be if the arrow being drawn were let go now.
struct PreviewSnapshot {
  SnapshotPtr snapshot;  ///< graph, tree, matrices; no diagnostics, no results
  ElementId ghost;       ///< the joint to be
};

/// The structure of the mechanism with the joint that is being drawn. Nothing while the arrow is over no
/// link, or the joint would be refused.
/// Cost: O(n + t + c), so it is done while the mouse moves.
[[nodiscard]] std::optional<PreviewSnapshot> previewOf(const Mechanism& mechanism,
                                                       const JointPreview& preview);

}  // namespace geargraph::inline models

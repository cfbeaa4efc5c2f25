#pragma once

#include <optional>

#include "core/theory/analysis/analysis.h"
#include "ui/tools/tool.h"

namespace geargraph {

/// The matrices as they would be if the arrow being drawn were released now.
struct PreviewSnapshot {
  SnapshotPtr snapshot;  ///< graph, tree, matrices; no diagnostics, no results
  ElementId drawnJoint;  ///< the joint being drawn
};

/// The structure of the mechanism with the joint that is being drawn. std::nullopt if the
/// arrow is over no link, or if the joint would be rejected.
/// Cost: O(n + t + c), fast enough for every mouse move.
[[nodiscard]] std::optional<PreviewSnapshot> previewOf(const Mechanism& mechanism,
                                                       const JointPreview& preview);

}  // namespace geargraph

#pragma once

#include <array>
#include <cstdint>
#include <stop_token>
#include <vector>

#include "core/base/diagnostic.h"
#include "core/graph/matrices.h"

namespace geargraph {

/// Everything that is computed from one mechanism: an immutable value that all views read. A stage that fails
/// leaves its part empty and does not fail the snapshot, so a half-drawn mechanism still shows its incidence
/// matrix.
struct AnalysisSnapshot {
  std::uint64_t revision = 0;
  MechanismPtr mechanism;
  DigraphPtr graph;
  SpanningTreePtr tree;  ///< null where the turning joints are no spanning tree
  std::vector<IntegerMatrixPtr>
      matrices;  ///< by MatrixKind; null where the matrix needs the tree and there is none
  Diagnostics diagnostics;

  [[nodiscard]] const IntegerMatrixPtr& matrix(MatrixKind kind) const {
    return matrices[static_cast<std::size_t>(kind)];
  }
};

using SnapshotPtr = std::shared_ptr<const AnalysisSnapshot>;

/// Analyses a mechanism. Pure; null when `stop` was requested meanwhile.
/// Cost: near linear in n + t + c and the sum of the cycle lengths.
/// @pre the mechanism is well formed
[[nodiscard]] SnapshotPtr analyze(MechanismPtr mechanism, std::uint64_t revision = 0,
                                  std::stop_token stop = {});

}  // namespace geargraph

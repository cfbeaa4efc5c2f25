#pragma once

#include <cstdint>
#include <optional>
#include <stop_token>
#include <vector>

#include "core/foundations/base/diagnostic.h"
#include "core/mechanism/graph/matrices.h"
#include "core/theory/analysis/kinematics.h"
#include "core/theory/states/state_solution.h"

namespace geargraph::inline bodies {
class DerivedGeometry;
using DerivedGeometryPtr = std::shared_ptr<const DerivedGeometry>;
}  // namespace geargraph::inline bodies

namespace geargraph::inline analysis {

/// Everything that is computed from one mechanism: an immutable value that all views read. Matrices are those
/// of the train; freedom, inputs, solutions and motion are those of the train as the document engages its
/// couplings; `states` has the ratios of all states whatever is engaged. A stage that fails
/// leaves its part empty and does not fail the snapshot, so a half-drawn mechanism still shows its incidence
/// matrix.
///
/// It comes in two steps: the live part at once, the exact and symbolic solutions (`solved`) when they are
/// there. Nothing in the live part changes with the second step but that diagnostics are added.
struct AnalysisSnapshot {
  std::uint64_t revision = 0;
  MechanismPtr mechanism;
  /// Placement, wheels, train and its diagnostics, which are computed on demand and once; never null.
  DerivedGeometryPtr geometry;
  DigraphPtr graph;
  SpanningTreePtr tree;  ///< null where the turning joints are no spanning tree
  /// By MatrixKind; null where the matrix needs the tree and there is none.
  std::vector<IntegerMatrixPtr> matrices;
  LiveKinematicsPtr kinematics;  ///< null where there is no tree
  SolvedKinematicsPtr solved;    ///< null until the second step, and where the live part has no solution
  /// By state of the document; null until the second step, where there are no states, and where a mesh has no
  /// geometry.
  std::shared_ptr<const std::vector<StateSolution>> states;
  bool isComplete = false;  ///< the second step is done
  Diagnostics diagnostics;

  [[nodiscard]] const IntegerMatrixPtr& matrix(MatrixKind kind) const {
    return matrices[static_cast<std::size_t>(kind)];
  }
  /// What the matroid method says; null where the mechanism has errors that leave nothing to solve.
  [[nodiscard]] const MatroidAnalysis* matroid() const {
    return kinematics && kinematics->matroid ? &*kinematics->matroid : nullptr;
  }
};

using SnapshotPtr = std::shared_ptr<const AnalysisSnapshot>;

/// The first step: digraph, tree, matrices, and both methods in doubles with exact zeros, rank and freedom.
/// Pure; null when `stop` was requested meanwhile.
/// Cost: near linear in n + t + c and the sum of the cycle lengths.
/// @pre the mechanism is well formed
[[nodiscard]] SnapshotPtr analyzeLive(DerivedGeometryPtr geometry, std::uint64_t revision = 0,
                                      const std::stop_token& stop = {});
/// The same of a mechanism of which nothing has been derived yet.
[[nodiscard]] SnapshotPtr analyzeLive(MechanismPtr mechanism, std::uint64_t revision = 0,
                                      const std::stop_token& stop = {});

/// The diagnostics of the train of a mechanism without errors (DerivedGeometry::diagnostics()). Its share of
/// the second step. None if `stop` was requested meanwhile.
[[nodiscard]] Diagnostics toothFindings(const AnalysisSnapshot& live, const std::stop_token& stop = {});

/// The states of the document solved, and their findings: the same snapshot with them. Null when `stop` was
/// requested meanwhile.
[[nodiscard]] SnapshotPtr analyzeStates(const SnapshotPtr& live, const SolveOptions& options = {},
                                        const std::stop_token& stop = {});

/// The second step: the states, exact fractions by both methods, their agreement, and symbols; what the
/// teeth have to say. The same snapshot with them. Null when `stop` was requested meanwhile.
[[nodiscard]] SnapshotPtr analyzeFully(const SnapshotPtr& live, const SolveOptions& options = {},
                                       const std::stop_token& stop = {});

/// Both steps.
[[nodiscard]] SnapshotPtr analyze(MechanismPtr mechanism, std::uint64_t revision = 0,
                                  const std::stop_token& stop = {}, const SolveOptions& options = {});

}  // namespace geargraph::inline analysis

#pragma once

#include <cstdint>
#include <optional>
#include <stop_token>
#include <vector>

#include "core/foundations/base/diagnostic.h"
#include "core/mechanism/graph/matrices.h"
#include "core/theory/analysis/kinematics.h"
#include "core/theory/states/state_solution.h"

namespace geargraph {
class DerivedGeometry;
using DerivedGeometryPtr = std::shared_ptr<const DerivedGeometry>;
}  // namespace geargraph

namespace geargraph {

/// Everything that is computed from one mechanism: an immutable value that all views read. Matrices are those
/// of the train; freedom, inputs, solutions and motion are those of the train as the document engages its
/// couplings; `states` has the ratios of all states whatever is engaged. A stage that fails leaves its part
/// empty and does not fail the snapshot, so a half-drawn mechanism still has its incidence matrix.
///
/// It is computed in two steps: first the live part, then the exact and symbolic solutions (`solved`). The
/// second step only adds diagnostics to the live part and changes nothing else of it.
struct AnalysisSnapshot {
  std::uint64_t revision = 0;  ///< of the document, as given by the caller
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
  /// The result of the matroid method; null where the mechanism has errors that leave nothing to solve.
  [[nodiscard]] const MatroidAnalysis* matroid() const {
    return kinematics && kinematics->matroid ? &*kinematics->matroid : nullptr;
  }
};

using SnapshotPtr = std::shared_ptr<const AnalysisSnapshot>;

/// The first step: digraph, tree, matrices, and both methods in doubles with exact zeros, rank and freedom.
/// Pure; null if `stop` was requested meanwhile.
/// Cost: near linear in n + t + c and the sum of the cycle lengths.
/// @pre the mechanism is well formed
[[nodiscard]] SnapshotPtr analyzeLive(DerivedGeometryPtr geometry, std::uint64_t revision = 0,
                                      const std::stop_token& stop = {});
/// The same for a mechanism from which no geometry has been derived yet.
[[nodiscard]] SnapshotPtr analyzeLive(MechanismPtr mechanism, std::uint64_t revision = 0,
                                      const std::stop_token& stop = {});

/// The diagnostics of the train of a mechanism without errors (DerivedGeometry::diagnostics()). Part of the
/// second step. Empty if `stop` was requested meanwhile.
[[nodiscard]] Diagnostics geometryDiagnostics(const AnalysisSnapshot& live, const std::stop_token& stop = {});

/// Returns the snapshot with the states of the document solved and their diagnostics added. Null if `stop`
/// was requested meanwhile.
[[nodiscard]] SnapshotPtr analyzeStates(const SnapshotPtr& live, const SolveOptions& options = {},
                                        const std::stop_token& stop = {});

/// The second step: returns the snapshot with the states, the exact solutions by both methods, their
/// agreement, the symbolic solutions and the diagnostics of the teeth added. Null if `stop` was requested
/// meanwhile.
[[nodiscard]] SnapshotPtr analyzeFully(const SnapshotPtr& live, const SolveOptions& options = {},
                                       const std::stop_token& stop = {});

/// Both steps, one after the other. Null if `stop` was requested meanwhile.
[[nodiscard]] SnapshotPtr analyze(MechanismPtr mechanism, std::uint64_t revision = 0,
                                  const std::stop_token& stop = {}, const SolveOptions& options = {});

}  // namespace geargraph

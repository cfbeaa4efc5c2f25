#include "core/analysis/analysis.h"

#include <algorithm>

#include "core/mechanism/validate.h"

namespace geargraph {
namespace {

/// Both methods report what they both meet (an axis that splits, a mesh without a carrier): once is enough.
void addNew(Diagnostics& all, const Diagnostics& more) {
  for (const Diagnostic& diagnostic : more) {
    const bool known = std::any_of(all.begin(), all.end(), [&](const Diagnostic& other) {
      return other.code == diagnostic.code && other.elements == diagnostic.elements;
    });
    if (!known) all.push_back(diagnostic);
  }
}

}  // namespace

SnapshotPtr analyzeLive(MechanismPtr mechanism, std::uint64_t revision, const std::stop_token& stop) {
  auto snapshot = std::make_shared<AnalysisSnapshot>();
  snapshot->revision = revision;
  snapshot->graph = std::make_shared<const Digraph>(*mechanism);
  snapshot->mechanism = std::move(mechanism);
  if (auto tree = SpanningTree::of(*snapshot->graph)) {
    snapshot->tree = std::make_shared<const SpanningTree>(std::move(*tree));
  } else {
    snapshot->diagnostics = treeDiagnostics(*snapshot->mechanism);
  }
  for (const MatrixKind kind : allMatrixKinds()) {
    snapshot->matrices.push_back(matrixOf(kind, snapshot->graph, snapshot->tree));
  }
  if (stop.stop_requested()) return nullptr;
  if (!snapshot->tree) return snapshot;

  snapshot->kinematics = liveKinematics(*snapshot->mechanism, snapshot->graph, snapshot->tree, stop);
  if (!snapshot->kinematics) return nullptr;
  addNew(snapshot->diagnostics, snapshot->kinematics->placement.diagnostics);
  addNew(snapshot->diagnostics, snapshot->kinematics->ttGraph->diagnostics());
  if (const MatroidAnalysis* matroid = snapshot->matroid())
    addNew(snapshot->diagnostics, matroid->diagnostics);
  return snapshot;
}

SnapshotPtr analyzeFully(const SnapshotPtr& live, const SolveOptions& options, const std::stop_token& stop) {
  auto snapshot = std::make_shared<AnalysisSnapshot>(*live);
  snapshot->isComplete = true;
  const MatroidAnalysis* matroid = live->matroid();
  if (matroid == nullptr || !matroid->solution || hasErrors(live->diagnostics)) return snapshot;
  snapshot->solved = solvedKinematics(*live->mechanism, *live->kinematics, options, stop);
  if (!snapshot->solved) return nullptr;
  addNew(snapshot->diagnostics, snapshot->solved->diagnostics);
  return snapshot;
}

SnapshotPtr analyze(MechanismPtr mechanism, std::uint64_t revision, const std::stop_token& stop,
                    const SolveOptions& options) {
  const SnapshotPtr live = analyzeLive(std::move(mechanism), revision, stop);
  return live ? analyzeFully(live, options, stop) : nullptr;
}

}  // namespace geargraph

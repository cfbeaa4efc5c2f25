#include "core/analysis/analysis.h"

#include "core/mechanism/validate.h"

namespace geargraph {

SnapshotPtr analyze(MechanismPtr mechanism, std::uint64_t revision, std::stop_token stop) {
  auto snapshot = std::make_shared<AnalysisSnapshot>();
  snapshot->revision = revision;
  snapshot->graph = std::make_shared<const Digraph>(*mechanism);
  snapshot->diagnostics = treeDiagnostics(*mechanism);
  snapshot->mechanism = std::move(mechanism);
  if (stop.stop_requested()) return nullptr;

  if (auto tree = SpanningTree::of(*snapshot->graph)) {
    snapshot->tree = std::make_shared<const SpanningTree>(std::move(*tree));
  }
  for (const MatrixKind kind : allMatrixKinds()) {
    snapshot->matrices.push_back(matrixOf(kind, snapshot->graph, snapshot->tree));
  }
  if (stop.stop_requested()) return nullptr;
  return snapshot;
}

}  // namespace geargraph

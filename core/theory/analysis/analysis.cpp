#include "core/theory/analysis/analysis.h"

#include <set>
#include <utility>

#include "core/machine/body_layout/derived_geometry.h"
#include "core/mechanism/model/shapes.h"
#include "core/mechanism/model/unknown_members.h"
#include "core/mechanism/model/validate.h"
#include "core/theory/states/engagement.h"

namespace geargraph {
namespace {

/// The placement and the T-T graph both meet axes that split or merge and meshes without a carrier; such a
/// diagnostic is said once, in the words of the T-T graph, whose notions they are.
Diagnostics placementDiagnostics(const Diagnostics& ttGraph, const Diagnostics& placement) {
  std::set<std::pair<Code, ElementId>> said;
  for (const Diagnostic& diagnostic : ttGraph) {
    for (const ElementId& element : diagnostic.elements) said.emplace(diagnostic.code, element);
  }
  Diagnostics all = ttGraph;
  for (const Diagnostic& diagnostic : placement) {
    const bool known =
        !diagnostic.elements.empty() && said.contains({diagnostic.code, diagnostic.elements.front()});
    if (!known) all.push_back(diagnostic);
  }
  return all;
}

/// A clutch between links on different axes is reported once, also where it closes a linkage.
Diagnostics couplingDiagnostics(Diagnostics clutches, const Diagnostics& engagement) {
  std::set<ElementId> said;
  for (const Diagnostic& each : clutches) said.insert(each.elements.front());
  for (const Diagnostic& each : engagement) {
    if (!said.contains(each.elements.front())) clutches.push_back(each);
  }
  return clutches;
}

}  // namespace

SnapshotPtr analyzeLive(DerivedGeometryPtr geometry, std::uint64_t revision, const std::stop_token& stop) {
  auto snapshot = std::make_shared<AnalysisSnapshot>();
  snapshot->revision = revision;
  snapshot->mechanism = geometry->placed().pointer();
  snapshot->geometry = std::move(geometry);
  const PlacedMechanism& placed = snapshot->geometry->placed();
  if (const auto& joints = placed.placement().tree) {
    snapshot->graph = joints->graph;
    snapshot->tree = joints->tree;
  } else {
    snapshot->graph = std::make_shared<const Digraph>(placed);
    snapshot->diagnostics = treeDiagnostics(placed);
  }
  snapshot->matrices.reserve(allMatrixKinds().size());
  for (const MatrixKind kind : allMatrixKinds()) {
    snapshot->matrices.push_back(matrixOf(kind, snapshot->graph, snapshot->tree));
  }
  if (stop.stop_requested()) return nullptr;
  Diagnostics ofDocument = unknownMemberDiagnostics(placed);
  append(ofDocument, shapeDiagnostics(placed));
  if (!snapshot->tree) {
    append(snapshot->diagnostics, ofDocument);
    return snapshot;
  }

  snapshot->kinematics = liveKinematics(placed, stop);
  if (!snapshot->kinematics) return nullptr;
  append(snapshot->diagnostics,
         placementDiagnostics(snapshot->kinematics->ttGraph->diagnostics(), placed.placement().diagnostics));
  append(snapshot->diagnostics, couplingDiagnostics(clutchDiagnostics(placed, placed.placement()),
                                                    snapshot->kinematics->engagement));
  if (const MatroidAnalysis* matroid = snapshot->matroid()) {
    append(snapshot->diagnostics, matroid->diagnostics);
  }
  append(snapshot->diagnostics, ofDocument);
  return snapshot;
}

SnapshotPtr analyzeLive(MechanismPtr mechanism, std::uint64_t revision, const std::stop_token& stop) {
  return analyzeLive(std::make_shared<const DerivedGeometry>(std::move(mechanism)), revision, stop);
}

Diagnostics geometryDiagnostics(const AnalysisSnapshot& live, const std::stop_token& stop) {
  if (!live.kinematics || hasErrors(live.diagnostics)) return {};
  const auto found = live.geometry->diagnostics(stop);
  return found ? *found : Diagnostics{};
}

SnapshotPtr analyzeStates(const SnapshotPtr& live, const SolveOptions& options, const std::stop_token& stop) {
  if (live->mechanism->states.empty() || !live->kinematics || !live->kinematics->model) return live;
  auto states = solveStates(*live->mechanism, *live->kinematics->model, live->kinematics->placement(),
                            options.symbolic, stop);
  if (!states) return nullptr;
  auto snapshot = std::make_shared<AnalysisSnapshot>(*live);
  append(snapshot->diagnostics, stateDiagnostics(*states));
  snapshot->states = std::make_shared<const std::vector<StateSolution>>(std::move(*states));
  return snapshot;
}

SnapshotPtr analyzeFully(const SnapshotPtr& live, const SolveOptions& options, const std::stop_token& stop) {
  const SnapshotPtr withStates = analyzeStates(live, options, stop);
  if (!withStates) return nullptr;
  auto snapshot = std::make_shared<AnalysisSnapshot>(*withStates);
  snapshot->isComplete = true;
  const MatroidAnalysis* matroid = live->matroid();
  if (matroid != nullptr && matroid->solution && !hasErrors(live->diagnostics)) {
    snapshot->solved = solvedKinematics(*live->mechanism, *live->kinematics, options, stop);
    if (!snapshot->solved) return nullptr;
  }
  append(snapshot->diagnostics, geometryDiagnostics(*live, stop));
  if (stop.stop_requested()) return nullptr;
  if (snapshot->solved) append(snapshot->diagnostics, snapshot->solved->diagnostics);
  if (snapshot->solved && snapshot->solved->exact) {
    append(snapshot->diagnostics, freewheelDiagnostics(*live->mechanism, live->kinematics->placement(),
                                                       snapshot->solved->exact->rates));
  }
  sortBySeverity(snapshot->diagnostics);
  return snapshot;
}

SnapshotPtr analyze(MechanismPtr mechanism, std::uint64_t revision, const std::stop_token& stop,
                    const SolveOptions& options) {
  const SnapshotPtr live = analyzeLive(std::move(mechanism), revision, stop);
  return live ? analyzeFully(live, options, stop) : nullptr;
}

}  // namespace geargraph

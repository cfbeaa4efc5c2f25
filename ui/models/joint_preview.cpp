#include "ui/models/joint_preview.h"

#include "core/mechanism/model/edits.h"

namespace geargraph {

std::optional<PreviewSnapshot> previewOf(const Mechanism& mechanism, const JointPreview& preview) {
  if (!preview.valid || preview.head.empty()) return std::nullopt;
  const bool turning = preview.kind == ElementKind::turningJoint;
  Expected<Mechanism> next = turning ? withTurningJoint(mechanism, preview.tail, preview.head)
                                     : withGearMesh(mechanism, preview.tail, preview.head);
  if (!next) return std::nullopt;

  auto snapshot = std::make_shared<AnalysisSnapshot>();
  snapshot->mechanism = std::make_shared<const Mechanism>(std::move(next).value());
  snapshot->graph = std::make_shared<const Digraph>(*snapshot->mechanism);
  if (auto tree = SpanningTree::of(*snapshot->graph)) {
    snapshot->tree = std::make_shared<const SpanningTree>(std::move(*tree));
  }
  for (const MatrixKind kind : allMatrixKinds()) {
    snapshot->matrices.push_back(matrixOf(kind, snapshot->graph, snapshot->tree));
  }
  const Mechanism& with = *snapshot->mechanism;
  const ElementId drawnJoint =
      turning ? ElementId(with.turningJoints.back().id) : ElementId(with.gearMeshes.back().id);
  return PreviewSnapshot{std::move(snapshot), drawnJoint};
}

}  // namespace geargraph

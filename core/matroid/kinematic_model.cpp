#include "core/matroid/kinematic_model.h"

namespace geargraph {

std::optional<KinematicModel> KinematicModel::of(const Mechanism& mechanism, DigraphPtr graph,
                                                 SpanningTreePtr tree, const Placement& placement) {
  if (!graph || !tree || !placement.tree) return std::nullopt;
  for (const auto& mesh : placement.meshes) {
    if (!mesh) return std::nullopt;
  }
  KinematicModel model;
  const AxisClasses& classes = *placement.classes;
  const JointTree& joints = *placement.tree;

  model.m_rates.reserve(joints.joints.size());
  for (std::size_t j = 0; j < joints.joints.size(); ++j) {
    const int child = joints.child[j];
    const int parent = joints.parent[child];
    const int top = classes.classes[classes.classOf[j]].top;
    const int direction = joints.joints[j].tail == parent ? 1 : -1;
    model.m_rates.push_back({child, parent == top ? 0 : parent, direction * classes.sense[j]});
  }

  model.m_rows.reserve(placement.meshes.size());
  for (std::size_t m = 0; m < placement.meshes.size(); ++m) {
    const MeshGeometry& mesh = *placement.meshes[m];
    MeshRow& row = model.m_rows.emplace_back();
    row.tailTeeth = mechanism.gearMeshes[m].tailTeeth;
    row.headTeeth = mechanism.gearMeshes[m].headTeeth;
    const auto add = [&](int link, int axisClass, bool tail, int factor) {
      if (link == classes.classes[axisClass].top) return;
      row.terms[static_cast<std::size_t>(row.size++)] = {link, tail, static_cast<std::int8_t>(factor)};
    };
    add(mesh.tail, mesh.tailClass, true, 1);
    add(mesh.carrier, mesh.tailClass, true, -1);
    add(mesh.head, mesh.headClass, false, -mesh.sign);
    add(mesh.carrier, mesh.headClass, false, mesh.sign);
  }
  model.m_graph = std::move(graph);
  model.m_tree = std::move(tree);
  return model;
}

}  // namespace geargraph

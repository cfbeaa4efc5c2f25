#include "core/theory/matroid/kinematic_model.h"

namespace geargraph::inline matroid {

std::optional<KinematicModel> KinematicModel::of(DigraphPtr graph, SpanningTreePtr tree,
                                                 const Placement& placement) {
  if (!graph || !tree || !placement.tree) return std::nullopt;
  KinematicModel model;
  const AxisClasses& classes = *placement.classes;
  const JointTree& joints = *placement.tree;

  model.m_rates.reserve(joints.joints.size());
  for (std::size_t j = 0; j < joints.joints.size(); ++j) {
    const int child = joints.child[j];
    const int parent = joints.parent[child];
    const int rootLink = classes.classes[classes.classOf[j]].rootLink;
    const int direction = joints.joints[j].tail == parent ? 1 : -1;
    model.m_rates.push_back({child, parent == rootLink ? 0 : parent, direction * classes.orientationSign[j]});
  }

  model.m_rows.reserve(placement.meshes.size());
  for (std::size_t m = 0; m < placement.meshes.size(); ++m) {
    if (!placement.meshes[m]) return std::nullopt;
    const MeshGeometry& mesh = *placement.meshes[m];
    const int tailRoot = classes.classes[mesh.tailClass].rootLink;
    const int headRoot = classes.classes[mesh.headClass].rootLink;
    const auto below = [](int link, int rootLink) { return link == rootLink ? 0 : link; };
    model.m_rows.push_back({{below(mesh.tail, tailRoot), below(mesh.carrier, tailRoot),
                             below(mesh.head, headRoot), below(mesh.carrier, headRoot)},
                            mesh.tailTeeth,
                            mesh.headTeeth,
                            mesh.sign});
  }
  model.m_graph = std::move(graph);
  model.m_tree = std::move(tree);
  return model;
}

}  // namespace geargraph::inline matroid

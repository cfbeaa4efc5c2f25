#include "core/theory/matroid/kinematic_model.h"

namespace geargraph {

std::optional<KinematicModel> KinematicModel::of(DigraphPtr graph, SpanningTreePtr tree,
                                                 const Placement& placement) {
  if (!graph || !tree || !placement.tree) return std::nullopt;
  KinematicModel model;
  const AxisGroups& classes = *placement.classes;
  const JointTree& joints = *placement.tree;

  model.m_rates.reserve(joints.joints.size());
  for (const JointOrdinal j : joints.joints.ordinals()) {
    const LinkOrdinal child = joints.child[j];
    const LinkOrdinal parent = joints.parent[child];
    const LinkOrdinal rootLink = classes.classes[classes.classOf[j]].rootLink;
    const int direction = joints.joints[j].tail == parent ? 1 : -1;
    model.m_rates.push_back(
        {child, parent == rootLink ? LinkOrdinal(0) : parent, direction * classes.orientationSign[j]});
  }

  model.m_rows.reserve(placement.meshes.size());
  for (const MeshOrdinal m : placement.meshes.ordinals()) {
    if (!placement.meshes[m]) return std::nullopt;
    const MeshGeometry& mesh = *placement.meshes[m];
    const LinkOrdinal tailRoot = classes.classes[mesh.tailClass].rootLink;
    const LinkOrdinal headRoot = classes.classes[mesh.headClass].rootLink;
    const auto below = [](LinkOrdinal link, LinkOrdinal rootLink) {
      return link == rootLink ? LinkOrdinal(0) : link;
    };
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

}  // namespace geargraph

#include "core/mechanism/placement/joint_tree.h"

namespace geargraph {

std::optional<JointTree> JointTree::of(const Mechanism& mechanism) {
  auto graph = std::make_shared<const Digraph>(mechanism);
  auto tree = SpanningTree::of(*graph);
  if (!tree) return std::nullopt;
  return JointTree(std::move(graph), std::make_shared<const SpanningTree>(std::move(*tree)));
}

JointTree::JointTree(DigraphPtr ofGraph, SpanningTreePtr ofTree)
    : graph(std::move(ofGraph)),
      tree(std::move(ofTree)),
      joints(graph->turningEdges()),
      meshes(graph->meshEdges()),
      axisOf(graph->axisOf()),
      parent(tree->parents()),
      joint(tree->jointsToParents()),
      child(tree->children()),
      order(tree->preorder()) {}

std::vector<int> JointTree::breadthFirst() const {
  std::vector<int> links{0};
  links.reserve(parent.size());
  for (std::size_t at = 0; at < links.size(); ++at) {
    const LinkOrdinal link = links[at];
    for (const int below : graph->turningEdgesAt(link)) {
      if (below != joint[link]) {
        links.push_back(child[below]);
      }
    }
  }
  return links;
}

}  // namespace geargraph

#include "core/graph/spanning_tree.h"

#include <algorithm>

namespace geargraph {
namespace {

/// The turning edges at every node, in one array (counting sort by node).
struct Adjacency {
  std::vector<int> start;
  std::vector<int> joint;

  explicit Adjacency(const Digraph& graph) : start(static_cast<std::size_t>(graph.nodeCount()) + 1, 0) {
    for (const DigraphEdge& edge : graph.turningEdges()) {
      ++start[static_cast<std::size_t>(edge.tail) + 1];
      ++start[static_cast<std::size_t>(edge.head) + 1];
    }
    for (std::size_t i = 1; i < start.size(); ++i) start[i] += start[i - 1];
    joint.resize(static_cast<std::size_t>(graph.t()) * 2);
    std::vector<int> next = start;
    for (int e = 0; e < graph.t(); ++e) {
      const DigraphEdge& edge = graph.turningEdge(e);
      joint[static_cast<std::size_t>(next[static_cast<std::size_t>(edge.tail)]++)] = e;
      joint[static_cast<std::size_t>(next[static_cast<std::size_t>(edge.head)]++)] = e;
    }
  }

  [[nodiscard]] std::span<const int> at(int node) const {
    const auto i = static_cast<std::size_t>(node);
    return std::span(joint).subspan(static_cast<std::size_t>(start[i]),
                                    static_cast<std::size_t>(start[i + 1] - start[i]));
  }
};

}  // namespace

std::optional<SpanningTree> SpanningTree::of(const Digraph& graph) {
  if (graph.t() != graph.n()) return std::nullopt;
  const auto nodes = static_cast<std::size_t>(graph.nodeCount());
  const auto joints = static_cast<std::size_t>(graph.t());
  const Adjacency adjacency(graph);

  SpanningTree tree;
  tree.m_parent.assign(nodes, -1);
  tree.m_jointToParent.assign(nodes, -1);
  tree.m_depth.assign(nodes, 0);
  tree.m_preorder.assign(nodes, -1);
  tree.m_subtreeEnd.assign(nodes, 0);
  tree.m_child.assign(joints, -1);
  tree.m_towardsGround.assign(joints, 0);
  tree.m_order.reserve(nodes);

  // Depth first with an explicit stack: chains of 100,000 links are legal.
  std::vector<int> stack{0};
  while (!stack.empty()) {
    const int node = stack.back();
    stack.pop_back();
    const auto at = static_cast<std::size_t>(node);
    tree.m_preorder[at] = static_cast<int>(tree.m_order.size());
    tree.m_order.push_back(node);
    const std::span<const int> here = adjacency.at(node);
    for (auto joint = here.rbegin(); joint != here.rend();
         ++joint) {  // so that the first one is walked first
      if (*joint == tree.m_jointToParent[at]) continue;
      const DigraphEdge& edge = graph.turningEdge(*joint);
      const int other = edge.tail == node ? edge.head : edge.tail;
      const auto below = static_cast<std::size_t>(other);
      if (other == 0 || tree.m_parent[below] != -1) return std::nullopt;  // seen before: a loop
      tree.m_parent[below] = node;
      tree.m_jointToParent[below] = *joint;
      tree.m_depth[below] = tree.m_depth[at] + 1;
      tree.m_child[static_cast<std::size_t>(*joint)] = other;
      tree.m_towardsGround[static_cast<std::size_t>(*joint)] = edge.head == node ? 1 : -1;
      stack.push_back(other);
    }
  }
  if (tree.m_order.size() != nodes) return std::nullopt;  // a loose link

  for (std::size_t i = 0; i < nodes; ++i) tree.m_subtreeEnd[i] = tree.m_preorder[i] + 1;
  for (auto node = tree.m_order.rbegin(); node != tree.m_order.rend(); ++node) {
    if (*node == 0) continue;
    const auto at = static_cast<std::size_t>(*node);
    const auto up = static_cast<std::size_t>(tree.m_parent[at]);
    tree.m_subtreeEnd[up] = std::max(tree.m_subtreeEnd[up], tree.m_subtreeEnd[at]);
  }
  return tree;
}

int SpanningTree::commonAncestor(int a, int b) const {
  while (depth(a) > depth(b)) a = parent(a);
  while (depth(b) > depth(a)) b = parent(b);
  while (a != b) {
    a = parent(a);
    b = parent(b);
  }
  return a;
}

std::vector<PathStep> treePath(const SpanningTree& tree, int from, int to) {
  const int meeting = tree.commonAncestor(from, to);
  std::vector<PathStep> path;
  for (int node = from; node != meeting; node = tree.parent(node)) {
    const int joint = tree.jointToParent(node);
    path.push_back({joint, tree.directionToGround(joint)});
  }
  const auto half = static_cast<std::ptrdiff_t>(path.size());
  for (int node = to; node != meeting; node = tree.parent(node)) {
    const int joint = tree.jointToParent(node);
    path.push_back({joint, -tree.directionToGround(joint)});
  }
  std::reverse(path.begin() + half, path.end());
  return path;
}

}  // namespace geargraph

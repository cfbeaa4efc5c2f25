#include "core/graph/spanning_tree.h"

#include <algorithm>

namespace geargraph {
std::optional<SpanningTree> SpanningTree::of(const Digraph& graph) {
  if (graph.t() != graph.n()) return std::nullopt;
  const int nodes = graph.nodeCount();
  SpanningTree tree(nodes);

  // Depth first with an explicit stack: chains of 100,000 links are legal.
  std::vector<int> stack;
  stack.reserve(static_cast<std::size_t>(nodes));
  stack.push_back(0);
  tree.at(Part::depth, 0) = 0;
  int seen = 0;
  while (!stack.empty()) {
    const int node = stack.back();
    stack.pop_back();
    tree.at(Part::preorder, node) = seen;
    tree.at(Part::order, seen++) = node;
    const std::span<const int> here = graph.turningEdgesAt(node);
    for (auto joint = here.rbegin(); joint != here.rend();
         ++joint) {  // so that the first one is walked first
      if (*joint == tree.jointToParent(node)) continue;
      const DigraphEdge& edge = graph.turningEdge(*joint);
      const int other = edge.tail == node ? edge.head : edge.tail;
      if (other == 0 || tree.parent(other) != -1) return std::nullopt;  // seen before: a loop
      tree.at(Part::parent, other) = node;
      tree.at(Part::jointToParent, other) = *joint;
      tree.at(Part::depth, other) = tree.depth(node) + 1;
      tree.at(Part::child, *joint) = other;
      tree.at(Part::towardsGround, *joint) = edge.head == node ? 1 : -1;
      stack.push_back(other);
    }
  }
  if (seen != nodes) return std::nullopt;  // a loose link

  for (int place = nodes; place-- > 0;) {
    const int node = tree.at(Part::order, place);
    int& end = tree.at(Part::subtreeEnd, node);
    end = std::max(end, place + 1);
    if (node == 0) continue;
    int& up = tree.at(Part::subtreeEnd, tree.parent(node));
    up = std::max(up, end);
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

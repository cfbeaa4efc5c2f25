#include "core/mechanism/graph/spanning_tree.h"

#include <algorithm>

namespace geargraph {
namespace {

/// Where a tree keeps its parts, each by node or joint; all of them hold -1 so far.
struct TreeParts {
  int* parent;
  int* jointToParent;
  int* depth;
  int* preorder;
  int* subtreeEnd;
  int* order;
  int* child;
  int* towardsGround;
};

/// Fills all parts but subtreeEnd; false where the turning joints are no spanning tree.
///
/// Depth first with an explicit stack: chains of 100,000 links are legal. A link is either seen or on the
/// stack or neither, so the stack has room at the end of the order that is being written.
bool walk(const Digraph& graph, const TreeParts& tree) {
  const int nodes = graph.nodeCount();
  int stack = nodes;
  tree.order[--stack] = 0;
  tree.depth[0] = 0;
  int seen = 0;
  while (stack < nodes) {
    const LinkOrdinal node = tree.order[stack++];
    tree.order[seen] = node;
    tree.preorder[node] = seen++;
    const std::span<const int> here = graph.turningEdgesAt(node);
    const int up = tree.jointToParent[node];
    for (auto joint = here.rbegin(); joint != here.rend(); ++joint) {  // so that the first is walked first
      if (*joint == up) continue;
      const DigraphEdge& edge = graph.turningEdge(*joint);
      const int other = edge.tail == node ? edge.head : edge.tail;
      if (other == 0 || tree.parent[other] != -1) return false;  // seen before: a loop
      tree.parent[other] = node;
      tree.jointToParent[other] = *joint;
      tree.depth[other] = tree.depth[node] + 1;
      tree.child[*joint] = other;
      tree.towardsGround[*joint] = edge.head == node ? 1 : -1;
      tree.order[--stack] = other;
    }
  }
  return seen == nodes;  // else a link is loose
}

void closeIntervals(int nodes, const TreeParts& tree) {
  for (int place = nodes; place-- > 0;) {
    const LinkOrdinal node = tree.order[place];
    int& end = tree.subtreeEnd[node];
    end = std::max(end, place + 1);
    if (node == 0) continue;
    int& up = tree.subtreeEnd[tree.parent[node]];
    up = std::max(up, end);
  }
}

}  // namespace

std::optional<SpanningTree> SpanningTree::of(const Digraph& graph) {
  if (graph.t() != graph.n()) return std::nullopt;
  SpanningTree tree(graph.nodeCount());
  const auto place = [&tree](Part part) { return &tree.at(part, 0); };
  const TreeParts parts{place(Part::parent),   place(Part::jointToParent), place(Part::depth),
                        place(Part::preorder), place(Part::subtreeEnd),    place(Part::order),
                        place(Part::child),    place(Part::towardsGround)};
  if (!walk(graph, parts)) return std::nullopt;
  closeIntervals(graph.nodeCount(), parts);
  return tree;
}

LinkOrdinal SpanningTree::commonAncestor(LinkOrdinal a, LinkOrdinal b) const {
  while (depth(a) > depth(b)) a = parent(a);
  while (depth(b) > depth(a)) b = parent(b);
  while (a != b) {
    a = parent(a);
    b = parent(b);
  }
  return a;
}

std::vector<PathStep> treePath(const SpanningTree& tree, LinkOrdinal from, LinkOrdinal to) {
  const int meeting = tree.commonAncestor(from, to);
  std::vector<PathStep> path;
  for (LinkOrdinal node = from; node != meeting; node = tree.parent(node)) {
    const JointOrdinal joint = tree.jointToParent(node);
    path.push_back({joint, tree.directionToGround(joint)});
  }
  const auto half = static_cast<std::ptrdiff_t>(path.size());
  for (LinkOrdinal node = to; node != meeting; node = tree.parent(node)) {
    const JointOrdinal joint = tree.jointToParent(node);
    path.push_back({joint, -tree.directionToGround(joint)});
  }
  std::reverse(path.begin() + half, path.end());
  return path;
}

}  // namespace geargraph

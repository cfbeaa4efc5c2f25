#pragma once

#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "core/graph/digraph.h"

namespace geargraph {

/// The spanning tree that the turning joints make, rooted at the ground [AU, Fig. 2: the solid arrows].
///
/// A tree that exists spans: of() gives none where the turning joints close a loop or leave a link loose
/// (treeDiagnostics() of core/mechanism says which and why).
///
/// Ancestry is answered in constant time from preorder intervals: node v lies below joint e exactly if
/// first(e) <= preorder(v) < last(e). So no entry of the path matrix is ever stored.
class SpanningTree {
 public:
  /// Cost: O(n).
  [[nodiscard]] static std::optional<SpanningTree> of(const Digraph& graph);

  [[nodiscard]] int nodeCount() const { return static_cast<int>(m_parent.size()); }

  /// The node next on the walk to the ground, and the turning joint that leads there. @pre node is not the
  /// ground
  [[nodiscard]] int parent(int node) const { return m_parent[static_cast<std::size_t>(node)]; }
  [[nodiscard]] int jointToParent(int node) const { return m_jointToParent[static_cast<std::size_t>(node)]; }
  /// The node of joint e that is farther from the ground.
  [[nodiscard]] int child(int joint) const { return m_child[static_cast<std::size_t>(joint)]; }
  [[nodiscard]] int depth(int node) const { return m_depth[static_cast<std::size_t>(node)]; }

  /// +1 if the walk from the child to the ground runs along the joint in its direction (head nearer the
  /// ground), -1 if against it (the usual case: drawn from parent to child).
  [[nodiscard]] int directionToGround(int joint) const {
    return m_towardsGround[static_cast<std::size_t>(joint)];
  }

  /// Is the joint on the walk from the node to the ground? Cost: O(1).
  [[nodiscard]] bool isOnWalk(int joint, int node) const {
    const auto below = static_cast<std::size_t>(child(joint));
    const int place = m_preorder[static_cast<std::size_t>(node)];
    return m_preorder[below] <= place && place < m_subtreeEnd[below];
  }
  /// Entry Z(e, node) of the path matrix, Eq. (3); 0 for the ground. Cost: O(1).
  [[nodiscard]] int pathEntry(int joint, int node) const {
    return isOnWalk(joint, node) ? directionToGround(joint) : 0;
  }

  /// The node where the walks of two nodes to the ground first meet. Cost: O(depth).
  [[nodiscard]] int commonAncestor(int a, int b) const;

  /// The nodes beyond joint e, seen from the ground, in preorder.
  [[nodiscard]] std::span<const int> below(int joint) const {
    const auto top = static_cast<std::size_t>(child(joint));
    const auto first = static_cast<std::size_t>(m_preorder[top]);
    return std::span(m_order).subspan(first, static_cast<std::size_t>(m_subtreeEnd[top]) - first);
  }

  /// Nodes in preorder, the ground first: every node stands behind its parent.
  [[nodiscard]] std::span<const int> preorder() const { return m_order; }

 private:
  SpanningTree() = default;

  std::vector<int> m_parent;         ///< by node; -1 for the ground
  std::vector<int> m_jointToParent;  ///< by node; -1 for the ground
  std::vector<int> m_depth;          ///< by node
  std::vector<int> m_preorder;       ///< by node: its place in m_order
  std::vector<int> m_subtreeEnd;     ///< by node: the place behind the last node below it
  std::vector<int> m_order;
  std::vector<int> m_child;          ///< by joint
  std::vector<int> m_towardsGround;  ///< by joint: +1 or -1
};

using SpanningTreePtr = std::shared_ptr<const SpanningTree>;

/// One step along a tree walk: a turning joint, and whether the walk runs in the joint's direction (+1) or
/// against.
struct PathStep {
  int joint = 0;
  int direction = 0;
};

/// The walk from one node to another through the tree, in order. Cost: O(its length).
[[nodiscard]] std::vector<PathStep> treePath(const SpanningTree& tree, int from, int to);

}  // namespace geargraph

#pragma once

#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "core/mechanism/graph/digraph.h"

namespace geargraph {

/// The spanning tree of the turning joints, rooted at the ground [AU, Fig. 2: the solid arrows].
///
/// of() returns std::nullopt if the turning joints close a loop or leave a link unconnected
/// (treeDiagnostics() of core/mechanism/model names them).
///
/// Ancestry takes constant time by preorder intervals: node v is below joint e exactly if first(e) <=
/// preorder(v) < last(e). So no entry of the path matrix is stored.
class SpanningTree {
 public:
  /// Cost: O(n).
  [[nodiscard]] static std::optional<SpanningTree> of(const Digraph& graph);

  [[nodiscard]] int nodeCount() const { return m_nodeCount; }

  /// The node next on the walk to the ground, and the turning joint that leads there; -1 for the ground.
  [[nodiscard]] LinkOrdinal parent(LinkOrdinal node) const { return at(Part::parent, node); }
  [[nodiscard]] JointOrdinal jointToParent(LinkOrdinal node) const { return at(Part::jointToParent, node); }
  /// The node of joint e that is farther from the ground.
  [[nodiscard]] LinkOrdinal child(JointOrdinal joint) const { return at(Part::child, joint); }
  [[nodiscard]] int depth(LinkOrdinal node) const { return at(Part::depth, node); }

  /// +1 if the walk from the child to the ground runs along the joint in its direction (head nearer the
  /// ground), -1 if against it (the usual case: drawn from parent to child).
  [[nodiscard]] int directionToGround(JointOrdinal joint) const { return at(Part::towardsGround, joint); }

  /// Is the joint on the walk from the node to the ground? Cost: O(1).
  [[nodiscard]] bool isOnWalk(JointOrdinal joint, LinkOrdinal node) const {
    const LinkOrdinal below = child(joint);
    const int place = at(Part::preorder, node);
    return at(Part::preorder, below) <= place && place < at(Part::subtreeEnd, below);
  }
  /// Entry Z(e, node) of the path matrix, Eq. (3); 0 for the ground. Cost: O(1).
  [[nodiscard]] int pathEntry(JointOrdinal joint, LinkOrdinal node) const {
    return isOnWalk(joint, node) ? directionToGround(joint) : 0;
  }

  /// The lowest common ancestor of two nodes. Cost: O(depth).
  [[nodiscard]] LinkOrdinal commonAncestor(LinkOrdinal a, LinkOrdinal b) const;

  /// The nodes beyond joint e, seen from the ground, in preorder.
  [[nodiscard]] std::span<const int> below(JointOrdinal joint) const {
    const LinkOrdinal top = child(joint);
    const int first = at(Part::preorder, top);
    return preorder().subspan(static_cast<std::size_t>(first),
                              static_cast<std::size_t>(at(Part::subtreeEnd, top) - first));
  }

  /// Nodes in preorder, the ground first: every node comes after its parent.
  [[nodiscard]] std::span<const int> preorder() const { return part(Part::order); }
  /// parent(), jointToParent() and child() as arrays.
  [[nodiscard]] SpanByLink<const int> parents() const { return SpanByLink<const int>(part(Part::parent)); }
  [[nodiscard]] SpanByLink<const int> jointsToParents() const {
    return SpanByLink<const int>(part(Part::jointToParent));
  }
  [[nodiscard]] SpanByJoint<const int> children() const {
    return SpanByJoint<const int>(part(Part::child).first(static_cast<std::size_t>(m_nodeCount) - 1));
  }

 private:
  /// The parts of m_numbers, each by node or joint, one after the other.
  enum class Part { parent, jointToParent, depth, preorder, subtreeEnd, order, child, towardsGround };
  static constexpr int kParts = 8;

  explicit SpanningTree(int nodeCount)
      : m_nodeCount(nodeCount), m_numbers(static_cast<std::size_t>(nodeCount) * kParts, -1) {}

  [[nodiscard]] std::span<const int> part(Part of) const {
    const auto size = static_cast<std::size_t>(m_nodeCount);
    return std::span(m_numbers).subspan(static_cast<std::size_t>(of) * size, size);
  }
  [[nodiscard]] std::size_t place(Part of, int index) const {
    return static_cast<std::size_t>(of) * static_cast<std::size_t>(m_nodeCount) +
           static_cast<std::size_t>(index);
  }
  [[nodiscard]] int at(Part of, int index) const { return m_numbers[place(of, index)]; }
  int& at(Part of, int index) { return m_numbers[place(of, index)]; }

  int m_nodeCount = 0;
  std::vector<int> m_numbers;
};

using SpanningTreePtr = std::shared_ptr<const SpanningTree>;

/// One step along a tree walk: a turning joint, and whether the walk runs in the joint's direction (+1) or
/// against.
struct PathStep {
  JointOrdinal joint = 0;
  int direction = 0;
};

/// The walk from one node to another through the tree, in order. Cost: O(its length).
[[nodiscard]] std::vector<PathStep> treePath(const SpanningTree& tree, LinkOrdinal from, LinkOrdinal to);

}  // namespace geargraph

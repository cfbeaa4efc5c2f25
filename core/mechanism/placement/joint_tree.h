#pragma once

#include <optional>
#include <span>
#include <vector>

#include "core/mechanism/graph/spanning_tree.h"

namespace geargraph {

/// The tree of the turning joints, by positions in the document's lists, rooted at the ground: Digraph and
/// SpanningTree as arrays. A value; copies share the two.
struct JointTree {
  /// std::nullopt if the turning joints are no spanning tree. Cost: O(n + t + c).
  /// @pre the mechanism is well formed
  [[nodiscard]] static std::optional<JointTree> of(const Mechanism& mechanism);

  JointTree(DigraphPtr ofGraph, SpanningTreePtr ofTree);

  /// The links level by level, the ground first. Cost: O(n).
  [[nodiscard]] std::vector<int> breadthFirst() const;

  DigraphPtr graph;
  SpanningTreePtr tree;
  SpanByJoint<const DigraphEdge> joints;
  SpanByMesh<const DigraphEdge> meshes;
  SpanByJoint<const int> axisOf;
  SpanByLink<const int> parent;  ///< the next towards the ground; -1 for the ground
  SpanByLink<const int> joint;   ///< the joint to the parent; -1 for the ground
  SpanByJoint<const int> child;  ///< its link farther from the ground
  std::span<const int> order;    ///< links, each after its parent
};

}  // namespace geargraph

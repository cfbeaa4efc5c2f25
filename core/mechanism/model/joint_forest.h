#pragma once

#include <utility>
#include <vector>

#include "core/mechanism/model/mechanism.h"

namespace geargraph {

/// The links by position as a rooted forest of turning joints; a joint that closes a loop is left out.
class JointForest {
 public:
  /// Cost: O(n + t).
  explicit JointForest(const Mechanism& mechanism);

  /// The joints (positions) between two links, from `from` to `to`; empty if they are not connected.
  [[nodiscard]] std::vector<int> path(int from, int to) const;
  /// The joint on which a link is carried, -1 for the root of a tree.
  [[nodiscard]] int carryingJoint(int link) const { return m_joint[static_cast<std::size_t>(link)]; }

 private:
  [[nodiscard]] int depth(int link) const { return m_depth[static_cast<std::size_t>(link)]; }
  void hangOn(int root, const std::vector<std::vector<std::pair<int, int>>>& edges);

  std::vector<int> m_parent;
  std::vector<int> m_joint;
  std::vector<int> m_depth;
};

}  // namespace geargraph

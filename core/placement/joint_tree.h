#pragma once

#include <optional>
#include <vector>

#include "core/mechanism/mechanism.h"

namespace geargraph {

/// The tree that the turning joints make, by positions in the document's lists, rooted at the ground.
struct JointTree {
  struct Ends {
    int tail = 0;
    int head = 0;
  };
  std::vector<Ends> joints;  ///< link positions
  std::vector<Ends> meshes;
  std::vector<int> axisOf;       ///< by joint: position of its axis
  std::vector<int> parent;       ///< by link: the next towards the ground; -1 for the ground
  std::vector<int> joint;        ///< by link: the joint to the parent; -1 for the ground
  std::vector<int> child;        ///< by joint: its link farther from the ground
  std::vector<int> aroundStart;  ///< by link, and one behind: where its joints begin in `around`
  std::vector<int> around;       ///< the joints at every link
  std::vector<int> order;        ///< links, every one behind its parent

  /// Nothing where the turning joints are no spanning tree. Cost: O(n + t + c).
  /// @pre the mechanism is well formed
  [[nodiscard]] static std::optional<JointTree> of(const Mechanism& mechanism);
};

}  // namespace geargraph

#pragma once

#include <optional>
#include <vector>

#include "core/base/diagnostic.h"
#include "core/placement/axis_classes.h"

namespace geargraph {

/// The path of a mesh through the tree, as a word of axis classes; a proper one is A..A B..B.
struct MeshWord {
  int tailClass = 0;  ///< A, the axis of the tail's gear
  int headClass = 0;  ///< B
  int carrier = 0;    ///< the link where A changes to B: the transfer vertex
};

/// The classes along the path from link `tail` to link `head`, each once a stretch, and the link behind each.
/// Cost: O(axis classes on the path), whatever its length in joints.
struct ClassPath {
  std::vector<int> classes;
  std::vector<int> changes;  ///< changes[i]: the link between classes[i] and classes[i+1]
  ClassPath(const AxisClasses& classes, const JointTree& tree, int tail, int head);
};

/// Nothing, and coaxial-mesh or no-transfer-vertex among the diagnostics, where the word is not proper.
[[nodiscard]] std::optional<MeshWord> meshWord(const Mechanism& mechanism, const AxisClasses& classes,
                                               const JointTree& tree, int mesh, Diagnostics& diagnostics);

}  // namespace geargraph

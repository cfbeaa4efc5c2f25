#pragma once

#include <optional>
#include <vector>

#include "core/foundations/base/diagnostic.h"
#include "core/mechanism/placement/axis_classes.h"

namespace geargraph::inline placement {

/// The path of a mesh through the tree as a word over axis classes: a proper one is A..A B..B.
struct MeshWord {
  int tailClass = 0;  ///< A, the axis of the tail's gear
  int headClass = 0;  ///< B
  int carrier = 0;    ///< the link where A changes to B: the transfer vertex
};

/// The path from one link to another as axis classes. Reused from mesh to mesh to save allocations.
class ClassPath {
 public:
  /// Cost: O(axis classes on the path), whatever its length in joints.
  void walk(const AxisClasses& classes, int tail, int head);

  [[nodiscard]] const std::vector<int>& classes() const { return m_classes; }  ///< without repetition
  /// The link between classes i and i + 1.
  [[nodiscard]] int change(std::size_t i) const { return m_changes[i]; }

 private:
  void climb(const AxisClasses& classes, int& link, std::vector<int>& word, std::vector<int>& links);

  std::vector<int> m_classes;
  std::vector<int> m_changes;
  std::vector<int> m_headClasses;  ///< climbed from the head, to be reversed
  std::vector<int> m_headChanges;
};

/// std::nullopt, with coaxial-mesh or no-transfer-vertex, if the word is not proper.
[[nodiscard]] std::optional<MeshWord> meshWord(const Mechanism& mechanism, const AxisClasses& classes,
                                               const JointTree& tree, int mesh, ClassPath& path,
                                               Diagnostics& diagnostics);

}  // namespace geargraph::inline placement

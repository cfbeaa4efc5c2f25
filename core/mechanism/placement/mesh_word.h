#pragma once

#include <optional>
#include <vector>

#include "core/foundations/base/diagnostic.h"
#include "core/mechanism/placement/axis_classes.h"

namespace geargraph {

/// The path of a mesh through the tree as a word over axis classes: a proper one is A..A B..B.
struct MeshAxisPath {
  AxisGroupOrdinal tailClass = 0;  ///< A, the axis of the tail's gear
  AxisGroupOrdinal headClass = 0;  ///< B
  LinkOrdinal carrier = 0;         ///< the link where A changes to B: the transfer vertex
};

/// The path from one link to another as axis classes. Reused from mesh to mesh to save allocations.
class AxisGroupPath {
 public:
  /// Cost: O(axis classes on the path), whatever its length in joints.
  void walk(const AxisGroups& classes, LinkOrdinal tail, LinkOrdinal head);

  /// Without repetition.
  [[nodiscard]] const std::vector<AxisGroupOrdinal>& classes() const { return m_classes; }
  /// The link between classes i and i + 1.
  [[nodiscard]] LinkOrdinal change(std::size_t i) const { return m_changes[i]; }

 private:
  void climb(const AxisGroups& classes, LinkOrdinal& link, std::vector<AxisGroupOrdinal>& word,
             std::vector<LinkOrdinal>& links);

  std::vector<AxisGroupOrdinal> m_classes;
  std::vector<LinkOrdinal> m_changes;
  std::vector<AxisGroupOrdinal> m_headClasses;  ///< climbed from the head, to be reversed
  std::vector<LinkOrdinal> m_headChanges;
};

/// std::nullopt, with coaxial-mesh or no-transfer-vertex, if the word is not proper.
[[nodiscard]] std::optional<MeshAxisPath> meshWord(const Mechanism& mechanism, const AxisGroups& classes,
                                                   const JointTree& tree, MeshOrdinal mesh,
                                                   AxisGroupPath& path, Diagnostics& diagnostics);

}  // namespace geargraph

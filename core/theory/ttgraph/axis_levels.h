#pragma once

#include <map>
#include <set>
#include <string>
#include <vector>

#include "core/foundations/base/diagnostic.h"
#include "core/mechanism/graph/digraph.h"
#include "core/theory/ttgraph/reference_lines.h"

namespace geargraph {

/// The turning joints that stay coaxial in every motion, and so the levels of the T-T graph: the letters on
/// its tree branches [AU, Fig. 5].
///
/// Two joints are on one level if they share a link and are collinear in the drawn pose, or through others
/// that are. Lines are never compared across the mechanism: axes 1 and 3 of a robot wrist coincide in the
/// drawn pose and are two axes. Where the user has given an axis no line, its id in the document decides.
/// Sliding joints are on one level if they share a link and slide in parallel; none turns.
struct AxisLevels {
  /// The axis of the level's first joint, which gives the level its direction.
  struct Axis {
    int position = 0;  ///< in the document
    AxisId id;
    JointKind kind = JointKind::turning;  ///< of its joints
  };

  ByJoint<int> ofJoint;    ///< its level
  std::vector<Axis> axes;  ///< by level
  std::set<int> reversed;  ///< joints whose axes point against their levels
  /// By level: its name where it is not the id: primes distinguish the levels that one axis splits into.
  std::map<int, std::string> primedNames;
  Diagnostics diagnostics;  ///< split-axis, merged-axes

  [[nodiscard]] int count() const { return static_cast<int>(axes.size()); }
  /// The position of the level's axis in the document.
  [[nodiscard]] int axisOf(int level) const { return axes[static_cast<std::size_t>(level)].position; }
  [[nodiscard]] bool isSliding(int level) const {
    return axes[static_cast<std::size_t>(level)].kind == JointKind::sliding;
  }
  /// +1 if the joint's axis points as its level does, else -1.
  [[nodiscard]] int orientationSign(JointOrdinal joint) const {
    return !reversed.empty() && reversed.contains(joint) ? -1 : 1;
  }
  [[nodiscard]] const std::string& name(int level) const {
    const auto primed = primedNames.find(level);
    return primed != primedNames.end() ? primed->second : axes[static_cast<std::size_t>(level)].id.text();
  }
  [[nodiscard]] const std::string& levelOf(JointOrdinal joint) const { return name(ofJoint[joint]); }
};

/// Cost: O(t log t) if the lines differ.
/// @pre `graph` is the mechanism's, `lines` are of its placement or empty
[[nodiscard]] AxisLevels axisLevels(const Mechanism& mechanism, const Digraph& graph,
                                    const ReferenceLines& lines);

}  // namespace geargraph

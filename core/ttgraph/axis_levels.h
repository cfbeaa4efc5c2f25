#pragma once

#include <map>
#include <string>
#include <vector>

#include "core/base/diagnostic.h"
#include "core/graph/digraph.h"
#include "core/ttgraph/reference_lines.h"

namespace geargraph {

/// The turning joints that stay coaxial in every motion, and so the levels of the T-T graph: the letters on
/// its tree branches [AU, Fig. 5].
///
/// Two joints are on one level if they share a link and are collinear in the drawn pose, or through others
/// that are. Lines are never compared across the mechanism: axes 1 and 3 of a robot wrist coincide in the
/// drawn pose and are two axes. Where an axis has no line of its author's, its id in the document decides.
struct AxisLevels {
  std::vector<int> ofJoint;     ///< by turning joint: its level
  std::vector<int> sense;       ///< by turning joint: +1 if its axis points as the level does, else -1
  std::vector<int> firstJoint;  ///< by level: its first joint, whose axis gives the level its direction
  std::vector<int> axis;        ///< by level: the position of that axis in the document
  std::vector<AxisId> axisIds;  ///< by level: the id of that axis
  /// By level: its name where it is not the id, because primes tell apart what an axis splits into.
  std::map<int, std::string> primedNames;
  Diagnostics diagnostics;  ///< split-axis, merged-axes

  [[nodiscard]] int count() const { return static_cast<int>(firstJoint.size()); }
  [[nodiscard]] const std::string& name(int level) const {
    const auto primed = primedNames.find(level);
    return primed != primedNames.end() ? primed->second : axisIds[static_cast<std::size_t>(level)].text();
  }
  [[nodiscard]] const std::string& levelOf(int joint) const {
    return name(ofJoint[static_cast<std::size_t>(joint)]);
  }
};

/// Cost: O(t log t), for lines that are not all alike.
/// @pre `graph` is the mechanism's, `lines` its own or nothing
[[nodiscard]] AxisLevels axisLevels(const Mechanism& mechanism, const Digraph& graph,
                                    const ReferenceLines& lines);

}  // namespace geargraph

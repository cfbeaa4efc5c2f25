#pragma once

#include <span>
#include <vector>

#include "core/foundations/base/diagnostic.h"
#include "core/mechanism/placement/axis_line.h"
#include "core/mechanism/placement/joint_tree.h"

namespace geargraph::inline placement {

/// Joints that stay coaxial in every motion, because they lie on one line and hang together by shared links.
/// Lines are never compared across the mechanism: axes 1 and 3 of a robot's wrist coincide in the drawn pose
/// only.
///
/// The links of a class are its top (nearest the ground) and all links whose joint towards the ground is in
/// it; so two classes share one link at most, and that link carries a mesh between them.
struct AxisClasses {
  struct Class {
    int joint = 0;  ///< the first of the document's order: its axis is the class's line, its sense counts
    int axis = 0;   ///< that joint's axis
    int top = 0;    ///< the link nearest the ground
    int depth = 0;  ///< classes between the top and the ground
  };

  std::vector<Class> classes;  ///< in the order of their first joints
  std::vector<int> classOf;    ///< by joint
  std::vector<int> sense;      ///< by joint: +1 where its axis points as the class's line does, -1 against it
  std::vector<int> ofLink;     ///< by link: the class of its joint towards the ground; -1 for the ground

  /// By links of one axis name, then by lines of different names that coincide at a shared link:
  /// `merged-axes`; joints of one name in several classes: `split-axis`. Cost: O(n) but for joints that share
  /// a link and a line.
  /// `lines`: givenLines() of the mechanism.
  AxisClasses(const Mechanism& mechanism, const JointTree& tree, std::span<const AxisLine> lines,
              Diagnostics& diagnostics);
  /// Of a mechanism without a tree: none.
  AxisClasses() = default;

  [[nodiscard]] int classOfLink(int link) const { return ofLink[static_cast<std::size_t>(link)]; }
};

}  // namespace geargraph::inline placement

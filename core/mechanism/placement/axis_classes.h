#pragma once

#include <span>
#include <vector>

#include "core/foundations/base/diagnostic.h"
#include "core/mechanism/placement/axis_line.h"
#include "core/mechanism/placement/joint_tree.h"

namespace geargraph {

/// The axis classes: turning joints that stay coaxial in every motion, because they are on one line and are
/// connected by shared links; and sliding joints that stay parallel, because they are so and are connected by
/// shared links. A class has joints of one kind. Lines are never compared across the mechanism: axes 1 and 3
/// of a robot's wrist coincide in the drawn pose only.
///
/// The links of a class are its root link (`rootLink`, nearest the ground) and all links whose joint towards
/// the ground is in the class; so two classes share at most one link, which carries a mesh between them.
struct AxisGroups {
  struct Class {
    JointOrdinal joint = 0;    ///< the first in the document's order: gives the class's line, orientation
    AxisOrdinal axis = 0;      ///< that joint's axis
    LinkOrdinal rootLink = 0;  ///< the root link: the one nearest the ground
    JointKind kind = JointKind::turning;
    int depth = 0;  ///< number of classes between the root link and the ground
  };

  ByClass<Class> classes;  ///< in the order of their first joints
  ByJoint<AxisGroupOrdinal> classOf;
  ByJoint<int> orientationSign;     ///< +1 if its axis points along the class's line, else -1
  ByLink<AxisGroupOrdinal> ofLink;  ///< the class of its joint towards the ground; -1 for the ground

  /// Joints of one axis that share a link are in one class; so are joints of different axes that share a link
  /// and whose lines coincide (diagnostic `merged-axes`). Joints of one axis in several classes:
  /// `split-axis`. `lines`: givenLines() of the mechanism. Cost: O(n), more for joints that share a link and
  /// a line.
  AxisGroups(const Mechanism& mechanism, const JointTree& tree, const ByAxis<AxisLine>& lines,
             Diagnostics& diagnostics);
  /// No classes, for a mechanism without a tree.
  AxisGroups() = default;

  [[nodiscard]] AxisGroupOrdinal classOfLink(LinkOrdinal link) const { return ofLink[link]; }
};

}  // namespace geargraph

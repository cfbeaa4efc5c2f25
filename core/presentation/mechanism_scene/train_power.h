#pragma once

#include <algorithm>
#include <memory>
#include <optional>
#include <vector>

#include "core/mechanism/placement/placement.h"
#include "core/presentation/diagrams/power_picture.h"
#include "core/presentation/drawing/palette.h"
#include "core/presentation/scene3d/stage.h"

namespace geargraph {

/// An arrow along the path of power through the solids. It belongs to the reference pose, and moves with a
/// link.
struct PowerArrow {
  ElementId element;                   ///< the mesh, joint or coupling; the link of a load or a balance on it
  Eigen::Vector3d from{0, 0, 0};       ///< at the scene's own poses, mm, base frame
  Eigen::Vector3d to{0, 0, 0};         ///< its tip
  std::optional<ElementId> movesWith;  ///< a link; none: the ground
  std::optional<int>
      giver;  ///< label of the link that the power leaves; none: it comes out of a mesh or from outside
  std::optional<int>
      taker;               ///< label of the link that it enters; none: it goes into a mesh or to the outside
  Tint tint;               ///< that of the bands
  double given = 0;        ///< W, taken from the giver, at least 0
  double delivered = 0;    ///< W, to the taker: less where a mesh loses some
  double circulating = 0;  ///< the part that goes round in a loop, W
  double lost = 0;         ///< W, in the mesh; on one arrow of each
  bool isKnown = true;     ///< else shared in unknown parts
  bool isAssumed = false;  ///< known by equal stiffness only

  [[nodiscard]] double power() const { return std::max(given, delivered); }
};

/// Where the power of a train goes, in three dimensions.
struct ScenePower {
  PowerPicture picture;
  std::vector<PowerArrow> arrows;
  [[nodiscard]] double largest() const;  ///< W
};
using ScenePowerPtr = std::shared_ptr<const ScenePower>;

/// The flows that bands show (power_drawing.h) as arrows. At the pitch point of a mesh: from the gear that
/// drives to the gear that is driven; what its carrier takes or gives, square to that. At a joint whose links
/// exchange power, and at an engaged coupling: along the axis towards the part that takes it. Where power
/// enters or leaves the train: along the axis into the end of the link, or out of it.
/// At every link the arrows deliver what they take, where all of them are known.
/// Cost: O(flows + instances) times the ends on one axis. @pre all of one mechanism; there is a tree
[[nodiscard]] ScenePower stagePower(PowerPicture picture, const Mechanism& mechanism,
                                    const Placement& placement, const MechanismScene& stage);

}  // namespace geargraph

#pragma once

#include <array>

#include "core/presentation/scene3d/label_anchors.h"
#include "core/presentation/scene3d/scene_forces.h"

namespace geargraph {

/// The arrow of a force in the picture, in logical pixels: a line from `from` to `neck`, and a filled
/// triangle. An arrow along the line of sight, which would be shorter than its head, is a disc around `from`
/// instead.
struct ForceArrowShape {
  Eigen::Vector2d from{0, 0};
  Eigen::Vector2d neck{0, 0};
  std::array<Eigen::Vector2d, 3> head;
  bool isDisc = false;
};

constexpr double kForceShaft = 2.8;   ///< width, px
constexpr double kForceCasing = 1.4;  ///< px on each side of shaft, head and disc, in the sheet's colour
constexpr double kForceDisc = 4.5;    ///< radius, px

/// Arrows are painted over the solids, because most begin inside one.
[[nodiscard]] ForceArrowShape forceArrowShape(const ForceArrow& arrow, const LabelGround& ground);

}  // namespace geargraph

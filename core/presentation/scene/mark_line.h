#pragma once

#include <vector>

#include "core/presentation/scene/scene.h"

namespace geargraph {

/// A line in space that is no part of a solid: a pitch circle, an axis, an arrow, a traced path. Its width is
/// constant in the picture.
struct MarkLine {
  std::vector<Eigen::Vector3d> points;  ///< mm, world; two or more
  Rgb colour;
  float width = 1.6F;  ///< logical pixels
  bool dashed = false;
};

}  // namespace geargraph

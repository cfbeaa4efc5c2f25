#pragma once

#include <span>
#include <vector>

#include "core/presentation/painting/camera.h"
#include "core/presentation/painting/gl_objects.h"
#include "core/presentation/painting/mark_line.h"

namespace geargraph::inline painting {

/// The lines as triangles in device pixels, with depths that solids can be compared with. What is behind the
/// eye is cut off. Cost: O(points), and of a dashed line O(dashes).
[[nodiscard]] std::vector<OverlayVertex> markTriangles(std::span<const MarkLine> lines,
                                                       const Eigen::Matrix4d& clip, const Viewport& viewport,
                                                       double pixelRatio);

}  // namespace geargraph::inline painting

#pragma once

#include <span>
#include <vector>

#include "core/presentation/gl_renderer/gl_objects.h"
#include "core/presentation/scene/camera.h"
#include "core/presentation/scene/mark_line.h"

namespace geargraph {

/// The lines as triangles in device pixels, with depths for the depth test. Parts behind the eye are clipped.
/// Cost: O(points), for a dashed line O(dashes).
[[nodiscard]] std::vector<OverlayVertex> markTriangles(std::span<const MarkLine> lines,
                                                       const Eigen::Matrix4d& clip, const Viewport& viewport,
                                                       double pixelRatio);

}  // namespace geargraph

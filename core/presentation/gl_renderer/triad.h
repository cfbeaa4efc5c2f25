#pragma once

#include <vector>

#include "core/presentation/gl_renderer/gl_objects.h"
#include "core/presentation/scene/camera.h"
#include "core/presentation/scene/render_style.h"

namespace geargraph {

/// The axis triad in the lower left corner: x red, y green, z blue, each with its letter, the nearest on top.
/// Triangles in device pixels.
[[nodiscard]] std::vector<OverlayVertex> axisTriad(const Camera& camera, const Viewport& viewport,
                                                   double pixelRatio, const RenderStyle& style);

}  // namespace geargraph

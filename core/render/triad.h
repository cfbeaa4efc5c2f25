#pragma once

#include <vector>

#include "core/render/camera.h"
#include "core/render/gl_objects.h"
#include "core/render/look.h"

namespace geargraph {

/// The axis triad in the lower left corner: x red, y green, z blue, each with its letter, the nearest on top.
/// Triangles in device pixels.
[[nodiscard]] std::vector<OverlayVertex> axisTriad(const Camera& camera, const Viewport& viewport,
                                                   double pixelRatio, const Look& look);

}  // namespace geargraph

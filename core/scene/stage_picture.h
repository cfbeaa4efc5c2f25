#pragma once

#include <optional>

#include "core/base/expected.h"
#include "core/drawing/palette.h"
#include "core/render/camera.h"
#include "core/render/image.h"
#include "core/render/stage.h"

namespace geargraph {

/// Sides of a picture in pixels.
constexpr int kLeastPictureSide = 16;
constexpr int kMostPictureSide = 8192;

struct PictureOptions {
  Viewport size{1600, 1000};
  std::optional<StandardView> from;  ///< none: from where the 3D view opens
  double time = 0;                   ///< s: the inputs run at their speeds from 0
  Theme theme = Theme::light;
  bool transparent = false;
};

/// A picture of the stage, all of it in view, as the 3D view shows it; with no display.
/// Fails with `graphics` where nothing can paint, or the driver paints no picture so large.
/// Cost: a context and shaders a call, then one frame.
[[nodiscard]] Expected<Image> stagePicture(const Stage& stage, const PictureOptions& options);

}  // namespace geargraph

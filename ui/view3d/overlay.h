#pragma once

#include "core/render/image.h"
#include "ui/view3d/label_layer.h"
#include "ui/view3d/viewer.h"

class QPainter;

namespace geargraph {

/// What an overlay lies over. It refers to what it was made of.
struct OverlayGround {
  const Stage& stage;
  std::span<const Pose> poses;
  std::span<const Showing> showing;
  const Camera& camera;
  Viewport viewport;
  double pixelRatio = 1;
  double barFromBelow = 52;  ///< logical pixels; room for the playback bar
};

/// What lies over the picture of the solids, the same in every canvas and file: the labels, and the scale
/// bar, which holds at the depth of the view's middle.
void paintOverlay(QPainter& painter, const OverlayGround& ground, LabelLayer& labels, bool scaleBar,
                  bool dark);
void paintOverlay(QPainter& painter, const Viewer& viewer, LabelLayer& labels, bool dark);

/// The labels of these options over a picture in a file. Any thread may call it.
void paintOverlay(Image& image, const OverlayGround& ground, const ViewOptions& options, bool dark);

}  // namespace geargraph

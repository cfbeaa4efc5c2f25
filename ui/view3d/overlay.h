#pragma once

#include "ui/view3d/label_layer.h"
#include "ui/view3d/viewer.h"

class QPainter;

namespace geargraph {

/// A length that reads well (1, 2 or 5 times a power of ten) and takes at most `most` pixels of the picture.
/// @pre both positive
[[nodiscard]] double niceLength(double millimetresPerPixel, double most);

/// What lies over the picture of the solids, the same in every canvas: the labels, and the scale bar, which
/// holds at the depth of the view's middle.
void paintOverlay(QPainter& painter, const Viewer& viewer, LabelLayer& labels, bool dark);

}  // namespace geargraph

#pragma once

#include "core/presentation/scene/image.h"
#include "core/presentation/scene3d/scene_forces.h"
#include "ui/view3d/label_layer.h"
#include "ui/view3d/view_options.h"

class QPainter;

namespace geargraph {

/// The forces shown as arrows, for their labels and legend.
struct ShownForces {
  SceneForces forces;
  std::vector<ForceArrow> arrows;
  std::set<ElementId> highlighted;  ///< highlighted elements, whose forces are always labelled
  QString caption;                  ///< why some or all are not drawn; empty if all are
  /// Something else with labels is painted over the view: only highlighted forces are labelled.
  bool areLabelsShared = false;
};

/// Paints the overlay of a rendered picture, identical in every canvas and file: the labels, and the scale
/// bar, which is valid at the depth of the view's centre. `ground` describes the picture, with a map of its
/// visible parts if one was made.
void paintOverlay(QPainter& painter, const LabelGround& ground, LabelLayer& labels, bool scaleBar, bool dark,
                  const ShownForces& forces = {});

/// The lower edge of the legend and the caption of forces as the painter paints them, in its logical pixels;
/// without any, where they would begin.
[[nodiscard]] double bottomOfForceLegend(const QPainter& painter, const LabelGround& ground,
                                         const ShownForces& shown);

/// Paints the overlay of these options on the frames of an animation, in order. May be used by any one thread
/// at a time.
class PictureOverlay {
 public:
  PictureOverlay(const ViewOptions& options, bool dark);
  /// @pre the ground has a map
  void paint(Image& image, const LabelGround& ground, const ShownForces& forces = {});

 private:
  bool m_scaleBar;
  bool m_dark;
  LabelLayer m_labels;
};

}  // namespace geargraph

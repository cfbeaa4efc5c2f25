#pragma once

#include "core/presentation/painting/image.h"
#include "core/presentation/stage/stage_forces.h"
#include "ui/view3d/label_layer.h"
#include "ui/view3d/view_options.h"

class QPainter;

namespace geargraph::inline view3d {

/// The forces that a picture shows as arrows, for their labels and their legend.
struct ShownForces {
  StageForces forces;
  std::vector<ForceArrow> arrows;
  std::set<ElementId> lit;  ///< elements whose forces have labels in any case
  QString caption;          ///< why some are not drawn, or all; empty where all are
};

/// What lies over the picture of the solids, the same in every canvas and file: the labels, and the scale
/// bar, which holds at the depth of the view's middle. The ground is that of the picture, with a map of it
/// where one was made.
void paintOverlay(QPainter& painter, const LabelGround& ground, LabelLayer& labels, bool scaleBar, bool dark,
                  const ShownForces& forces = {});

/// Below the legend and the caption of forces, which the painter has painted; where they begin without any.
[[nodiscard]] double bottomOfForceLegend(const QPainter& painter, const LabelGround& ground,
                                         const ShownForces& shown);

/// The labels of these options over the pictures of a film, one after the other. Any one thread may use it.
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

}  // namespace geargraph::inline view3d

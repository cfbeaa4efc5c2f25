#pragma once

#include <optional>

#include "core/presentation/scene/render_style.h"
#include "core/presentation/scene3d/scene_view.h"

namespace geargraph {

/// The display options of the 3D view; not part of the document.
struct ViewOptions {
  Faces faces = Faces::shaded;
  std::optional<SectionChoice> section;
  double explosion = 0;            ///< amount of the exploded view, 0..1
  bool translucentOthers = false;  ///< makes links that are not selected translucent while any is
  bool linkLabels = true;
  bool jointLabels = false;
  bool axisLabels = false;
  bool scaleBar = true;
  MarkChoice marks;
  friend bool operator==(const ViewOptions&, const ViewOptions&) = default;
};

}  // namespace geargraph

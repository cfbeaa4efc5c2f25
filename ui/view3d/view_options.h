#pragma once

#include <optional>

#include "core/presentation/painting/look.h"
#include "core/presentation/stage/stage_view.h"

namespace geargraph::inline view3d {

/// What the 3D view shows of its stage, and how. A value; nothing of it belongs to the document.
struct ViewOptions {
  Faces faces = Faces::shaded;
  std::optional<SectionChoice> section;
  double pulledApart = 0;    ///< 0..1: the exploded view
  bool ghostOthers = false;  ///< while something is selected, the rest is a veil
  bool linkLabels = true;
  bool jointLabels = false;
  bool axisLabels = false;
  bool scaleBar = true;
  MarkChoice marks;
  friend bool operator==(const ViewOptions&, const ViewOptions&) = default;
};

}  // namespace geargraph::inline view3d

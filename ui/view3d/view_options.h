#pragma once

#include <optional>

#include "core/render/look.h"
#include "core/render/stage_lines.h"

namespace geargraph {

/// A cut across the train: square to x, y or z, so far along it.
struct SectionChoice {
  int axis = 1;           ///< 0 x, 1 y, 2 z
  double place = 0.5;     ///< 0..1 through the scene
  bool isTurned = false;  ///< the other half is taken away
  friend bool operator==(const SectionChoice&, const SectionChoice&) = default;
};

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

}  // namespace geargraph

#pragma once

#include "core/foundations/base/id.h"
#include "core/foundations/base/triple.h"

namespace geargraph {

/// A requested displacement of an axis since it was grabbed, in the base frame and the reference pose.
struct AxisPull {
  ElementId element;  ///< the axis, or a joint about it
  Vector3 way{};
  bool isFree = false;  ///< Alt: no snapping
};

}  // namespace geargraph

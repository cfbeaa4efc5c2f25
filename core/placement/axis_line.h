#pragma once

#include "core/base/triple.h"

namespace geargraph {

/// Where an axis lies in the reference pose, base frame.
struct AxisLine {
  Vector3 point{};
  Vector3 direction{0, 0, 1};  ///< of length 1
  ExactVector3 exactPoint;
  ExactVector3 exactDirection;  ///< as written, of any length
  bool automatic = false;       ///< point or direction chosen by the program
};

}  // namespace geargraph

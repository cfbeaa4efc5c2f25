#pragma once

#include <optional>
#include <utility>

#include "ui/tools/tool_machine.h"

namespace geargraph::test {

inline const JointId kJoint("8");

/// The pointer at a place of the drawing, over an element or over nothing.
inline Pointer at(double x, double y, std::optional<ElementId> on = {}) {
  Pointer pointer;
  pointer.at = {x, y};
  pointer.on = std::move(on);
  return pointer;
}

}  // namespace geargraph::test

#pragma once

#include <string>

#include "core/presentation/drawing/display_list.h"
#include "core/theory/matroid/motor_range.h"

namespace geargraph {

/// The plot of a range over the angles of its two motors, in degrees and to one scale: the polygon with its
/// numbered corners, dashed around it what either motor alone may do, which is more than both together, and a
/// list of the corners in exact numbers and of the limits that bound the sides between them. Open sides are
/// dotted; limits that are never reached are named below.
/// Cost: O(limits).
[[nodiscard]] DisplayList motorRangeDrawing(const Mechanism& mechanism, const MotorRange& range);

/// The only text of a drawing without a range.
[[nodiscard]] DisplayList motorRangeAbsence(const std::string& why);

}  // namespace geargraph

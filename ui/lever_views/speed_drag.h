#pragma once

#include <optional>

#include "ui/document/document.h"
#include "ui/lever_views/levers_service.h"

namespace geargraph {

/// How the speed of a link on a lever follows from one input, the other inputs as they are.
struct SpeedHandle {
  std::size_t input = 0;  ///< position in DrawnLevers::inputs
  JointId joint;
  Rational perInput;  ///< speed of the link for 1 rad/s of the input; not 0
  Rational link;      ///< its speed now, rad/s
  Rational now;       ///< speed of the input now, rad/s

  /// The speed of the input with which the link has this one.
  [[nodiscard]] Rational inputFor(const Rational& speed) const { return now + (speed - link) / perInput; }
};

/// The handle on a link: of the input that drives the link itself, else of the first that turns it.
/// std::nullopt if none does. @pre the levers are drawn of this page
[[nodiscard]] std::optional<SpeedHandle> handleOn(const DrawnLevers& drawn, LinkOrdinal link);

/// Sets the speed of an input; where the document leaves its inputs to the program, they become its own.
[[nodiscard]] Edit inputSpeedEdit(const DrawnLevers& drawn, const SpeedHandle& handle, const Number& speed,
                                  quint64 gesture);

/// The whole multiple of a power of ten nearest to a speed, where 1 px is `perPixel` rad/s: no more digits
/// than a hand can set.
[[nodiscard]] Number handSet(double speed, double perPixel);

}  // namespace geargraph

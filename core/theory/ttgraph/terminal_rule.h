#pragma once

#include <optional>

#include "core/foundations/base/triple.h"
#include "core/mechanism/kinds/pair_kind.h"

namespace geargraph {

/// A pair of which one side turns and the other one slides, in the drawn pose.
struct SlidePose {
  Vector3 axis;      ///< the direction about which the one turns,
  Vector3 slide;     ///< and that along which the other slides, both of length 1
  Vector3 arm;       ///< from the axis to the pitch point, square to the axis
  double helix = 0;  ///< of the side that turns, rad, positive right-hand
};

/// What the T-T graph knows of a kind of gear pair: the sign of its terminal equation (mesh_sign.h) as far as
/// it needs no pitch point. It takes no step of the other method, which has the sign from the pitch radii.
struct TerminalRule {
  /// For parallel axes; `sense`: +1 where they point the same way, else -1. std::nullopt: the pitch point
  /// decides.
  std::optional<int> (*alongParallels)(int sense) = nullptr;
  /// For skew axes: from the sum beta_i + beta_j + Sigma of the helix angles and the crossing angle, a whole
  /// number of half turns, because the teeth of both run the same way where they touch.
  std::optional<int> (*acrossSkew)(double sum) = nullptr;
  /// For a side that turns and one that slides: +1 where a positive speed of the one goes with a positive
  /// speed of the other.
  std::optional<int> (*alongSlide)(const SlidePose& pose) = nullptr;
  /// For skew axes whose gears are cones instead: from the half axes, seen from the feet of the common
  /// perpendicular, beside which the pitch point lies, +1 along the axis and -1 against it.
  std::optional<int> (*alongHalfAxes)(int tail, int head) = nullptr;
};

[[nodiscard]] KindTable<MeshKind, TerminalRule>& terminalRules();

}  // namespace geargraph

#pragma once

#include <vector>

#include "core/presentation/schematic/sheet_layout.h"

namespace geargraph::inline schematic {

/// A turning joint as a bearing: the parent's bars about the child's shaft.
struct SheetBearing {
  int joint = 0;
  int axis = 0;  ///< of the layout
  int parent = 0;
  int child = 0;
  double at = 0;  ///< px along the axis
  /// The parent reaches it by a straight arm from its own, parallel axis.
  bool straightArm = false;
  bool driven = false;  ///< an input: its shaft has an arrow at the end
  double freeEnd = -1;  ///< which end of the child's shaft that is, along the axis
};

/// The side wall that carries a ring.
struct SheetCup {
  int wheel = 0;
  double at = 0;
};

/// The stretch of an axis that a link holds: on the axis itself (lane 0), or as a hollow shaft about others.
struct SheetShaft {
  int axis = 0;
  int link = 0;
  double low = 0;
  double high = 0;
  int lane = 0;
  bool turns = true;  ///< its link turns about this axis
};

/// Where bearings, arms and shafts go.
struct ShaftPlan {
  std::vector<SheetBearing> bearings;  ///< by joint of the part
  std::vector<SheetCup> cups;
  std::vector<SheetShaft> shafts;

  [[nodiscard]] const SheetShaft* shaft(int axis, int link) const;
};

/// Height of a hollow shaft's lane above the next inner one, px.
constexpr double kLaneHeight = 12;
/// Half of a bearing's length; from its shaft to its bars; depth of the hatching behind them.
constexpr double kBearingHalf = 9;
constexpr double kBearingGap = 5;
constexpr double kHatching = 7;
/// From a driven bearing to the arrow about its shaft, and to the shaft's end.
constexpr double kArrowPlace = 20;
constexpr double kDrivenEnd = 29;
constexpr double kShaftEnd = 15;
/// Beyond its pitch line: the rim of a ring.
constexpr double kRimHeight = 15;

}  // namespace geargraph::inline schematic

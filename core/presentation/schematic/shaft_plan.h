#pragma once

#include <vector>

#include "core/presentation/schematic/sheet_layout.h"

namespace geargraph::inline schematic {

struct DrawnTrain;

/// A turning joint as a bearing: the parent's bars about the child's shaft, or on a pin of the parent's
/// within the child's hub.
struct SheetBearing {
  int joint = 0;
  int axis = 0;  ///< of the layout
  int parent = 0;
  int child = 0;
  double at = 0;        ///< px along the axis
  double height = 0;    ///< of the child's shaft above the axis, or of its wall
  bool isHeld = false;  ///< the parent reaches it without an arm: by a pin, a wall or the end of its shaft
  bool onPin = false;   ///< on a shaft of the parent's within the child's
  bool driven = false;  ///< an input: its shaft has an arrow at the end
  double freeEnd = -1;  ///< which end of the child's shaft that is, along the axis
};

/// An arm from a link's own axis to a bearing on another.
struct SheetArm {
  int link = 0;
  int joint = 0;            ///< whose bearing it ends at
  int axis = 0;             ///< that it begins on
  double at = 0;            ///< px along it
  bool isStraight = false;  ///< to a parallel axis
};

/// The side wall that carries a ring.
struct SheetCup {
  int wheel = 0;
  double at = 0;
};

/// A wall of a link between its shafts, wheels and pins: (coordinate, height) of its ends.
struct SheetWall {
  int axis = 0;
  int link = 0;
  SheetPoint from;
  SheetPoint to;
};

/// The stretch of an axis that a link holds: on the axis itself (lane 0), or as a hollow shaft about others.
struct SheetShaft {
  int axis = 0;
  int link = 0;
  double low = 0;
  double high = 0;
  int lane = 0;       ///< shafts nested within it, one in the other
  bool turns = true;  ///< its link turns about this axis
};

/// Where bearings, arms and shafts go.
struct ShaftPlan {
  std::vector<SheetBearing> bearings;  ///< by joint of the part
  std::vector<SheetArm> arms;
  std::vector<SheetCup> cups;
  std::vector<SheetWall> walls;
  std::vector<SheetShaft> shafts;

  /// The link's shaft on an axis, of several the one nearest to the place; null: it has none.
  [[nodiscard]] const SheetShaft* shaft(int axis, int link, double near) const;
};

/// The arrangement of a train on its sheet: the order along every axis and the nesting of shafts are the
/// arrangement's; distances are what the symbols need. Wheels of a parallel layout are moved together with
/// them. Bearings that the arrangement does not show (BearingForm::hidden) get a free place on their shafts.
/// Cost: O((wheels + joints + walls)^2).
[[nodiscard]] ShaftPlan shaftPlan(const DrawnPart& part, const DrawnTrain& train, SheetLayout& layout);

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

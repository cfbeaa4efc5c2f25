#pragma once

#include <vector>

#include "core/presentation/schematic/sheet_layout.h"

namespace geargraph {

struct DrawnTrain;

/// A turning joint as a bearing: bars of the parent around the child's shaft, or a pin of the parent within
/// the child's hub.
struct SheetBearing {
  int joint = 0;
  int axis = 0;  ///< of the layout
  int parent = 0;
  int child = 0;
  double at = 0;        ///< px along the axis
  double height = 0;    ///< of the child's shaft above the axis, or of its wall
  bool isHeld = false;  ///< the parent supports it without an arm: by a pin, a wall or the end of its shaft
  bool onPin = false;   ///< on a shaft of the parent inside the child's
  bool driven = false;  ///< an input: there is an arrow at the end of its shaft
  double freeEnd = -1;  ///< that end of the child's shaft: -1 or 1 along the axis
};

/// An arm from a link's own axis to a bearing on another.
struct SheetArm {
  int link = 0;
  int joint = 0;            ///< at whose bearing it ends
  int axis = 0;             ///< where it begins
  double at = 0;            ///< px along it
  bool isStraight = false;  ///< to a parallel axis
};

/// The ring-gear carrier: the side wall that supports a ring gear.
struct RingCarrierSymbol {
  int wheel = 0;
  double at = 0;
};

/// A wall of a link between its shafts, wheels and pins: (coordinate, height) of its ends.
struct SheetWall {
  int axis = 0;
  int link = 0;
  CanvasPoint from;
  CanvasPoint to;
};

/// The interval of an axis that a link's shaft occupies: on the axis itself (lane 0), or as a hollow shaft
/// around others.
struct SheetShaft {
  int axis = 0;
  int link = 0;
  double low = 0;
  double high = 0;
  int lane = 0;       ///< number of shafts nested inside it
  bool turns = true;  ///< its link turns about this axis
};

/// The places of bearings, arms and shafts.
struct ShaftPlan {
  ByJoint<SheetBearing> bearings;  ///< of the part
  std::vector<SheetArm> arms;
  std::vector<RingCarrierSymbol> ringCarriers;
  std::vector<SheetWall> walls;
  std::vector<SheetShaft> shafts;

  /// The link's shaft on an axis, of several the one nearest to `near`; null: it has none.
  [[nodiscard]] const SheetShaft* shaft(int axis, int link, double near) const;
};

/// The arrangement of a train on its sheet: the order along every axis and the nesting of shafts are the
/// arrangement's; distances follow from the symbols. Wheels of a parallel layout are moved accordingly.
/// Bearings that are not visible in the arrangement (BearingForm::hidden) get a free place on their shafts.
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
/// The rim of a ring gear beyond its pitch line, px.
constexpr double kRimHeight = 15;

}  // namespace geargraph

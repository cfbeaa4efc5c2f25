#pragma once

#include <optional>
#include <stop_token>
#include <vector>

#include "core/foundations/base/triple.h"
#include "core/machine/train/train_wheels.h"
#include "core/presentation/drawing/planar.h"
#include "core/presentation/schematic/drawn_part.h"
#include "core/presentation/schematic/sheet_frame.h"

namespace geargraph::inline schematic {

/// A line of the mechanism laid into the sheet: an axis class, or an axis that nothing turns about yet.
struct SheetAxis {
  int axis = 0;  ///< position in the part's list: whose name it bears
  int top = 0;   ///< link that holds it; -1 for an axis without joints
  Vector3 base{};
  Vector3 direction{0, 0, 1};
  Vector3 upInSpace{1, 0, 0};  ///< at right angles to direction: what `up` shows
  SheetPoint origin;           ///< where `base` lies, px
  SheetPoint along{1, 0};      ///< unit vectors
  SheetPoint up{0, -1};
  bool half = false;    ///< a half section: only the upper side is drawn
  bool turned = false;  ///< does not lie so in space: turned into the sheet

  /// px along the axis and away from it.
  [[nodiscard]] SheetPoint at(double coordinate, double height) const {
    return origin + coordinate * along + height * up;
  }
  [[nodiscard]] double coordinateOf(SheetPoint p) const { return dot(p - origin, along); }
  [[nodiscard]] double heightOf(SheetPoint p) const { return dot(p - origin, up); }
  /// Along the axis in space, in the document's unit.
  [[nodiscard]] double spaceCoordinate(const Vector3& p) const { return geargraph::dot(p - base, direction); }
};

/// A toothed wheel on the sheet, by its pitch line on the upper side of its axis; px.
struct SheetWheel {
  int link = 0;
  int axis = 0;  ///< of the layout
  GearKind kind = GearKind::external;
  std::vector<int> meshes;
  double space = 0;  ///< where along the axis it stands in space
  double at = 0;     ///< where its body meets the axis
  double low = 0;    ///< parallel: where the first and the last of its meshes lie, most often both at `at`
  double high = 0;
  double radius = 0;   ///< height of the body's end: the middle of the pitch line
  SheetPoint barFrom;  ///< (coordinate, height) of the ends of its pitch line
  SheetPoint barTo;
  SheetPoint outward;  ///< unit (coordinate, height): from the pitch line into the partner
  [[nodiscard]] bool isRing() const { return kind == GearKind::internal; }
};

/// Is the wheel fastened to the frame behind its teeth?
[[nodiscard]] inline bool isInFrame(const SheetWheel& wheel) {
  return wheel.link == 0 && wheel.kind != GearKind::external;
}

/// Two wheels in mesh.
struct SheetPair {
  int mesh = 0;
  int tail = 0;  ///< wheels
  int head = 0;
  bool apart = false;  ///< they do not touch on the sheet
};

/// Axes and wheels of a part on the sheet, x to the right, y down.
struct SheetLayout {
  std::vector<SheetAxis> axes;  ///< axis classes first, in their order
  std::vector<SheetWheel> wheels;
  std::vector<SheetPair> pairs;
  double scale = 1;         ///< px a unit of length, at right angles to parallel axes
  bool parallel = true;     ///< all axes lie horizontally, where along them is not to scale
  bool otherRadii = false;  ///< radii were changed so that wheels touch on the sheet
  Vector3 right{0, 0, 1};   ///< unit vectors: what lies to the right and upward on the sheet
  Vector3 up{1, 0, 0};
  int root = 0;                ///< the axis that the others are laid out from
  std::vector<double> planes;  ///< parallel: where along the axes wheels stand, in space, ascending

  /// px along an axis of a place in space.
  [[nodiscard]] double along(const SheetAxis& axis, const Vector3& p) const {
    const double coordinate = axis.spaceCoordinate(p);
    return parallel ? stretched(coordinate) : coordinate * scale;
  }
  /// Parallel: px along the axes of a coordinate in space.
  [[nodiscard]] double stretched(double coordinate) const;
};

/// What places on the sheet mean in space, wheels standing where they stand now.
/// @pre the layout has an axis
[[nodiscard]] SheetFrame sheetFrame(const DrawnPart& part, const SheetLayout& layout);

/// Where planes of wheels stand apart before things are put between them, px.
constexpr double kPlaneDistance = 150;
/// Half of the length of a spur gear's pitch line.
constexpr double kBarHalf = 9;
/// Between a pitch line and the true pitch point: the lines of two wheels in mesh lie side by side.
constexpr double kBarGap = 1.8;

/// Lays axes and wheels out.
///
/// All axes parallel: side by side at their centre distances, rolled out upward where they do not lie in one
/// plane; where that cannot keep all distances, radii give way by the least squares of their relative
/// changes.
/// Otherwise: as in space where the axes lie in one plane (z up); else each axis is turned about its
/// neighbour into the sheet, its distance and angle to it kept.
/// Of no use when `stop` was requested meanwhile.
/// @pre placement and stacked wheels are the part's, and there is a tree
[[nodiscard]] SheetLayout sheetLayout(const DrawnPart& part, const Placement& placement,
                                      const TrainWheels& train, const std::stop_token& stop = {});

// The two ways, and what both need.
void layParallel(SheetLayout& layout, const TrainWheels& train, const Placement& placement,
                 const std::stop_token& stop);
void layUnfolded(SheetLayout& layout, const TrainWheels& train, const Placement& placement);
/// The link's own axis of the layout; -1 for the ground.
[[nodiscard]] inline int axisOfLink(const Placement& placement, int link) {
  return placement.classes->classOfLink(link);
}

}  // namespace geargraph::inline schematic

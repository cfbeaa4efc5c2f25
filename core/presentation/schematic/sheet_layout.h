#pragma once

#include <optional>
#include <stop_token>
#include <vector>

#include "core/foundations/base/triple.h"
#include "core/machine/teeth/wheel_kind.h"
#include "core/machine/train/train_wheels.h"
#include "core/presentation/drawing/planar.h"
#include "core/presentation/schematic/drawn_part.h"
#include "core/presentation/schematic/sheet_frame.h"

namespace geargraph {

/// A line of the mechanism in the sheet: an axis class, or an axis without joints.
struct SheetAxis {
  int axis = 0;      ///< position in the part's list of the axis that names it
  int rootLink = 0;  ///< root link of the class; -1 for an axis without joints
  Vector3 base{};
  Vector3 direction{0, 0, 1};
  Vector3 upInSpace{1, 0, 0};  ///< at right angles to direction: shown as `up`
  CanvasPoint origin;          ///< the point of the sheet for `base`, px
  CanvasPoint along{1, 0};     ///< unit vectors
  CanvasPoint up{0, -1};
  bool half = false;    ///< a half section: only the upper side is drawn
  bool turned = false;  ///< turned into the sheet: not so in space

  /// The point of the sheet at px along the axis and away from it.
  [[nodiscard]] CanvasPoint at(double coordinate, double height) const {
    return origin + coordinate * along + height * up;
  }
  [[nodiscard]] double coordinateOf(CanvasPoint p) const { return dot(p - origin, along); }
  [[nodiscard]] double heightOf(CanvasPoint p) const { return dot(p - origin, up); }
  /// The coordinate along the axis in space, in the document's unit.
  [[nodiscard]] double spaceCoordinate(const Vector3& p) const { return geargraph::dot(p - base, direction); }
};

/// A toothed wheel on the sheet, by its pitch line on the upper side of its axis; px.
struct SheetWheel {
  int link = 0;
  int axis = 0;  ///< of the layout
  GearKind kind{};
  std::vector<MeshOrdinal> meshes;
  double space = 0;  ///< coordinate along the axis in space
  double at = 0;     ///< where its body is on the axis
  double low = 0;    ///< parallel: places of its first and last mesh, mostly both `at`
  double high = 0;
  double radius = 0;    ///< height of the body's end: the middle of the pitch line
  CanvasPoint barFrom;  ///< (coordinate, height) of the ends of its pitch line
  CanvasPoint barTo;
  CanvasPoint outward;  ///< unit (coordinate, height): from the pitch line into the partner
  int hand = 0;         ///< of helical teeth: +1 right, -1 left; of herringbone teeth that of the end `low`
  bool herringbone = false;
  [[nodiscard]] bool isRing() const { return wheelKind(kind).isRing; }
};

/// Is the wheel fixed to the frame behind its teeth?
[[nodiscard]] bool isInFrame(const SheetWheel& wheel);

/// Two wheels in mesh.
struct SheetPair {
  int mesh = 0;
  int tail = 0;  ///< positions of wheels
  int head = 0;
  bool apart = false;  ///< they do not touch on the sheet
};

/// Axes and wheels of a part on the sheet, x to the right, y down.
struct SheetLayout {
  ByClass<SheetAxis> axes;  ///< axis classes first, in their order
  ByGear<SheetWheel> wheels;
  std::vector<SheetPair> pairs;
  double scale = 1;         ///< px per unit of length, at right angles to parallel axes
  bool parallel = true;     ///< all axes are horizontal, and not to scale along them
  bool otherRadii = false;  ///< radii were changed so that wheels touch on the sheet
  Vector3 right{0, 0, 1};   ///< unit vectors in space: right and up on the sheet
  Vector3 up{1, 0, 0};
  int root = 0;                ///< the axis from which the others are laid out
  std::vector<double> planes;  ///< parallel: coordinates of the wheels along the axes in space, ascending

  /// px along an axis of a point in space.
  [[nodiscard]] double along(const SheetAxis& axis, const Vector3& p) const {
    const double coordinate = axis.spaceCoordinate(p);
    return parallel ? stretched(coordinate) : coordinate * scale;
  }
  /// Parallel: px along the axes of a coordinate in space.
  [[nodiscard]] double stretched(double coordinate) const;
};

/// The frame of the sheet for the present places of the wheels.
/// @pre the layout has an axis
[[nodiscard]] CanvasFrame sheetFrame(const DrawnPart& part, const SheetLayout& layout);

/// The initial distance of planes of wheels, px.
constexpr double kPlaneDistance = 150;
/// Half of the length of a spur gear's pitch line.
constexpr double kBarHalf = 9;
/// The offset of a pitch line from the true pitch point, px: the lines of two wheels in mesh are side by
/// side.
constexpr double kBarGap = 1.8;

/// Lays axes and wheels out.
///
/// If all axes are parallel: side by side at their centre distances, unrolled upward if they are not in one
/// plane; if that cannot keep all distances, radii are changed by least squares of their relative changes.
/// Otherwise: as in space if the axes are in one plane (z up); else each axis is turned about its neighbour
/// into the sheet, with its distance and angle to it kept. The result is meaningless if `stop` was requested
/// meanwhile.
/// @pre placement and stacked wheels are the part's, and there is a tree
[[nodiscard]] SheetLayout sheetLayout(const DrawnPart& part, const Placement& placement,
                                      const TrainWheels& train, const std::stop_token& stop = {});

// The two cases of sheetLayout(), and a helper.
void layParallel(SheetLayout& layout, const TrainWheels& train, const Placement& placement,
                 const std::stop_token& stop);
void layUnfolded(SheetLayout& layout, const TrainWheels& train, const Placement& placement);
/// The link's own axis of the layout; -1 for the ground.
[[nodiscard]] inline int axisOfLink(const Placement& placement, int link) {
  return placement.classes->classOfLink(link);
}

}  // namespace geargraph

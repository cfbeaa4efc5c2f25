#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <utility>
#include <vector>

#include "core/foundations/base/ordinal.h"
#include "core/machine/solids/shell_builder.h"

namespace geargraph {

constexpr double kShaftRadius = 1.8;  // modules, where bores leave room for it

/// An arm of a link from its own axis to the bearing of another.
struct ArmPlan {
  LinkOrdinal link = 0;
  int from = 0;      ///< axis class that it starts at
  double level = 0;  ///< coordinate along it
  int to = 0;        ///< axis class of the bearing
  double at = 0;     ///< coordinate of the bearing
  int child = 0;     ///< link whose shaft is in the bearing
};

/// The shaft of a link along an interval of an axis: solid, or a tube around the shafts inside. Empty if its
/// low end is above the high one.
struct ShaftSegment {
  AxisGroupOrdinal axisGroup = 0;
  LinkOrdinal link = 0;
  double low = 1e300;
  double high = -1e300;
  double inner = 0;
  double outer = 0;

  void include(double from, double to) {
    low = std::min(low, from);
    high = std::max(high, to);
  }

  /// Sets the radii: a tube that clears a shaft of radius `inside`, or a solid shaft for 0.
  void wrap(double inside, double module) {
    inner = inside > 0 ? inside + 0.12 * module : 0;
    outer = inside > 0 ? inside + module : kShaftRadius * module;
  }
};

/// A cantilevered pin of a link along an axis that intersects its own, on which a child turns.
struct PinPlan {
  LinkOrdinal link = 0;
  AxisGroupOrdinal home = 0;  ///< the link's axis class
  double level = 0;           ///< coordinate of the intersection along it
  AxisGroupOrdinal axisGroup = 0;
  double from = 0;  ///< of the intersection along the pin's axis
  double to = 0;    ///< beyond the child's last wheel
};

/// A cross-shaft boss: a link's shaft that ends in a boss around a shaft on an axis across its own.
struct CrossShaftBossPlan {
  LinkOrdinal link = 0;
  AxisGroupOrdinal home = 0;  ///< the link's axis class
  double level = 0;           ///< coordinate of the intersection along it
  AxisGroupOrdinal axisGroup = 0;
  double at = 0;             ///< of the intersection along the other axis
  int child = 0;             ///< link whose shaft is in the boss
  double low = 0, high = 0;  ///< the interval of that shaft, for other links that turn on it
};

/// A pedestal for a wheel of the ground that none of the ground's bearings supports.
struct PedestalPlan {
  AxisGroupOrdinal axisGroup = 0;
  double at = 0;
};

/// The ring-gear carrier: the disc and wall that support a ring gear on its link's shaft.
struct RingCarrierPlan {
  GearOrdinal gear;
  int side = -1;     ///< the face of the ring that the disc closes: -1 or 1 along the axis
  double plate = 0;  ///< coordinate of the disc's middle
};

/// Bars along an axis in place of a drum's wall, so that the wheels inside are visible.
struct CagePlan {
  AxisGroupOrdinal axisGroup = 0;
  LinkOrdinal link = 0;
  double inner = 0;
  double outer = 0;
  double low = 0;
  double high = 0;
};

/// Solids of revolution of a link about an axis: closed profiles, material on the left.
struct RevolvedPlan {
  AxisGroupOrdinal axisGroup = 0;
  LinkOrdinal link = 0;
  std::vector<std::vector<ProfileVertex>> profiles;  ///< heights are coordinates along the axis
};

/// A disc (radial) or the wall of a drum (axial) by its middle line in the half plane through its axis. Walls
/// join the wheels, shafts and pins of a link whose bodies are routed in that plane (coaxial_plan.h).
struct WallPlan {
  AxisGroupOrdinal axisGroup = 0;
  LinkOrdinal link = 0;
  double fromAt = 0;  ///< coordinates along the axis; ascending for an axial wall
  double toAt = 0;
  double fromRadius = 0;  ///< distances from the axis; ascending for a radial wall
  double toRadius = 0;
  bool isOnShaft = false;  ///< a radial wall that begins at the link's own shaft
};

/// A housing around an axis, which joins bearings of the ground or supports one on the base.
struct HousingPlan {
  AxisGroupOrdinal axisGroup = 0;
  double low = 0;
  double high = 0;
  double inner = 0;
  double outer = 0;
};

/// A round bar of the ground's frame.
struct FrameBar {
  Eigen::Vector3d from;
  Eigen::Vector3d to;
  double radius = 0;
};

/// The frame: the parts that join the ground's bearings into one body.
struct FramePlan {
  /// Where a bar or a housing is fixed to the base.
  struct Foot {
    Eigen::Vector2d place;
    double radius = 0;
  };
  std::vector<HousingPlan> housings;
  std::vector<FrameBar> bars;
  std::vector<Foot> feet;  ///< the base plate is their convex hull; empty: there is no base
  double top = 0;          ///< of the base, along z
  double thickness = 0;
  /// Bearings (axis class, coordinate) that could not be connected to the others and have pedestals of their
  /// own.
  std::vector<std::pair<int, double>> onPedestals;
};

}  // namespace geargraph

#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <utility>
#include <vector>

#include "core/machine/solids/shell_builder.h"

namespace geargraph::inline arrangement {

constexpr double kShaftRadius = 1.8;  // modules, where bores leave room for it

/// An arm of a link from its own axis to the bearing of another.
struct ArmPlan {
  int link = 0;
  int from = 0;      ///< axis class it starts at
  double level = 0;  ///< coordinate along it
  int to = 0;        ///< axis class of the bearing
  double at = 0;     ///< coordinate of the bearing
  int child = 0;     ///< whose shaft the bearing holds
};

/// The interval of an axis that one link occupies: a shaft, or a tube about the shafts inside.
struct ShaftSegment {
  int axisClass = 0;
  int link = 0;
  double low = 1e300;
  double high = -1e300;
  double inner = 0;
  double outer = 0;

  void include(double from, double to) {
    low = std::min(low, from);
    high = std::max(high, to);
  }

  /// A solid shaft, or with something of radius @p inside to go about (0: nothing) a tube that clears it.
  void wrap(double inside, double module) {
    inner = inside > 0 ? inside + 0.12 * module : 0;
    outer = inside > 0 ? inside + module : kShaftRadius * module;
  }
};

/// A pin that a link holds out along an axis that crosses its own, for a child that turns on it.
struct PinPlan {
  int link = 0;
  int home = 0;      ///< the link's axis class
  double level = 0;  ///< coordinate of the crossing along it
  int axisClass = 0;
  double from = 0;  ///< of the crossing along the pin's axis
  double to = 0;    ///< behind the child's last wheel
};

/// A link's shaft that ends in an eye about a shaft across its own axis.
struct TeePlan {
  int link = 0;
  int home = 0;      ///< the link's axis class
  double level = 0;  ///< coordinate of the crossing along it
  int axisClass = 0;
  double at = 0;             ///< of the crossing along the other axis
  int child = 0;             ///< whose shaft the eye holds
  double low = 0, high = 0;  ///< how far that one reaches, for others that run on it
};

/// The foot of a wheel of the frame that stands on none of its bearings.
struct StubPlan {
  int axisClass = 0;
  double at = 0;
};

/// The plate and wall that carry a ring on its link's shaft.
struct CupPlan {
  int gear = 0;
  int side = -1;     ///< the ring's face that it closes
  double plate = 0;  ///< coordinate of the plate's middle
};

/// Bars along an axis in place of a drum's wall, so that the wheels inside are seen.
struct CagePlan {
  int axisClass = 0;
  int link = 0;
  double inner = 0;
  double outer = 0;
  double low = 0;
  double high = 0;
};

/// Bodies of revolution of a link about an axis: closed meridians, material on the left.
struct LathePlan {
  int axisClass = 0;
  int link = 0;
  std::vector<std::vector<ProfileVertex>> meridians;  ///< heights are coordinates along the axis
};

/// A disc or the wall of a drum in the half plane through its axis, by its middle: upright or level. Walls
/// join the wheels, shafts and pins of a link whose bodies are routed in that plane (coaxial_plan.h).
struct WallPlan {
  int axisClass = 0;
  int link = 0;
  double fromAt = 0;  ///< coordinates along the axis; level: ascending
  double toAt = 0;
  double fromRadius = 0;  ///< distances from the axis; upright: ascending
  double toRadius = 0;
  bool isOnShaft = false;  ///< upright: begins at the link's own shaft
};

/// A housing about an axis, which joins bearings of the ground or holds one on the base.
struct HousingPlan {
  int axisClass = 0;
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

/// What joins the ground's bearings to one body.
struct FramePlan {
  /// Where a bar or a housing is fixed to the base.
  struct Foot {
    Eigen::Vector2d place;
    double radius = 0;
  };
  std::vector<HousingPlan> housings;
  std::vector<FrameBar> bars;
  std::vector<Foot> feet;  ///< the base is the plate that they span; empty: there is none
  double top = 0;          ///< of the base, along z
  double thickness = 0;
  /// Bearings (axis class, coordinate) that found no way to the others and have feet of their own.
  std::vector<std::pair<int, double>> onFeet;
};

}  // namespace geargraph::inline arrangement

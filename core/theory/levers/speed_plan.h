#pragma once

#include <span>
#include <vector>

#include "core/foundations/base/rational.h"
#include "core/mechanism/placement/placement.h"

namespace geargraph {

/// Why a mechanism has no speed plan.
enum class SpeedPlanAbsence {
  none,        ///< it has one
  unfinished,  ///< no tree of turning joints, or a mesh without geometry
  noMotion,    ///< no rates are known
  directions,  ///< some axes are not parallel
};

/// Kutzbach's speed plan of a train with parallel axes (K. Kutzbach, Mehrgliedrige Radgetriebe und ihre
/// Gesetze, Maschinenbau 6, 1927): the peripheral velocities of all links over the distance from the main
/// axis (mainAxisOf()), in one plane. A link is a straight line; its slope is its absolute speed. Two links
/// have the same velocity where they meet: at the axis by which one carries the other, and at their teeth.
///
/// An axis is at its distance from the axis of the link that carries it; axes that the ground carries are
/// unrolled one beside the other. Distances in the document's unit, upward; velocities in unit times rad/s.
struct SpeedPlan {
  struct Axis {
    double height = 0;
    double velocity = 0;
  };
  /// A link, the ground first.
  struct Line {
    LinkOrdinal link = 0;
    double axisHeight = 0;
    double axisVelocity = 0;
    Rational speed;  ///< absolute, about the main direction, rad/s
    double low = 0;  ///< the heights between which it has its axis, its teeth and the axes that it carries
    double high = 0;

    [[nodiscard]] double velocityAt(double height) const {
      return axisVelocity + speed.toDouble() * (height - axisHeight);
    }
  };
  struct Crossing {
    MeshOrdinal mesh = 0;
    double height = 0;
    double velocity = 0;
  };
  SpeedPlanAbsence absence = SpeedPlanAbsence::unfinished;
  AxisGroupOrdinal mainAxis = -1;
  ByClass<Axis> axes;
  std::vector<Line> lines;
  std::vector<Crossing> crossings;
  /// Meshes of two axes that are not in one plane with the axis of their carrier: their lines meet nowhere.
  std::vector<MeshOrdinal> apart;
  /// Pairs that turn alike (pins, belts 1 : 1): their lines are parallel.
  std::vector<MeshOrdinal> alike;
};

/// `rates`: of all joints; empty where they are not known. Cost: O(n + c) and the joints to the ground of
/// each link.
[[nodiscard]] SpeedPlan speedPlanOf(const Placement& placement, std::span<const Rational> rates);

}  // namespace geargraph

#pragma once

#include <optional>
#include <stop_token>
#include <utility>
#include <vector>

#include "core/machine/train/train_wheels.h"
#include "core/mechanism/placement/disc_hull.h"

namespace geargraph {

/// The orbit of a wheel's axis on its carrier: two wheels on parallel axes whose carriers turn about one
/// third axis can come as close as the difference of their orbits' radii.
struct WheelOrbit {
  LinkOrdinal carrier = 0;  ///< the link that holds the wheel's axis
  AxisGroupOrdinal about =
      -1;              ///< the axis class that the carrier turns about; -1: the carrier is the ground
  double radius = 0;   ///< of the orbit
  Eigen::Vector3d at;  ///< a point of the wheel's axis
};

[[nodiscard]] WheelOrbit orbitOf(AxisGroupOrdinal axisGroup, const Placement& placement);

/// The smallest distance between two parallel axes in any pose; their present distance if both are held by
/// one carrier, or one carries the other.
[[nodiscard]] double nearestAxes(const WheelOrbit& a, const WheelOrbit& b, const Eigen::Vector3d& direction);

/// The swept envelopes of the wheels of a train: discs and rings, bevels by the hull of their tips and body.
class WheelEnvelopes {
 public:
  WheelEnvelopes(const TrainWheels& train, const Placement& placement);

  /// Moves a wheel; `by` is along its axis.
  void move(GearOrdinal wheel, const Eigen::Vector3d& by);
  /// Updates a wheel after a change of its face width.
  void update(GearOrdinal wheel);
  /// Every pair (a, b), a < b, for which collide() may be true: wheels whose bounding spheres overlap, and
  /// wheels whose carriers revolve about one axis. Ordered by a, then b. Incomplete if `stop` was requested
  /// meanwhile. Cost: O(n log n), and the comparison of those whose spheres overlap along one coordinate, and
  /// of those on one axis.
  [[nodiscard]] std::vector<std::pair<int, int>> nearPairs(const std::stop_token& stop = {}) const;
  /// Can the wheels collide() for some position of the first one along its axis?
  [[nodiscard]] bool mayIntersect(GearOrdinal moving, GearOrdinal other) const;
  /// Do two wheels overlap in the reference pose, or on parallel axes in any pose?
  [[nodiscard]] bool collide(GearOrdinal a, GearOrdinal b) const;
  /// Does another parallel axis pass through the wheel in any pose?
  [[nodiscard]] bool covers(GearOrdinal wheel, AxisGroupOrdinal axisGroup) const;
  /// The preferred direction for moving a wheel along its axis: the side from which the bevels on it come; 0
  /// if there are none.
  [[nodiscard]] const Eigen::Vector3d& freeSide(GearOrdinal wheel) const {
    return m_freeSide[envelope(wheel).axisGroup];
  }

 private:
  struct Envelope {
    Eigen::Vector3d origin, axis;
    AxisGroupOrdinal axisGroup = 0;
    double low = 0, high = 0;  ///< along the axis from the origin
    double inner = 0, outer = 0;
    bool bevel = false;
    WheelOrbit orbit;
    DiscHull hull;                 ///< empty for rings, which are hollow
    double middle = 0, reach = 0;  ///< of the bounding sphere: coordinate of its centre, radius
    bool hasArm = false;           ///< the hull includes room for arms beside the wheel

    [[nodiscard]] Eigen::Vector3d centre() const { return origin + middle * axis; }
  };
  [[nodiscard]] Envelope envelopeOf(const TrainWheel& wheel, bool hasArms) const;
  /// Do both revolve about the same axis on different carriers, so that the reference pose is not decisive?
  [[nodiscard]] static bool shareOrbit(const Envelope& a, const Envelope& b) {
    return a.orbit.about >= 0 && a.orbit.about == b.orbit.about && a.orbit.carrier != b.orbit.carrier;
  }
  [[nodiscard]] const Envelope& envelope(GearOrdinal w) const { return m_envelopes[w]; }
  [[nodiscard]] static bool discsCollide(const Envelope& a, const Envelope& b);
  [[nodiscard]] static bool hullsCollide(const Envelope& a, const Envelope& b);

  const TrainWheels& m_train;
  ByGear<Envelope> m_envelopes;
  ByClass<WheelOrbit> m_orbits;
  std::vector<Eigen::Vector3d> m_lines;  ///< their directions
  ByClass<Eigen::Vector3d> m_freeSide;
};

}  // namespace geargraph

#pragma once

#include <optional>
#include <stop_token>
#include <utility>
#include <vector>

#include "core/machine/train/train_wheels.h"
#include "core/mechanism/placement/disc_hull.h"

namespace geargraph::inline train {

/// A wheel's axis as its carrier sees it go round: two wheels on parallel axes whose carriers turn about one
/// third axis come as close as the difference of their orbits.
struct WheelOrbit {
  int carrier = 0;     ///< the link that holds the wheel's axis
  int about = -1;      ///< the axis class that this one turns about; -1: the ground
  double radius = 0;   ///< of the orbit
  Eigen::Vector3d at;  ///< a point of the wheel's axis
};

[[nodiscard]] WheelOrbit orbitOf(int axisClass, const Placement& placement);

/// How near two parallel axes come to each other: where both are held by one carrier, or one carries the
/// other, that is their distance.
[[nodiscard]] double nearestAxes(const WheelOrbit& a, const WheelOrbit& b, const Eigen::Vector3d& direction);

/// The room that the wheels of a train take up: discs and rings, bevels by the hull of their tips and body.
class WheelRooms {
 public:
  WheelRooms(const TrainWheels& train, const Placement& placement);

  /// @p by is along the wheel's axis.
  void move(int wheel, const Eigen::Vector3d& by);
  /// Takes up a wheel's new face width.
  void update(int wheel);
  /// Every pair (a, b), a < b, that collide() may be true of: wheels whose bounding spheres overlap, and
  /// wheels whose carriers go round one axis. Ordered by a, then b. Incomplete when `stop` was requested
  /// meanwhile. Cost: O(n log n), and comparing those whose spheres overlap along one coordinate, and those
  /// of one axis.
  [[nodiscard]] std::vector<std::pair<int, int>> nearPairs(const std::stop_token& stop = {}) const;
  /// May the wheels collide() wherever the first is moved along its axis?
  [[nodiscard]] bool mayMeet(int moving, int other) const;
  /// Do two wheels take up the same room in the reference pose, or wheels on parallel axes ever?
  [[nodiscard]] bool collide(int a, int b) const;
  /// Does a parallel axis beside its own pass through the wheel, or ever come to?
  [[nodiscard]] bool covers(int wheel, int axisClass) const;
  /// The way that a wheel rather moves along its axis: where the bevels on it come from; 0: none are there.
  [[nodiscard]] const Eigen::Vector3d& freeSide(int wheel) const {
    return m_freeSide[static_cast<std::size_t>(room(wheel).axisClass)];
  }

 private:
  struct Room {
    Eigen::Vector3d origin, axis;
    int axisClass = 0;
    double low = 0, high = 0;  ///< along the axis from the origin
    double inner = 0, outer = 0;
    bool bevel = false;
    WheelOrbit orbit;
    DiscHull hull;                 ///< none of rings, which are hollow
    double middle = 0, reach = 0;  ///< of the bounding sphere: coordinate of its centre, radius
    bool hasArm = false;           ///< the hull leaves room for arms beside it

    [[nodiscard]] Eigen::Vector3d centre() const { return origin + middle * axis; }
  };
  [[nodiscard]] Room roomOf(const TrainWheel& wheel, bool hasArms) const;
  /// Do both go round the same axis on different carriers, so that the reference pose says nothing?
  [[nodiscard]] static bool shareOrbit(const Room& a, const Room& b) {
    return a.orbit.about >= 0 && a.orbit.about == b.orbit.about && a.orbit.carrier != b.orbit.carrier;
  }
  [[nodiscard]] const Room& room(int w) const { return m_rooms[static_cast<std::size_t>(w)]; }
  [[nodiscard]] static bool discsCollide(const Room& a, const Room& b);
  [[nodiscard]] static bool hullsCollide(const Room& a, const Room& b);

  const TrainWheels& m_train;
  std::vector<Room> m_rooms;
  std::vector<WheelOrbit> m_orbits;         ///< by axis class
  std::vector<Eigen::Vector3d> m_lines;     ///< their directions
  std::vector<Eigen::Vector3d> m_freeSide;  ///< by axis class
};

}  // namespace geargraph::inline train

#pragma once

#include <Eigen/Core>
#include <optional>
#include <stop_token>
#include <vector>

#include "core/machine/train/train.h"
#include "core/mechanism/placement/placement.h"

namespace geargraph {

constexpr double kSameLevel = 1e-9;  ///< modules: levels that differ by less are one

/// An interval of an axis that a part occupies.
struct Interval {
  double low = 0;
  double high = 0;
  LinkOrdinal link = -1;  ///< of the part; -1: reserved, kept free
};

/// The visible form of a bearing.
enum class BearingForm {
  boss,    ///< the parent's boss around the child's shaft
  pin,     ///< the child turns on a pin of the parent, with a collar at the bearing's place
  hidden,  ///< not visible: the child turns on a pin without a collar, or on the shaft that it encloses
};

/// The bearing of a turning joint between parent and child link.
struct Bearing {
  JointOrdinal joint = 0;
  int parent = 0;
  int child = 0;
  double at = 0;  ///< coordinate along the class's line
  bool placed = false;
  BearingForm form = BearingForm::boss;
  double wall = 1;  ///< thickness of the boss's wall, in modules

  [[nodiscard]] bool isBoss() const { return form == BearingForm::boss; }
};

/// The layout of the parts along the line of an axis class. Coordinates are measured along the line from its
/// point.
struct AxisLayout {
  Eigen::Vector3d point = Eigen::Vector3d::Zero();
  Eigen::Vector3d direction = Eigen::Vector3d::UnitZ();
  double module = 1;     ///< the unit of all dimensions of the bodies
  double thickness = 3;  ///< of bearings and arms, in modules
  int bearingSide = -1;  ///< the end of the axis for bearings without a stated place
  std::vector<Interval> wheels;
  std::vector<Interval> occupied;  ///< wheels, and everything placed since
  std::vector<Bearing> bearings;

  [[nodiscard]] double coordinate(const Eigen::Vector3d& p) const { return (p - point).dot(direction); }
  [[nodiscard]] Eigen::Vector3d at(double coordinate) const { return point + coordinate * direction; }
  /// Is one coordinate below another by more than rounding? So equal coordinates stay equal in every
  /// orientation of the train.
  [[nodiscard]] bool isBelow(double a, double b) const { return a < b - kSameLevel * module; }
  /// Do two intervals overlap by more than rounding?
  [[nodiscard]] bool overlap(double lowA, double highA, double lowB, double highB) const {
    return isBelow(lowA, highB) && isBelow(lowB, highA);
  }
  [[nodiscard]] bool isFree(double low, double high) const;
  [[nodiscard]] double width() const { return thickness * module; }  ///< of bearings and arms
  [[nodiscard]] double gap() const { return 0.6 * module; }
  [[nodiscard]] bool slotIsFree(double middle) const {
    return isFree(middle - width() / 2 - gap() / 2, middle + width() / 2 + gap() / 2);
  }
  void occupy(double middle, LinkOrdinal link) {
    occupied.push_back({middle - width() / 2, middle + width() / 2, link});
  }
  /// Middles of candidate slots: those adjacent to an occupied interval, and those outside of all.
  [[nodiscard]] std::vector<double> slotCandidates() const;
  /// The middle of the free slot nearest to `wanted`; if there is none, outside of everything on the bearing
  /// side.
  [[nodiscard]] double freeSlot(double wanted) const;
  /// The interval that the wheels of a link span; std::nullopt if it has none.
  [[nodiscard]] std::optional<Interval> wheelsOf(LinkOrdinal link) const;
  /// A shaft that passes through the wheels of another link has to extend beyond that link's shaft too. Is
  /// that so with this bearing at `at` and the bearings placed already?
  [[nodiscard]] bool nests(const Bearing& bearing, double at) const;
  /// Is the link's shaft accessible at this level? Not within the interval from the wheels to the bearing of
  /// another link, unless its own bearing is in there too.
  [[nodiscard]] bool emerges(LinkOrdinal link, double level) const;
  /// The first free slot outside of everything on the bearing side.
  [[nodiscard]] double outerSlot() const;
};

/// The axis classes with their wheels, intersections and the bearings still without a place. The result is
/// meaningless if `stop` was requested meanwhile. Cost: O(joints + gears), and the square of the classes that
/// one link holds.
[[nodiscard]] std::vector<AxisLayout> axisLayouts(const Mechanism& mechanism, const Placement& placement,
                                                  const GearTrain& train, const std::stop_token& stop = {});

}  // namespace geargraph

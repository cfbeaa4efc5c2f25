#pragma once

#include <Eigen/Core>
#include <optional>
#include <stop_token>
#include <vector>

#include "core/machine/train/train.h"
#include "core/mechanism/placement/placement.h"

namespace geargraph::inline arrangement {

constexpr double kSameLevel = 1e-9;  ///< modules: what rounding leaves between levels that are one

/// A stretch of an axis that something fills.
struct Stretch {
  double low = 0;
  double high = 0;
  int link = -1;  ///< whose it is; -1: nobody's, kept free
};

/// What shows of a bearing.
enum class BearingForm {
  eye,     ///< the parent's eye about the child's shaft
  pin,     ///< the child turns on a pin of the parent's, whose collar stands at the bearing's place
  hidden,  ///< nothing: the child turns on a pin without collar, or runs on what it encloses
};

/// A bearing: the parent's eye about the child's shaft.
struct Bearing {
  int joint = 0;
  int parent = 0;
  int child = 0;
  double at = 0;  ///< coordinate along the class's line
  bool placed = false;
  BearingForm form = BearingForm::eye;
  double wall = 1;  ///< of the eye, in modules

  [[nodiscard]] bool isEye() const { return form == BearingForm::eye; }
};

/// What stands where along the line of an axis class. Coordinates run along the line from its point.
struct AxisLayout {
  Eigen::Vector3d point = Eigen::Vector3d::Zero();
  Eigen::Vector3d direction = Eigen::Vector3d::UnitZ();
  double module = 1;     ///< what all measures of the bodies go by
  double thickness = 3;  ///< of bearings and arms, in modules
  int bearingSide = -1;  ///< end of the axis where bearings go that have no place of their own
  std::vector<Stretch> wheels;
  std::vector<Stretch> taken;  ///< wheels, and whatever was placed since
  std::vector<Bearing> bearings;

  [[nodiscard]] double coordinate(const Eigen::Vector3d& p) const { return (p - point).dot(direction); }
  [[nodiscard]] Eigen::Vector3d at(double coordinate) const { return point + coordinate * direction; }
  /// Is one coordinate below another by more than rounding? What is equal stays so wherever the train is
  /// turned to.
  [[nodiscard]] bool isBelow(double a, double b) const { return a < b - kSameLevel * module; }
  /// Do two stretches overlap by more than rounding?
  [[nodiscard]] bool overlap(double lowA, double highA, double lowB, double highB) const {
    return isBelow(lowA, highB) && isBelow(lowB, highA);
  }
  [[nodiscard]] bool isFree(double low, double high) const;
  [[nodiscard]] double width() const { return thickness * module; }  ///< of bearings and arms
  [[nodiscard]] double gap() const { return 0.6 * module; }
  [[nodiscard]] bool slotIsFree(double middle) const {
    return isFree(middle - width() / 2 - gap() / 2, middle + width() / 2 + gap() / 2);
  }
  void take(double middle, int link) { taken.push_back({middle - width() / 2, middle + width() / 2, link}); }
  /// Middles of slots that touch something, and those outside of everything.
  [[nodiscard]] std::vector<double> slotCandidates() const;
  /// The free slot nearest to `wanted`; outside of everything on the bearing side where there is none.
  [[nodiscard]] double freeSlot(double wanted) const;
  /// What the wheels of a link span.
  [[nodiscard]] std::optional<Stretch> wheelsOf(int link) const;
  /// A shaft that passes the wheels of another has to come out at the end of that one's, too: is that so for
  /// a bearing at this place and the bearings that have theirs?
  [[nodiscard]] bool nests(const Bearing& bearing, double at) const;
  /// Does the link's shaft come to light here? Not within what another spans from its wheels to its bearing,
  /// unless its own bearing stands within that, too.
  [[nodiscard]] bool emerges(int link, double level) const;
  /// The first free slot outside of everything on the bearing side.
  [[nodiscard]] double outerSlot() const;
};

/// The axis classes with their wheels, crossings and the bearings still without a place. Of no use when
/// `stop` was requested meanwhile. Cost: O(joints + gears), and the
/// square of the classes that one link holds.
[[nodiscard]] std::vector<AxisLayout> axisLayouts(const Mechanism& mechanism, const Placement& placement,
                                                  const GearTrain& train, const std::stop_token& stop = {});

}  // namespace geargraph::inline arrangement

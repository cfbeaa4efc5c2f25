#pragma once

#include <Eigen/Core>
#include <vector>

#include "core/machine/train/train.h"

namespace geargraph::inline arrangement {

/// The room that the gears of a train take up while they turn: a disc each, a bevel what its tips sweep. For
/// bodies that have to pass them.
class GearObstacles {
 public:
  explicit GearObstacles(const GearTrain& train);

  /// Gears across `axis` that stand within `half` of the plane through `point`.
  [[nodiscard]] std::vector<std::size_t> inPlane(const Eigen::Vector3d& point, const Eigen::Vector3d& axis,
                                                 double half) const;
  /// Does a straight bar from a to b, in the plane that the gears were asked for, stay `margin` off their
  /// teeth?
  [[nodiscard]] bool isClear(const std::vector<std::size_t>& gears, const Eigen::Vector3d& a,
                             const Eigen::Vector3d& b, double margin) const;
  /// How many of some places along the bar, its first left out, lie in gears of other links or within
  /// `margin`.
  [[nodiscard]] int hits(int link, const Eigen::Vector3d& a, const Eigen::Vector3d& b, double margin) const {
    return hits(link, a, b, margin, nullptr);
  }
  /// The same of gears on axes that are not parallel to `axis`.
  [[nodiscard]] int crossingHits(int link, const Eigen::Vector3d& a, const Eigen::Vector3d& b, double margin,
                                 const Eigen::Vector3d& axis) const {
    return hits(link, a, b, margin, &axis);
  }

 private:
  struct Gear {
    int link = 0;
    bool ring = false;
    Eigen::Vector3d origin, axis;
    double low = 0, high = 0;  ///< along the axis from the origin
    double tip = 0;            ///< radius; of a ring the inner one
    double slope = 0;          ///< bevels: the tip's radius grows by this along the axis; 0: discs
    Eigen::Vector3d middle;
    double reach = 0;  ///< of the sphere about `middle` that holds it
  };
  [[nodiscard]] int hits(int link, const Eigen::Vector3d& a, const Eigen::Vector3d& b, double margin,
                         const Eigen::Vector3d* across) const;
  [[nodiscard]] static bool isNear(const Gear& gear, const Eigen::Vector3d& p, double margin);

  std::vector<Gear> m_gears;
};

}  // namespace geargraph::inline arrangement

#pragma once

#include <Eigen/Core>
#include <vector>

#include "core/machine/train/train.h"

namespace geargraph {

/// The swept envelopes of the turning gears of a train, for routing bodies past them: a disc each, for a
/// bevel the volume swept by its tips.
class GearObstacles {
 public:
  explicit GearObstacles(const GearTrain& train);

  /// Gears on axes parallel to `axis` within the distance `half` of the plane through `point` normal to it.
  [[nodiscard]] std::vector<std::size_t> inPlane(const Eigen::Vector3d& point, const Eigen::Vector3d& axis,
                                                 double half) const;
  /// Does a straight bar from a to b, in the plane given to inPlane(), keep the distance `margin` from the
  /// teeth of these gears?
  [[nodiscard]] bool isClear(const std::vector<std::size_t>& gears, const Eigen::Vector3d& a,
                             const Eigen::Vector3d& b, double margin) const;
  /// The number of collisions: of sample points along the bar from a to b, without the first, those inside or
  /// within `margin` of gears of other links.
  [[nodiscard]] int collisions(LinkOrdinal link, const Eigen::Vector3d& a, const Eigen::Vector3d& b,
                               double margin) const {
    return collisions(link, a, b, margin, nullptr);
  }
  /// The same for gears on axes that are not parallel to `axis` only.
  [[nodiscard]] int nonParallelCollisions(LinkOrdinal link, const Eigen::Vector3d& a,
                                          const Eigen::Vector3d& b, double margin,
                                          const Eigen::Vector3d& axis) const {
    return collisions(link, a, b, margin, &axis);
  }

 private:
  struct Gear {
    LinkOrdinal link = 0;
    bool ring = false;
    Eigen::Vector3d origin, axis;
    double low = 0, high = 0;  ///< along the axis from the origin
    double tip = 0;            ///< radius; of a ring the inner one
    double slope = 0;          ///< bevels: the tip's radius grows by this along the axis; 0: discs
    Eigen::Vector3d middle;
    double reach = 0;  ///< of the sphere about `middle` that holds it
  };
  [[nodiscard]] int collisions(LinkOrdinal link, const Eigen::Vector3d& a, const Eigen::Vector3d& b,
                               double margin, const Eigen::Vector3d* across) const;
  [[nodiscard]] static bool isNear(const Gear& gear, const Eigen::Vector3d& p, double margin);

  std::vector<Gear> m_gears;
};

}  // namespace geargraph

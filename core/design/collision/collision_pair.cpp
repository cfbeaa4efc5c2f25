#include "core/design/collision/collision_pair.h"

#include <fcl/narrowphase/detail/traversal/collision/mesh_collision_traversal_node.h>
#include <fcl/narrowphase/detail/traversal/collision_node.h>
#include <fcl/narrowphase/detail/traversal/distance/mesh_distance_traversal_node.h>

#include <algorithm>
#include <cmath>

#include "core/design/collision/collision_shape.h"
#include "core/foundations/base/contract.h"

namespace geargraph {
namespace {

/// Distances are asked for up to this relative error, which is on the safe side of what is stepped.
constexpr double kDistanceError = 0.3;

}  // namespace

CollisionPair::CollisionPair(const CollisionPart& p, const CollisionPart& q, const RelativeMotion& motion,
                             double speed, const CollisionResolution& resolution)
    : m_p(p),
      m_q(q),
      m_motion(motion),
      m_speed(speed),
      m_step(resolution.step * std::min(p.module, q.module) / speed),
      m_precision(resolution.bisection * m_step) {}

double CollisionPair::distanceAt(double time, std::int64_t& budget) const {
  const Eigen::Isometry3d placed = m_motion.displacement(time);
  --budget;
  const double balls = (placed * m_q.centre - m_p.centre).norm() - m_p.radius - m_q.radius;
  if (balls > 0.2 * (m_p.radius + m_q.radius)) return balls;
  const fcl::DistanceRequestd request(false, false, kDistanceError, 0);
  fcl::DistanceResultd result;
  fcl::detail::MeshDistanceTraversalNodeOBBRSSd node;
  const bool isReady = fcl::detail::initialize(node, m_p.shape->model(), Eigen::Isometry3d::Identity(),
                                               m_q.shape->model(), placed, request, result);
  GEARGRAPH_REQUIRE(isReady);
  node.enableStatistics(true);
  fcl::detail::distance(&node);
  budget -= node.num_bv_tests + node.num_leaf_tests;
  return std::max(0.0, result.min_distance) / (1 + kDistanceError);
}

bool CollisionPair::touchAt(double time, std::int64_t& budget) const {
  const fcl::CollisionRequestd request(1, false);
  fcl::CollisionResultd result;
  fcl::detail::MeshCollisionTraversalNodeOBBRSSd node;
  const bool isReady =
      fcl::detail::initialize(node, m_p.shape->model(), Eigen::Isometry3d::Identity(), m_q.shape->model(),
                              m_motion.displacement(time), request, result);
  GEARGRAPH_REQUIRE(isReady);
  node.enableStatistics(true);
  fcl::detail::collide(&node);
  budget -= 1 + node.num_bv_tests + node.num_leaf_tests;
  return result.isCollision();
}

std::optional<double> CollisionPair::firstContact(double until, std::int64_t& budget,
                                                  const std::stop_token& stop) const {
  const double sense = until < 0 ? -1 : 1;
  const double end = std::abs(until);
  double clear = 0;  // the latest time at which they were seen apart
  for (double time = 0; time <= end;) {
    if (stop.stop_requested() || budget < 0) return std::nullopt;
    const double distance = distanceAt(sense * time, budget);
    if (distance <= 0 && touchAt(sense * time, budget)) {
      double touching = time;
      while (touching - clear > m_precision) {
        const double middle = (clear + touching) / 2;
        (touchAt(sense * middle, budget) ? touching : clear) = middle;
      }
      return sense * touching;
    }
    clear = time;
    if (time == end) break;
    time = std::min(end, time + std::max(distance / m_speed, m_step));
  }
  return std::nullopt;
}

}  // namespace geargraph

#pragma once

#include <cstdint>
#include <optional>
#include <stop_token>

#include "core/collision/relative_motion.h"

namespace geargraph {

/// How finely the motion of two parts is followed.
struct CollisionResolution {
  /// Parts that are nearer than this are looked at again whenever a point of one can have moved so far
  /// against the other, modules: a contact that lasts for less is missed.
  double step = 0.1;
  /// To which a time of first contact is found, as a part of that step.
  double bisection = 0.01;
};

/// Two parts that move against each other.
class CollisionPair {
 public:
  CollisionPair(const CollisionPart& p, const CollisionPart& q, const RelativeMotion& motion, double speed,
                const CollisionResolution& resolution = {});

  /// The first time of contact from 0 to `until` (negative: backwards), by conservative advancement: where
  /// the parts are a distance d apart they cannot touch before d / speed has passed. Nothing where they do
  /// not touch, the queries are used up, or `stop` was requested. `queries`: how many more distances may be
  /// asked for; counted down. Cost: a distance of two bounding volume hierarchies a step, some tens of
  /// microseconds.
  [[nodiscard]] std::optional<double> firstContact(double until, std::int64_t& queries,
                                                   const std::stop_token& stop) const;

 private:
  [[nodiscard]] double distanceAt(double time) const;
  [[nodiscard]] bool touchAt(double time) const;

  const CollisionPart& m_p;
  const CollisionPart& m_q;
  const RelativeMotion& m_motion;
  double m_speed;
  double m_step;       ///< s
  double m_precision;  ///< s
};

}  // namespace geargraph

#pragma once

#include <cstdint>
#include <optional>
#include <stop_token>

#include "core/design/collision/relative_motion.h"

namespace geargraph {

/// The resolution of a collision check in time.
struct CollisionResolution {
  /// Parts that are nearer than this are tested whenever a point of one can have moved by this much relative
  /// to the other, modules; a shorter contact is missed.
  double step = 0.1;
  /// The precision of the time of first contact, as a fraction of `step`.
  double bisection = 0.01;
};

/// Two parts in relative motion. The arguments outlive it.
class CollisionPair {
 public:
  CollisionPair(const CollisionPart& p, const CollisionPart& q, const RelativeMotion& motion, double speed,
                const CollisionResolution& resolution = {});

  /// The first time of contact from 0 to `until` (negative: backwards), by conservative advancement: where
  /// the parts are a distance d apart they cannot touch before d / speed has passed. std::nullopt if they do
  /// not touch, the budget is spent, or cancelled. `budget`: the remaining number of tests of two bounding
  /// volumes or two triangles; counted down, below 0 when spent. Cost: per step a distance of two bounding
  /// volume hierarchies, some tens of microseconds; per test about a tenth of one.
  [[nodiscard]] std::optional<double> firstContact(double until, std::int64_t& budget,
                                                   const std::stop_token& stop) const;

 private:
  [[nodiscard]] double distanceAt(double time, std::int64_t& budget) const;
  [[nodiscard]] bool touchAt(double time, std::int64_t& budget) const;

  const CollisionPart& m_p;
  const CollisionPart& m_q;
  const RelativeMotion& m_motion;
  double m_speed;
  double m_step;       ///< s
  double m_precision;  ///< s
};

}  // namespace geargraph

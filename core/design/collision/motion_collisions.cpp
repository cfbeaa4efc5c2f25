#include "core/design/collision/motion_collisions.h"

#include <fcl/broadphase/broadphase_dynamic_AABB_tree.h>
#include <fcl/geometry/shape/box.h>
#include <fcl/narrowphase/collision_object.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <memory>
#include <numbers>
#include <tuple>
#include <utility>

#include "core/design/collision/collision_pair.h"
#include "core/design/collision/collision_shape.h"

namespace geargraph {
namespace {

using Pairs = std::vector<std::pair<std::size_t, std::size_t>>;

/// Triangles whose extents about the lines of a motion are found in the time of a test.
constexpr std::int64_t kTrianglesATest = 4;

/// The pairs of parts of different links whose swept boxes overlap, in the order of the parts.
class BroadPhase {
 public:
  BroadPhase(std::span<const CollisionPart> parts, const JointRates& motion) : m_parts(parts) {
    for (std::size_t i = 0; i < parts.size(); ++i) {
      const Eigen::AlignedBox3d box = sweptBox(motion, parts[i]);
      Eigen::Isometry3d placed = Eigen::Isometry3d::Identity();
      placed.translation() = box.center();
      m_objects.push_back(
          std::make_unique<fcl::CollisionObjectd>(std::make_shared<fcl::Boxd>(box.sizes()), placed));
      m_index.emplace(m_objects.back().get(), i);
      m_manager.registerObject(m_objects.back().get());
    }
    m_manager.setup();
  }

  /// Each costs kPairWork of the budget; some are missing when it is spent, or if cancelled.
  [[nodiscard]] Pairs pairs(std::int64_t& budget, const std::stop_token& stop) {
    m_budget = &budget;
    m_stop = &stop;
    m_manager.collide(this, [](fcl::CollisionObjectd* a, fcl::CollisionObjectd* b, void* self) {
      return static_cast<BroadPhase*>(self)->add(a, b);
    });
    std::sort(m_pairs.begin(), m_pairs.end());
    return std::move(m_pairs);
  }

 private:
  /// Is it to end?
  bool add(fcl::CollisionObjectd* a, fcl::CollisionObjectd* b) {
    std::size_t one = m_index.at(a);
    std::size_t other = m_index.at(b);
    *m_budget -= kPairWork;
    if (*m_budget < 0 || m_stop->stop_requested()) return true;
    if (m_parts[one].link == m_parts[other].link) return false;
    if (m_parts[one].link > m_parts[other].link) std::swap(one, other);
    m_pairs.emplace_back(one, other);
    return false;
  }

  std::span<const CollisionPart> m_parts;
  std::vector<std::unique_ptr<fcl::CollisionObjectd>> m_objects;
  std::map<const fcl::CollisionObjectd*, std::size_t> m_index;
  fcl::DynamicAABBTreeCollisionManagerd m_manager;
  Pairs m_pairs;
  std::int64_t* m_budget = nullptr;
  const std::stop_token* m_stop = nullptr;
};

class MotionSearch {
 public:
  MotionSearch(std::span<const CollisionPart> parts, const JointRates& motion, const MotionRange& range,
               const std::stop_token& stop, const MotionCheckOptions& options)
      : m_parts(parts), m_motion(motion), m_range(range), m_stop(stop), m_options(options) {}

  MotionCheck run() {
    std::int64_t budget = m_options.mostTests;
    for (const auto& [one, other] : BroadPhase(m_parts, m_motion).pairs(budget, m_stop)) {
      if (m_stop.stop_requested() || budget < 0) break;
      examine(m_parts[one], m_parts[other], budget);
    }
    m_check.isComplete = !m_stop.stop_requested() && budget >= 0;
    m_check.to = std::min(m_uncovered, std::isfinite(m_range.to) ? m_range.to : m_longest);
    m_check.isLimited = m_range.isLimited();
    if (m_check.isLimited)
      m_check.from = 0 - std::min(m_uncovered, std::isfinite(m_range.from) ? -m_range.from : m_longest);
    for (const auto& [links, time] : m_first) m_check.collisions.push_back({links.first, links.second, time});
    const auto key = [](const MotionCollision& c) {
      return std::tuple(c.time < 0, std::abs(c.time), c.one, c.other);
    };
    std::sort(m_check.collisions.begin(), m_check.collisions.end(),
              [&](const MotionCollision& a, const MotionCollision& b) { return key(a) < key(b); });
    return std::move(m_check);
  }

 private:
  void examine(const CollisionPart& p, const CollisionPart& q, std::int64_t& budget) {
    const RelativeMotion relative(m_motion, p, q);
    if (!relative.isMoving()) return;
    const double period = relative.period();
    const double stretch = m_options.mostTurns * 2 * std::numbers::pi / relative.fastestRate();
    if (!std::isfinite(stretch)) return;  // so slow that a turn takes longer than any number
    const bool repeats = period > 0 && period <= stretch * (1 + 1e-9);
    const double longest = repeats ? period : stretch;
    const double ahead = std::min(longest, m_range.to);
    const double back = m_range.isLimited() ? std::max(-longest, m_range.from) : 0;
    m_longest = std::max(m_longest, longest);
    budget -= (p.shape->model().num_tris + q.shape->model().num_tris) / kTrianglesATest;
    const PairBounds bounds = pairBounds(relative, p, q);
    if (bounds.isClear) return;
    if (!repeats && (m_range.to > longest || (back < 0 && m_range.from < -longest))) {
      m_check.coversAll = false;
      m_uncovered = std::min(m_uncovered, longest);
    }

    const CollisionPair pair(p, q, relative, bounds.speed);
    const std::pair links(p.link, q.link);
    const auto found = m_first.find(links);
    const bool isForward = found != m_first.end() && found->second >= 0;
    if (const auto time = pair.firstContact(isForward ? found->second : ahead, budget, m_stop)) {
      m_first[links] = *time;
    } else if (back < 0 && !isForward) {
      const double until = found != m_first.end() ? found->second : back;
      if (const auto before = pair.firstContact(until, budget, m_stop)) m_first[links] = *before;
    }
  }

  std::span<const CollisionPart> m_parts;
  const JointRates& m_motion;
  const MotionRange& m_range;
  const std::stop_token& m_stop;
  const MotionCheckOptions& m_options;
  MotionCheck m_check;
  double m_longest = 0;                                          ///< s for which a pair was followed
  double m_uncovered = std::numeric_limits<double>::infinity();  ///< the least of those that do not repeat
  std::map<std::pair<int, int>, double> m_first;                 ///< contact by links
};

}  // namespace

MotionCheck motionCollisions(std::span<const CollisionPart> parts, const JointRates& motion,
                             const MotionRange& range, const std::stop_token& stop,
                             const MotionCheckOptions& options) {
  return MotionSearch(parts, motion, range, stop, options).run();
}

}  // namespace geargraph

#pragma once

#include <span>
#include <stop_token>
#include <vector>

#include "core/design/collision/collision_parts.h"
#include "core/design/collision/relative_motion.h"
#include "core/theory/pose/joint_limits.h"

namespace geargraph {

/// A collision of two links in motion.
struct MotionCollision {
  int one = 0;  ///< positions of the links, the smaller first
  int other = 0;
  double time = 0;  ///< s, of the first contact; negative: only when the motion runs backwards
  friend bool operator==(const MotionCollision&, const MotionCollision&) = default;
};

/// The result of a collision check, and its extent.
struct MotionCheck {
  std::vector<MotionCollision>
      collisions;  ///< by time, those of the forward motion first; one per pair of links
  /// s: all pairs of parts were followed from `from` to `to`, each until it repeats; `from` is below 0 where
  /// limits let the motion run backwards. Both are 0 where nothing bounds the motion and the distance of no
  /// two parts changes, so that nothing can collide.
  double from = 0;
  double to = 0;
  /// Was all of the motion examined: up to the limits of the joints, or until each pair of parts repeats?
  bool coversAll = true;
  bool isLimited = false;  ///< the limits of joints bound the motion
  bool isComplete = true;  ///< false: cancelled, or the budget was spent; pairs may be missing
};

/// The cost of finding a pair and its relative motion in the broad phase, in tests.
constexpr std::int64_t kPairWork = 10;

struct MotionCheckOptions {
  /// The most turns of the fastest joint between two parts whose relative motion does not repeat sooner.
  double mostTurns = 20;
  /// The most tests of two bounding volumes or two triangles in total, about a tenth of a microsecond each;
  /// the work before them for a pair of parts counts as kPairWork.
  std::int64_t mostTests = 20'000'000;
};

/// Checks the parts of different links for collisions over the motion that starts in the reference pose.
///
/// Pairs: only parts whose distance can change (RelativeMotion). Intended contacts need no exemption list:
/// where teeth mesh, a shaft turns in a bearing or a wheel on its shaft, one of the two parts is a solid of
/// revolution about the line of the turn, so their distance stays that of the reference pose, which the
/// train's own diagnostics cover.
///
/// Duration: until the relative motion of the two parts repeats (about one line: one turn), but at most
/// `mostTurns` of the fastest joint between them; where joints have limits, within `range` and both ways.
///
/// Resolution: conservative advancement (CollisionPair). A contact during which no point moves by a tenth of
/// a module may be missed. Parts that overlap in the reference pose are reported at time 0.
///
/// Cost: a broad phase over the boxes that the parts sweep, then some tens of microseconds per step for each
/// pair that comes near; at most `mostTests` in all (tests/bench/bench_scene.cpp, motionCheck). The token is
/// polled for each pair and each step.
[[nodiscard]] MotionCheck motionCollisions(std::span<const CollisionPart> parts, const JointRates& motion,
                                           const MotionRange& range, const std::stop_token& stop = {},
                                           const MotionCheckOptions& options = {});

}  // namespace geargraph

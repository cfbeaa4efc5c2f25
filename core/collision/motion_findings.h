#pragma once

#include <optional>
#include <stop_token>

#include "core/analysis/analysis.h"
#include "core/collision/motion_collisions.h"

namespace geargraph {

/// Larger mechanisms are not checked: all their parts would be compared with each other.
constexpr int kMostCheckedLinks = 300;

/// Pairs of links that are reported one by one, the earliest first.
constexpr std::size_t kMostMotionFindings = 20;

/// The motion of a mechanism with its inputs at their speeds, and what collides in it.
struct MotionReport {
  MotionCheck check;
  /// One `interference` a pair of links, with the time at which they meet. Links of which the train's
  /// findings say already that they overlap in the reference pose are left out.
  Diagnostics diagnostics;
};

/// Makes the solids of the mechanism, its wheels at their tips, and moves them through the motion
/// (motionCollisions()). 3D files that are attached to links are ignored.
///
/// std::nullopt if the mechanism has errors, no valid inputs, no motion or more than kMostCheckedLinks, or if
/// cancelled.
[[nodiscard]] std::optional<MotionReport> checkMotion(const AnalysisSnapshot& snapshot,
                                                      const std::stop_token& stop = {},
                                                      const MotionCheckOptions& options = {});

}  // namespace geargraph

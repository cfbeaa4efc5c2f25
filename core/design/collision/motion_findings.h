#pragma once

#include <optional>
#include <stop_token>
#include <string>

#include "core/design/collision/motion_collisions.h"
#include "core/theory/analysis/analysis.h"

namespace geargraph::inline collision {

/// Larger mechanisms are not checked: all their parts would be compared with each other.
constexpr int kMostCheckedLinks = 300;

/// Pairs of links that are reported one by one, the earliest first.
constexpr std::size_t kMostMotionFindings = 20;

/// The motion of a mechanism with its inputs at their speeds, and what collides in it.
struct MotionReport {
  MotionCheck check;
  /// One `interference/motion-collision` a pair of links, with the time of their first contact. Pairs that
  /// the train's diagnostics report as overlapping in the reference pose are left out.
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

/// "4.5 s"; below 1 s with two digits that count.
[[nodiscard]] std::string secondsText(double seconds);

/// One sentence on motion that was not checked, for a person: too many links, the budget spent, or no
/// repetition within what was checked. Empty if all of it was checked, or nothing is known yet (`report`
/// null).
[[nodiscard]] std::string motionNote(const AnalysisSnapshot& snapshot, const MotionReport* report);

}  // namespace geargraph::inline collision

#pragma once

#include <optional>
#include <stop_token>
#include <string>

#include "core/design/collision/motion_collisions.h"
#include "core/theory/analysis/analysis.h"

namespace geargraph {

/// Larger mechanisms are not checked, because all pairs of parts would have to be compared.
constexpr int kMaxCheckedLinks = 300;

/// The most pairs of links that are reported individually, the earliest first.
constexpr std::size_t kMaxMotionDiagnostics = 20;

/// The motion of a mechanism with its inputs at their speeds, and what collides in it.
struct MotionReport {
  MotionCheck check;
  /// One `interference/motion-collision` per pair of links, with the time of their first contact. Pairs that
  /// the train's diagnostics report as overlapping in the reference pose are left out.
  Diagnostics diagnostics;
};

/// Makes the solids of the mechanism, its wheels at their tips, and moves them through the motion
/// (motionCollisions()). 3D files that are attached to links are ignored.
///
/// std::nullopt if the mechanism has errors, no valid inputs, no motion or more than kMaxCheckedLinks, or if
/// cancelled.
[[nodiscard]] std::optional<MotionReport> checkMotion(const AnalysisSnapshot& snapshot,
                                                      const std::stop_token& stop = {},
                                                      const MotionCheckOptions& options = {});

/// "4.5 s"; below 1 s with two significant digits.
[[nodiscard]] std::string secondsText(double seconds);

/// One sentence for the user on motion that was not checked: too many links, the budget spent, or no
/// repetition within what was checked. Empty if everything was checked, or there is no result yet (`report`
/// null).
[[nodiscard]] std::string motionNote(const AnalysisSnapshot& snapshot, const MotionReport* report);

}  // namespace geargraph

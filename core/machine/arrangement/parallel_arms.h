#pragma once

#include <vector>

#include "core/machine/arrangement/plan_draft.h"

namespace geargraph::inline arrangement {

// Bearings on axes that are parallel to their holder's, and the arms in one plane that hold them.

/// A straight bar between two axes.
struct AxisBar {
  int from = 0;  ///< axis classes
  int to = 0;
};

/// The axis that a link's arms start from: its own. The ground's is the one of those that most others are
/// parallel to that has most bearings, so that one arm does for them; the last of these.
/// @pre the link holds a bearing
[[nodiscard]] int homeOf(const PlanDraft& draft, int link);

/// Keeps places beside the wheels free for carriers that found none the last time, and what their arms go
/// round (PlanTries), until releaseRoom().
void reserveRoom(PlanDraft& draft);
void releaseRoom(PlanDraft& draft);

/// The bearings that a link holds and that have no place yet, a round at a time: one of each axis parallel to
/// its own (its own included), those whose wheels are nearest the bearings' end first.
[[nodiscard]] std::vector<std::vector<Bearing*>> roundsOf(PlanDraft& draft, int link, int home);

/// The straight bars that join the bearings of a round: a frame's from each to the nearest, a carrier's from
/// its own axis, unless another eye stands in the way, which it then starts from.
[[nodiscard]] std::vector<AxisBar> barsOf(const PlanDraft& draft, int link, int home,
                                          const std::vector<Bearing*>& round, double level);

/// Gives the bearings of a round the level that is free on all of their axes and nearest to where they are
/// drawn, and the arms to there. Bearings of the ground for which there is none get feet of their own;
/// carriers are then blocked, and want room.
void placeParallel(PlanDraft& draft, int link, int home, std::vector<Bearing*> round);

}  // namespace geargraph::inline arrangement

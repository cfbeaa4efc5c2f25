#pragma once

#include <vector>

#include "core/machine/body_layout/plan_draft.h"

namespace geargraph {

// Bearings on axes parallel to that of the link that holds them, and the arms in one plane that support them.

/// A straight bar between two axes.
struct AxisBar {
  int from = 0;  ///< axis classes
  int to = 0;
};

/// The axis class that a link's arms start from: its own. For the ground, among the axes with the most
/// parallel ones the one with the most bearings, so that these need one arm; the last of several.
/// @pre the link holds a bearing
[[nodiscard]] int homeOf(const PlanDraft& draft, LinkOrdinal link);

/// Reserves places beside the wheels for carriers that found none in the previous try, and the interval that
/// their arms sweep (PlanTries), until releaseSlots().
void reserveSlots(PlanDraft& draft);
void releaseSlots(PlanDraft& draft);

/// The unplaced bearings that a link holds, in rounds: each has one bearing per axis parallel to the link's
/// (including its own), those whose wheels are nearest the bearing side first.
[[nodiscard]] std::vector<std::vector<Bearing*>> roundsOf(PlanDraft& draft, LinkOrdinal link,
                                                          AxisGroupOrdinal home);

/// The straight bars that join the bearings of a round: for the frame from each to the nearest, for a carrier
/// from its own axis, unless another boss is in between, from which it then starts.
[[nodiscard]] std::vector<AxisBar> barsOf(const PlanDraft& draft, LinkOrdinal link, AxisGroupOrdinal home,
                                          const std::vector<Bearing*>& round, double level);

/// Places the bearings of a round at the level that is free on all of their axes and nearest to where they
/// are drawn, and adds the arms. If there is no such level, bearings of the ground get pedestals of their
/// own; carriers are reported as blocked and recorded in wantSlots.
void placeParallel(PlanDraft& draft, LinkOrdinal link, AxisGroupOrdinal home, std::vector<Bearing*> round);

}  // namespace geargraph

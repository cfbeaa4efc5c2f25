#pragma once

#include <vector>

#include "core/gears/body_plan.h"

namespace geargraph {

/// Pairs of links whose planned bodies run into each other or into the gears of the other, the smaller link
/// first: what stands on crossing axes, and posts, for levels keep apart what stands on parallel ones. In the
/// reference pose, as hulls of discs (disc_hull.h); rings, drums and cups, which are hollow, are left out.
/// Cost: O(parts^2), most of them by their balls.
[[nodiscard]] std::vector<std::vector<int>> clashingLinks(const BodyPlan& plan, const GearTrain& train);

}  // namespace geargraph

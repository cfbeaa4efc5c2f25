#pragma once

#include "core/machine/train/train_wheels.h"

namespace geargraph::inline train {

/// Do two bevel wheels on one line take up the same room, as their outlines in the half plane through the
/// line say? Bores count as filled. False for wheels on other lines.
[[nodiscard]] bool bevelsCollide(const TrainWheel& a, const TrainWheel& b);

/// The same of bevel wheels anywhere, from points of the outlines at some paces round the axes: what overlaps
/// by less than the smaller module, or where both have more than 330 teeth by less than a 250th of the
/// smaller radius, may go unseen, wherever the two are turned to alike. Cost: some 0.1 ms at 20 teeth, 10 ms
/// at most at any number (tests/bench/bench_gears.cpp).
[[nodiscard]] bool bevelsCross(const TrainWheel& a, const TrainWheel& b);

}  // namespace geargraph::inline train

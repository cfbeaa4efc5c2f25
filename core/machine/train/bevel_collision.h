#pragma once

#include "core/machine/train/train_wheels.h"

namespace geargraph {

/// Do two coaxial bevel wheels overlap, judged by their outlines in the half plane through the line? Bores
/// count as filled. False for wheels on different lines.
[[nodiscard]] bool bevelsCollide(const TrainWheel& a, const TrainWheel& b);

/// The same for bevel wheels anywhere, by sample points of the outlines at steps around the axes: an overlap
/// below the smaller module, or if both have more than 330 teeth below a 250th of the smaller radius, may be
/// missed. The result does not depend on the orientation of the train. Cost: some 0.1 ms at 20 teeth, 10 ms
/// at most at any number (tests/bench/bench_gears.cpp).
[[nodiscard]] bool bevelsCross(const TrainWheel& a, const TrainWheel& b);

}  // namespace geargraph

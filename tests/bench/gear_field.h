#pragma once

#include "core/presentation/scene/scene.h"

namespace geargraph::bench {

/// A square of so many gears of 60 teeth, each turned by an angle of its own. `shapes`: how many different
/// gears there are among them; their widths differ.
[[nodiscard]] Scene gearField(int count, int shapes = 1);

}  // namespace geargraph::bench

#pragma once

#include <string>
#include <vector>

#include "core/presentation/drawing/display_list.h"
#include "core/theory/vibration/frequency_lines.h"

namespace geargraph {

/// The lines of a motion over a logarithmic axis of orders (cycles a turn of the reference shaft), from a
/// power of ten to a power of ten. Where lines are is exact up to a pixel; how high and in which dashes they
/// are tells what repeats, not how strongly. Tooth meshes, shafts and planets bear their labels; equal
/// frequencies share one. `xTitle`: of the axis; `without`: what is written where there are no lines.
/// Cost: O(lines log lines).
[[nodiscard]] DisplayList spectrumDrawing(const Mechanism& mechanism, const std::vector<FrequencyLine>& lines,
                                          const std::string& xTitle, const std::string& without);

}  // namespace geargraph

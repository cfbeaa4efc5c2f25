#pragma once

#include <cstddef>
#include <utility>
#include <vector>

#include "core/presentation/pages/flow.h"

namespace geargraph::inline pages {

/// Strips of one page: the position of each in its list, and how far below the top of the body it begins.
struct FlowPage {
  std::vector<std::pair<std::size_t, double>> lines;
};

/// Parts strips into pages with a body of this height, at least one. Strips that no page's end parts go to a
/// page together, where they are not taller than one. Cost: linear in the strips.
[[nodiscard]] std::vector<FlowPage> flowPages(const std::vector<FlowLine>& lines, double body);

/// The name of the mechanism and what the document is, before the first heading; blocks of none.
[[nodiscard]] std::vector<FlowLine> titleLines(const SetReport& report, const FlowLook& flow,
                                               const WordMeasure& measure);

}  // namespace geargraph::inline pages

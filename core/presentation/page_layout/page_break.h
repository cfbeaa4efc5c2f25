#pragma once

#include <cstddef>
#include <utility>
#include <vector>

#include "core/presentation/page_layout/flow.h"

namespace geargraph {

/// Strips of one page: the position of each in its list, and how far below the top of the body it begins.
struct FlowPage {
  std::vector<std::pair<std::size_t, double>> lines;
};

/// Distributes strips over pages with a body of this height; at least one page. Strips that keep with the
/// next one go to the same page, unless together they are taller than a page. Cost: linear in the strips.
[[nodiscard]] std::vector<FlowPage> flowPages(const std::vector<FlowLine>& lines, double body);

/// The name of the mechanism and what the document is, before the first heading; they belong to no block.
[[nodiscard]] std::vector<FlowLine> titleLines(const SetReport& report, const FlowParameters& flow,
                                               const WordMeasure& measure);

}  // namespace geargraph

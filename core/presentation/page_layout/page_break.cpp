#include "core/presentation/page_layout/page_break.h"

#include "core/presentation/page_layout/paragraph.h"

namespace geargraph {

std::vector<FlowPage> flowPages(const std::vector<FlowLine>& lines, double body) {
  std::vector<FlowPage> pages(1);
  double used = 0;
  for (std::size_t begin = 0; begin < lines.size();) {
    std::size_t end = begin;
    double height = 0;
    do {
      height += (end > begin ? lines[end].above : 0) + lines[end].height;
    } while (lines[end++].keepsWithNext && end < lines.size());
    const bool isNew = pages.back().lines.empty();
    if (!isNew && used + lines[begin].above + height > body) {
      pages.emplace_back();
      used = 0;
    }
    for (; begin < end; ++begin) {
      double top = used + (pages.back().lines.empty() ? 0 : lines[begin].above);
      if (!pages.back().lines.empty() && top + lines[begin].height > body) {
        pages.emplace_back();
        top = 0;
      }
      pages.back().lines.emplace_back(begin, top);
      used = top + lines[begin].height;
    }
  }
  return pages;
}

std::vector<FlowLine> titleLines(const SetReport& report, const FlowParameters& flow,
                                 const WordMeasure& measure) {
  const std::size_t none = report.report().blocks.size();
  std::vector<FlowLine> lines = paragraphLines(report, {{report.report().title, false}},
                                               {1.9 * flow.size, true, false}, flow, measure, 0, flow.width);
  for (FlowLine& line : paragraphLines(report, {{report.report().subtitle, false}},
                                       {1.1 * flow.size, false, true}, flow, measure, 0, flow.width)) {
    lines.push_back(std::move(line));
  }
  for (FlowLine& line : lines) {
    line.block = none;
    line.keepsWithNext = true;
  }
  return lines;
}

}  // namespace geargraph

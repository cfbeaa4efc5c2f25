#include "core/presentation/page_layout/equation_flow.h"

#include <algorithm>
#include <array>

#include "core/foundations/base/translation.h"

namespace geargraph {
namespace {

using Lines = std::vector<SetReport::SetLine>;

constexpr double kGapOfLines = 0.45;     // em, between the lines of one equation
constexpr double kGapOfParts = 1;        // em, between the parts of a matrix
constexpr double kTallLine = 4;          // em: nothing but a matrix is as tall
constexpr double kLeastUnbroken = 0.75;  // smaller than this a formula is broken first
constexpr std::size_t kMaxKept = 12;     // lines of an equation that stay on one page

double widthOf(const Lines& lines) {
  double width = 0;
  for (const auto& line : lines) width = std::max(width, line.box->width);
  return width;
}
double tallest(const Lines& lines) {
  double height = 0;
  for (const auto& line : lines) height = std::max(height, line.box->height + line.box->depth);
  return height;
}

struct Fit {
  Lines lines;
  double part = 1;  ///< of the size
  bool fits = true;
};

class EquationFitter {
 public:
  EquationFitter(const SetReport::SetEquation& set, const FlowParameters& flow, double room)
      : m_set(set), m_flow(flow), m_room(room) {}

  [[nodiscard]] Fit fit() const {
    const double part =
        std::min({1.0, m_room / em(widthOf(m_set.lines)), m_flow.tallest / em(tallest(m_set.lines))});
    const bool isList = m_set.lines.size() > 1;
    if (part == 1 || (!isList && part >= std::max(kLeastUnbroken, m_flow.leastPart))) {
      return {m_set.lines, part};
    }
    for (const double smaller : {1.0, 0.9, 0.8, 0.7, 0.6}) {
      if (smaller < m_flow.leastPart) break;
      Fit broken{brokenTo(m_room / smaller), smaller};
      if (isIn(broken)) return broken;
    }
    if (part >= m_flow.leastPart) return {m_set.lines, part};
    return {brokenTo(m_room / m_flow.leastPart), m_flow.leastPart, false};
  }

 private:
  [[nodiscard]] double em(double length) const { return std::max(length, 1e-9) * m_flow.formulaSize; }
  [[nodiscard]] bool isIn(const Fit& fit) const {
    constexpr double kRounding = 1e-6;
    return em(widthOf(fit.lines)) * fit.part <= m_room + kRounding &&
           em(tallest(fit.lines)) * fit.part <= m_flow.tallest + kRounding;
  }
  [[nodiscard]] Lines brokenTo(double room) const {
    return sharedLines(typesetLines(m_set.formula, room / m_flow.formulaSize));
  }

  const SetReport::SetEquation& m_set;
  const FlowParameters& m_flow;
  double m_room;
};

FlowLine leftOut(const FlowParameters& flow, const std::string& number, double numberWidth) {
  const TextStyle style{flow.size, false, true};
  FlowLine line;
  line.above = 0.6 * flow.size;
  line.height = 1.4 * flow.size;
  line.words.push_back(
      {translated("Too wide for this page; the web page and LaTeX hold it whole."), 0, flow.size, style});
  if (!number.empty()) line.words.push_back({number, flow.width - numberWidth, flow.size, style});
  return line;
}

/// Of a line of "aligned" the element that it is about.
std::optional<ElementId> elementOf(const ReportEquation& equation, std::size_t row) {
  if (equation.elements.size() == 1) return equation.elements.front();
  return row < equation.elements.size() ? std::optional(equation.elements[row]) : std::nullopt;
}

}  // namespace

std::vector<SetReport::SetLine> sharedLines(std::vector<FormulaLine> lines) {
  Lines shared;
  for (FormulaLine& line : lines) {
    shared.push_back({std::make_shared<const FormulaBox>(std::move(line.box)), line.row});
  }
  return shared;
}

std::vector<FlowLine> equationLines(const SetReport::SetEquation& set, const ReportEquation& equation,
                                    const FlowParameters& flow, const WordMeasure& measure) {
  const TextStyle numberStyle{flow.size, false, true};
  const std::string number = equation.number ? "(" + equation.label() + ")" : "";
  const double numberWidth = number.empty() ? 0 : measure.widthOf(number, numberStyle);
  const double room = flow.width - (number.empty() ? 0 : numberWidth + flow.size);
  const Fit fit = EquationFitter(set, flow, room).fit();
  if (!fit.fits && flow.leavesOutWide) return {leftOut(flow, number, numberWidth)};
  const double em = flow.formulaSize * fit.part, width = widthOf(fit.lines) * em;
  const double x = std::max(0.0, std::min((flow.width - width) / 2, room - width));
  std::vector<FlowLine> lines;
  for (std::size_t i = 0; i < fit.lines.size(); ++i) {
    const FormulaBox& box = *fit.lines[i].box;
    FlowLine line;
    const bool isMatrix = box.height + box.depth > kTallLine;
    line.above = (i == 0 ? 0.85 : isMatrix ? kGapOfParts : kGapOfLines) * em;
    const double ascent = std::max(box.height, 0.8) * em, descent = std::max(box.depth, 0.25) * em;
    line.height = ascent + descent;
    line.formulas.push_back({fit.lines[i].box, x, ascent, em});
    line.element = elementOf(equation, fit.lines[i].row);
    const bool kept = fit.lines.size() <= kMaxKept || i == 0 || i + 2 == fit.lines.size();
    line.keepsWithNext = kept && i + 1 < fit.lines.size();
    lines.push_back(std::move(line));
  }
  if (number.empty()) return lines;
  const std::size_t at = lines.size() <= kMaxKept ? (lines.size() - 1) / 2 : lines.size() - 1;
  double y = lines[at].formulas.front().y;
  if (lines.size() <= kMaxKept && lines.size() % 2 == 0) y += (lines[at].height + kGapOfLines * em) / 2;
  lines[at].words.push_back({number, flow.width - numberWidth, y, numberStyle});
  return lines;
}

}  // namespace geargraph

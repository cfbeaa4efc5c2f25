#include "core/presentation/page_layout/flow.h"

#include <algorithm>
#include <numeric>

#include "core/presentation/drawing/svg_writer.h"
#include "core/presentation/page_layout/equation_flow.h"
#include "core/presentation/page_layout/paragraph.h"
#include "core/presentation/typeset/tex_reader.h"

namespace geargraph {
namespace {

constexpr double kAnyWidth = 1e9;

/// Lays out one block after the other.
class FlowWriter {
 public:
  FlowWriter(const SetReport& report, const FlowParameters& flow, const WordMeasure& measure)
      : m_report(report), m_flow(flow), m_measure(measure) {}

  std::vector<FlowLine> all() {
    const auto& blocks = m_report.report().blocks;
    for (m_block = 0; m_block < blocks.size(); ++m_block) std::visit(*this, blocks[m_block]);
    return std::move(m_lines);
  }

  void operator()(const ReportHeading& heading) {
    const TextStyle style{m_flow.size * (heading.level == 1 ? 1.45 : 1.15), true, false};
    std::vector<FlowLine> lines = paragraph({{heading.text, false}}, style, 0, m_flow.width);
    lines.front().above = m_flow.size * (heading.level == 1 ? 2.2 : 1.6);
    for (FlowLine& line : lines) line.keepsWithNext = true;
    put(std::move(lines));
  }
  void operator()(const ReportParagraph& block) {
    std::vector<FlowLine> lines = paragraph(block.words, TextStyle{m_flow.size}, 0, m_flow.width);
    lines.front().above = 0.6 * m_flow.size;
    keepEnds(lines);
    const auto& blocks = m_report.report().blocks;
    const bool leads = m_block + 1 < blocks.size() &&
                       !std::holds_alternative<ReportHeading>(blocks[m_block + 1]) &&
                       !std::holds_alternative<ReportParagraph>(blocks[m_block + 1]);
    lines.back().keepsWithNext = leads;
    put(std::move(lines));
  }
  void operator()(const ReportEquation& equation) {
    put(equationLines(m_report.equation(m_block), equation, m_flow, m_measure));
  }
  void operator()(const ReportList& list) {
    const TextStyle style{m_flow.size};
    const double indent = 1.2 * m_flow.size;
    for (const ReportWords& item : list.items) {
      std::vector<FlowLine> lines = paragraph(item, style, indent, m_flow.width - indent);
      lines.front().above = 0.4 * m_flow.size;
      lines.front().words.insert(lines.front().words.begin(), {"–", 0, firstBaseline(lines.front()), style});
      keepEnds(lines);
      put(std::move(lines));
    }
  }
  void operator()(const ReportFigure& figure) {
    const auto size = m_flow.figureSize ? m_flow.figureSize(figure.drawing) : std::nullopt;
    if (size) putFigure(*size, {figure.drawing}, figure.caption);
  }
  void operator()(const ReportCurves& curves) {
    auto list = std::make_shared<const DisplayList>(chartDrawing(curves.charts));
    const Extent sheet = sheetOf(*list, {});
    const double scale = 2 * m_flow.curvesScale;
    putFigure({scale * sheet.halfWidth, scale * sheet.halfHeight}, {{}, std::move(list)}, curves.caption);
  }
  void operator()(const ReportTable& table) {
    std::vector<ReportWords> head;
    for (const std::string& text : table.head) head.push_back({{text, false}});
    const std::vector<double> widths = columnWidths(table, head);
    FlowLine line = tableRow(head, widths, true);
    line.above = 0.8 * m_flow.size;
    line.keepsWithNext = true;
    put({line});
    for (std::size_t row = 0; row < table.rows.size(); ++row) {
      FlowLine next = tableRow(table.rows[row], widths, false);
      const bool isLast = row + 1 == table.rows.size();
      next.keepsWithNext = !isLast && (table.isWhole || row == 0 || row + 2 == table.rows.size());
      put({next});
    }
  }

 private:
  /// A figure, smaller where it does not fit, and its caption.
  void putFigure(const FlowParameters::FigureSize& size, FlowFigure figure, const std::string& caption) {
    const double part = std::min({1.0, m_flow.width / size.width, 0.42 * m_flow.tallest / size.height});
    figure.width = part * size.width;
    figure.height = part * size.height;
    figure.x = (m_flow.width - figure.width) / 2;
    FlowLine line;
    line.above = 1.2 * m_flow.size;
    line.height = figure.height;
    line.keepsWithNext = true;
    line.figure = std::move(figure);
    put({line});
    const TextStyle style{0.9 * m_flow.size, false, true};
    const double words = m_measure.widthOf(caption, style);
    FlowLine below;
    below.above = 0.4 * m_flow.size;
    below.height = 2 * style.size;
    below.words.push_back({caption, (m_flow.width - words) / 2, style.size, style});
    put({below});
  }

  static double firstBaseline(const FlowLine& line) {
    if (!line.words.empty()) return line.words.front().y;
    return line.formulas.empty() ? 0 : line.formulas.front().y;
  }
  std::vector<FlowLine> paragraph(const ReportWords& words, const TextStyle& style, double x, double width) {
    return paragraphLines(m_report, words, style, m_flow, m_measure, x, width);
  }
  /// Neither its first nor its last line stands alone.
  static void keepEnds(std::vector<FlowLine>& lines) {
    if (lines.size() < 2) return;
    lines.front().keepsWithNext = true;
    lines[lines.size() - 2].keepsWithNext = true;
  }
  void put(std::vector<FlowLine> lines) {
    for (FlowLine& line : lines) {
      line.block = m_block;
      m_lines.push_back(std::move(line));
    }
  }

  [[nodiscard]] double gap() const { return 1.6 * m_flow.size; }
  double naturalWidth(const ReportWords& words) {
    double width = 0;
    for (const ReportSpan& span : words) {
      width += span.isFormula ? m_report.inLine(span.text)->width * m_flow.formulaSize
                              : m_measure.widthOf(span.text, TextStyle{m_flow.size});
    }
    return width;
  }
  /// Formulas do not break.
  double widestFormula(const ReportWords& words) {
    double widest = 0;
    for (const ReportSpan& span : words) {
      if (span.isFormula) widest = std::max(widest, m_report.inLine(span.text)->width * m_flow.formulaSize);
    }
    return widest;
  }
  /// As wide as the widest cell; where that is too much the wide ones share what the narrow ones leave, but
  /// none is narrower than its formulas.
  std::vector<double> columnWidths(const ReportTable& table, const std::vector<ReportWords>& head) {
    std::vector<double> widths;
    std::vector<double> least;
    for (std::size_t column = 0; column < head.size(); ++column) {
      double width = naturalWidth(head[column]);
      double formula = widestFormula(head[column]);
      for (const auto& row : table.rows) {
        if (column >= row.size()) continue;
        width = std::max(width, naturalWidth(row[column]));
        formula = std::max(formula, widestFormula(row[column]));
      }
      widths.push_back(width + 0.01);
      least.push_back(std::max(formula + 0.01, m_flow.size));
    }
    double room = m_flow.width - gap() * static_cast<double>(widths.size() - 1);
    std::vector<std::size_t> open(widths.size());
    std::iota(open.begin(), open.end(), std::size_t{0});
    std::sort(open.begin(), open.end(), [&](std::size_t a, std::size_t b) { return widths[a] < widths[b]; });
    while (!open.empty()) {
      const double share = room / static_cast<double>(open.size());
      const auto needsMore =
          std::find_if(open.begin(), open.end(), [&](std::size_t i) { return least[i] > share; });
      const auto next = needsMore != open.end() ? needsMore : open.begin();
      widths[*next] = std::max(std::min(widths[*next], share), least[*next]);
      room -= widths[*next];
      open.erase(next);
    }
    return widths;
  }
  FlowLine tableRow(const std::vector<ReportWords>& cells, const std::vector<double>& widths, bool isHead) {
    FlowLine row;
    row.isHead = isHead;
    double x = 0, height = 0;
    const double lead = 0.15 * m_flow.size;
    for (std::size_t column = 0; column < widths.size(); ++column) {
      const TextStyle style{m_flow.size, false, isHead};
      double y = lead;
      if (column < cells.size()) {
        for (FlowLine& line : paragraph(cells[column], style, x, widths[column])) {
          for (FlowWords& words : line.words) {
            words.y += y;
            words.cell = static_cast<int>(column);
            row.words.push_back(std::move(words));
          }
          for (FlowFormula& formula : line.formulas) {
            formula.y += y;
            formula.cell = static_cast<int>(column);
            row.formulas.push_back(std::move(formula));
          }
          y += line.height;
        }
      }
      height = std::max(height, y);
      x += widths[column] + gap();
    }
    row.height = height + lead;
    row.rules.push_back({0, row.height, x - gap()});
    return row;
  }

  const SetReport& m_report;
  const FlowParameters& m_flow;
  const WordMeasure& m_measure;
  std::size_t m_block = 0;
  std::vector<FlowLine> m_lines;
};

}  // namespace

SetReport::SetReport(Report report, const std::stop_token& stop)
    : m_report(std::move(report)), m_equations(m_report.blocks.size()) {
  for (std::size_t i = 0; i < m_report.blocks.size() && !stop.stop_requested(); ++i) {
    const ReportBlock& block = m_report.blocks[i];
    if (const auto* equation = std::get_if<ReportEquation>(&block)) {
      m_equations[i].formula = formulaOf(equation->tex);
      m_equations[i].lines = sharedLines(typesetLines(m_equations[i].formula, kAnyWidth));
    } else if (const auto* paragraph = std::get_if<ReportParagraph>(&block)) {
      set(paragraph->words);
    } else if (const auto* list = std::get_if<ReportList>(&block)) {
      for (const ReportWords& item : list->items) set(item);
    } else if (const auto* table = std::get_if<ReportTable>(&block)) {
      for (const auto& row : table->rows) {
        for (const ReportWords& cell : row) set(cell);
      }
    }
  }
}

void SetReport::set(const ReportWords& words) {
  for (const ReportSpan& span : words) {
    if (!span.isFormula || m_inLine.contains(span.text)) continue;
    m_inLine[span.text] =
        std::make_shared<const FormulaBox>(typesetFormula(formulaOf(span.text), FormulaPlace::inLine));
  }
}

std::vector<FlowLine> SetReport::lines(const FlowParameters& parameters, const WordMeasure& measure) const {
  return FlowWriter(*this, parameters, measure).all();
}

}  // namespace geargraph

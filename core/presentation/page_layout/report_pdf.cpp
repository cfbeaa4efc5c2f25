#include "core/presentation/page_layout/report_pdf.h"

#include <algorithm>
#include <string_view>
#include <tuple>

#include "core/foundations/base/translation.h"
#include "core/presentation/cairo_output/pdf_pages.h"
#include "core/presentation/drawing/svg_writer.h"
#include "core/presentation/page_layout/flow.h"
#include "core/presentation/page_layout/page_break.h"

namespace geargraph {
namespace {

// A4, in points.
constexpr double kPageWidth = 595.28, kPageHeight = 841.89;
constexpr double kSide = 62, kHead = 62, kFoot = 68;
constexpr double kPoints = 0.75;  // a pixel of a drawing
constexpr double kSize = 10, kSmall = 8.5;
constexpr double kBody = kPageHeight - kHead - kFoot;
constexpr double kWidth = kPageWidth - 2 * kSide;

constexpr Color kInk{0, 0, 0}, kSoft{85, 93, 102}, kHairline{200, 206, 212};

class PageMeasure : public WordMeasure {
 public:
  explicit PageMeasure(const PdfPages& pages) : m_pages(pages) {}
  [[nodiscard]] double widthOf(std::string_view utf8, const TextStyle& style) const override {
    return m_pages.widthOf(utf8, style.size, style.bold);
  }

 private:
  const PdfPages& m_pages;
};

class PagePainter {
 public:
  PagePainter(PdfPages& pages, const Report& report, const ReportLists& drawings)
      : m_pages(pages), m_report(report), m_drawings(drawings) {}

  void paint(const FlowPage& page, const std::vector<FlowLine>& lines) {
    for (const auto& [line, top] : page.lines) paint(lines[line], kHead + top);
    endPart();
    endBlock();
  }
  void paintFoot(std::size_t page, std::size_t of) {
    const std::string text = std::to_string(page) + " / " + std::to_string(of);
    m_pages.words(text, (kPageWidth - m_pages.widthOf(text, kSmall, false)) / 2, kPageHeight - kFoot / 2,
                  {kSmall, false, kSoft});
  }

 private:
  void paint(const FlowLine& line, double top) {
    if (line.block < m_report.blocks.size() && line.block + 1 != m_bookmarked) {
      if (const auto* heading = std::get_if<ReportHeading>(&m_report.blocks[line.block])) {
        m_pages.bookmark(heading->level, heading->text, top - 2 * kSize);
        m_bookmarked = line.block + 1;
      }
    }
    beginPartOf(line);
    for (const FlowRule& rule : line.rules) m_pages.rule(kSide + rule.x, top + rule.y, rule.width, kHairline);
    paintContent(line, top);
    if (const auto& figure = line.figure) {
      m_pages.drawing(figure->curves ? *figure->curves : m_drawings[figure->drawing], kSide + figure->x, top,
                      figure->width, figure->height);
    }
    if (m_part == kRow) endPart();
  }

  /// In the order in which it is read: by cells, from above, from left to right.
  void paintContent(const FlowLine& line, double top) {
    struct Item {
      int cell = 0;
      double x = 0, y = 0;
      const FlowWords* words = nullptr;
      const FlowFormula* formula = nullptr;
    };
    std::vector<Item> items;
    for (const FlowWords& words : line.words)
      items.push_back({words.cell, words.x, words.y, &words, nullptr});
    for (const FlowFormula& formula : line.formulas)
      items.push_back({formula.cell, formula.x, formula.y, nullptr, &formula});
    std::stable_sort(items.begin(), items.end(), [](const Item& a, const Item& b) {
      return std::tie(a.cell, a.y, a.x) < std::tie(b.cell, b.y, b.x);
    });
    const char* cellName = line.isHead ? "TH" : "TD";
    for (std::size_t i = 0; i < items.size(); ++i) {
      const auto& [cell, x, y, words, formula] = items[i];
      const bool isRow = m_part == kRow;
      if (isRow && (i == 0 || items[i - 1].cell != cell)) m_pages.beginPart(cellName);
      if (words != nullptr) {
        m_pages.words(words->text, kSide + x, top + y,
                      {words->style.size, words->style.bold, words->style.soft ? kSoft : kInk});
      } else {
        m_pages.formula(*formula->box, kSide + x, top + y, formula->size, kInk, kSoft);
      }
      if (isRow && (i + 1 == items.size() || items[i + 1].cell != cell)) m_pages.endPart(cellName);
    }
  }

  /// The names of parts: of what a block begins, and within it.
  void beginPartOf(const FlowLine& line) {
    const bool isTitle = line.block >= m_report.blocks.size();
    const ReportBlock* block = isTitle ? nullptr : &m_report.blocks[line.block];
    std::string_view outer;
    std::string_view part = "P";
    bool isNew = line.block != m_block;
    if (block == nullptr) {
      part = !line.words.empty() && line.words.front().style.bold ? "H1" : "P";
    } else if (const auto* heading = std::get_if<ReportHeading>(block)) {
      part = heading->level == 1 ? "H2" : "H3";
    } else if (std::holds_alternative<ReportEquation>(*block)) {
      part = "Formula";
    } else if (std::holds_alternative<ReportTable>(*block)) {
      outer = "Table";
      part = kRow;
    } else if (std::holds_alternative<ReportList>(*block)) {
      outer = "L";
      part = "LI";
      isNew = isNew || (!line.words.empty() && line.words.front().x == 0);  // its dash
    } else if (line.figure) {
      part = "Figure";
    }
    if (!isNew && part == m_part) return;
    endPart();
    if (line.block != m_block || outer != m_outer) {
      endBlock();
      m_outer = outer;
      m_block = line.block;
      if (!m_outer.empty()) m_pages.beginPart(m_outer.data());
    }
    m_part = part;
    m_pages.beginPart(m_part.data());
  }
  void endPart() {
    if (!m_part.empty()) m_pages.endPart(m_part.data());
    m_part = {};
  }
  void endBlock() {
    if (!m_outer.empty()) m_pages.endPart(m_outer.data());
    m_outer = {};
    m_block = kNoBlock;
  }

  PdfPages& m_pages;
  const Report& m_report;
  const ReportLists& m_drawings;
  std::size_t m_bookmarked = 0;  ///< one more than the block of the last bookmark
  static constexpr std::string_view kRow = "TR";
  static constexpr std::size_t kNoBlock = static_cast<std::size_t>(-1);
  std::size_t m_block = kNoBlock;  ///< whose parts are open
  std::string_view m_outer;        ///< the part around those of the block's lines; empty: none
  std::string_view m_part;         ///< that is open; of literals, which end with a zero
};

}  // namespace

Expected<std::string> reportPdf(Report report, const ReportLists& drawings) {
  const SetReport set(std::move(report));
  PdfPages pdf(kPageWidth, kPageHeight, set.report().title);
  const PageMeasure measure(pdf);
  FlowParameters flow;
  flow.width = kWidth;
  flow.size = flow.formulaSize = kSize;
  flow.tallest = kBody - 3 * kSize;
  flow.curvesScale = kPoints;
  flow.figureSize = [&](ReportDrawing drawing) -> std::optional<FlowParameters::FigureSize> {
    const DisplayList& list = drawings[drawing];
    if (list.marks.empty()) return std::nullopt;
    const Extent sheet = sheetOf(list, {});
    return FlowParameters::FigureSize{2 * kPoints * sheet.halfWidth, 2 * kPoints * sheet.halfHeight};
  };
  std::vector<FlowLine> lines = titleLines(set, flow, measure);
  for (FlowLine& line : set.lines(flow, measure)) lines.push_back(std::move(line));
  const std::vector<FlowPage> pages = flowPages(lines, kBody);
  PagePainter painter(pdf, set.report(), drawings);
  for (std::size_t i = 0; i < pages.size(); ++i) {
    painter.paint(pages[i], lines);
    painter.paintFoot(i + 1, pages.size());
    pdf.endPage();
  }
  std::optional<std::string> bytes = pdf.finished();
  if (bytes) return std::move(*bytes);
  Diagnostic diagnostic;
  diagnostic.code = Code::graphics;
  diagnostic.message = translated("There is not enough memory for the pages.");
  return diagnostic;
}

}  // namespace geargraph

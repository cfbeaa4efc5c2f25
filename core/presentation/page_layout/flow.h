#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <stop_token>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "core/presentation/report/report.h"
#include "core/presentation/typeset/typeset.h"

namespace geargraph {

/// The style of words.
struct TextStyle {
  double size = 10;  ///< of the em
  bool bold = false;
  bool soft = false;  ///< in the secondary colour
};

/// Measures words in the faces that will show them.
class WordMeasure {
 public:
  WordMeasure() = default;
  WordMeasure(const WordMeasure&) = delete;
  WordMeasure& operator=(const WordMeasure&) = delete;
  virtual ~WordMeasure() = default;
  [[nodiscard]] virtual double widthOf(std::string_view utf8, const TextStyle& style) const = 0;
};

/// Words from x on, with their baseline at y, downwards from the top of their line.
struct FlowWords {
  std::string text;
  double x = 0, y = 0;
  TextStyle style;
  int cell = 0;  ///< of a row of a table, from 0
};
struct FlowFormula {
  std::shared_ptr<const FormulaBox> box;
  double x = 0, y = 0;
  double size = 10;  ///< of the em
  int cell = 0;      ///< of a row of a table, from 0
};
struct FlowRule {
  double x = 0, y = 0, width = 0;
};
/// A drawing and its space.
struct FlowFigure {
  ReportDrawing drawing = ReportDrawing::digraph;
  std::shared_ptr<const DisplayList> curves = {};  ///< null: `drawing`
  double x = 0, width = 0, height = 0;
};

/// A strip of the page that is never split by a page break.
struct FlowLine {
  double above = 0;  ///< space above it, except at the top of a page
  double height = 0;
  std::size_t block = 0;             ///< of the report
  bool keepsWithNext = false;        ///< no page break after it
  bool isHead = false;               ///< the first row of a table, its headings
  std::optional<ElementId> element;  ///< that it is about
  std::vector<FlowWords> words;
  std::vector<FlowFormula> formulas;
  std::vector<FlowRule> rules;
  std::optional<FlowFigure> figure;
};

/// The parameters of a layout. Lengths in one unit: points of a page or pixels of a window.
struct FlowParameters {
  double width = 480;
  double size = 10;         ///< of the em of words
  double formulaSize = 10;  ///< of the em of formulas
  double tallest = 700;     ///< of any strip
  /// The smallest factor by which a formula is scaled down to fit.
  double leastPart = 0.6;
  /// Is a formula that is too wide even so replaced by a note?
  bool leavesOutWide = true;
  /// The size of a drawing if there is room; std::nullopt leaves it out.
  struct FigureSize {
    double width = 0, height = 0;
  };
  std::function<std::optional<FigureSize>(ReportDrawing)> figureSize = {};
  double curvesScale = 1;  ///< units per px of a chart of curves, if there is room
};

/// A report with its formulas parsed and typeset at their natural width, once for all widths and sizes.
class SetReport {
 public:
  /// The result is meaningless if `stop` was requested meanwhile. Cost: linear in the text of the report.
  explicit SetReport(Report report, const std::stop_token& stop = {});

  [[nodiscard]] const Report& report() const { return m_report; }
  /// The report from its first heading to its end, in strips. Cost: linear in the report.
  [[nodiscard]] std::vector<FlowLine> lines(const FlowParameters& parameters,
                                            const WordMeasure& measure) const;

  struct SetLine {
    std::shared_ptr<const FormulaBox> box;
    std::size_t row = 0;  ///< of "aligned"
  };
  struct SetEquation {
    FormulaNode formula;
    std::vector<SetLine> lines;  ///< as a displayed equation, without line breaks
  };
  /// The equation of a block. @pre the block is an equation
  [[nodiscard]] const SetEquation& equation(std::size_t block) const { return m_equations[block]; }
  /// The box of a formula within a sentence. @pre the report has it
  [[nodiscard]] const std::shared_ptr<const FormulaBox>& inLine(const std::string& tex) const {
    return m_inLine.at(tex);
  }

 private:
  void set(const ReportWords& words);

  Report m_report;
  std::vector<SetEquation> m_equations;  ///< by block; empty ones for others
  std::unordered_map<std::string, std::shared_ptr<const FormulaBox>> m_inLine;
};

}  // namespace geargraph

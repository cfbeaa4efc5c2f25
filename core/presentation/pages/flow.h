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

namespace geargraph::inline pages {

/// How words look.
struct WordLook {
  double size = 10;  ///< of the em
  bool bold = false;
  bool soft = false;  ///< in the colour of what may be overlooked
};

/// Measures words in the faces that will show them.
class WordMeasure {
 public:
  WordMeasure() = default;
  WordMeasure(const WordMeasure&) = delete;
  WordMeasure& operator=(const WordMeasure&) = delete;
  virtual ~WordMeasure() = default;
  [[nodiscard]] virtual double widthOf(std::string_view utf8, const WordLook& look) const = 0;
};

/// Words from x on, with their baseline at y, downwards from the top of their line.
struct FlowWords {
  std::string text;
  double x = 0, y = 0;
  WordLook look;
};
struct FlowFormula {
  std::shared_ptr<const FormulaBox> box;
  double x = 0, y = 0;
  double size = 10;  ///< of the em
};
struct FlowRule {
  double x = 0, y = 0, width = 0;
};
/// A drawing and the room that it has.
struct FlowFigure {
  ReportDrawing drawing = ReportDrawing::digraph;
  std::shared_ptr<const DisplayList> curves = {};  ///< null: `drawing`
  double x = 0, width = 0, height = 0;
};

/// A strip of the page that is not torn.
struct FlowLine {
  double above = 0;  ///< what is left free above it, but at the top of a page
  double height = 0;
  std::size_t block = 0;             ///< of the report
  bool keepsWithNext = false;        ///< no page ends behind it
  std::optional<ElementId> element;  ///< what it is about
  std::vector<FlowWords> words;
  std::vector<FlowFormula> formulas;
  std::vector<FlowRule> rules;
  std::optional<FlowFigure> figure;
};

/// What a report is laid out for. Lengths in one unit: points of a page or pixels of a window.
struct FlowLook {
  double width = 480;
  double size = 10;         ///< of the em of words
  double formulaSize = 10;  ///< of the em of formulas
  double tallest = 700;     ///< of a strip
  /// The least part of its size that a formula shrinks to.
  double leastPart = 0.6;
  /// Where a formula is too wide even so: is it left out, and the reader told?
  bool leavesOutWide = true;
  /// How large a drawing is where there is room; none leaves it out.
  struct FigureSize {
    double width = 0, height = 0;
  };
  std::function<std::optional<FigureSize>(ReportDrawing)> figureSize = {};
  double curvesScale = 1;  ///< units that a px of curves takes where there is room
};

/// The formulas of a report, read and set as wide as they are: done once for every width and size.
class SetReport {
 public:
  /// Of no use when `stop` was requested meanwhile. Cost: linear in the text of the report.
  explicit SetReport(Report report, const std::stop_token& stop = {});

  [[nodiscard]] const Report& report() const { return m_report; }
  /// The report from its first heading to its end, in strips. Cost: linear in the report.
  [[nodiscard]] std::vector<FlowLine> lines(const FlowLook& look, const WordMeasure& measure) const;

  struct SetLine {
    std::shared_ptr<const FormulaBox> box;
    std::size_t row = 0;  ///< of "aligned"
  };
  struct SetEquation {
    FormulaNode formula;
    std::vector<SetLine> lines;  ///< on its own, unbroken
  };
  /// Of a block that is an equation.
  [[nodiscard]] const SetEquation& equation(std::size_t block) const { return m_equations[block]; }
  /// Of a formula within a sentence.
  [[nodiscard]] const std::shared_ptr<const FormulaBox>& inLine(const std::string& tex) const {
    return m_inLine.at(tex);
  }

 private:
  void set(const ReportWords& words);

  Report m_report;
  std::vector<SetEquation> m_equations;  ///< by block; empty ones for others
  std::unordered_map<std::string, std::shared_ptr<const FormulaBox>> m_inLine;
};

}  // namespace geargraph::inline pages

#pragma once

#include <array>
#include <functional>
#include <optional>
#include <stop_token>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "core/foundations/base/translation.h"
#include "core/presentation/drawing/curve_chart.h"
#include "core/presentation/drawing/display_list.h"
#include "core/theory/analysis/analysis.h"

namespace geargraph {

/// A part of a sentence: words, or a formula in core's subset of TeX (tex_reader.h).
struct ReportSpan {
  std::string text;
  bool isFormula = false;
};
using ReportWords = std::vector<ReportSpan>;

struct ReportHeading {
  int level = 1;  ///< 1: a part, 2: a step of it
  std::string text;
};
struct ReportParagraph {
  ReportWords words;
};
/// A formula on a line of its own. `number` is the paper's if it has this equation, else one that continues
/// after the paper's; none if nothing refers to it.
struct ReportEquation {
  std::string tex;
  std::optional<int> number;
  /// The elements that it is about: one for the whole equation, or one for each line of "aligned"; empty for
  /// the whole mechanism.
  std::vector<ElementId> elements;
  bool isDual = false;  ///< of statics: the number is that of its dual in kinematics, with a star

  /// "17", "17*"; empty without a number.
  [[nodiscard]] std::string label() const {
    return number ? std::to_string(*number) + (isDual ? "*" : "") : std::string();
  }
};
struct ReportTable {
  std::vector<std::string> head;
  std::vector<std::vector<ReportWords>> rows;
  bool isWhole = false;  ///< kept on one page, if it fits
};
struct ReportList {
  std::vector<ReportWords> items;
};
enum class ReportDrawing { schematic, digraph, ttGraph, levers, nomogram };
constexpr std::size_t kReportDrawingCount = 5;
/// The place of a drawing, in the forms that have drawings.
struct ReportFigure {
  ReportDrawing drawing = ReportDrawing::digraph;
  std::string caption;
};
/// Charts, in the forms that have drawings. Their values are also in a table.
struct ReportCurves {
  std::vector<CurveChart> charts;
  std::string caption;
};
using ReportBlock = std::variant<ReportHeading, ReportParagraph, ReportEquation, ReportTable, ReportList,
                                 ReportFigure, ReportCurves>;

/// The step-by-step solution of a mechanism by both methods, as data: Eqs. (1)-(45) of [AU] for its own
/// links, joints and teeth. An immutable value, from which each form (reportLatex() ...) is written.
struct Report {
  std::string title;
  std::vector<ReportBlock> blocks;
  std::string subtitle = translated("Worked out by the Matroid and the T-T graph method");  ///< on pages
};

/// With more links a report would have thousands of pages.
constexpr int kMaxReportLinks = 200;

/// The heading of the part that compares the methods, to be translated; none without a solution.
inline constexpr const char* kComparisonHeading = toTranslate("Both methods compared");

/// The title of a mechanism's report.
[[nodiscard]] std::string reportTitle(const Mechanism& mechanism);

/// The derivation as far as the mechanism allows it: without a spanning tree the incidence matrix, with an
/// error of the geometry the digraph's matrices, and so on; the diagnostics explain what is missing. The
/// result is meaningless if `stop` was requested meanwhile. Cost: that of the matrices' entries.
/// @pre the snapshot is complete (analyze()); no more than kMaxReportLinks links
[[nodiscard]] Report derivationReport(const SnapshotPtr& snapshot, const std::stop_token& stop = {});

/// The drawings of a report, each by its place; empty ones are left out.
template <class Drawn>
struct PerReportDrawing {
  std::array<Drawn, kReportDrawingCount> all = {};

  [[nodiscard]] Drawn& operator[](ReportDrawing drawing) { return all[static_cast<std::size_t>(drawing)]; }
  [[nodiscard]] const Drawn& operator[](ReportDrawing drawing) const {
    return all[static_cast<std::size_t>(drawing)];
  }
};
using ReportLists = PerReportDrawing<DisplayList>;
using ReportDrawings = PerReportDrawing<std::string>;  ///< in SVG

/// The lists as SVG; an empty list is an empty text.
[[nodiscard]] ReportDrawings svgDrawings(const ReportLists& lists);

enum class ReportForm { markdown, latex, html };
/// The report in a form. `drawings` is called only if the form has drawings, because they may be expensive.
[[nodiscard]] std::string reportText(const Report& report, ReportForm form,
                                     const std::function<ReportLists()>& drawings);

/// "md", "latex", "html"
[[nodiscard]] std::optional<ReportForm> reportFormFromName(std::string_view name);

/// One HTML page with formulas in MathML and drawings in SVG, without scripts and external resources.
[[nodiscard]] std::string reportHtml(const Report& report, const ReportDrawings& drawings);
/// Blocks of a report for another HTML page: without drawings; a part about one element has the attribute
/// data-el, "gearMeshes/16".
[[nodiscard]] std::string reportHtmlBlocks(const std::vector<ReportBlock>& blocks);
/// A LaTeX document for any engine. Long formulas are broken into lines, wide tables into columns with
/// several lines, and what is too large even so is set smaller, so that all fits the page. It needs amsmath,
/// array, graphicx and longtable; with drawings, which are `tikzpicture`s, tikz as well.
[[nodiscard]] std::string reportLatex(const Report& report, const ReportLists& drawings = {});
/// Markdown with formulas between dollar signs, as GitHub, Jupyter and Pandoc read it; without drawings.
[[nodiscard]] std::string reportMarkdown(const Report& report);

}  // namespace geargraph

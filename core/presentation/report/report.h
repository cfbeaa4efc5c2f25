#pragma once

#include <functional>
#include <optional>
#include <stop_token>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "core/foundations/base/words.h"
#include "core/presentation/drawing/curve_chart.h"
#include "core/theory/analysis/analysis.h"

namespace geargraph::inline report {

/// A stretch of a sentence: words, or a formula in TeX (tex_reader.h says which TeX).
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
/// A formula on a line of its own. `number` is the paper's where it has this equation, and goes on from the
/// paper's numbers where it has not; none where nothing refers to it.
struct ReportEquation {
  std::string tex;
  std::optional<int> number;
  /// What it is about: one element of all of it, or one of each line of "aligned"; none of the whole
  /// mechanism.
  std::vector<ElementId> elements;
  bool isDual = false;  ///< of statics: the number is that of its twin of the kinematics, with a star

  /// "17", "17*"; empty without a number.
  [[nodiscard]] std::string label() const {
    return number ? std::to_string(*number) + (isDual ? "*" : "") : std::string();
  }
};
struct ReportTable {
  std::vector<std::string> head;
  std::vector<std::vector<ReportWords>> rows;
  bool isWhole = false;  ///< on pages: stays on one, if it fits
};
struct ReportList {
  std::vector<ReportWords> items;
};
enum class ReportDrawing { schematic, digraph, ttGraph };
/// Where a drawing stands, in the forms that can hold one.
struct ReportFigure {
  ReportDrawing drawing = ReportDrawing::digraph;
  std::string caption;
};
/// Curves, in the forms that can hold a drawing. What they show stands in a table, too.
struct ReportCurves {
  std::vector<CurveChart> charts;
  std::string caption;
};
using ReportBlock = std::variant<ReportHeading, ReportParagraph, ReportEquation, ReportTable, ReportList,
                                 ReportFigure, ReportCurves>;

/// A mechanism worked out by both methods, step by step, as data: Eqs. (1)-(45) of [AU] for its own links,
/// joints and teeth. An immutable value that each form (reportLatex() ...) writes down as it can.
struct Report {
  std::string title;
  std::vector<ReportBlock> blocks;
  std::string subtitle = translated("Worked out by the Matroid and the T-T graph method");  ///< on pages
};

/// Reports of more links would be thousands of pages.
constexpr int kMostReportLinks = 200;

/// The heading of the part that compares the methods, which is shown translated; a mechanism without a
/// solution has none.
inline constexpr const char* kComparisonHeading = toTranslate("Both methods compared");

/// What the report of a mechanism is headed with.
[[nodiscard]] std::string reportTitle(const Mechanism& mechanism);

/// The derivation as far as the mechanism allows it: without a spanning tree the incidence matrix, with an
/// error of the geometry the digraph's matrices, and so on; what is missing is said with the findings.
/// Of no use when `stop` was requested meanwhile. Cost: that of the matrices' entries.
/// @pre the snapshot is complete (analyze()); no more than kMostReportLinks links
[[nodiscard]] Report derivationReport(const SnapshotPtr& snapshot, const std::stop_token& stop = {});

/// The drawings in SVG; empty ones are left out.
struct ReportDrawings {
  std::string schematic;
  std::string digraph;
  std::string ttGraph;
};

enum class ReportForm { markdown, latex, html };
/// In this form. `drawings` are asked for where the form holds some: they may be dear.
[[nodiscard]] std::string reportText(const Report& report, ReportForm form,
                                     const std::function<ReportDrawings()>& drawings);

/// "md", "latex", "html"
[[nodiscard]] std::optional<ReportForm> reportFormFromName(std::string_view name);

/// One page that any browser shows, prints and lets select: formulas in MathML, drawings in SVG, no scripts
/// and nothing fetched.
[[nodiscard]] std::string reportHtml(const Report& report, const ReportDrawings& drawings);
/// Blocks of it within another page: without drawings; what speaks of one element tells it as data-el,
/// "gearMeshes/16".
[[nodiscard]] std::string reportHtmlBlocks(const std::vector<ReportBlock>& blocks);
/// A document for any of the LaTeX programs, with amsmath and nothing else that is not part of LaTeX; without
/// drawings.
[[nodiscard]] std::string reportLatex(const Report& report);
/// Markdown with formulas between dollar signs, as GitHub, Jupyter and Pandoc read it; without drawings.
[[nodiscard]] std::string reportMarkdown(const Report& report);

}  // namespace geargraph::inline report

#include <algorithm>
#include <cmath>
#include <string_view>

#include "core/presentation/drawing/latex_text.h"
#include "core/presentation/drawing/svg_writer.h"
#include "core/presentation/drawing/text_metrics.h"
#include "core/presentation/drawing/tikz_writer.h"
#include "core/presentation/report/latex_lines.h"
#include "core/presentation/report/report_words.h"
#include "core/presentation/typeset/tex_reader.h"
#include "core/presentation/typeset/typeset.h"

namespace geargraph {
namespace {

/// \fit sets what is larger than a page smaller, as a whole: a formula, or a table.
constexpr std::string_view kBegin = R"(\documentclass[a4paper,10pt]{article}
\usepackage[margin=2cm]{geometry}
\usepackage{iftex}
\ifpdftex\usepackage[T1]{fontenc}\usepackage[utf8]{inputenc}\else\usepackage{fontspec}\fi
\usepackage{amsmath,array,graphicx,longtable}
)";
constexpr std::string_view kDrawingPackage = "\\usepackage{tikz}\n";
constexpr std::string_view kSettings = R"(\setcounter{MaxMatrixCols}{50}
\renewcommand{\arraystretch}{1.2}
\setlength{\arraycolsep}{3pt}
\setlength{\parindent}{0pt}
\setlength{\parskip}{6pt}
\setlength{\emergencystretch}{4em}
\setlength{\LTleft}{0pt}
\allowdisplaybreaks
\newsavebox{\fitbox}
\newcommand{\fit}[2]{\sbox{\fitbox}{#2}%
  \ifdim\wd\fitbox>#1\relax\sbox{\fitbox}{\resizebox{#1}{!}{\usebox{\fitbox}}}\fi
  \ifdim\dimexpr\ht\fitbox+\dp\fitbox\relax>0.9\textheight\sbox{\fitbox}{\resizebox{!}{0.9\textheight}{\usebox{\fitbox}}}\fi
  \usebox{\fitbox}}
)";

// Sizes of a page, in em of 10 pt.
constexpr double kPageWidth = 48;
constexpr double kPageHeight = 73;
constexpr double kFormulaWidth = 43;  ///< that leaves room for the number, and for measures that differ
constexpr double kColumnGap = 1.2;    ///< between two columns of a table

double widthOf(const std::string& words, bool isBold) {
  constexpr double kSerif = 0.87;       // Computer Modern runs narrower than the face of textWidth()
  constexpr double kUnderscore = 0.25;  // its underscores are wider
  return kSerif * textWidth(words, 1, isBold) +
         kUnderscore * static_cast<double>(std::count(words.begin(), words.end(), '_'));
}

double widthOfFormula(const std::string& tex) {
  return typesetFormula(formulaOf(tex), FormulaPlace::inLine).width;
}

double widthOf(const ReportWords& words) {
  double width = 0;
  for (const ReportSpan& span : words)
    width += span.isFormula ? widthOfFormula(span.text) : widthOf(span.text, false);
  return width;
}

/// That of the longest word, and of the widest formula.
double leastWidthOf(const ReportWords& words) {
  double width = 0;
  for (const ReportSpan& span : words) {
    if (span.isFormula) width = std::max(width, widthOfFormula(span.text));
    for (std::size_t at = 0; !span.isFormula && at < span.text.size();) {
      const std::size_t end = std::min(span.text.find(' ', at), span.text.size());
      width = std::max(width, widthOf(span.text.substr(at, end - at), false));
      at = end + 1;
    }
  }
  return width;
}

std::string words(const ReportWords& spans) {
  return dollarWords(spans, escapedLatex);
}

/// The columns of a table: how wide they are in full, and at least.
struct Columns {
  std::vector<double> full, least;

  explicit Columns(const ReportTable& table) : full(table.head.size()), least(table.head.size()) {
    for (std::size_t i = 0; i < table.head.size(); ++i) {
      full[i] = widthOf(table.head[i], false);
      least[i] = leastWidthOf({{table.head[i], false}});
      for (const auto& row : table.rows) {
        if (i >= row.size()) continue;
        full[i] = std::max(full[i], widthOf(row[i]));
        least[i] = std::max(least[i], leastWidthOf(row[i]));
      }
    }
  }
  [[nodiscard]] double room() const { return kPageWidth - kColumnGap * static_cast<double>(full.size()); }
  static double sum(const std::vector<double>& widths) {
    double all = 0;
    for (const double width : widths) all += width;
    return all;
  }
  /// The narrow ones in full; the wide ones share what is left.
  [[nodiscard]] std::vector<double> shared() const {
    std::vector<double> widths = least;
    double left = room() - sum(least);
    for (bool isChanged = true; isChanged && left > 0.01;) {
      isChanged = false;
      const auto open =
          static_cast<double>(std::count_if(widths.begin(), widths.end(), [&](const double& width) {
            return width < full[static_cast<std::size_t>(&width - widths.data())] - 0.01;
          }));
      if (open < 1) break;
      const double share = left / open;
      for (std::size_t i = 0; i < widths.size(); ++i) {
        const double more = std::min(share, full[i] - widths[i]);
        if (more <= 0.01) continue;
        widths[i] += more;
        left -= more;
        isChanged = true;
      }
    }
    return widths;
  }
};

class LatexWriter {
 public:
  explicit LatexWriter(const ReportLists& drawings) : m_drawings(drawings) {}

  std::string operator()(const ReportHeading& heading) const {
    return (heading.level == 1 ? "\n\\section*{" : "\n\\subsection*{") + escapedLatex(heading.text) + "}\n\n";
  }
  std::string operator()(const ReportParagraph& paragraph) const { return words(paragraph.words) + "\n"; }
  std::string operator()(const ReportEquation& equation) const {
    const std::string tag = equation.number ? " \\tag{" + equation.label() + "}" : "";
    std::string tex = brokenLines(equation.tex, kFormulaWidth);
    if (const SetSize size = setSize(tex); size.width > kFormulaWidth || size.height > kPageHeight - 4)
      tex = "\\fit{\\dimexpr\\linewidth-4em\\relax}{$\\displaystyle " + tex + "$}";
    return "\\begin{equation*}\n" + tex + tag + "\n\\end{equation*}\n";
  }
  std::string operator()(const ReportTable& table) const {
    const Columns columns(table);
    const bool isNarrow = Columns::sum(columns.full) <= columns.room();
    const bool isWrapped = !isNarrow && Columns::sum(columns.least) <= columns.room();
    constexpr std::size_t kRowsOfPage = 40;
    const bool isLong = table.rows.size() > (isWrapped ? kRowsOfPage / 2 : kRowsOfPage) && !table.isWhole &&
                        (isNarrow || isWrapped);
    std::string form;
    if (isWrapped) {
      for (const double width : columns.shared())
        form += ">{\\raggedright\\arraybackslash}p{" + inEm(width) + "}";
    } else {
      form = std::string(table.head.size(), 'l');
    }
    const std::string environment = isLong ? "longtable" : "tabular";
    std::string text = "\\begin{" + environment + "}{" + form + "}\n";
    for (std::size_t i = 0; i < table.head.size(); ++i)
      text += (i > 0 ? " & " : "") + escapedLatex(table.head[i]);
    text += " \\\\ \\hline\n";
    if (isLong) text += "\\endhead\n";
    for (const auto& row : table.rows) {
      for (std::size_t i = 0; i < row.size(); ++i) text += (i > 0 ? " & " : "") + words(row[i]);
      text += " \\\\\n";
    }
    text += "\\end{" + environment + "}";
    if (!isNarrow && !isWrapped) text = "\\fit{\\linewidth}{" + text + "}";
    return "\n" + text + "\n\n";
  }
  std::string operator()(const ReportList& list) const {
    std::string text = "\\begin{itemize}\n";
    for (const ReportWords& item : list.items) text += "\\item " + words(item) + "\n";
    return text + "\\end{itemize}\n";
  }
  std::string operator()(const ReportFigure& figure) const {
    return drawn(m_drawings[figure.drawing], figure.caption);
  }
  std::string operator()(const ReportCurves& curves) const {
    return m_drawsCurves ? drawn(chartDrawing(curves.charts), curves.caption) : std::string();
  }

  /// Charts go with drawings: a text without them needs no package for them.
  void drawCurves() { m_drawsCurves = true; }

 private:
  struct SetSize {
    double width = 0, height = 0;
  };
  /// As TeX would set it; its own columns are closer to each other than LaTeX's.
  static SetSize setSize(const std::string& tex) {
    const FormulaNode formula = formulaOf(tex);
    SetSize size;
    for (const FormulaLine& line : typesetLines(formula, 1e9)) {
      size.width = std::max(size.width, line.box.width);
      size.height += line.box.height + line.box.depth + 0.3;
    }
    return size;
  }
  static std::string inEm(double width) {
    const long tenths = std::lround(std::floor(10 * width));
    return std::to_string(tenths / 10) + "." + std::to_string(tenths % 10) + "em";
  }
  static std::string drawn(const DisplayList& list, const std::string& caption) {
    if (list.marks.empty()) return {};
    constexpr double kPoints = 0.75, kEm = 10, kPart = 0.42;  // of the page's height at most
    const Extent sheet = sheetOf(list, {});
    const double points = std::min({kPoints, kEm * kPageWidth / (2 * sheet.halfWidth),
                                    kEm * kPart * kPageHeight / (2 * sheet.halfHeight)});
    return "\n\\begin{center}\n" + tikzOf(list, points) + "\n\n\\small " + escapedLatex(caption) +
           "\n\\end{center}\n\n";
  }

  const ReportLists& m_drawings;
  bool m_drawsCurves = false;
};

}  // namespace

std::string reportLatex(const Report& report, const ReportLists& drawings) {
  const bool hasDrawings = std::any_of(drawings.all.begin(), drawings.all.end(),
                                       [](const DisplayList& list) { return !list.marks.empty(); });
  std::string text = std::string(kBegin) + std::string(hasDrawings ? kDrawingPackage : std::string_view()) +
                     std::string(kSettings) + "\\title{" + escapedLatex(report.title) +
                     "}\n\\date{}\n\\begin{document}\n\\maketitle\n";
  LatexWriter writer(drawings);
  if (hasDrawings) writer.drawCurves();
  for (const ReportBlock& block : report.blocks) text += std::visit(writer, block);
  return text + "\\end{document}\n";
}

}  // namespace geargraph

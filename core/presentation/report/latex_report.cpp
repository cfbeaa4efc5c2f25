#include <algorithm>
#include <array>
#include <utility>

#include "core/presentation/report/report_words.h"

namespace geargraph {
namespace {

constexpr std::string_view kBegin = R"(\documentclass[a4paper,10pt]{article}
\usepackage[margin=2cm]{geometry}
\usepackage{iftex}
\ifpdftex\usepackage[T1]{fontenc}\usepackage[utf8]{inputenc}\else\usepackage{fontspec}\fi
\usepackage{amsmath}
\setcounter{MaxMatrixCols}{50}
\renewcommand{\arraystretch}{1.2}
\setlength{\arraycolsep}{3pt}
\setlength{\parindent}{0pt}
\setlength{\parskip}{6pt}
\allowdisplaybreaks
)";

constexpr int kMaxColumnsInFullSize = 18;  // of an A4 page

/// Of the widest line of an array. Cost: its length.
int columnsOf(std::string_view tex) {
  int most = 0, columns = 1;
  for (const char c : tex) {
    if (c == '&') most = std::max(most, ++columns);
    if (c == '\n') columns = 1;
  }
  return most;
}

/// Signs that sentences use and that not every LaTeX program has in its text faces.
constexpr std::array<std::pair<std::string_view, std::string_view>, 11> kTextSigns = {
    {{"\u2212", "$-$"},
     {"\u00b7", "$\\cdot$"},
     {"\u00d7", "$\\times$"},
     {"\u00a6", "$\\mid$"},
     {"\u0393", "$\\Gamma$"},
     {"\u03b8", "$\\theta$"},
     {"\u03c9", "$\\omega$"},
     {"\u2070", "$^0$"},
     {"\u201c", "``"},
     {"\u201d", "''"},
     {"\u2026", "\\dots{}"}}};

std::string escaped(std::string_view text) {
  std::string result;
  for (std::size_t at = 0; at < text.size(); ++at) {
    const auto sign = std::find_if(kTextSigns.begin(), kTextSigns.end(),
                                   [&](const auto& s) { return text.substr(at).starts_with(s.first); });
    if (sign != kTextSigns.end()) {
      result += sign->second;
      at += sign->first.size() - 1;
      continue;
    }
    const char c = text[at];
    switch (c) {
      case '\\':
        result += "\\textbackslash{}";
        break;
      case '~':
        result += "\\textasciitilde{}";
        break;
      case '^':
        result += "\\textasciicircum{}";
        break;
      case '&':
      case '%':
      case '$':
      case '#':
      case '_':
      case '{':
      case '}':
        result += std::string("\\") + c;
        break;
      default:
        result += c;
    }
  }
  return result;
}

std::string words(const ReportWords& spans) {
  return dollarWords(spans, escaped);
}

struct LatexWriter {
  std::string operator()(const ReportHeading& heading) const {
    return (heading.level == 1 ? "\n\\section*{" : "\n\\subsection*{") + escaped(heading.text) + "}\n\n";
  }
  std::string operator()(const ReportParagraph& paragraph) const { return words(paragraph.words) + "\n"; }
  std::string operator()(const ReportEquation& equation) const {
    const bool wide = columnsOf(equation.tex) > kMaxColumnsInFullSize;
    const std::string tag = equation.number ? " \\tag{" + equation.label() + "}" : "";
    return std::string(wide ? "{\\scriptsize" : "") + "\\begin{equation*}\n" + equation.tex + tag +
           "\n\\end{equation*}" + (wide ? "}" : "") + "\n";
  }
  std::string operator()(const ReportTable& table) const {
    std::string text = "\n\\begin{tabular}{" + std::string(table.head.size(), 'l') + "}\n";
    for (std::size_t i = 0; i < table.head.size(); ++i) text += (i > 0 ? " & " : "") + escaped(table.head[i]);
    text += " \\\\ \\hline\n";
    for (const auto& row : table.rows) {
      for (std::size_t i = 0; i < row.size(); ++i) text += (i > 0 ? " & " : "") + words(row[i]);
      text += " \\\\\n";
    }
    return text + "\\end{tabular}\n\n";
  }
  std::string operator()(const ReportList& list) const {
    std::string text = "\\begin{itemize}\n";
    for (const ReportWords& item : list.items) text += "\\item " + words(item) + "\n";
    return text + "\\end{itemize}\n";
  }
  std::string operator()(const ReportFigure& /*figure*/) const { return {}; }
  std::string operator()(const ReportCurves& /*curves*/) const { return {}; }
};

}  // namespace

std::string reportLatex(const Report& report) {
  std::string text = std::string(kBegin) + "\\title{" + escaped(report.title) +
                     "}\n\\date{}\n\\begin{document}\n\\maketitle\n";
  for (const ReportBlock& block : report.blocks) text += std::visit(LatexWriter{}, block);
  return text + "\\end{document}\n";
}

}  // namespace geargraph

#include "core/presentation/report/report_words.h"

namespace geargraph {
namespace {

/// What Markdown or HTML would read as a mark is kept as it is written.
std::string escaped(std::string_view text) {
  std::string result;
  for (const char c : text) {
    if (std::string_view("\\`*_{}[]<>#|$~").find(c) != std::string_view::npos) result += '\\';
    result += c;
  }
  return result;
}

std::string words(const ReportWords& spans) {
  return dollarWords(spans, escaped);
}

/// A cell of a table stands on one line.
std::string cell(const ReportWords& spans) {
  std::string text = words(spans);
  for (char& c : text) {
    if (c == '\n') c = ' ';
  }
  return text;
}

struct MarkdownWriter {
  std::string operator()(const ReportHeading& heading) const {
    return std::string(static_cast<std::size_t>(heading.level) + 1, '#') + " " + escaped(heading.text) +
           "\n\n";
  }
  std::string operator()(const ReportParagraph& paragraph) const { return words(paragraph.words) + "\n\n"; }
  std::string operator()(const ReportEquation& equation) const {
    const std::string tag = equation.number ? " \\tag{" + equation.label() + "}" : "";
    return "$$\n" + equation.tex + tag + "\n$$\n\n";
  }
  std::string operator()(const ReportTable& table) const {
    std::string text = "|", rule = "|";
    for (const std::string& head : table.head) {
      text += " " + escaped(head) + " |";
      rule += " --- |";
    }
    text += "\n" + rule + "\n";
    for (const auto& row : table.rows) {
      text += "|";
      for (const ReportWords& entry : row) text += " " + cell(entry) + " |";
      text += "\n";
    }
    return text + "\n";
  }
  std::string operator()(const ReportList& list) const {
    std::string text;
    for (const ReportWords& item : list.items) text += "- " + cell(item) + "\n";
    return text + "\n";
  }
  std::string operator()(const ReportFigure& /*figure*/) const { return {}; }
  std::string operator()(const ReportCurves& /*curves*/) const { return {}; }
};

}  // namespace

std::string reportMarkdown(const Report& report) {
  std::string text = "# " + escaped(report.title) + "\n\n";
  for (const ReportBlock& block : report.blocks) text += std::visit(MarkdownWriter{}, block);
  return text;
}

}  // namespace geargraph

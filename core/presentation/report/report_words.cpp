#include "core/presentation/report/report_words.h"

#include "core/foundations/base/contract.h"
#include "core/foundations/base/text_lists.h"
#include "core/foundations/base/translation.h"
#include "core/presentation/report/report_parts.h"

namespace geargraph {

void ReportPart::paragraph(std::string_view text) {
  put(ReportParagraph{reportWords(text)});
}

void ReportPart::equation(std::string tex, std::optional<int> number, std::vector<ElementId> elements) {
  while (!tex.empty() && tex.back() == '\n') tex.pop_back();
  put(ReportEquation{std::move(tex), number, std::move(elements), false});
}

void ReportPart::equation(std::string tex, PaperEquation number, std::vector<ElementId> elements) {
  equation(std::move(tex), number == PaperEquation::none ? std::nullopt : std::optional(numberOf(number)),
           std::move(elements));
}

void ReportPart::dualEquation(std::string tex, PaperEquation number, std::vector<ElementId> elements) {
  dualEquation(std::move(tex), numberOf(number), std::move(elements));
}

void ReportPart::dualEquation(std::string tex, int number, std::vector<ElementId> elements) {
  while (!tex.empty() && tex.back() == '\n') tex.pop_back();
  put(ReportEquation{std::move(tex), number, std::move(elements), true});
}

ReportWords reportWords(std::string_view sentence) {
  ReportWords words;
  bool isFormula = false;
  while (true) {
    const std::size_t dollar = sentence.find('$');
    if (dollar != 0 && !sentence.empty())
      words.push_back({std::string(sentence.substr(0, dollar)), isFormula});
    if (dollar == std::string_view::npos) break;
    sentence.remove_prefix(dollar + 1);
    isFormula = !isFormula;
  }
  GEARGRAPH_REQUIRE(!isFormula);
  return words;
}

std::string dollarWords(const ReportWords& words, std::string (*escaped)(std::string_view)) {
  std::string text;
  for (const ReportSpan& span : words) text += span.isFormula ? "$" + span.text + "$" : escaped(span.text);
  return text;
}

ReportWords plainWords(std::string text) {
  return {{std::move(text), false}};
}

std::string rateName(const Digraph& graph, JointOrdinal joint) {
  return "\\dot{\\theta}_{" + std::to_string(graph.edgeLabel(joint)) + "}";
}

std::string texColumn(const std::vector<std::string>& names) {
  std::string text = "\\begin{pmatrix}";
  for (std::size_t i = 0; i < names.size(); ++i) text += (i > 0 ? " \\\\ " : " ") + names[i];
  return text + " \\end{pmatrix}";
}

std::string rateColumn(const Digraph& graph, std::span<const int> joints) {
  std::vector<std::string> names;
  for (const JointOrdinal joint : joints) names.push_back(rateName(graph, joint));
  return texColumn(names);
}

std::string texMatrix(const std::vector<std::vector<std::string>>& rows, std::optional<int> partition) {
  const std::size_t columns = rows.empty() ? 0 : rows.front().size();
  std::string alignment(columns, 'r');
  if (partition && *partition > 0 && *partition < static_cast<int>(columns)) {
    alignment.insert(static_cast<std::size_t>(*partition), 1, '|');
  }
  std::string text = "\\left[ \\begin{array}{" + alignment + "}\n";
  for (std::size_t i = 0; i < rows.size(); ++i) {
    for (std::size_t j = 0; j < rows[i].size(); ++j) text += (j > 0 ? " & " : "") + rows[i][j];
    text += i + 1 < rows.size() ? " \\\\\n" : "\n";
  }
  return text + "\\end{array} \\right]";
}

std::string texMatrix(const ResultTable& table) {
  std::vector<std::vector<std::string>> rows;
  for (int row = 0; row < table.rows(); ++row) {
    rows.emplace_back(static_cast<std::size_t>(table.columns()), "0");
    for (const ResultEntry& entry : table.row(row)) {
      rows.back()[static_cast<std::size_t>(entry.column)] = readableLatex(entry);
    }
  }
  return texMatrix(rows, table.partition());
}

std::string texLines(const std::vector<std::string>& lines) {
  std::string text = "\\begin{aligned}\n";
  for (std::size_t i = 0; i < lines.size(); ++i) {
    std::string line = lines[i];
    if (const std::size_t equals = line.find('='); equals != std::string::npos) line.insert(equals, "&");
    text += line + (i + 1 < lines.size() ? " \\\\\n" : "\n");
  }
  return text + "\\end{aligned}";
}

std::string texStages(const std::vector<std::string>& stages) {
  std::string text = "\\begin{aligned}\n" + (stages.empty() ? std::string() : stages.front());
  for (std::size_t i = 1; i < stages.size(); ++i) {
    text += (i > 1 ? " \\\\\n &= " : " &= ") + stages[i];
  }
  return text + "\n\\end{aligned}";
}

std::string tooManyEntries(int rows, int columns, std::string_view commandName) {
  return translated(
      "It has $%1 \\times %2$ entries, too many to print: \"export --to csv --matrix %3\" writes them.",
      {std::to_string(rows), std::to_string(columns), commandName});
}

std::string citedEquations(const std::vector<int>& numbers) {
  std::vector<std::string> names;
  for (const int number : numbers) names.push_back("(" + std::to_string(number) + ")");
  return listed(names, kAllNames);
}

}  // namespace geargraph

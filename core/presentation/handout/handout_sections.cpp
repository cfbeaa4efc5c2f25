#include "core/presentation/handout/handout_sections.h"

#include <array>
#include <cstdio>

#include "core/foundations/base/locale.h"
#include "core/foundations/base/readable.h"
#include "core/foundations/base/text_lists.h"
#include "core/foundations/base/translation.h"
#include "core/presentation/report/report_words.h"
#include "core/teaching/derivation/named_results.h"
#include "core/theory/matroid/coefficient_matrix.h"
#include "core/theory/states/state_solution.h"

namespace geargraph {
namespace {

std::string elementAttribute(const ElementId& element) {
  if (element.id.empty()) return {};
  return " data-el=\"" + std::string(listName(element.kind)) + "/" + escapedXml(element.id.text()) + "\"";
}

std::string heading(const std::string& title) {
  return "<h2>" + escapedXml(title) + "</h2>\n";
}

/// With the minus of print.
std::string printed(std::string number) {
  if (number.starts_with('-')) number.replace(0, 1, "\u2212");
  return number;
}

std::string head(const std::string& text, const ElementId& element, const char* scope,
                 bool beginsPart = false) {
  return "<th scope=\"" + std::string(scope) + "\"" + (beginsPart ? " class=\"part\"" : "") +
         elementAttribute(element) + ">" + escapedXml(text) + "</th>";
}

std::string cell(const std::string& text, int sign, bool beginsPart) {
  std::string classes = sign > 0 ? "plus" : sign < 0 ? "minus" : "zero";
  if (beginsPart) classes += " part";
  return "<td class=\"" + classes + "\">" + (sign == 0 ? "0" : printed(text)) + "</td>";
}

std::string scrolled(const std::string& name, const std::string& table) {
  return "<div class=\"wide\" tabindex=\"0\" role=\"region\" aria-label=\"" + escapedXml(name) + "\">" +
         table + "</div>\n";
}

/// A result as a table: `nameOf` a heading, `textOf` an entry that is not 0.
template <class NameOf, class TextOf>
std::string tableOf(const ResultTable& result, const std::string& name, const NameOf& nameOf,
                    const TextOf& textOf) {
  const auto begins = [&](int column) { return column > 0 && result.partition() == column; };
  std::string table = "<table class=\"matrix\"><thead><tr><td></td>";
  for (int column = 0; column < result.columns(); ++column) {
    const Heading heading = result.columnHeading(column);
    table += head(nameOf(heading), heading.element, "col", begins(column));
  }
  table += "</tr></thead>\n<tbody>\n";
  for (int row = 0; row < result.rows(); ++row) {
    const Heading heading = result.rowHeading(row);
    table += "<tr" + elementAttribute(heading.element) + ">" + head(nameOf(heading), heading.element, "row");
    const std::vector<ResultEntry> entries = result.row(row);
    auto next = entries.begin();
    for (int column = 0; column < result.columns(); ++column) {
      const bool isHere = next != entries.end() && next->column == column && next->value != 0;
      table += isHere ? cell(textOf(*next), next->value < 0 ? -1 : 1, begins(column))
                      : cell({}, 0, begins(column));
      if (next != entries.end() && next->column == column) ++next;
    }
    table += "</tr>\n";
  }
  return scrolled(name, table + "</tbody></table>");
}

std::string matrixTable(const ResultTable& matrix, MatrixKind kind) {
  const std::string name = translated(matrixTitle(kind));
  const std::string symbol = escapedXml(matrixSymbol(kind));
  std::string text = "<h3 data-name=\"" + symbol + "\">" + escapedXml(name) + " " + symbol;
  if (const std::string number = cited(matrixEquation(kind)); !number.empty()) text += ' ' + number;
  return text + "</h3>\n" +
         tableOf(
             matrix, name, [](const Heading& heading) { return heading.text; },
             [](const ResultEntry& entry) { return entry.text; });
}

/// An entry of P: exact where the radius is a fraction, else four digits.
std::string lengthText(const ResultEntry& entry) {
  if (!entry.text.starts_with("\u2248")) return entry.text;
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%.4g", entry.value);
  return localizedNumber(text.data());
}

/// "20 \dot{\theta}_{9} - 30 \dot{\theta}_{12} = 0": radii where both are fractions, else the gear ratio.
std::string rowEquation(const Digraph& graph, const CoefficientMatrix& matrix, MeshOrdinal mesh) {
  const bool isExact = matrix.exactRadius(mesh, true) && matrix.exactRadius(mesh, false);
  std::string sum;
  for (const CoefficientMatrix::Entry& entry : matrix.row(mesh)) {
    const Rational ratio = entry.tail ? matrix.ratio(mesh) : Rational(1);
    const Rational size = isExact ? *matrix.exactRadius(mesh, entry.tail) : ratio;
    const bool isNegative = isExact ? entry.length < 0 : entry.sign < 0;
    if (!sum.empty()) sum += isNegative ? " - " : " + ";
    if (sum.empty() && isNegative) sum = "-";
    if (size != Rational(1)) sum += latexOf(size) + " \\, ";
    sum += rateName(graph, entry.joint);
  }
  return (sum.empty() ? "0" : sum) + " = 0";
}

/// What the rows of P say, an equation for each mesh; nothing where they would be a long list.
std::string rowEquations(const AnalysisSnapshot& snapshot, const CoefficientMatrix& matrix) {
  constexpr int kMaxListed = 100;
  if (matrix.rows() == 0 || matrix.rows() > kMaxListed) return {};
  const Digraph& graph = *snapshot.graph;
  std::vector<ReportBlock> blocks{ReportHeading{2, translated("Rows of P times the rates (17)")}};
  for (MeshOrdinal mesh = 0; mesh < matrix.rows(); ++mesh)
    blocks.emplace_back(
        ReportEquation{rowEquation(graph, matrix, mesh), std::nullopt, {graph.edgeId(graph.t() + mesh)}});
  return reportHtmlBlocks(blocks);
}

std::string coefficientTable(const ResultSource& source) {
  const AnalysisSnapshot& snapshot = *source.snapshot;
  const ResultTablePtr table = resultTable(*resultNamed("p"), source, EntryForm::fractions);
  if (!table) return {};
  const std::string title = translated("Coefficient matrix P (18), (19), in %1", {snapshot.mechanism->unit});
  const CoefficientMatrix matrix(*snapshot.mechanism, *snapshot.kinematics->model,
                                 snapshot.kinematics->placement());
  return "<h3 data-name=\"P\">" + escapedXml(title) + "</h3>\n" +
         tableOf(
             *table, translated("Coefficient matrix"),
             [](const Heading& heading) { return std::to_string(heading.label); }, lengthText) +
         rowEquations(snapshot, matrix);
}

/// `name` is what the page's script calls it by.
std::string figure(const char* name, const std::string& title, const std::string& svg,
                   const std::string& caption) {
  const std::size_t start = svg.find("<svg");
  if (svg.empty() || start == std::string::npos) return {};
  return "<figure data-name=\"" + std::string(name) + "\" data-title=\"" + escapedXml(title) + "\">\n" +
         svg.substr(start) + "<figcaption>" + escapedXml(caption) + "</figcaption>\n</figure>\n";
}

}  // namespace

std::string counted(int number, const char* one, const char* several) {
  return filled(translated(std::string_view(number == 1 ? one : several)), {std::to_string(number)});
}

std::string drawingsSection(const ReportDrawings& drawings, const HandoutLevers& levers) {
  return heading(translated("Drawings")) +
         figure("Digraph", translated("Digraph"), drawings[ReportDrawing::digraph],
                translated("Digraph. Solid arrows: turning joints; dashed: gear meshes.")) +
         figure("Schematic", translated("Schematic"), drawings[ReportDrawing::schematic],
                translated("Schematic.")) +
         figure("T-T graph", translated("T-T graph"), drawings[ReportDrawing::ttGraph],
                translated("T-T graph.")) +
         figure("Levers", translated("Levers"), levers.leversSvg,
                translated("Levers. Points: links of a gear set at exact distances; arrows: their speeds.")) +
         figure("Nomogram", translated("Nomogram"), levers.nomogramSvg,
                translated(
                    "Nomogram. A line for each state through the speeds of the links, the drive being 1."));
}

std::string trainSection(const std::string& still) {
  std::string text = "<h2 class=\"skip\">" + escapedXml(translated("The train")) +
                     "</h2>\n<div id=\"scene\" class=\"scene\">";
  if (!still.empty())
    text += "<img alt=\"" + escapedXml(translated("The train in three dimensions")) +
            "\" width=\"720\" height=\"480\" src=\"data:image/png;base64," + still + "\">";
  const std::string withoutScripts =
      translated("The train turns where scripts may run: open the file in a browser.");
  return text + "</div>\n<noscript><p>" + escapedXml(withoutScripts) + "</p></noscript>\n";
}

std::string matricesSection(const SnapshotPtr& snapshot) {
  std::string text = heading(translated("Matrices"));
  const ResultSource source{snapshot};
  for (const MatrixKind kind : allMatrixKinds()) {
    if (const ResultTablePtr matrix = exactTable(resultOf(kind), source)) text += matrixTable(*matrix, kind);
  }
  if (snapshot->kinematics && snapshot->kinematics->model) text += coefficientTable(source);
  return text;
}

namespace {

/// The states of a gearbox with what they engage and their ratios; nothing where there are none.
std::string statesTable(const AnalysisSnapshot& snapshot, const std::stop_token& stop) {
  const Mechanism& mechanism = *snapshot.mechanism;
  if (mechanism.states.empty() || !snapshot.kinematics || !snapshot.kinematics->model) return {};
  const auto solved =
      solveStates(mechanism, *snapshot.kinematics->model, snapshot.kinematics->placement(), false, stop);
  if (!solved) return {};
  std::string table = "<table class=\"plain\"><thead><tr>" + head(translated("state"), {}, "col") +
                      head(translated("engaged"), {}, "col") + head(translated("ratio"), {}, "col") +
                      "</tr></thead>\n<tbody>\n";
  for (const StateSolution& solution : *solved) {
    const ShiftState& state = mechanism.states[static_cast<std::size_t>(solution.state)];
    std::vector<std::string> engaged;
    for (const ShiftElementId coupling : state.engaged) engaged.push_back(coupling.text());
    table += "<tr data-state=\"" + std::to_string(solution.state) + "\"><th scope=\"row\">" +
             escapedXml(state.name) + "</th><td>" + escapedXml(listed(engaged, kAllNames)) + "</td><td>" +
             (solution.ratio ? printed(readableNumber(*solution.ratio)) : escapedXml(translated("none"))) +
             "</td></tr>\n";
  }
  const std::string title = translated("States");
  return "<h3>" + escapedXml(title) + "</h3>\n" + scrolled(title, table + "</tbody></table>");
}

}  // namespace

std::string solutionSection(const AnalysisSnapshot& snapshot, const std::stop_token& stop) {
  std::string text = heading(translated("Solution"));
  if (!snapshot.solved || !snapshot.solved->exact)
    return text + "<div id=\"inputs\"><p>" +
           escapedXml(translated("The mechanism has no solution: its derivation says why.")) +
           "</p></div>\n" + statesTable(snapshot, stop);
  const ExactSolution& exact = *snapshot.solved->exact;
  const Digraph& graph = *snapshot.graph;
  std::string inputs;
  for (std::size_t i = 0; i < exact.inputs.size(); ++i) {
    inputs += (i == 0 ? "" : ", ") +
              translated("joint %1 at %2 rad/s", {std::to_string(graph.edgeLabel(exact.inputs[i])),
                                                  printed(readableNumber(snapshot.matroid()->speeds[i]))});
  }
  text += "<div id=\"inputs\"><p>" + escapedXml(translated("Inputs: %1.", {inputs})) + "</p></div>\n";
  std::string table = "<table class=\"plain\"><thead><tr>" + head(translated("joint"), {}, "col");
  const bool hasMatrix = !exact.matrix.empty();
  if (hasMatrix) {
    for (const int input : exact.inputs)
      table +=
          head(translated("of %1", {std::to_string(graph.edgeLabel(input))}), graph.edgeId(input), "col");
  }
  table += head(translated("now, rad/s"), {}, "col") + "</tr></thead>\n<tbody>\n";
  for (std::size_t row = 0; row < exact.outputs.size(); ++row) {
    const JointOrdinal joint = exact.outputs[row];
    table += "<tr" + elementAttribute(graph.edgeId(joint)) + ">" +
             head(std::to_string(graph.edgeLabel(joint)), graph.edgeId(joint), "row");
    if (hasMatrix) {
      for (std::size_t column = 0; column < exact.inputs.size(); ++column)
        table += "<td>" + printed(readableNumber(exact.matrix[row * exact.inputs.size() + column])) + "</td>";
    }
    table += "<td class=\"now\" data-now=\"" + std::to_string(joint) + "\">" +
             printed(readableNumber(exact.rates[joint])) + "</td></tr>\n";
  }
  text += scrolled(translated("Speeds of the joints"), table + "</tbody></table>");
  if (snapshot.solved->agreement && snapshot.solved->agreement->equal)
    text += "<p class=\"agreement\">" +
            escapedXml(translated("Matroid method = T–T graph method, exactly, for all %1 joints",
                                  {std::to_string(exact.outputs.size())})) +
            ".</p>\n";
  return text + statesTable(snapshot, stop);
}

std::string derivationSection(const Report& report) {
  return heading(translated("Derivation")) + reportHtmlBlocks(report.blocks);
}

}  // namespace geargraph

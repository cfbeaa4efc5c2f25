#include "app/cli/analyze_text.h"

#include <algorithm>
#include <unordered_map>

#include "app/cli/solution_text.h"
#include "core/foundations/base/translation.h"

namespace geargraph::cli {
namespace {

constexpr int kMaxRows = 40;
constexpr int kMaxColumns = 40;
constexpr int kMaxListedElements = 100;

std::string rightAligned(std::string_view text, std::size_t width) {
  return std::string(width > text.size() ? width - text.size() : 0, ' ') + std::string(text);
}

/// In one of two texts that are marked by toTranslate(), by their number, which is %1.
std::string countedItems(int count, const char* one, const char* many) {
  return filled(translated(count == 1 ? one : many), {std::to_string(count)});
}

std::string heading(const Mechanism& m) {
  return (m.name.empty() ? translated("Untitled mechanism") : m.name) +
         "\nn = " + countedItems(m.n(), toTranslate("%1 moving link"), toTranslate("%1 moving links")) +
         ", t = " + countedItems(m.t(), toTranslate("%1 turning joint"), toTranslate("%1 turning joints")) +
         ", c = " + countedItems(m.c(), toTranslate("%1 gear mesh"), toTranslate("%1 gear meshes")) + '\n';
}

/// The labels of the links, so that joints and meshes are listed with numbers.
std::unordered_map<LinkId, std::string> labelsOfLinks(const Mechanism& m) {
  std::unordered_map<LinkId, std::string> labels;
  for (std::size_t i = 0; i < m.links.size(); ++i) labels[m.links[i].id] = std::to_string(i);
  return labels;
}

std::string elements(const Mechanism& m) {
  if (m.n() + m.t() + m.c() > kMaxListedElements) return {};
  auto labels = labelsOfLinks(m);
  const auto arrow = [&](LinkId tail, LinkId head) { return labels[tail] + " -> " + labels[head]; };
  std::string text = '\n' + translated("Links") + '\n';
  for (int i = 0; i <= m.n(); ++i) {
    const Link& link = m.links[static_cast<std::size_t>(i)];
    const std::string label = std::to_string(m.linkLabel(i));
    text += rightAligned(label, 5) + (link.id.text() == label ? "" : "  " + link.id.text()) +
            (link.name.empty() ? "" : "  " + link.name) + '\n';
  }
  text += '\n' + translated("Turning joints") + '\n';
  for (int i = 0; i < m.t(); ++i) {
    const TurningJoint& joint = m.turningJoints[static_cast<std::size_t>(i)];
    text += rightAligned(std::to_string(m.jointLabel(i)), 5) + "  " + arrow(joint.tail, joint.head) + "  " +
            translated("axis %1", {joint.axis.text()}) + '\n';
  }
  text += '\n' + translated("Gear meshes") + '\n';
  for (int i = 0; i < m.c(); ++i) {
    const GearMesh& mesh = m.gearMeshes[static_cast<std::size_t>(i)];
    text += rightAligned(std::to_string(m.meshLabel(i)), 5) + "  " + arrow(mesh.tail, mesh.head) + "  " +
            translated("teeth %1 : %2", {std::to_string(mesh.tailTeeth), std::to_string(mesh.headTeeth)}) +
            (mesh.kind ? "  " + kindWord(*mesh.kind) : "") + '\n';
  }
  return text;
}

std::string title(const IntegerMatrix& matrix) {
  std::string text =
      '\n' + std::string(matrixSymbol(matrix.kind())) + "   " + translated(matrixTitle(matrix.kind()));
  if (const PaperEquation equation = matrixEquation(matrix.kind()); equation != PaperEquation::none)
    text += ", " + translated("Eq. (%1)", {std::to_string(numberOf(equation))});
  return text + '\n';
}

/// Rows and columns under their labels, zeros as dots, a bar where the matrix is parted.
std::string grid(const IntegerMatrix& matrix) {
  std::size_t labelWidth = 0;
  std::size_t width = 2;
  for (int row = 0; row < matrix.rows(); ++row)
    labelWidth = std::max(labelWidth, matrix.rowHeading(row).text.size());
  for (int column = 0; column < matrix.columns(); ++column) {
    width = std::max(width, matrix.columnHeading(column).text.size());
  }
  const auto part = [&](int column) { return matrix.partition() == column ? " |" : ""; };
  std::string text = std::string(labelWidth + 2, ' ');
  for (int column = 0; column < matrix.columns(); ++column) {
    text += (matrix.partition() == column ? "  " : "") +
            rightAligned(matrix.columnHeading(column).text, width + 1);
  }
  text += '\n';
  for (int row = 0; row < matrix.rows(); ++row) {
    text += "  " + rightAligned(matrix.rowHeading(row).text, labelWidth);
    for (int column = 0; column < matrix.columns(); ++column) {
      const int value = matrix.entry(row, column);
      text += part(column) + rightAligned(value == 0 ? "." : std::to_string(value), width + 1);
    }
    text += '\n';
  }
  return text;
}

std::string matrixText(const IntegerMatrix& matrix) {
  const std::string shape =
      countedItems(matrix.rows(), toTranslate("%1 row"), toTranslate("%1 rows")) + ", " +
      countedItems(matrix.columns(), toTranslate("%1 column"), toTranslate("%1 columns"));
  if (matrix.rows() == 0 || matrix.columns() == 0) return title(matrix) + "  " + shape + '\n';
  if (matrix.rows() > kMaxRows || matrix.columns() > kMaxColumns) {
    return title(matrix) + "  " +
           translated("%1: too large to print; see \"export --to csv --matrix %2\"",
                      {shape, matrixCommandName(matrix.kind())}) +
           '\n';
  }
  return title(matrix) + grid(matrix);
}

}  // namespace

std::string analysisText(const AnalysisSnapshot& snapshot) {
  std::string text = heading(*snapshot.mechanism) + elements(*snapshot.mechanism);
  for (const IntegerMatrixPtr& matrix : snapshot.matrices) {
    if (matrix) text += matrixText(*matrix);
  }
  return text + motionText(snapshot);
}

}  // namespace geargraph::cli

#include "app/cli/solution_text.h"

#include <algorithm>
#include <vector>

#include "app/cli/engagement_options.h"

namespace geargraph::cli {
namespace {

constexpr std::size_t kMostRows = 40;
constexpr std::size_t kMostColumns = 8;
constexpr std::size_t kLongestCell = 48;

std::string padded(const std::string& text, std::size_t width) {
  return std::string(width > text.size() ? width - text.size() : 0, ' ') + text;
}

std::string freedom(const Mechanism& mechanism, const MatroidAnalysis& matroid) {
  const std::string engaged = engagementText(mechanism);
  const std::string parts =
      engaged.empty() ? std::string()
                      : " (" + std::to_string(matroid.independentMeshes.size()) + " of the meshes + " +
                            std::to_string(matroid.independentHeld.size()) + " of the couplings)";
  std::string text = (engaged.empty() ? "" : "\nEngaged: " + engaged) +
                     "\nrank r = " + std::to_string(matroid.rank) + parts +
                     ", degrees of freedom E = t - r = " + std::to_string(matroid.dof);
  if (matroid.kutzbachDof != matroid.dof)
    text += " (Kutzbach counts " + std::to_string(matroid.kutzbachDof) + ')';
  return text + '\n';
}

std::string carriers(const TtGraph& graph) {
  const Digraph& digraph = graph.graph();
  if (digraph.c() == 0 || static_cast<std::size_t>(digraph.c()) > kMostRows) return {};
  std::string text = "\nCarriers of the gear pairs, by their transfer vertices\n";
  for (int mesh = 0; mesh < digraph.c(); ++mesh) {
    const auto& vertex = graph.transferVertices().ofMesh[static_cast<std::size_t>(mesh)];
    if (!vertex) continue;
    const DigraphEdge& edge = digraph.meshEdge(mesh);
    text += padded(std::to_string(digraph.edgeLabel(digraph.t() + mesh)), 5) + "  (" +
            std::to_string(edge.tail) + ',' + std::to_string(edge.head) + ")(" +
            std::to_string(vertex->carrier) + ")  axes " + graph.levels().name(vertex->tailLevel) + ", " +
            graph.levels().name(vertex->headLevel) + '\n';
  }
  return text;
}

/// Rows of the solution: a label, a cell for each input, the rate now.
using Table = std::vector<std::vector<std::string>>;

std::string cell(const SolvedKinematics& solved, std::size_t row, std::size_t column) {
  const std::size_t at = row * solved.exact->inputs.size() + column;
  if (solved.symbolic && solved.symbolic->matrix[at]) {
    std::string symbols = solved.symbolic->matrix[at]->toText();
    if (symbols.size() <= kLongestCell) return symbols;
  }
  return solved.exact->matrix[at].toString();
}

Table tableOf(const AnalysisSnapshot& snapshot) {
  const SolvedKinematics& solved = *snapshot.solved;
  const Digraph& graph = *snapshot.graph;
  Table table(1, {"joint"});
  for (const int input : solved.exact->inputs) table[0].push_back(std::to_string(graph.edgeLabel(input)));
  table[0].emplace_back("rad/s");
  for (std::size_t row = 0; row < solved.exact->outputs.size(); ++row) {
    const int output = solved.exact->outputs[row];
    table.push_back({std::to_string(graph.edgeLabel(output))});
    for (std::size_t column = 0; column < solved.exact->inputs.size(); ++column) {
      const std::string entry = cell(solved, row, column);
      table.back().push_back(entry == "0" ? "." : entry);
    }
    table.back().push_back(solved.exact->rates[static_cast<std::size_t>(output)].toString());
  }
  return table;
}

std::string printed(const Table& table) {
  std::vector<std::size_t> widths(table[0].size(), 0);
  for (const auto& row : table) {
    for (std::size_t i = 0; i < row.size(); ++i) widths[i] = std::max(widths[i], row[i].size());
  }
  std::string text;
  for (const auto& row : table) {
    for (std::size_t i = 0; i < row.size(); ++i) text += "  " + padded(row[i], widths[i]);
    text += '\n';
  }
  return text;
}

std::string solution(const AnalysisSnapshot& snapshot) {
  const SolvedKinematics& solved = *snapshot.solved;
  const ExactSolution& exact = *solved.exact;
  std::string text = "\nRates of the outputs over those of the inputs, Eq. (23)\n";
  text += snapshot.matroid()->inputsGiven ? "inputs" : "inputs, chosen because the file names none:";
  for (std::size_t i = 0; i < exact.inputs.size(); ++i) {
    const auto joint = static_cast<std::size_t>(exact.inputs[i]);
    text += (i > 0 ? ", " : " ") + std::to_string(snapshot.graph->edgeLabel(exact.inputs[i])) + " at " +
            exact.rates[joint].toString() + " rad/s";
  }
  text += exact.inputs.empty() ? " none\n" : "\n";
  if (const std::vector<int>& follow = snapshot.matroid()->choice.rejected; !follow.empty()) {
    text += "not driven, because engaged couplings decide:";
    for (const int joint : follow) text += ' ' + std::to_string(snapshot.graph->edgeLabel(joint));
    text += '\n';
  }
  const bool isSmall = exact.outputs.size() <= kMostRows && exact.inputs.size() <= kMostColumns;
  if (isSmall && exact.matrix.size() == exact.outputs.size() * exact.inputs.size()) {
    text += printed(tableOf(snapshot));
  } else {
    text += "  " + std::to_string(exact.outputs.size()) + " outputs over " +
            std::to_string(exact.inputs.size()) + " inputs: too large to print; see --json\n";
  }
  if (!solved.agreement) return text;
  return text + (solved.agreement->equal ? "The matroid method and the T-T graph method agree exactly.\n"
                                         : "The two methods differ by up to " +
                                               solved.agreement->largestDifference.toString() + ".\n");
}

}  // namespace

std::string motionText(const AnalysisSnapshot& snapshot) {
  std::string text;
  if (const MatroidAnalysis* matroid = snapshot.matroid()) text += freedom(*snapshot.mechanism, *matroid);
  if (snapshot.kinematics) text += carriers(*snapshot.kinematics->ttGraph);
  if (snapshot.solved && snapshot.solved->exact) text += solution(snapshot);
  return text;
}

}  // namespace geargraph::cli

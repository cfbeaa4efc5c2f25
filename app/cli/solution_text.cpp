#include "app/cli/solution_text.h"

#include <algorithm>
#include <vector>

#include "app/cli/engagement_options.h"
#include "core/foundations/base/readable.h"
#include "core/foundations/base/translation.h"
#include "core/foundations/files/utf8.h"

namespace geargraph::cli {
namespace {

constexpr std::size_t kMaxRows = 40;
constexpr std::size_t kMaxColumns = 8;
constexpr std::size_t kMaxCellLength = 48;

std::string padded(const std::string& text, std::size_t width) {
  const std::size_t length = utf8Count(text);
  return std::string(width > length ? width - length : 0, ' ') + text;
}

std::string freedom(const Mechanism& mechanism, const MatroidAnalysis& matroid) {
  const std::string engaged = engagementText(mechanism);
  const std::string rank = std::to_string(matroid.rank);
  const std::string dof = std::to_string(matroid.dof);
  std::string text = engaged.empty() ? "\n" : '\n' + translated("Engaged: %1", {engaged}) + '\n';
  text += engaged.empty()
              ? translated("rank r = %1, degrees of freedom E = t - r = %2", {rank, dof})
              : translated(
                    "rank r = %1 (%3 of the meshes + %4 of the couplings), degrees of freedom E = t - r = %2",
                    {rank, dof, std::to_string(matroid.independentMeshes.size()),
                     std::to_string(matroid.independentHeld.size())});
  if (matroid.kutzbachDof != matroid.dof)
    text += ' ' + translated("(Kutzbach counts %1)", {std::to_string(matroid.kutzbachDof)});
  return text + '\n';
}

std::string carriers(const TtGraph& graph) {
  const Digraph& digraph = graph.graph();
  if (digraph.c() == 0 || static_cast<std::size_t>(digraph.c()) > kMaxRows) return {};
  std::string text = '\n' + translated("Carriers of the gear pairs, by their transfer vertices") + '\n';
  for (int mesh = 0; mesh < digraph.c(); ++mesh) {
    const auto& vertex = graph.transferVertices().ofMesh[static_cast<std::size_t>(mesh)];
    if (!vertex) continue;
    const DigraphEdge& edge = digraph.meshEdge(mesh);
    text += padded(std::to_string(digraph.edgeLabel(digraph.t() + mesh)), 5) + "  (" +
            std::to_string(edge.tail) + ',' + std::to_string(edge.head) + ")(" +
            std::to_string(vertex->carrier) + ")  " +
            translated("axes %1, %2",
                       {graph.levels().name(vertex->tailLevel), graph.levels().name(vertex->headLevel)}) +
            '\n';
  }
  return text;
}

/// Rows of the solution: a label, a cell for each input, the rate now.
using Table = std::vector<std::vector<std::string>>;

std::string readable(const Rational& value) {
  return readableNumber(value);
}
std::string readable(const PiNumber& value) {
  return value.isRational() ? readableNumber(value.rational()) : value.toString();
}

/// "rad/s", of a sliding joint "mm/s".
std::string unitOfRate(const Mechanism& mechanism, JointOrdinal joint) {
  return slides(mechanism.turningJoints[joint]) ? translated("%1/s", {mechanism.unit}) : "rad/s";
}

/// In the gear ratios and as a number: "-i15 = -1/2".
template <class Solution>
std::string cell(const SolvedKinematics& solved, const Solution& exact, std::size_t row, std::size_t column) {
  const std::size_t at = row * exact.inputs.size() + column;
  const std::string number = readable(exact.matrix[at]);
  if (!solved.symbolic || !solved.symbolic->matrix[at]) return number;
  const std::string symbols = solved.symbolic->matrix[at]->toText();
  if (symbols == number || symbols.size() > kMaxCellLength) return number;
  return symbols + " = " + number;
}

template <class Solution>
Table tableOf(const AnalysisSnapshot& snapshot, const Solution& exact) {
  const SolvedKinematics& solved = *snapshot.solved;
  const Digraph& graph = *snapshot.graph;
  const bool hasUnits = hasSlides(*snapshot.mechanism);
  Table table(1, {translated("joint")});
  for (const int input : exact.inputs) table[0].push_back(std::to_string(graph.edgeLabel(input)));
  table[0].emplace_back(hasUnits ? translated("rate") : "rad/s");
  for (std::size_t row = 0; row < exact.outputs.size(); ++row) {
    const int output = exact.outputs[row];
    table.push_back({std::to_string(graph.edgeLabel(output))});
    for (std::size_t column = 0; column < exact.inputs.size(); ++column) {
      const std::string entry = cell(solved, exact, row, column);
      table.back().push_back(entry == "0" ? "." : entry);
    }
    table.back().push_back(readable(exact.rates[output]) +
                           (hasUnits ? " " + unitOfRate(*snapshot.mechanism, output) : ""));
  }
  return table;
}

std::string printed(const Table& table) {
  std::vector<std::size_t> widths(table[0].size(), 0);
  for (const auto& row : table) {
    for (std::size_t i = 0; i < row.size(); ++i) widths[i] = std::max(widths[i], utf8Count(row[i]));
  }
  std::string text;
  for (const auto& row : table) {
    for (std::size_t i = 0; i < row.size(); ++i) text += "  " + padded(row[i], widths[i]);
    text += '\n';
  }
  return text;
}

template <class Solution>
std::string solution(const AnalysisSnapshot& snapshot, const Solution& exact) {
  const SolvedKinematics& solved = *snapshot.solved;
  std::string text = '\n' + translated("Rates of the outputs over those of the inputs, Eq. (23)") + '\n';
  text += snapshot.matroid()->inputsGiven ? translated("inputs")
                                          : translated("inputs, chosen because the file names none:");
  for (std::size_t i = 0; i < exact.inputs.size(); ++i) {
    const JointOrdinal joint = exact.inputs[i];
    const std::string label = std::to_string(snapshot.graph->edgeLabel(joint));
    text += (i > 0 ? ", " : " ") +
            (slides(snapshot.mechanism->turningJoints[joint])
                 ? translated("%1 at %2 %3",
                              {label, readable(exact.rates[joint]), unitOfRate(*snapshot.mechanism, joint)})
                 : translated("%1 at %2 rad/s", {label, readable(exact.rates[joint])}));
  }
  text += exact.inputs.empty() ? ' ' + translated("none") + '\n' : "\n";
  if (const std::vector<int>& follow = snapshot.matroid()->choice.rejected; !follow.empty()) {
    text += translated("not driven, because engaged couplings decide:");
    for (const int joint : follow) text += ' ' + std::to_string(snapshot.graph->edgeLabel(joint));
    text += '\n';
  }
  const bool isSmall = exact.outputs.size() <= kMaxRows && exact.inputs.size() <= kMaxColumns;
  if (isSmall && exact.matrix.size() == exact.outputs.size() * exact.inputs.size()) {
    text += printed(tableOf(snapshot, exact));
  } else {
    text += "  " +
            translated("%1 outputs over %2 inputs: too large to print; see --json",
                       {std::to_string(exact.outputs.size()), std::to_string(exact.inputs.size())}) +
            '\n';
  }
  if (!solved.agreement) return text;
  return text +
         (solved.agreement->equal ? translated("The matroid method and the T-T graph method agree exactly.")
                                  : translated("The two methods differ by up to %1.",
                                               {readableNumber(solved.agreement->largestDifference)})) +
         '\n';
}

}  // namespace

std::string motionText(const AnalysisSnapshot& snapshot) {
  std::string text;
  if (const MatroidAnalysis* matroid = snapshot.matroid()) text += freedom(*snapshot.mechanism, *matroid);
  if (snapshot.kinematics) text += carriers(*snapshot.kinematics->ttGraph);
  if (snapshot.solved && snapshot.solved->exact) text += solution(snapshot, *snapshot.solved->exact);
  if (snapshot.solved && snapshot.solved->pi) text += solution(snapshot, *snapshot.solved->pi);
  return text;
}

}  // namespace geargraph::cli

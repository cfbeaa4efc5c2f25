#include "core/theory/ttgraph/mesh_words.h"

#include "core/theory/ttgraph/equations.h"

namespace geargraph {
namespace {

bool isDigit(char c) {
  return c >= '0' && c <= '9';
}

/// The level between two nodes that a tree branch joins, and the walk along it.
std::string pathText(const TtGraph& graph, MeshOrdinal mesh) {
  const DigraphEdge& edge = graph.graph().meshEdge(mesh);
  std::string text = std::to_string(edge.tail);
  LinkOrdinal node = edge.tail;
  for (const PathStep& step : treePath(graph.tree(), edge.tail, edge.head)) {
    const DigraphEdge& joint = graph.graph().turningEdge(step.joint);
    node = joint.tail == node ? joint.head : joint.tail;
    text += " –" + graph.levels().levelOf(step.joint) + "– " + std::to_string(node);
  }
  return text;
}

}  // namespace

std::string inPrint(std::string_view formula) {
  constexpr std::string_view kLowered[] = {"₀", "₁", "₂", "₃", "₄", "₅", "₆", "₇", "₈", "₉"};
  std::string text;
  bool lowered = false;  // digits right behind a symbol are its index
  for (std::size_t i = 0; i < formula.size(); ++i) {
    const char c = formula[i];
    const bool indexed = i + 1 < formula.size() && isDigit(formula[i + 1]);
    if ((c == 'w' || c == 'n' || c == 'i') && indexed) {
      text += c == 'w' ? "ω" : std::string(1, c);
      lowered = true;
    } else if (lowered && isDigit(c)) {
      text += kLowered[c - '0'];
    } else if (lowered && c == '_' && indexed) {
      text += ",";
    } else {
      lowered = false;
      if (c == '-') {
        text += "−";
      } else if (c == '\'') {
        text += "′";
      } else if (c == '*') {
        text += " ";
      } else {
        text += c;
      }
    }
  }
  return text;
}

std::optional<MeshWords> meshWords(const TtGraph& graph, MeshOrdinal mesh) {
  const auto& vertex = graph.transferVertices().ofMesh[mesh];
  if (!vertex) return std::nullopt;
  const DigraphEdge& edge = graph.graph().meshEdge(mesh);
  MeshWords words;
  words.set = "(" + std::to_string(edge.tail) + "," + std::to_string(edge.head) + ")(" +
              std::to_string(vertex->carrier) + ")";
  words.path = pathText(graph, mesh);
  if (!graph.terminal(mesh)) return words;
  const SubstitutionPlan noPlan;  // only steps need one
  const TtEquations equations(graph, noPlan, RatioNaming::ttGraph, FormulaStyle::text);
  words.terminal = inPrint(equations.terminal(mesh));
  if (!graph.isComplete()) return words;
  words.tailCircuit = inPrint(equations.tailCircuit(mesh));
  words.headCircuit = inPrint(equations.headCircuit(mesh));
  const EquationNumbers numbers(graph, 0);
  words.terminalNumber = numbers.terminal(mesh);
  words.tailNumber = numbers.tailCircuit(mesh);
  words.headNumber = numbers.headCircuit(mesh);
  return words;
}

}  // namespace geargraph

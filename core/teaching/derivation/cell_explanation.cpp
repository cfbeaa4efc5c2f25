#include "core/teaching/derivation/cell_explanation.h"

#include "core/foundations/base/contract.h"
#include "core/foundations/base/translation.h"
#include "core/mechanism/graph/matrices.h"

namespace geargraph {
namespace {

std::string label(int number) {
  return std::to_string(number);
}

/// "joint 10" or "mesh 16".
std::string edgeName(const Digraph& graph, int edge) {
  const std::string number = label(graph.edgeLabel(edge));
  return edge < graph.t() ? translated("joint %1", {number}) : translated("mesh %1", {number});
}

/// The same at the beginning of a sentence or title.
std::string edgeTitle(const Digraph& graph, int edge) {
  const std::string number = label(graph.edgeLabel(edge));
  return edge < graph.t() ? translated("Joint %1", {number}) : translated("Mesh %1", {number});
}

std::string cycleName(const Digraph& graph, MeshOrdinal mesh) {
  return "C" + label(graph.edgeLabel(graph.t() + mesh));
}

/// The ends of an edge as a walk along it, or against it, passes them.
struct Passage {
  std::string from;
  std::string to;
};

Passage passage(const Digraph& graph, int edge, int direction) {
  const DigraphEdge& arrow = graph.edge(edge);
  return {label(graph.nodeLabel(direction > 0 ? arrow.tail : arrow.head)),
          label(graph.nodeLabel(direction > 0 ? arrow.head : arrow.tail))};
}

std::string incidenceText(const Digraph& graph, LinkOrdinal node, int edge) {
  const DigraphEdge& arrow = graph.edge(edge);
  const std::string name = edgeTitle(graph, edge);
  const std::string link = label(graph.nodeLabel(node));
  if (arrow.head == node) return translated("%1 points to link %2: its arrow ends there.", {name, link});
  if (arrow.tail == node) return translated("%1 leaves link %2: its arrow begins there.", {name, link});
  return translated("%1 goes from link %2 to link %3 and does not touch link %4.",
                    {name, label(graph.nodeLabel(arrow.tail)), label(graph.nodeLabel(arrow.head)), link});
}

std::string pathText(const Digraph& graph, const SpanningTree& tree, JointOrdinal joint, LinkOrdinal node) {
  const std::string link = label(graph.nodeLabel(node));
  const std::string edge = edgeName(graph, joint);
  const int value = tree.pathEntry(joint, node);
  if (value == 0) return translated("The walk from link %1 to the ground does not use %2.", {link, edge});
  const auto [from, to] = passage(graph, joint, value);
  return value > 0 ? translated("The walk from link %1 to the ground runs along %2 (from %3 to %4).",
                                {link, edge, from, to})
                   : translated("The walk from link %1 to the ground runs against %2 (from %3 to %4).",
                                {link, edge, from, to});
}

std::string cycleText(const Digraph& graph, const SpanningTree& tree, MeshOrdinal mesh, int edge) {
  const int t = graph.t();
  const std::string cycle = cycleName(graph, mesh);
  const std::string own = edgeName(graph, t + mesh);
  const DigraphEdge& arrow = graph.meshEdge(mesh);
  const std::string tail = label(graph.nodeLabel(arrow.tail));
  const std::string head = label(graph.nodeLabel(arrow.head));
  if (edge == t + mesh)
    return translated("%1 is the cycle that %2 closes, walked along its arrow (from %3 to %4).",
                      {cycle, own, tail, head});
  const std::string other = edgeName(graph, edge);
  if (edge >= t)
    return translated("A cycle of the basis holds one mesh, its own: %1 holds %2, not %3.",
                      {cycle, own, other});
  const int value = tree.pathEntry(edge, arrow.head) - tree.pathEntry(edge, arrow.tail);
  if (value == 0)
    return translated("Walking %1 along %2, the path from %3 back to %4 does not use %5.",
                      {cycle, own, head, tail, other});
  const auto [from, to] = passage(graph, edge, value);
  return value > 0
             ? translated("Walking %1 along %2, the path from %3 back to %4 runs along %5 (from %6 to %7).",
                          {cycle, own, head, tail, other, from, to})
             : translated("Walking %1 along %2, the path from %3 back to %4 runs against %5 (from %6 to %7).",
                          {cycle, own, head, tail, other, from, to});
}

std::string cutsetText(const Digraph& graph, const SpanningTree& tree, JointOrdinal joint, int edge) {
  const std::string own = edgeName(graph, joint);
  if (edge == joint)
    return translated("Without %1 the tree falls into two halves; its own arrow counts as 1.", {own});
  const std::string other = edgeName(graph, edge);
  if (edge < graph.t())
    return translated("A cutset holds one turning joint, its own: %1, not %2.", {own, other});
  const DigraphEdge& arrow = graph.edge(edge);
  const int value = tree.pathEntry(joint, arrow.tail) - tree.pathEntry(joint, arrow.head);
  if (value == 0)
    return translated("Without %1 the tree falls into two halves; %2 stays in one of them.", {own, other});
  return value > 0 ? translated(
                         "Without %1 the tree falls into two halves; %2 crosses over in the direction of %1.",
                         {own, other})
                   : translated("Without %1 the tree falls into two halves; %2 crosses over against %1.",
                                {own, other});
}

const SpanningTree& required(const SpanningTree* tree) {
  GEARGRAPH_REQUIRE(tree != nullptr);
  return *tree;
}

struct Reading {
  std::string title;
  std::string text;
  int value = 0;
};

int incidenceEntry(const Digraph& graph, LinkOrdinal node, int edge) {
  return (graph.edge(edge).head == node ? 1 : 0) - (graph.edge(edge).tail == node ? 1 : 0);
}

Reading readIncidence(const Digraph& graph, LinkOrdinal node, int edge) {
  return {translated("Link %1, %2", {label(graph.nodeLabel(node)), edgeName(graph, edge)}),
          incidenceText(graph, node, edge), incidenceEntry(graph, node, edge)};
}

Reading readCycle(const Digraph& graph, const SpanningTree& tree, MeshOrdinal mesh, int edge) {
  const DigraphEdge& arrow = graph.meshEdge(mesh);
  const int value = edge < graph.t() ? tree.pathEntry(edge, arrow.head) - tree.pathEntry(edge, arrow.tail)
                                     : (edge == graph.t() + mesh ? 1 : 0);
  return {cycleName(graph, mesh) + ", " + edgeName(graph, edge), cycleText(graph, tree, mesh, edge), value};
}

Reading readCutset(const Digraph& graph, const SpanningTree& tree, JointOrdinal joint, int edge) {
  const DigraphEdge& arrow = graph.edge(edge);
  const int value = edge < graph.t() ? (edge == joint ? 1 : 0)
                                     : tree.pathEntry(joint, arrow.tail) - tree.pathEntry(joint, arrow.head);
  return {translated("Cutset of %1, %2", {edgeName(graph, joint), edgeName(graph, edge)}),
          cutsetText(graph, tree, joint, edge), value};
}

Reading read(MatrixKind kind, const Digraph& graph, const SpanningTree* tree, int row, int column) {
  switch (kind) {
    case MatrixKind::incidence:
      return readIncidence(graph, row, column);
    case MatrixKind::reducedIncidence:
      return readIncidence(graph, row + 1, column);
    case MatrixKind::path:
      return {translated("%1, link %2", {edgeTitle(graph, row), label(graph.nodeLabel(column + 1))}),
              pathText(graph, required(tree), row, column + 1), tree->pathEntry(row, column + 1)};
    case MatrixKind::spanningTree:
    case MatrixKind::cycleBasis:
      return readCycle(graph, required(tree), row, column);
    case MatrixKind::cutset:
      return readCutset(graph, required(tree), row, column);
  }
  GEARGRAPH_REQUIRE(false);
}

void addCutset(const Digraph& graph, const SpanningTree& tree, JointOrdinal joint,
               std::set<ElementId>& elements) {
  for (MeshOrdinal mesh = 0; mesh < graph.c(); ++mesh) {
    const DigraphEdge& arrow = graph.meshEdge(mesh);
    if (tree.isOnWalk(joint, arrow.tail) != tree.isOnWalk(joint, arrow.head)) {
      elements.insert(graph.edgeId(graph.t() + mesh));
    }
  }
}

}  // namespace

CellExplanation explainCell(MatrixKind kind, const Digraph& graph, const SpanningTree* tree, int row,
                            int column) {
  Reading reading = read(kind, graph, tree, row, column);
  const PaperEquation equation = matrixEquation(kind);
  reading.text += ' ';
  reading.text += equation == PaperEquation::none ? translated("Not in the paper.")
                                                  : translated("Eq. (%1)", {label(numberOf(equation))});
  return {reading.title + ": " + printedEntry(reading.value), std::move(reading.text)};
}

std::set<ElementId> elementsOfRow(MatrixKind kind, const Digraph& graph, const SpanningTree* tree, int row) {
  std::set<ElementId> elements;
  switch (kind) {
    case MatrixKind::incidence:
      elements.insert(graph.nodeId(row));
      break;
    case MatrixKind::reducedIncidence:
      elements.insert(graph.nodeId(row + 1));
      break;
    case MatrixKind::path:
      elements.insert(graph.edgeId(row));
      break;
    case MatrixKind::spanningTree:
    case MatrixKind::cycleBasis: {
      const DigraphEdge& arrow = graph.meshEdge(row);
      elements.insert(graph.edgeId(graph.t() + row));
      for (const PathStep& step : treePath(required(tree), arrow.head, arrow.tail)) {
        elements.insert(graph.edgeId(step.joint));
      }
      break;
    }
    case MatrixKind::cutset:
      elements.insert(graph.edgeId(row));
      addCutset(graph, required(tree), row, elements);
      break;
  }
  return elements;
}

std::string printedEntry(int value) {
  return value < 0 ? "−" + label(-value) : label(value);
}

}  // namespace geargraph

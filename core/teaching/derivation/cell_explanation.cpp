#include "core/teaching/derivation/cell_explanation.h"

#include "core/foundations/base/contract.h"
#include "core/mechanism/graph/matrices.h"

namespace geargraph::inline derivation {
namespace {

std::string label(int number) {
  return std::to_string(number);
}

/// "joint 10" or "mesh 16".
std::string edgeName(const Digraph& graph, int edge) {
  return (edge < graph.t() ? "joint " : "mesh ") + label(graph.edgeLabel(edge));
}

std::string capital(std::string text) {
  if (text.front() >= 'a' && text.front() <= 'z') text.front() = static_cast<char>(text.front() - 'a' + 'A');
  return text;
}

std::string cycleName(const Digraph& graph, int mesh) {
  return "C" + label(graph.edgeLabel(graph.t() + mesh));
}

/// "runs along joint 9 (from 0 to 5)": a walk over an edge, with or against its arrow.
std::string passage(const Digraph& graph, int edge, int direction) {
  const DigraphEdge& arrow = graph.edge(edge);
  const int from = direction > 0 ? arrow.tail : arrow.head;
  const int to = direction > 0 ? arrow.head : arrow.tail;
  return (direction > 0 ? "runs along " : "runs against ") + edgeName(graph, edge) + " (from " +
         label(graph.nodeLabel(from)) + " to " + label(graph.nodeLabel(to)) + ")";
}

std::string incidenceText(const Digraph& graph, int node, int edge) {
  const DigraphEdge& arrow = graph.edge(edge);
  const std::string name = capital(edgeName(graph, edge));
  const std::string link = "link " + label(graph.nodeLabel(node));
  if (arrow.head == node) return name + " points to " + link + ": its arrow ends there.";
  if (arrow.tail == node) return name + " leaves " + link + ": its arrow begins there.";
  return name + " goes from link " + label(graph.nodeLabel(arrow.tail)) + " to link " +
         label(graph.nodeLabel(arrow.head)) + " and does not touch " + link + ".";
}

std::string pathText(const Digraph& graph, const SpanningTree& tree, int joint, int node) {
  const std::string walk = "The walk from link " + label(graph.nodeLabel(node)) + " to the ground ";
  const int value = tree.pathEntry(joint, node);
  if (value == 0) return walk + "does not use " + edgeName(graph, joint) + ".";
  return walk + passage(graph, joint, value) + ".";
}

std::string cycleText(const Digraph& graph, const SpanningTree& tree, int mesh, int edge) {
  const int t = graph.t();
  const std::string cycle = cycleName(graph, mesh);
  const std::string own = edgeName(graph, t + mesh);
  const DigraphEdge& arrow = graph.meshEdge(mesh);
  const std::string tail = label(graph.nodeLabel(arrow.tail));
  const std::string head = label(graph.nodeLabel(arrow.head));
  if (edge == t + mesh) {
    return cycle + " is the cycle that " + own + " closes, walked along its arrow (from " + tail + " to " +
           head + ").";
  }
  if (edge >= t) {
    return "A cycle of the basis holds one mesh, its own: " + cycle + " holds " + own + ", not " +
           edgeName(graph, edge) + ".";
  }
  const std::string walk =
      "Walking " + cycle + " along " + own + ", the path from " + head + " back to " + tail + " ";
  const int value = tree.pathEntry(edge, arrow.head) - tree.pathEntry(edge, arrow.tail);
  if (value == 0) return walk + "does not use " + edgeName(graph, edge) + ".";
  return walk + passage(graph, edge, value) + ".";
}

std::string cutsetText(const Digraph& graph, const SpanningTree& tree, int joint, int edge) {
  const std::string own = edgeName(graph, joint);
  if (edge == joint) return "Without " + own + " the tree falls into two halves; its own arrow counts as 1.";
  if (edge < graph.t()) {
    return "A cutset holds one turning joint, its own: " + own + ", not " + edgeName(graph, edge) + ".";
  }
  const DigraphEdge& arrow = graph.edge(edge);
  const int value = tree.pathEntry(joint, arrow.tail) - tree.pathEntry(joint, arrow.head);
  const std::string halves = "Without " + own + " the tree falls into two halves; " + edgeName(graph, edge);
  if (value == 0) return halves + " stays in one of them.";
  return halves + (value > 0 ? " crosses over in the direction of " : " crosses over against ") + own + ".";
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

int incidenceEntry(const Digraph& graph, int node, int edge) {
  return (graph.edge(edge).head == node ? 1 : 0) - (graph.edge(edge).tail == node ? 1 : 0);
}

Reading readIncidence(const Digraph& graph, int node, int edge) {
  return {"Link " + label(graph.nodeLabel(node)) + ", " + edgeName(graph, edge),
          incidenceText(graph, node, edge), incidenceEntry(graph, node, edge)};
}

Reading readCycle(const Digraph& graph, const SpanningTree& tree, int mesh, int edge) {
  const DigraphEdge& arrow = graph.meshEdge(mesh);
  const int value = edge < graph.t() ? tree.pathEntry(edge, arrow.head) - tree.pathEntry(edge, arrow.tail)
                                     : (edge == graph.t() + mesh ? 1 : 0);
  return {cycleName(graph, mesh) + ", " + edgeName(graph, edge), cycleText(graph, tree, mesh, edge), value};
}

Reading readCutset(const Digraph& graph, const SpanningTree& tree, int joint, int edge) {
  const DigraphEdge& arrow = graph.edge(edge);
  const int value = edge < graph.t() ? (edge == joint ? 1 : 0)
                                     : tree.pathEntry(joint, arrow.tail) - tree.pathEntry(joint, arrow.head);
  return {"Cutset of " + edgeName(graph, joint) + ", " + edgeName(graph, edge),
          cutsetText(graph, tree, joint, edge), value};
}

Reading read(MatrixKind kind, const Digraph& graph, const SpanningTree* tree, int row, int column) {
  switch (kind) {
    case MatrixKind::incidence:
      return readIncidence(graph, row, column);
    case MatrixKind::reducedIncidence:
      return readIncidence(graph, row + 1, column);
    case MatrixKind::path:
      return {capital(edgeName(graph, row)) + ", link " + label(graph.nodeLabel(column + 1)),
              pathText(graph, required(tree), row, column + 1), tree->pathEntry(row, column + 1)};
    case MatrixKind::spanningTree:
    case MatrixKind::cycleBasis:
      return readCycle(graph, required(tree), row, column);
    case MatrixKind::cutset:
      return readCutset(graph, required(tree), row, column);
  }
  GEARGRAPH_REQUIRE(false);
}

void addCutset(const Digraph& graph, const SpanningTree& tree, int joint, std::set<ElementId>& elements) {
  for (int mesh = 0; mesh < graph.c(); ++mesh) {
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
  const int equation = matrixEquation(kind);
  reading.text += equation == 0 ? " Not in the paper." : " Eq. (" + label(equation) + ")";
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

}  // namespace geargraph::inline derivation

#include "core/ttgraph/transfer_vertices.h"

#include "core/ttgraph/wording.h"

namespace geargraph {
namespace {

std::string wordText(const AxisLevels& levels, const std::vector<int>& word, const char* between = "|") {
  std::string text;
  for (const int level : word) {
    if (!text.empty()) text += between;
    text += levels.names[static_cast<std::size_t>(level)];
  }
  return text;
}

Diagnostic culprit(Code code, const Digraph& graph, int mesh) {
  Diagnostic finding;
  finding.code = code;
  const DigraphEdge& edge = graph.meshEdge(mesh);
  finding.elements = {graph.edgeId(graph.t() + mesh), graph.nodeId(edge.tail), graph.nodeId(edge.head)};
  return finding;
}

std::string meshName(const Digraph& graph, int mesh) {
  return "Mesh " + std::to_string(graph.edgeLabel(graph.t() + mesh));
}

std::string label(int node) {
  return std::to_string(node);
}

Diagnostic coaxial(const Digraph& graph, const AxisLevels& levels, int mesh, const MeshWalk& walk) {
  Diagnostic finding = culprit(Code::coaxialMesh, graph, mesh);
  finding.message = meshName(graph, mesh) + " holds gears " + label(walk.nodes.front()) + " and " +
                    label(walk.nodes.back()) + " on one axis (" + wordText(levels, walk.word) +
                    "). Gears that mesh turn about two axes of one carrier: let one of them turn about "
                    "another axis.";
  return finding;
}

/// The tail gear is well attached to any link that carries the head gear's axis: the last stretch of the
/// walk.
Diagnostic manyAxes(const Digraph& graph, const AxisLevels& levels, int mesh, const MeshWalk& walk) {
  Diagnostic finding = culprit(Code::noTransferVertex, graph, mesh);
  std::vector<std::string> carriers;
  for (std::size_t i = static_cast<std::size_t>(walk.turns.back()); i + 1 < walk.nodes.size(); ++i) {
    carriers.push_back(label(walk.nodes[i]));
  }
  finding.message = meshName(graph, mesh) + " holds gears on " +
                    countInWords(static_cast<int>(walk.word.size())) + " axes (" +
                    wordText(levels, walk.word, ", ") + "): its path reads " + wordText(levels, walk.word) +
                    ". A carrier must hold both axes: attach gear " + label(walk.nodes.front()) +
                    " to link " + listed(carriers, "or") + ".";
  return finding;
}

}  // namespace

MeshWalk meshWalk(const Digraph& graph, const SpanningTree& tree, const AxisLevels& levels, int mesh) {
  MeshWalk walk;
  const DigraphEdge& edge = graph.meshEdge(mesh);
  walk.steps = treePath(tree, edge.tail, edge.head);
  int node = edge.tail;
  walk.nodes.push_back(node);
  for (const PathStep& step : walk.steps) {
    const int level = levels.ofJoint[static_cast<std::size_t>(step.joint)];
    if (walk.word.empty() || walk.word.back() != level) {
      if (!walk.word.empty()) walk.turns.push_back(static_cast<int>(walk.nodes.size()) - 1);
      walk.word.push_back(level);
    }
    const DigraphEdge& branch = graph.turningEdge(step.joint);
    node = branch.tail == node ? branch.head : branch.tail;
    walk.nodes.push_back(node);
  }
  return walk;
}

TransferVertices transferVertices(const Digraph& graph, const SpanningTree& tree, const AxisLevels& levels) {
  TransferVertices result;
  result.ofMesh.resize(static_cast<std::size_t>(graph.c()));
  for (int mesh = 0; mesh < graph.c(); ++mesh) {
    const MeshWalk walk = meshWalk(graph, tree, levels, mesh);
    result.walkLength += static_cast<long long>(walk.steps.size());
    if (walk.word.size() == 2) {
      const int carrier = walk.nodes[static_cast<std::size_t>(walk.turns.front())];
      result.ofMesh[static_cast<std::size_t>(mesh)] = TransferVertex{carrier, walk.word[0], walk.word[1]};
    } else if (walk.word.size() == 1) {
      result.diagnostics.push_back(coaxial(graph, levels, mesh, walk));
    } else {
      result.diagnostics.push_back(manyAxes(graph, levels, mesh, walk));
    }
  }
  return result;
}

}  // namespace geargraph

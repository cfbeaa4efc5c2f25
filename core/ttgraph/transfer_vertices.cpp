#include "core/ttgraph/transfer_vertices.h"

#include "core/base/wording.h"
#include "core/ttgraph/wording.h"

namespace geargraph {
namespace {

std::string wordText(const AxisLevels& levels, const std::vector<WalkStretch>& walk,
                     const char* between = "|") {
  std::string text;
  for (const WalkStretch& stretch : walk) {
    if (!text.empty()) text += between;
    text += levels.name(stretch.level);
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

Diagnostic coaxial(const Digraph& graph, const AxisLevels& levels, int mesh,
                   const std::vector<WalkStretch>& walk) {
  Diagnostic finding = culprit(Code::coaxialMesh, graph, mesh);
  finding.message = meshName(graph, mesh) + " holds gears " + label(walk.front().from) + " and " +
                    label(walk.back().to) + " on one axis (" + wordText(levels, walk) +
                    "). Gears that mesh turn about two axes of one carrier: let one of them turn about "
                    "another axis.";
  return finding;
}

/// The tail gear is well attached to any link that carries the head gear's axis: the last stretch of the
/// walk.
Diagnostic manyAxes(const Digraph& graph, const SpanningTree& tree, const AxisLevels& levels, int mesh,
                    const std::vector<WalkStretch>& walk) {
  Diagnostic finding = culprit(Code::noTransferVertex, graph, mesh);
  std::vector<std::string> carriers;
  int node = walk.back().from;
  for (const PathStep& step : treePath(tree, walk.back().from, walk.back().to)) {
    carriers.push_back(label(node));
    const DigraphEdge& branch = graph.turningEdge(step.joint);
    node = branch.tail == node ? branch.head : branch.tail;
  }
  finding.message = meshName(graph, mesh) + " holds gears on " + countInWords(static_cast<int>(walk.size())) +
                    " axes (" + wordText(levels, walk, ", ") + "): its path reads " + wordText(levels, walk) +
                    ". A carrier must hold both axes: attach gear " + label(walk.front().from) + " to link " +
                    listed(carriers, kMostNames, "or") + ".";
  return finding;
}

}  // namespace

LevelWalks::LevelWalks(const Digraph& graph, const SpanningTree& tree, const AxisLevels& levels)
    : m_graph(graph), m_places(static_cast<std::size_t>(graph.nodeCount())) {
  constexpr std::size_t kUsual = 4;
  m_up.reserve(kUsual);
  m_down.reserve(kUsual);
  for (const int node : tree.preorder()) {
    if (node == 0) continue;
    const int level = levels.ofJoint[static_cast<std::size_t>(tree.jointToParent(node))];
    const int parent = tree.parent(node);
    const Place& above = at(parent);
    m_places[static_cast<std::size_t>(node)] =
        above.level == level ? above : Place{level, parent, tree.depth(parent)};
  }
}

// Climb from both gears, stretch by stretch, the one first whose stretch ends lower: so neither passes the
// node where the walks meet. Where both stand on one level they are joined along it, for a level is one
// piece.
const std::vector<WalkStretch>& LevelWalks::walk(int mesh) {
  auto [tail, head] = m_graph.meshEdge(mesh);
  m_up.clear();
  m_down.clear();
  while (tail != head) {
    const Place& ofTail = at(tail);
    const Place& ofHead = at(head);
    if (ofTail.level == ofHead.level) {
      m_up.push_back({ofTail.level, tail, head});
      break;
    }
    if (ofTail.topDepth >= ofHead.topDepth) {
      m_up.push_back({ofTail.level, tail, ofTail.top});
      tail = ofTail.top;
    } else {
      m_down.push_back({ofHead.level, ofHead.top, head});
      head = ofHead.top;
    }
  }
  m_up.insert(m_up.end(), m_down.rbegin(), m_down.rend());
  return m_up;
}

TransferVertices transferVertices(const Digraph& graph, const SpanningTree& tree, const AxisLevels& levels) {
  TransferVertices result;
  result.ofMesh.reserve(static_cast<std::size_t>(graph.c()));
  LevelWalks walks(graph, tree, levels);
  for (int mesh = 0; mesh < graph.c(); ++mesh) {
    const std::vector<WalkStretch>& walk = walks.walk(mesh);
    auto& vertex = result.ofMesh.emplace_back();
    if (walk.size() == 2) {
      vertex = TransferVertex{walk[0].to, walk[0].level, walk[1].level};
    } else if (walk.size() == 1) {
      result.diagnostics.push_back(coaxial(graph, levels, mesh, walk));
    } else {
      result.diagnostics.push_back(manyAxes(graph, tree, levels, mesh, walk));
    }
  }
  return result;
}

}  // namespace geargraph

#include "core/theory/ttgraph/transfer_vertices.h"

#include "core/foundations/base/scratch.h"
#include "core/foundations/base/text_lists.h"
#include "core/foundations/base/translation.h"
#include "core/theory/ttgraph/wording.h"

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

Diagnostic culprit(Code code, const Digraph& graph, MeshOrdinal mesh) {
  Diagnostic diagnostic;
  diagnostic.code = code;
  const DigraphEdge& edge = graph.meshEdge(mesh);
  diagnostic.elements = {graph.edgeId(graph.t() + mesh), graph.nodeId(edge.tail), graph.nodeId(edge.head)};
  return diagnostic;
}

std::string label(LinkOrdinal node) {
  return std::to_string(node);
}

Diagnostic coaxial(const Digraph& graph, const AxisLevels& levels, MeshOrdinal mesh,
                   const std::vector<WalkStretch>& walk) {
  Diagnostic diagnostic = culprit(Code::coaxialMesh, graph, mesh);
  diagnostic.message = translated(
      "Mesh %1 holds gears %2 and %3 on one axis (%4). Gears that mesh turn about two axes of one carrier: "
      "let "
      "one of them turn about another axis.",
      {std::to_string(graph.edgeLabel(graph.t() + mesh)), label(walk.front().from), label(walk.back().to),
       wordText(levels, walk)});
  return diagnostic;
}

/// The tail gear is well attached to any link that carries the head gear's axis: the last stretch of the
/// walk.
Diagnostic manyAxes(const Digraph& graph, const SpanningTree& tree, const AxisLevels& levels,
                    MeshOrdinal mesh, const std::vector<WalkStretch>& walk) {
  Diagnostic diagnostic = culprit(Code::noTransferVertex, graph, mesh);
  std::vector<std::string> carriers;
  LinkOrdinal node = walk.back().from;
  for (const PathStep& step : treePath(tree, walk.back().from, walk.back().to)) {
    carriers.push_back(label(node));
    const DigraphEdge& branch = graph.turningEdge(step.joint);
    node = branch.tail == node ? branch.head : branch.tail;
  }
  diagnostic.message = translated(
      "The path between the gears of mesh %1 runs over %2 axes (%3), and no carrier holds both of theirs: "
      "attach "
      "gear %4 to link %5.",
      {std::to_string(graph.edgeLabel(graph.t() + mesh)), countInWords(static_cast<int>(walk.size())),
       wordText(levels, walk, ", "), label(walk.front().from),
       listed(carriers, kMaxNames, toTranslate("or"))});
  return diagnostic;
}

}  // namespace

LevelWalks::LevelWalks(const Digraph& graph, const SpanningTree& tree, const AxisLevels& levels,
                       std::pmr::memory_resource* memory)
    : m_graph(graph), m_tree(tree), m_places(static_cast<std::size_t>(graph.nodeCount()), memory) {
  for (const LinkOrdinal node : tree.preorder().subspan(1)) {
    const int level = levels.ofJoint[tree.jointToParent(node)];
    const LinkOrdinal parent = tree.parent(node);
    const Place& above = at(parent);
    m_places[static_cast<std::size_t>(node)] = above.level == level ? above : Place{level, parent};
  }
}

// Climb from both gears, stretch by stretch, the one first whose stretch ends lower: so neither passes the
// node where the walks meet. Where both stand on one level they are joined along it, for a level is one
// piece.
std::vector<WalkStretch> LevelWalks::walk(MeshOrdinal mesh) const {
  auto [tail, head] = m_graph.meshEdge(mesh);
  std::vector<WalkStretch> up;
  std::vector<WalkStretch> down;
  const auto rootDepth = [this](LinkOrdinal node) {
    return node == 0 ? -1 : m_tree.depth(at(node).rootLink);
  };
  while (tail != head) {
    const Place& ofTail = at(tail);
    const Place& ofHead = at(head);
    if (ofTail.level == ofHead.level) {
      up.push_back({ofTail.level, tail, head});
      break;
    }
    if (rootDepth(tail) >= rootDepth(head)) {
      up.push_back({ofTail.level, tail, ofTail.rootLink});
      tail = ofTail.rootLink;
    } else {
      down.push_back({ofHead.level, ofHead.rootLink, head});
      head = ofHead.rootLink;
    }
  }
  up.insert(up.end(), down.rbegin(), down.rend());
  return up;
}

/// The level on which two nodes lie, as its links or its root link; -1 where there is none. @pre the nodes
/// differ
int LevelWalks::levelOfBoth(int a, int b) const {
  const Place& ofA = at(a);
  const Place& ofB = at(b);
  if (ofA.level == ofB.level || ofA.rootLink == b) return ofA.level;
  return ofB.rootLink == a ? ofB.level : -1;
}

// Where a walk leaves a level that it climbed, or enters one that it descends, it passes the level's root
// link: the only vertex of a walk of two stretches is the root link of its tail gear's level or of its head
// gear's.
std::optional<TransferVertex> LevelWalks::transferVertex(MeshOrdinal mesh) const {
  const auto [tail, head] = m_graph.meshEdge(mesh);
  for (const LinkOrdinal gear : {tail, head}) {
    const LinkOrdinal carrier = at(gear).rootLink;
    if (carrier < 0 || carrier == tail || carrier == head) continue;
    const int tailLevel = levelOfBoth(tail, carrier);
    const int headLevel = levelOfBoth(head, carrier);
    if (tailLevel >= 0 && headLevel >= 0 && tailLevel != headLevel) {
      return TransferVertex{carrier, tailLevel, headLevel};
    }
  }
  return std::nullopt;
}

TransferVertices transferVertices(const Digraph& graph, const SpanningTree& tree, const AxisLevels& levels) {
  TransferVertices result;
  result.ofMesh.reserve(static_cast<std::size_t>(graph.c()));
  Scratch<> scratch;
  const LevelWalks walks(graph, tree, levels, &scratch);
  for (MeshOrdinal mesh = 0; mesh < graph.c(); ++mesh) {
    if (result.ofMesh.emplace_back(walks.transferVertex(mesh))) continue;
    const std::vector<WalkStretch> walk = walks.walk(mesh);
    result.diagnostics.push_back(walk.size() == 1 ? coaxial(graph, levels, mesh, walk)
                                                  : manyAxes(graph, tree, levels, mesh, walk));
  }
  return result;
}

}  // namespace geargraph

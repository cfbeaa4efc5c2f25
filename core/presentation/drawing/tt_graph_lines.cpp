#include "core/presentation/drawing/tt_graph_lines.h"

namespace geargraph {
namespace {

/// The paper's primes; beyond four they are counted.
std::string primes(int count) {
  if (count > 4) return "(" + std::to_string(count) + ")";
  std::string text;
  for (int i = 0; i < count; ++i) text += "′";
  return text;
}

}  // namespace

std::vector<TtGraphLine> ttGraphLines(const Mechanism& mechanism, const Digraph& digraph,
                                      const TtGraph* graph) {
  std::vector<TtGraphLine> lines;
  for (JointOrdinal joint = 0; joint < digraph.t(); ++joint) {
    const DigraphEdge& edge = digraph.turningEdge(joint);
    const std::string level =
        graph != nullptr ? graph->levels().levelOf(joint) : mechanism.turningJoints[joint].axis.text();
    lines.push_back({TtLine::branch, edge.head, edge.tail, joint, level});
  }
  for (MeshOrdinal mesh = 0; mesh < digraph.c(); ++mesh) {
    const DigraphEdge& edge = digraph.meshEdge(mesh);
    const int ordinal = digraph.t() + mesh;
    const std::string label = std::to_string(digraph.edgeLabel(ordinal));
    const std::optional<TransferVertex> vertex =
        graph != nullptr ? graph->transferVertices().ofMesh[mesh] : std::nullopt;
    if (!vertex) {
      lines.push_back({TtLine::open, edge.tail, edge.head, ordinal, label});
      continue;
    }
    const std::string marked = label + primes(mesh + 1);
    lines.push_back({TtLine::tailChord, edge.tail, vertex->carrier, ordinal, marked});
    lines.push_back({TtLine::headChord, edge.head, vertex->carrier, ordinal, marked});
  }
  return lines;
}

}  // namespace geargraph

#include "core/theory/ttgraph/tt_matrices.h"

#include <algorithm>

namespace geargraph {

TtChordOf TtMatrices::chord(int chord) const {
  const int ofMeshes = 2 * m_graph->graph().c();
  if (chord >= ofMeshes) return {-1, false, chord - ofMeshes};
  return {chord / 2, chord % 2 == 0, -1};
}

int TtMatrices::coefficient(int branch, LinkOrdinal gear, LinkOrdinal carrier) const {
  const SpanningTree& tree = m_graph->tree();
  const bool isOnGearsSide = tree.isOnWalk(branch, gear);
  if (isOnGearsSide == tree.isOnWalk(branch, carrier)) return 0;
  // A branch from the carrier's side to the gear's adds its velocity, along its level.
  const int outward = -tree.directionToGround(branch) * m_graph->levels().orientationSign(branch);
  return isOnGearsSide ? outward : -outward;
}

std::vector<TtEntry> TtMatrices::circuit(int chord) const {
  std::vector<TtEntry> entries;
  const TtChordOf of = this->chord(chord);
  if (of.held >= 0) {
    for (const CircuitTerm& term : m_graph->held()[static_cast<std::size_t>(of.held)].terms)
      entries.push_back({term.joint, -term.coefficient});
  } else {
    const TerminalPair& pair = *m_graph->terminal(of.mesh);
    const LinkOrdinal gear = of.isTail ? pair.tail : pair.head;
    for (const PathStep& step : treePath(m_graph->tree(), gear, pair.carrier))
      entries.push_back({step.joint, -coefficient(step.joint, gear, pair.carrier)});
  }
  entries.push_back({branches() + chord, 1});
  std::sort(entries.begin(), entries.end(),
            [](const TtEntry& a, const TtEntry& b) { return a.column < b.column; });
  return entries;
}

std::vector<TtEntry> TtMatrices::cutset(int branch) const {
  std::vector<TtEntry> entries{{branch, 1}};
  const auto add = [&](int chord, int value) {
    if (value != 0) entries.push_back({branches() + chord, value});
  };
  const int meshes = m_graph->graph().c();
  for (MeshOrdinal mesh = 0; mesh < meshes; ++mesh) {
    const TerminalPair& pair = *m_graph->terminal(mesh);
    add(2 * mesh, coefficient(branch, pair.tail, pair.carrier));
    add(2 * mesh + 1, coefficient(branch, pair.head, pair.carrier));
  }
  for (std::size_t held = 0; held < m_graph->held().size(); ++held) {
    int value = 0;
    for (const CircuitTerm& term : m_graph->held()[held].terms)
      if (term.joint == branch) value += term.coefficient;
    add(2 * meshes + static_cast<int>(held), value);
  }
  return entries;
}

}  // namespace geargraph

#include "core/theory/ttgraph/tt_graph.h"

#include <algorithm>

#include "core/foundations/base/contract.h"
#include "core/foundations/base/position_index.h"
#include "core/theory/ttgraph/mesh_sign.h"

namespace geargraph {
namespace {

std::optional<int> signFromPlaces(const MeshPose& pose,
                                  const std::optional<ReferenceLines::MeshPlaces>& places) {
  if (!places) return meshSign(pose);
  AxisLine tail = *pose.tailAxis;
  AxisLine head = *pose.headAxis;
  tail.point = {0, 0, 0};
  head.point = places->headPoint;
  return meshSign(
      {&tail, &head, &places->pitchPoint, pose.kind, places->helices, pose.tailSlides, pose.headSlides});
}

}  // namespace

TtGraph::TtGraph(const Mechanism& mechanism, DigraphPtr graph, SpanningTreePtr tree,
                 const ReferenceLines& lines)
    : m_graph(std::move(graph)),
      m_tree(std::move(tree)),
      m_levels(axisLevels(mechanism, *m_graph, lines)),
      m_vertices(geargraph::transferVertices(*m_graph, *m_tree, m_levels)) {
  addTerminals(mechanism, lines);
  if (!mechanism.engaged.empty()) addHeld(mechanism, lines);
}

Diagnostics TtGraph::diagnostics() const {
  Diagnostics all = m_levels.diagnostics;
  append(all, m_vertices.diagnostics);
  return all;
}

long long TtGraph::longestCircuitTerms() const {
  // By level: the depth of its link nearest the ground.
  std::vector<int> rootDepth(static_cast<std::size_t>(m_levels.count()), m_graph->nodeCount());
  for (const LinkOrdinal node : m_tree->preorder()) {
    if (node == 0) continue;
    const int level = m_levels.ofJoint[m_tree->jointToParent(node)];
    int& root = rootDepth[static_cast<std::size_t>(level)];
    root = std::min(root, m_tree->depth(node) - 1);
  }
  long long terms = 0;
  for (const std::optional<TerminalPair>& pair : m_terminals) {
    if (!pair) continue;
    // A chord's circuit stays on one level, so it never climbs above the level's root link.
    const TransferVertex& vertex = *m_vertices.ofMesh[pair->mesh];
    for (const auto& [gear, level] :
         {std::pair(pair->tail, vertex.tailLevel), std::pair(pair->head, vertex.headLevel)}) {
      const int root = rootDepth[static_cast<std::size_t>(level)];
      terms += (m_tree->depth(gear) - root) + (m_tree->depth(pair->carrier) - root);
    }
  }
  for (const HeldCircuit& circuit : m_held) terms += static_cast<long long>(circuit.terms.size());
  return terms;
}

void TtGraph::addHeld(const Mechanism& mechanism, const ReferenceLines& lines) {
  const PositionIndex<LinkTag> links(mechanism.links);
  const PositionIndex<CouplingTag> couplings(mechanism.couplings);
  // Along parallel levels velocities add up like voltages: +1 or -1 between their directions, else 0.
  const auto along = [&](int level, int other) {
    if (level == other) return 1;
    if (m_levels.isSliding(level) != m_levels.isSliding(other)) return 0;
    const AxisLine* const one = lines.axis(m_levels.axisOf(level));
    const AxisLine* const two = lines.axis(m_levels.axisOf(other));
    if (one == nullptr || two == nullptr) return 0;
    if (length(cross(one->direction, two->direction)) >= kSameLine) return 0;
    return dot(one->direction, two->direction) < 0 ? -1 : 1;
  };
  for (const ShiftElementId id : mechanism.engaged) {
    const int position = couplings.at(id);
    const ShiftElement& coupling = mechanism.couplings[position];
    const LinkOrdinal link = links.at(coupling.links.front());
    const int against = coupling.kind == ShiftElementKind::brake ? 0 : links.at(coupling.links.back());
    const std::size_t first = m_held.size();
    std::vector<int> levels;  // of the circuits from `first` on
    for (const PathStep& step : treePath(*m_tree, link, against)) {
      const int level = m_levels.ofJoint[step.joint];
      std::size_t at = 0;
      while (at < levels.size() && along(level, levels[at]) == 0) ++at;
      if (at == levels.size()) {
        levels.push_back(level);
        m_held.push_back({position, {}});
      }
      const int coefficient =
          -step.direction * m_levels.orientationSign(step.joint) * along(level, levels[at]);
      m_held[first + at].terms.push_back({step.joint, coefficient});
    }
  }
}

void TtGraph::addTerminals(const Mechanism& mechanism, const ReferenceLines& lines) {
  const auto lineOf = [&](int level) { return lines.axis(m_levels.axisOf(level)); };
  m_terminals.reserve(static_cast<std::size_t>(m_graph->c()));
  for (MeshOrdinal mesh = 0; mesh < m_graph->c(); ++mesh) {
    const auto at = static_cast<std::size_t>(mesh);
    auto& terminal = m_terminals.emplace_back();
    const std::optional<TransferVertex>& vertex = m_vertices.ofMesh[at];
    if (!vertex) {
      m_complete = false;
      continue;
    }
    const GearMesh& pair = mechanism.gearMeshes[at];
    const bool ofTail = m_levels.isSliding(vertex->tailLevel);
    const MeshPose pose{lineOf(vertex->tailLevel),
                        lineOf(vertex->headLevel),
                        nullptr,
                        pair.kind,
                        {},
                        ofTail,
                        m_levels.isSliding(vertex->headLevel)};
    std::optional<int> sign = pair.kind ? meshSign(pose) : std::nullopt;
    if (!sign) {  // the kind alone does not tell, so the place of the pitch point has to
      sign = signFromPlaces(pose, lines.placesOf(mesh));
    }
    if (sign && pair.crossed) sign = -*sign;  // a strand that crosses over turns the other pulley back
    const std::optional<MeshWeights> weights = weightsOf(pair, ofTail);
    if (!sign || !weights) {
      m_unsigned.push_back(mesh);
      m_complete = false;
      continue;
    }
    const DigraphEdge& edge = m_graph->meshEdge(mesh);
    terminal = TerminalPair{mesh,  edge.tail,     edge.head,     vertex->carrier, mesh + 1,
                            *sign, weights->tail, weights->head, weights->pi};
  }
}

void TtGraph::writeCircuits() const {
  GEARGRAPH_REQUIRE(m_complete);
  std::vector<CircuitTerm>& terms = m_circuits->terms;
  std::vector<std::size_t>& starts = m_circuits->starts;
  starts.reserve(2 * m_terminals.size() + 1);
  starts.push_back(0);
  // The walk leads from the gear to the carrier, so a branch that it meets against its direction leads from
  // the carrier to the gear, and counts.
  const auto addChord = [&](LinkOrdinal gear, LinkOrdinal carrier) {
    for (const PathStep& step : treePath(*m_tree, gear, carrier)) {
      terms.push_back({step.joint, -step.direction * m_levels.orientationSign(step.joint)});
    }
    starts.push_back(terms.size());
  };
  for (const std::optional<TerminalPair>& pair : m_terminals) {
    addChord(pair->tail, pair->carrier);
    addChord(pair->head, pair->carrier);
  }
}

}  // namespace geargraph

#include "core/presentation/drawing/tt_graph_geometry.h"

#include <map>

#include "core/presentation/drawing/coupling_marks.h"
#include "core/presentation/drawing/edge_routing.h"
#include "core/presentation/drawing/label_placement.h"
#include "core/presentation/drawing/node_placement.h"
#include "core/presentation/drawing/text_metrics.h"

namespace geargraph {
namespace {

constexpr double kBesideBranch = 32;  ///< between a branch and an only chord on its side
constexpr double kBetweenLines = 13;  ///< beside a label between two lines of the same two links

/// How far every line is pushed aside because others join the same two links: a branch stays straight, chords
/// take turns on its sides; chords alone spread evenly. Measured from the lower to the higher ordinal.
std::vector<double> offsets(const std::vector<TtGraphLine>& lines, const Centers& centers) {
  std::map<std::pair<int, int>, std::vector<std::size_t>> bundles;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    bundles[std::minmax(lines[i].from, lines[i].to)].push_back(i);
  }
  std::vector<double> offsets(lines.size(), 0);
  for (const auto& [ends, members] : bundles) {
    const auto& a = centers[static_cast<std::size_t>(ends.first)];
    const auto& b = centers[static_cast<std::size_t>(ends.second)];
    if (!a || !b || members.size() == 1) continue;
    const CanvasPoint across = turned(unit(*b - *a));
    double room = 0;
    for (const std::size_t i : members) {
      const Extent label = ttLabelExtent({}, lines[i].label);
      room = std::max(room, label.halfWidth * std::abs(across.x) + label.halfHeight * std::abs(across.y));
    }
    const bool branched = lines[members.front()].kind == TtLine::branch;
    const bool lone = branched && members.size() <= 3;  // its label has room on the outer side
    const double step = lone ? kBesideBranch : 2 * room + kBetweenLines;
    // The first chord beside a branch bows away from the others, to where the lower node stands.
    const CanvasPoint down = a->y <= b->y ? *b - *a : *a - *b;
    const double outward = (down.x < 0) == (across.x > 0) ? 1 : -1;
    const double middle = branched ? 0 : (static_cast<double>(members.size()) - 1) / 2;
    for (std::size_t k = 0; k < members.size(); ++k) {
      const auto turn = static_cast<double>((k + 1) / 2);
      const double place = branched ? outward * (k % 2 == 1 ? turn : -turn) : static_cast<double>(k) - middle;
      const bool against = lines[members[k]].from != ends.first;
      offsets[members[k]] = (against ? -1 : 1) * place * step;
    }
  }
  return offsets;
}

}  // namespace

Extent ttLabelExtent(CanvasPoint center, const std::string& label) {
  return {center, textWidth(label, kLabelSize, true) / 2, kLabelSize * 0.45};
}

TtGraphGeometry ttGraphGeometry(const Mechanism& mechanism, const TtGraph* graph,
                                const NodePositions& positions) {
  const Digraph digraph(mechanism);
  const std::vector<TtGraphLine> lines = ttGraphLines(mechanism, digraph, graph);
  const Centers centers = centersOf(digraph, positions);
  ObstacleGrid taken = gridWithNodes(centers);

  std::vector<DigraphEdge> edges;
  for (const TtGraphLine& line : lines) edges.push_back({line.from, line.to});
  const Courses courses = routedEdges(edges, offsets(lines, centers), centers, taken);
  for (const auto& course : courses) {
    if (course) taken.addCurve(course->curve);
  }

  TtGraphGeometry geometry;
  geometry.nodes = placedNodes(mechanism, digraph, centers, taken);
  geometry.couplings = placedCouplings(mechanism, digraph, centers, geometry.nodes, taken);
  for (std::size_t i = 0; i < lines.size(); ++i) {
    if (!courses[i]) continue;
    const TtGraphLine& line = lines[i];
    const Extent size = ttLabelExtent({}, line.label);
    const Curve& curve = courses[i]->curve;
    const LabelPlace place = placeBeside(curve, size.halfWidth, size.halfHeight, taken);
    taken.addBox(ttLabelExtent(place.center, line.label));
    geometry.lines.push_back({line.kind, digraph.edgeId(line.edge), line.label, line.from, line.to, curve,
                              place.center, place.crowded});
  }
  placeNames(geometry.nodes, mechanism, taken);

  std::vector<bool> carries(static_cast<std::size_t>(digraph.nodeCount()), false);
  for (const TtGraphLine& line : lines) {
    if (line.kind == TtLine::tailChord) carries[static_cast<std::size_t>(line.to)] = true;
  }
  for (const NodePlace& node : geometry.nodes) {
    geometry.isTransfer.push_back(carries[static_cast<std::size_t>(node.label)]);
  }
  return geometry;
}

}  // namespace geargraph

#include "core/presentation/drawing/tt_graph_layout.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>

#include "core/presentation/drawing/tidy_tree.h"
#include "core/presentation/drawing/tt_graph_geometry.h"

namespace geargraph {
namespace {

constexpr double kRank = 130;        ///< between a link and those it carries, at least
constexpr double kSteepness = 0.28;  ///< of the branch to the outermost of many
constexpr double kWidestFan = 1500;  ///< beyond which they fall no farther
constexpr double kSlot = 100;        ///< for a link without children
constexpr double kBesideLines = 64;  ///< of a slot, besides the lines that lead to it
constexpr double kLineRoom = 38;     ///< for one of them with its label
constexpr double kGrid = 10;
constexpr double kNodesApart = 75;       ///< centres, at least
constexpr std::size_t kMaxTried = 6;     ///< children whose every order is tried
constexpr std::size_t kMaxSwapped = 60;  ///< children whose order is improved by swaps

/// The turning joints as a forest: from the ground, then from the first link that is not reached yet, ...
struct Forest {
  std::vector<int> order;  ///< parents before their children
  std::vector<int> parent;
  std::vector<std::vector<int>> children;
  std::vector<int> roots;
};

Forest forestOf(const Digraph& graph) {
  const auto count = static_cast<std::size_t>(graph.nodeCount());
  std::vector<std::vector<int>> neighbours(count);
  for (const DigraphEdge& edge : graph.turningEdges()) {
    neighbours[static_cast<std::size_t>(edge.tail)].push_back(edge.head);
    neighbours[static_cast<std::size_t>(edge.head)].push_back(edge.tail);
  }
  Forest forest{{}, std::vector<int>(count, -1), std::vector<std::vector<int>>(count), {}};
  std::vector<bool> seen(count, false);
  for (int root = 0; root < graph.nodeCount(); ++root) {
    if (seen[static_cast<std::size_t>(root)]) continue;
    seen[static_cast<std::size_t>(root)] = true;
    forest.roots.push_back(root);
    forest.order.push_back(root);
    for (std::size_t next = forest.order.size() - 1; next < forest.order.size(); ++next) {
      const int from = forest.order[next];
      for (const int node : neighbours[static_cast<std::size_t>(from)]) {
        if (seen[static_cast<std::size_t>(node)]) continue;
        seen[static_cast<std::size_t>(node)] = true;
        forest.parent[static_cast<std::size_t>(node)] = from;
        forest.children[static_cast<std::size_t>(from)].push_back(node);
        forest.order.push_back(node);
      }
    }
  }
  return forest;
}

/// How far apart lines keep links of one parent: pairs of positions in the list of children.
using Ties = std::vector<std::pair<std::size_t, std::size_t>>;

/// The lines between the subtrees of different children, by their parent.
std::vector<Ties> tiesOf(const Forest& forest, const std::vector<TtGraphLine>& lines) {
  const std::size_t count = forest.parent.size();
  std::vector<int> depth(count, 0);
  std::vector<std::size_t> place(count, 0);
  for (const int node : forest.order) {
    const auto at = static_cast<std::size_t>(node);
    if (forest.parent[at] >= 0) depth[at] = depth[static_cast<std::size_t>(forest.parent[at])] + 1;
    for (std::size_t i = 0; i < forest.children[at].size(); ++i) {
      place[static_cast<std::size_t>(forest.children[at][i])] = i;
    }
  }
  std::vector<Ties> ties(count);
  for (const TtGraphLine& line : lines) {
    if (line.kind == TtLine::branch) continue;
    int a = line.from;
    int b = line.to;
    const auto up = [&](int node) { return forest.parent[static_cast<std::size_t>(node)]; };
    const auto deep = [&](int node) { return depth[static_cast<std::size_t>(node)]; };
    while (a >= 0 && b >= 0 && up(a) != up(b)) {
      if (deep(a) >= deep(b)) {
        a = up(a);
      } else {
        b = up(b);
      }
    }
    // Where one is above the other, their line runs beside branches only.
    if (a < 0 || b < 0 || a == b || up(a) < 0) continue;
    ties[static_cast<std::size_t>(up(a))].emplace_back(place[static_cast<std::size_t>(a)],
                                                       place[static_cast<std::size_t>(b)]);
  }
  return ties;
}

/// How long the ties are when the children stand in this order.
std::size_t stretch(const std::vector<std::size_t>& order, const Ties& ties) {
  std::vector<std::size_t> place(order.size());
  for (std::size_t i = 0; i < order.size(); ++i) place[order[i]] = i;
  std::size_t sum = 0;
  for (const auto& [a, b] : ties) sum += place[a] > place[b] ? place[a] - place[b] : place[b] - place[a];
  return sum;
}

/// The order of children that stretches the ties least: the best of all for a few, improved by swaps of
/// neighbours for more, as it is for very many.
std::vector<std::size_t> calmOrder(std::size_t count, const Ties& ties) {
  std::vector<std::size_t> order(count);
  std::iota(order.begin(), order.end(), std::size_t{0});
  if (ties.empty() || count < 3 || count > kMaxSwapped) return order;
  std::vector<std::size_t> best = order;
  std::size_t least = stretch(best, ties);
  if (count <= kMaxTried) {
    while (std::next_permutation(order.begin(), order.end())) {
      const std::size_t length = stretch(order, ties);
      if (length >= least) continue;
      least = length;
      best = order;
    }
    return best;
  }
  for (bool better = true; better;) {
    better = false;
    for (std::size_t i = 0; i + 1 < count; ++i) {
      std::vector<std::size_t> tried = best;
      std::swap(tried[i], tried[i + 1]);
      const std::size_t length = stretch(tried, ties);
      if (length >= least) continue;
      least = length;
      best = std::move(tried);
      better = true;
    }
  }
  return best;
}

void orderChildren(Forest& forest, const std::vector<TtGraphLine>& lines) {
  const std::vector<Ties> ties = tiesOf(forest, lines);
  for (std::size_t node = 0; node < forest.children.size(); ++node) {
    const std::vector<int> children = forest.children[node];
    const std::vector<std::size_t> order = calmOrder(children.size(), ties[node]);
    for (std::size_t i = 0; i < order.size(); ++i) forest.children[node][i] = children[order[i]];
  }
}

/// How wide a link's own place is, with the lines that run beside the branch to its parent.
std::vector<double> slots(const Forest& forest, const std::vector<TtGraphLine>& lines) {
  std::vector<int> beside(forest.parent.size(), 0);
  for (const TtGraphLine& line : lines) {
    if (forest.parent[static_cast<std::size_t>(line.from)] == line.to)
      ++beside[static_cast<std::size_t>(line.from)];
    if (forest.parent[static_cast<std::size_t>(line.to)] == line.from)
      ++beside[static_cast<std::size_t>(line.to)];
  }
  std::vector<double> widths;
  for (const int count : beside) widths.push_back(std::max(kSlot, kBesideLines + count * kLineRoom));
  return widths;
}

CanvasPoint onGrid(CanvasPoint p) {
  return {std::round(p.x / kGrid) * kGrid, std::round(p.y / kGrid) * kGrid};
}

/// Ranks below each other, the farther the wider their links are spread under their parents.
void dropRanks(const Forest& forest, std::vector<CanvasPoint>& places) {
  std::vector<std::size_t> rank(places.size(), 0);
  std::vector<double> drop{0};
  for (const int node : forest.order) {
    const auto at = static_cast<std::size_t>(node);
    for (const int child : forest.children[at]) {
      const auto below = static_cast<std::size_t>(child);
      rank[below] = rank[at] + 1;
      if (rank[below] == drop.size()) drop.push_back(kRank);
      const double aside = std::min(std::abs(places[below].x - places[at].x), kWidestFan);
      drop[rank[below]] = std::max(drop[rank[below]], 2 * kSteepness * aside);
    }
  }
  std::partial_sum(drop.begin(), drop.end(), drop.begin());
  for (std::size_t node = 0; node < places.size(); ++node) places[node].y = drop[rank[node]];
}

/// Every node behind its parent, siblings in the order in which they stand.
std::vector<int> drawnOrder(const Forest& forest) {
  std::vector<int> order = forest.roots;
  for (std::size_t i = 0; i < order.size(); ++i) {
    const std::vector<int>& children = forest.children[static_cast<std::size_t>(order[i])];
    order.insert(order.end(), children.begin(), children.end());
  }
  return order;
}

/// Slots as wide as all that hangs below them, so that no subtree reaches under its neighbour.
std::vector<double> withSubtrees(const Forest& forest, std::vector<double> slots) {
  for (auto node = forest.order.rbegin(); node != forest.order.rend(); ++node) {
    double below = 0;
    for (const int child : forest.children[static_cast<std::size_t>(*node)])
      below += slots[static_cast<std::size_t>(child)];
    double& own = slots[static_cast<std::size_t>(*node)];
    own = std::max(own, below);
  }
  return slots;
}

/// Places by node: subtrees side by side as close as their slots allow, a parent over the middle of its
/// children.
std::vector<CanvasPoint> hung(const Forest& forest, const std::vector<double>& slots) {
  std::vector<CanvasPoint> places;
  for (const TidyPlace& place : tidyForest(forest.parent, drawnOrder(forest), slots))
    places.push_back({place.row, 0});
  dropRanks(forest, places);
  const CanvasPoint ground = places.front();
  for (CanvasPoint& place : places) place = onGrid(place - ground);
  return places;
}

/// Does a label or a badge touch something?
bool isCrowded(const TtGraphGeometry& geometry) {
  return std::any_of(geometry.lines.begin(), geometry.lines.end(),
                     [](const TtLinePlace& line) { return line.labelCrowded; }) ||
         std::any_of(geometry.nodes.begin(), geometry.nodes.end(),
                     [](const NodePlace& node) { return node.badgeCrowded; });
}

/// Does every label stand by its own line rather than by another one?
bool isClear(const TtGraphGeometry& geometry) {
  return std::none_of(geometry.lines.begin(), geometry.lines.end(), [&](const TtLinePlace& line) {
    const double own = distanceToCurve(line.labelCenter, line.curve);
    return std::any_of(geometry.lines.begin(), geometry.lines.end(), [&](const TtLinePlace& other) {
      return distanceToCurve(line.labelCenter, other.curve) < own - 1;
    });
  });
}

/// The place itself, or the nearest on a spiral around it that is away from all of `others`.
CanvasPoint roomNear(CanvasPoint wanted, const std::vector<CanvasPoint>& others) {
  constexpr double kGoldenAngle = 2.399963229728653;
  for (int i = 0;; ++i) {
    const double radius = kNodesApart / 2 * std::sqrt(i);
    const CanvasPoint tried =
        i == 0
            ? wanted
            : onGrid(wanted + radius * CanvasPoint{std::cos(i * kGoldenAngle), std::sin(i * kGoldenAngle)});
    const bool free = std::all_of(others.begin(), others.end(),
                                  [&](CanvasPoint other) { return distance(tried, other) >= kNodesApart; });
    if (free) return tried;
  }
}

}  // namespace

NodePositions ttLayout(const Mechanism& mechanism, const TtGraph* graph) {
  const Digraph digraph(mechanism);
  const std::vector<TtGraphLine> lines = ttGraphLines(mechanism, digraph, graph);
  Forest forest = forestOf(digraph);
  orderChildren(forest, lines);
  const std::vector<double> own = slots(forest, lines);
  const std::vector<CanvasPoint> close = hung(forest, own);
  const std::vector<CanvasPoint> roomy = hung(forest, withSubtrees(forest, own));
  NodePositions positions;
  const auto put = [&](const std::vector<CanvasPoint>& places, double stretch, bool wantsClear) {
    for (int v = 0; v < digraph.nodeCount(); ++v) {
      positions[digraph.nodeId(v)] = onGrid(stretch * places[static_cast<std::size_t>(v)]);
    }
    if (lines.size() > kMaxLinesChecked) return true;
    const TtGraphGeometry geometry = ttGraphGeometry(mechanism, graph, positions);
    return !isCrowded(geometry) && (!wantsClear || isClear(geometry));
  };
  for (const double stretch : {1.0, 1.2}) {
    if (put(close, stretch, true)) return positions;
  }
  for (const double stretch : {1.0, 1.2, 1.45, 1.75, 2.1, 2.5, 3.0, 3.6, 4.3}) {
    if (put(roomy, stretch, false)) return positions;
  }
  return positions;
}

NodePositions ttPositions(NodePositions layout, const NodePositions& chosen) {
  std::vector<CanvasPoint> standing;
  for (const auto& [link, place] : chosen) {
    const auto found = layout.find(link);
    if (found == layout.end()) continue;
    found->second = onSheet(place);
    standing.push_back(found->second);
  }
  if (standing.empty()) return layout;
  for (auto& [link, place] : layout) {
    if (chosen.contains(link)) continue;
    const CanvasPoint room = roomNear(place, standing);
    if (room == place) continue;
    place = room;
    standing.push_back(room);
  }
  return layout;
}

}  // namespace geargraph

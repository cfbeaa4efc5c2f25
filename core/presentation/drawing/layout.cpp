#include "core/presentation/drawing/layout.h"

#include <cstdint>

#include "core/mechanism/graph/digraph.h"
#include "core/presentation/drawing/layered_places.h"
#include "core/presentation/drawing/tidy_tree.h"

namespace geargraph {
namespace {

constexpr double kColumn = 170;    ///< between a link and the one it carries
constexpr double kRow = 110;       ///< between neighbours of a column
constexpr int kMaxLayered = 300;   ///< nodes; the time grows with their square, and it cannot be stopped
constexpr int kMaxMeshLength = 6;  ///< columns, of those that the layered layout is told of
constexpr double kGrid = 10;
constexpr double kNodesApart = 75;  ///< centres, at least
constexpr double kClosest = 80;     ///< columns and rows, of drawings that fill the sheet

using Places = std::vector<CanvasPoint>;

CanvasPoint onGrid(CanvasPoint p) {
  return {std::round(p.x / kGrid) * kGrid, std::round(p.y / kGrid) * kGrid};
}

/// The links that joints tie to each link; over meshes too if `meshes`.
std::vector<std::vector<int>> neighbours(const Digraph& graph, bool meshes) {
  std::vector<std::vector<int>> lists(static_cast<std::size_t>(graph.nodeCount()));
  const int count = meshes ? graph.edgeCount() : graph.t();
  for (int e = 0; e < count; ++e) {
    const DigraphEdge& edge = graph.edge(e);
    lists[static_cast<std::size_t>(edge.tail)].push_back(edge.head);
    lists[static_cast<std::size_t>(edge.head)].push_back(edge.tail);
  }
  return lists;
}

/// A walk over all links, from those of `start` on: each with the link it was reached from (-1 at the start).
struct Reached {
  int node;
  int from;
};
std::vector<Reached> breadthFirst(const std::vector<std::vector<int>>& lists, const std::vector<int>& start) {
  std::vector<bool> seen(lists.size(), false);
  std::vector<Reached> order;
  const auto reach = [&](int node, int from) {
    if (seen[static_cast<std::size_t>(node)]) return;
    seen[static_cast<std::size_t>(node)] = true;
    order.push_back({node, from});
  };
  std::size_t next = 0;
  const auto spread = [&] {
    for (; next < order.size(); ++next) {
      const int from = order[next].node;
      for (const int node : lists[static_cast<std::size_t>(from)]) reach(node, from);
    }
  };
  for (const int node : start) reach(node, -1);
  spread();
  for (int node = 0; node < static_cast<int>(lists.size()); ++node) {
    reach(node, -1);
    spread();
  }
  return order;
}

/// How far each link is from the ground over turning joints, and when a walk from there reaches it.
struct Order {
  std::vector<int> depth;
  std::vector<int> rank;
};
Order orderOf(const Digraph& graph) {
  const auto count = static_cast<std::size_t>(graph.nodeCount());
  Order order{std::vector<int>(count, 0), std::vector<int>(count, 0)};
  int reached = 0;
  for (const auto [node, from] : breadthFirst(neighbours(graph, false), {0})) {
    order.rank[static_cast<std::size_t>(node)] = reached++;
    if (from >= 0)
      order.depth[static_cast<std::size_t>(node)] = order.depth[static_cast<std::size_t>(from)] + 1;
  }
  return order;
}

/// The tree of the turning joints, whatever meshes do.
Places asTree(const Digraph& graph) {
  std::vector<int> parent(static_cast<std::size_t>(graph.nodeCount()), -1);
  std::vector<int> order;
  for (const auto [node, from] : breadthFirst(neighbours(graph, false), {0})) {
    parent[static_cast<std::size_t>(node)] = from;
    order.push_back(node);
  }
  const std::vector<TidyPlace> tree = tidyForest(parent, order);
  double columns = 0;
  double rows = 0;
  for (const TidyPlace& place : tree) {
    columns = std::max<double>(columns, place.column);
    rows = std::max(rows, std::abs(place.row - tree.front().row));
  }
  // What would reach over the sheet's end is drawn closer, down to where nodes just keep apart.
  const double column = std::clamp(kSheetEnd / std::max(columns, 1.0), kClosest, kColumn);
  const double row = std::clamp(kSheetEnd / std::max(rows, 1.0), kClosest, kRow);
  Places places;
  places.reserve(tree.size());
  for (const TidyPlace& place : tree) {
    places.push_back(onGrid({place.column * column, (place.row - tree.front().row) * row}));
  }
  return places;
}

/// Joints may be drawn either way; the layout puts what is nearer to the ground on the left. Meshes over many
/// columns would cost it minutes, and it could do nothing for them.
std::vector<LayeredEdge> layeredEdges(const Digraph& graph) {
  const Order order = orderOf(graph);
  std::vector<LayeredEdge> edges;
  for (int e = 0; e < graph.edgeCount(); ++e) {
    DigraphEdge edge = graph.edge(e);
    const auto tail = static_cast<std::size_t>(edge.tail);
    const auto head = static_cast<std::size_t>(edge.head);
    const bool isMesh = e >= graph.t();
    if (isMesh && std::abs(order.depth[tail] - order.depth[head]) > kMaxMeshLength) continue;
    if (order.rank[tail] > order.rank[head]) std::swap(edge.tail, edge.head);
    edges.push_back({edge.tail, edge.head, isMesh});
  }
  return edges;
}

/// Places by ordinal; the ground stands at (0, 0).
Places placesOf(const Digraph& graph) {
  if (graph.nodeCount() > kMaxLayered) return asTree(graph);
  const auto layered = layeredPlaces(graph.nodeCount(), layeredEdges(graph));
  if (!layered) return asTree(graph);
  const CanvasPoint ground = layered->front();
  Places places;
  for (const CanvasPoint at : *layered)
    places.push_back(onGrid({(at.x - ground.x) * kColumn / 2, (ground.y - at.y) * kRow / 2}));
  return places;
}

/// Nodes that are placed, in cells of kNodesApart.
class OccupiedCells {
 public:
  void add(CanvasPoint p) { m_cells[cell(p)].push_back(p); }
  [[nodiscard]] bool hasRoom(CanvasPoint p) const {
    const auto [column, row] = cell(p);
    for (std::int64_t c = column - 1; c <= column + 1; ++c) {
      for (std::int64_t r = row - 1; r <= row + 1; ++r) {
        const auto found = m_cells.find({c, r});
        if (found == m_cells.end()) continue;
        for (const CanvasPoint other : found->second) {
          if (distance(p, other) < kNodesApart) return false;
        }
      }
    }
    return true;
  }
  /// The place itself, or the nearest on a spiral around it that has room.
  [[nodiscard]] CanvasPoint roomNear(CanvasPoint wanted) const {
    constexpr double kGoldenAngle = 2.399963229728653;
    for (int i = 0;; ++i) {
      const double radius = kNodesApart / 2 * std::sqrt(i);
      const CanvasPoint tried =
          onGrid(wanted + radius * CanvasPoint{std::cos(i * kGoldenAngle), std::sin(i * kGoldenAngle)});
      if (hasRoom(tried)) return tried;
    }
  }

 private:
  using Cell = std::pair<std::int64_t, std::int64_t>;
  static Cell cell(CanvasPoint p) {
    return {static_cast<std::int64_t>(std::floor(p.x / kNodesApart)),
            static_cast<std::int64_t>(std::floor(p.y / kNodesApart))};
  }
  std::map<Cell, std::vector<CanvasPoint>> m_cells;
};

}  // namespace

NodePositions layoutOf(const Mechanism& mechanism) {
  const Digraph graph(mechanism);
  const Places places = placesOf(graph);
  NodePositions positions;
  for (int v = 0; v < graph.nodeCount(); ++v)
    positions[graph.nodeId(v)] = places[static_cast<std::size_t>(v)];
  return positions;
}

NodePositions completedPositions(const Mechanism& mechanism) {
  NodePositions positions = mechanism.view.nodes;
  const Digraph graph(mechanism);
  std::vector<int> placed;
  OccupiedCells occupied;
  for (int v = 0; v < graph.nodeCount(); ++v) {
    const auto found = positions.find(graph.nodeId(v));
    if (found == positions.end()) continue;
    placed.push_back(v);
    occupied.add(onSheet(found->second));
  }
  if (placed.empty()) return layoutOf(mechanism);
  if (placed.size() == static_cast<std::size_t>(graph.nodeCount())) return positions;

  const Places ideal = placesOf(graph);
  for (const auto [node, from] : breadthFirst(neighbours(graph, true), placed)) {
    const LinkId link = graph.nodeId(node);
    if (positions.contains(link)) continue;
    // A link that nothing ties to the placed ones goes where it lies seen from the first of those.
    const int anchor = from < 0 ? placed.front() : from;
    const CanvasPoint offset =
        ideal[static_cast<std::size_t>(node)] - ideal[static_cast<std::size_t>(anchor)];
    const CanvasPoint place = occupied.roomNear(onSheet(positions.at(graph.nodeId(anchor))) + offset);
    positions[link] = place;
    occupied.add(place);
  }
  return positions;
}

}  // namespace geargraph

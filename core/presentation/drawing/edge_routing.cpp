#include "core/presentation/drawing/edge_routing.h"

#include <array>
#include <map>

#include "core/presentation/drawing/digraph_geometry.h"

namespace geargraph {
namespace {

constexpr double kGapToRim = 2;          ///< between a ring and an arrow's end
constexpr double kGapToOtherNode = 8;    ///< between an arrow and a node that it passes
constexpr double kParallelSpacing = 34;  ///< between arrows of the same two links
constexpr double kDetourStep = 16;
constexpr double kMaxDetourStep = 60;
constexpr int kDetours = 12;           ///< sizes that are tried
constexpr int kDetoursInACrowd = 3;    ///< where there are many arrows, few of them can be helped
constexpr std::size_t kCrowd = 400;    ///< arrows
constexpr double kMaxAside = 1.25;     ///< times its size: how far a detour is off the straight line
constexpr int kMaxHits = 4;            ///< more count as many
constexpr std::size_t kFewMoved = 16;  ///< places, for which looking at what they concern pays
constexpr double kTrimRadius = kNodeRadius + kRingWidth / 2 + kGapToRim;

/// The parameter where the curve leaves the circle of kTrimRadius around `center` for good, sought from the
/// end where it is inside (at parameter `inside`) towards the other.
double crossing(const Curve& curve, CanvasPoint center, double inside, double outside) {
  for (int i = 0; i < 24; ++i) {
    const double middle = (inside + outside) / 2;
    (distance(curve.at(middle), center) < kTrimRadius ? inside : outside) = middle;
  }
  return outside;
}

/// Twice the straight middle line's offset for each edge among those of the same two links: 0 for an only
/// one, else spread evenly to both sides, measured in the direction from the lower to the higher ordinal.
std::vector<double> parallelHeights(const Digraph& graph) {
  const auto key = [&](int edge) { return std::minmax({graph.edge(edge).tail, graph.edge(edge).head}); };
  std::map<std::pair<int, int>, std::vector<int>> bundles;
  for (int e = 0; e < graph.edgeCount(); ++e) bundles[key(e)].push_back(e);
  std::vector<double> heights(static_cast<std::size_t>(graph.edgeCount()), 0);
  for (const auto& [ends, edges] : bundles) {
    for (std::size_t i = 0; i < edges.size(); ++i) {
      const double place = static_cast<double>(i) - (static_cast<double>(edges.size()) - 1) / 2;
      const bool against = graph.edge(edges[i]).tail != ends.first;
      heights[static_cast<std::size_t>(edges[i])] = (against ? -1 : 1) * place * kParallelSpacing;
    }
  }
  return heights;
}

/// Long arrows may go farther round, but not without end.
double detourStep(CanvasPoint from, CanvasPoint to) {
  return std::clamp(0.02 * distance(from, to), kDetourStep, kMaxDetourStep);
}

/// What a detour of size 1 adds to the pull at both thirds: bows, bumps near one end, and the two S.
struct Pull {
  double first;
  double second;
};
constexpr std::array<Pull, 8> kPulls{
    {{1, 1}, {-1, -1}, {1.8, 0}, {0, 1.8}, {-1.8, 0}, {0, -1.8}, {2.6, -2.6}, {-2.6, 2.6}}};

/// The least bent course that passes all other nodes; where there is none, the one that meets the fewest.
Course detour(CanvasPoint from, CanvasPoint to, double height, const ObstacleGrid& nodes,
              const DigraphEdge& edge, int mostSteps) {
  Curve best = Curve::pulled(from, to, height, height);
  int fewest = nodes.circlesHit(best, kGapToOtherNode, edge.tail, edge.head, kMaxHits);
  int step = 0;
  while (fewest > 0 && step < mostSteps) {
    const double size = ++step * detourStep(from, to);
    for (const Pull pull : kPulls) {
      const Curve tried = Curve::pulled(from, to, height + size * pull.first, height + size * pull.second);
      const int hits = nodes.circlesHit(tried, kGapToOtherNode, edge.tail, edge.head, fewest);
      if (hits >= fewest) continue;
      best = tried;
      fewest = hits;
      if (fewest == 0) break;
    }
  }
  return {trimmedAtRims(best), step, height};
}

}  // namespace

Curve trimmedAtStart(const Curve& curve) {
  if (distance(curve.from, curve.to) <= kTrimRadius) return Curve::straight(curve.to, curve.to);
  return curve.part(crossing(curve, curve.from, 0, 1), 1);
}

Curve trimmedAtRims(const Curve& curve) {
  // Discs that touch leave no room for an arrow: it shrinks to the middle.
  if (distance(curve.from, curve.to) <= 2 * kTrimRadius && curve.isStraight()) {
    return Curve::straight(curve.at(0.5), curve.at(0.5));
  }
  const double start = crossing(curve, curve.from, 0, 0.5);
  const double end = crossing(curve, curve.to, 1, 0.5);
  return curve.part(start, end);
}

Courses routedEdges(const Digraph& graph, const Centers& centers, const ObstacleGrid& nodes) {
  return reroutedEdges(graph, centers, nodes, {}, Courses(static_cast<std::size_t>(graph.edgeCount())));
}

Courses routedEdges(std::span<const DigraphEdge> edges, const std::vector<double>& offsets,
                    const Centers& centers, const ObstacleGrid& nodes) {
  const int mostSteps = edges.size() > kCrowd ? kDetoursInACrowd : kDetours;
  Courses courses(edges.size());
  for (std::size_t e = 0; e < edges.size(); ++e) {
    const auto& from = centers[static_cast<std::size_t>(edges[e].tail)];
    const auto& to = centers[static_cast<std::size_t>(edges[e].head)];
    if (from && to) courses[e] = detour(*from, *to, offsets[e], nodes, edges[e], mostSteps);
  }
  return courses;
}

Courses reroutedEdges(const Digraph& graph, const Centers& centers, const ObstacleGrid& nodes,
                      const std::vector<CanvasPoint>& moved, const Courses& former) {
  const bool fewMoved = moved.size() <= kFewMoved;
  const int mostSteps = static_cast<std::size_t>(graph.edgeCount()) > kCrowd ? kDetoursInACrowd : kDetours;
  const std::vector<double> heights = parallelHeights(graph);
  Courses courses(static_cast<std::size_t>(graph.edgeCount()));
  for (std::size_t e = 0; e < courses.size(); ++e) {
    const DigraphEdge& edge = graph.edge(static_cast<int>(e));
    const auto& from = centers[static_cast<std::size_t>(edge.tail)];
    const auto& to = centers[static_cast<std::size_t>(edge.head)];
    if (!from || !to) continue;
    // No course that was looked at lies farther from the straight line than this.
    const auto concerns = [&](CanvasPoint place) {
      const double aside = kMaxAside * former[e]->looked * detourStep(*from, *to);
      const double reach = std::abs(heights[e]) + aside + kGapToOtherNode + 2 * kNodeRadius;
      return distanceToSegment(place, *from, *to) <= reach;
    };
    const bool known = fewMoved && former[e] && former[e]->height == heights[e];
    if (known && std::none_of(moved.begin(), moved.end(), concerns)) {
      courses[e] = former[e];
    } else {
      courses[e] = detour(*from, *to, heights[e], nodes, edge, mostSteps);
    }
  }
  return courses;
}

}  // namespace geargraph

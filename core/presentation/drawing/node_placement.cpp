#include "core/presentation/drawing/node_placement.h"

#include <array>
#include <cmath>
#include <map>
#include <numbers>

#include "core/presentation/drawing/label_placement.h"
#include "core/presentation/drawing/text_metrics.h"

namespace geargraph {
namespace {

constexpr double kMargin = 80;
constexpr std::size_t kNameCharacters = 18;
constexpr double kRim = kNodeRadius + kRingWidth / 2;

/// How far a link is from the ground over turning joints; links out of reach are infinitely far.
std::vector<int> depths(const Digraph& graph) {
  constexpr int kFar = 1 << 30;
  std::vector<std::vector<int>> neighbours(static_cast<std::size_t>(graph.nodeCount()));
  for (const DigraphEdge& edge : graph.turningEdges()) {
    neighbours[static_cast<std::size_t>(edge.tail)].push_back(edge.head);
    neighbours[static_cast<std::size_t>(edge.head)].push_back(edge.tail);
  }
  std::vector<int> depth(neighbours.size(), kFar);
  depth.front() = 0;
  std::vector<int> order{0};
  for (std::size_t i = 0; i < order.size(); ++i) {
    for (const int next : neighbours[static_cast<std::size_t>(order[i])]) {
      if (depth[static_cast<std::size_t>(next)] != kFar) continue;
      depth[static_cast<std::size_t>(next)] = depth[static_cast<std::size_t>(order[i])] + 1;
      order.push_back(next);
    }
  }
  return depth;
}

/// The driven joints by the link that they move: the one farther from the ground, else the head.
std::map<int, JointId> drivenLinks(const Mechanism& mechanism, const Digraph& graph) {
  std::map<int, JointId> driven;
  if (!mechanism.inputs || mechanism.inputs->empty()) return driven;
  const std::vector<int> depth = depths(graph);
  for (const Input& input : *mechanism.inputs) {
    const TurningJoint* joint = mechanism.find(input.joint);
    const int tail = graph.nodeOf(joint->tail);
    const int head = graph.nodeOf(joint->head);
    const bool tailMoves = depth[static_cast<std::size_t>(tail)] > depth[static_cast<std::size_t>(head)];
    driven.emplace(tailMoves ? tail : head, input.joint);
  }
  return driven;
}

/// Does an arrow run through the hatching, looked at in small pieces, because a tilted one fills no box?
bool isCrossed(const NodePlace& ground, const ObstacleGrid& arrows) {
  constexpr double kPiece = 4;
  const CanvasPoint out = *ground.groundSide;
  for (double across = -ground.groundHalfWidth; across <= ground.groundHalfWidth; across += kPiece) {
    const CanvasPoint at = ground.center + (kGroundDistance + kHatchDepth / 2) * out + across * turned(out);
    if (arrows.touches({at, kPiece, kPiece}, 1, ground.label)) return true;
  }
  return false;
}

/// Hangs the hatching where no arrow leaves: below if possible, or on another side; where arrows leave on all
/// of them, a shorter one between two arrows.
void placeHatching(NodePlace& ground, const ObstacleGrid& arrows) {
  constexpr std::array<CanvasPoint, 4> kSides{{{0, 1}, {-1, 0}, {1, 0}, {0, -1}}};
  for (const CanvasPoint side : kSides) {
    ground.groundSide = side;
    if (!arrows.touches(hatchingExtent(ground), 2, ground.label)) return;
  }
  constexpr int kTurns = 24;
  for (const double half : {kGroundHalfWidth, 0.7 * kGroundHalfWidth, 0.45 * kGroundHalfWidth}) {
    for (int k = 0; k < kTurns; ++k) {
      const int aside = k % 2 == 0 ? k / 2 : -(k + 1) / 2;  // from below to both sides
      const double angle = std::numbers::pi / 2 + 2 * std::numbers::pi * aside / kTurns;
      ground.groundHalfWidth = half;
      ground.groundSide = CanvasPoint{std::cos(angle), std::sin(angle)};
      if (!isCrossed(ground, arrows)) return;
    }
  }
  ground.groundHalfWidth = kGroundHalfWidth;
  ground.groundSide = kSides.front();
}

}  // namespace

Centers centersOf(const Digraph& graph, const NodePositions& positions) {
  Centers centers(static_cast<std::size_t>(graph.nodeCount()));
  for (int v = 0; v < graph.nodeCount(); ++v) {
    const auto found = positions.find(graph.nodeId(v));
    if (found != positions.end()) centers[static_cast<std::size_t>(v)] = onSheet(found->second);
  }
  return centers;
}

Extent areaOf(const Centers& centers) {
  std::optional<Extent> area;
  for (const auto& center : centers) {
    if (!center) continue;
    const Extent point{*center, 0, 0};
    area = area ? area->united(point) : point;
  }
  return area.value_or(Extent{}).grown(kMargin);
}

ObstacleGrid gridWithNodes(const Centers& centers) {
  ObstacleGrid grid(areaOf(centers));
  for (std::size_t v = 0; v < centers.size(); ++v) {
    if (centers[v]) grid.addCircle(*centers[v], kRim, static_cast<int>(v));
  }
  return grid;
}

Extent hatchingExtent(const NodePlace& ground) {
  const CanvasPoint out = *ground.groundSide;
  const CanvasPoint middle = ground.center + (kGroundDistance + kHatchDepth / 2) * out;
  const double across = ground.groundHalfWidth;
  const auto half = [&](double outward, double aside) {
    return std::abs(outward) * kHatchDepth + std::abs(aside) * across;
  };
  return {middle, half(out.x, out.y), half(out.y, out.x)};
}

void placeNames(std::vector<NodePlace>& nodes, const Mechanism& mechanism, ObstacleGrid& taken) {
  for (NodePlace& node : nodes) {
    const std::string& name = mechanism.links[node.label].name;
    if (name.empty() || name == std::to_string(node.label)) continue;
    const std::string shown = elided(name, kNameCharacters);
    const double halfWidth = textWidth(shown, kNameSize, false) / 2;
    const double halfHeight = kNameSize * 0.55;
    const std::optional<CanvasPoint> place = placeAround(node.center, halfWidth, halfHeight, taken);
    if (!place) continue;
    node.name = shown;
    node.nameCenter = *place;
    taken.addBox({*place, halfWidth, halfHeight});
  }
}

std::vector<NodePlace> placedNodes(const Mechanism& mechanism, const Digraph& graph, const Centers& centers,
                                   ObstacleGrid& taken) {
  const std::map<int, JointId> driven = drivenLinks(mechanism, graph);
  std::vector<NodePlace> nodes;
  for (int v = 0; v < graph.nodeCount(); ++v) {
    const auto& center = centers[static_cast<std::size_t>(v)];
    if (!center) continue;
    NodePlace node;
    node.link = graph.nodeId(v);
    node.label = graph.nodeLabel(v);
    node.color = mechanism.colorNumber(v);
    node.center = *center;
    if (v == 0) {
      placeHatching(node, taken);
      taken.addBox(hatchingExtent(node));
    }
    nodes.push_back(std::move(node));
  }
  for (NodePlace& node : nodes) {
    const auto input = driven.find(node.label);
    if (input == driven.end()) continue;
    node.input = input->second;
    const LabelPlace badge = placeAtCorner(node.center, node.label, taken);
    node.badgeCenter = badge.center;
    node.badgeCrowded = badge.crowded;
    taken.addBox(badgeExtent(node.badgeCenter));
  }
  return nodes;
}

}  // namespace geargraph

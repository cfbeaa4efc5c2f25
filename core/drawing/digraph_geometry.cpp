#include "core/drawing/digraph_geometry.h"

#include <array>
#include <unordered_map>

#include "core/drawing/edge_routing.h"
#include "core/drawing/label_placement.h"
#include "core/drawing/text_metrics.h"
#include "core/graph/digraph.h"

namespace geargraph {
namespace {

constexpr double kMargin = 80;
constexpr std::size_t kNameCharacters = 18;
constexpr double kRim = kNodeRadius + kRingWidth / 2;

Extent areaOf(const Centers& centers) {
  std::optional<Extent> area;
  for (const auto& center : centers) {
    if (!center) continue;
    const Extent point{*center, 0, 0};
    area = area ? area->united(point) : point;
  }
  return area.value_or(Extent{}).grown(kMargin);
}

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

/// The side of the ground where no arrow leaves: below if possible.
SheetPoint freeSide(SheetPoint ground, const ObstacleGrid& arrows) {
  constexpr std::array<SheetPoint, 4> kSides{{{0, 1}, {-1, 0}, {1, 0}, {0, -1}}};
  for (const SheetPoint side : kSides) {
    const bool upright = side.x == 0;
    const double across = upright ? kGroundHalfWidth : kHatchDepth;
    const double along = upright ? kHatchDepth : kGroundHalfWidth;
    const Extent box{ground + (kGroundDistance + kHatchDepth / 2) * side, across, along};
    if (!arrows.touches(box, 2, 0)) return side;
  }
  return kSides.front();
}

Extent hatchingExtent(const NodePlace& ground) {
  const SheetPoint side = *ground.groundSide;
  const bool upright = side.x == 0;
  const SheetPoint middle = ground.center + (kGroundDistance + kHatchDepth / 2) * side;
  return {middle, upright ? kGroundHalfWidth : kHatchDepth, upright ? kHatchDepth : kGroundHalfWidth};
}

void placeNames(DigraphGeometry& geometry, const Mechanism& mechanism, ObstacleGrid& taken) {
  for (NodePlace& node : geometry.nodes) {
    const std::string& name = mechanism.links[static_cast<std::size_t>(node.label)].name;
    if (name.empty() || name == std::to_string(node.label)) continue;
    const std::string shown = elided(name, kNameCharacters);
    const double halfWidth = textWidth(shown, kNameSize, false) / 2;
    const double halfHeight = kNameSize * 0.55;
    const std::optional<SheetPoint> place = placeAround(node.center, halfWidth, halfHeight, taken);
    if (!place) continue;
    node.name = shown;
    node.nameCenter = *place;
    taken.addBox({*place, halfWidth, halfHeight});
  }
}

Extent labelExtent(const EdgePlace& edge) {
  return edgeLabelExtent(edge.labelCenter, edge.label);
}

/// Names apart, which are placed last and keep out of everything's way.
bool standsAlike(const NodePlace& a, const NodePlace& b) {
  return a.center == b.center && a.groundSide == b.groundSide && a.input.has_value() == b.input.has_value() &&
         (!a.input || a.badgeCenter == b.badgeCenter);
}

/// Everything that stands elsewhere than before, at its old and its new place.
class Changes {
 public:
  Changes(const Extent& area, const DigraphGeometry& former, const DigraphGeometry& now) : m_grid(area) {
    for (std::size_t i = 0; i < now.nodes.size(); ++i) {
      if (standsAlike(former.nodes[i], now.nodes[i])) continue;
      add(former.nodes[i]);
      add(now.nodes[i]);
    }
    for (std::size_t i = 0; i < now.edges.size(); ++i) {
      if (former.edges[i].curve == now.edges[i].curve) continue;
      m_grid.addCurve(former.edges[i].curve);
      m_grid.addCurve(now.edges[i].curve);
    }
  }

  void labelMoved(const EdgePlace& from, const EdgePlace& to) {
    m_grid.addBox(labelExtent(from));
    m_grid.addBox(labelExtent(to));
  }
  [[nodiscard]] const ObstacleGrid& grid() const { return m_grid; }

 private:
  void add(const NodePlace& node) {
    m_grid.addCircle(node.center, kRim, node.label);
    if (node.groundSide) m_grid.addBox(hatchingExtent(node));
    if (node.input) m_grid.addBox(badgeExtent(node.badgeCenter));
  }

  ObstacleGrid m_grid;
};

void placeLabels(DigraphGeometry& geometry, ObstacleGrid& taken) {
  for (EdgePlace& edge : geometry.edges) {
    const Extent size = labelExtent(edge);
    const LabelPlace place = placeBeside(edge.curve, size.halfWidth, size.halfHeight, taken);
    edge.labelCenter = place.center;
    edge.labelCrowded = place.crowded;
    taken.addBox(labelExtent(edge));
  }
}

/// The same labels as placeLabels(), taken over from `former` where nothing near them has changed.
void placeLabelsAgain(DigraphGeometry& geometry, ObstacleGrid& taken, const DigraphGeometry& former,
                      Changes changes) {
  for (std::size_t i = 0; i < geometry.edges.size(); ++i) {
    EdgePlace& edge = geometry.edges[i];
    const EdgePlace& before = former.edges[i];
    const Extent size = labelExtent(edge);
    LabelPlace place{before.labelCenter, before.labelCrowded};
    const bool stays = edge.label == before.label && edge.curve == before.curve &&
                       isStillBeside(edge.curve, size.halfWidth, size.halfHeight, place, changes.grid());
    if (!stays) place = placeBeside(edge.curve, size.halfWidth, size.halfHeight, taken);
    edge.labelCenter = place.center;
    edge.labelCrowded = place.crowded;
    if (!(edge.labelCenter == before.labelCenter) || edge.label != before.label)
      changes.labelMoved(before, edge);
    taken.addBox(labelExtent(edge));
  }
}

void placeNodes(DigraphGeometry& geometry, const Digraph& graph, const Centers& centers,
                const std::map<int, JointId>& driven, ObstacleGrid& taken) {
  for (int v = 0; v < graph.nodeCount(); ++v) {
    const auto& center = centers[static_cast<std::size_t>(v)];
    if (!center) continue;
    NodePlace node;
    node.link = graph.nodeId(v);
    node.label = graph.nodeLabel(v);
    node.center = *center;
    if (v == 0) {
      node.groundSide = freeSide(*center, taken);
      taken.addBox(hatchingExtent(node));
    }
    geometry.nodes.push_back(std::move(node));
  }
  for (NodePlace& node : geometry.nodes) {
    const auto input = driven.find(node.label);
    if (input == driven.end()) continue;
    node.input = input->second;
    node.badgeCenter = placeAtCorner(node.center, node.label, taken);
    taken.addBox(badgeExtent(node.badgeCenter));
  }
}

/// Is it the same digraph, seen by ordinals, all of it with places?
bool isSameDigraph(const DigraphGeometry& former, const Digraph& graph) {
  if (former.nodes.size() != static_cast<std::size_t>(graph.nodeCount()) ||
      former.edges.size() != static_cast<std::size_t>(graph.edgeCount())) {
    return false;
  }
  for (int e = 0; e < graph.edgeCount(); ++e) {
    const EdgePlace& place = former.edges[static_cast<std::size_t>(e)];
    if (place.tail != graph.edge(e).tail || place.head != graph.edge(e).head) return false;
  }
  return true;
}

/// The places that links have left, or taken, since `former`.
std::vector<SheetPoint> movedPlaces(const DigraphGeometry& former, const Digraph& graph,
                                    const Centers& centers) {
  std::unordered_map<LinkId, SheetPoint> now;
  for (int v = 0; v < graph.nodeCount(); ++v) {
    const auto& center = centers[static_cast<std::size_t>(v)];
    if (center) now.emplace(graph.nodeId(v), *center);
  }
  std::vector<SheetPoint> places;
  for (const NodePlace& node : former.nodes) {
    const auto found = now.find(node.link);
    if (found != now.end() && found->second == node.center) {
      now.erase(found);
    } else {
      places.push_back(node.center);
    }
  }
  for (const auto& [link, place] : now) places.push_back(place);
  return places;
}

/// The courses of the arrows, starting from those that `former` has for the same arrows.
Courses coursesFrom(const DigraphGeometry& former, const Digraph& graph, const Centers& centers,
                    const ObstacleGrid& nodes) {
  std::unordered_map<int, LinkId> formerLinks;
  for (const NodePlace& node : former.nodes) formerLinks.emplace(node.label, node.link);
  std::unordered_map<ElementId, const EdgePlace*> formerEdges;
  for (const EdgePlace& edge : former.edges) formerEdges.emplace(edge.element, &edge);
  Courses courses(static_cast<std::size_t>(graph.edgeCount()));
  for (int e = 0; e < graph.edgeCount(); ++e) {
    const auto found = formerEdges.find(graph.edgeId(e));
    if (found == formerEdges.end()) continue;
    const EdgePlace& edge = *found->second;
    const bool sameEnds = formerLinks.at(edge.tail) == graph.nodeId(graph.edge(e).tail) &&
                          formerLinks.at(edge.head) == graph.nodeId(graph.edge(e).head);
    if (sameEnds) courses[static_cast<std::size_t>(e)] = Course{edge.curve, edge.detoursLooked, edge.height};
  }
  return reroutedEdges(graph, centers, nodes, movedPlaces(former, graph, centers), courses);
}

}  // namespace

SheetPoint onSheet(SheetPoint place) {
  return {std::clamp(place.x, -kSheetEnd, kSheetEnd), std::clamp(place.y, -kSheetEnd, kSheetEnd)};
}

const NodePlace* DigraphGeometry::node(LinkId link) const {
  const auto found =
      std::find_if(nodes.begin(), nodes.end(), [link](const NodePlace& node) { return node.link == link; });
  return found == nodes.end() ? nullptr : &*found;
}

const EdgePlace* DigraphGeometry::edge(const ElementId& element) const {
  const auto found = std::find_if(edges.begin(), edges.end(),
                                  [&](const EdgePlace& edge) { return edge.element == element; });
  return found == edges.end() ? nullptr : &*found;
}

Extent badgeExtent(SheetPoint center) {
  return {center, kBadgeHalfWidth, kBadgeHalfHeight};
}

Extent edgeLabelExtent(SheetPoint center, int label) {
  return {center, textWidth(std::to_string(label), kLabelSize, true) / 2, kLabelSize * 0.45};
}

DigraphGeometry digraphGeometry(const Mechanism& mechanism, const NodePositions& positions) {
  return digraphGeometry(mechanism, positions, {});
}

DigraphGeometry digraphGeometry(const Mechanism& mechanism, const NodePositions& positions,
                                const DigraphGeometry& former) {
  const Digraph graph(mechanism);
  Centers centers(static_cast<std::size_t>(graph.nodeCount()));
  for (int v = 0; v < graph.nodeCount(); ++v) {
    const auto found = positions.find(graph.nodeId(v));
    if (found != positions.end()) centers[static_cast<std::size_t>(v)] = onSheet(found->second);
  }

  ObstacleGrid taken(areaOf(centers));
  for (int v = 0; v < graph.nodeCount(); ++v) {
    const auto& center = centers[static_cast<std::size_t>(v)];
    if (center) taken.addCircle(*center, kRim, v);
  }
  const bool again = isSameDigraph(former, graph);
  const Courses courses = coursesFrom(former, graph, centers, taken);
  for (const auto& course : courses) {
    if (course) taken.addCurve(course->curve);
  }

  DigraphGeometry geometry;
  placeNodes(geometry, graph, centers, drivenLinks(mechanism, graph), taken);
  for (int e = 0; e < graph.edgeCount(); ++e) {
    const auto& course = courses[static_cast<std::size_t>(e)];
    if (!course) continue;
    const DigraphEdge& edge = graph.edge(e);
    EdgePlace place;
    place.element = graph.edgeId(e);
    place.label = graph.edgeLabel(e);
    place.tail = edge.tail;
    place.head = edge.head;
    place.curve = course->curve;
    place.detoursLooked = course->looked;
    place.height = course->height;
    geometry.edges.push_back(place);
  }
  const bool comparable = again && geometry.nodes.size() == former.nodes.size();
  if (comparable) {
    placeLabelsAgain(geometry, taken, former, Changes(areaOf(centers), former, geometry));
  } else {
    placeLabels(geometry, taken);
  }
  placeNames(geometry, mechanism, taken);
  return geometry;
}

}  // namespace geargraph

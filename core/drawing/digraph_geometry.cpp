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

/// What a drawing has, by element.
class Former {
 public:
  explicit Former(const DigraphGeometry& geometry) : m_geometry(geometry) {
    m_nodes.reserve(geometry.nodes.size());
    m_edges.reserve(geometry.edges.size());
    for (const NodePlace& node : geometry.nodes) m_nodes.emplace(node.link, &node);
    for (const EdgePlace& edge : geometry.edges) m_edges.emplace(edge.element, &edge);
  }
  [[nodiscard]] const DigraphGeometry& geometry() const { return m_geometry; }
  [[nodiscard]] const NodePlace* node(LinkId link) const {
    const auto found = m_nodes.find(link);
    return found == m_nodes.end() ? nullptr : found->second;
  }
  [[nodiscard]] const EdgePlace* edge(const ElementId& element) const {
    const auto found = m_edges.find(element);
    return found == m_edges.end() ? nullptr : found->second;
  }
  /// Do the arrows that both have stand in the same order?
  [[nodiscard]] bool isInOrderOf(const DigraphGeometry& now) const {
    const EdgePlace* last = nullptr;
    for (const EdgePlace& edge : now.edges) {
      const EdgePlace* const here = this->edge(edge.element);
      if (here == nullptr) continue;
      if (last != nullptr && here < last) return false;
      last = here;
    }
    return true;
  }

 private:
  const DigraphGeometry& m_geometry;
  std::unordered_map<LinkId, const NodePlace*> m_nodes;
  std::unordered_map<ElementId, const EdgePlace*> m_edges;
};

/// Everything that stands elsewhere than before, came or went, at its old and its new place.
class Changes {
 public:
  Changes(const Extent& area, const Former& former, const DigraphGeometry& now) : m_grid(area) {
    const Former current(now);
    for (const NodePlace& node : former.geometry().nodes) {
      const NodePlace* const is = current.node(node.link);
      if (is == nullptr || !standsAlike(node, *is)) add(node);
    }
    for (const NodePlace& node : now.nodes) {
      const NodePlace* const was = former.node(node.link);
      if (was == nullptr || !standsAlike(*was, node)) add(node);
    }
    for (const EdgePlace& edge : former.geometry().edges) {
      const EdgePlace* const is = current.edge(edge.element);
      if (is == nullptr || !(is->curve == edge.curve)) m_grid.addCurve(edge.curve);
      if (is == nullptr) addLabel(edge);
    }
    for (const EdgePlace& edge : now.edges) {
      const EdgePlace* const was = former.edge(edge.element);
      if (was == nullptr || !(was->curve == edge.curve)) m_grid.addCurve(edge.curve);
    }
  }

  void addLabel(const EdgePlace& edge) { m_grid.addBox(labelExtent(edge)); }
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
void placeLabelsAgain(DigraphGeometry& geometry, ObstacleGrid& taken, const Former& former, Changes changes) {
  for (EdgePlace& edge : geometry.edges) {
    const Extent size = labelExtent(edge);
    const auto placed = [&] { return placeBeside(edge.curve, size.halfWidth, size.halfHeight, taken); };
    const EdgePlace* const before = former.edge(edge.element);
    LabelPlace place;
    if (before == nullptr) {
      place = placed();
    } else {
      place = {before->labelCenter, before->labelCrowded};
      const bool sameSize = labelExtent(*before).halfWidth == size.halfWidth;
      const bool stays = sameSize && edge.curve == before->curve &&
                         isStillBeside(edge.curve, size.halfWidth, size.halfHeight, place, changes.grid());
      if (!stays) place = placed();
      if (!sameSize || !(place.center == before->labelCenter)) changes.addLabel(*before);
    }
    edge.labelCenter = place.center;
    edge.labelCrowded = place.crowded;
    if (before == nullptr || !(labelExtent(edge).halfWidth == labelExtent(*before).halfWidth) ||
        !(place.center == before->labelCenter)) {
      changes.addLabel(edge);
    }
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

/// The places that links have left, or taken, since `former`.
std::vector<SheetPoint> movedPlaces(const Former& former, const Digraph& graph, const Centers& centers) {
  std::vector<SheetPoint> places;
  std::size_t kept = 0;
  std::vector<char> stays(former.geometry().nodes.size(), 0);
  for (int v = 0; v < graph.nodeCount(); ++v) {
    const auto& center = centers[static_cast<std::size_t>(v)];
    if (!center) continue;
    const NodePlace* const was = former.node(graph.nodeId(v));
    if (was == nullptr || !(was->center == *center)) {
      places.push_back(*center);
    } else {
      stays[static_cast<std::size_t>(was - former.geometry().nodes.data())] = 1;
      ++kept;
    }
  }
  for (std::size_t i = 0; kept < stays.size() && i < stays.size(); ++i) {
    if (stays[i] == 0) places.push_back(former.geometry().nodes[i].center);
  }
  return places;
}

/// The courses of the arrows, starting from those that `former` has for the same arrows.
Courses coursesFrom(const Former& former, const Digraph& graph, const Centers& centers,
                    const ObstacleGrid& nodes) {
  std::unordered_map<int, LinkId> links;  // of the former drawing, by label
  for (const NodePlace& node : former.geometry().nodes) links.emplace(node.label, node.link);
  Courses courses(static_cast<std::size_t>(graph.edgeCount()));
  for (int e = 0; e < graph.edgeCount(); ++e) {
    const EdgePlace* const edge = former.edge(graph.edgeId(e));
    if (edge == nullptr) continue;
    const bool sameEnds = links.at(edge->tail) == graph.nodeId(graph.edge(e).tail) &&
                          links.at(edge->head) == graph.nodeId(graph.edge(e).head);
    if (sameEnds)
      courses[static_cast<std::size_t>(e)] = Course{edge->curve, edge->detoursLooked, edge->height};
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
  const Former known(former);
  const Courses courses = coursesFrom(known, graph, centers, taken);
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
  if (!former.edges.empty() && known.isInOrderOf(geometry)) {
    placeLabelsAgain(geometry, taken, known, Changes(areaOf(centers), known, geometry));
  } else {
    placeLabels(geometry, taken);
  }
  placeNames(geometry, mechanism, taken);
  return geometry;
}

}  // namespace geargraph

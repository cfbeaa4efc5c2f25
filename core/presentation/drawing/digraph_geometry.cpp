#include "core/presentation/drawing/digraph_geometry.h"

#include <array>
#include <unordered_map>

#include "core/mechanism/graph/digraph.h"
#include "core/presentation/drawing/coupling_marks.h"
#include "core/presentation/drawing/edge_routing.h"
#include "core/presentation/drawing/label_placement.h"
#include "core/presentation/drawing/node_placement.h"
#include "core/presentation/drawing/note_marks.h"
#include "core/presentation/drawing/text_metrics.h"

namespace geargraph {
namespace {

constexpr double kRim = kNodeRadius + kRingWidth / 2;

Extent labelExtent(const EdgePlace& edge) {
  return edgeLabelExtent(edge.labelCenter, edge.label);
}

/// Names apart, which are placed last and keep out of everything's way.
bool standsAlike(const NodePlace& a, const NodePlace& b) {
  return a.center == b.center && a.groundSide == b.groundSide && a.groundHalfWidth == b.groundHalfWidth &&
         a.input.has_value() == b.input.has_value() && (!a.input || a.badgeCenter == b.badgeCenter);
}

/// What a drawing has, by element.
class GeometryIndex {
 public:
  explicit GeometryIndex(const DigraphGeometry& geometry) : m_geometry(geometry) {
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
  Changes(const Extent& area, const GeometryIndex& former, const DigraphGeometry& now) : m_grid(area) {
    const GeometryIndex current(now);
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
    if (former.geometry().couplings == now.couplings) return;
    for (const auto* couplings : {&former.geometry().couplings, &now.couplings}) {
      for (const ShiftElementPlace& place : *couplings) {
        m_grid.addCurve(place.line);
        m_grid.addBox(couplingExtent(place));
      }
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
void placeLabelsAgain(DigraphGeometry& geometry, ObstacleGrid& taken, const GeometryIndex& former,
                      Changes changes) {
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

/// The places that links have left, or taken, since `former`.
std::vector<CanvasPoint> movedPlaces(const GeometryIndex& former, const Digraph& graph,
                                     const Centers& centers) {
  std::vector<CanvasPoint> places;
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
Courses coursesFrom(const GeometryIndex& former, const Digraph& graph, const Centers& centers,
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

CanvasPoint onSheet(CanvasPoint place) {
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

Extent badgeExtent(CanvasPoint center) {
  return {center, kBadgeHalfWidth, kBadgeHalfHeight};
}

Extent edgeLabelExtent(CanvasPoint center, int label) {
  return {center, textWidth(std::to_string(label), kLabelSize, true) / 2, kLabelSize * 0.45};
}

DigraphGeometry digraphGeometry(const Mechanism& mechanism, const NodePositions& positions) {
  return digraphGeometry(mechanism, positions, {});
}

DigraphGeometry digraphGeometry(const Mechanism& mechanism, const NodePositions& positions,
                                const DigraphGeometry& former) {
  const Digraph graph(mechanism);
  const Centers centers = centersOf(graph, positions);
  ObstacleGrid taken = gridWithNodes(centers);
  const GeometryIndex known(former);
  const Courses courses = coursesFrom(known, graph, centers, taken);
  for (const auto& course : courses) {
    if (course) taken.addCurve(course->curve);
  }

  DigraphGeometry geometry;
  geometry.nodes = placedNodes(mechanism, graph, centers, taken);
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
  geometry.couplings = placedCouplings(mechanism, graph, centers, geometry.nodes, taken);
  if (!former.edges.empty() && known.isInOrderOf(geometry)) {
    placeLabelsAgain(geometry, taken, known, Changes(areaOf(centers), known, geometry));
  } else {
    placeLabels(geometry, taken);
  }
  placeNames(geometry.nodes, mechanism, taken);
  geometry.notes = placedNotes(mechanism.view.notes);
  return geometry;
}

}  // namespace geargraph

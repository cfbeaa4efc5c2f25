#include "ui/canvas/digraph_scene.h"

#include <QTimer>
#include <algorithm>
#include <utility>

#include "core/drawing/coupling_marks.h"

namespace geargraph {
namespace {

/// How many outlines an element has: an arrow's line and label, a node's disc and badge, a coupling's line
/// and plates.
int outlinesOf(const EdgePlace&) {
  return 2;
}
int outlinesOf(const NodePlace& node) {
  return node.input ? 2 : 1;
}
int outlinesOf(const CouplingPlace&) {
  return 2;
}

/// Do both show the same elements in the same order?
bool hasSameOutlines(const DigraphGeometry& a, const DigraphGeometry& b) {
  const auto sameEdge = [](const EdgePlace& x, const EdgePlace& y) { return x.element == y.element; };
  const auto sameNode = [](const NodePlace& x, const NodePlace& y) {
    return x.link == y.link && x.input == y.input;
  };
  return std::equal(a.edges.begin(), a.edges.end(), b.edges.begin(), b.edges.end(), sameEdge) &&
         std::equal(a.nodes.begin(), a.nodes.end(), b.nodes.begin(), b.nodes.end(), sameNode) &&
         std::equal(a.couplings.begin(), a.couplings.end(), b.couplings.begin(), b.couplings.end(),
                    [](const CouplingPlace& x, const CouplingPlace& y) { return x.coupling == y.coupling; });
}

/// Of everything that is put up.
std::size_t sizeOf(const DigraphGeometry& geometry) {
  return geometry.edges.size() + geometry.nodes.size() + geometry.couplings.size();
}

}  // namespace

void DigraphScene::show(const Mechanism& mechanism, NodePositions positions) {
  auto geometry = std::make_shared<const DigraphGeometry>(digraphGeometry(mechanism, positions, *m_geometry));
  show(std::move(positions), std::move(geometry));
}

void DigraphScene::show(NodePositions positions, DigraphGeometryPtr geometry) {
  m_positions = std::move(positions);
  const DigraphGeometryPtr former = std::exchange(m_geometry, std::move(geometry));
  if (isDrawn() && hasSameOutlines(*former, *m_geometry)) {
    drawWhatDiffers(*former);
    growSheet();
  } else {
    drawAll();
  }
}

void DigraphScene::drawAll() {
  constexpr std::size_t kLarge = 4'000;  // elements, which take some 50 ms
  const std::size_t size = sizeOf(*m_geometry);
  const bool isUnderWay = !isDrawn();
  editableOutlines().clear();
  beginDrawing();
  m_putUp = 0;
  if (size <= kLarge) {
    putUp(size);
  } else if (!isUnderWay) {
    QTimer::singleShot(0, this, &DigraphScene::putUpSlice);
  }  // else the next slice comes by itself
}

void DigraphScene::putUp(std::size_t end) {
  std::vector<Outline>& all = editableOutlines();
  const std::size_t edges = m_geometry->edges.size();
  const std::size_t nodes = m_geometry->nodes.size();
  for (; *m_putUp < end; ++*m_putUp) {
    const std::size_t at = *m_putUp;
    const std::vector<Outline> outlines = at < edges ? draw(m_geometry->edges[at])
                                          : at < edges + nodes
                                              ? draw(m_geometry->nodes[at - edges])
                                              : draw(m_geometry->couplings[at - edges - nodes]);
    all.insert(all.end(), outlines.begin(), outlines.end());
  }
  if (end < sizeOf(*m_geometry)) return;
  m_putUp.reset();
  endDrawing();
}

void DigraphScene::putUpSlice() {
  constexpr std::size_t kSlice = 1'000;  // elements
  if (isDrawn()) return;                 // a small drawing came in between
  const std::size_t size = sizeOf(*m_geometry);
  putUp(std::min(*m_putUp + kSlice, size));
  if (isDrawn()) {
    emit drawn();
  } else {
    QTimer::singleShot(0, this, &DigraphScene::putUpSlice);
  }
}

void DigraphScene::drawWhatDiffers(const DigraphGeometry& former) {
  auto slot = editableOutlines().begin();
  const auto update = [&](const auto& before, const auto& now) {
    if (before == now) {
      slot += outlinesOf(now);
      return;
    }
    for (const Outline& outline : draw(now)) *slot++ = outline;
  };
  for (std::size_t i = 0; i < former.edges.size(); ++i) update(former.edges[i], m_geometry->edges[i]);
  for (std::size_t i = 0; i < former.nodes.size(); ++i) update(former.nodes[i], m_geometry->nodes[i]);
  for (std::size_t i = 0; i < former.couplings.size(); ++i)
    update(former.couplings[i], m_geometry->couplings[i]);
}

std::vector<Outline> DigraphScene::draw(const NodePlace& node) {
  DisplayList drawing = nodeDrawing(node, emphasisOf(emphases(), node.link));
  std::vector<Outline> outlines = std::move(drawing.outlines);
  redraw(node.link, std::move(drawing), kNodeDepth);
  return outlines;
}

std::vector<Outline> DigraphScene::draw(const EdgePlace& edge) {
  DisplayList drawing = edgeDrawing(edge, emphasisOf(emphases(), edge.element));
  std::vector<Outline> outlines = std::move(drawing.outlines);
  redraw(edge.element, std::move(drawing), kLineDepth);
  return outlines;
}

std::vector<Outline> DigraphScene::draw(const CouplingPlace& place) {
  DisplayList drawing = couplingDrawing(place, emphasisOf(emphases(), place.coupling));
  std::vector<Outline> outlines = std::move(drawing.outlines);
  redraw(place.coupling, std::move(drawing), kLineDepth);
  return outlines;
}

void DigraphScene::redraw(const ElementId& element, DisplayList drawing, int depth) {
  const auto behind = std::stable_partition(drawing.marks.begin(), drawing.marks.end(),
                                            [](const Mark& mark) { return mark.role != MarkRole::halo; });
  std::vector<Mark> halo(std::make_move_iterator(behind), std::make_move_iterator(drawing.marks.end()));
  drawing.marks.erase(behind, drawing.marks.end());
  setPart(element, depth, std::move(drawing.marks));
  setPart(element, kHaloDepth, std::move(halo));
}

void DigraphScene::drawAgain(const std::unordered_set<ElementId>& changed) {
  for (const NodePlace& node : m_geometry->nodes) {
    if (changed.contains(node.link)) draw(node);
  }
  for (const EdgePlace& edge : m_geometry->edges) {
    if (changed.contains(edge.element)) draw(edge);
  }
  for (const CouplingPlace& place : m_geometry->couplings) {
    if (changed.contains(place.coupling)) draw(place);
  }
}

DisplayList DigraphScene::displayList(const Emphases& emphases) const {
  return digraphDrawing(*m_geometry, emphases);
}

}  // namespace geargraph

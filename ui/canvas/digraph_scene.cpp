#include "ui/canvas/digraph_scene.h"

#include <utility>

namespace geargraph {
namespace {

/// How many outlines an element has: an arrow's line and label, a node's disc and badge.
int outlinesOf(const EdgePlace&) {
  return 2;
}
int outlinesOf(const NodePlace& node) {
  return node.input ? 2 : 1;
}

/// Do both show the same elements in the same order?
bool hasSameOutlines(const DigraphGeometry& a, const DigraphGeometry& b) {
  const auto sameEdge = [](const EdgePlace& x, const EdgePlace& y) { return x.element == y.element; };
  const auto sameNode = [](const NodePlace& x, const NodePlace& y) {
    return x.link == y.link && x.input == y.input;
  };
  return std::equal(a.edges.begin(), a.edges.end(), b.edges.begin(), b.edges.end(), sameEdge) &&
         std::equal(a.nodes.begin(), a.nodes.end(), b.nodes.begin(), b.nodes.end(), sameNode);
}

}  // namespace

void DigraphScene::show(const Mechanism& mechanism, NodePositions positions) {
  m_positions = std::move(positions);
  DigraphGeometry geometry = digraphGeometry(mechanism, m_positions, m_geometry);
  const DigraphGeometry former = std::exchange(m_geometry, std::move(geometry));
  if (hasSameOutlines(former, m_geometry)) {
    drawWhatDiffers(former);
    growSheet();
  } else {
    drawAll();
  }
}

void DigraphScene::drawAll() {
  std::vector<Outline>& all = editableOutlines();
  all.clear();
  beginDrawing();
  for (const EdgePlace& edge : m_geometry.edges) {
    const std::vector<Outline> outlines = draw(edge);
    all.insert(all.end(), outlines.begin(), outlines.end());
  }
  for (const NodePlace& node : m_geometry.nodes) {
    const std::vector<Outline> outlines = draw(node);
    all.insert(all.end(), outlines.begin(), outlines.end());
  }
  endDrawing();
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
  for (std::size_t i = 0; i < former.edges.size(); ++i) update(former.edges[i], m_geometry.edges[i]);
  for (std::size_t i = 0; i < former.nodes.size(); ++i) update(former.nodes[i], m_geometry.nodes[i]);
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

void DigraphScene::redraw(const ElementId& element, DisplayList drawing, int depth) {
  const auto behind = std::stable_partition(drawing.marks.begin(), drawing.marks.end(),
                                            [](const Mark& mark) { return mark.role != MarkRole::halo; });
  std::vector<Mark> halo(std::make_move_iterator(behind), std::make_move_iterator(drawing.marks.end()));
  drawing.marks.erase(behind, drawing.marks.end());
  setPart(element, depth, std::move(drawing.marks));
  setPart(element, kHaloDepth, std::move(halo));
}

void DigraphScene::drawAgain(const std::unordered_set<ElementId>& changed) {
  for (const NodePlace& node : m_geometry.nodes) {
    if (changed.contains(node.link)) draw(node);
  }
  for (const EdgePlace& edge : m_geometry.edges) {
    if (changed.contains(edge.element)) draw(edge);
  }
}

DisplayList DigraphScene::displayList(const Emphases& emphases) const {
  return digraphDrawing(m_geometry, emphases);
}

}  // namespace geargraph

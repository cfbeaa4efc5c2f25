#include "ui/canvas/digraph_scene.h"

#include <unordered_set>
#include <utility>

#include "ui/canvas/mark_painter.h"

namespace geargraph {
namespace {

constexpr double kRoomAround = 20000;  ///< how far the sheet can be pulled beyond the drawing

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

DigraphScene::DigraphScene(QObject* parent) : QGraphicsScene(parent), m_overlay(new MarkItem(kGhostDepth)) {
  addItem(m_overlay);
  setSceneRect(-kRoomAround, -kRoomAround, 2 * kRoomAround, 2 * kRoomAround);
}

DigraphScene::~DigraphScene() = default;

Emphasis DigraphScene::emphasisOf(const ElementId& element) const {
  const auto found = m_emphases.find(element);
  return found == m_emphases.end() ? Emphasis{} : found->second;
}

void DigraphScene::show(const Mechanism& mechanism, NodePositions positions) {
  m_positions = std::move(positions);
  DigraphGeometry geometry = digraphGeometry(mechanism, m_positions, m_geometry);
  const DigraphGeometry former = std::exchange(m_geometry, std::move(geometry));
  if (hasSameOutlines(former, m_geometry)) {
    drawWhatDiffers(former);
  } else {
    drawAll();
  }
  const QRectF drawn = drawnRect();
  if (!sceneRect().contains(drawn.adjusted(-1000, -1000, 1000, 1000))) {
    setSceneRect(drawn.adjusted(-kRoomAround, -kRoomAround, kRoomAround, kRoomAround));
  }
}

void DigraphScene::drawAll() {
  m_outlines.clear();
  for (auto& [element, part] : m_parts) part.shown = false;
  for (const EdgePlace& edge : m_geometry.edges) {
    const std::vector<Outline> outlines = draw(edge);
    m_outlines.insert(m_outlines.end(), outlines.begin(), outlines.end());
  }
  for (const NodePlace& node : m_geometry.nodes) {
    const std::vector<Outline> outlines = draw(node);
    m_outlines.insert(m_outlines.end(), outlines.begin(), outlines.end());
  }
  std::erase_if(m_parts, [](const auto& entry) { return !entry.second.shown; });
}

void DigraphScene::drawWhatDiffers(const DigraphGeometry& former) {
  auto slot = m_outlines.begin();
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
  DisplayList drawing = nodeDrawing(node, emphasisOf(node.link));
  std::vector<Outline> outlines = std::move(drawing.outlines);
  redraw(node.link, std::move(drawing), kNodeDepth);
  return outlines;
}

std::vector<Outline> DigraphScene::draw(const EdgePlace& edge) {
  DisplayList drawing = edgeDrawing(edge, emphasisOf(edge.element));
  std::vector<Outline> outlines = std::move(drawing.outlines);
  redraw(edge.element, std::move(drawing), kLineDepth);
  return outlines;
}

void DigraphScene::redraw(const ElementId& element, DisplayList drawing, double depth) {
  Part& part = m_parts[element];
  part.shown = true;
  if (!part.item) {
    part.item = std::make_unique<MarkItem>(depth);
    part.item->setTheme(m_theme);
    addItem(part.item.get());
  }
  const auto behind = std::stable_partition(drawing.marks.begin(), drawing.marks.end(),
                                            [](const Mark& mark) { return mark.role != MarkRole::halo; });
  std::vector<Mark> halo(std::make_move_iterator(behind), std::make_move_iterator(drawing.marks.end()));
  drawing.marks.erase(behind, drawing.marks.end());
  part.item->setMarks(std::move(drawing.marks));
  if (halo.empty()) {
    part.halo.reset();
    return;
  }
  if (!part.halo) {
    part.halo = std::make_unique<MarkItem>(kHaloDepth);
    part.halo->setTheme(m_theme);
    addItem(part.halo.get());
  }
  part.halo->setMarks(std::move(halo));
}

void DigraphScene::setEmphases(Emphases emphases) {
  std::unordered_set<ElementId> changed;
  for (const auto& [element, emphasis] : m_emphases) {
    const auto found = emphases.find(element);
    if (found == emphases.end() || !(found->second == emphasis)) changed.insert(element);
  }
  for (const auto& [element, emphasis] : emphases) {
    if (!m_emphases.contains(element)) changed.insert(element);
  }
  m_emphases = std::move(emphases);
  if (changed.empty()) return;
  for (const NodePlace& node : m_geometry.nodes) {
    if (changed.contains(node.link)) draw(node);
  }
  for (const EdgePlace& edge : m_geometry.edges) {
    if (changed.contains(edge.element)) draw(edge);
  }
}

void DigraphScene::setTheme(Theme theme) {
  m_theme = theme;
  m_overlay->setTheme(theme);
  for (auto& [element, part] : m_parts) {
    part.item->setTheme(theme);
    if (part.halo) part.halo->setTheme(theme);
  }
  setBackgroundBrush(toQColor(colorOf(ColorRole::sheet, theme)));
}

DisplayList DigraphScene::displayList() const {
  return digraphDrawing(m_geometry, m_emphases);
}

QRectF DigraphScene::drawnRect() const {
  QRectF rect;
  for (const auto& [element, part] : m_parts) rect |= part.item->boundingRect();
  return rect;
}

void DigraphScene::setOverlay(DisplayList overlay) {
  m_overlay->setMarks(std::move(overlay.marks));
}

}  // namespace geargraph

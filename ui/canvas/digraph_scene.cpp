#include "ui/canvas/digraph_scene.h"

#include <unordered_set>

#include "ui/canvas/mark_painter.h"

namespace geargraph {
namespace {

constexpr double kRoomAround = 20000;  ///< how far the sheet can be pulled beyond the drawing

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
  m_geometry = digraphGeometry(mechanism, m_positions);
  m_outlines.clear();
  for (auto& [element, part] : m_parts) part.shown = false;
  for (const EdgePlace& edge : m_geometry.edges) drawEdge(edge);
  for (const NodePlace& node : m_geometry.nodes) drawNode(node);
  std::erase_if(m_parts, [](const auto& entry) { return !entry.second.shown; });
  const QRectF wanted = drawnRect().adjusted(-kRoomAround, -kRoomAround, kRoomAround, kRoomAround);
  if (!sceneRect().contains(drawnRect().adjusted(-1000, -1000, 1000, 1000))) setSceneRect(wanted);
}

void DigraphScene::drawNode(const NodePlace& node) {
  DisplayList drawing = nodeDrawing(node, emphasisOf(node.link));
  m_outlines.insert(m_outlines.end(), drawing.outlines.begin(), drawing.outlines.end());
  redraw(node.link, std::move(drawing), kNodeDepth);
}

void DigraphScene::drawEdge(const EdgePlace& edge) {
  DisplayList drawing = edgeDrawing(edge, emphasisOf(edge.element));
  m_outlines.insert(m_outlines.end(), drawing.outlines.begin(), drawing.outlines.end());
  redraw(edge.element, std::move(drawing), kLineDepth);
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
    if (changed.contains(node.link)) redraw(node.link, nodeDrawing(node, emphasisOf(node.link)), kNodeDepth);
  }
  for (const EdgePlace& edge : m_geometry.edges) {
    if (changed.contains(edge.element)) {
      redraw(edge.element, edgeDrawing(edge, emphasisOf(edge.element)), kLineDepth);
    }
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

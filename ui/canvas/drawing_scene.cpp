#include "ui/canvas/drawing_scene.h"

#include <utility>

#include "ui/canvas/mark_painter.h"

namespace geargraph::inline canvas {
namespace {

constexpr double kRoomAround = 20000;  ///< how far the sheet can be pulled beyond the drawing

/// What stands out differently in one than in the other.
std::unordered_set<ElementId> difference(const Emphases& before, const Emphases& now) {
  std::unordered_set<ElementId> changed;
  for (const auto& [element, emphasis] : before) {
    if (!(emphasisOf(now, element) == emphasis)) changed.insert(element);
  }
  for (const auto& [element, emphasis] : now) {
    if (!before.contains(element)) changed.insert(element);
  }
  return changed;
}

}  // namespace

DrawingScene::DrawingScene(QObject* parent)
    : QGraphicsScene(parent), m_overlay(new MarkItem(kGhostDepth, m_theme)) {
  // Items are never looked up by place, and thousands of changes cost more in a tree than in a list.
  setItemIndexMethod(NoIndex);
  addItem(m_overlay);
  setSceneRect(-kRoomAround, -kRoomAround, 2 * kRoomAround, 2 * kRoomAround);
}

DrawingScene::~DrawingScene() = default;

void DrawingScene::show(Draw draw) {
  m_draw = std::move(draw);
  play(m_draw(m_emphases));
}

void DrawingScene::play(DisplayList drawing) {
  m_outlines = std::move(drawing.outlines);
  // An item for each element and depth, its marks in their order.
  std::unordered_map<PartKey, std::vector<Mark>, PartHash> parts;
  std::vector<PartKey> order;
  for (Mark& mark : drawing.marks) {
    const PartKey key{mark.element, mark.z};
    std::vector<Mark>& marks = parts[key];
    if (marks.empty()) order.push_back(key);
    marks.push_back(std::move(mark));
  }
  beginDrawing();
  for (const PartKey& key : order) setPart(key.first, key.second, std::move(parts[key]));
  endDrawing();
}

void DrawingScene::beginDrawing() {
  ++m_drawing;
}

void DrawingScene::setPart(const ElementId& element, int depth, std::vector<Mark> marks) {
  if (marks.empty()) {
    m_parts.erase({element, depth});
    return;
  }
  Part& part = m_parts[{element, depth}];
  part.drawing = m_drawing;
  if (!part.item) {
    part.item = std::make_unique<MarkItem>(depth, m_theme);
    addItem(part.item.get());
  }
  part.item->setMarks(std::move(marks));
}

void DrawingScene::endDrawing() {
  std::erase_if(m_parts, [this](const auto& entry) { return entry.second.drawing != m_drawing; });
  growSheet();
}

void DrawingScene::growSheet() {
  const QRectF drawn = drawnRect();
  if (sceneRect().contains(drawn.adjusted(-1000, -1000, 1000, 1000))) return;
  setSceneRect(drawn.adjusted(-kRoomAround, -kRoomAround, kRoomAround, kRoomAround));
}

void DrawingScene::setEmphases(Emphases emphases) {
  const std::unordered_set<ElementId> changed = difference(m_emphases, emphases);
  m_emphases = std::move(emphases);
  if (!changed.empty()) drawAgain(changed);
}

void DrawingScene::drawAgain(const std::unordered_set<ElementId>&) {
  if (m_draw) play(m_draw(m_emphases));
}

void DrawingScene::setTheme(Theme theme) {
  m_theme = theme;
  update();
  setBackgroundBrush(toQColor(colorOf(ColorRole::sheet, theme)));
}

DisplayList DrawingScene::displayList(const Emphases& emphases) const {
  return m_draw ? m_draw(emphases) : DisplayList{};
}

QRectF DrawingScene::drawnRect() const {
  QRectF rect;
  for (const auto& [key, part] : m_parts) {
    if (key.second != kHaloDepth) rect |= part.item->boundingRect();
  }
  return rect;
}

void DrawingScene::setOverlay(DisplayList overlay) {
  m_overlay->setMarks(std::move(overlay.marks));
}

}  // namespace geargraph::inline canvas

#include "ui/canvas/drawing_scene.h"

#include <QGraphicsView>
#include <algorithm>
#include <unordered_map>
#include <utility>

#include "ui/canvas/mark_painter.h"

namespace geargraph {
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

void dropCaptioned(const ElementId& element, const std::vector<Mark>& captions, std::vector<Mark>& marks) {
  if (element.kind != ElementKind::link) return;
  const bool has = std::any_of(captions.begin(), captions.end(),
                               [&](const Mark& caption) { return caption.element == element; });
  if (has) std::erase_if(marks, [](const Mark& mark) { return mark.role == MarkRole::name; });
}

}  // namespace

DrawingScene::DrawingScene(QObject* parent)
    : QGraphicsScene(parent),
      m_item(new PartsItem(m_theme)),
      m_overlay(new MarkItem(kPreviewDepth, m_theme)),
      m_underlay(new MarkItem(-1, m_theme)),
      m_captions(new MarkItem(kLabelDepth, m_theme)) {
  setItemIndexMethod(NoIndex);  // items are never looked up by place
  addItem(m_item);
  addItem(m_overlay);
  addItem(m_underlay);
  addItem(m_captions);
  setSheet({-kRoomAround, -kRoomAround, 2 * kRoomAround, 2 * kRoomAround});
}

DrawingScene::~DrawingScene() = default;

void DrawingScene::show(Draw draw) {
  m_draw = std::move(draw);
  play(m_draw(m_emphases));
}

void DrawingScene::play(DisplayList drawing) {
  m_outlines = std::move(drawing.outlines);
  // The marks of each part in their order.
  using PartKey = std::pair<ElementId, int>;
  struct PartHash {
    std::size_t operator()(const PartKey& key) const {
      return std::hash<ElementId>{}(key.first) * 31 + static_cast<std::size_t>(key.second);
    }
  };
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
  m_item->parts().beginDrawing();
}

/// A highlighted link shows its name: not twice, where it has a caption.
void DrawingScene::setPart(const ElementId& element, int depth, std::vector<Mark> marks) {
  ++m_drawnParts;
  dropCaptioned(element, m_captionMarks, marks);
  repaint(m_item->parts().set(element, depth, std::move(marks)));
}

void DrawingScene::setElement(const ElementId& element, std::vector<Mark> marks) {
  ++m_drawnParts;
  dropCaptioned(element, m_captionMarks, marks);
  repaint(m_item->parts().setElement(element, std::move(marks)));
}

void DrawingScene::endDrawing() {
  repaint(m_item->parts().endDrawing());
  growSheet();
}

void DrawingScene::setParts(SheetParts parts, std::vector<Outline> outlines) {
  m_item->parts() = std::move(parts);
  m_outlines = std::move(outlines);
  growSheet();
  update();
}

/// Uniting the areas of many parts costs the square of their number.
void DrawingScene::repaint(const QRectF& area) {
  constexpr int kMany = 100;
  if (area.isNull() || m_repaints > kMany) return;
  ++m_repaints;
  for (QGraphicsView* view : views()) {
    if (m_repaints > kMany) {
      view->viewport()->update();
    } else {
      view->viewport()->update(view->mapFromScene(area).boundingRect().adjusted(-2, -2, 2, 2));
    }
  }
}

void DrawingScene::beginPainting(const QRegion& exposed) {
  m_repaints = 0;
  m_item->setExposed(exposed);
}

void DrawingScene::setSheet(const QRectF& area) {
  setSceneRect(area);
  m_item->setArea(area);
}

void DrawingScene::growSheet() {
  const QRectF drawn = drawnRect();
  if (sceneRect().contains(drawn.adjusted(-1000, -1000, 1000, 1000))) return;
  setSheet(drawn.adjusted(-kRoomAround, -kRoomAround, kRoomAround, kRoomAround));
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

DrawingScene::Draw DrawingScene::drawing() const {
  return m_draw ? m_draw : [](const Emphases&) { return DisplayList{}; };
}

QRectF DrawingScene::drawnRect() const {
  QRectF drawn = parts().bounds(kHaloDepth);
  if (!m_underlayList.marks.empty()) drawn |= m_underlay->boundingRect();
  if (!m_captionMarks.empty()) drawn |= m_captions->boundingRect();
  return drawn;
}

void DrawingScene::setUnderlay(DisplayList underlay) {
  m_underlay->setMarks(underlay.marks);
  m_underlayList = std::move(underlay);
}

void DrawingScene::setCaptions(std::vector<Mark> captions) {
  m_captions->setMarks(captions);
  m_captionMarks = std::move(captions);
}

void DrawingScene::setOverlay(DisplayList overlay) {
  m_overlay->setMarks(std::move(overlay.marks));
}

}  // namespace geargraph

#include "moc_drawing_scene.cpp"

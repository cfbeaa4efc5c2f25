// The keys of a drawing: commands, and walking from element to element instead of pointing at them.

#include <QFocusEvent>
#include <QKeyEvent>
#include <algorithm>
#include <cmath>
#include <unordered_set>

#include "ui/canvas/drawing_view.h"
#include "ui/canvas/mark_painter.h"
#include "ui/canvas/place_grid.h"
#include "ui/workbench/measuring.h"

namespace geargraph {
namespace {

/// A point that lies on the shape.
CanvasPoint pointOn(const Shape& shape) {
  if (const auto* curve = std::get_if<Curve>(&shape)) return curve->at(0.5);
  if (const auto* line = std::get_if<Polyline>(&shape); line != nullptr && !line->points.empty())
    return line->points[line->points.size() / 2];
  return extentOf(shape).center;
}

}  // namespace

bool DrawingView::event(QEvent* event) {
  if (event->type() == QEvent::ShortcutOverride) {
    // Space belongs to panning as long as the drawing has the focus; a tap is handed on by spaceTapped().
    auto* key = static_cast<QKeyEvent*>(event);
    if (key->key() == Qt::Key_Space && key->modifiers() == Qt::NoModifier) {
      event->accept();
      return true;
    }
  }
  return QGraphicsView::event(event);
}

void DrawingView::keyPressEvent(QKeyEvent* event) {
  if (event->key() == Qt::Key_Space) {
    if (event->isAutoRepeat()) return;
    m_spaceDown = true;
    m_spaceUsed = false;
    updateCursor();
    return;
  }
  if (walkKey(*event) || viewKey(*event) || editKey(*event) || toolKeyPressed(*event)) return;
  event->ignore();
}

void DrawingView::keyReleaseEvent(QKeyEvent* event) {
  if (event->key() != Qt::Key_Space || event->isAutoRepeat()) {
    event->ignore();
    return;
  }
  const bool tap = m_spaceDown && !m_spaceUsed;
  m_spaceDown = false;
  updateCursor();
  if (tap) emit spaceTapped();
}

void DrawingView::focusInEvent(QFocusEvent* event) {
  QGraphicsView::focusInEvent(event);
  m_showsFocus = event->reason() == Qt::TabFocusReason || event->reason() == Qt::BacktabFocusReason ||
                 event->reason() == Qt::ShortcutFocusReason;
  viewport()->update();
}

void DrawingView::focusOutEvent(QFocusEvent* event) {
  m_showsFocus = false;
  viewport()->update();
  m_spaceDown = false;  // its release goes elsewhere
  updateCursor();
  QGraphicsView::focusOutEvent(event);
}

void DrawingView::escape() {
  if (isLoadDragged()) {
    stepLoad(Escaped{});
    m_grip = Grip::none;
    updateCursor();
  } else if (cancel()) {
    m_grip = Grip::none;
  } else if (tool() == ToolKind::measure) {
    if (m_measuring == nullptr || !m_measuring->cancel()) setTool(ToolKind::select);
  } else if (!m_selection->selected().empty()) {
    m_selection->clear();
  } else {
    setTool(ToolKind::select);
  }
}

bool DrawingView::viewKey(const QKeyEvent& event) {
  const bool control = (event.modifiers() & Qt::ControlModifier) != 0;
  switch (event.key()) {
    case Qt::Key_Escape:
      escape();
      return true;
    case Qt::Key_F:
      if (control) return false;
      (event.modifiers() & Qt::ShiftModifier) != 0 ? fitSelected() : fit();
      return true;
    case Qt::Key_0:
      if (control) fit();
      return control;
    case Qt::Key_1:
      if (control) resetZoom();
      return control;
    case Qt::Key_Plus:
    case Qt::Key_Equal:
      if (control) zoomIn();
      return control;
    case Qt::Key_Minus:
      if (control) zoomOut();
      return control;
    default:
      return false;
  }
}

bool DrawingView::editKey(const QKeyEvent& event) {
  const bool control = (event.modifiers() & Qt::ControlModifier) != 0;
  const double step = (event.modifiers() & Qt::ShiftModifier) != 0 ? 1 : 10;
  switch (event.key()) {
    case Qt::Key_Delete:
    case Qt::Key_Backspace:
      deleteSelected();
      return true;
    case Qt::Key_F2:
      renameSelected();
      return true;
    case Qt::Key_A:
      if (control) selectAll();
      return control;
    case Qt::Key_X:
      if (!control) flipSelected();
      return !control;
    case Qt::Key_Left:
      nudge(-step, 0, event.isAutoRepeat());
      return true;
    case Qt::Key_Right:
      nudge(step, 0, event.isAutoRepeat());
      return true;
    case Qt::Key_Up:
      nudge(0, -step, event.isAutoRepeat());
      return true;
    case Qt::Key_Down:
      nudge(0, step, event.isAutoRepeat());
      return true;
    default:
      return false;
  }
}

bool DrawingView::toolKeyPressed(const QKeyEvent& event) {
  if ((event.modifiers() & ~Qt::KeyboardModifiers(Qt::ShiftModifier)) != Qt::NoModifier) return false;
  for (int kind = 0; kind < kToolCount; ++kind) {
    const auto tool = static_cast<ToolKind>(kind);
    if (event.key() != toolKey(tool)) continue;
    setTool(tool);
    return true;
  }
  return false;
}

// --- walking ----------------------------------------------------------------------------------------------

std::vector<ElementId> DrawingView::drawnElements() const {
  std::unordered_set<ElementId> drawn;
  for (const Outline& outline : m_scene->outlines()) drawn.insert(outline.element);
  std::vector<ElementId> ordered;
  const auto add = [&](const auto& list) {
    for (const auto& each : list) {
      if (drawn.contains(each.id)) ordered.emplace_back(each.id);
    }
  };
  add(mechanism().links);
  add(mechanism().turningJoints);
  add(mechanism().gearMeshes);
  add(mechanism().couplings);
  add(mechanism().axes);
  add(mechanism().view.notes);
  return ordered;
}

std::optional<ElementId> DrawingView::currentElement() const {
  const std::set<ElementId>& selected = m_selection->selected();
  if (m_current && selected.contains(*m_current) && middleOf(*m_current)) return m_current;
  const ElementId* first = nullptr;  // of those selected, in their order
  for (const Outline& outline : m_scene->outlines()) {
    if (first != nullptr && !(outline.element < *first)) continue;
    if (selected.contains(outline.element)) first = &outline.element;
  }
  return first == nullptr ? std::nullopt : std::optional(*first);
}

std::optional<CanvasPoint> DrawingView::middleOf(const ElementId& element) const {
  const std::vector<Outline>& outlines = m_scene->outlines();
  const auto found = std::find_if(outlines.begin(), outlines.end(),
                                  [&](const Outline& outline) { return outline.element == element; });
  if (found == outlines.end()) return std::nullopt;
  return pointOn(found->shape);
}

QRect DrawingView::boxOf(const ElementId& element) const {
  QRectF box;
  for (const Outline& outline : m_scene->outlines()) {
    if (outline.element == element) box |= toQRect(extentOf(outline.shape).grown(1));
  }
  return box.isNull() ? QRect() : mapFromScene(box).boundingRect();
}

CanvasPoint DrawingView::freePlace() const {
  constexpr double kStep = 90, kRoom = 50;
  constexpr int kRings = 60;
  const CanvasPoint middle = toSheetPoint(mapToScene(viewport()->rect().center()));
  PlaceGrid taken(kRings);
  QRectF all;
  for (const Outline& outline : m_scene->outlines()) {
    const QRectF box = toQRect(extentOf(outline.shape).grown(kRoom));
    taken.take({std::ceil((box.left() - middle.x) / kStep), std::floor((box.right() - middle.x) / kStep)},
               {std::ceil((box.top() - middle.y) / kStep), std::floor((box.bottom() - middle.y) / kStep)});
    all |= box;
  }
  // Rings of places round the middle, then beside everything that is drawn.
  if (const auto free = taken.nearestFree())
    return middle + CanvasPoint{free->across * kStep, free->down * kStep};
  return {all.right() + kStep, middle.y};
}

void DrawingView::walk(int steps, bool add) {
  const std::vector<ElementId> all = drawnElements();
  if (all.empty()) return;
  const auto count = static_cast<int>(all.size());
  const std::optional<ElementId> current = currentElement();
  const auto found = current ? std::find(all.begin(), all.end(), *current) : all.end();
  if (found == all.end()) return walkTo(steps > 0 ? all.front() : all.back(), add);
  const int next = (static_cast<int>(found - all.begin()) + steps + count) % count;
  walkTo(all[static_cast<std::size_t>(next)], add);
}

/// The nearest one within an eighth of a turn to either side.
void DrawingView::walkTowards(CanvasPoint direction, bool add) {
  const std::optional<ElementId> current = currentElement();
  if (!current) return walk(1, add);
  const CanvasPoint from = *middleOf(*current);
  std::optional<ElementId> nearest;
  double least = 0;
  for (const Outline& outline : m_scene->outlines()) {
    const CanvasPoint way = pointOn(outline.shape) - from;
    const double along = dot(way, direction);
    const double aside = std::abs(way.x * direction.y - way.y * direction.x);
    if (outline.element == *current || outline.element.id.empty() || along <= aside || along <= 0) continue;
    if (nearest && along + aside >= least) continue;
    nearest = outline.element;
    least = along + aside;
  }
  if (nearest) walkTo(*nearest, add);
}

void DrawingView::walkTo(const ElementId& element, bool add) {
  std::set<ElementId> chosen = add ? m_selection->selected() : std::set<ElementId>{};
  chosen.insert(element);
  m_current = element;
  m_selection->select(std::move(chosen));
  if (const QRect box = boxOf(element); !viewport()->rect().contains(box.center())) {
    centerOn(mapToScene(box.center()));
    m_fitted = false;
  }
  emit walkedTo(element);
}

std::optional<Pointer> DrawingView::keyStrokeEnd(const Pointer& begin) const {
  const bool isClick = tool() == ToolKind::link || tool() == ToolKind::note;
  return isClick ? std::optional(begin) : std::nullopt;
}

void DrawingView::clickCurrent() {
  const std::optional<ElementId> current = currentElement();
  if (tool() == ToolKind::select) {
    if (current) openElement(*current);
    return;
  }
  if (tool() == ToolKind::load) return editLoad();
  if (tool() == ToolKind::measure) {
    if (m_measuring != nullptr && current) m_measuring->take(*current);
    return;
  }
  Pointer pointer;
  const bool onNote = current && current->kind == ElementKind::note;
  const bool placesNew = tool() == ToolKind::link || (tool() == ToolKind::note && !onNote);
  pointer.on = placesNew ? std::nullopt : current;
  if (!pointer.on && !placesNew) return;
  pointer.at = pointer.on ? *middleOf(*pointer.on) : freePlace();
  pointer.onSelected = pointer.on.has_value();
  if (!isIdle()) {
    moved(pointer);
    return released(pointer);
  }
  pressed(pointer);
  if (const auto end = keyStrokeEnd(pointer); end && !isIdle()) {
    moved(*end);
    released(*end);
  }
}

bool DrawingView::walkKey(const QKeyEvent& event) {
  const bool control = (event.modifiers() & Qt::ControlModifier) != 0;
  const bool add = (event.modifiers() & Qt::ShiftModifier) != 0;
  switch (event.key()) {
    case Qt::Key_PageDown:
    case Qt::Key_PageUp:
      walk(event.key() == Qt::Key_PageDown ? 1 : -1, add);
      return true;
    case Qt::Key_Left:
    case Qt::Key_Right:
      if (control) walkTowards({event.key() == Qt::Key_Right ? 1.0 : -1.0, 0}, add);
      return control;
    case Qt::Key_Up:
    case Qt::Key_Down:
      if (control) walkTowards({0, event.key() == Qt::Key_Down ? 1.0 : -1.0}, add);
      return control;
    case Qt::Key_Return:
    case Qt::Key_Enter:
      clickCurrent();
      return true;
    default:
      return false;
  }
}

}  // namespace geargraph

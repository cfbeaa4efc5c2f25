// The mouse on a drawing: turns Qt's events into those of tools. The keys are in drawing_view_keys.cpp.

#include <QHelpEvent>
#include <QMenu>
#include <QMouseEvent>
#include <QNativeGestureEvent>
#include <QToolTip>

#include "core/presentation/drawing/hit_test.h"
#include "ui/canvas/drawing_view.h"
#include "ui/canvas/mark_painter.h"

namespace geargraph {
namespace {

constexpr double kReach = 3;  ///< px on screen around an arrow that still hit it
constexpr double kSlop = 4;   ///< px on screen that a click may wander

}  // namespace

std::optional<ElementId> DrawingView::elementUnder(QPointF viewportPlace) const {
  const CanvasPoint place = toSheetPoint(mapToScene(viewportPlace.toPoint()));
  const auto element = elementAt(m_scene->outlines(), place, kReach / scaleNow());
  return element ? element : elementAt(m_scene->underlay().outlines, place, 0);
}

Pointer DrawingView::pointerAt(QPointF viewportPlace, Qt::KeyboardModifiers modifiers) const {
  Pointer pointer;
  pointer.at = toSheetPoint(mapToScene(viewportPlace.toPoint()));
  pointer.on = elementUnder(viewportPlace);
  pointer.onSelected = pointer.on && m_selection->isSelected(*pointer.on);
  pointer.add = (modifiers & (Qt::ShiftModifier | Qt::ControlModifier)) != 0;
  pointer.unsnapped = (modifiers & Qt::AltModifier) != 0;
  pointer.slop = kSlop / scaleNow();
  return pointer;
}

// --- mouse ------------------------------------------------------------------------------------------------

void DrawingView::mousePressEvent(QMouseEvent* event) {
  const bool left = event->button() == Qt::LeftButton;
  const bool pan = event->button() == Qt::MiddleButton || (left && m_spaceDown);
  if (m_grip != Grip::none || (!left && !pan)) return;
  m_grip = pan ? Grip::pan : Grip::tool;
  m_panFrom = event->position();
  if (pan) {
    m_spaceUsed = m_spaceDown;
  } else {
    const Pointer pointer = pointerAt(event->position(), event->modifiers());
    if (tool() == ToolKind::measure) {
      measureFrom(pointer);
    } else if (!grabLoad(event->position(), pointer)) {
      pressed(pointer);
    }
  }
  updateCursor();
}

void DrawingView::pressed(const Pointer& pointer) {
  if (tool() == ToolKind::pan) {
    m_grip = Grip::pan;
  } else if (!pointer.on) {
    if (!pointer.add) m_selection->clear();
  } else if (pointer.add) {
    m_selection->toggle(*pointer.on);
  } else {
    m_selection->select({*pointer.on});
  }
}

void DrawingView::mouseMoveEvent(QMouseEvent* event) {
  if (m_grip == Grip::pan) {
    m_fitted = false;
    const QPoint step = (event->position() - m_panFrom).toPoint();  // the sheet moves by whole pixels
    moveView(step);
    m_panFrom += step;
    return;
  }
  const Pointer pointer = pointerAt(event->position(), event->modifiers());
  if (isLoadDragged()) return stepLoad(Moved{pointer});
  moved(pointer);
  if (m_grip == Grip::tool && tool() == ToolKind::select) return;  // what is dragged stays highlighted
  if (const bool over = tool() == ToolKind::select && loadUnder(event->position()); over != m_overLoad) {
    m_overLoad = over;
    updateCursor();
  }
  if (pointer.on) {
    m_selection->hover(*pointer.on);
  } else {
    m_selection->unhover();
  }
  m_hovering = pointer.on.has_value();
}

void DrawingView::mouseReleaseEvent(QMouseEvent* event) {
  if (m_grip == Grip::tool && event->button() == Qt::LeftButton) {
    const Pointer pointer = pointerAt(event->position(), event->modifiers());
    isLoadDragged() ? stepLoad(Released{pointer}) : released(pointer);
  }
  if ((event->buttons() & (Qt::LeftButton | Qt::MiddleButton)) == 0) m_grip = Grip::none;
  updateCursor();
}

void DrawingView::mouseDoubleClickEvent(QMouseEvent* event) {
  const std::optional<ElementId> element = elementUnder(event->position());
  if (event->button() != Qt::LeftButton || tool() != ToolKind::select || !element) {
    mousePressEvent(event);  // two quick clicks of any other tool
    return;
  }
  if (loadUnder(event->position())) return editLoad();  // the first click has selected it
  openElement(*element);
}

void DrawingView::leaveEvent(QEvent* event) {
  if (m_hovering) m_selection->unhover();
  m_hovering = false;
  QGraphicsView::leaveEvent(event);
}

void DrawingView::wheelEvent(QWheelEvent* event) {
  const bool touchpad = event->phase() != Qt::NoScrollPhase && !event->pixelDelta().isNull();
  if (touchpad && (event->modifiers() & Qt::ControlModifier) == 0) {
    panBy(QPointF(event->pixelDelta()) / scaleNow());
  } else {
    zoomAt(event->position(), std::pow(1.2, event->angleDelta().y() / 120.0));
  }
  event->accept();
}

void DrawingView::contextMenuEvent(QContextMenuEvent* event) {
  if (isDrawing()) return;
  QPoint place = viewport()->mapFromGlobal(event->globalPos());
  const std::optional<ElementId> current = currentElement();
  const bool byKey = event->reason() == QContextMenuEvent::Keyboard && current;
  if (byKey) place = boxOf(*current).center();
  QMenu* menu = byKey ? contextMenuFor(current, toSheetPoint(mapToScene(place))) : contextMenuAt(place);
  menu->setAttribute(Qt::WA_DeleteOnClose);
  menu->popup(viewport()->mapToGlobal(place));
}

/// What the element is, then what is painted under the drawing there: a load that can be dragged, a balance
/// with what was found for it.
QString DrawingView::tipAt(const ElementId& element, QPointF viewportPlace) const {
  QString tip = toolTipFor(element);
  const CanvasPoint place = toSheetPoint(mapToScene(viewportPlace.toPoint()));
  const bool isUnder = !elementAt(m_scene->outlines(), place, 0);
  const auto further = m_underlayTips.find(element);
  if (isUnder && further != m_underlayTips.end()) tip += QLatin1Char('\n') + further->second;
  if (loadUnder(viewportPlace)) tip += tr("\nDrag to change the load; W types it");
  return tip;
}

bool DrawingView::viewportEvent(QEvent* event) {
  if (event->type() == QEvent::ToolTip) {
    auto* help = static_cast<QHelpEvent*>(event);
    const std::optional<ElementId> element = elementUnder(help->pos());
    const bool onCaption =
        !m_caption.isEmpty() && boxOf(m_caption, Qt::BottomLeftCorner).box.contains(help->pos());
    if (onCaption && !captionToolTip().isEmpty()) {
      QToolTip::showText(help->globalPos(), captionToolTip(), viewport());
    } else if (element) {
      QToolTip::showText(help->globalPos(), tipAt(*element, help->pos()), viewport());
    } else {
      QToolTip::hideText();
    }
    return true;
  }
  if (event->type() == QEvent::NativeGesture) {
    auto* gesture = static_cast<QNativeGestureEvent*>(event);
    if (gesture->gestureType() == Qt::ZoomNativeGesture) {
      zoomAt(gesture->position(), 1 + gesture->value());
      return true;
    }
  }
  return QGraphicsView::viewportEvent(event);
}

void DrawingView::updateCursor() {
  Qt::CursorShape shape = Qt::ArrowCursor;
  if (tool() == ToolKind::link || tool() == ToolKind::turningJoint || tool() == ToolKind::gearMesh ||
      tool() == ToolKind::measure) {
    shape = Qt::CrossCursor;
  }
  if (tool() == ToolKind::note) shape = Qt::IBeamCursor;
  if (tool() == ToolKind::input || tool() == ToolKind::load) shape = Qt::PointingHandCursor;
  if (m_overLoad || isLoadDragged()) shape = Qt::SizeHorCursor;
  if (tool() == ToolKind::pan || m_spaceDown) shape = Qt::OpenHandCursor;
  const bool pulling = m_grip == Grip::pan || (m_grip == Grip::tool && tool() == ToolKind::pan);
  viewport()->setCursor(pulling ? Qt::ClosedHandCursor : shape);
}

}  // namespace geargraph

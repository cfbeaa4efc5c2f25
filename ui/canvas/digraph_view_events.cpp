// The mouse and the keys of the digraph view: turns Qt's events into those of tools and commands.

#include <QHelpEvent>
#include <QKeyEvent>
#include <QMenu>
#include <QMouseEvent>
#include <QNativeGestureEvent>
#include <QToolTip>

#include "core/drawing/hit_test.h"
#include "ui/canvas/canvas_edits.h"
#include "ui/canvas/digraph_view.h"
#include "ui/canvas/mark_painter.h"

namespace geargraph {
namespace {

constexpr double kReach = 3;  ///< px on screen around an arrow that still hit it
constexpr double kSlop = 4;   ///< px on screen that a click may wander

}  // namespace

std::optional<ElementId> DigraphView::elementUnder(QPointF viewportPlace) const {
  return elementAt(m_scene->outlines(), toSheetPoint(mapToScene(viewportPlace.toPoint())),
                   kReach / scaleNow());
}

Pointer DigraphView::pointerAt(QPointF viewportPlace, Qt::KeyboardModifiers modifiers) const {
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

void DigraphView::mousePressEvent(QMouseEvent* event) {
  const bool left = event->button() == Qt::LeftButton;
  const bool pan = event->button() == Qt::MiddleButton || (left && m_spaceDown);
  if (m_grip != Grip::none || (!left && !pan)) return;
  const Pointer pointer = pointerAt(event->position(), event->modifiers());
  m_grip = pan ? Grip::pan : Grip::tool;
  if (pan) {
    m_spaceUsed = m_spaceDown;
    m_controller->handlePan(Pressed{pointer});
  } else {
    m_controller->handle(Pressed{pointer}, scaleNow());
  }
  updateCursor();
}

void DigraphView::mouseMoveEvent(QMouseEvent* event) {
  const Pointer pointer = pointerAt(event->position(), event->modifiers());
  if (m_grip == Grip::pan) {
    m_controller->handlePan(Moved{pointer});
    return;
  }
  m_controller->handle(Moved{pointer}, scaleNow());
  if (m_grip == Grip::tool && m_controller->tool() == ToolKind::select) return;  // what is dragged stays lit
  if (pointer.on) {
    m_selection->hover(*pointer.on);
  } else {
    m_selection->unhover();
  }
  m_hovering = pointer.on.has_value();
}

void DigraphView::mouseReleaseEvent(QMouseEvent* event) {
  const Pointer pointer = pointerAt(event->position(), event->modifiers());
  if (m_grip == Grip::pan) m_controller->handlePan(Released{pointer});
  if (m_grip == Grip::tool && event->button() == Qt::LeftButton)
    m_controller->handle(Released{pointer}, scaleNow());
  if ((event->buttons() & (Qt::LeftButton | Qt::MiddleButton)) == 0) m_grip = Grip::none;
  updateCursor();
}

void DigraphView::mouseDoubleClickEvent(QMouseEvent* event) {
  const std::optional<ElementId> element = elementUnder(event->position());
  if (event->button() != Qt::LeftButton || tool() != ToolKind::select || !element) {
    mousePressEvent(event);  // two quick clicks of any other tool
    return;
  }
  if (element->kind == ElementKind::link) {
    openRenameEditor(LinkId(element->id));
  } else {
    emit propertiesWanted(*element);
  }
}

void DigraphView::leaveEvent(QEvent* event) {
  if (m_hovering) m_selection->unhover();
  m_hovering = false;
  QGraphicsView::leaveEvent(event);
}

void DigraphView::wheelEvent(QWheelEvent* event) {
  const bool touchpad = event->phase() != Qt::NoScrollPhase && !event->pixelDelta().isNull();
  if (touchpad && (event->modifiers() & Qt::ControlModifier) == 0) {
    panBy(QPointF(event->pixelDelta()) / scaleNow());
  } else {
    zoomAt(event->position(), std::pow(1.2, event->angleDelta().y() / 120.0));
  }
  event->accept();
}

void DigraphView::contextMenuEvent(QContextMenuEvent* event) {
  if (!m_controller->isIdle()) return;
  QMenu* menu = contextMenuAt(viewport()->mapFromGlobal(event->globalPos()));
  menu->setAttribute(Qt::WA_DeleteOnClose);
  menu->popup(event->globalPos());
}

bool DigraphView::viewportEvent(QEvent* event) {
  if (event->type() == QEvent::ToolTip) {
    auto* help = static_cast<QHelpEvent*>(event);
    const std::optional<ElementId> element = elementUnder(help->pos());
    if (element) {
      QToolTip::showText(help->globalPos(), toolTipFor(*element), viewport());
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

QString DigraphView::toolTipFor(const ElementId& element) const {
  const Mechanism& mechanism = *m_document->mechanism();
  QString text = describe(mechanism, {element});
  text[0] = text[0].toUpper();
  if (element.kind == ElementKind::link) {
    const Link* link = mechanism.find(LinkId(element.id));
    if (link != nullptr && !link->name.empty()) text += ": " + QString::fromStdString(link->name);
    return text;
  }
  const auto ends = [&](LinkId tail, LinkId head) {
    return tr(" from link %1 to link %2")
        .arg(QString::fromStdString(*labelOf(mechanism, tail)),
             QString::fromStdString(*labelOf(mechanism, head)));
  };
  if (const TurningJoint* joint = mechanism.find(JointId(element.id));
      joint != nullptr && element == ElementId(joint->id)) {
    text += ends(joint->tail, joint->head) + tr(", axis %1").arg(QString::fromStdString(joint->axis.text()));
    if (isInput(mechanism, joint->id)) text += tr(", driven");
  }
  if (const GearMesh* mesh = mechanism.find(MeshId(element.id));
      mesh != nullptr && element == ElementId(mesh->id)) {
    text += ends(mesh->tail, mesh->head) + tr(", %1 : %2 teeth").arg(mesh->tailTeeth).arg(mesh->headTeeth);
  }
  return text;
}

void DigraphView::updateCursor() {
  Qt::CursorShape shape = Qt::ArrowCursor;
  if (tool() == ToolKind::link || tool() == ToolKind::turningJoint || tool() == ToolKind::gearMesh) {
    shape = Qt::CrossCursor;
  }
  if (tool() == ToolKind::input) shape = Qt::PointingHandCursor;
  if (tool() == ToolKind::pan || m_spaceDown) shape = Qt::OpenHandCursor;
  const bool pulling = m_grip == Grip::pan || (m_grip == Grip::tool && tool() == ToolKind::pan);
  viewport()->setCursor(pulling ? Qt::ClosedHandCursor : shape);
}

// --- keys -------------------------------------------------------------------------------------------------

bool DigraphView::event(QEvent* event) {
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

void DigraphView::keyPressEvent(QKeyEvent* event) {
  if (event->key() == Qt::Key_Space) {
    if (event->isAutoRepeat()) return;
    m_spaceDown = true;
    m_spaceUsed = false;
    updateCursor();
    return;
  }
  if (viewKey(*event) || editKey(*event) || toolKeyPressed(*event)) return;
  event->ignore();
}

void DigraphView::keyReleaseEvent(QKeyEvent* event) {
  if (event->key() != Qt::Key_Space || event->isAutoRepeat()) {
    event->ignore();
    return;
  }
  const bool tap = m_spaceDown && !m_spaceUsed;
  m_spaceDown = false;
  updateCursor();
  if (tap) emit spaceTapped();
}

void DigraphView::focusOutEvent(QFocusEvent* event) {
  m_spaceDown = false;  // its release goes elsewhere
  updateCursor();
  QGraphicsView::focusOutEvent(event);
}

void DigraphView::escape() {
  if (!m_controller->isIdle()) {
    m_controller->handle(Escaped{}, scaleNow());
    m_grip = Grip::none;
  } else if (!m_selection->selected().empty()) {
    m_selection->clear();
  } else {
    setTool(ToolKind::select);
  }
}

bool DigraphView::viewKey(const QKeyEvent& event) {
  const bool control = (event.modifiers() & Qt::ControlModifier) != 0;
  switch (event.key()) {
    case Qt::Key_Escape:
      escape();
      return true;
    case Qt::Key_F:
      if (!control) fit();
      return !control;
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

bool DigraphView::editKey(const QKeyEvent& event) {
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
      m_controller->nudge(-step, 0, event.isAutoRepeat());
      return true;
    case Qt::Key_Right:
      m_controller->nudge(step, 0, event.isAutoRepeat());
      return true;
    case Qt::Key_Up:
      m_controller->nudge(0, -step, event.isAutoRepeat());
      return true;
    case Qt::Key_Down:
      m_controller->nudge(0, step, event.isAutoRepeat());
      return true;
    default:
      return false;
  }
}

bool DigraphView::toolKeyPressed(const QKeyEvent& event) {
  if ((event.modifiers() & ~Qt::KeyboardModifiers(Qt::ShiftModifier)) != Qt::NoModifier) return false;
  for (int kind = 0; kind < kToolCount; ++kind) {
    const auto tool = static_cast<ToolKind>(kind);
    if (event.key() != toolKey(tool)) continue;
    setTool(tool);
    return true;
  }
  return false;
}

}  // namespace geargraph

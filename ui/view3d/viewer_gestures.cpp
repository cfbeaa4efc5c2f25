#include <QApplication>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QNativeGestureEvent>
#include <QPointingDevice>
#include <QWheelEvent>
#include <algorithm>
#include <cmath>
#include <utility>

#include "ui/view3d/viewer.h"

namespace geargraph {
namespace {

constexpr double kZoomPerNotch = 1.15;
constexpr double kMaxZoomPerEvent = 4;
constexpr double kZoomPerPixel = 1.006;
constexpr double kKeyPixels = 32;  // an arrow key turns as far as a drag by as many pixels

}  // namespace

// A stage may change before the answer is there: what is left of the part is another instance.
void Viewer::ask(const QPointF& place, PickFor use, Answer answer) {
  if (!m_pick || m_stage == nullptr) return answer(std::nullopt);
  m_pick(frame(true), place.x() * m_pixelRatio, place.y() * m_pixelRatio, use,
         [this, stage = m_stage, dropped = m_dropped, answer = std::move(answer)](std::optional<Hit> hit) {
           if (dropped != m_dropped) return;
           if (hit && stage != m_stage) {
             const auto now = instance(hit->element);
             now ? static_cast<void>(hit->instance = *now) : hit.reset();
           }
           answer(hit);
         });
}

void Viewer::dropQuestions() {
  ++m_dropped;
  m_zoom.reset();
  m_grab.reset();
  if (m_gesture == Gesture::grab) m_gesture = Gesture::none;
}

void Viewer::setPick(Pick pick) {
  dropQuestions();
  m_pick = std::move(pick);
}

void Viewer::hover(const QPointF& place) {
  m_isPointedAt = true;
  ask(place, PickFor::hover, [this, place](const std::optional<Hit>& hit) {
    if (!m_isPointedAt) return;
    hit ? m_selection->hover(hit->element) : m_selection->unhover();
    const Gesture gesture = gestureOn(hit, false);
    emit pointed(gesture == Gesture::time ? tr("Drag the part to turn the train. Ctrl turns it alone by hand")
                 : gesture == Gesture::turn ? tr("Drag the part to turn it by hand")
                 : hit && m_view.trajectory ? tr("Drag to orbit: the train moves as its torques make it")
                 : hit                      ? tr("Drag to orbit: this part does not turn")
                                            : tr("Drag to orbit, with Shift to pan; the wheel zooms"));
    if (m_probe) m_probe(place, hit, false);
  });
}

// What the pointer has done before the answer is there is made up for then, even if the button is up again.
void Viewer::grab(const QPointF& place, bool isByHand) {
  m_gesture = Gesture::grab;
  m_grab = std::make_shared<Grab>();
  m_grab->isByHand = isByHand;
  ask(place, PickFor::gesture, [this, grab = m_grab](const std::optional<Hit>& hit) {
    std::optional<Hit> held = hit;
    const Gesture gesture = gestureOn(held, grab->isByHand);
    for (const QPointF& step : grab->steps) drag(gesture, held, step);
    if (m_grab != grab) return;
    m_grab.reset();
    m_gesture = gesture;
    m_held = std::move(held);
  });
}

/// What dragging the thing under the pointer does.
Viewer::Gesture Viewer::gestureOn(const std::optional<Hit>& hit, bool isByHand) const {
  const bool turns = hit && m_stage != nullptr && hit->instance < m_stage->handles.size() &&
                     !m_stage->handles[hit->instance].gains.empty();
  // Along a trajectory every angle follows from the time.
  if (!turns || trajectoryOf(*m_stage, m_view) != nullptr) return Gesture::orbit;
  return isByHand || rateOf(hit->instance) == 0 ? Gesture::turn : Gesture::time;
}

void Viewer::drag(Gesture gesture, std::optional<Hit>& held, const QPointF& step) {
  emit moving();
  if (gesture == Gesture::turn) return turn(*held, step);
  if (gesture == Gesture::time) return runTo(*held, step);
  if (gesture == Gesture::zoom) return zoomAt(m_pressedAt, std::pow(kZoomPerPixel, -step.y()));
  setCamera(gesture == Gesture::orbit
                ? m_view.camera.orbited(step.x(), step.y())
                : m_view.camera.panned(step.x() * m_pixelRatio, step.y() * m_pixelRatio, m_viewport));
}

bool Viewer::eventFilter(QObject* canvas, QEvent* event) {
  switch (event->type()) {
    case QEvent::MouseButtonPress:
    case QEvent::MouseButtonDblClick:
      event->setAccepted(mousePress(*static_cast<QMouseEvent*>(event)));
      return true;
    case QEvent::MouseMove:
      event->setAccepted(mouseMove(*static_cast<QMouseEvent*>(event)));
      return true;
    case QEvent::MouseButtonRelease:
      event->setAccepted(mouseRelease(*static_cast<QMouseEvent*>(event)));
      return true;
    case QEvent::Wheel:
      event->setAccepted(wheel(*static_cast<QWheelEvent*>(event)));
      return true;
    case QEvent::NativeGesture:
      return nativeGesture(*static_cast<QNativeGestureEvent*>(event));
    case QEvent::Leave:
      leave();
      return false;
    default:
      return QObject::eventFilter(canvas, event);
  }
}

bool Viewer::mousePress(const QMouseEvent& event) {
  if (m_gesture != Gesture::none) return true;
  const bool isLeft = event.button() == Qt::LeftButton;
  m_held.reset();
  m_pressedAt = m_last = event.position();
  m_dragged = false;
  if (isLeft && event.modifiers().testFlag(Qt::ControlModifier)) {
    grab(event.position(), true);
  } else if (isLeft && !event.modifiers().testFlag(Qt::ShiftModifier)) {
    m_gesture = Gesture::grab;  // what is there is asked when the pointer moves: it may be a click
  } else {
    m_gesture = gestureOf(event);
  }
  return m_gesture != Gesture::none;
}

/// For buttons that never grab a part.
Viewer::Gesture Viewer::gestureOf(const QMouseEvent& event) const {
  if (event.button() == Qt::RightButton || event.button() == Qt::LeftButton) return Gesture::pan;
  if (event.button() != Qt::MiddleButton) return Gesture::none;
  const bool isShift = event.modifiers().testFlag(Qt::ShiftModifier);
  const bool isControl = event.modifiers().testFlag(Qt::ControlModifier);
  switch (m_navigation) {
    case Navigation::blender:
      return isControl ? Gesture::zoom : isShift ? Gesture::pan : Gesture::orbit;
    case Navigation::freeCad:
      return isControl ? Gesture::zoom : isShift ? Gesture::orbit : Gesture::pan;
    case Navigation::solidWorks:
      return isControl ? Gesture::pan : isShift ? Gesture::zoom : Gesture::orbit;
  }
  return Gesture::none;
}

bool Viewer::mouseMove(const QMouseEvent& event) {
  if (m_gesture == Gesture::none) {
    hover(event.position());
    return true;
  }
  if (!m_dragged) {
    const QPointF away = event.position() - m_pressedAt;
    if (away.manhattanLength() < QApplication::startDragDistance() / 2.0) return true;
    m_dragged = true;
    if (m_gesture == Gesture::grab && m_grab == nullptr) grab(m_pressedAt, false);
  }
  const QPointF step = event.position() - m_last;
  m_last = event.position();
  if (m_gesture == Gesture::grab) {
    m_grab->steps.push_back(step);
  } else {
    drag(m_gesture, m_held, step);
  }
  return true;
}

bool Viewer::mouseRelease(const QMouseEvent& event) {
  if (m_gesture == Gesture::none || event.buttons() != Qt::NoButton) return false;
  m_gesture = Gesture::none;
  m_grab.reset();
  if (m_dragged) return true;
  const QPointF place = event.position();
  if (event.button() == Qt::RightButton) {
    ask(place, PickFor::gesture,
        [this, place](const std::optional<Hit>& hit) { emit menuWanted(hit, place); });
  } else if (event.button() == Qt::LeftButton) {
    const bool isAdded = event.modifiers().testFlag(Qt::ControlModifier);
    ask(place, PickFor::gesture, [this, place, isAdded](const std::optional<Hit>& hit) {
      if (!m_probe || !m_probe(place, hit, true)) click(hit, isAdded);
    });
  }
  return true;
}

void Viewer::click(const std::optional<Hit>& hit, bool isAdded) {
  if (isAdded) {
    if (hit) m_selection->toggle(hit->element);
  } else {
    hit ? m_selection->select({hit->element}) : m_selection->clear();
  }
}

// One question for all notches that follow each other before its answer is there.
void Viewer::zoomAt(const QPointF& place, double factor) {
  if (m_zoom != nullptr && m_zoom->place == place) {
    m_zoom->factor *= factor;
    return;
  }
  m_zoom = std::make_shared<Zoom>(Zoom{place, factor});
  ask(place, PickFor::gesture, [this, zoom = m_zoom](const std::optional<Hit>& hit) {
    if (m_zoom == zoom) m_zoom.reset();
    const QPointF at = zoom->place * m_pixelRatio;
    setCamera(m_view.camera.zoomed(
        zoom->factor, hit ? hit->point : m_view.camera.atTargetDepth(at.x(), at.y(), m_viewport)));
  });
}

bool Viewer::wheel(const QWheelEvent& event) {
  const bool isPad =
      event.device() != nullptr && event.device()->type() == QInputDevice::DeviceType::TouchPad;
  if (isPad && !event.modifiers().testFlag(Qt::ControlModifier)) {
    const QPointF step = event.pixelDelta().isNull() ? QPointF(event.angleDelta()) / 8 : event.pixelDelta();
    emit moving();
    setCamera(m_view.camera.panned(step.x() * m_pixelRatio, step.y() * m_pixelRatio, m_viewport));
    return true;
  }
  const double notches = event.angleDelta().y() / 120.0;
  if (notches == 0) return false;
  emit moving();
  zoomAt(event.position(),
         std::clamp(std::pow(kZoomPerNotch, notches), 1 / kMaxZoomPerEvent, kMaxZoomPerEvent));
  return true;
}

bool Viewer::nativeGesture(const QNativeGestureEvent& event) {
  if (event.gestureType() != Qt::ZoomNativeGesture) return false;
  emit moving();
  zoomAt(event.position(), std::clamp(1 + event.value(), 1 / kMaxZoomPerEvent, kMaxZoomPerEvent));
  return true;
}

bool Viewer::keyPress(const QKeyEvent& event) {
  const auto arrow = [&](double across, double down) {
    const double x = kKeyPixels * across, y = kKeyPixels * down;
    setCamera(event.modifiers().testFlag(Qt::ShiftModifier)
                  ? m_view.camera.panned(x * m_pixelRatio, y * m_pixelRatio, m_viewport)
                  : m_view.camera.orbited(x, y));
    return true;
  };
  const QPointF middle(0.5 * m_viewport.width / m_pixelRatio, 0.5 * m_viewport.height / m_pixelRatio);
  switch (event.key()) {
    case Qt::Key_Left:
      return arrow(-1, 0);
    case Qt::Key_Right:
      return arrow(1, 0);
    case Qt::Key_Up:
      return arrow(0, -1);
    case Qt::Key_Down:
      return arrow(0, 1);
    case Qt::Key_Plus:
    case Qt::Key_Equal:
      zoomAt(middle, kZoomPerNotch);
      return true;
    case Qt::Key_Minus:
      zoomAt(middle, 1 / kZoomPerNotch);
      return true;
    default:
      return false;
  }
}

void Viewer::leave() {
  m_isPointedAt = false;
  emit pointed({});
  if (m_gesture == Gesture::none) m_selection->unhover();
}

}  // namespace geargraph

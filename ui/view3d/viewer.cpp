#include "ui/view3d/viewer.h"

#include <QApplication>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QNativeGestureEvent>
#include <QPointingDevice>
#include <QWheelEvent>
#include <algorithm>
#include <cmath>
#include <utility>

#include "core/foundations/base/contract.h"
#include "core/presentation/stage/exploded.h"

namespace geargraph::inline view3d {
namespace {

constexpr double kZoomPerNotch = 1.15;
constexpr double kMostZoomPerEvent = 4;
constexpr double kKeyPixels = 32;           // an arrow key turns as far as a drag by so many pixels
constexpr double kHalfFrame = 8;            // ms
constexpr int kHandRests = 150;             // ms
constexpr double kTraceWithoutPeriod = 60;  // s

}  // namespace

Viewer::Viewer(Selection* selection, QObject* parent) : QObject(parent), m_selection(selection) {
  m_whenHandRests.setSingleShot(true);
  m_whenHandRests.setInterval(kHandRests);
  connect(&m_whenHandRests, &QTimer::timeout, this, &Viewer::lightUp);
  connect(selection, &Selection::selectionChanged, this, &Viewer::lightUp);
  connect(selection, &Selection::hoverChanged, this, &Viewer::lightUpHovered);
}

void Viewer::setStage(StagePtr stage) {
  const bool first = m_stage == nullptr || m_stage->scene.instances.empty();
  const StagePtr before = std::exchange(m_stage, std::move(stage));
  m_seen = {};
  m_separations.clear();
  m_outlines.reset();
  m_bounds.reset();
  if (m_stage != nullptr) {
    for (const Instance& instance : m_stage->scene.instances) m_seen.poses.push_back(instance.pose);
  }
  if (!instance(m_view.ridden)) m_view.ridden.reset();
  if (m_gesture == Gesture::turn) m_gesture = Gesture::none;  // what was held is gone
  if (m_stage == nullptr || m_view.turned.size() != m_stage->inputSpeeds.size()) m_view.turned.clear();
  if (before != nullptr && m_stage != nullptr) renewTraces(*before);
  const bool isEmpty = m_stage == nullptr || m_stage->scene.instances.empty();
  if (first || (m_isAnew && !isEmpty)) m_fitted = false;
  emit sceneChanged();
  lightUp();
  place();
  emit viewChanged();
  if (isEmpty) return;
  if (m_isAnew && m_opening) {
    setCamera(*m_opening);
    m_fitted = true;
  }
  if (!m_fitted) fitNow();
  m_isAnew = false;
  m_opening.reset();
}

void Viewer::startAnew(const std::optional<Camera>& camera) {
  m_isAnew = true;
  m_opening = camera;
  m_isCameraChosen = camera.has_value();
  m_view.traces.clear();
  m_view.turned.clear();
  m_view.hidden.clear();
  m_view.ridden.reset();
  if (!camera) m_view.camera = Camera::home();
  emit optionsChanged();
}

// A part is found again by its place among those of its link.
void Viewer::renewTraces(const Stage& before) {
  std::vector<ShownTrace> kept;
  for (ShownTrace& trace : m_view.traces) {
    const auto& old = before.scene.instances;
    const auto isOfLink = [&](const Instance& part) { return part.element == trace.element; };
    auto left =
        std::count_if(old.begin(), old.begin() + static_cast<std::ptrdiff_t>(trace.point.instance), isOfLink);
    const auto& now = m_stage->scene.instances;
    auto found = std::find_if(now.begin(), now.end(), isOfLink);
    if (found == now.end()) continue;
    for (auto next = found; left > 0 && next != now.end(); --left) {
      next = std::find_if(next + 1, now.end(), isOfLink);
      if (next != now.end()) found = next;
    }
    if (trace.point.watcher) {
      trace.point.watcher = instance(old[*trace.point.watcher].element);
      if (!trace.point.watcher) continue;
    }
    trace.point.instance = static_cast<std::size_t>(found - now.begin());
    trace.path = pathOf(trace.point);
    kept.push_back(std::move(trace));
  }
  if (kept.empty() && m_view.traces.empty()) return;
  m_view.traces = std::move(kept);
  emit optionsChanged();
}

/// Empty where nothing moves.
TracedPath Viewer::pathOf(const TracedPoint& point) const {
  if (!m_stage->place || m_stage->inputSpeeds.empty()) return {};
  std::vector<double> start = m_view.turned;
  start.resize(m_stage->inputSpeeds.size(), 0);
  double duration = m_stage->period > 0 ? m_stage->period : kTraceWithoutPeriod;
  const StageRange range = m_stage->range ? m_stage->range(start) : StageRange();
  if (std::isfinite(range.from.time)) {
    for (std::size_t k = 0; k < start.size(); ++k) start[k] += m_stage->inputSpeeds[k] * range.from.time;
    duration = std::min(duration, range.to.time - range.from.time);
  } else {
    duration = std::min(duration, range.to.time);
  }
  return tracedPath(*m_stage, point, start, duration);
}

void Viewer::setTime(double seconds) {
  m_view.time = seconds;
  place();
}

void Viewer::setTurnedByHand(std::vector<double> angles) {
  m_view.turned = std::move(angles);
  place();
  emit turnedByHandChanged();
}

std::optional<std::size_t> Viewer::instance(const std::optional<ElementId>& link) const {
  return m_stage == nullptr ? std::nullopt : instanceOf(*m_stage, link);
}

void Viewer::place() {
  if (m_stage == nullptr) return;
  if (m_stage->place) m_view.turned.resize(m_stage->inputSpeeds.size(), 0);
  if (m_view.pulledApart > 0 && m_separations.empty()) m_separations = separations(*m_stage);
  m_seen = seenPoses(*m_stage, m_view, m_separations);
  m_floor = floorOf(m_stage->scene, m_separations, m_view.pulledApart);
  renewMarks();
  emit viewChanged();
}

void Viewer::renewMarks() {
  m_marks.clear();
  if (m_stage != nullptr && !m_seen.poses.empty()) m_marks = seenLines(*m_stage, m_view, m_seen, cut());
}

void Viewer::setOptions(const ViewOptions& options) {
  if (options == m_options) return;
  const bool otherSize = (options.pulledApart > 0) != (m_options.pulledApart > 0);
  m_options = options;
  m_view.look.faces = options.faces;
  m_view.section = options.section;
  m_view.pulledApart = options.pulledApart;
  m_view.marks = options.marks;
  renewShowing();
  place();
  if (otherSize) fitNow();
  emit optionsChanged();
}

void Viewer::rideAlong(const std::optional<ElementId>& link) {
  if (link == m_view.ridden || (link && !instance(link))) return;
  m_view.ridden = link;
  place();
  emit optionsChanged();
}

void Viewer::setHidden(std::set<ElementId> links) {
  if (links == m_view.hidden) return;
  m_view.hidden = std::move(links);
  renewShowing();
  emit viewChanged();
  emit optionsChanged();
}

std::optional<Eigen::Vector3d> Viewer::axisOf(const ElementId& link) const {
  const auto part = instance(link);
  if (!part || *part >= m_stage->handles.size() || m_stage->handles[*part].gains.empty()) {
    return std::nullopt;
  }
  const Eigen::Matrix3d turned =
      m_seen.poses[*part].linear() * m_stage->scene.instances[*part].pose.linear().transpose();
  return turned * m_stage->handles[*part].direction;
}

bool Viewer::trace(const Hit& hit) {
  if (m_stage == nullptr || !m_stage->place || m_stage->inputSpeeds.empty()) return false;
  const TracedPoint point{hit.instance, m_seen.poses[hit.instance].inverse() * hit.point,
                          instance(m_view.ridden)};
  m_view.traces.push_back({hit.element, point, pathOf(point)});
  place();
  emit optionsChanged();
  return true;
}

void Viewer::clearTraces() {
  if (m_view.traces.empty()) return;
  m_view.traces.clear();
  place();
  emit optionsChanged();
}

// The pointer's way along the circle of the held point, as the picture shows it, is the angle; where the
// circle is seen from its edge, a small part of its radius stands for it, so that the part does not spin
// away.
void Viewer::turn(const QPointF& step) {
  const StageHandle& handle = m_stage->handles[m_held->instance];
  double strength = 0;
  for (const double gain : handle.gains) strength += gain * gain;
  if (strength == 0) return;
  const auto displacement = [this] {
    return m_seen.poses[m_held->instance] * m_stage->scene.instances[m_held->instance].pose.inverse();
  };
  const Pose before = displacement();
  const Eigen::Vector3d axis = before.linear() * handle.direction, origin = before * handle.point;
  const Eigen::Vector3d along = axis.cross(m_held->point - origin);  // of the held point, a rad
  const double pixels = 1 / m_view.camera.millimetresPerPixel(m_viewport);
  const Eigen::Vector2d seen =
      pixels * Eigen::Vector2d(along.dot(m_view.camera.right()), -along.dot(m_view.camera.up()));
  const double least = 0.2 * pixels * along.norm();
  const Eigen::Vector2d moved(step.x() * m_pixelRatio, step.y() * m_pixelRatio);
  const double size = std::max(seen.squaredNorm(), least * least);
  if (size == 0) return;
  const double angle = moved.dot(seen) / size;
  std::vector<double> turned = m_view.turned;
  for (std::size_t k = 0; k < turned.size(); ++k) turned[k] += handle.gains[k] * angle / strength;
  if (m_stage->beyondLimits) {
    StageView next = m_view;
    next.turned = turned;
    const std::string joint = m_stage->beyondLimits(inputAngles(*m_stage, next));
    if (!joint.empty()) return emit limitReached(QString::fromStdString(joint));
  }
  setTurnedByHand(std::move(turned));
  m_held->point = displacement() * before.inverse() * m_held->point;
}

void Viewer::setCamera(const Camera& camera) {
  m_isCameraChosen = true;
  if (camera == m_view.camera) return;
  m_view.camera = camera;
  emit cameraChanged();
  emit viewChanged();
}

void Viewer::showFrom(StandardView view) {
  setCamera(m_view.camera.turnedTo(view));
  fit();
}

void Viewer::fit() {
  fitNow();
  m_isCameraChosen = m_isCameraChosen || m_fitted;
}

void Viewer::fitNow() {
  if (m_stage == nullptr || m_stage->scene.instances.empty() || m_viewport.width < 2) return;
  if (!m_outlines) m_outlines = solidOutlines(m_stage->scene);
  std::vector<Eigen::Vector3d> points;
  for (std::size_t i = 0; i < m_seen.poses.size(); ++i) {
    for (const Eigen::Vector3d& point : (*m_outlines)[m_stage->scene.instances[i].solid])
      points.push_back(m_seen.poses[i] * point);
  }
  m_fitted = true;
  const bool wasChosen = m_isCameraChosen;
  setCamera(m_view.camera.fitted(points, m_viewport, 0.13));
  m_isCameraChosen = wasChosen;
}

void Viewer::setLook(const Look& look) {
  m_view.look = look;
  m_view.look.faces = m_options.faces;
  renewMarks();
  emit viewChanged();
}

// In motion a train stands elsewhere than when it was fitted: a bar that comes or goes above the view would
// make it jump. Another width is somebody's wish.
void Viewer::setViewport(const Viewport& viewport, double pixelRatio) {
  const bool sameWidth = viewport.width == m_viewport.width;
  m_viewport = viewport;
  m_pixelRatio = pixelRatio;
  if (!m_fitted || !(m_isCameraChosen || (m_isRunning && sameWidth))) fitNow();
}

std::optional<CutPlane> Viewer::cut() const {
  if (!m_view.section || m_stage == nullptr) return std::nullopt;
  if (!m_bounds) m_bounds = boundsOf(m_stage->scene);
  return cutPlane(*m_bounds, m_seen.poses, m_view.section);
}

Frame Viewer::frame(bool quick) const {
  Frame frame;
  frame.viewport = m_viewport;
  frame.pixelRatio = m_pixelRatio;
  frame.camera = m_view.camera;
  frame.look = quick ? m_view.look.cheaper() : m_view.look;
  frame.poses = m_seen.poses;
  frame.emphasis = m_emphasis;
  frame.showing = m_showing;
  frame.section = cut();
  frame.floor = m_floor;
  frame.marks = m_marks;
  return frame;
}

void Viewer::lightUpHovered() {
  if (m_pictureCost > kHalfFrame) return m_whenHandRests.start();
  lightUp();
}

void Viewer::lightUp() {
  std::vector<Highlight> emphasis;
  if (m_stage != nullptr) {
    for (const Instance& instance : m_stage->scene.instances) {
      const auto any = [&](auto holds) {
        return holds(instance.element) || std::any_of(instance.also.begin(), instance.also.end(), holds);
      };
      const bool selected =
          any([this](const ElementId& element) { return m_selection->isSelected(element); });
      const bool hovered = any([this](const ElementId& element) { return m_selection->isHovered(element); });
      emphasis.push_back(selected ? Highlight::selected : hovered ? Highlight::hovered : Highlight::none);
    }
  }
  if (emphasis == m_emphasis && m_showing.size() == emphasis.size()) return;
  m_emphasis = std::move(emphasis);
  renewShowing();
  emit viewChanged();
}

void Viewer::renewShowing() {
  m_showing.assign(m_emphasis.size(), Showing::solid);
  const bool isChosen = m_options.ghostOthers && std::find(m_emphasis.begin(), m_emphasis.end(),
                                                           Highlight::selected) != m_emphasis.end();
  for (std::size_t i = 0; i < m_showing.size(); ++i) {
    if (m_view.hidden.contains(m_stage->scene.instances[i].element)) {
      m_showing[i] = Showing::hidden;
    } else if (isChosen && m_emphasis[i] != Highlight::selected) {
      m_showing[i] = Showing::ghost;
    }
  }
}

std::optional<Hit> Viewer::hitAt(const QPointF& place) const {
  if (!m_pick || m_stage == nullptr) return std::nullopt;
  return m_pick(frame(true), place.x() * m_pixelRatio, place.y() * m_pixelRatio);
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
  const bool shifted = event.modifiers().testFlag(Qt::ShiftModifier);
  m_held.reset();
  if (event.button() == Qt::LeftButton && event.modifiers().testFlag(Qt::ControlModifier))
    m_held = hitAt(event.position());
  const bool turns = m_held && m_held->instance < m_stage->handles.size() &&
                     !m_stage->handles[m_held->instance].gains.empty();
  if (turns) {
    m_gesture = Gesture::turn;
  } else if (event.button() == Qt::RightButton || (event.button() == Qt::LeftButton && shifted)) {
    m_gesture = Gesture::pan;
  } else if (event.button() == Qt::LeftButton || event.button() == Qt::MiddleButton) {
    m_gesture = Gesture::orbit;
  } else {
    return false;
  }
  m_pressedAt = m_last = event.position();
  m_dragged = false;
  return true;
}

bool Viewer::mouseMove(const QMouseEvent& event) {
  if (m_gesture == Gesture::none) {
    const auto hit = hitAt(event.position());
    hit ? m_selection->hover(hit->element) : m_selection->unhover();
    return true;
  }
  if (!m_dragged) {
    const QPointF away = event.position() - m_pressedAt;
    if (away.manhattanLength() < QApplication::startDragDistance() / 2.0) return true;
    m_dragged = true;
  }
  const QPointF step = event.position() - m_last;
  m_last = event.position();
  emit moving();
  if (m_gesture == Gesture::turn) {
    turn(step);
    return true;
  }
  setCamera(m_gesture == Gesture::orbit
                ? m_view.camera.orbited(step.x(), step.y())
                : m_view.camera.panned(step.x() * m_pixelRatio, step.y() * m_pixelRatio, m_viewport));
  return true;
}

bool Viewer::mouseRelease(const QMouseEvent& event) {
  if (m_gesture == Gesture::none || event.buttons() != Qt::NoButton) return false;
  m_gesture = Gesture::none;
  if (!m_dragged && event.button() == Qt::RightButton)
    emit menuWanted(hitAt(event.position()), event.position());
  if (m_dragged || event.button() != Qt::LeftButton) return true;
  const auto hit = hitAt(event.position());
  if (event.modifiers().testFlag(Qt::ControlModifier)) {
    if (hit) m_selection->toggle(hit->element);
  } else {
    hit ? m_selection->select({hit->element}) : m_selection->clear();
  }
  return true;
}

void Viewer::zoomAt(const QPointF& place, double factor) {
  const double x = place.x() * m_pixelRatio, y = place.y() * m_pixelRatio;
  const auto hit = hitAt(place);
  setCamera(m_view.camera.zoomed(factor, hit ? hit->point : m_view.camera.atTargetDepth(x, y, m_viewport)));
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
         std::clamp(std::pow(kZoomPerNotch, notches), 1 / kMostZoomPerEvent, kMostZoomPerEvent));
  return true;
}

bool Viewer::nativeGesture(const QNativeGestureEvent& event) {
  if (event.gestureType() != Qt::ZoomNativeGesture) return false;
  emit moving();
  zoomAt(event.position(), std::clamp(1 + event.value(), 1 / kMostZoomPerEvent, kMostZoomPerEvent));
  return true;
}

bool Viewer::keyPress(const QKeyEvent& event) {
  const QPointF middle(0.5 * m_viewport.width / m_pixelRatio, 0.5 * m_viewport.height / m_pixelRatio);
  switch (event.key()) {
    case Qt::Key_Left:
      setCamera(m_view.camera.orbited(-kKeyPixels, 0));
      return true;
    case Qt::Key_Right:
      setCamera(m_view.camera.orbited(kKeyPixels, 0));
      return true;
    case Qt::Key_Up:
      setCamera(m_view.camera.orbited(0, -kKeyPixels));
      return true;
    case Qt::Key_Down:
      setCamera(m_view.camera.orbited(0, kKeyPixels));
      return true;
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
  if (m_gesture == Gesture::none) m_selection->unhover();
}

}  // namespace geargraph::inline view3d

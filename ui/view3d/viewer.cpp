#include "ui/view3d/viewer.h"

#include <QApplication>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QNativeGestureEvent>
#include <QPointingDevice>
#include <QWheelEvent>
#include <algorithm>
#include <cmath>

#include "core/base/contract.h"
#include "core/render/exploded.h"

namespace geargraph {
namespace {

constexpr double kZoomPerNotch = 1.15;
constexpr double kMostZoomPerEvent = 4;
constexpr double kKeyPixels = 32;  // an arrow key turns as far as a drag by so many pixels
constexpr double kHalfFrame = 8;   // ms
constexpr int kHandRests = 150;    // ms

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
  m_stage = std::move(stage);
  m_poses.clear();
  m_separations.clear();
  m_bounds = {};
  if (m_stage != nullptr) {
    for (const Instance& instance : m_stage->scene.instances) m_poses.push_back(instance.pose);
    m_separations = separations(*m_stage);
    m_bounds = boundsOf(m_stage->scene);
  }
  m_traces.clear();
  if (!instanceOf(m_ridden)) m_ridden.reset();
  if (m_gesture == Gesture::turn) m_gesture = Gesture::none;  // what was held is gone
  if (m_stage == nullptr || m_turned.size() != m_stage->inputSpeeds.size()) m_turned.clear();
  if (first) m_fitted = false;
  emit sceneChanged();
  lightUp();
  place();
  emit viewChanged();
  if (!m_fitted) fit();
}

void Viewer::setTime(double seconds) {
  m_time = seconds;
  place();
}

void Viewer::setTurnedByHand(std::vector<double> angles) {
  m_turned = std::move(angles);
  place();
}

std::vector<double> Viewer::angles() const {
  std::vector<double> angles;
  for (std::size_t k = 0; k < m_turned.size(); ++k)
    angles.push_back(m_stage->inputSpeeds[k] * m_time + m_turned[k]);
  return angles;
}

std::optional<std::size_t> Viewer::instanceOf(const std::optional<ElementId>& link) const {
  if (m_stage == nullptr || !link) return std::nullopt;
  const auto& instances = m_stage->scene.instances;
  const auto found = std::find_if(instances.begin(), instances.end(),
                                  [&](const Instance& instance) { return instance.element == *link; });
  if (found == instances.end()) return std::nullopt;
  return static_cast<std::size_t>(found - instances.begin());
}

void Viewer::place() {
  if (m_stage == nullptr) return;
  const Scene& scene = m_stage->scene;
  if (m_stage->place) {
    m_turned.resize(m_stage->inputSpeeds.size(), 0);
    m_stage->place(angles(), m_poses);
  } else {
    for (std::size_t i = 0; i < m_poses.size(); ++i) m_poses[i] = scene.instances[i].pose;
  }
  m_ground = Pose::Identity();
  if (const auto ridden = instanceOf(m_ridden)) {
    m_ground = scene.instances[*ridden].pose * m_poses[*ridden].inverse();
    for (Pose& pose : m_poses) pose = m_ground * pose;
  }
  pullApart(scene, m_separations, m_options.pulledApart, m_poses);
  renewMarks();
  emit viewChanged();
}

void Viewer::renewMarks() {
  m_marks.clear();
  if (m_stage == nullptr || m_poses.empty()) return;
  const bool isDark = m_look.letters.red > 0.5F;
  const std::vector<double> now = angles();
  const Moment moment{m_poses,        now,
                      m_ground,       instanceOf(m_ridden),
                      m_look.letters, Rgb::fromHex(isDark ? 0xFF8FC7 : 0xB0126B)};
  m_marks = stageLines(*m_stage, m_options.marks, moment);
  for (const ShownTrace& trace : m_traces) {
    const Instance& instance = m_stage->scene.instances[trace.point.instance];
    const auto watcher = instanceOf(m_ridden);
    if (watcher != trace.point.watcher) continue;  // it was drawn in another frame
    m_marks.push_back({trace.path.points, instance.colour, 2.4F, false});
    const Eigen::Vector3d at = m_poses[trace.point.instance] * trace.point.place;
    for (int axis = 0; axis < 3; ++axis) {
      const Eigen::Vector3d arm = 0.018 * m_bounds.radius() * Eigen::Vector3d::Unit(axis);
      m_marks.push_back({{at - arm, at + arm}, moment.motion, 2.4F, false});
    }
  }
}

void Viewer::setOptions(const ViewOptions& options) {
  if (options == m_options) return;
  m_options = options;
  m_look.faces = options.faces;
  renewShowing();
  place();
  emit optionsChanged();
}

void Viewer::rideAlong(const std::optional<ElementId>& link) {
  if (link == m_ridden || (link && !instanceOf(link))) return;
  m_ridden = link;
  place();
  emit optionsChanged();
}

void Viewer::setHidden(std::set<ElementId> links) {
  if (links == m_hidden) return;
  m_hidden = std::move(links);
  renewShowing();
  emit viewChanged();
  emit optionsChanged();
}

std::optional<Eigen::Vector3d> Viewer::axisOf(const ElementId& link) const {
  const auto instance = instanceOf(link);
  if (!instance || *instance >= m_stage->handles.size() || m_stage->handles[*instance].gains.empty()) {
    return std::nullopt;
  }
  const Eigen::Matrix3d turned =
      m_poses[*instance].linear() * m_stage->scene.instances[*instance].pose.linear().transpose();
  return turned * m_stage->handles[*instance].direction;
}

bool Viewer::trace(const Hit& hit, double seconds) {
  if (m_stage == nullptr || !m_stage->place || m_stage->inputSpeeds.empty()) return false;
  const TracedPoint point{hit.instance, m_poses[hit.instance].inverse() * hit.point, instanceOf(m_ridden)};
  const double span = m_stage->period > 0 ? m_stage->period : seconds;
  m_traces.push_back({hit.element, point, tracedPath(*m_stage, point, m_turned, span)});
  place();
  emit optionsChanged();
  return true;
}

void Viewer::clearTraces() {
  if (m_traces.empty()) return;
  m_traces.clear();
  place();
  emit optionsChanged();
}

std::optional<CutPlane> Viewer::section() const {
  if (!m_options.section || m_bounds.box.isEmpty()) return std::nullopt;
  const SectionChoice& choice = *m_options.section;
  Eigen::AlignedBox3d box = m_bounds.box;
  for (std::size_t i = 0; i < m_poses.size(); ++i) {  // pulled apart, the train is longer
    box.extend(Eigen::Vector3d(m_poses[i].translation()));
  }
  const double low = box.min()[choice.axis], high = box.max()[choice.axis];
  // What stands before the viewer of the standard views goes first: front looks along +y, right along -x.
  const double sense = (choice.axis == 1) != choice.isTurned ? -1 : 1;
  CutPlane section;
  section.normal = sense * Eigen::Vector3d::Unit(choice.axis);
  section.offset = sense * (low + choice.place * (high - low));
  return section;
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
    return m_poses[m_held->instance] * m_stage->scene.instances[m_held->instance].pose.inverse();
  };
  const Pose before = displacement();
  const Eigen::Vector3d axis = before.linear() * handle.direction, origin = before * handle.point;
  const Eigen::Vector3d along = axis.cross(m_held->point - origin);  // of the held point, a rad
  const double pixels = 1 / m_camera.millimetresPerPixel(m_viewport);
  const Eigen::Vector2d seen =
      pixels * Eigen::Vector2d(along.dot(m_camera.right()), -along.dot(m_camera.up()));
  const double least = 0.2 * pixels * along.norm();
  const Eigen::Vector2d moved(step.x() * m_pixelRatio, step.y() * m_pixelRatio);
  const double size = std::max(seen.squaredNorm(), least * least);
  if (size == 0) return;
  const double angle = moved.dot(seen) / size;
  std::vector<double> turned = m_turned;
  for (std::size_t k = 0; k < turned.size(); ++k) turned[k] += handle.gains[k] * angle / strength;
  setTurnedByHand(std::move(turned));
  m_held->point = displacement() * before.inverse() * m_held->point;
}

void Viewer::setCamera(const Camera& camera) {
  if (camera == m_camera) return;
  m_camera = camera;
  emit cameraChanged();
  emit viewChanged();
}

void Viewer::showFrom(StandardView view) {
  setCamera(m_camera.turnedTo(view));
  fit();
}

void Viewer::fit() {
  if (m_stage == nullptr || m_stage->scene.instances.empty() || m_viewport.width < 2) return;
  Scene now{m_stage->scene.solids, m_stage->scene.instances};
  for (std::size_t i = 0; i < m_poses.size(); ++i) now.instances[i].pose = m_poses[i];
  m_fitted = true;
  setCamera(m_camera.fitted(cornersOf(now), m_viewport, 0.09));
}

void Viewer::setLook(const Look& look) {
  m_look = look;
  m_look.faces = m_options.faces;
  renewMarks();
  emit viewChanged();
}

void Viewer::setViewport(const Viewport& viewport, double pixelRatio) {
  m_viewport = viewport;
  m_pixelRatio = pixelRatio;
  if (!m_fitted) fit();
}

Frame Viewer::frame(bool quick) const {
  Frame frame;
  frame.viewport = m_viewport;
  frame.pixelRatio = m_pixelRatio;
  frame.camera = m_camera;
  frame.look = quick ? m_look.cheaper() : m_look;
  frame.poses = m_poses;
  frame.emphasis = m_emphasis;
  frame.showing = m_showing;
  frame.section = section();
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
    if (m_hidden.contains(m_stage->scene.instances[i].element)) {
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
                ? m_camera.orbited(step.x(), step.y())
                : m_camera.panned(step.x() * m_pixelRatio, step.y() * m_pixelRatio, m_viewport));
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
  setCamera(m_camera.zoomed(factor, hit ? hit->point : m_camera.atTargetDepth(x, y, m_viewport)));
}

bool Viewer::wheel(const QWheelEvent& event) {
  const bool isPad =
      event.device() != nullptr && event.device()->type() == QInputDevice::DeviceType::TouchPad;
  if (isPad && !event.modifiers().testFlag(Qt::ControlModifier)) {
    const QPointF step = event.pixelDelta().isNull() ? QPointF(event.angleDelta()) / 8 : event.pixelDelta();
    emit moving();
    setCamera(m_camera.panned(step.x() * m_pixelRatio, step.y() * m_pixelRatio, m_viewport));
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
      setCamera(m_camera.orbited(-kKeyPixels, 0));
      return true;
    case Qt::Key_Right:
      setCamera(m_camera.orbited(kKeyPixels, 0));
      return true;
    case Qt::Key_Up:
      setCamera(m_camera.orbited(0, -kKeyPixels));
      return true;
    case Qt::Key_Down:
      setCamera(m_camera.orbited(0, kKeyPixels));
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

}  // namespace geargraph

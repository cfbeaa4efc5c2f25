#include "ui/view3d/viewer.h"

#include <QApplication>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QWheelEvent>
#include <algorithm>
#include <cmath>

#include "core/base/contract.h"

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
  if (m_stage != nullptr) {
    for (const Instance& instance : m_stage->scene.instances) m_poses.push_back(instance.pose);
  }
  if (m_gesture == Gesture::turn) m_gesture = Gesture::none;  // what was held is gone
  if (m_stage == nullptr || m_turned.size() != m_stage->inputSpeeds.size()) m_turned.clear();
  if (first) m_fitted = false;
  emit sceneChanged();
  lightUp();
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

void Viewer::place() {
  if (m_stage == nullptr || !m_stage->place) return;
  m_turned.resize(m_stage->inputSpeeds.size(), 0);
  std::vector<double> angles;
  for (std::size_t k = 0; k < m_turned.size(); ++k)
    angles.push_back(m_stage->inputSpeeds[k] * m_time + m_turned[k]);
  m_stage->place(angles, m_poses);
  emit viewChanged();
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
  return frame;
}

void Viewer::lightUpHovered() {
  if (m_pictureCost > kHalfFrame) return m_whenHandRests.start();
  lightUp();
}

void Viewer::lightUp() {
  std::vector<Emphasis> emphasis;
  if (m_stage != nullptr) {
    for (const Instance& instance : m_stage->scene.instances) {
      const auto any = [&](auto holds) {
        return holds(instance.element) || std::any_of(instance.also.begin(), instance.also.end(), holds);
      };
      const bool selected =
          any([this](const ElementId& element) { return m_selection->isSelected(element); });
      const bool hovered = any([this](const ElementId& element) { return m_selection->isHovered(element); });
      emphasis.push_back(selected ? Emphasis::selected : hovered ? Emphasis::hovered : Emphasis::none);
    }
  }
  if (emphasis == m_emphasis) return;
  m_emphasis = std::move(emphasis);
  emit viewChanged();
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
  const double notches = event.angleDelta().y() / 120.0;
  if (notches == 0) return false;
  emit moving();
  zoomAt(event.position(),
         std::clamp(std::pow(kZoomPerNotch, notches), 1 / kMostZoomPerEvent, kMostZoomPerEvent));
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

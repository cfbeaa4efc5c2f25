#include "ui/view3d/viewer.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/foundations/base/contract.h"
#include "core/presentation/scene3d/exploded.h"

namespace geargraph {
namespace {

constexpr double kHalfFrame = 8;            // ms
constexpr int kHandRests = 150;             // ms
constexpr double kTraceWithoutPeriod = 60;  // s

}  // namespace

Viewer::Viewer(Selection* selection, QObject* parent)
    : QObject(parent),
      m_selection(selection),
      m_paths(new Service<PathsRequest, std::vector<TracedPath>>(
          [](const PathsRequest& request, const auto& respond) {
            std::vector<TracedPath> paths;
            for (const TracedPoint& point : request.points)
              paths.push_back(pathOf(point, request, respond.stop()));
            respond(std::move(paths));
          },
          this)) {
  m_paths->onAnswer(this, [this](const std::vector<TracedPath>& paths) { showPaths(paths); });
  m_whenHandRests.setSingleShot(true);
  m_whenHandRests.setInterval(kHandRests);
  connect(&m_whenHandRests, &QTimer::timeout, this, &Viewer::updateHighlight);
  connect(selection, &Selection::selectionChanged, this, &Viewer::updateHighlight);
  connect(selection, &Selection::hoverChanged, this, &Viewer::updateHoverHighlight);
}

void Viewer::setScene(MechanismScenePtr stage) {
  const bool first = m_stage == nullptr || m_stage->scene.instances.empty();
  const MechanismScenePtr before = std::exchange(m_stage, std::move(stage));
  m_seen = {};
  m_explosionOffsets.clear();
  m_outlines.reset();
  m_bounds.reset();
  if (m_stage != nullptr) {
    for (const Instance& instance : m_stage->scene.instances) m_seen.poses.push_back(instance.pose);
  }
  if (!instance(m_view.referenceLink)) m_view.referenceLink.reset();
  if (m_gesture == Gesture::turn) m_gesture = Gesture::none;  // what was held is gone
  if (m_stage == nullptr || m_view.turned.size() != m_stage->inputSpeeds.size()) m_view.turned.clear();
  if (before != nullptr && m_stage != nullptr) updateTraces(*before);
  const bool isEmpty = m_stage == nullptr || m_stage->scene.instances.empty();
  if (first || (m_isAnew && !isEmpty)) m_fitted = false;
  emit sceneChanged();
  updateHighlight();
  place();
  emit viewChanged();
  if (isEmpty) return;
  if (m_isAnew && m_opening) {
    setCamera(*m_opening);
    m_fitted = true;
  }
  if (!m_fitted || (!m_isCameraChosen && !isAllInside())) fitNow();  // the camera follows growth
  m_isAnew = false;
  m_opening.reset();
}

void Viewer::startAnew(const std::optional<Camera>& camera) {
  m_isAnew = true;
  dropQuestions();
  m_opening = camera;
  m_isCameraChosen = camera.has_value();
  m_view.traces.clear();
  m_paths->cancel();
  m_view.turned.clear();
  m_view.hidden.clear();
  m_view.referenceLink.reset();
  if (!camera) m_view.camera = Camera::home();
  emit optionsChanged();
}

// A part is found again by its place among those of its link.
void Viewer::updateTraces(const MechanismScene& before) {
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
    kept.push_back(std::move(trace));
  }
  if (kept.empty() && m_view.traces.empty()) return;
  m_view.traces = std::move(kept);
  requestPaths();
  emit optionsChanged();
}

void Viewer::requestPaths() {
  if (m_view.traces.empty()) return m_paths->cancel();
  PathsRequest request{m_stage, {}, m_view.turned, {}};
  for (const ShownTrace& trace : m_view.traces) request.points.push_back(trace.point);
  request.start.resize(m_stage->inputSpeeds.size(), 0);
  if (trajectoryOf(*m_stage, m_view) != nullptr) request.trajectory = m_view.trajectory;
  m_paths->request(std::move(request));
}

void Viewer::showPaths(const std::vector<TracedPath>& paths) {
  for (std::size_t i = 0; i < m_view.traces.size(); ++i) m_view.traces[i].path = paths[i];
  place();
  emit optionsChanged();
  if (std::exchange(m_isTraceNew, false)) emit traced(m_view.traces.back().path);
}

/// Empty where nothing moves.
TracedPath Viewer::pathOf(const TracedPoint& point, const PathsRequest& request,
                          const std::stop_token& stop) {
  const MechanismScene& stage = *request.stage;
  if (!stage.place || stage.inputSpeeds.empty()) return {};
  std::vector<double> start = request.start;
  const InputTrajectory* const trajectory = request.trajectory.get();
  if (trajectory != nullptr && trajectory->seconds() > 0)
    return tracedPath(stage, point, start, trajectory->seconds(), trajectory, stop);
  double duration = stage.period > 0 ? stage.period : kTraceWithoutPeriod;
  const SceneRange range = stage.range ? stage.range(start) : SceneRange();
  if (std::isfinite(range.from.time)) {
    for (std::size_t k = 0; k < start.size(); ++k) start[k] += stage.inputSpeeds[k] * range.from.time;
    duration = std::min(duration, range.to.time - range.from.time);
  } else {
    duration = std::min(duration, range.to.time);
  }
  return tracedPath(stage, point, start, duration, nullptr, stop);
}

void Viewer::setTime(double seconds) {
  m_view.time = seconds;
  place();
}

void Viewer::setTrajectory(InputTrajectoryPtr trajectory) {
  if (trajectory == m_view.trajectory) return;
  m_view.trajectory = std::move(trajectory);
  if (m_stage == nullptr) return;
  requestPaths();
  place();
  emit optionsChanged();
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
  if (m_view.explosion > 0 && m_explosionOffsets.empty()) m_explosionOffsets = explosionOffsets(*m_stage);
  m_seen = seenPoses(*m_stage, m_view, m_explosionOffsets);
  m_floor = floorOf(m_stage->scene, m_explosionOffsets, m_view.explosion);
  updateMarks();
  emit viewChanged();
}

void Viewer::updateMarks() {
  m_marks.clear();
  if (m_stage != nullptr && !m_seen.poses.empty()) m_marks = seenLines(*m_stage, m_view, m_seen, cut());
}

void Viewer::setOptions(const ViewOptions& options) {
  if (options == m_options) return;
  const bool otherSize = (options.explosion > 0) != (m_options.explosion > 0);
  m_options = options;
  m_view.style.faces = options.faces;
  m_view.section = options.section;
  m_view.explosion = options.explosion;
  m_view.marks = options.marks;
  updateVisibility();
  place();
  if (otherSize) fitNow();
  emit optionsChanged();
}

void Viewer::fixReferenceFrame(const std::optional<ElementId>& link) {
  if (link == m_view.referenceLink || (link && !instance(link))) return;
  m_view.referenceLink = link;
  place();
  emit optionsChanged();
}

void Viewer::setHidden(std::set<ElementId> links) {
  if (links == m_view.hidden) return;
  m_view.hidden = std::move(links);
  updateVisibility();
  emit viewChanged();
  emit optionsChanged();
}

void Viewer::setForces(SceneForces forces, const QString& caption) {
  if (forces == m_view.forces && caption == m_forcesCaption) return;
  m_view.forces = std::move(forces);
  m_forcesCaption = caption;
  if (!m_options.marks.forces) return;
  updateMarks();
  emit viewChanged();
}

ShownForces Viewer::shownForces() const {
  ShownForces shown;
  if (m_stage == nullptr || m_seen.poses.empty() || !m_view.marks.forces) return shown;
  shown.caption = m_forcesCaption;
  if (!m_view.forces) return shown;
  shown.forces = m_view.forces;
  shown.arrows = seenForces(*m_stage, m_view, m_seen);
  shown.highlighted = m_selection->hovered();
  shown.highlighted.insert(m_selection->selected().begin(), m_selection->selected().end());
  shown.areLabelsShared = m_areLabelsShared;
  return shown;
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
                          instance(m_view.referenceLink)};
  m_view.traces.push_back({hit.element, point, {}});
  m_isTraceNew = true;
  requestPaths();
  emit optionsChanged();
  return true;
}

void Viewer::clearTraces() {
  if (m_view.traces.empty()) return;
  m_view.traces.clear();
  m_paths->cancel();
  place();
  emit optionsChanged();
}

// The pointer's way along the circle of the held point, as the picture shows it, is the angle; where the
// circle is seen from its edge, a small part of its radius stands for it, so that the part does not spin
// away.
/// rad/s that the part turns by, or lengths a second that it slides by, as the inputs run, against what
/// carries it.
double Viewer::rateOf(std::size_t instance) const {
  const SceneHandle& handle = m_stage->handles[instance];
  double rate = 0;
  for (std::size_t k = 0; k < handle.gains.size() && k < m_stage->inputSpeeds.size(); ++k)
    rate += handle.gains[k] * m_stage->inputSpeeds[k];
  return rate;
}

Pose Viewer::displacementOf(std::size_t instance) const {
  return m_seen.poses[instance] * m_stage->scene.instances[instance].pose.inverse();
}

/// How far the part turns or slides so that the held point follows the pointer as nearly as it can; none
/// where that cannot be told.
std::optional<double> Viewer::angleOf(const Hit& held, const QPointF& step) const {
  const SceneHandle& handle = m_stage->handles[held.instance];
  const Pose before = displacementOf(held.instance);
  const Eigen::Vector3d axis = before.linear() * handle.direction, origin = before * handle.point;
  // Of the held point, a rad or a length.
  const Eigen::Vector3d along = handle.slides ? axis : axis.cross(held.point - origin);
  const double pixels = 1 / m_view.camera.millimetresPerPixel(m_viewport);
  const Eigen::Vector2d seen =
      pixels * Eigen::Vector2d(along.dot(m_view.camera.right()), -along.dot(m_view.camera.up()));
  const double least = 0.2 * pixels * along.norm();
  const Eigen::Vector2d moved(step.x() * m_pixelRatio, step.y() * m_pixelRatio);
  const double size = std::max(seen.squaredNorm(), least * least);
  if (size == 0) return std::nullopt;
  return moved.dot(seen) / size;
}

void Viewer::runTo(Hit& held, const QPointF& step) {
  const std::optional<double> angle = angleOf(held, step);
  if (!angle) return;
  const Pose before = displacementOf(held.instance);
  emit timeWanted(m_view.time + *angle / rateOf(held.instance));
  held.point = displacementOf(held.instance) * before.inverse() * held.point;
}

void Viewer::turn(Hit& held, const QPointF& step) {
  const SceneHandle& handle = m_stage->handles[held.instance];
  double strength = 0;
  for (const double gain : handle.gains) strength += gain * gain;
  const std::optional<double> angle = angleOf(held, step);
  if (strength == 0 || !angle) return;
  const Pose before = displacementOf(held.instance);
  std::vector<double> turned = m_view.turned;
  for (std::size_t k = 0; k < turned.size(); ++k) turned[k] += handle.gains[k] * *angle / strength;
  if (m_stage->beyondLimits) {
    SceneView next = m_view;
    next.turned = turned;
    const std::string joint = m_stage->beyondLimits(inputAngles(*m_stage, next));
    if (!joint.empty()) return emit limitReached(QString::fromStdString(joint));
  }
  setTurnedByHand(std::move(turned));
  held.point = displacementOf(held.instance) * before.inverse() * held.point;
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

/// Of every part as it stands now. @pre there is a stage
std::vector<Eigen::Vector3d> Viewer::outlinePoints() {
  if (!m_outlines) m_outlines = solidOutlines(m_stage->scene);
  std::vector<Eigen::Vector3d> points;
  for (std::size_t i = 0; i < m_seen.poses.size(); ++i) {
    for (const Eigen::Vector3d& point : (*m_outlines)[m_stage->scene.instances[i].solid])
      points.push_back(m_seen.poses[i] * point);
  }
  return points;
}

bool Viewer::isAllInside() {
  const std::vector<Eigen::Vector3d> points = outlinePoints();
  return std::all_of(points.begin(), points.end(), [this](const Eigen::Vector3d& point) {
    const ScreenPoint at = m_view.camera.project(point, m_viewport);
    return at.x >= 0 && at.y >= 0 && at.x <= m_viewport.width && at.y <= m_viewport.height;
  });
}

void Viewer::fitNow() {
  if (m_stage == nullptr || m_stage->scene.instances.empty() || m_viewport.width < 2) return;
  const std::vector<Eigen::Vector3d> points = outlinePoints();
  m_fitted = true;
  const bool wasChosen = m_isCameraChosen;
  setCamera(m_view.camera.fitted(points, m_viewport, 0.13));
  m_isCameraChosen = wasChosen;
}

void Viewer::setRenderStyle(const RenderStyle& style) {
  m_view.style = style;
  m_view.style.faces = m_options.faces;
  updateMarks();
  emit viewChanged();
}

// In motion a train stands elsewhere than when it was fitted: a bar that comes or goes above the view would
// make it jump. Another width is the user's choice.
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

Frame Viewer::frame(bool draft) const {
  Frame frame;
  frame.viewport = m_viewport;
  frame.pixelRatio = m_pixelRatio;
  frame.camera = m_view.camera;
  frame.style = draft ? m_view.style.cheaper() : m_view.style;
  frame.poses = m_seen.poses;
  frame.emphasis = m_emphasis;
  frame.visibility = m_visibility;
  frame.section = cut();
  frame.floor = m_floor;
  frame.marks = m_marks;
  return frame;
}

void Viewer::updateHoverHighlight() {
  if (m_pictureCost > kHalfFrame) return m_whenHandRests.start();
  updateHighlight();
}

void Viewer::updateHighlight() {
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
  if (emphasis == m_emphasis && m_visibility.size() == emphasis.size()) return;
  m_emphasis = std::move(emphasis);
  updateVisibility();
  emit viewChanged();
}

void Viewer::updateVisibility() {
  m_visibility.assign(m_emphasis.size(), Visibility::solid);
  const bool isChosen = m_options.translucentOthers && std::find(m_emphasis.begin(), m_emphasis.end(),
                                                                 Highlight::selected) != m_emphasis.end();
  for (std::size_t i = 0; i < m_visibility.size(); ++i) {
    if (m_view.hidden.contains(m_stage->scene.instances[i].element)) {
      m_visibility[i] = Visibility::hidden;
    } else if (isChosen && m_emphasis[i] != Highlight::selected) {
      m_visibility[i] = Visibility::translucent;
    }
  }
}

}  // namespace geargraph

#include "moc_viewer.cpp"

#include "core/presentation/scene3d/scene_view.h"

#include <algorithm>

#include "core/foundations/base/contract.h"
#include "core/presentation/scene3d/exploded.h"

namespace geargraph {
namespace {

constexpr double kCross = 0.018;  // of the scene's radius: half the size of a traced point's cross

/// The colour of what moves: arrows, traced points.
Rgb motionInk(const RenderStyle& style) {
  return Rgb::fromHex(style.letters.red > 0.5F ? 0xFF8FC7 : 0xB0126B);
}

void addTrace(std::vector<MarkLine>& lines, const MechanismScene& stage, const ShownTrace& trace,
              const SeenPoses& seen, const Rgb& ink) {
  const std::size_t instance = trace.point.instance;
  lines.push_back({trace.path.points, stage.scene.instances[instance].colour, 2.4F, false});
  const Eigen::Vector3d at = seen.poses[instance] * trace.point.place;
  const double size = kCross * boundsOf(stage.scene).radius();
  for (int axis = 0; axis < 3; ++axis) {
    const Eigen::Vector3d arm = size * Eigen::Vector3d::Unit(axis);
    lines.push_back({{at - arm, at + arm}, ink, 2.4F, false});
  }
}

}  // namespace

std::vector<double> inputAngles(const MechanismScene& stage, const SceneView& view) {
  std::vector<double> angles;
  if (!stage.place) return angles;
  if (const InputTrajectory* const trajectory = trajectoryOf(stage, view)) {
    angles = trajectory->at(view.time).angles;
  } else {
    for (const double speed : stage.inputSpeeds) angles.push_back(speed * view.time);
  }
  for (std::size_t k = 0; k < angles.size() && k < view.turned.size(); ++k) angles[k] += view.turned[k];
  return angles;
}

std::vector<double> inputSpeeds(const MechanismScene& stage, const SceneView& view) {
  if (!stage.place) return {};
  const InputTrajectory* const trajectory = trajectoryOf(stage, view);
  return trajectory != nullptr ? trajectory->at(view.time).speeds : stage.inputSpeeds;
}

const InputTrajectory* trajectoryOf(const MechanismScene& stage, const SceneView& view) {
  const bool fits = view.trajectory && view.trajectory->inputs() == stage.inputSpeeds.size();
  return fits ? view.trajectory.get() : nullptr;
}

std::optional<std::size_t> instanceOf(const MechanismScene& stage, const std::optional<ElementId>& link) {
  if (!link) return std::nullopt;
  const auto& instances = stage.scene.instances;
  const auto found = std::find_if(instances.begin(), instances.end(),
                                  [&](const Instance& instance) { return instance.element == *link; });
  if (found == instances.end()) return std::nullopt;
  return static_cast<std::size_t>(found - instances.begin());
}

SeenPoses seenPoses(const MechanismScene& stage, const SceneView& view,
                    std::span<const Eigen::Vector3d> offsets) {
  const auto& instances = stage.scene.instances;
  SeenPoses seen;
  for (const Instance& instance : instances) seen.poses.push_back(instance.pose);
  if (stage.place) stage.place(inputAngles(stage, view), seen.poses);
  if (const auto referenceLink = instanceOf(stage, view.referenceLink)) {
    seen.ground = instances[*referenceLink].pose * seen.poses[*referenceLink].inverse();
    for (Pose& pose : seen.poses) pose = seen.ground * pose;
  }
  explode(stage.scene, offsets, view.explosion, seen.poses);
  return seen;
}

std::optional<CutPlane> cutPlane(const Bounds& bounds, std::span<const Pose> poses,
                                 const std::optional<SectionChoice>& section) {
  if (!section || bounds.box.isEmpty()) return std::nullopt;
  Eigen::AlignedBox3d box = bounds.box;
  for (const Pose& pose : poses) box.extend(Eigen::Vector3d(pose.translation()));  // exploded, it is longer
  const double low = box.min()[section->axis], high = box.max()[section->axis];
  // What stands before the viewer of the standard views goes first: front looks along +y, right along -x.
  const double sense = (section->axis == 1) != section->isTurned ? -1 : 1;
  CutPlane plane;
  plane.normal = sense * Eigen::Vector3d::Unit(section->axis);
  plane.offset = sense * (low + section->place * (high - low));
  return plane;
}

std::optional<double> floorOf(const Scene& scene, std::span<const Eigen::Vector3d> offsets, double part) {
  if (part == 0 || scene.instances.empty()) return std::nullopt;
  Scene apart = scene;
  for (std::size_t i = 0; i < offsets.size(); ++i) apart.instances[i].pose.pretranslate(part * offsets[i]);
  return boundsOf(apart).box.min().z();
}

std::vector<ForceArrow> seenForces(const MechanismScene& stage, const SceneView& view,
                                   const SeenPoses& seen) {
  if (!view.marks.forces || !view.forces) return {};
  return forceArrows(stage, *view.forces, seen.poses, seen.ground);
}

std::vector<MarkLine> seenLines(const MechanismScene& stage, const SceneView& view, const SeenPoses& seen,
                                const std::optional<CutPlane>& cut) {
  const std::vector<double> angles = inputAngles(stage, view);
  const auto watcher = instanceOf(stage, view.referenceLink);
  const Rgb ink = motionInk(view.style);
  const std::vector<double> speeds = inputSpeeds(stage, view);
  const Moment moment{seen.poses, angles, speeds, seen.ground, watcher, view.style.letters, ink, cut};
  std::vector<MarkLine> lines = stageLines(stage, view.marks, moment);
  if (const auto arrows = seenForces(stage, view, seen); !arrows.empty())
    addForceLines(*view.forces, arrows, view.style, lines);
  for (const ShownTrace& trace : view.traces) {
    if (trace.point.watcher == watcher && !trace.path.points.empty())
      addTrace(lines, stage, trace, seen, ink);
  }
  return lines;
}

SeenStage::SeenStage(MechanismScenePtr stage)
    : m_stage(std::move(stage)), m_bounds(boundsOf(m_stage->scene)) {}

void SeenStage::show(const SceneView& view, const std::stop_token& stop) {
  if (view.explosion > 0 && m_explosionOffsets.empty()) m_explosionOffsets = explosionOffsets(*m_stage, stop);
  if (m_seen.poses.empty() || m_view.explosion != view.explosion)
    m_floor = floorOf(m_stage->scene, m_explosionOffsets, view.explosion);
  m_view = view;
  m_seen = seenPoses(*m_stage, view, m_explosionOffsets);
  m_lines = seenLines(*m_stage, view, m_seen, cut());
  m_visibility.clear();
  for (const Instance& instance : m_stage->scene.instances)
    m_visibility.push_back(view.hidden.contains(instance.element) ? Visibility::hidden : Visibility::solid);
}

std::vector<Eigen::Vector3d> SeenStage::corners(const std::stop_token& stop) {
  if (!m_outlines) m_outlines = solidOutlines(m_stage->scene, stop);
  std::vector<Eigen::Vector3d> points;
  for (std::size_t i = 0; i < m_seen.poses.size(); ++i) {
    if (m_visibility[i] == Visibility::hidden) continue;
    for (const Eigen::Vector3d& point : (*m_outlines)[m_stage->scene.instances[i].solid])
      points.push_back(m_seen.poses[i] * point);
  }
  return points;
}

Frame SeenStage::frame(const Viewport& viewport, double pixelRatio) const {
  GEARGRAPH_REQUIRE(m_seen.poses.size() == m_stage->scene.instances.size());
  Frame frame;
  frame.viewport = viewport;
  frame.pixelRatio = pixelRatio;
  frame.camera = m_view.camera;
  frame.style = m_view.style;
  frame.poses = m_seen.poses;
  frame.visibility = m_visibility;
  frame.section = cut();
  frame.floor = m_floor;
  frame.marks = m_lines;
  return frame;
}

}  // namespace geargraph

#include "core/presentation/mechanism_scene/scene_picture.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "core/foundations/base/translation.h"
#include "core/machine/solids/gear_solid.h"
#include "core/presentation/scene3d/exploded.h"

namespace geargraph {
namespace {

constexpr double kMargin = 0.07;       // of each side of the picture
constexpr int kAnimationSamples = 24;  // pictures of an animation that are looked at to fit it
constexpr double kHeightOfOne = 600;   // of a picture whose lines are one pixel wide

/// The least distance from which a camera of this direction sees a point within the margin.
double distanceFor(const Camera& camera, const Viewport& size, const Eigen::Vector3d& point) {
  const double upward = camera.millimetresPerPixel(size) * size.height / 2 / camera.distance();
  const double across = upward * size.aspect(), inside = 1 - 2 * kMargin;
  const Eigen::Vector3d from = point - camera.target();
  const double x = std::abs(from.dot(camera.right())), y = std::abs(from.dot(camera.up()));
  return std::max(x / (inside * across), y / (inside * upward)) - from.dot(camera.forward());
}

/// By link; the ground has none.
std::map<ElementId, std::string> namesOf(const MechanismScene& stage) {
  std::map<ElementId, std::string> names;
  for (const SceneLabel& label : stage.labels) {
    if (label.kind == LabelKind::link) names.emplace(label.element, "link " + label.text);
  }
  return names;
}

}  // namespace

RenderStyle pictureStyle(Theme theme, bool transparent) {
  RenderStyle style = theme == Theme::dark ? RenderStyle::dark() : RenderStyle::light();
  style.samples = 8;
  style.transparent = transparent;
  if (transparent) style.discStrength = 0;
  return style;
}

ScenePainter::ScenePainter(SceneRendering rendering, std::stop_token stop, std::unique_ptr<EglHost> host)
    : m_rendering(std::move(rendering)),
      m_stop(std::move(stop)),
      m_host(std::move(host)),
      m_seen(m_rendering.stage),
      m_now(m_rendering.view) {
  m_host->setScene(m_rendering.stage->scene);
}

Expected<std::unique_ptr<ScenePainter>> ScenePainter::create(SceneRendering rendering,
                                                             const std::stop_token& stop) {
  if (stop.stop_requested()) return std::unique_ptr<ScenePainter>();
  auto host = EglHost::create();
  if (!host) return host.error();
  if (std::max(rendering.size.width, rendering.size.height) > (*host)->maximumSide()) {
    Diagnostic tooLarge;
    tooLarge.code = Code::graphics;
    tooLarge.message =
        translated("The driver paints pictures of up to %1 pixels a side; choose a smaller size.",
                   {std::to_string((*host)->maximumSide())});
    return tooLarge;
  }
  if (stop.stop_requested()) return std::unique_ptr<ScenePainter>();
  std::unique_ptr<ScenePainter> painter(
      new ScenePainter(std::move(rendering), stop, std::move(host).value()));
  if (painter->m_rendering.fits) painter->fit();
  if (stop.stop_requested()) return std::unique_ptr<ScenePainter>();
  return painter;
}

void ScenePainter::fit() {
  if (m_rendering.animation) return fitAnimation();
  m_seen.show(m_rendering.view, m_stop);
  m_rendering.view.camera = m_rendering.view.camera.fitted(m_seen.corners(m_stop), m_rendering.size, kMargin);
}

// One place to look at and one distance for the whole animation: a camera that breathes makes one seasick.
void ScenePainter::fitAnimation() {
  Animation coarse = *m_rendering.animation;
  coarse.frames = std::min(coarse.frames, kAnimationSamples);
  std::vector<std::vector<Eigen::Vector3d>> points;
  Eigen::AlignedBox3d box;
  for (int picture = 0; picture < coarse.frames; ++picture) {
    m_seen.show(animationView(*m_rendering.stage, m_rendering.view, coarse, picture), m_stop);
    points.push_back(m_seen.corners(m_stop));
    if (m_stop.stop_requested()) return;
    for (const Eigen::Vector3d& point : points.back()) box.extend(point);
  }
  if (box.isEmpty()) return;
  Camera& camera = m_rendering.view.camera;
  camera = camera.placedAt(box.center(), camera.distance());
  double distance = 0;
  for (int picture = 0; picture < coarse.frames && !m_stop.stop_requested(); ++picture) {
    const Camera from = animationView(*m_rendering.stage, m_rendering.view, coarse, picture).camera;
    for (const Eigen::Vector3d& point : points[static_cast<std::size_t>(picture)])
      distance = std::max(distance, distanceFor(from, m_rendering.size, point));
  }
  camera = camera.placedAt(box.center(), std::max(distance, 1e-3));
}

SceneView ScenePainter::viewOf(int picture) const {
  return m_rendering.animation
             ? animationView(*m_rendering.stage, m_rendering.view, *m_rendering.animation, picture)
             : m_rendering.view;
}

double ScenePainter::pixelRatio() const {
  return m_rendering.pixelRatio > 0 ? m_rendering.pixelRatio
                                    : std::max(1.0, m_rendering.size.height / kHeightOfOne);
}

Frame ScenePainter::frame() const {
  Frame frame = m_seen.frame(m_rendering.size, pixelRatio());
  frame.stop = m_stop;
  return frame;
}

Image ScenePainter::paint(int picture) {
  m_now = viewOf(picture);
  m_seen.show(m_now, m_stop);
  return m_host->picture(frame());
}

VisibilityBuffer ScenePainter::seenForLabels() {
  const Viewport cells = labelCells(m_rendering.size, pixelRatio());
  return m_host->seen(frame(), cells.width, cells.height);
}

LabelGround ScenePainter::labelGround(const VisibilityBuffer& seen) const {
  return {m_seen.stage(), m_seen.poses(), m_seen.visibility(), m_now.camera, m_rendering.size,
          pixelRatio(),   &seen};
}

Expected<Image> stagePicture(SceneRendering rendering) {
  rendering.animation.reset();
  auto painter = ScenePainter::create(std::move(rendering));
  if (!painter) return painter.error();
  return (*painter)->paint(0);
}

MeshScene sceneOf(const MechanismScene& stage, const SceneView& view, const std::stop_token& stop) {
  MeshScene scene;
  scene.name = "view";
  scene.unit = stage.unit;
  const std::vector<Eigen::Vector3d> apart =
      view.explosion > 0 ? explosionOffsets(stage, stop) : std::vector<Eigen::Vector3d>();
  const SeenPoses seen = seenPoses(stage, view, apart);
  const std::map<ElementId, std::string> names = namesOf(stage);
  std::map<ElementId, std::size_t> materials;
  for (std::size_t i = 0; i < seen.poses.size() && !stop.stop_requested(); ++i) {
    const Instance& instance = stage.scene.instances[i];
    if (view.hidden.contains(instance.element)) continue;
    const auto [material, isNew] = materials.try_emplace(instance.element, scene.materials.size());
    const auto name = names.find(instance.element);
    MeshNode node;
    node.name = name == names.end() ? "ground" : name->second;
    node.pose = seen.poses[i];
    node.solid = stage.scene.solidWithin(kScreenTolerance, instance.solid);
    node.material = material->second;
    if (isNew) {
      scene.materials.push_back(
          {node.name, {instance.colour.red, instance.colour.green, instance.colour.blue}});
    }
    scene.nodes.push_back(std::move(node));
  }
  return withDistinctNames(std::move(scene));
}

}  // namespace geargraph

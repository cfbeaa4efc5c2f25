#include "core/presentation/train_stage/stage_picture.h"

#include <algorithm>
#include <cmath>

#include "core/machine/solids/gear_solid.h"
#include "core/presentation/stage/exploded.h"

namespace geargraph::inline train_stage {
namespace {

constexpr double kMargin = 0.07;      // of each side of the picture
constexpr int kFilmSamples = 24;      // pictures of a film that are looked at to fit it
constexpr double kHeightOfOne = 600;  // of a picture whose lines are one pixel wide

/// The least distance from which a camera of this direction sees a point within the margin.
double distanceFor(const Camera& camera, const Viewport& size, const Eigen::Vector3d& point) {
  const double upward = camera.millimetresPerPixel(size) * size.height / 2 / camera.distance();
  const double across = upward * size.aspect(), inside = 1 - 2 * kMargin;
  const Eigen::Vector3d from = point - camera.target();
  const double x = std::abs(from.dot(camera.right())), y = std::abs(from.dot(camera.up()));
  return std::max(x / (inside * across), y / (inside * upward)) - from.dot(camera.forward());
}

std::string nameOf(const Stage& stage, const ElementId& link) {
  for (const StageLabel& label : stage.labels) {
    if (label.kind == LabelKind::link && label.element == link) return "link " + label.text;
  }
  return "ground";
}

}  // namespace

Look pictureLook(Theme theme, bool transparent) {
  Look look = theme == Theme::dark ? Look::dark() : Look::light();
  look.samples = 8;
  look.transparent = transparent;
  if (transparent) look.discStrength = 0;
  return look;
}

StagePainter::StagePainter(StageShot shot, std::unique_ptr<EglHost> host)
    : m_shot(std::move(shot)), m_host(std::move(host)), m_seen(m_shot.stage), m_now(m_shot.view) {
  m_host->setScene(m_shot.stage->scene);
  if (m_shot.fits && m_shot.film) {
    fitFilm();
  } else if (m_shot.fits) {
    m_seen.show(m_shot.view);
    m_shot.view.camera = m_shot.view.camera.fitted(m_seen.corners(), m_shot.size, kMargin);
  }
}

Expected<std::unique_ptr<StagePainter>> StagePainter::create(StageShot shot) {
  auto host = EglHost::create();
  if (!host) return host.error();
  if (std::max(shot.size.width, shot.size.height) > (*host)->maximumSide()) {
    Diagnostic tooLarge;
    tooLarge.code = Code::graphics;
    tooLarge.message = "The driver paints pictures of up to " + std::to_string((*host)->maximumSide()) +
                       " pixels a side; choose a smaller size.";
    return tooLarge;
  }
  return std::unique_ptr<StagePainter>(new StagePainter(std::move(shot), std::move(host).value()));
}

// One place to look at and one distance for the whole film: a camera that breathes makes one seasick.
void StagePainter::fitFilm() {
  Film coarse = *m_shot.film;
  coarse.frames = std::min(coarse.frames, kFilmSamples);
  std::vector<std::vector<Eigen::Vector3d>> points;
  Eigen::AlignedBox3d box;
  for (int picture = 0; picture < coarse.frames; ++picture) {
    m_seen.show(filmView(*m_shot.stage, m_shot.view, coarse, picture));
    points.push_back(m_seen.corners());
    for (const Eigen::Vector3d& point : points.back()) box.extend(point);
  }
  if (box.isEmpty()) return;
  Camera& camera = m_shot.view.camera;
  camera = camera.placedAt(box.center(), camera.distance());
  double distance = 0;
  for (int picture = 0; picture < coarse.frames; ++picture) {
    const Camera from = filmView(*m_shot.stage, m_shot.view, coarse, picture).camera;
    for (const Eigen::Vector3d& point : points[static_cast<std::size_t>(picture)])
      distance = std::max(distance, distanceFor(from, m_shot.size, point));
  }
  camera = camera.placedAt(box.center(), std::max(distance, 1e-3));
}

StageView StagePainter::viewOf(int picture) const {
  return m_shot.film ? filmView(*m_shot.stage, m_shot.view, *m_shot.film, picture) : m_shot.view;
}

double StagePainter::pixelRatio() const {
  return m_shot.pixelRatio > 0 ? m_shot.pixelRatio : std::max(1.0, m_shot.size.height / kHeightOfOne);
}

Image StagePainter::paint(int picture, const std::stop_token& stop) {
  m_now = viewOf(picture);
  m_seen.show(m_now);
  Frame frame = m_seen.frame(m_shot.size, pixelRatio());
  frame.stop = stop;
  return m_host->picture(frame);
}

SeenMap StagePainter::seenForLabels() {
  const Viewport cells = labelCells(m_shot.size, pixelRatio());
  return m_host->seen(m_seen.frame(m_shot.size, pixelRatio()), cells.width, cells.height);
}

LabelGround StagePainter::labelGround(const SeenMap& seen) const {
  return {m_seen.stage(), m_seen.poses(), m_seen.showing(), m_now.camera, m_shot.size, pixelRatio(), &seen};
}

Expected<Image> stagePicture(StageShot shot) {
  shot.film.reset();
  auto painter = StagePainter::create(std::move(shot));
  if (!painter) return painter.error();
  return (*painter)->paint(0);
}

MeshScene sceneOf(const Stage& stage, const StageView& view, const std::stop_token& stop) {
  MeshScene scene;
  scene.name = "view";
  scene.unit = stage.unit;
  const SeenPoses seen = seenPoses(stage, view, separations(stage));
  std::vector<ElementId> links;
  for (std::size_t i = 0; i < seen.poses.size() && !stop.stop_requested(); ++i) {
    const Instance& instance = stage.scene.instances[i];
    if (view.hidden.contains(instance.element)) continue;
    const auto known = std::find(links.begin(), links.end(), instance.element);
    MeshNode node;
    node.name = nameOf(stage, instance.element);
    node.pose = seen.poses[i];
    node.solid = stage.scene.solidWithin(kScreenTolerance, instance.solid);
    node.material = static_cast<std::size_t>(known - links.begin());
    if (known == links.end()) {
      links.push_back(instance.element);
      scene.materials.push_back(
          {node.name, {instance.colour.red, instance.colour.green, instance.colour.blue}});
    }
    scene.nodes.push_back(std::move(node));
  }
  return withDistinctNames(std::move(scene));
}

}  // namespace geargraph::inline train_stage

#include "core/presentation/scene3d/label_places.h"

#include <algorithm>
#include <cmath>

namespace geargraph {
namespace {

constexpr std::size_t kMaxLabels = 60;  // beyond, plates would hide the train
constexpr int kRounds = 12;

/// Where plates may lie.
struct Room {
  double width = 0;
  double top = 0;
  double bottom = 0;
};

/// Moves touching plates apart, a little in each round, and all of them into the room.
void pushApart(std::vector<LabelPlate>& plates, const Room& room) {
  constexpr double kWanted = 2 * kLabelRadius + 2, kEdge = kLabelRadius + 2;
  const double highest = room.top + kEdge;
  const Eigen::Vector2d least(kEdge, highest);
  const Eigen::Vector2d most(std::max(kEdge, room.width - kEdge), std::max(highest, room.bottom - kEdge));
  for (int round = 0; round < kRounds; ++round) {
    for (std::size_t a = 0; a < plates.size(); ++a) {
      for (std::size_t b = a + 1; b < plates.size(); ++b) {
        const Eigen::Vector2d between = plates[b].middle - plates[a].middle;
        const double distance = between.norm();
        if (distance >= kWanted) continue;
        const double half = 0.5 * (kWanted - distance);
        const Eigen::Vector2d move =
            distance > 1e-3 ? Eigen::Vector2d(half / distance * between) : Eigen::Vector2d(0, half);
        plates[a].middle -= move;
        plates[b].middle += move;
      }
    }
    for (LabelPlate& plate : plates) plate.middle = plate.middle.cwiseMax(least).cwiseMin(most);
  }
}

}  // namespace

std::optional<LabelPlate> LabelPlaces::placed(const LabelGround& ground, std::size_t index) const {
  const SceneLabel& label = ground.stage.labels[index];
  if (!isShown(label.kind) || !ground.isShown(label)) return std::nullopt;
  Eigen::Vector3d point = ground.middleOf(label);
  Eigen::Vector2d away(0, 0);
  if (label.kind == LabelKind::link && !areNew()) {
    const LabelAnchor* anchor = m_anchors.of(label.element);
    if (anchor == nullptr) return std::nullopt;
    point += anchor->off;
    away = anchor->away;
  }
  if (ground.camera.project(point, ground.viewport).depth <= 0) return std::nullopt;
  const Eigen::Vector2d at = ground.project(point);
  // What is close to the eye lies far beside the picture: its line would be thousands of pixels long.
  const Eigen::Vector2d size =
      Eigen::Vector2d(ground.viewport.width, ground.viewport.height) / ground.pixelRatio;
  const double beyond = 2 * kLabelRadius;
  if (!((at.array() > -beyond).all() && (at.array() < size.array() + beyond).all())) return std::nullopt;
  return LabelPlate{index, at + away, at};
}

std::vector<LabelPlate> LabelPlaces::find(const LabelGround& ground) {
  const auto& labels = ground.stage.labels;
  const auto count = std::count_if(labels.begin(), labels.end(), [&](const SceneLabel& label) {
    return isShown(label.kind) && ground.isShown(label);
  });
  if (count == 0 || static_cast<std::size_t>(count) > kMaxLabels) return {};
  if (ground.seen != nullptr && isShown(LabelKind::link)) m_anchors.renew(ground);
  std::vector<LabelPlate> plates;
  for (std::size_t i = 0; i < labels.size(); ++i) {
    if (const auto plate = placed(ground, i)) plates.push_back(*plate);
  }
  pushApart(plates, {ground.viewport.width / ground.pixelRatio, m_above,
                     ground.viewport.height / ground.pixelRatio - m_below});
  return plates;
}

double niceLength(double millimetresPerPixel, double most) {
  const double longest = millimetresPerPixel * most;
  const double decade = std::pow(10, std::floor(std::log10(longest)));
  for (const double step : {5.0, 2.0}) {
    if (step * decade <= longest) return step * decade;
  }
  return decade;
}

}  // namespace geargraph

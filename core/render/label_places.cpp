#include "core/render/label_places.h"

#include <algorithm>
#include <cmath>

namespace geargraph {
namespace {

constexpr std::size_t kMostLabels = 60;  // beyond, plates would hide the train
constexpr double kGap = 5;               // between a part and its plate
constexpr double kCrossed = 0.25;        // of the part's radius beyond the middle: the plate changes sides
constexpr int kRounds = 12;

/// Where plates may lie.
struct Room {
  double width = 0;
  double top = 0;
  double bottom = 0;
};

/// Moves touching plates apart, a little in each round, and all of them into the room.
void pushApart(std::vector<LabelPlace>& labels, const Room& room) {
  constexpr double kWanted = 2 * kLabelRadius + 2, kEdge = kLabelRadius + 2;
  for (int round = 0; round < kRounds; ++round) {
    for (std::size_t a = 0; a < labels.size(); ++a) {
      for (std::size_t b = a + 1; b < labels.size(); ++b) {
        double x = labels[b].x - labels[a].x, y = labels[b].y - labels[a].y;
        const double distance = std::hypot(x, y);
        if (distance >= kWanted) continue;
        const bool apart = distance > 1e-3;
        const double half = 0.5 * (kWanted - distance);
        x = apart ? half * x / distance : 0;
        y = apart ? half * y / distance : half;
        labels[a].x -= x;
        labels[a].y -= y;
        labels[b].x += x;
        labels[b].y += y;
      }
    }
    for (LabelPlace& label : labels) {
      label.x = std::clamp(label.x, kEdge, std::max(kEdge, room.width - kEdge));
      const double highest = room.top + kEdge;
      label.y = std::clamp(label.y, highest, std::max(highest, room.bottom - kEdge));
    }
  }
}

}  // namespace

std::vector<LabelPlace> LabelPlaces::find(const LabelGround& ground) {
  const auto& labels = ground.stage.labels;
  const auto isShownNow = [&](const StageLabel& label) {
    return isShown(label.kind) &&
           (ground.showing.empty() || ground.showing[label.instance] == Showing::solid);
  };
  const auto count = std::count_if(labels.begin(), labels.end(), isShownNow);
  if (count == 0 || static_cast<std::size_t>(count) > kMostLabels) return {};
  m_sides.resize(labels.size(), 0);
  std::vector<ScreenPoint> middles;
  double centre = 0;
  for (const StageLabel& label : labels) {
    middles.push_back(ground.camera.project(ground.poses[label.instance] * label.place, ground.viewport));
    centre += middles.back().x / static_cast<double>(labels.size());
  }
  std::vector<LabelPlace> placed;
  for (std::size_t i = 0; i < labels.size(); ++i) {
    const ScreenPoint& middle = middles[i];
    if (middle.depth <= 0 || !isShownNow(labels[i])) continue;
    const double x = middle.x / ground.pixelRatio, y = middle.y / ground.pixelRatio;
    if (labels[i].kind != LabelKind::link) {
      placed.push_back({i, x, y});
      continue;
    }
    const double reach = labels[i].radius / ground.camera.millimetresPerPixel(ground.viewport) *
                         ground.camera.distance() / middle.depth;
    const double off = middle.x - centre;
    if (m_sides[i] == 0 || off * m_sides[i] < -kCrossed * reach) m_sides[i] = off < 0 ? -1 : 1;
    const double away = reach / ground.pixelRatio + kLabelRadius + kGap;
    placed.push_back({i, x + 0.93 * m_sides[i] * away, y - 0.37 * away});
  }
  pushApart(placed, {ground.viewport.width / ground.pixelRatio, m_above,
                     ground.viewport.height / ground.pixelRatio - m_below});
  return placed;
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

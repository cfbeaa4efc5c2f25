#include "core/presentation/scene3d/scene_forces.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numeric>

#include "core/foundations/base/translation.h"

namespace geargraph {
namespace {

constexpr double kMaxLength = 0.34;  // share of the scene's radius
constexpr double kLeast = 1e-3;      // share of the greatest force
constexpr float kWidth = 2.8F;
constexpr float kCasing = 5.6F;
constexpr double kHeadShare = 0.3;  // of an arrow: its head is painted over the picture

bool isDark(const RenderStyle& style) {
  return style.letters.red > 0.5F;
}

struct ForceBox {
  Eigen::Vector2d middle;
  Eigen::Vector2d half;
  [[nodiscard]] bool meets(const ForceBox& other) const {
    const Eigen::Vector2d apart = (middle - other.middle).cwiseAbs();
    return apart.x() < half.x() + other.half.x() && apart.y() < half.y() + other.half.y();
  }
  /// Does the segment cross it?
  [[nodiscard]] bool meets(const Eigen::Vector2d& from, const Eigen::Vector2d& to) const {
    double low = 0;
    double high = 1;
    for (int axis = 0; axis < 2; ++axis) {
      const double way = to[axis] - from[axis];
      const double a = middle[axis] - half[axis] - from[axis];
      const double b = middle[axis] + half[axis] - from[axis];
      if (std::abs(way) < 1e-9) {
        if (a > 0 || b < 0) return false;
        continue;
      }
      low = std::max(low, std::min(a / way, b / way));
      high = std::min(high, std::max(a / way, b / way));
    }
    return low <= high;
  }
};

}  // namespace

std::vector<ForceArrow> forceArrows(const MechanismScene& stage, std::span<const SceneForce> forces,
                                    std::span<const Pose> poses, const Pose& ground) {
  double greatest = 0;
  for (const SceneForce& each : forces) greatest = std::max(greatest, each.force.norm());
  std::vector<ForceArrow> arrows;
  if (!(greatest > 0) || stage.scene.instances.empty()) return arrows;
  std::map<ElementId, std::size_t> instances;  // the first of each link
  for (std::size_t i = 0; i < stage.scene.instances.size(); ++i)
    instances.try_emplace(stage.scene.instances[i].element, i);
  const double scale = kMaxLength * boundsOf(stage.scene).radius() / greatest;
  for (std::size_t i = 0; i < forces.size(); ++i) {
    const SceneForce& each = forces[i];
    if (each.force.norm() < kLeast * greatest) continue;
    Pose moved = ground;
    if (const auto at = each.link ? instances.find(*each.link) : instances.end(); at != instances.end())
      moved = poses[at->second] * stage.scene.instances[at->second].pose.inverse();
    const Eigen::Vector3d from = moved * each.point;
    arrows.push_back({i, from, from + scale * (moved.linear() * each.force)});
  }
  return arrows;
}

Rgb forceColour(ForceKind kind, const RenderStyle& style) {
  if (kind == ForceKind::tooth) return style.letters;
  return Rgb::fromHex(isDark(style) ? 0x6C9BFF : 0x2A68E4);
}

std::string_view forceLegend(ForceKind kind) {
  return kind == ForceKind::tooth ? toTranslate("tooth forces (on heads)")
                                  : toTranslate("bearing reactions (on heads)");
}

void addForceLines(std::span<const SceneForce> forces, std::span<const ForceArrow> arrows,
                   const RenderStyle& style, std::vector<MarkLine>& lines) {
  const Rgb casing = Rgb::fromHex(isDark(style) ? 0x1E2227 : 0xFFFFFF);
  for (const ForceArrow& arrow : arrows) {
    const Eigen::Vector3d neck = arrow.to - kHeadShare * (arrow.to - arrow.from);
    lines.push_back({{arrow.from, neck}, casing, kCasing, false});
    lines.push_back({{arrow.from, neck}, forceColour(forces[arrow.force].kind, style), kWidth, false});
  }
}

std::vector<ForceLabel> placeForceLabels(std::span<const SceneForce> forces,
                                         std::span<const ForceArrow> arrows,
                                         const std::set<ElementId>& highlighted, const LabelGround& ground,
                                         const std::function<double(const std::string&)>& widthOf) {
  std::vector<std::size_t> order(arrows.size());
  std::iota(order.begin(), order.end(), 0U);
  const auto isHighlighted = [&](std::size_t at) {
    return highlighted.contains(forces[arrows[at].force].element);
  };
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    if (isHighlighted(a) != isHighlighted(b)) return isHighlighted(a);
    return forces[arrows[a].force].force.norm() > forces[arrows[b].force].force.norm() * (1 + 1e-9);
  });
  std::vector<std::pair<Eigen::Vector2d, Eigen::Vector2d>> seen;
  for (const ForceArrow& arrow : arrows)
    seen.emplace_back(ground.project(arrow.from), ground.project(arrow.to));
  const Eigen::Vector2d corner(ground.viewport.width / ground.pixelRatio,
                               ground.viewport.height / ground.pixelRatio);
  std::vector<ForceLabel> labels;
  std::vector<ForceBox> taken;
  for (const std::size_t at : order) {
    if (labels.size() >= kMaxForceLabels && !isHighlighted(at)) break;
    const Eigen::Vector2d half(widthOf(forces[arrows[at].force].text) / 2 + 6, 9);
    const auto& [from, tip] = seen[at];
    const Eigen::Vector2d way = (tip - from).norm() > 1 ? (tip - from).normalized() : Eigen::Vector2d(0, -1);
    for (const double turn : {0.0, 0.7, -0.7, 1.4, -1.4, 2.1, -2.1}) {
      const Eigen::Vector2d out(way.x() * std::cos(turn) - way.y() * std::sin(turn),
                                way.x() * std::sin(turn) + way.y() * std::cos(turn));
      const double reach = half.x() * std::abs(out.x()) + half.y() * std::abs(out.y()) + 7;
      const ForceBox box{tip + reach * out, half};
      const Eigen::Vector2d low = box.middle - half;
      const Eigen::Vector2d high = box.middle + half;
      if (low.x() < 2 || low.y() < 2 + ground.above) continue;
      if (high.x() > corner.x() - 2 || high.y() > corner.y() - 2 - ground.below) continue;
      const bool isFree =
          std::none_of(taken.begin(), taken.end(), [&](const ForceBox& other) { return box.meets(other); }) &&
          std::none_of(seen.begin(), seen.end(),
                       [&](const auto& line) { return box.meets(line.first, line.second); });
      if (!isFree) continue;
      taken.push_back(box);
      labels.push_back({arrows[at].force, box.middle, half, tip});
      break;
    }
  }
  return labels;
}

}  // namespace geargraph

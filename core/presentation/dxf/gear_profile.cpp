#include "core/presentation/dxf/gear_profile.h"

#include <Eigen/Geometry>
#include <numbers>

#include "core/foundations/base/contract.h"
#include "core/machine/teeth/half_tooth.h"
#include "core/machine/teeth/wheel_kind.h"

namespace geargraph {

bool isDrawnPlane(const GearSpec& spec) {
  return isToothed(spec) && !isConical(spec) && !isFaceGear(spec);
}

std::vector<ArcVertex> toothOutline(const GearSpec& spec, double deviation) {
  GEARGRAPH_REQUIRE(isDrawnPlane(spec));
  // The samples are on the curve, and so close that arcs do not leave it between them where it bends more and
  // more, near the base circle.
  const HalfTooth tooth = toothOf(spec, deviation / 100);
  std::vector<Eigen::Vector2d> points;  // from the middle of the space to the middle of the tip, rising angle
  for (const ProfilePoint& point : tooth.points)
    points.emplace_back(point.rad * std::cos(point.gam), -point.rad * std::sin(point.gam));
  std::vector<ArcVertex> half = fittedArcs(points, 0.9 * deviation);
  for (ArcVertex& vertex : half) vertex.at *= spec.module;

  std::vector<ArcVertex> outline;
  for (int number = 0; number < spec.teeth; ++number) {
    const Eigen::Rotation2Dd turn(2 * std::numbers::pi * number / spec.teeth);
    for (std::size_t i = 0; i + 1 < half.size(); ++i) outline.push_back({turn * half[i].at, half[i].bulge});
    for (std::size_t i = half.size() - 1; i > 0; --i) {
      const Eigen::Vector2d mirrored(half[i].at.x(), -half[i].at.y());
      outline.push_back({turn * mirrored, half[i - 1].bulge});
    }
  }
  return outline;
}

}  // namespace geargraph

#include "core/machine/body_layout/gear_obstacles.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "core/machine/solids/gear_body.h"
#include "core/machine/teeth/wheel_kind.h"

namespace geargraph {
namespace {

using Eigen::Vector3d;

constexpr int kPlaces = 12;        // along a bar
constexpr double kSteepest = 1.3;  // rad: flatter bevels count as discs

}  // namespace

GearObstacles::GearObstacles(const GearTrain& train) {
  for (const TrainGear& drawn : train.gears) {
    const GearSpec& spec = drawn.spec;
    const AxialSpan span = axialSpan(spec);
    Gear gear;
    gear.link = drawn.link;
    gear.ring = isRing(spec);
    gear.origin = drawn.pose.translation();
    gear.axis = drawn.pose.linear().col(2);
    gear.low = span.low;
    gear.high = span.high;
    gear.tip = nominalTipRadius(spec);
    if (isConical(spec) && spec.coneAngle < kSteepest) {
      gear.slope = std::tan(spec.coneAngle + (spec.addendum + 0.5) * spec.module / coneDistance(spec));
    }
    gear.middle = gear.origin + (span.low + span.high) / 2 * gear.axis;
    gear.reach = std::hypot((span.high - span.low) / 2, outerRadius(spec));
    m_gears.push_back(gear);
  }
}

std::vector<std::size_t> GearObstacles::inPlane(const Vector3d& point, const Vector3d& axis,
                                                double half) const {
  std::vector<std::size_t> found;
  for (std::size_t g = 0; g < m_gears.size(); ++g) {
    const Gear& gear = m_gears[g];
    const double along = (point - gear.origin).dot(gear.axis);
    if (along + half < gear.low || along - half > gear.high) continue;
    if (gear.axis.cross(axis).norm() < 1e-6) found.push_back(g);
  }
  return found;
}

bool GearObstacles::isClear(const std::vector<std::size_t>& gears, const Vector3d& a, const Vector3d& b,
                            double margin) const {
  const Vector3d bar = b - a;
  const double squared = bar.squaredNorm();
  return std::none_of(gears.begin(), gears.end(), [&](std::size_t g) {
    const Gear& gear = m_gears[g];
    const Vector3d centre = gear.origin + (a - gear.origin).dot(gear.axis) * gear.axis;
    const double part = squared > 0 ? std::clamp((centre - a).dot(bar) / squared, 0.0, 1.0) : 0;
    return (centre - a - part * bar).norm() < gear.tip + margin;
  });
}

bool GearObstacles::isNear(const Gear& gear, const Vector3d& p, double margin) {
  const Vector3d arm = p - gear.origin;
  const double along = arm.dot(gear.axis);
  if (along < gear.low - margin || along > gear.high + margin) return false;
  const double radius = (arm - along * gear.axis).norm();
  if (gear.ring) return radius > gear.tip - margin;
  const double tip = gear.slope > 0 ? std::min(gear.tip, std::max(along, 0.0) * gear.slope) : gear.tip;
  return radius < tip + margin;
}

int GearObstacles::collisions(LinkOrdinal link, const Vector3d& a, const Vector3d& b, double margin,
                              const Vector3d* across) const {
  int count = 0;
  const Vector3d middle = 0.5 * (a + b);
  const double half = 0.5 * (b - a).norm() + margin;
  for (const Gear& gear : m_gears) {
    if (gear.link == link || (gear.middle - middle).norm() > gear.reach + half) continue;
    if (across != nullptr && gear.axis.cross(*across).norm() < 1e-6) continue;
    for (int i = 1; i <= kPlaces; ++i) count += isNear(gear, a + (b - a) * i / kPlaces, margin) ? 1 : 0;
  }
  return count;
}

}  // namespace geargraph

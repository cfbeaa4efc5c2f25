#include "core/machine/body_layout/body_hulls.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <utility>

#include "core/machine/body_layout/body_shapes.h"
#include "core/machine/solids/gear_body.h"
#include "core/machine/teeth/wheel_kind.h"

namespace geargraph {
namespace {

using Eigen::Vector3d;

constexpr double kFlattest = 1.7;  // rad: the bodies of flatter bevels are hollow

Vector3 narrow(const Vector3d& v) {
  return {v.x(), v.y(), v.z()};
}

class HullMaker {
 public:
  HullMaker(const Arrangement& plan, const HullOptions& options) : m_plan(plan), m_options(options) {}

  std::vector<BodyHull> make(const GearTrain& train) {
    for (const TrainGear& gear : train.gears) addGear(gear);
    for (const ShaftSegment& shaft : m_plan.shafts)
      addRound(HullKind::shaft, shaft.link, shaft.axisGroup, shaft.low, shaft.high, shaft.outer);
    for (std::size_t c = 0; c < m_plan.axes.size(); ++c) {
      for (const Bearing& b : m_plan.axes[c].bearings) addBearing(static_cast<int>(c), b);
    }
    for (const ArmPlan& arm : m_plan.arms) addArm(arm);
    if (m_options.isWhole) addRevolved(train);
    return std::move(m_hulls);
  }

 private:
  [[nodiscard]] const AxisLayout& axis(int c) const { return m_plan.axes[c]; }
  [[nodiscard]] double inset(int c) const { return m_options.inset * axis(c).module; }

  void addGear(const TrainGear& gear) {
    const GearSpec& spec = gear.spec;
    const Vector3d k = gear.pose.linear().col(2);
    BodyHull hull{HullKind::gear, gear.link, gear.axisGroup, -1, {}};
    const auto add = [&](double radius, double height) {
      hull.discs.push_back({narrow(gear.pose.translation() + height * k), narrow(k), std::max(radius, 0.0)});
    };
    if (isDisc(spec) || (isRing(spec) && m_options.isWhole)) {
      const AxialSpan span = axialSpan(spec);
      const double radius = outerRadius(spec);
      add(radius, span.low);
      add(radius, span.high);
    } else if (isConical(spec) && (spec.coneAngle < kFlattest || m_options.isWhole)) {
      // The small ends of the teeth stand out from a hollow that a hull would fill.
      const std::vector<ProfileVertex> body = bodyProfile(spec);
      const std::vector<ProfileVertex> all = wheelOutline(spec);
      const ProfileVertex small = all[all.size() - 2], large = all.back();
      for (const ProfileVertex& c : body) add(c.radius, c.height);
      add(large.radius, large.height);
      const double share = (body.back().height - small.height) / (large.height - small.height);
      if (m_options.isWhole)
        add(small.radius, small.height);
      else if (share > 0 && share < 1)
        add(small.radius + share * (large.radius - small.radius), body.back().height);
    }
    if (!hull.discs.empty()) m_hulls.push_back(std::move(hull));
  }

  void addRound(HullKind kind, LinkOrdinal link, int c, double low, double high, double radius) {
    const double off = inset(c);
    if (high - low <= 2 * off || radius <= off) return;
    BodyHull hull{kind, link, c, -1, {}};
    for (const double z : {low + off, high - off})
      hull.discs.push_back({narrow(axis(c).at(z)), narrow(axis(c).direction), radius - off});
    m_hulls.push_back(std::move(hull));
  }

  void addBearing(int c, const Bearing& bearing) {
    if (!bearing.isBoss()) return;
    const AxisLayout& layout = axis(c);
    addRound(HullKind::bearing, bearing.parent, c, bearing.at - layout.width() / 2,
             bearing.at + layout.width() / 2, bossRadius(m_plan, c, bearing));
  }

  /// The bar as wide as its narrower end, and the standoff on it.
  void addArm(const ArmPlan& arm) {
    const AxisLayout& from = axis(arm.from);
    const Boss foot = footOf(m_plan, arm), end = endOf(m_plan, arm);
    const double off = inset(arm.from);
    const Eigen::Isometry3d frame = frameAlong(from.at(arm.level), from.direction, Vector3d::UnitX());
    const bool parallel = from.direction.cross(axis(arm.to).direction).norm() < 1e-6;
    BodyHull bar{HullKind::arm, arm.link, arm.from, parallel ? arm.to : -1, {}};
    bar.held = parallel ? -1 : arm.child;
    for (const double z : {off - 0.5 * from.width(), 0.5 * from.width() - off}) {
      const Vector3 k = narrow(from.direction);
      const double radius = std::min(foot.radius, end.radius) - off;
      bar.discs.push_back({narrow(frame * Vector3d(0, 0, z)), k, radius});
      bar.discs.push_back({narrow(frame * Vector3d(end.centre.x(), end.centre.y(), z)), k, radius});
    }
    m_hulls.push_back(std::move(bar));
    if (const auto standoff = standoffOf(m_plan, arm)) {
      BodyHull rod{HullKind::standoff, arm.link, -1, arm.to, {}};
      rod.held = arm.child;
      for (const double z : {0.0, standoff->reach - off})
        rod.discs.push_back(
            {narrow(standoff->foot + z * standoff->way), narrow(standoff->way), standoff->radius - off});
      m_hulls.push_back(std::move(rod));
    }
  }

  void addRevolved(const GearTrain& train) {
    for (const RingCarrierPlan& ringCarrier : m_plan.ringCarriers) {
      const TrainGear& ring = train.gears[ringCarrier.gear];
      const double half = axis(ring.axisGroup).width() / 2;
      addRound(HullKind::gear, ring.link, ring.axisGroup, ringCarrier.plate - half, ringCarrier.plate + half,
               rimDiameter(ring.spec) / 2);
    }
    for (const CagePlan& cage : m_plan.cages)
      addRound(HullKind::gear, cage.link, cage.axisGroup, cage.low, cage.high, cage.outer);
    for (const RevolvedPlan& revolved : m_plan.revolvedBodies) {
      for (const auto& profile : revolved.profiles) {
        double low = 1e300, high = -1e300, radius = 0;
        for (const ProfileVertex& vertex : profile) {
          low = std::min(low, vertex.height);
          high = std::max(high, vertex.height);
          radius = std::max(radius, vertex.radius);
        }
        addRound(HullKind::gear, revolved.link, revolved.axisGroup, low, high, radius);
      }
    }
  }

  const Arrangement& m_plan;
  const HullOptions& m_options;
  std::vector<BodyHull> m_hulls;
};

}  // namespace

std::vector<BodyHull> bodyHulls(const Arrangement& plan, const GearTrain& train, const HullOptions& options) {
  return HullMaker(plan, options).make(train);
}

}  // namespace geargraph

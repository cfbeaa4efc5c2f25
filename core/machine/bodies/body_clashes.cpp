#include "core/machine/bodies/body_clashes.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "core/machine/bodies/body_shapes.h"
#include "core/machine/solids/gear_body.h"
#include "core/mechanism/placement/disc_hull.h"

namespace geargraph::inline bodies {
namespace {

using Eigen::Vector3d;

/// Modules by which parts may lie in each other unnoticed: chamfers, chords, and what touches.
constexpr double kUnseen = 0.15;
constexpr double kFlattest = 1.7;  // rad: the bodies of flatter bevels are hollow

enum class PartKind { gear, shaft, bearing, arm, post };

struct Part {
  PartKind kind = PartKind::gear;
  int link = 0;
  int axisClass = -1;  ///< that it stands on
  int other = -1;      ///< of an arm: at its other end, where that is parallel; of a post: that it reaches
  DiscHull hull;
  Vector3 middle{};  ///< of a ball that holds the hull
  double reach = 0;
  int held = -1;  ///< of an arm across to another axis, and of its post: the link that it holds

  [[nodiscard]] bool standsOn(int c) const { return axisClass == c || other == c; }
};

Vector3 narrow(const Vector3d& v) {
  return {v.x(), v.y(), v.z()};
}

class PartsMaker {
 public:
  PartsMaker(const BodyPlan& plan, const GearTrain& train) : m_plan(plan) {
    for (const TrainGear& gear : train.gears) addGear(gear);
    for (const ShaftSegment& shaft : plan.shafts)
      addRound(PartKind::shaft, shaft.link, shaft.axisClass, shaft.low, shaft.high, shaft.outer);
    for (std::size_t c = 0; c < plan.axes.size(); ++c) {
      for (const Bearing& b : plan.axes[c].bearings) addBearing(static_cast<int>(c), b);
    }
    for (const ArmPlan& arm : plan.arms) addArm(arm);
  }
  std::vector<Part> take() {
    for (Part& part : m_parts) {
      const double share = 1.0 / static_cast<double>(part.hull.size());
      for (const Disc& d : part.hull) part.middle = part.middle + share * d.centre;
      for (const Disc& d : part.hull)
        part.reach = std::max(part.reach, length(d.centre - part.middle) + d.radius);
    }
    return std::move(m_parts);
  }

 private:
  [[nodiscard]] const AxisLayout& axis(int c) const { return m_plan.axes[static_cast<std::size_t>(c)]; }

  void addGear(const TrainGear& gear) {
    const GearSpec& spec = gear.spec;
    const Vector3d k = gear.pose.linear().col(2);
    Part part{PartKind::gear, gear.link, gear.axisClass, -1, {}, {}, 0};
    const auto add = [&](double radius, double height) {
      part.hull.push_back({narrow(gear.pose.translation() + height * k), narrow(k), std::max(radius, 0.0)});
    };
    if (spec.kind == GearKind::external) {
      const AxialSpan span = axialSpan(spec);
      const double radius = nominalTipRadius(spec);
      add(radius, span.low);
      add(radius, span.high);
    } else if (spec.kind == GearKind::bevel && spec.coneAngle < kFlattest) {
      // The small ends of the teeth stand out from a hollow that a hull would fill.
      const std::vector<ProfileVertex> body = bodyMeridian(spec);
      const std::vector<ProfileVertex> all = bevelOutline(spec);
      const ProfileVertex small = all[all.size() - 2], large = all.back();
      for (const ProfileVertex& c : body) add(c.radius, c.height);
      add(large.radius, large.height);
      const double share = (body.back().height - small.height) / (large.height - small.height);
      if (share > 0 && share < 1)
        add(small.radius + share * (large.radius - small.radius), body.back().height);
    }
    if (!part.hull.empty()) m_parts.push_back(std::move(part));
  }

  void addRound(PartKind kind, int link, int c, double low, double high, double radius) {
    const double off = kUnseen * axis(c).module;
    if (high - low <= 2 * off || radius <= off) return;
    Part part{kind, link, c, -1, {}, {}, 0};
    for (const double z : {low + off, high - off})
      part.hull.push_back({narrow(axis(c).at(z)), narrow(axis(c).direction), radius - off});
    m_parts.push_back(std::move(part));
  }

  void addBearing(int c, const Bearing& bearing) {
    if (!bearing.isEye()) return;
    const AxisLayout& layout = axis(c);
    const double radius = holeFor(m_plan, c, bearing.at, bearing.parent) + bearing.wall * eyeWall(layout);
    addRound(PartKind::bearing, bearing.parent, c, bearing.at - layout.width() / 2,
             bearing.at + layout.width() / 2, radius);
  }

  /// The bar as wide as its narrower end, and the post on it.
  void addArm(const ArmPlan& arm) {
    const AxisLayout& from = axis(arm.from);
    const Eye foot = footOf(m_plan, arm), end = endOf(m_plan, arm);
    const double off = kUnseen * from.module;
    const Eigen::Isometry3d frame = frameAlong(from.at(arm.level), from.direction, Vector3d::UnitX());
    const bool parallel = from.direction.cross(axis(arm.to).direction).norm() < 1e-6;
    Part part{PartKind::arm, arm.link, arm.from, parallel ? arm.to : -1, {}, {}, 0};
    part.held = parallel ? -1 : arm.child;
    for (const double z : {off - 0.5 * from.width(), 0.5 * from.width() - off}) {
      const Vector3 k = narrow(from.direction);
      const double bar = std::min(foot.radius, end.radius) - off;
      part.hull.push_back({narrow(frame * Vector3d(0, 0, z)), k, bar});
      part.hull.push_back({narrow(frame * Vector3d(end.centre.x(), end.centre.y(), z)), k, bar});
    }
    m_parts.push_back(std::move(part));
    if (const auto post = postOf(m_plan, arm)) {
      Part rod{PartKind::post, arm.link, -1, arm.to, {}, {}, 0};
      rod.held = arm.child;
      for (const double z : {0.0, post->reach - off})
        rod.hull.push_back({narrow(post->foot + z * post->way), narrow(post->way), post->radius - off});
      m_parts.push_back(std::move(rod));
    }
  }

  const BodyPlan& m_plan;
  std::vector<Part> m_parts;
};

/// Is one within the other by design, or kept off it by other means: a shaft in bores, eyes and other shafts
/// of its axis, and what stands on one axis?
bool holds(const Part& a, const Part& b) {
  if (a.kind == PartKind::gear && b.kind == PartKind::gear) return true;  // findings of their own
  const auto isAcross = [](const Part& part) { return part.kind == PartKind::post || part.held >= 0; };
  const bool onOneAxis = a.standsOn(b.axisClass) || (b.other >= 0 && a.standsOn(b.other));
  if (!isAcross(a) && !isAcross(b) && onOneAxis &&
      std::abs(dot(a.hull.front().axis, b.hull.front().axis)) > 1 - 1e-9)
    return true;
  const auto runsIn = [](const Part& shaft, const Part& part) {
    return shaft.kind == PartKind::shaft && part.standsOn(shaft.axisClass);
  };
  return runsIn(a, b) || runsIn(b, a);
}

}  // namespace

std::vector<BodyClash> bodyClashes(const BodyPlan& plan, const GearTrain& train,
                                   const std::stop_token& stop) {
  const std::vector<Part> parts = PartsMaker(plan, train).take();
  std::map<std::pair<int, int>, std::set<int>> found;
  for (std::size_t i = 0; i < parts.size() && !stop.stop_requested(); ++i) {
    for (std::size_t k = i + 1; k < parts.size(); ++k) {
      const Part& a = parts[i];
      const Part& b = parts[k];
      if (a.link == b.link || holds(a, b)) continue;
      const Vector3 apart = a.middle - b.middle;
      const double reach = a.reach + b.reach;
      if (dot(apart, apart) > reach * reach || !areNear(a.hull, b.hull)) continue;
      std::set<int>& held = found[std::minmax({a.link, b.link})];
      for (const Part* part : {&a, &b}) {
        if (part->link == 0 && part->held >= 0) held.insert(part->held);
      }
    }
  }
  std::vector<BodyClash> clashes;
  for (auto& [links, held] : found) clashes.push_back({links.first, links.second, std::move(held)});
  return clashes;
}

}  // namespace geargraph::inline bodies

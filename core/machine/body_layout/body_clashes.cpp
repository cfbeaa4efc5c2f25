#include "core/machine/body_layout/body_clashes.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "core/machine/body_layout/body_hulls.h"
#include "core/machine/solids/gear_body.h"
#include "core/machine/teeth/wheel_kind.h"

namespace geargraph {
namespace {

using Eigen::Vector3d;

/// Modules by which parts may lie in each other unnoticed: chamfers, chords, and what touches.
constexpr double kUnseen = 0.15;

/// A hull and its bounding sphere.
struct Part {
  BodyHull hull;
  Vector3 middle{};
  double reach = 0;
};

std::vector<Part> partsOf(const Arrangement& plan, const GearTrain& train) {
  std::vector<Part> parts;
  for (BodyHull& hull : bodyHulls(plan, train, {kUnseen, false})) {
    Part part{std::move(hull)};
    const double share = 1.0 / static_cast<double>(part.hull.discs.size());
    for (const Disc& d : part.hull.discs) part.middle = part.middle + share * d.centre;
    for (const Disc& d : part.hull.discs)
      part.reach = std::max(part.reach, length(d.centre - part.middle) + d.radius);
    parts.push_back(std::move(part));
  }
  return parts;
}

/// Is one within the other by design, or kept off it by other means: a shaft in bores, bosses and other
/// shafts of its axis, and what stands on one axis?
bool holds(const BodyHull& a, const BodyHull& b) {
  if (a.kind == HullKind::gear && b.kind == HullKind::gear) return true;  // diagnostics of their own
  const auto isAcross = [](const BodyHull& part) {
    return part.kind == HullKind::standoff || part.held >= 0;
  };
  const bool onOneAxis = a.isOn(b.axisGroup) || (b.other >= 0 && a.isOn(b.other));
  if (!isAcross(a) && !isAcross(b) && onOneAxis &&
      std::abs(dot(a.discs.front().axis, b.discs.front().axis)) > 1 - 1e-9)
    return true;
  const auto runsIn = [](const BodyHull& shaft, const BodyHull& part) {
    return shaft.kind == HullKind::shaft && part.isOn(shaft.axisGroup);
  };
  return runsIn(a, b) || runsIn(b, a);
}

/// Does a shaft on a wheel's axis run through the wheel's middle, neither within the wheel's own shaft nor,
/// where it has none there, within its bore?
bool runsThrough(const Arrangement& plan, const ShaftSegment& shaft, const TrainGear& gear) {
  const AxisLayout& axis = plan.axes[gear.axisGroup];
  const AxialSpan span = axialSpan(gear.spec);
  const double sense = gear.pose.linear().col(2).dot(axis.direction) < 0 ? -1 : 1;
  const double middle = axis.coordinate(gear.pose.translation()) + sense * (span.low + span.high) / 2;
  const auto covers = [&](const ShaftSegment& s) { return s.low <= middle && middle <= s.high; };
  if (!covers(shaft)) return false;
  const ShaftSegment* own = plan.shaftOf(gear.axisGroup, gear.link, middle);
  return shaft.outer > (own != nullptr && covers(*own) ? own->inner : nominalRootRadius(gear.spec));
}

}  // namespace

std::vector<BodyClash> bodyClashes(const Arrangement& plan, const GearTrain& train,
                                   const std::stop_token& stop) {
  const std::vector<Part> parts = partsOf(plan, train);
  std::map<std::pair<int, int>, std::set<int>> found;
  for (std::size_t i = 0; i < parts.size() && !stop.stop_requested(); ++i) {
    for (std::size_t k = i + 1; k < parts.size(); ++k) {
      const Part& a = parts[i];
      const Part& b = parts[k];
      if (a.hull.link == b.hull.link || holds(a.hull, b.hull)) continue;
      const Vector3 apart = a.middle - b.middle;
      const double reach = a.reach + b.reach;
      if (dot(apart, apart) > reach * reach || !areNear(a.hull.discs, b.hull.discs)) continue;
      std::set<int>& held = found[std::minmax({a.hull.link, b.hull.link})];
      for (const BodyHull* hull : {&a.hull, &b.hull}) {
        if (hull->link == 0 && hull->held >= 0) held.insert(hull->held);
      }
    }
  }
  for (const TrainGear& gear : train.gears) {
    if (isRing(gear.spec) || stop.stop_requested()) continue;
    for (const std::size_t s : plan.shaftsOn[gear.axisGroup]) {
      const ShaftSegment& shaft = plan.shafts[s];
      if (shaft.link != gear.link && runsThrough(plan, shaft, gear))
        found.try_emplace(std::minmax({shaft.link, gear.link}));
    }
  }
  std::vector<BodyClash> clashes;
  for (auto& [links, held] : found) clashes.push_back({links.first, links.second, std::move(held)});
  return clashes;
}

}  // namespace geargraph

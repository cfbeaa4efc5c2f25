// Heights above the axes: lanes of nested shafts, walls of discs and drums; and where a bearing that the
// arrangement does not show has room.

#include <algorithm>
#include <cmath>
#include <numeric>

#include "core/machine/solids/gear_body.h"
#include "core/presentation/schematic/shaft_planner.h"

namespace geargraph {
namespace {

constexpr double kBetweenWalls = 9;

}  // namespace

/// The link's shaft on an axis, of several the one nearest to a place.
std::size_t ShaftPlanner::shaftAt(int a, int link, double place) const {
  std::size_t found = kNoShaft;
  double nearest = 1e300;
  for (const std::size_t s : m_train.arrangement.shaftsOn[a]) {
    const ShaftSegment& shaft = m_train.arrangement.shafts[s];
    if (shaft.link != link) continue;
    const auto [low, high] = std::minmax({placeOf(a, shaft.low), placeOf(a, shaft.high)});
    const double away = std::max({low - place, place - high, 0.0});
    if (away >= nearest) continue;
    nearest = away;
    found = s;
  }
  return found;
}

double ShaftPlanner::laneHeight(int a, int link, double place) const {
  const std::size_t shaft = shaftAt(a, link, place);
  return shaft == kNoShaft ? 0 : m_depths[shaft] * kLaneHeight;
}

/// The height of the rim of the link's ring at this coordinate, if the radius is that of its body.
std::optional<double> ShaftPlanner::rimHeight(int a, int link, double coordinate, double radius) const {
  for (std::size_t w = 0; w < m_layout.wheels.size(); ++w) {
    const SheetWheel& wheel = m_layout.wheels[w];
    if (wheel.axis != a || wheel.link != link || !wheel.isRing()) continue;
    const GearSpec& spec = m_train.wheels.wheels[w].spec;
    const double half = spec.faceWidth / 2;
    const double away = std::abs(line(a).coordinate(m_train.wheels.wheels[w].origin) - coordinate);
    const double beyond = 1.6 * line(a).module;  // a row of the half plane
    if (away < half && nominalTipRadius(spec) < radius && radius < rimDiameter(spec) / 2 + beyond)
      return wheel.radius + kRimHeight;
  }
  return std::nullopt;
}

/// The height of a level wall: to scale, but clear of what it encloses in the machine. `number`: its position
/// in the arrangement. @pre walls of smaller radius have their heights
double ShaftPlanner::levelHeight(const WallPlan& wall, std::size_t number) const {
  for (const double end : {wall.fromAt, wall.toAt}) {
    if (const auto rim = rimHeight(wall.axisGroup, wall.link, end, wall.fromRadius)) return *rim;
  }
  const int a = wall.axisGroup;
  const auto [low, high] = std::minmax({placeOf(a, wall.fromAt), placeOf(a, wall.toAt)});
  double height = wall.fromRadius * m_layout.scale;
  const auto passes = [&](double above) { height = std::max(height, above + kBetweenWalls); };
  const Arrangement& arrangement = m_train.arrangement;
  for (const std::size_t s : arrangement.shaftsOn[a]) {
    const ShaftSegment& shaft = arrangement.shafts[s];
    if (shaft.link != 0 && shaft.low < wall.toAt && wall.fromAt < shaft.high)
      passes(m_depths[s] * kLaneHeight + kBearingGap + kHatching);
  }
  for (std::size_t w = 0; w < m_layout.wheels.size(); ++w) {
    const SheetWheel& wheel = m_layout.wheels[w];
    const double place = placeOf(wheel);
    if (!areParallel(a, wheel.axis) || place < low - tolerance(a) || place > high + tolerance(a)) continue;
    const Eigen::Vector3d apart = line(wheel.axis).point - line(a).point;
    const double distance = (apart - apart.dot(line(a).direction) * line(a).direction).norm();
    const GearSpec& spec = m_train.wheels.wheels[w].spec;
    const double rim = wheel.isRing() ? rimDiameter(spec) / 2 : nominalTipRadius(spec);
    const double top = wheel.radius + (wheel.isRing() ? kRimHeight : 0);
    if (distance + rim < wall.fromRadius) passes(axis(a).heightOf(axis(wheel.axis).origin) + top);
  }
  for (std::size_t other = 0; other < arrangement.walls.size(); ++other) {
    const WallPlan& inner = arrangement.walls[other];
    if (other == number || inner.axisGroup != a || inner.fromAt == inner.toAt) continue;
    if (inner.fromRadius < wall.fromRadius && inner.fromAt < wall.toAt && wall.fromAt < inner.toAt)
      passes(m_levels[other]);
  }
  return height;
}

/// Heights of the level walls, from the axes outwards.
void ShaftPlanner::layWalls() {
  const std::vector<WallPlan>& walls = m_train.arrangement.walls;
  m_levels.assign(walls.size(), 0);
  std::vector<std::size_t> order(walls.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return walls[a].fromRadius < walls[b].fromRadius; });
  for (const std::size_t w : order) {
    if (walls[w].fromAt < walls[w].toAt) m_levels[w] = levelHeight(walls[w], w);
  }
}

/// The height of an end of an upright wall: that of the level wall, the ring or the pin that it joins there.
double ShaftPlanner::heightOf(const WallPlan& wall, double coordinate, double radius) const {
  const double same = 1e-6 * line(wall.axisGroup).module;
  const std::vector<WallPlan>& walls = m_train.arrangement.walls;
  for (std::size_t w = 0; w < walls.size(); ++w) {
    const WallPlan& level = walls[w];
    const bool joins = level.axisGroup == wall.axisGroup && level.link == wall.link &&
                       level.fromAt < level.toAt && level.fromAt - same <= coordinate &&
                       coordinate <= level.toAt + same && std::abs(level.fromRadius - radius) <= same;
    if (joins) return m_levels[w];
  }
  if (const auto rim = rimHeight(wall.axisGroup, wall.link, coordinate, radius)) return *rim;
  for (const PinPlan& pin : m_train.arrangement.pins) {
    if (pin.link != wall.link) continue;
    const Eigen::Vector3d apart = line(pin.axisGroup).point - line(wall.axisGroup).point;
    const Eigen::Vector3d along = line(wall.axisGroup).direction;
    if (std::abs((apart - apart.dot(along) * along).norm() - radius) <= same)
      return axis(wall.axisGroup).heightOf(axis(pin.axisGroup).origin);
  }
  return radius * m_layout.scale;
}

/// In the widest gap along the child's shafts that no other shaft encloses, or outside of all; without a
/// shaft on its largest drum.
double ShaftPlanner::hiddenPlace(SheetBearing& bearing) {
  const Arrangement& arrangement = m_train.arrangement;
  const int a = bearing.axis;
  std::vector<double> taken;
  for (const Spot& spot : m_spots) {
    if (spot.axis == a && !spot.spans.empty()) taken.push_back(spot.place);
  }
  for (const Held& held : m_held) {
    if (held.axis == a) taken.push_back(m_spots[held.spot].place);
  }
  std::sort(taken.begin(), taken.end());
  const double module = placeOf(a, line(a).module) - placeOf(a, 0);
  const double step = 2 * std::abs(module);
  double best = 0;
  double widest = -1e300;
  const auto offer = [&](double place, double width) {
    if (width <= widest) return;
    widest = width;
    best = place;
  };
  for (const std::size_t s : arrangement.shaftsOn[a]) {
    const ShaftSegment& shaft = arrangement.shafts[s];
    if (shaft.link != bearing.child) continue;
    const auto [low, high] = std::minmax({placeOf(a, shaft.low), placeOf(a, shaft.high)});
    const auto isEnclosed = [&, own = s](double place) {
      const auto& on = arrangement.shaftsOn[a];
      return std::any_of(on.begin(), on.end(), [&](std::size_t o) {
        const ShaftSegment& other = arrangement.shafts[o];
        const auto [from, to] = std::minmax({placeOf(a, other.low), placeOf(a, other.high)});
        return m_depths[o] > m_depths[own] && from < place && place < to;
      });
    };
    std::vector<double> edges{low, high};
    for (const double place : taken) {
      if (low < place && place < high) edges.push_back(place);
    }
    std::sort(edges.begin(), edges.end());
    for (std::size_t i = 1; i < edges.size(); ++i) {
      const double middle = (edges[i - 1] + edges[i]) / 2;
      offer(middle, edges[i] - edges[i - 1] - (isEnclosed(middle) ? 1e6 * step : 0));
    }
    const bool isFirst = taken.empty() || low <= taken.front();
    const bool isLast = taken.empty() || taken.back() <= high;
    if (isFirst) offer(low - step, 1e6 * step);
    if (isLast) offer(high + step, 1e6 * step);
  }
  if (widest > -1e300) return best;
  double largest = 0;
  for (std::size_t w = 0; w < arrangement.walls.size(); ++w) {
    const WallPlan& wall = arrangement.walls[w];
    if (wall.axisGroup != a || wall.link != bearing.child || wall.fromAt == wall.toAt) continue;
    if (wall.fromRadius * (wall.toAt - wall.fromAt) <= largest) continue;
    largest = wall.fromRadius * (wall.toAt - wall.fromAt);
    best = placeOf(a, (wall.fromAt + wall.toAt) / 2);
    bearing.height = m_levels[w];
  }
  if (largest > 0) return best;
  const auto& bearings = line(a).bearings;
  const auto own = std::find_if(bearings.begin(), bearings.end(),
                                [&](const Bearing& b) { return b.joint == bearing.joint; });
  return placeOf(a, own->at);
}

}  // namespace geargraph

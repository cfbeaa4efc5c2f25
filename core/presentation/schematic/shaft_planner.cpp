#include "core/presentation/schematic/shaft_planner.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

#include "core/machine/solids/gear_body.h"

namespace geargraph {
namespace {

constexpr double kStemHalf = 2;
constexpr double kArmHalf = 3;
constexpr double kSheetMargin = 20'000;  ///< from wheels and axes to the farthest bearing, px
constexpr double kPinEnd = 13;           ///< from a wheel to the end of its pin

Vector3 narrow(const Eigen::Vector3d& v) {
  return {v[0], v[1], v[2]};
}

}  // namespace

ShaftPlanner::ShaftPlanner(const DrawnPart& part, const DrawnTrain& train, SheetLayout& layout)
    : m_part(part), m_train(train), m_layout(layout), m_depths(nestingDepths(train.arrangement)) {}

ShaftPlan ShaftPlanner::plan() {
  findFamilies();
  addWheels();
  addRingCarriers();
  layWalls();
  addWalls();
  addBearings();
  separateArms();
  spanBearings();
  solve();
  takePlaces();
  addShafts();
  return std::move(m_plan);
}

void ShaftPlanner::findFamilies() {
  for (std::size_t a = 0; a < m_layout.axes.size(); ++a) {
    int family = static_cast<int>(a);
    for (std::size_t b = 0; b < a; ++b) {
      if (m_family[b] != static_cast<int>(b)) continue;
      if (std::abs(dot(m_layout.axes[a].along, turned(m_layout.axes[b].along))) < 1e-6)
        family = static_cast<int>(b);
    }
    m_family.push_back(family);
  }
}

/// Places that differ by less are one.
double ShaftPlanner::tolerance(int a) const {
  return kSameLevel * 1000 * line(a).module * (m_layout.parallel ? 1 : m_layout.scale);
}

/// Along the first axis of the family, so that places on parallel axes can be compared: in the document's
/// unit in a parallel layout, which is not to scale along its axes, else px.
double ShaftPlanner::placeOf(int a, double coordinate) const {
  const double space = axis(a).spaceCoordinate(narrow(line(a).at(coordinate)));
  if (m_layout.parallel) return space;
  return dot(axis(a).at(space * m_layout.scale, 0), first(a).along);
}

std::size_t ShaftPlanner::addSpot(int a, double coordinate) {
  Spot spot;
  spot.axis = a;
  spot.place = placeOf(a, coordinate);
  spot.wanted = spot.place;
  m_spots.push_back(spot);
  return m_spots.size() - 1;
}

void ShaftPlanner::occupy(std::size_t spot, double before, double after, double from, double to) {
  const int a = m_spots[spot].axis;
  if (isReversed(a)) std::swap(before, after);
  const auto across = [&](double height) {
    const SheetAxis& family = first(a);
    return dot(axis(a).at(0, height) - family.origin, family.up);
  };
  const auto add = [&](double low, double high) {
    const auto [least, most] = std::minmax({across(low), across(high)});
    m_spots[spot].spans.push_back({before, after, least, most});
  };
  add(from, to);
  if (!axis(a).half) add(-to, -from);
}

void ShaftPlanner::addWheels() {
  for (std::size_t w = 0; w < m_layout.wheels.size(); ++w) {
    const SheetWheel& wheel = m_layout.wheels[w];
    const TrainWheel& made = m_train.wheels.wheels[w];
    const AxisLayout& on = line(wheel.axis);
    const double sense = made.axis.dot(on.direction) < 0 ? -1 : 1;
    const AxialSpan face = axialSpan(made.spec);
    const double origin = on.coordinate(made.origin);
    WheelSpots spots;
    spots.at = addSpot(wheel.axis, origin + sense * (face.low + face.high) / 2);
    spots.low = spots.high = spots.at;
    const double rim = wheel.isRing() ? wheel.radius + kRimHeight : wheel.radius;
    const double foot = wheel.isRing() ? wheel.radius : 0;
    if (m_layout.parallel) {
      const auto [low, high] = std::minmax_element(made.planes.begin(), made.planes.end());
      const double a = origin + sense * *low, b = origin + sense * *high;
      if (*high - *low > on.module * 1e-6) {
        spots.low = addSpot(wheel.axis, sense < 0 ? b : a);
        spots.high = addSpot(wheel.axis, sense < 0 ? a : b);
      }
      for (const std::size_t spot : {spots.low, spots.high}) occupy(spot, kBarHalf, kBarHalf, foot, rim);
      if (spots.low != spots.high) occupy(spots.at, kStemHalf, kStemHalf, foot, rim);
    } else {
      const auto [low, high] = std::minmax({wheel.barFrom.x, wheel.barTo.x, wheel.at});
      occupy(spots.at, kStemHalf, kStemHalf, foot, wheel.radius);
      occupy(spots.at, wheel.at - low, high - wheel.at, std::min(wheel.barFrom.y, wheel.barTo.y),
             std::max(wheel.barFrom.y, wheel.barTo.y));
      m_spots[spots.at].fixed = dot(axis(wheel.axis).at(wheel.at, 0), first(wheel.axis).along);
    }
    m_wheelSpots.push_back(spots);
    const bool isHeld = !wheel.isRing() && !isInFrame(wheel);
    if (isHeld) m_held.push_back({wheel.axis, wheel.link, spots.at, 0, 0});
  }
}

void ShaftPlanner::addRingCarriers() {
  for (const RingCarrierPlan& ringCarrier : m_train.arrangement.ringCarriers) {
    const SheetWheel& wheel = m_layout.wheels[ringCarrier.gear];
    if (wheel.link == 0) continue;  // in the frame
    const std::size_t spot = addSpot(wheel.axis, ringCarrier.plate);
    occupy(spot, kStemHalf, kStemHalf, laneHeight(wheel.axis, wheel.link, m_spots[spot].place),
           wheel.radius + kRimHeight + 3);
    m_plan.ringCarriers.push_back({ringCarrier.gear, 0});
    m_ringCarrierSpots.push_back(spot);
    m_held.push_back({wheel.axis, wheel.link, spot, 0, 0});
  }
}

void ShaftPlanner::addWalls() {
  const std::vector<WallPlan>& walls = m_train.arrangement.walls;
  for (std::size_t w = 0; w < walls.size(); ++w) {
    const WallPlan& wall = walls[w];
    WallSpots spots;
    spots.from = addSpot(wall.axisGroup, wall.fromAt);
    spots.to = wall.fromAt < wall.toAt ? addSpot(wall.axisGroup, wall.toAt) : spots.from;
    SheetWall drawn{wall.axisGroup, wall.link, {}, {}};
    if (wall.fromAt < wall.toAt) {
      drawn.from.y = drawn.to.y = m_levels[w];
    } else {
      const double place = m_spots[spots.from].place;
      drawn.from.y = wall.isOnShaft ? laneHeight(wall.axisGroup, wall.link, place)
                                    : heightOf(wall, wall.fromAt, wall.fromRadius);
      drawn.to.y = heightOf(wall, wall.fromAt, wall.toRadius);
      occupy(spots.from, kStemHalf, kStemHalf, drawn.from.y, drawn.to.y);
      if (wall.isOnShaft) m_held.push_back({wall.axisGroup, wall.link, spots.from, 0, 0});
    }
    m_plan.walls.push_back(drawn);
    m_wallSpots.push_back(spots);
  }
}

/// The wheel of the child nearest to the middle of what the pin carries.
const SheetWheel* ShaftPlanner::wheelOnPin(const PinPlan& pin, int child) const {
  const SheetWheel* found = nullptr;
  const double middle = placeOf(pin.axisGroup, (pin.from + pin.to) / 2);
  const auto away = [&](const SheetWheel& wheel) { return std::abs(placeOf(wheel) - middle); };
  for (const SheetWheel& wheel : m_layout.wheels) {
    if (wheel.axis != pin.axisGroup || wheel.link != child) continue;
    if (found == nullptr || away(wheel) < away(*found)) found = &wheel;
  }
  return found;
}

void ShaftPlanner::addBearings() {
  const JointTree& tree = *m_train.placement.tree;
  std::set<JointId> driven;
  for (const Input& input : m_part.mechanism.inputs.value_or(std::vector<Input>{}))
    driven.insert(input.joint);
  m_plan.bearings.resize(tree.joints.size());
  m_bearingSpots.resize(tree.joints.size());
  for (const bool isShown : {true, false}) {  // what is hidden goes where the others leave room
    for (std::size_t c = 0; c < m_train.arrangement.axes.size(); ++c) {
      for (const Bearing& b : m_train.arrangement.axes[c].bearings) {
        if (b.isBoss() != isShown) continue;
        SheetBearing& bearing = m_plan.bearings[b.joint];
        bearing.joint = b.joint;
        bearing.axis = static_cast<int>(c);
        bearing.parent = b.parent;
        bearing.child = b.child;
        bearing.driven = driven.contains(m_part.mechanism.turningJoints[b.joint].id);
        addBearing(b.joint);
      }
    }
  }
}

void ShaftPlanner::addBearing(int joint) {
  SheetBearing& bearing = m_plan.bearings[joint];
  const Arrangement& arrangement = m_train.arrangement;
  const auto onAxis = [&](const auto& plan) {
    return plan.link == bearing.parent && plan.axisGroup == bearing.axis;
  };
  const auto& bearings = line(bearing.axis).bearings;
  const auto shown =
      std::find_if(bearings.begin(), bearings.end(), [&](const Bearing& b) { return b.joint == joint; });
  const auto pin = std::find_if(arrangement.pins.begin(), arrangement.pins.end(), onAxis);
  const auto boss =
      std::find_if(arrangement.crossShaftBosses.begin(), arrangement.crossShaftBosses.end(),
                   [&](const CrossShaftBossPlan& t) { return onAxis(t) && t.child == bearing.child; });
  std::size_t& spot = m_bearingSpots[joint];
  spot = addSpot(bearing.axis, shown->at);
  bearing.isHeld = bearing.parent == 0;
  if (pin != arrangement.pins.end() && !shown->isBoss()) {
    const SheetWheel* wheel = wheelOnPin(*pin, bearing.child);
    if (wheel != nullptr) spot = wheelSpot(*wheel);
  } else if (!shown->isBoss()) {
    m_spots[spot].place = m_spots[spot].wanted = hiddenPlace(bearing);
  }
  const double place = m_spots[spot].place;
  if (shaftAt(bearing.axis, bearing.child, place) != kNoShaft)
    bearing.height = laneHeight(bearing.axis, bearing.child, place);
  m_held.push_back({bearing.axis, bearing.child, spot, kShaftEnd, kShaftEnd});
  if (pin != arrangement.pins.end() && !shown->isBoss()) {
    addPin(*pin, bearing);
    bearing.isHeld = true;
    bearing.onPin = bearing.height > 0;
  } else if (boss != arrangement.crossShaftBosses.end()) {
    addCrossShaftBoss(*boss, bearing);
    bearing.isHeld = true;
  } else if (bearing.parent != 0 && axisOfLink(m_train.placement, bearing.parent) == bearing.axis) {
    m_held.push_back({bearing.axis, bearing.parent, spot, 0, 0});
    bearing.isHeld = true;
  } else if (bearing.parent != 0) {
    addArm(bearing);
  }
}

void ShaftPlanner::addPin(const PinPlan& pin, const SheetBearing& bearing) {
  const std::size_t start = addSpot(pin.axisGroup, pin.from);
  m_held.push_back({pin.axisGroup, pin.link, start, 0, 0});
  m_held.push_back({pin.axisGroup, pin.link, m_bearingSpots[bearing.joint], kPinEnd, kPinEnd});
  if (pin.home < 0 || areParallel(pin.home, pin.axisGroup)) return;
  m_spots[start].fixed = intersection(pin.axisGroup, pin.home);
  const std::size_t home = addSpot(pin.home, pin.level);
  m_spots[home].fixed = intersection(pin.home, pin.axisGroup);
  m_held.push_back({pin.home, pin.link, home, 0, 0});
}

/// The link's shaft comes as near to the intersection as the bars of the bearing.
void ShaftPlanner::addCrossShaftBoss(const CrossShaftBossPlan& boss, const SheetBearing& bearing) {
  m_spots[m_bearingSpots[bearing.joint]].fixed = intersection(boss.axisGroup, boss.home);
  const std::size_t home = addSpot(boss.home, boss.level);
  m_spots[home].fixed = intersection(boss.home, boss.axisGroup);
  const double reach = bearing.height + kBearingGap;
  m_held.push_back({boss.home, boss.link, home, -reach, -reach});
}

void ShaftPlanner::addArm(const SheetBearing& bearing) {
  SheetArm arm{bearing.parent, bearing.joint, -1, 0, false};
  const auto& arms = m_train.arrangement.arms;
  const auto found = std::find_if(arms.begin(), arms.end(), [&](const ArmPlan& a) {
    return a.link == bearing.parent && a.child == bearing.child && a.to == bearing.axis;
  });
  std::size_t spot = 0;
  if (found != arms.end()) {
    arm.axis = found->from;
    arm.isStraight = areParallel(arm.axis, bearing.axis);
    spot = addSpot(arm.axis, found->level);
    const double lane = laneHeight(arm.axis, arm.link, m_spots[spot].place);
    if (arm.isStraight) {
      m_spots[spot].place = m_spots[spot].wanted = m_spots[m_bearingSpots[bearing.joint]].place;
      const double end = axis(arm.axis).heightOf(axis(bearing.axis).origin);
      const double way = end < 0 ? -1 : 1;
      const auto [low, high] = std::minmax({way * lane, end - way * (bearing.height + kBearingGap)});
      if (low < high) occupy(spot, kArmHalf, kArmHalf, low, high);
    } else {
      occupy(spot, kArmHalf, kArmHalf, lane, lane + kArmHalf);
    }
    m_held.push_back({arm.axis, arm.link, spot, 0, 0});
  }
  m_plan.arms.push_back(arm);
  m_armSpots.push_back(spot);
}

/// Straight arms of a link in one plane to several axes would cover the bearings of the nearer ones: on the
/// sheet they are side by side, the farther ones beyond the ends of those shafts.
void ShaftPlanner::separateArms() {
  const auto endOf = [&](const SheetArm& arm) {
    return axis(arm.axis).heightOf(axis(m_plan.bearings[arm.joint].axis).origin);
  };
  for (std::size_t a = 0; a < m_plan.arms.size(); ++a) {
    const SheetArm& arm = m_plan.arms[a];
    if (!arm.isStraight) continue;
    Spot& bearing = m_spots[m_bearingSpots[arm.joint]];
    int passed = 0;
    for (std::size_t b = 0; b < m_plan.arms.size(); ++b) {
      const SheetArm& other = m_plan.arms[b];
      const bool isBeside = other.isStraight && other.link == arm.link && other.axis == arm.axis &&
                            std::abs(m_spots[m_armSpots[b]].place - bearing.place) <= tolerance(arm.axis);
      if (isBeside && endOf(arm) * endOf(other) > 0 && std::abs(endOf(other)) < std::abs(endOf(arm)) - 1)
        ++passed;
    }
    double sum = 0;  // towards what the child holds
    for (const Held& held : m_held) {
      const bool isChilds = held.axis == bearing.axis && held.link == m_plan.bearings[arm.joint].child;
      if (isChilds) sum += m_spots[held.spot].place - bearing.place;
    }
    bearing.rank = m_spots[m_armSpots[a]].rank = sum > 0 ? -passed : passed;
  }
}

/// The end of the child's shaft beside which it holds nothing; then what bearings occupy.
void ShaftPlanner::spanBearings() {
  for (SheetBearing& bearing : m_plan.bearings) {
    const std::size_t spot = m_bearingSpots[bearing.joint];
    double sum = 0;
    for (const Held& held : m_held) {
      if (held.axis == bearing.axis && held.link == bearing.child)
        sum += m_spots[held.spot].place - m_spots[spot].place;
    }
    if (isReversed(bearing.axis)) sum = -sum;
    bearing.freeEnd = sum < 0 ? 1 : -1;
    if (bearing.onPin) continue;
    const double reach = kBearingGap + (bearing.parent == 0 ? kHatching + 3 : 3);
    double before = kShaftEnd, after = kShaftEnd;
    if (bearing.driven) (bearing.freeEnd < 0 ? before : after) = kDrivenEnd;
    const bool onWall = shaftAt(bearing.axis, bearing.child, m_spots[spot].place) == kNoShaft;
    occupy(spot, before, after, onWall ? bearing.height - kStemHalf : -bearing.height - reach,
           bearing.height + reach);
    if (!bearing.driven) continue;
    Held end{bearing.axis, bearing.child, spot, 0, 0};
    (bearing.freeEnd < 0 ? end.before : end.after) = kDrivenEnd;
    m_held.push_back(end);
  }
}

/// Places that are one become equal.
void ShaftPlanner::sortByPlace(std::vector<std::size_t>& spots, double tolerance) {
  std::stable_sort(spots.begin(), spots.end(),
                   [&](std::size_t a, std::size_t b) { return m_spots[a].place < m_spots[b].place; });
  double last = -1e300;
  for (const std::size_t s : spots) {
    if (m_spots[s].place - last <= tolerance) m_spots[s].place = last;
    last = m_spots[s].place;
  }
  std::stable_sort(spots.begin(), spots.end(), [&](std::size_t a, std::size_t b) {
    return std::pair(m_spots[a].place, m_spots[a].rank) < std::pair(m_spots[b].place, m_spots[b].rank);
  });
}

/// px for all spots: family by family, spots at one place in one slot.
void ShaftPlanner::solve() {
  for (std::size_t family = 0; family < m_family.size(); ++family) {
    const SheetAxis& base = m_layout.axes[family];
    std::vector<std::size_t> spots;
    for (std::size_t s = 0; s < m_spots.size(); ++s) {
      if (m_family[m_spots[s].axis] == static_cast<int>(family)) spots.push_back(s);
    }
    if (spots.empty()) continue;
    sortByPlace(spots, tolerance(static_cast<int>(family)));
    double low = 1e300, high = -1e300;
    const auto include = [&](CanvasPoint p) {
      low = std::min(low, dot(p, base.along));
      high = std::max(high, dot(p, base.along));
    };
    for (const SheetWheel& wheel : m_layout.wheels) include(axis(wheel.axis).at(wheel.at, wheel.radius));
    if (m_layout.wheels.empty()) {
      for (const SheetAxis& other : m_layout.axes) include(other.origin);
    }
    std::vector<SheetSlot> slots;
    std::vector<std::size_t> slotOf;
    for (const std::size_t s : spots) {
      const Spot& spot = m_spots[s];
      const bool isNew = slotOf.empty() || spot.place != m_spots[spots[slotOf.size() - 1]].place ||
                         spot.rank != m_spots[spots[slotOf.size() - 1]].rank;
      if (isNew) slots.emplace_back();
      SheetSlot& slot = slots.back();
      if (isNew) {
        slot.place = spot.place;
        slot.wanted = std::clamp(spot.wanted, low - kSheetMargin, high + kSheetMargin);
      }
      if (spot.fixed) slot.fixed = spot.fixed;
      slot.spans.insert(slot.spans.end(), spot.spans.begin(), spot.spans.end());
      slot.axes.push_back(spot.axis);
      slotOf.push_back(slots.size() - 1);
    }
    for (SheetSlot& slot : slots) {
      std::sort(slot.axes.begin(), slot.axes.end());
      slot.axes.erase(std::unique(slot.axes.begin(), slot.axes.end()), slot.axes.end());
    }
    m_layout.parallel ? packSlots(slots) : spreadSlots(slots);
    for (std::size_t i = 0; i < spots.size(); ++i) m_spots[spots[i]].at = slots[slotOf[i]].at;
  }
}

double ShaftPlanner::atOn(int a, std::size_t spot) const {
  const CanvasPoint along = first(a).along;
  const double way = isReversed(a) ? -1 : 1;
  return way * (m_spots[spot].at - dot(axis(a).origin, along));
}

/// px along the first axis of a's family where the other axis crosses it.
double ShaftPlanner::intersection(int a, int other) const {
  const SheetAxis& on = axis(a);
  const SheetAxis& across = axis(other);
  const double sine = dot(on.along, turned(across.along));
  const double coordinate =
      std::abs(sine) < 1e-6 ? 0 : dot(across.origin - on.origin, turned(across.along)) / sine;
  return dot(on.at(coordinate, 0), first(a).along);
}

void ShaftPlanner::takePlaces() {
  for (SheetBearing& bearing : m_plan.bearings)
    bearing.at = atOn(bearing.axis, m_bearingSpots[bearing.joint]);
  for (std::size_t c = 0; c < m_plan.ringCarriers.size(); ++c)
    m_plan.ringCarriers[c].at =
        atOn(m_layout.wheels[m_plan.ringCarriers[c].wheel].axis, m_ringCarrierSpots[c]);
  for (std::size_t a = 0; a < m_plan.arms.size(); ++a) {
    if (m_plan.arms[a].axis >= 0) m_plan.arms[a].at = atOn(m_plan.arms[a].axis, m_armSpots[a]);
  }
  for (std::size_t w = 0; w < m_plan.walls.size(); ++w) {
    SheetWall& wall = m_plan.walls[w];
    wall.from.x = atOn(wall.axis, m_wallSpots[w].from);
    wall.to.x = atOn(wall.axis, m_wallSpots[w].to);
  }
  if (!m_layout.parallel) return;
  for (std::size_t w = 0; w < m_layout.wheels.size(); ++w) {
    SheetWheel& wheel = m_layout.wheels[w];
    wheel.at = atOn(wheel.axis, m_wheelSpots[w].at);
    wheel.low = atOn(wheel.axis, m_wheelSpots[w].low);
    wheel.high = atOn(wheel.axis, m_wheelSpots[w].high);
    wheel.barFrom.x = wheel.low - kBarHalf;
    wheel.barTo.x = wheel.high + kBarHalf;
  }
}

/// Shafts of the arrangement from the first to the last thing that they hold. The ground's are short feet of
/// its wheels: it is drawn as hatching.
void ShaftPlanner::addShafts() {
  constexpr double kFootHalf = 12;
  const std::vector<ShaftSegment>& shafts = m_train.arrangement.shafts;
  for (std::size_t s = 0; s < shafts.size(); ++s) {
    const int a = shafts[s].axisGroup;
    const int link = shafts[s].link;
    SheetShaft drawn{a,      link,        1e300,
                     -1e300, m_depths[s], link != 0 && axisOfLink(m_train.placement, link) == a};
    for (const Held& held : m_held) {
      if (held.axis != a || held.link != link) continue;
      if (shaftAt(a, link, m_spots[held.spot].place) != s) continue;
      const double x = atOn(a, held.spot);
      drawn.low = std::min(drawn.low, x - held.before);
      drawn.high = std::max(drawn.high, x + held.after);
    }
    if (drawn.low > drawn.high) continue;
    if (!drawn.turns && drawn.high - drawn.low < 2 * kFootHalf) {
      drawn.low -= kFootHalf;
      drawn.high += kFootHalf;
    }
    m_plan.shafts.push_back(drawn);
  }
  for (const SheetBearing& bearing : m_plan.bearings) {  // links that hold nothing but are held
    const bool isBare =
        m_plan.shaft(bearing.axis, bearing.child, bearing.at) == nullptr && bearing.height == 0;
    if (isBare)
      m_plan.shafts.push_back(
          {bearing.axis, bearing.child, bearing.at - kShaftEnd, bearing.at + kShaftEnd, 0, true});
  }
}

}  // namespace geargraph

#include "core/machine/arrangement/body_planner.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

#include "core/machine/arrangement/coaxial_plan.h"
#include "core/machine/arrangement/coaxial_sections.h"
#include "core/machine/solids/gear_body.h"

namespace geargraph::inline arrangement {

using Eigen::Vector3d;

namespace {

/// Modules: lengths that differ by less are equal where they are sorted.
constexpr double kEqual = 1e-6;

}  // namespace

/// Linked sets: sleeves, discs and drums of one axis, with the bearings and arms on it.
void BodyPlanner::planCoaxial(int axisClass) {
  if (!needsCoaxialPlan(axisClass, m_placement, m_train)) return;
  const auto plan = coaxialPlan(axisClass, m_plan.axes, m_placement, m_train, m_stop);
  if (!plan) {
    m_plan.blocked.emplace_back();
    for (const Bearing& b : axis(axisClass).bearings) m_plan.blocked.back().push_back(b.child);
    return;
  }
  m_coaxial[static_cast<std::size_t>(axisClass)] = true;
  axis(axisClass).thickness = plan->width;
  for (const CoaxialBearing& placed : plan->bearings) {
    const int c = m_placement.classes->classOf[static_cast<std::size_t>(placed.joint)];
    axis(c).thickness = plan->width;
    for (Bearing& b : axis(c).bearings) {
      if (b.joint != placed.joint) continue;
      b.at = placed.at;
      b.form = placed.form;
      b.placed = true;
    }
  }
  for (const ShaftSegment& shaft : plan->shafts) {
    m_plan.shaftsOn[static_cast<std::size_t>(axisClass)].push_back(m_plan.shafts.size());
    m_plan.shafts.push_back(shaft);
  }
  for (const ArmPlan& arm : plan->arms) addArm(arm);
  m_plan.pins.insert(m_plan.pins.end(), plan->pins.begin(), plan->pins.end());
  m_plan.lathes.insert(m_plan.lathes.end(), plan->lathes.begin(), plan->lathes.end());
  m_plan.walls.insert(m_plan.walls.end(), plan->walls.begin(), plan->walls.end());
  m_plan.cages.insert(m_plan.cages.end(), plan->cages.begin(), plan->cages.end());
  m_plan.hubs.insert(m_plan.hubs.end(), plan->hubs.begin(), plan->hubs.end());
}

/// Does a plate of the ring's cup at this place cut through planets that have wheels on both of its sides?
bool BodyPlanner::cutsPlanets(const TrainGear& ring, double plate) const {
  const AxisLayout& own = axis(ring.axisClass);
  const double half = own.width() / 2 + own.gap() / 2;
  return std::any_of(m_train.gears.begin(), m_train.gears.end(), [&](const TrainGear& gear) {
    const int c = gear.axisClass;
    if (c == ring.axisClass || !parallel(ring.axisClass, c)) return false;
    const Vector3d apart = axis(c).point - own.point;
    if ((apart - apart.dot(own.direction) * own.direction).norm() > rimDiameter(ring.spec) / 2) return false;
    const auto span = axis(c).wheelsOf(gear.link);
    const auto [low, high] =
        std::minmax({carried(c, span->low, ring.axisClass), carried(c, span->high, ring.axisClass)});
    return own.overlap(low, high, plate - half, plate + half);
  });
}

/// The face of a ring that its other wheels on the axis call for, or that lets wheels inside out which the
/// frame holds; 0: neither.
int BodyPlanner::cupSideFor(const TrainGear& ring) const {
  const AxisLayout& own = axis(ring.axisClass);
  const double middle = own.coordinate(ring.pose.translation());
  double others = 0;
  for (const std::size_t g : m_gearsOn[static_cast<std::size_t>(ring.axisClass)]) {
    const TrainGear& gear = m_train.gears[g];
    if (gear.link == ring.link) others += own.coordinate(gear.pose.translation()) - middle;
  }
  if (std::abs(others) > own.module) return others < 0 ? -1 : 1;
  const bool holdsFixed = std::any_of(ring.meshes.begin(), ring.meshes.end(), [&](int mesh) {
    return std::any_of(m_train.gears.begin(), m_train.gears.end(), [&](const TrainGear& gear) {
      const bool meshes = std::find(gear.meshes.begin(), gear.meshes.end(), mesh) != gear.meshes.end();
      return meshes && gear.axisClass != ring.axisClass &&
             m_placement.classes->classes[static_cast<std::size_t>(gear.axisClass)].top == 0;
    });
  });
  return holdsFixed ? -own.bearingSide : 0;
}

/// Rings get the face on the bearing side, so that carriers find the other one free.
void BodyPlanner::placeCups() {
  for (std::size_t g = 0; g < m_train.gears.size(); ++g) {
    const TrainGear& gear = m_train.gears[g];
    if (gear.spec.kind != GearKind::internal || isCoaxial(gear.axisClass)) continue;
    AxisLayout& layout = axis(gear.axisClass);
    const double middle = layout.coordinate(gear.pose.translation());
    const double reach = gear.spec.faceWidth / 2 + layout.gap() + layout.width() / 2;
    const int wanted = cupSideFor(gear);
    int side = wanted != 0 ? wanted : layout.bearingSide;
    const auto isOpen = [&](int towards) {
      const double plate = middle + towards * reach;
      return layout.slotIsFree(plate) && !cutsPlanets(gear, plate);
    };
    if (!isOpen(side) && (isOpen(-side) || !layout.slotIsFree(middle + side * reach))) side = -side;
    m_plan.cups.push_back({static_cast<int>(g), side, middle + side * reach});
    layout.take(middle + side * reach, gear.link);
  }
}

/// The bearings that a link holds, a round at a time: one of each axis parallel to its own (its own
/// included), those whose wheels are nearest the bearings' end first.
std::vector<std::vector<Bearing*>> BodyPlanner::roundsOf(int link, int home) {
  std::vector<std::vector<Bearing*>> rounds;
  const auto& held = m_heldBy[static_cast<std::size_t>(link)];
  for (std::size_t first = 0; first < held.size();) {
    const int c = held[first].first;
    AxisLayout& layout = axis(c);
    std::vector<Bearing*> here;
    for (; first < held.size() && held[first].first == c; ++first) {
      Bearing& bearing = layout.bearings[held[first].second];
      if (!bearing.placed) here.push_back(&bearing);
    }
    if (!parallel(home, c)) continue;
    const auto rounded = [&](double depth) { return std::round(depth / (kEqual * layout.module)); };
    const auto depth = [&](const Bearing* b) {
      if (m_tries.roomFor.contains(b->child) || m_tries.roundBearings.contains(b->child)) return 1e300;
      double nearest = -1e300;                 // a link without wheels has the inmost shaft
      for (const Stretch& s : layout.taken) {  // wheels and cups
        if (s.link == b->child) nearest = std::max(nearest, layout.bearingSide * (s.low + s.high) / 2);
      }
      return nearest;
    };
    std::stable_sort(here.begin(), here.end(), [&](const Bearing* x, const Bearing* y) {
      return rounded(depth(x)) > rounded(depth(y));
    });
    for (std::size_t i = 0; i < here.size(); ++i) {
      if (rounds.size() <= i) rounds.emplace_back();
      rounds[i].push_back(here[i]);
    }
  }
  return rounds;
}

void BodyPlanner::placeLink(int link) {
  const auto& held = m_heldBy[static_cast<std::size_t>(link)];
  if (held.empty()) return;
  const int home = homeOf(link);
  const std::vector<int> reserved = link == 0 ? reserveRoom() : std::vector<int>();
  for (const auto& round : roundsOf(link, home)) {
    if (isStopped()) return;
    placeParallel(link, home, round);
  }
  for (std::size_t i = 0; i < held.size(); ++i) {
    const int c = held[i].first;
    if (!parallel(home, c) && (i == 0 || held[i - 1].first != c)) placeTee(link, home, c);
  }
  for (const auto& [c, b] : held) {
    if (isStopped()) return;
    if (!parallel(home, c) && !axis(c).bearings[b].placed) placeCrossing(link, home, axis(c).bearings[b]);
  }
  for (const int c : reserved)
    std::erase_if(axis(c).taken, [](const Stretch& s) { return s.link == kReserved; });
}

/// Is a level free on the axes of all these bearings, and can straight arms reach them from the link's own?
bool BodyPlanner::fits(int link, int home, const std::vector<Bearing*>& round, double level) const {
  std::vector<int> involved{home};
  for (const Bearing* b : round) {
    involved.push_back(classOf(*b));
    const double at = carried(home, level, involved.back());
    if (!axis(involved.back()).nests(*b, at) || !shaftPasses(*b, at)) return false;
    if (link != 0 && (meetsArms(*b, at) || sweepsShafts(link, home, level, involved.back()))) return false;
  }
  for (const int c : involved) {
    if (!axis(c).slotIsFree(carried(home, level, c))) return false;
  }
  if (!round.empty() && !axis(home).emerges(round.front()->parent, level)) return false;
  if (link != 0 && isTrapped(link, home, level)) return false;
  const AxisLayout& own = axis(home);
  const auto gears = m_obstacles.inPlane(own.at(level), own.direction, own.width() / 2 + own.gap() / 2);
  const double margin = own.width() / 2 + 0.3 * own.module;
  const std::vector<Bar> bars = barsOf(link, home, round, level);
  return std::all_of(bars.begin(), bars.end(), [&](const Bar& bar) {
    const Vector3d start = axis(bar.from).at(carried(home, level, bar.from));
    const Vector3d end = axis(bar.to).at(carried(home, level, bar.to));
    return m_obstacles.isClear(gears, start, end, 2.5 * own.module) &&
           m_obstacles.crossingHits(link, start, end, margin, own.direction) == 0;
  });
}

/// A level at which the link's arms lie in one plane, beside the wheels: the free one nearest to what is
/// drawn. The ground stands at the bearings' end, behind everything; carriers keep to the other. None where
/// there is none.
std::optional<double> BodyPlanner::commonLevel(int link, int home, const std::vector<Bearing*>& round) const {
  const int side = axis(home).bearingSide;
  std::vector<int> involved{home};
  std::vector<double> candidates;
  std::vector<double> edges;  // of what stands on the axes, towards the bearings' end
  for (const Bearing* b : round) {
    const int c = classOf(*b);
    if (c != home) involved.push_back(c);
    candidates.push_back(carried(c, b->at, home));
  }
  const double wanted = candidates.front();
  for (const int c : involved) {
    for (const double x : axis(c).slotCandidates()) candidates.push_back(carried(c, x, home));
    for (const Stretch& s : axis(c).taken)
      edges.push_back(side * carried(c, side < 0 ? s.low : s.high, home));
  }
  std::sort(edges.begin(), edges.end());
  const auto cost = [&](double x) {
    double sum = std::abs(x - wanted);
    if (link == 0 && std::abs(x - wanted) > kSameLevel * axis(home).module) {
      const auto beyond = edges.end() - std::upper_bound(edges.begin(), edges.end(),
                                                         side * x + kSameLevel * axis(home).module);
      sum += 1000 * axis(home).module * static_cast<double>(beyond);
    } else if (axis(home).isBelow(side * wanted, side * x)) {
      sum += 2 * axis(home).module;
    }
    if (link != 0) sum += 1000 * axis(home).module * static_cast<double>(enclosedBy(link, home, x));
    return sum;
  };
  std::vector<std::pair<double, double>> byCost;
  for (const double x : candidates) {
    if (isStopped()) return std::nullopt;
    byCost.emplace_back(std::round(cost(x) / (kEqual * axis(home).module)), x);
  }
  std::sort(byCost.begin(), byCost.end(), [side](const auto& a, const auto& b) {
    return a.first != b.first ? a.first < b.first : side * a.second < side * b.second;
  });
  std::transform(byCost.begin(), byCost.end(), candidates.begin(),
                 [](const auto& each) { return each.second; });
  const auto same = [&](double a, double b) { return std::abs(a - b) < 1e-6 * axis(home).module; };
  candidates.erase(std::unique(candidates.begin(), candidates.end(), same), candidates.end());
  constexpr std::size_t kTries = 40;
  for (std::size_t i = 0; i < std::min(candidates.size(), kTries); ++i) {
    if (isStopped()) return std::nullopt;
    if (fits(link, home, round, candidates[i])) return candidates[i];
  }
  return std::nullopt;
}

void BodyPlanner::placeParallel(int link, int home, std::vector<Bearing*> round) {
  if (link == 0) {  // what cannot reach the frame behind everything else stands on feet of its own
    const double behind = outmostLevel(home, round);
    std::erase_if(round, [&](Bearing* b) {
      if (isStopped()) return false;
      const int c = classOf(*b);
      if (shaftPasses(*b, carried(home, behind, c))) return false;
      const auto place = boltPlace(*b);
      if (place) boltDown(*b, *place);
      return place.has_value();
    });
    if (round.empty()) return;
    const auto isHome = [&](const Bearing* b) { return classOf(*b) == home; };
    if (std::none_of(round.begin(), round.end(), isHome)) home = classOf(*round.back());
  }
  const std::optional<double> found = commonLevel(link, home, round);
  if (!found && link == 0) {
    for (Bearing* b : round) boltDownOrSay(*b);
    return;
  }
  if (!found) {
    m_wantRoom.insert(link);
    m_plan.blocked.push_back({link});
    for (const Bearing* b : round) m_plan.blocked.back().push_back(b->child);
  }
  const double level = found ? *found : outmostLevel(home, round);
  axis(home).take(level, link);
  const std::vector<Bar> bars = barsOf(link, home, round, level);
  for (Bearing* b : round) {
    const int c = classOf(*b);
    b->at = carried(home, level, c);
    b->placed = true;
    if (c == home) continue;
    axis(c).take(b->at, link);
    const auto bar = std::find_if(bars.begin(), bars.end(), [c](const Bar& each) { return each.to == c; });
    addArm({link, bar->from, carried(home, level, bar->from), c, b->at, b->child});
  }
}

/// A frame has no shaft of its own: its arms begin about the shaft of the one link that it holds on their
/// axis, where nobody else's wheels are in between.
std::optional<double> BodyPlanner::heldLevel(int axisClass, int link) const {
  const AxisLayout& layout = axis(axisClass);
  if (layout.bearings.size() != 1 || layout.bearings.front().child != link) return std::nullopt;
  const Bearing& bearing = layout.bearings.front();
  if (bearing.parent != 0) return std::nullopt;
  for (const std::size_t a : m_armsOf[0]) {
    const ArmPlan& arm = m_plan.arms[a];
    if (arm.from != axisClass || std::abs(arm.level - bearing.at) <= kSameLevel * layout.module) continue;
    const double low = std::min(arm.level, bearing.at);
    const double high = std::max(arm.level, bearing.at);
    const bool blocked = std::any_of(layout.taken.begin(), layout.taken.end(), [&](const Stretch& s) {
      return s.link != link && s.link != 0 && layout.overlap(s.low, s.high, low, high);
    });
    if (!blocked) return arm.level;
  }
  return std::nullopt;
}

namespace {

/// Does an axis cross this one between the shaft and a place outside of it?
bool isAcross(const AxisLayout& layout, const ShaftSegment& shaft, double place) {
  const double low = std::min(shaft.high, place), high = std::max(shaft.low, place);
  return std::any_of(layout.taken.begin(), layout.taken.end(), [&](const Stretch& s) {
    return s.link < 0 && layout.overlap(s.low, s.high, low, high);
  });
}

}  // namespace

/// A wheel of the frame that none of its bearings reaches stands on a foot of its own, on the side where
/// nothing crosses its axis.
void BodyPlanner::addStub(int axisClass, ShaftSegment& shaft) {
  AxisLayout& layout = axis(axisClass);
  const double reach = layout.gap() + layout.width() / 2;
  double place = shaft.low - reach;
  const double other = shaft.high + reach;
  const auto isBetter = [&](double x) { return layout.slotIsFree(x) && !isAcross(layout, shaft, x); };
  if (!isBetter(place) && isBetter(other)) place = other;
  shaft.include(place - layout.width() / 2, place + layout.width() / 2);
  layout.take(place, 0);
  m_plan.stubs.push_back({axisClass, place});
}

/// True where the link has wheels here.
bool BodyPlanner::includeWheels(int axisClass, int link, ShaftSegment& shaft) {
  const Stretch hubs = hubStretch(axisClass, link);
  if (hubs.low > hubs.high) return false;
  shaft.include(hubs.low, hubs.high);
  return true;
}

/// Arms, cups, tees and pins of the link that stand on the axis.
void BodyPlanner::includeBodies(int axisClass, int link, ShaftSegment& shaft) {
  const double half = axis(axisClass).width() / 2;
  for (const std::size_t a : m_armsOf[static_cast<std::size_t>(link)]) {
    const ArmPlan& arm = m_plan.arms[a];
    if (arm.from == axisClass) shaft.include(arm.level - half, arm.level + half);
  }
  if (const auto level = heldLevel(axisClass, link)) shaft.include(*level - half, *level + half);
  for (const CupPlan& cup : m_plan.cups) {
    const TrainGear& gear = m_train.gears[static_cast<std::size_t>(cup.gear)];
    if (gear.link == link && gear.axisClass == axisClass) shaft.include(cup.plate - half, cup.plate + half);
  }
  for (const TeePlan& tee : m_plan.tees) {
    if (tee.link == link && tee.home == axisClass) shaft.include(tee.level, tee.level);
    if (tee.child == link && tee.axisClass == axisClass) shaft.include(tee.low, tee.high);
  }
  for (const PinPlan& pin : m_plan.pins) {
    if (pin.link == link && pin.home == axisClass) shaft.include(pin.level, pin.level);
    if (pin.link == link && pin.axisClass == axisClass)
      shaft.include(std::min(pin.from, pin.to), std::max(pin.from, pin.to));
  }
}

/// A shaft reaches from the link's wheels to its bearing, its arms and cups on this axis.
void BodyPlanner::addShaft(int axisClass, int link) {
  const AxisLayout& layout = axis(axisClass);
  ShaftSegment shaft;
  shaft.axisClass = axisClass;
  shaft.link = link;
  const double half = layout.width() / 2;
  const bool turns = m_placement.classes->classOfLink(link) == axisClass;
  const bool holdsWheel = includeWheels(axisClass, link, shaft);
  includeBodies(axisClass, link, shaft);
  const Bearing* nearest = nullptr;  // what holds a wheel that does not turn here
  const auto away = [&](const Bearing& b) { return std::max({b.at - shaft.high, shaft.low - b.at, 0.0}); };
  for (const Bearing& b : layout.bearings) {
    if (!b.isEye()) continue;
    if (b.parent == link && (nearest == nullptr || layout.isBelow(away(b), away(*nearest)))) nearest = &b;
    if (turns && (b.child == link || b.parent == link)) shaft.include(b.at - half, b.at + half);
  }
  if (!turns && nearest != nullptr && !isAcross(layout, shaft, nearest->at)) {
    shaft.include(nearest->at - half, nearest->at + half);
  } else if (link == 0 && holdsWheel) {
    addStub(axisClass, shaft);
  }
  if (shaft.low < shaft.high) {
    shaft.low -= 0.4 * layout.gap();  // neighbours do not touch
    shaft.high += 0.4 * layout.gap();
    m_plan.shaftsOn[static_cast<std::size_t>(axisClass)].push_back(m_plan.shafts.size());
    m_plan.shafts.push_back(shaft);
  }
}

/// Wheels that stand on an axis without turning about it are held by the bearings that their link has there,
/// rings by the tube between their cup and these.
void BodyPlanner::addFixedHubs() {
  for (const TrainGear& gear : m_train.gears) {
    const bool turns = m_placement.classes->classOfLink(gear.link) == gear.axisClass;
    if (turns || isCoaxial(gear.axisClass)) continue;
    if (m_plan.shaftOf(gear.axisClass, gear.link, 0) == nullptr) addShaft(gear.axisClass, gear.link);
  }
}

/// Largest radius that the bores of the link's wheels on this axis allow.
double BodyPlanner::boreRoom(int axisClass, int link) const {
  double room = 1e300;
  for (const std::size_t g : m_gearsOn[static_cast<std::size_t>(axisClass)]) {
    const TrainGear& gear = m_train.gears[g];
    if (gear.link != link || gear.spec.kind == GearKind::internal) continue;
    room = std::min(room, shaftRoom(gear.spec));
  }
  return room;
}

/// How many wheels, cups and arms of a link another shaft on the axis would cut through if it went about the
/// link's own.
int BodyPlanner::cutsBy(const ShaftSegment& outer, int link) const {
  const AxisLayout& layout = axis(outer.axisClass);
  const auto isCut = [&](double low, double high) {
    return layout.overlap(low, high, outer.low, outer.high) ? 1 : 0;
  };
  const double half = layout.width() / 2;
  int cuts = 0;
  for (const std::size_t g : m_gearsOn[static_cast<std::size_t>(outer.axisClass)]) {
    const TrainGear& gear = m_train.gears[g];
    if (gear.link != link || gear.spec.kind == GearKind::internal) continue;
    const AxialSpan span = axialSpan(gear.spec);
    const double sense = gear.pose.linear().col(2).dot(layout.direction) < 0 ? -1 : 1;
    const double origin = layout.coordinate(gear.pose.translation());
    const auto [low, high] = std::minmax({origin + sense * span.low, origin + sense * span.high});
    cuts += isCut(low, high);
  }
  for (const CupPlan& cup : m_plan.cups) {
    const TrainGear& ring = m_train.gears[static_cast<std::size_t>(cup.gear)];
    if (ring.link == link && ring.axisClass == outer.axisClass)
      cuts += isCut(cup.plate - half, cup.plate + half);
  }
  for (const std::size_t a : m_armsOf[static_cast<std::size_t>(link)]) {
    const ArmPlan& arm = m_plan.arms[a];
    if (arm.from == outer.axisClass) cuts += isCut(arm.level - half, arm.level + half);
  }
  return cuts;
}

/// Shafts that lie over each other are nested: inmost comes the one of whose wheels, arms and cups the others
/// would cut through the least, of several the longest. All of an axis shrink together until the bores of
/// their wheels hold them.
void BodyPlanner::nestShafts(int axisClass) {
  std::vector<ShaftSegment*> open;
  for (const std::size_t s : m_plan.shaftsOn[static_cast<std::size_t>(axisClass)]) {
    open.push_back(&m_plan.shafts[s]);
  }
  const double module = axis(axisClass).module;
  const auto length = [&](const ShaftSegment* s) {
    return std::round((s->high - s->low) / (kEqual * module));
  };
  std::stable_sort(open.begin(), open.end(),
                   [&](const ShaftSegment* a, const ShaftSegment* b) { return length(a) > length(b); });
  std::vector<ShaftSegment*> shafts;
  while (!open.empty()) {
    const auto cuts = [&](const ShaftSegment* inner) {
      int sum = 0;
      for (const ShaftSegment* outer : open) {
        if (outer->link != inner->link &&
            axis(axisClass).overlap(outer->low, outer->high, inner->low, inner->high))
          sum += cutsBy(*outer, inner->link);
      }
      return sum;
    };
    const auto next =
        std::min_element(open.begin(), open.end(),
                         [&](const ShaftSegment* a, const ShaftSegment* b) { return cuts(a) < cuts(b); });
    shafts.push_back(*next);
    open.erase(next);
  }
  double scale = 1;
  for (std::size_t i = 0; i < shafts.size(); ++i) {
    ShaftSegment& shaft = *shafts[i];
    double inside = 0;
    for (std::size_t k = 0; k < i; ++k) {
      const bool over = axis(axisClass).overlap(shafts[k]->low, shafts[k]->high, shaft.low, shaft.high);
      if (over) inside = std::max(inside, shafts[k]->outer);
    }
    shaft.wrap(inside, module);
    scale = std::min(scale, boreRoom(axisClass, shaft.link) / shaft.outer);
  }
  for (ShaftSegment* shaft : shafts) {
    shaft->inner *= scale;
    shaft->outer *= scale;
  }
}

}  // namespace geargraph::inline arrangement

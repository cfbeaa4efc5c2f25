#include "core/schematic/stacker.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <set>

namespace geargraph {
namespace {

constexpr double kStep = 24;       ///< between places for bearings and walls
constexpr double kBeside = 25;     ///< from a wheel to the first of them
constexpr int kStepsAside = 4;     ///< places on either side of a wheel
constexpr int kStepsOutside = 10;  ///< and beyond all of them
constexpr double kCrossing = 100;  ///< cost of two things in one place
constexpr double kEnclosed = 45;
constexpr double kArmHalf = 3;
constexpr int kRounds = 4;
// Large trains are searched less: nobody follows every line of them.
constexpr std::size_t kLarge = 50;  ///< joints
constexpr std::size_t kMostPlaces = 64;
constexpr std::size_t kMostPlacesInLarge = 16;

std::size_t at(int position) {
  return static_cast<std::size_t>(position);
}

}  // namespace

Stacker::Stacker(const DrawnPart& part, const Placement& placement, SheetLayout& layout)
    : m_part(part), m_placement(placement), m_layout(layout) {
  addFixedPieces();
  addCups();
  addBearings();
  indexByAxis();
}

void Stacker::indexByAxis() {
  m_on.resize(m_layout.axes.size());
  m_reachesAcross.resize(m_part.mechanism.links.size());
  for (const SheetBearing& bearing : m_bearings) {
    const int home = axisOfLink(m_placement, bearing.parent);
    if (bearing.axis != home && !bearing.straightArm) m_reachesAcross[at(bearing.parent)] = true;
  }
  for (std::size_t w = 0; w < m_layout.wheels.size(); ++w) {
    m_on[at(m_layout.wheels[w].axis)].wheels.push_back(static_cast<int>(w));
  }
  for (std::size_t k = 0; k < m_cups.size(); ++k) {
    m_on[at(m_layout.wheels[at(m_cups[k].wheel)].axis)].cups.push_back(static_cast<int>(k));
  }
  for (const SheetBearing& bearing : m_bearings) {
    m_on[at(bearing.axis)].bearings.push_back(bearing.joint);
    if (bearing.straightArm) m_on[at(axisOfLink(m_placement, bearing.parent))].arms.push_back(bearing.joint);
  }
  for (OnAxis& on : m_on) {
    std::set<int> links;
    for (const int joint : on.bearings) links.insert(m_bearings[at(joint)].child);
    for (const int w : on.wheels) {
      if (!isInFrame(m_layout.wheels[at(w)])) links.insert(m_layout.wheels[at(w)].link);
    }
    on.links.assign(links.begin(), links.end());
  }
}

bool Stacker::areParallel(int a, int b) const {
  const SheetPoint u = m_layout.axes[at(a)].along;
  const SheetPoint v = m_layout.axes[at(b)].along;
  return std::abs(dot(u, turned(v))) < 1e-6;
}

/// The upright box about a stretch of an axis, from one height to another.
Extent Stacker::boxOn(int axis, double low, double high, double from, double to) const {
  const SheetAxis& on = m_layout.axes[at(axis)];
  return Extent::spanning(on.at(low, from), on.at(high, to))
      .united(Extent::spanning(on.at(low, to), on.at(high, from)));
}

void Stacker::addFixedPieces() {
  for (const SheetWheel& wheel : m_layout.wheels) {
    const SheetAxis& on = m_layout.axes[at(wheel.axis)];
    for (const double side : {1.0, -1.0}) {
      if (side < 0 && on.half) continue;
      const SheetPoint from = on.at(wheel.barFrom.x, side * wheel.barFrom.y);
      const SheetPoint to = on.at(wheel.barTo.x, side * wheel.barTo.y);
      m_fixed.push_back({Extent::spanning(from, to).grown(3), wheel.link});
      const double foot = wheel.isRing() ? wheel.radius + kRimHeight : (isInFrame(wheel) ? wheel.radius : 0);
      m_fixed.push_back(
          {boxOn(wheel.axis, wheel.at - 2, wheel.at + 2, side * foot, side * wheel.radius), wheel.link});
    }
  }
}

/// Places beside every wheel on parallel axes, the nearest to what is wanted if there are many.
std::vector<double> Stacker::placesOn(int axis, double wanted) const {
  const SheetAxis& on = m_layout.axes[at(axis)];
  std::vector<double> places{wanted};
  double low = 1e300;
  double high = -1e300;
  for (const SheetWheel& wheel : m_layout.wheels) {
    if (!areParallel(axis, wheel.axis)) continue;
    const SheetAxis& other = m_layout.axes[at(wheel.axis)];
    const double a = on.coordinateOf(other.at(wheel.barFrom.x, 0));
    const double b = on.coordinateOf(other.at(wheel.barTo.x, 0));
    const double body = on.coordinateOf(other.at(wheel.at, 0));
    for (int k = 0; k < kStepsAside; ++k) {
      places.push_back(std::min({a, b, body}) - kBeside - k * kStep);
      places.push_back(std::max({a, b, body}) + kBeside + k * kStep);
    }
    low = std::min({low, a, b, body});
    high = std::max({high, a, b, body});
  }
  for (int k = kStepsAside; k < kStepsOutside && low <= high; ++k) {
    places.push_back(low - kBeside - k * kStep);
    places.push_back(high + kBeside + k * kStep);
  }
  const auto nearer = [&](double x, double y) { return std::abs(x - wanted) < std::abs(y - wanted) - 1e-9; };
  std::stable_sort(places.begin(), places.end(), nearer);
  const bool isLarge = m_placement.tree->joints.size() > kLarge;
  const std::size_t most = isLarge ? kMostPlacesInLarge : kMostPlaces;
  std::vector<double> kept;
  for (const double place : places) {
    const bool known =
        std::any_of(kept.begin(), kept.end(), [&](double k) { return std::abs(k - place) < 6; });
    if (!known && kept.size() < most) kept.push_back(place);
  }
  return kept;
}

void Stacker::addCups() {
  for (std::size_t w = 0; w < m_layout.wheels.size(); ++w) {
    const SheetWheel& wheel = m_layout.wheels[w];
    if (!wheel.isRing() || wheel.link == 0 || axisOfLink(m_placement, wheel.link) != wheel.axis) continue;
    Item item{true, static_cast<int>(m_cups.size()), wheel.at, 0, {}};
    for (int k = 0; k < kStepsAside; ++k) {
      item.places.push_back(wheel.at - kStep - k * kStep);
      item.places.push_back(wheel.at + kStep + k * kStep);
    }
    m_cups.push_back({static_cast<int>(w), item.places.front()});
    m_items.push_back(std::move(item));
  }
}

/// Bearings of moving links come first: the ground stands round them.
void Stacker::addBearings() {
  const JointTree& tree = *m_placement.tree;
  std::set<JointId> driven;
  for (const Input& input : m_part.mechanism.inputs.value_or(std::vector<Input>{}))
    driven.insert(input.joint);
  for (std::size_t j = 0; j < tree.joints.size(); ++j) {
    SheetBearing bearing;
    bearing.joint = static_cast<int>(j);
    bearing.axis = m_placement.classes->classOf[j];
    bearing.child = tree.child[j];
    bearing.parent = tree.parent[at(bearing.child)];
    const AxisLine& own = m_placement.axes[at(tree.axisOf[j])];
    const double offset = m_part.mechanism.turningJoints[j].offset.value();
    const Vector3 drawn = own.point + offset * own.direction;
    bearing.at = m_layout.along(m_layout.axes[at(bearing.axis)], drawn);
    const int home = bearing.parent == 0 ? -1 : axisOfLink(m_placement, bearing.parent);
    bearing.straightArm = home >= 0 && home != bearing.axis && areParallel(home, bearing.axis);
    bearing.driven = driven.contains(m_part.mechanism.turningJoints[j].id);
    m_bearings.push_back(bearing);
  }
  for (const bool ground : {false, true}) {
    for (const SheetBearing& bearing : m_bearings) {
      if ((bearing.parent == 0) != ground) continue;
      const TurningJoint& joint = m_part.mechanism.turningJoints[at(bearing.joint)];
      const AxisLine& own = m_placement.axes[at(tree.axisOf[at(bearing.joint)])];
      const bool says = !(own.automatic && joint.offset.value() == 0);
      m_items.push_back(
          {false, bearing.joint, bearing.at, says ? 0.12 : 0.02, placesOn(bearing.axis, bearing.at)});
    }
  }
}

double& Stacker::atOf(const Item& item) {
  return item.isCup ? m_cups[at(item.index)].at : m_bearings[at(item.index)].at;
}
double Stacker::atOf(const Item& item) const {
  return item.isCup ? m_cups[at(item.index)].at : m_bearings[at(item.index)].at;
}
int Stacker::axisOf(const Item& item) const {
  return item.isCup ? m_layout.wheels[at(m_cups[at(item.index)].wheel)].axis
                    : m_bearings[at(item.index)].axis;
}

std::vector<Stacker::Piece> Stacker::piecesOf(const Item& item) const {
  const int axis = axisOf(item);
  const double x = atOf(item);
  if (item.isCup) {
    const SheetWheel& wheel = m_layout.wheels[at(m_cups[at(item.index)].wheel)];
    return {{boxOn(axis, x - kArmHalf, x + kArmHalf, 0, wheel.radius + kRimHeight), wheel.link},
            {boxOn(axis, std::min(x, wheel.at), std::max(x, wheel.at), wheel.radius + kRimHeight - 3,
                   wheel.radius + kRimHeight + 3),
             wheel.link}};
  }
  const SheetBearing& bearing = m_bearings[at(item.index)];
  const double reach = kBearingGap + (bearing.parent == 0 ? kHatching + 3 : 3);
  std::vector<Piece> pieces{
      {boxOn(axis, x - kBearingHalf - 1, x + kBearingHalf + 1, -reach, reach), -1 - bearing.joint}};
  if (bearing.straightArm) {
    const SheetAxis& home = m_layout.axes[at(axisOfLink(m_placement, bearing.parent))];
    const SheetPoint end = m_layout.axes[at(axis)].at(x, 0);
    const SheetPoint start = home.at(home.coordinateOf(end), 0);
    const SheetPoint way = unit(end - start);
    const Extent line = Extent::spanning(start, end - (reach + 2) * way);
    pieces.push_back({line.grown(kArmHalf), bearing.parent});
  }
  return pieces;
}

template <class Visit>
void Stacker::forColumns(int axis, const Visit& visit) const {
  const OnAxis& on = m_on[at(axis)];
  for (const int w : on.wheels) {
    const SheetWheel& wheel = m_layout.wheels[at(w)];
    if (!wheel.isRing() && !isInFrame(wheel)) visit(Column{wheel.at, wheel.link, wheel.link != 0});
  }
  for (const int k : on.cups) {
    const SheetCup& cup = m_cups[at(k)];
    visit(Column{cup.at, m_layout.wheels[at(cup.wheel)].link, true});
  }
  for (const int joint : on.bearings) {
    const SheetBearing& bearing = m_bearings[at(joint)];
    visit(Column{bearing.at, bearing.child, m_reachesAcross[at(bearing.child)]});
  }
  for (const int joint : on.arms) {
    const SheetBearing& bearing = m_bearings[at(joint)];
    const SheetPoint end = m_layout.axes[at(bearing.axis)].at(bearing.at, 0);
    visit(Column{m_layout.axes[at(axis)].coordinateOf(end), bearing.parent, true});
  }
}

std::vector<Stacker::Column> Stacker::columnsOn(int axis) const {
  std::vector<Column> columns;
  forColumns(axis, [&](const Column& column) { columns.push_back(column); });
  return columns;
}

/// Does the link turn about the axis?
bool Stacker::isOwn(int axis, int link) const {
  return link != 0 && axisOfLink(m_placement, link) == axis;
}

Stacker::Range Stacker::rangeOf(int axis, int link) const {
  Range range;
  forColumns(axis, [&](const Column& column) {
    if (column.link == link) range.include(column.at, column.at);
  });
  const bool own = isOwn(axis, link);
  for (const int joint : m_on[at(axis)].bearings) {
    const SheetBearing& bearing = m_bearings[at(joint)];
    if (bearing.child == link) {
      range.include(bearing.at - kShaftEnd, bearing.at + kShaftEnd);
      if (bearing.driven) {
        const double end = bearing.at + kDrivenEnd * freeEndOf(bearing);
        range.include(end, end);
      }
    }
    if (bearing.parent == link && own) range.include(bearing.at, bearing.at);
  }
  if (!own && !range.isEmpty()) range.include(range.low - 12, range.high + 12);
  return range;
}

/// The end of the child's shaft beside which it holds nothing.
double Stacker::freeEndOf(const SheetBearing& bearing) const {
  double sum = 0;
  forColumns(bearing.axis, [&](const Column& column) {
    if (column.link == bearing.child) sum += column.at - bearing.at;
  });
  return sum < 0 ? 1 : -1;
}

std::vector<Stacker::OnShaft> Stacker::shaftsOn(int axis) const {
  const std::vector<int>& links = linksOn(axis);
  std::vector<OnShaft> shafts(links.size());
  for (std::size_t i = 0; i < links.size(); ++i) shafts[i].link = links[i];
  const auto find = [&](int link) -> OnShaft* {
    const auto found = std::lower_bound(links.begin(), links.end(), link);
    return found == links.end() || *found != link ? nullptr
                                                  : &shafts[static_cast<std::size_t>(found - links.begin())];
  };
  forColumns(axis, [&](const Column& column) {
    OnShaft* shaft = find(column.link);
    if (shaft == nullptr) return;
    shaft->columns.push_back(column.at);
    shaft->range.include(column.at, column.at);
  });
  for (const int joint : m_on[at(axis)].bearings) {
    const SheetBearing& bearing = m_bearings[at(joint)];
    OnShaft& child = *find(bearing.child);
    child.range.include(bearing.at - kShaftEnd, bearing.at + kShaftEnd);
    if (bearing.driven) {
      const double sum = std::accumulate(child.columns.begin(), child.columns.end(), 0.0) -
                         static_cast<double>(child.columns.size()) * bearing.at;
      const double end = bearing.at + kDrivenEnd * (sum < 0 ? 1 : -1);
      child.range.include(end, end);
    }
    OnShaft* parent = find(bearing.parent);
    if (parent != nullptr && isOwn(axis, bearing.parent)) parent->range.include(bearing.at, bearing.at);
  }
  for (OnShaft& shaft : shafts) {
    if (!isOwn(axis, shaft.link) && !shaft.range.isEmpty())
      shaft.range.include(shaft.range.low - 12, shaft.range.high + 12);
    std::sort(shaft.columns.begin(), shaft.columns.end());
  }
  return shafts;
}

/// How many things on an axis cannot get past a shaft of another link, whichever of the two is hollow, as far
/// as one of the two links is among these: the others do not change while an item is moved.
int Stacker::conflictsOn(int axis, const std::vector<int>& moved) const {
  const std::vector<OnShaft> shafts = shaftsOn(axis);
  const auto isMoved = [&](const OnShaft& shaft) {
    return std::find(moved.begin(), moved.end(), shaft.link) != moved.end();
  };
  const auto inside = [](const OnShaft& inner, const OnShaft& outer) {
    const auto first = std::upper_bound(inner.columns.begin(), inner.columns.end(), outer.range.low - 5);
    const auto last = std::lower_bound(first, inner.columns.end(), outer.range.high + 5);
    return static_cast<int>(last - first);
  };
  int conflicts = 0;
  for (const OnShaft& shaft : shafts) {
    if (!isMoved(shaft)) continue;
    for (const OnShaft& other : shafts) {
      if (&other == &shaft || (isMoved(other) && other.link < shaft.link)) continue;
      conflicts += std::min(inside(shaft, other), inside(other, shaft));
    }
  }
  return conflicts;
}

/// Shafts that get longer or shorter with an item, as (axis, range).
std::vector<std::pair<int, Stacker::Range>> Stacker::tubesTouchedBy(const Item& item) const {
  const int axis = axisOf(item);
  if (item.isCup) return {{axis, rangeOf(axis, m_layout.wheels[at(m_cups[at(item.index)].wheel)].link)}};
  const SheetBearing& bearing = m_bearings[at(item.index)];
  std::vector<std::pair<int, Range>> tubes{{axis, rangeOf(axis, bearing.child)}};
  if (bearing.straightArm) {
    const int home = axisOfLink(m_placement, bearing.parent);
    tubes.emplace_back(home, rangeOf(home, bearing.parent));
  }
  return tubes;
}

/// Links whose shafts and columns go with an item.
std::vector<int> Stacker::movedBy(const Item& item) const {
  if (item.isCup) return {m_layout.wheels[at(m_cups[at(item.index)].wheel)].link};
  const SheetBearing& bearing = m_bearings[at(item.index)];
  return {bearing.child, bearing.parent};
}

/// Short shafts, bearings near what they hold.
double Stacker::compactness(const Item& item, const std::vector<std::pair<int, Range>>& tubes) const {
  double sum = item.insistence * std::min(std::abs(atOf(item) - item.wanted), 150.0);
  for (const auto& [axis, range] : tubes) sum += 0.1 * (range.high - range.low);
  if (item.isCup) sum += 0.05 * std::abs(atOf(item) - item.wanted);
  return sum;
}

/// The frame comes from outside: how much it would have to reach past to a bearing.
double Stacker::enclosure(const SheetBearing& bearing) const {
  if (bearing.parent != 0) return 0;
  int below = 0;
  int above = 0;
  const auto count = [&](double place, int weight) {
    if (place < bearing.at - 1) below += weight;
    if (place > bearing.at + 1) above += weight;
  };
  const SheetAxis& on = m_layout.axes[at(bearing.axis)];
  for (std::size_t a = 0; a < m_layout.axes.size(); ++a) {
    const SheetAxis& other = m_layout.axes[a];
    const double sine = dot(on.along, turned(other.along));
    if (other.top < 0) continue;
    if (std::abs(sine) < 1e-6) {
      if (std::abs(on.heightOf(other.origin)) > 1) continue;
      forColumns(static_cast<int>(a), [&](const Column& column) {
        if (column.closes) count(on.coordinateOf(other.at(column.at, 0)), 1);
      });
      continue;
    }
    count(dot(other.origin - on.origin, turned(other.along)) / sine, 2);  // what crosses is in the middle
  }
  return kEnclosed * std::min(below, above);
}

Stacker::Scene Stacker::sceneWithout(std::size_t item) const {
  Scene scene;
  scene.pieces = m_fixed;
  scene.axisOf.assign(m_fixed.size(), -1);
  for (std::size_t i = 0; i < m_items.size(); ++i) {
    if (i == item) continue;
    for (const Piece& piece : piecesOf(m_items[i])) {
      scene.pieces.push_back(piece);
      scene.axisOf.push_back(axisOf(m_items[i]));
    }
  }
  for (const SheetBearing& bearing : m_bearings) {
    const Range range = rangeOf(bearing.axis, bearing.child);
    scene.tubes.push_back({boxOn(bearing.axis, range.low, range.high, -2, 2), bearing.child, bearing.axis});
  }
  return scene;
}

/// What stands in one place, arms across shafts on other axes, and shafts that cannot be nested. No part of
/// it is negative, so it need not be known to the end where it has come to what is too much.
double Stacker::cost(const Item& item, const Scene& scene, double tooMuch) const {
  const std::vector<std::pair<int, Range>> tubes = tubesTouchedBy(item);
  double sum = compactness(item, tubes);
  if (sum >= tooMuch) return sum;
  if (!item.isCup) sum += enclosure(m_bearings[at(item.index)]);
  const int axis = axisOf(item);
  for (const Piece& own : piecesOf(item)) {
    for (const Piece& other : scene.pieces) {
      if (own.owner != other.owner && own.box.meets(other.box)) sum += kCrossing;
    }
    for (const Scene::Tube& tube : scene.tubes) {
      if (tube.axis != axis && own.owner != tube.link && own.box.meets(tube.box)) sum += kCrossing;
    }
    if (sum >= tooMuch) return sum;
  }
  for (const auto& [tubeAxis, range] : tubes) {
    const Extent tube = boxOn(tubeAxis, range.low, range.high, -2, 2);
    const int link = item.isCup ? m_layout.wheels[at(m_cups[at(item.index)].wheel)].link
                                : (tubeAxis == axis ? m_bearings[at(item.index)].child
                                                    : m_bearings[at(item.index)].parent);
    for (std::size_t k = m_fixed.size(); k < scene.pieces.size(); ++k) {
      const Piece& piece = scene.pieces[k];
      if (scene.axisOf[k] != tubeAxis && piece.owner != link && piece.box.meets(tube)) sum += kCrossing;
    }
    if (sum >= tooMuch) return sum;
    sum += 1.3 * kCrossing * conflictsOn(tubeAxis, movedBy(item));
  }
  return sum;
}

double Stacker::costOf(int joint) const {
  const std::size_t item = itemOf(joint);
  return cost(m_items[item], sceneWithout(item), std::numeric_limits<double>::infinity());
}

std::size_t Stacker::itemOf(int joint) const {
  std::size_t item = 0;
  while (m_items[item].isCup || m_items[item].index != joint) ++item;
  return item;
}

std::vector<double> Stacker::placesOf(int joint) const {
  return m_items[itemOf(joint)].places;
}

/// The item's places, and those just beyond the other bearings on its axis.
std::vector<double> Stacker::candidatesOf(const Item& item) const {
  std::vector<double> candidates = item.places;
  if (item.isCup) return candidates;
  const SheetBearing& own = m_bearings[at(item.index)];
  for (const SheetBearing& other : m_bearings) {
    if (other.axis != own.axis || other.joint == own.joint) continue;
    const double reach = kShaftEnd + (other.driven || own.driven ? kDrivenEnd : kShaftEnd);
    candidates.push_back(other.at - reach);
    candidates.push_back(other.at + reach);
  }
  return candidates;
}

void Stacker::search(const std::stop_token& stop) {
  const int rounds = m_bearings.size() > kLarge ? 1 : kRounds;
  for (int round = 0; round < rounds; ++round) {
    bool changed = false;
    for (std::size_t i = 0; i < m_items.size(); ++i) {
      if (stop.stop_requested()) return;
      const Item& item = m_items[i];
      const Scene scene = sceneWithout(i);
      double& place = atOf(item);
      double best = place;
      double least = cost(item, scene, std::numeric_limits<double>::infinity());
      for (const double candidate : candidatesOf(item)) {
        place = candidate;
        const double found = cost(item, scene, least - 1e-6);
        if (found >= least - 1e-6) continue;
        least = found;
        best = candidate;
        changed = true;
      }
      place = best;
    }
    if (!changed) return;
  }
}

}  // namespace geargraph

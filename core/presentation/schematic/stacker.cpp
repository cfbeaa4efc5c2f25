#include "core/presentation/schematic/stacker.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <set>

namespace geargraph::inline schematic {
namespace {

constexpr double kStep = 24;       ///< between places for bearings and walls
constexpr double kBeside = 25;     ///< from a wheel to the first of them
constexpr int kStepsAside = 4;     ///< places on either side of a wheel
constexpr int kStepsOutside = 10;  ///< and beyond all of them
constexpr double kCrossing = 100;  ///< cost of two things in one place
constexpr double kEnclosed = 45;
constexpr double kArmHalf = 3;
constexpr double kSheetMargin = 20'000;  ///< from wheels and axes to the farthest bearing, px
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
  standUp();
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

/// What is drawn on the sheet before its bearings, as a stretch of an axis.
Stacker::Range Stacker::drawnOn(int axis) const {
  const SheetAxis& on = m_layout.axes[at(axis)];
  Range drawn;
  const auto include = [&](SheetPoint p) {
    const double place = on.coordinateOf(p);
    drawn.include(place, place);
  };
  for (const SheetWheel& wheel : m_layout.wheels)
    include(m_layout.axes[at(wheel.axis)].at(wheel.at, wheel.radius));
  if (m_layout.wheels.empty()) {
    for (const SheetAxis& other : m_layout.axes) include(other.origin);
  }
  return drawn;
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
    const Range sheet = drawnOn(bearing.axis);
    bearing.at = std::clamp(m_layout.along(m_layout.axes[at(bearing.axis)], drawn), sheet.low - kSheetMargin,
                            sheet.high + kSheetMargin);
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

double Stacker::atOf(const Item& item) const {
  return item.isCup ? m_cups[at(item.index)].at : m_bearings[at(item.index)].at;
}
int Stacker::axisOf(const Item& item) const {
  return item.isCup ? m_layout.wheels[at(m_cups[at(item.index)].wheel)].axis
                    : m_bearings[at(item.index)].axis;
}

Stacker::Few<Stacker::Piece> Stacker::piecesOf(const Item& item) const {
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
  Few<Piece> pieces(
      {boxOn(axis, x - kBearingHalf - 1, x + kBearingHalf + 1, -reach, reach), -1 - bearing.joint});
  if (bearing.straightArm) {
    const SheetAxis& home = m_layout.axes[at(axisOfLink(m_placement, bearing.parent))];
    const SheetPoint end = m_layout.axes[at(axis)].at(x, 0);
    const SheetPoint start = home.at(home.coordinateOf(end), 0);
    const SheetPoint way = unit(end - start);
    const Extent line = Extent::spanning(start, end - (reach + 2) * way);
    pieces.add({line.grown(kArmHalf), bearing.parent});
  }
  return pieces;
}

/// On the axis from which a straight arm holds a bearing.
Stacker::Column Stacker::armColumn(const SheetBearing& bearing) const {
  const SheetAxis& home = m_layout.axes[at(axisOfLink(m_placement, bearing.parent))];
  const SheetPoint end = m_layout.axes[at(bearing.axis)].at(bearing.at, 0);
  return {home.coordinateOf(end), bearing.parent, true};
}

/// Lists the columns on all axes anew.
void Stacker::standUp() {
  std::vector<std::size_t> ofCup(m_cups.size()), ofBearing(m_bearings.size()), ofArm(m_bearings.size());
  for (OnAxis& on : m_on) {
    on.columns.clear();
    for (const int w : on.wheels) {
      const SheetWheel& wheel = m_layout.wheels[at(w)];
      if (!wheel.isRing() && !isInFrame(wheel)) on.columns.push_back({wheel.at, wheel.link, wheel.link != 0});
    }
    for (const int k : on.cups) {
      ofCup[at(k)] = on.columns.size();
      on.columns.push_back({m_cups[at(k)].at, m_layout.wheels[at(m_cups[at(k)].wheel)].link, true});
    }
    for (const int joint : on.bearings) {
      const SheetBearing& bearing = m_bearings[at(joint)];
      ofBearing[at(joint)] = on.columns.size();
      on.columns.push_back({bearing.at, bearing.child, m_reachesAcross[at(bearing.child)]});
    }
    for (const int joint : on.arms) {
      ofArm[at(joint)] = on.columns.size();
      on.columns.push_back(armColumn(m_bearings[at(joint)]));
    }
    for (Column& column : on.columns) column.shaft = shaftOn(on, column.link);
  }
  for (Item& item : m_items) {
    item.column = item.isCup ? ofCup[at(item.index)] : ofBearing[at(item.index)];
    if (!item.isCup) item.arm = ofArm[at(item.index)];
  }
}

void Stacker::put(const Item& item, double to) {
  m_on[at(axisOf(item))].columns[item.column].at = to;
  if (item.isCup) {
    m_cups[at(item.index)].at = to;
    return;
  }
  SheetBearing& bearing = m_bearings[at(item.index)];
  bearing.at = to;
  if (!bearing.straightArm) return;
  m_on[at(axisOfLink(m_placement, bearing.parent))].columns[item.arm].at = armColumn(bearing).at;
}

/// Shafts that get longer or shorter with an item.
Stacker::Few<Stacker::Tube> Stacker::tubesTouchedBy(const Item& item) const {
  const int axis = axisOf(item);
  const auto tube = [this](int on, int link) { return Tube{on, link, rangeOf(on, link)}; };
  if (item.isCup) return tube(axis, m_layout.wheels[at(m_cups[at(item.index)].wheel)].link);
  const SheetBearing& bearing = m_bearings[at(item.index)];
  Few<Tube> tubes(tube(axis, bearing.child));
  if (bearing.straightArm) tubes.add(tube(axisOfLink(m_placement, bearing.parent), bearing.parent));
  return tubes;
}

/// Links whose shafts and columns go with an item.
Stacker::Few<int> Stacker::movedBy(const Item& item) const {
  if (item.isCup) return m_layout.wheels[at(m_cups[at(item.index)].wheel)].link;
  const SheetBearing& bearing = m_bearings[at(item.index)];
  return {bearing.child, bearing.parent};
}

/// Short shafts, bearings near what they hold.
double Stacker::compactness(const Item& item, const Few<Tube>& tubes) const {
  double sum = item.insistence * std::min(std::abs(atOf(item) - item.wanted), 150.0);
  for (const Tube& tube : tubes) sum += 0.1 * (tube.range.high - tube.range.low);
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
      for (const Column& column : m_on[a].columns) {
        if (column.closes) count(on.coordinateOf(other.at(column.at, 0)), 1);
      }
      continue;
    }
    count(dot(other.origin - on.origin, turned(other.along)) / sine, 2);  // what crosses is in the middle
  }
  return kEnclosed * std::min(below, above);
}

Stacker::Scene Stacker::sceneWithout(std::size_t item) const {
  Scene scene;
  scene.pieces = m_fixed;
  for (std::size_t i = 0; i < m_items.size(); ++i) {
    if (i == item) continue;
    for (const Piece& piece : piecesOf(m_items[i])) {
      scene.pieces.push_back(piece);
      scene.standing.push_back({piece, axisOf(m_items[i])});
    }
  }
  for (const SheetBearing& bearing : m_bearings) {
    const Range range = rangeOf(bearing.axis, bearing.child);
    scene.shafts.push_back({boxOn(bearing.axis, range.low, range.high, -2, 2), bearing.child, bearing.axis});
  }
  return scene;
}

/// Of a scene, what the item can get in the way of at one of these places.
void Stacker::keepInReach(Scene& scene, const Item& item, const std::vector<double>& candidates) {
  constexpr double kBeyond = 2 * kDrivenEnd;  // a shaft's free end may change
  const double now = atOf(item);
  const auto [least, most] = std::minmax_element(candidates.begin(), candidates.end());
  std::optional<Extent> ofPieces;
  std::optional<Extent> ofTubes;
  const auto include = [](std::optional<Extent>& all, const Extent& box) {
    all = all ? all->united(box) : box;
  };
  for (const double place : {std::min(*least, now), std::max(*most, now)}) {
    put(item, place);
    for (const Piece& piece : piecesOf(item)) include(ofPieces, piece.box.grown(1));
    for (const Tube& tube : tubesTouchedBy(item))
      include(ofTubes, boxOn(tube.axis, tube.range.low - kBeyond, tube.range.high + kBeyond, -3, 3));
  }
  put(item, now);
  std::erase_if(scene.pieces, [&](const Piece& piece) { return !piece.box.meets(*ofPieces); });
  std::erase_if(scene.shafts, [&](const Scene::Shaft& shaft) { return !shaft.box.meets(*ofPieces); });
  std::erase_if(scene.standing, [&](const Scene::Standing& one) { return !one.piece.box.meets(*ofTubes); });
}

/// What stands in one place, arms across shafts on other axes, and shafts that cannot be nested. No part of
/// it is negative, so it need not be known to the end where it has come to what is too much.
double Stacker::cost(const Item& item, const Scene& scene, double tooMuch) const {
  const Few<Tube> tubes = tubesTouchedBy(item);
  double sum = compactness(item, tubes);
  if (sum >= tooMuch) return sum;
  if (!item.isCup) sum += enclosure(m_bearings[at(item.index)]);
  const int axis = axisOf(item);
  for (const Piece& own : piecesOf(item)) {
    for (const Piece& other : scene.pieces) {
      if (own.owner != other.owner && own.box.meets(other.box)) sum += kCrossing;
    }
    for (const Scene::Shaft& shaft : scene.shafts) {
      if (shaft.axis != axis && own.owner != shaft.link && own.box.meets(shaft.box)) sum += kCrossing;
    }
    if (sum >= tooMuch) return sum;
  }
  for (const Tube& tube : tubes) {
    const Extent box = boxOn(tube.axis, tube.range.low, tube.range.high, -2, 2);
    for (const auto& [piece, on] : scene.standing) {
      if (on != tube.axis && piece.owner != tube.link && piece.box.meets(box)) sum += kCrossing;
    }
    if (sum >= tooMuch) return sum;
    sum += 1.3 * kCrossing * conflictsOn(tube.axis, movedBy(item));
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
      const std::vector<double> candidates = candidatesOf(item);
      Scene scene = sceneWithout(i);
      keepInReach(scene, item, candidates);
      double best = atOf(item);
      double least = cost(item, scene, std::numeric_limits<double>::infinity());
      for (const double candidate : candidates) {
        put(item, candidate);
        const double found = cost(item, scene, least - 1e-6);
        if (found >= least - 1e-6) continue;
        least = found;
        best = candidate;
        changed = true;
      }
      put(item, best);
    }
    if (!changed) return;
  }
}

}  // namespace geargraph::inline schematic

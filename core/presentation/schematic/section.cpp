#include "core/presentation/schematic/section.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/machine/teeth/wheel_kind.h"
#include "core/presentation/drawing/emphasis.h"
#include "core/presentation/schematic/arm_router.h"
#include "core/presentation/schematic/section_symbols.h"
#include "core/presentation/schematic/wheel_symbol.h"

namespace geargraph {
namespace {

constexpr double kHitHalfWidth = 4;
constexpr double kHubHalf = 10;      ///< of a wheel's foot on the frame
constexpr double kHoldOnWheel = 60;  ///< an arm begins at a shaft rather than at a wheel
constexpr double kNoHold = -1;
constexpr double kContactWidth = 5;
constexpr int kAxisDepth = kLineDepth - 2;
constexpr int kSymbolDepth = kLineDepth + 2;
constexpr double kStrandWidth = 1.4;
constexpr double kHoleRadius = 6;
constexpr double kPinRadius = 3;
constexpr double kPinReach = 10;  ///< from a wheel's body to where the line of a pin's link ends

/// A pair without wheels of its own: the pins of a link in the holes of another, which are drawn on the body
/// of a wheel of that one.
struct PinPair {
  int mesh = 0;
  int holed = 0;            ///< link
  int pinned = 0;           ///< link
  const SheetWheel* wheel;  ///< of the link with the holes
  double height = 0;        ///< of hole and pin above the wheel's axis
};

class SectionBuilder {
 public:
  SectionBuilder(const DrawnPart& part, const Placement& placement, const SheetLayout& layout,
                 const ShaftPlan& plan, const std::stop_token& stop)
      : m_part(part), m_placement(placement), m_layout(layout), m_plan(plan), m_stop(stop) {
    for (const Link& link : part.mechanism.links) m_section.links.push_back({link.id, {}});
    for (const TurningJoint& joint : part.mechanism.turningJoints) m_section.joints.push_back({joint.id, {}});
    m_armLines.resize(part.mechanism.turningJoints.size());
  }

  Section build() {
    for (const SheetShaft& shaft : m_plan.shafts) addShaft(shaft);
    for (std::size_t w = 0; w < m_layout.wheels.size(); ++w) addWheel(w);
    for (const RingCarrierSymbol& ringCarrier : m_plan.ringCarriers) addRingCarrier(ringCarrier);
    for (const SheetWall& wall : m_plan.walls) addWall(wall);
    m_hold = 0;
    for (const SheetBearing& bearing : m_plan.bearings) addBearing(bearing);
    addArms();
    for (const SheetPair& pair : m_layout.pairs) addMesh(pair);
    addAxes();
    return std::move(m_section);
  }

 private:
  // --- what is drawn ---
  void addShaft(const SheetShaft& shaft);
  void addWheel(std::size_t w);
  void addHelix(const SheetWheel& wheel, double side);
  void addSpiral(const SheetWheel& wheel, double side);
  void addFrame(const SheetWheel& wheel);
  void addRingCarrier(const RingCarrierSymbol& ringCarrier);
  void addWall(const SheetWall& wall);
  void addBearing(const SheetBearing& bearing);
  void addBar(const SheetBearing& bearing, double height, double out);
  void addParentLine(const SheetBearing& bearing);
  void addStraightArm(const SheetArm& arm);
  [[nodiscard]] std::vector<LinkLine> stubsOf(const SheetArm& arm) const;
  [[nodiscard]] std::vector<LinkLine> startsOf(const SheetArm& arm) const;
  void addArrow(const SheetBearing& bearing, double height);
  void addArms();
  [[nodiscard]] std::vector<PinPair> pinPairs() const;
  [[nodiscard]] const SheetWheel* stemOf(int link) const;
  void addPin(const PinPair& pair, CanvasPoint end);
  void addMesh(const SheetPair& pair);
  void addStrands(const SheetWheel& a, const SheetWheel& b, const GearMesh& drawn, Section::Anchors& anchors);
  void addAxes();

  // --- how ---
  [[nodiscard]] const SheetAxis& axis(int a) const { return m_layout.axes[a]; }
  [[nodiscard]] std::vector<double> sides(int a) const {
    return axis(a).half ? std::vector<double>{1} : std::vector<double>{1, -1};
  }
  [[nodiscard]] Tint tintOf(int link) const { return m_part.tintOf(link); }
  [[nodiscard]] ElementId idOf(int link) const { return m_part.mechanism.links[link].id; }
  [[nodiscard]] int linkAt(const LinkId& id) const {
    const auto& links = m_part.mechanism.links;
    const auto isIt = [&](const Link& link) { return link.id == id; };
    return static_cast<int>(std::find_if(links.begin(), links.end(), isIt) - links.begin());
  }
  [[nodiscard]] ElementId jointId(int joint) const { return m_part.mechanism.turningJoints[joint].id; }
  /// Height of the link's shaft above an axis, of several the one nearest to the place.
  [[nodiscard]] double laneOf(int a, int link, double near) const {
    const SheetShaft* shaft = m_plan.shaft(a, link, near);
    return shaft == nullptr ? 0 : shaft->lane * kLaneHeight;
  }

  void put(const ElementId& element, MarkRole role, int z, std::variant<Stroke, Fill, Text> what) {
    m_section.marks.push_back({element, role, z, std::move(what)});
  }
  /// A line of a link, which counts as an obstacle for others and can be hit.
  void line(int link, CanvasPoint from, CanvasPoint to, double width) {
    stroke(idOf(link), link, from, to, width, kLineDepth);
  }
  void stroke(const ElementId& element, int link, CanvasPoint from, CanvasPoint to, double width, int z) {
    if (distance(from, to) < 1e-6) return;
    put(element, MarkRole::line, z, Stroke{Polyline{{from, to}, false}, tintOf(link), width, Dash::solid});
    m_section.outlines.push_back({element, z, Curve::straight(from, to), kHitHalfWidth});
    m_section.lines.push_back({from, to, link, m_hold});
  }
  void hatch(const ElementId& element, CanvasPoint from, CanvasPoint to, CanvasPoint out) {
    for (auto& points : hatching(from, to, out)) {
      put(element, MarkRole::hatching, kSymbolDepth,
          Stroke{Polyline{std::move(points), false}, ColorRole::secondary, 1.1, Dash::solid});
    }
    const CanvasPoint back = kHatching * out;
    m_section.lines.push_back({from + back, to + back, 0, kNoHold});
    const Extent box = Extent::spanning(from, to).united(Extent::spanning(from + back, to + back));
    m_section.outlines.push_back({element, kSymbolDepth, Box{box, 0}, 1});
  }
  void anchor(Section::Anchors& anchors, CanvasPoint place) { anchors.places.push_back(place); }

  const DrawnPart& m_part;
  const Placement& m_placement;
  const SheetLayout& m_layout;
  const ShaftPlan& m_plan;
  const std::stop_token& m_stop;
  Section m_section;
  ByJoint<std::vector<LinkLine>> m_armLines;  ///< of the arm to its bearing
  double m_hold = 0;                          ///< what it costs to fasten an arm to what is drawn now
};

void SectionBuilder::addShaft(const SheetShaft& shaft) {
  const SheetAxis& on = axis(shaft.axis);
  const double height = shaft.lane * kLaneHeight;
  const bool fixed = shaft.link == 0;
  m_hold = shaft.turns || fixed ? 0 : kNoHold;
  for (const double side : sides(shaft.axis)) {
    if (shaft.lane == 0 && side < 0) break;
    const CanvasPoint from = on.at(shaft.low, side * height);
    const CanvasPoint to = on.at(shaft.high, side * height);
    line(shaft.link, from, to, shaft.turns && !fixed ? kShaftWidth : kLinkWidth);
    if (fixed) hatch(idOf(0), from, to, side * on.up);
  }
  anchor(m_section.links[shaft.link], on.at((shaft.low + shaft.high) / 2, height));
}

/// Pitch lines and bodies; the wall of a ring comes with its ring carrier.
void SectionBuilder::addWheel(std::size_t w) {
  const SheetWheel& wheel = m_layout.wheels[w];
  const SheetAxis& on = axis(wheel.axis);
  const double lane = laneOf(wheel.axis, wheel.link, wheel.at);
  const bool own = wheel.link != 0;
  const bool turns = own && axisOfLink(m_placement, wheel.link) == wheel.axis;
  for (const double side : sides(wheel.axis)) {
    m_hold = kNoHold;
    line(wheel.link, on.at(wheel.barFrom.x, side * wheel.barFrom.y),
         on.at(wheel.barTo.x, side * wheel.barTo.y), kLinkWidth);
    m_hold = turns ? kHoldOnWheel : kNoHold;
    const double foot = wheel.isRing() ? wheel.radius + kRimHeight : lane;
    if (own || wheelSymbol(wheel.kind).frame != FrameSymbol::behind) {
      line(wheel.link, on.at(wheel.at, side * foot), on.at(wheel.at, side * wheel.radius), kLinkWidth);
    }
    if (wheel.hand != 0) wheelKind(wheel.kind).isConical ? addSpiral(wheel, side) : addHelix(wheel, side);
  }
  anchor(m_section.links[wheel.link], on.at(wheel.at, (wheel.radius + lane) / 2));
  anchor(m_section.links[wheel.link], on.at(wheel.barTo.x, wheel.barTo.y));
  m_hold = 0;
  if (!own) addFrame(wheel);
}

/// Spiral teeth: a bent stroke behind the pitch line of the cone, which leads away from it outwards where
/// they are right-hand.
void SectionBuilder::addSpiral(const SheetWheel& wheel, double side) {
  constexpr double kAway = 6, kLean = 3.5, kBow = 2;
  constexpr int kPieces = 8;
  const SheetAxis& on = axis(wheel.axis);
  Polyline stroke{{}, false};
  for (int i = 0; i <= kPieces; ++i) {
    const double part = static_cast<double>(i) / kPieces;  // from the large end
    const double depth = kAway + wheel.hand * (kLean * (1 - 2 * part) + kBow * 4 * part * (1 - part));
    const CanvasPoint at = between(wheel.barFrom, wheel.barTo, part) - depth * wheel.outward;
    stroke.points.push_back(on.at(at.x, side * at.y));
  }
  put(idOf(wheel.link), MarkRole::line, kSymbolDepth,
      Stroke{std::move(stroke), tintOf(wheel.link), 1.1, Dash::solid});
}

/// The direction of helical teeth as seen from the front: three oblique strokes beside the pitch line, on the
/// side of the wheel's body; of herringbone teeth two and two that make chevrons.
void SectionBuilder::addHelix(const SheetWheel& wheel, double side) {
  constexpr double kLength = 6, kPace = 5, kAway = 5;
  constexpr double kAlong = 0.82, kAcross = 0.57;  // of an angle that is seen, whatever the true one
  const SheetAxis& on = axis(wheel.axis);
  const CanvasPoint across{on.along.y, -on.along.x};  // to the left of the axis's direction
  const double height = side * (wheel.radius + (wheel.isRing() ? kAway : -kAway));
  const double middle = (wheel.barFrom.x + wheel.barTo.x) / 2;
  const int strokes = wheel.herringbone ? 4 : 3;
  for (int i = 0; i < strokes; ++i) {
    const double place = i - (strokes - 1) / 2.0;
    const int hand = wheel.herringbone && place > 0 ? -wheel.hand : wheel.hand;
    const CanvasPoint trace = kAlong * on.along - (hand * kAcross) * across;
    const CanvasPoint at = on.at(middle + kPace * place, height);
    put(idOf(wheel.link), MarkRole::line, kSymbolDepth,
        Stroke{Polyline{{at - (kLength / 2) * trace, at + (kLength / 2) * trace}, false}, tintOf(wheel.link),
               1.1, Dash::solid});
  }
}

/// A wheel of the ground is cut in the frame: a ring at its rim, a bevel behind its teeth. Others stand on
/// their hub.
void SectionBuilder::addFrame(const SheetWheel& wheel) {
  const SheetAxis& on = axis(wheel.axis);
  for (const double side : sides(wheel.axis)) {
    if (wheelSymbol(wheel.kind).frame == FrameSymbol::rim) {
      const double rim = side * (wheel.radius + kRimHeight);
      const CanvasPoint from = on.at(wheel.at - kHubHalf - 2, rim);
      const CanvasPoint to = on.at(wheel.at + kHubHalf + 2, rim);
      line(0, from, to, kLinkWidth);
      hatch(idOf(0), from, to, side * on.up);
    } else if (wheelSymbol(wheel.kind).frame == FrameSymbol::behind) {
      const CanvasPoint back = -10.0 * wheel.outward;
      const CanvasPoint a = wheel.barFrom + back;
      const CanvasPoint b = wheel.barTo + back;
      const CanvasPoint from = on.at(a.x, side * a.y);
      const CanvasPoint to = on.at(b.x, side * b.y);
      const CanvasPoint out =
          on.at(wheel.at + back.x, side * (wheel.radius + back.y)) - on.at(wheel.at, side * wheel.radius);
      line(0, on.at(wheel.at, side * wheel.radius), between(from, to, 0.5), kLinkWidth);
      line(0, from, to, kLinkWidth);
      hatch(idOf(0), from, to, unit(out));
    }
  }
}

void SectionBuilder::addRingCarrier(const RingCarrierSymbol& ringCarrier) {
  const SheetWheel& wheel = m_layout.wheels[ringCarrier.wheel];
  const SheetAxis& on = axis(wheel.axis);
  const double rim = wheel.radius + kRimHeight;
  const double lane = laneOf(wheel.axis, wheel.link, ringCarrier.at);
  for (const double side : sides(wheel.axis)) {
    line(wheel.link, on.at(wheel.at, side * rim), on.at(ringCarrier.at, side * rim), kLinkWidth);
    line(wheel.link, on.at(ringCarrier.at, side * rim), on.at(ringCarrier.at, side * lane), kLinkWidth);
  }
  m_section.links[wheel.link].places.insert(m_section.links[wheel.link].places.begin(),
                                            on.at((wheel.at + ringCarrier.at) / 2, rim));
  anchor(m_section.links[wheel.link], on.at(ringCarrier.at, (rim + lane) / 2));
}

void SectionBuilder::addWall(const SheetWall& wall) {
  const SheetAxis& on = axis(wall.axis);
  for (const double side : sides(wall.axis)) {
    line(wall.link, on.at(wall.from.x, side * wall.from.y), on.at(wall.to.x, side * wall.to.y), kLinkWidth);
  }
  anchor(m_section.links[wall.link], on.at((wall.from.x + wall.to.x) / 2, (wall.from.y + wall.to.y) / 2));
}

void SectionBuilder::addBar(const SheetBearing& bearing, double height, double out) {
  const SheetAxis& on = axis(bearing.axis);
  const CanvasPoint from = on.at(bearing.at - kBearingHalf, height);
  const CanvasPoint to = on.at(bearing.at + kBearingHalf, height);
  stroke(jointId(bearing.joint), bearing.parent, from, to, kLinkWidth, kSymbolDepth);
  if (bearing.parent == 0) hatch(jointId(bearing.joint), from, to, out * on.up);
}

/// A short wall from the parent's shaft on the same axis to its bars.
void SectionBuilder::addParentLine(const SheetBearing& bearing) {
  const SheetAxis& on = axis(bearing.axis);
  const double own = laneOf(bearing.axis, bearing.parent, bearing.at);
  const double bar = own > bearing.height ? bearing.height + kBearingGap : bearing.height - kBearingGap;
  for (const double side : sides(bearing.axis)) {
    line(bearing.parent, on.at(bearing.at, side * bar), on.at(bearing.at, side * own), kLinkWidth);
  }
}

void SectionBuilder::addStraightArm(const SheetArm& arm) {
  const SheetBearing& bearing = m_plan.bearings[arm.joint];
  const SheetAxis& from = axis(arm.axis);
  const CanvasPoint end = axis(bearing.axis).at(bearing.at, 0);
  const double side = from.heightOf(end) < 0 ? -1 : 1;
  const CanvasPoint start = from.at(arm.at, side * laneOf(arm.axis, arm.link, arm.at));
  const CanvasPoint bar = end - (bearing.height + kBearingGap) * unit(end - start);
  line(arm.link, start, bar, kLinkWidth);
  m_armLines[arm.joint].push_back({start, bar, arm.link, 0});
  anchor(m_section.links[arm.link], between(start, bar, 0.5));
}

void SectionBuilder::addArrow(const SheetBearing& bearing, double height) {
  if (!bearing.driven) return;
  const SheetAxis& on = axis(bearing.axis);
  const double place = bearing.at + bearing.freeEnd * kArrowPlace;
  const TurnArrow arrow = on.half ? turnArrow(on.at(place, height), on.along, 9)
                                  : turnArrow(on.at(place, 0), on.along, height + 9);
  const ElementId joint = jointId(bearing.joint);
  put(joint, MarkRole::input, kSymbolDepth, Stroke{arrow.bow, ColorRole::input, 2, Dash::solid});
  put(joint, MarkRole::input, kSymbolDepth, Fill{Polyline{arrow.tip, true}, ColorRole::input});
  m_section.outlines.push_back({joint, kSymbolDepth, arrow.bow, kHitHalfWidth});
  forEachChord(arrow.bow, [&](CanvasPoint a, CanvasPoint b) {
    m_section.lines.push_back({a, b, -1, kNoHold});
  });
  m_section.lines.push_back({arrow.tip[0], between(arrow.tip[1], arrow.tip[2], 0.5), -1, kNoHold});
}

void SectionBuilder::addBearing(const SheetBearing& bearing) {
  const SheetAxis& on = axis(bearing.axis);
  const double lane = bearing.height;
  const bool isCoaxial = bearing.parent != 0 && axisOfLink(m_placement, bearing.parent) == bearing.axis;
  const bool isInside =
      bearing.onPin || (isCoaxial && laneOf(bearing.axis, bearing.parent, bearing.at) < lane);
  const double bar = isInside ? lane - kBearingGap : lane + kBearingGap;
  const auto ownArm = std::find_if(m_plan.arms.begin(), m_plan.arms.end(),
                                   [&](const SheetArm& arm) { return arm.joint == bearing.joint; });
  const bool isStraight = ownArm != m_plan.arms.end() && ownArm->isStraight;
  m_hold = bearing.isHeld || isStraight ? 0 : kNoHold;
  addBar(bearing, bar, 1);
  if (!on.half || lane == 0) addBar(bearing, -bar, -1);
  m_hold = 0;
  if (isCoaxial || bearing.onPin) addParentLine(bearing);
  if (isStraight) addStraightArm(*ownArm);
  addArrow(bearing, lane);
  Section::Anchors& anchors = m_section.joints[bearing.joint];
  const double beyond = bar + (bearing.parent == 0 ? kHatching : 0);
  for (const double side : {1.0, -1.0}) {
    if (side < 0 && on.half && lane > 0) break;
    anchor(anchors, on.at(bearing.at, side * beyond));
    anchor(anchors, on.at(bearing.at - kBearingHalf, side * beyond));
    anchor(anchors, on.at(bearing.at + kBearingHalf, side * beyond));
  }
}

/// Where an arm may leave its shaft.
std::vector<LinkLine> SectionBuilder::stubsOf(const SheetArm& arm) const {
  constexpr double kStub = 6;
  const double lane = laneOf(arm.axis, arm.link, arm.at);
  std::vector<LinkLine> stubs;
  for (const double side : sides(arm.axis)) {
    stubs.push_back({axis(arm.axis).at(arm.at, side * lane), axis(arm.axis).at(arm.at, side * (lane + kStub)),
                     arm.link, 0});
  }
  return stubs;
}

/// There, or on the link's arms that leave it there already.
std::vector<LinkLine> SectionBuilder::startsOf(const SheetArm& arm) const {
  std::vector<LinkLine> starts;
  for (const LinkLine& stub : stubsOf(arm)) starts.push_back({stub.to, stub.to, arm.link, 0});
  for (const SheetArm& other : m_plan.arms) {
    if (other.link != arm.link || other.axis != arm.axis || std::abs(other.at - arm.at) > 1e-6) continue;
    const auto& lines = m_armLines[other.joint];
    starts.insert(starts.end(), lines.begin(), lines.end());
  }
  return starts;
}

/// The largest wheel of a link that stands on a shaft.
const SheetWheel* SectionBuilder::stemOf(int link) const {
  const SheetWheel* largest = nullptr;
  for (const SheetWheel& wheel : m_layout.wheels) {
    if (wheel.link != link || link == 0 || wheel.isRing()) continue;
    if (largest == nullptr || wheel.radius > largest->radius) largest = &wheel;
  }
  return largest;
}

std::vector<PinPair> SectionBuilder::pinPairs() const {
  std::vector<PinPair> pairs;
  for (std::size_t m = 0; m < m_part.mechanism.gearMeshes.size(); ++m) {
    const auto isIts = [&](const SheetPair& pair) { return pair.mesh == static_cast<int>(m); };
    if (!m_placement.meshes[m] || touches(saidKind(m_part.mechanism.gearMeshes[m])) ||
        std::any_of(m_layout.pairs.begin(), m_layout.pairs.end(), isIts))
      continue;
    PinPair pair{static_cast<int>(m), linkAt(m_part.mechanism.gearMeshes[m].tail),
                 linkAt(m_part.mechanism.gearMeshes[m].head), nullptr, 0};
    pair.wheel = stemOf(pair.holed);
    if (pair.wheel == nullptr) {
      std::swap(pair.holed, pair.pinned);
      pair.wheel = stemOf(pair.holed);
    }
    if (pair.wheel == nullptr) continue;
    const double lane = laneOf(pair.wheel->axis, pair.holed, pair.wheel->at);
    pair.height = (lane + pair.wheel->radius) / 2;
    pairs.push_back(pair);
  }
  return pairs;
}

/// A hole as a circle on the wheel's body, and the pin in it, to which the line of its link comes at `end`.
void SectionBuilder::addPin(const PinPair& pair, CanvasPoint end) {
  const SheetAxis& on = axis(pair.wheel->axis);
  const double side = on.heightOf(end) < 0 ? -1 : 1;
  const CanvasPoint centre = on.at(pair.wheel->at, side * pair.height);
  const ElementId mesh = m_part.mechanism.gearMeshes[pair.mesh].id;
  line(pair.pinned, end, centre + kPinRadius * unit(end - centre), kLinkWidth);
  put(mesh, MarkRole::line, kSymbolDepth, Fill{Circle{centre, kHoleRadius}, ColorRole::sheet});
  put(mesh, MarkRole::line, kSymbolDepth,
      Stroke{Circle{centre, kHoleRadius}, tintOf(pair.holed), kLinkWidth, Dash::solid});
  put(mesh, MarkRole::line, kSymbolDepth, Fill{Circle{centre, kPinRadius}, tintOf(pair.pinned)});
  m_section.outlines.push_back({mesh, kSymbolDepth + 1, Circle{centre, kHoleRadius}, 1});
  Section::Anchors anchors{mesh, {}};
  for (const double place : {-side, side})
    anchor(anchors, on.at(pair.wheel->at, side * pair.height + place * kHoleRadius));
  m_section.meshes.push_back(std::move(anchors));
}

/// Arms to axes across, to wheels that a link holds on the axis of another, and to pins in holes: found round
/// what is drawn. Those of the arrangement begin where it has them.
void SectionBuilder::addArms() {
  struct Wanted {
    int link;
    const SheetArm* arm;  ///< null: it may begin anywhere on the link
    std::vector<CanvasPoint> ends;
    const PinPair* pins = nullptr;
  };
  m_hold = 0;
  std::vector<Wanted> wanted;
  for (const SheetArm& arm : m_plan.arms) {
    if (arm.isStraight) continue;
    const SheetBearing& bearing = m_plan.bearings[arm.joint];
    const SheetAxis& on = axis(bearing.axis);
    const double bar = bearing.height + kBearingGap;
    wanted.push_back(
        {arm.link, arm.axis < 0 ? nullptr : &arm, {on.at(bearing.at, bar), on.at(bearing.at, -bar)}});
  }
  for (const SheetWheel& wheel : m_layout.wheels) {
    if (wheel.link == 0 || axisOfLink(m_placement, wheel.link) == wheel.axis) continue;
    const SheetAxis& on = axis(wheel.axis);
    const double foot = wheel.isRing() ? wheel.radius + kRimHeight : laneOf(wheel.axis, wheel.link, wheel.at);
    Wanted way{wheel.link, nullptr, {}};
    for (const double side : sides(wheel.axis)) {
      way.ends.push_back(on.at(wheel.at, side * foot));
      if (wheel.isRing()) continue;
      way.ends.push_back(on.at(wheel.at - 12, side * foot));
      way.ends.push_back(on.at(wheel.at + 12, side * foot));
    }
    wanted.push_back(std::move(way));
  }
  const std::vector<PinPair> pairs = pinPairs();
  for (const PinPair& pair : pairs) {
    Wanted way{pair.pinned, nullptr, {}, &pair};
    for (const double side : sides(pair.wheel->axis)) {
      for (const double beside : {kPinReach, -kPinReach})
        way.ends.push_back(axis(pair.wheel->axis).at(pair.wheel->at + beside, side * pair.height));
    }
    wanted.push_back(std::move(way));
  }
  std::vector<CanvasPoint> ends;
  for (const Wanted& way : wanted) {
    ends.insert(ends.end(), way.ends.begin(), way.ends.end());
    if (way.arm == nullptr) continue;
    for (const LinkLine& stub : stubsOf(*way.arm)) ends.push_back(stub.to);
  }
  ArmRouter router(m_section.lines, ends);
  for (const Wanted& way : wanted) {
    if (m_stop.stop_requested()) return;
    const std::vector<LinkLine> starts = way.arm == nullptr ? std::vector<LinkLine>() : startsOf(*way.arm);
    const auto course = router.route(way.link, starts, way.ends, {}, m_stop);
    if (!course) continue;
    const std::vector<CanvasPoint>& points = course->points;
    for (std::size_t i = 1; i < points.size(); ++i) line(way.link, points[i - 1], points[i], kLinkWidth);
    if (way.pins != nullptr) addPin(*way.pins, way.ends[course->target]);
    if (way.arm != nullptr) {
      for (std::size_t i = 1; i < points.size(); ++i)
        m_armLines[way.arm->joint].push_back({points[i - 1], points[i], way.link, 0});
      for (const LinkLine& stub : stubsOf(*way.arm)) {
        if (distance(stub.to, points.front()) < 1e-6 || distance(stub.to, points.back()) < 1e-6)
          line(way.link, stub.from, stub.to, kLinkWidth);
      }
    }
    if (points.size() > 1) {
      const std::size_t half = points.size() / 2;
      anchor(m_section.links[way.link], between(points[half - 1], points[half], 0.5));
    }
  }
}

/// Of the pitch line of a wheel through several planes, what lies beside the other's.
std::pair<CanvasPoint, CanvasPoint> besideOf(const std::pair<CanvasPoint, CanvasPoint>& line,
                                             const std::pair<CanvasPoint, CanvasPoint>& other) {
  const double length = distance(line.first, line.second);
  if (length < distance(other.first, other.second) + 1) return line;
  const CanvasPoint way = unit(line.second - line.first);
  const auto along = [&](CanvasPoint p) { return std::clamp(dot(p - line.first, way), 0.0, length); };
  const double from = along(other.first), to = along(other.second);
  return to - from < 1 ? line : std::pair(line.first + from * way, line.first + to * way);
}

/// A belt of ISO 3952: a line on each side of the pulleys, which cross where the belt does.
void SectionBuilder::addStrands(const SheetWheel& a, const SheetWheel& b, const GearMesh& drawn,
                                Section::Anchors& anchors) {
  const auto middle = [&](const SheetWheel& wheel, double side) {
    const CanvasPoint bar = between(wheel.barFrom, wheel.barTo, 0.5);
    return axis(wheel.axis).at(bar.x, side * bar.y);
  };
  const std::vector<double> ofA = sides(a.axis), ofB = sides(b.axis);
  for (std::size_t i = 0; i < std::max(ofA.size(), ofB.size()); ++i) {
    const double side = ofA[std::min(i, ofA.size() - 1)];
    const std::size_t at = drawn.crossed && ofB.size() > 1 ? 1 - i : i;
    const CanvasPoint from = middle(a, side);
    const CanvasPoint to = middle(b, ofB[std::min(at, ofB.size() - 1)]);
    stroke(drawn.id, -1, from, to, kStrandWidth, kLineDepth);
    anchor(anchors, between(from, to, 0.5));
  }
}

void SectionBuilder::addMesh(const SheetPair& pair) {
  const SheetWheel& a = m_layout.wheels[pair.tail];
  const SheetWheel& b = m_layout.wheels[pair.head];
  const ElementId mesh = m_part.mechanism.gearMeshes[pair.mesh].id;
  const auto bar = [&](const SheetWheel& wheel, double side) {
    return std::pair(axis(wheel.axis).at(wheel.barFrom.x, side * wheel.barFrom.y),
                     axis(wheel.axis).at(wheel.barTo.x, side * wheel.barTo.y));
  };
  double nearest = 1e300;
  std::pair<CanvasPoint, CanvasPoint> ofA;
  std::pair<CanvasPoint, CanvasPoint> ofB;
  std::vector<std::pair<CanvasPoint, CanvasPoint>> contacts;
  for (const double side : sides(a.axis)) {
    for (const double other : sides(b.axis)) {
      const auto p = besideOf(bar(a, side), bar(b, other));
      const auto q = besideOf(bar(b, other), bar(a, side));
      const double away = std::min(distance(p.first, q.first), distance(between(p.first, p.second, 0.5),
                                                                        between(q.first, q.second, 0.5)));
      if (away < 3 * kBarGap)
        contacts.emplace_back(between(p.first, q.first, 0.5), between(p.second, q.second, 0.5));
      if (away >= nearest) continue;
      nearest = away;
      ofA = p;
      ofB = q;
    }
  }
  Section::Anchors anchors{mesh, {}};
  const GearMesh& drawn = m_part.mechanism.gearMeshes[pair.mesh];
  if (!touches(saidKind(drawn))) {
    addStrands(a, b, drawn, anchors);
    m_section.meshes.push_back(std::move(anchors));
    return;
  }
  if (contacts.empty()) {  // far apart on the sheet: a dashed bow says that they mesh
    const CanvasPoint from = ofA.first.x > ofA.second.x ? ofA.first : ofA.second;
    const CanvasPoint to = ofB.first.x > ofB.second.x ? ofB.first : ofB.second;
    const double pull = from.y < to.y ? 1 : -1;
    const Curve bow = Curve::pulled(from, to, pull * 26, pull * 26);
    put(mesh, MarkRole::line, kLineDepth, Stroke{bow, ColorRole::secondary, 1.4, Dash::dashed});
    m_section.outlines.push_back({mesh, kLineDepth, bow, kHitHalfWidth});
    forEachChord(bow, [&](CanvasPoint x, CanvasPoint y) { m_section.lines.push_back({x, y, -1, kNoHold}); });
    anchor(anchors, bow.at(0.5));
  }
  for (const auto& [from, to] : contacts) {
    m_section.highlights.push_back(
        {mesh, MarkRole::line, kSymbolDepth,
         Stroke{Polyline{{from, to}, false}, ColorRole::accent, kContactWidth, Dash::solid}});
    m_section.outlines.push_back({mesh, kSymbolDepth + 1, Curve::straight(from, to), kHitHalfWidth});
    anchor(anchors, from);
    anchor(anchors, to);
  }
  m_section.meshes.push_back(std::move(anchors));
}

/// Dash-dotted through everything that stands on an axis, and a little beyond.
void SectionBuilder::addAxes() {
  constexpr double kBeyond = 16;
  constexpr double kLonely = 90;
  for (std::size_t a = 0; a < m_layout.axes.size(); ++a) {
    const SheetAxis& on = m_layout.axes[a];
    double low = 1e300;
    double high = -1e300;
    const auto include = [&](double x) {
      low = std::min(low, x);
      high = std::max(high, x);
    };
    for (const SheetShaft& shaft : m_plan.shafts) {
      if (shaft.axis != static_cast<int>(a)) continue;
      include(shaft.low);
      include(shaft.high);
    }
    for (const SheetWheel& wheel : m_layout.wheels) {
      if (wheel.axis == static_cast<int>(a)) include(wheel.at);
    }
    if (low > high) {
      const double middle = m_layout.along(on, on.base);
      low = middle - kLonely;
      high = middle + kLonely;
    }
    const CanvasPoint from = on.at(low - kBeyond, 0);
    const CanvasPoint to = on.at(high + kBeyond, 0);
    const ElementId id = m_part.mechanism.axes[on.axis].id;
    put(id, MarkRole::line, kAxisDepth,
        Stroke{Polyline{{from, to}, false}, ColorRole::secondary, kAxisWidth, Dash::dashDotted});
    m_section.outlines.push_back({id, kAxisDepth, Curve::straight(from, to), kHitHalfWidth});
    m_section.lines.push_back({from, to, -1, kNoHold});
    m_section.axes.push_back({id, {to, from}});
  }
}

void occupy(ObstacleGrid& taken, const Shape& shape) {
  if (const auto* line = std::get_if<Polyline>(&shape)) {
    for (std::size_t i = 1; i < line->points.size(); ++i) {
      taken.addCurve(Curve::straight(line->points[i - 1], line->points[i]));
    }
    if (line->closed) taken.addCurve(Curve::straight(line->points.back(), line->points.front()));
  } else if (const auto* curve = std::get_if<Curve>(&shape)) {
    taken.addCurve(*curve);
  } else {
    taken.addBox(extentOf(shape));
  }
}

}  // namespace

Section sectionOf(const DrawnPart& part, const Placement& placement, const SheetLayout& layout,
                  const ShaftPlan& plan, const std::stop_token& stop) {
  return SectionBuilder(part, placement, layout, plan, stop).build();
}

Extent extentOf(const Section& section) {
  Extent all;
  for (std::size_t i = 0; i < section.marks.size(); ++i) {
    const Extent mark = extentOf(section.marks[i]);
    all = i == 0 ? mark : all.united(mark);
  }
  return all;
}

ObstacleGrid obstaclesOf(const Section& section, double beyond) {
  ObstacleGrid taken(extentOf(section).grown(beyond));
  for (const Mark& mark : section.marks) {
    if (const auto* stroke = std::get_if<Stroke>(&mark.what)) occupy(taken, stroke->shape);
    if (const auto* fill = std::get_if<Fill>(&mark.what)) occupy(taken, fill->shape);
  }
  return taken;
}

}  // namespace geargraph

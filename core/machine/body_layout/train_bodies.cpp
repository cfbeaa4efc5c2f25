#include "core/machine/body_layout/train_bodies.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <span>
#include <tuple>
#include <vector>

#include "core/foundations/base/text_lists.h"
#include "core/foundations/base/translation.h"
#include "core/machine/body_layout/arrangement.h"
#include "core/machine/body_layout/body_clashes.h"
#include "core/machine/body_layout/body_recipe.h"
#include "core/machine/body_layout/body_shapes.h"
#include "core/machine/body_layout/carrier_cases.h"
#include "core/machine/body_layout/carrier_flanges.h"
#include "core/machine/solids/gear_body.h"
#include "core/machine/solids/gear_solid.h"
#include "core/machine/teeth/wheel_kind.h"
#include "core/machine/train/train_diagnostics.h"

namespace geargraph {
namespace {

using Eigen::Vector3d;

constexpr int kCageBars = 5;
constexpr int kCaseBars = 4;

class BodyBuilder {
 public:
  BodyBuilder(const Arrangement& plan, const GearTrain& train, std::size_t links)
      : m_plan(plan), m_train(train), m_recipes(links), m_armsOf(links) {
    for (const ArmPlan& arm : plan.arms) m_armsOf[arm.link].push_back(&arm);
  }

  void addCase(const CasePlan& made);
  void addFlange(const FlangePlan& made);
  void addStrand(const TrainStrand& strand, LinkOrdinal carrier, bool isCrossed);

  /// By link.
  std::vector<BodyRecipe> build() {
    for (const ShaftSegment& shaft : m_plan.shafts) addShaft(shaft);
    addArms();
    for (const RingCarrierPlan& ringCarrier : m_plan.ringCarriers) addRingCarrier(ringCarrier);
    for (const RevolvedPlan& plan : m_plan.revolvedBodies) addRevolved(plan);
    for (const CagePlan& plan : m_plan.cages) addCage(plan);
    for (const PedestalPlan& pedestal : m_plan.pedestals) addPedestal(pedestal);
    addFrame(m_plan.frame);
    for (std::size_t c = 0; c < m_plan.axes.size(); ++c) {
      for (const Bearing& b : m_plan.axes[c].bearings) {
        if (b.form == BearingForm::pin) {
          addCollar(static_cast<int>(c), b);
        } else if (!b.isBoss()) {
          continue;
        } else if (!isBossOfArm(static_cast<int>(c), b)) {
          addBearing(static_cast<int>(c), b);
        }
      }
    }
    return std::move(m_recipes);
  }

 private:
  template <class Shape>
  void add(LinkOrdinal link, Shape shape, const AxisLayout& layout, const Eigen::Isometry3d& placed) {
    m_recipes[link].push_back({std::move(shape), layout.module, placed});
  }
  [[nodiscard]] const AxisLayout& axis(int c) const { return m_plan.axes[c]; }
  [[nodiscard]] static Eigen::Isometry3d line(const AxisLayout& layout) {
    return frameAlong(layout.point, layout.direction);
  }
  [[nodiscard]] Eigen::Isometry3d frame(int c, double coordinate, const Vector3d& towards) const {
    return frameAlong(axis(c).at(coordinate), axis(c).direction, towards);
  }

  void addShaft(const ShaftSegment& shaft) {
    const AxisLayout& layout = axis(shaft.axisGroup);
    add(shaft.link, TubePart{shaft.outer, shaft.inner, shaft.low, shaft.high}, layout, line(layout));
  }

  /// An arm in the plane of the bearing has its boss there already, at either end.
  [[nodiscard]] bool isBossOfArm(int c, const Bearing& bearing) const {
    const auto& arms = m_armsOf[bearing.parent];
    return std::any_of(arms.begin(), arms.end(), [&](const ArmPlan* each) {
      const ArmPlan& arm = *each;
      const bool parallel = axis(arm.from).direction.cross(axis(arm.to).direction).norm() < 1e-6;
      if (parallel && arm.to == c && arm.child == bearing.child) return true;
      return arm.from == c && std::abs(arm.level - bearing.at) < 1e-9 * axis(c).module &&
             m_plan.shaftOf(c, arm.link, arm.level) == nullptr;
    });
  }

  /// The end of a pin, which keeps what turns on it.
  void addCollar(int c, const Bearing& bearing) {
    const AxisLayout& layout = axis(c);
    const ShaftSegment* held = m_plan.shaftOf(c, bearing.child, bearing.at);
    const ShaftSegment* pin = m_plan.shaftOf(c, bearing.parent, bearing.at);
    if (held == nullptr || pin == nullptr) return;
    const double side = bearing.at < (held->low + held->high) / 2 ? -1 : 1;
    const double near = side < 0 ? held->low - 0.2 * layout.gap() : held->high + 0.2 * layout.gap();
    const double far = near + side * 0.5 * layout.width();
    add(bearing.parent, TubePart{held->outer, 0.5 * pin->outer, std::min(near, far), std::max(near, far)},
        layout, line(layout));
  }

  void addBearing(int c, const Bearing& bearing) {
    const AxisLayout& layout = axis(c);
    const double hole = holeFor(m_plan, c, bearing.at, bearing.parent);
    const double half = layout.width() / 2;
    const double outer = hole + bearing.wall * bossWall(layout);
    add(bearing.parent, TubePart{outer, hole, bearing.at - half, bearing.at + half}, layout, line(layout));
    if (bearing.parent == 0 && isOnPedestal(c, bearing.at)) addFlange(c, bearing.at, hole, outer);
  }

  void addFlange(int c, double at, double hole, double outer);
  void addPedestal(const PedestalPlan& pedestal);
  [[nodiscard]] bool hasRoom(int c, double coordinate, double radius) const;
  void addArms();
  void addSpider(std::span<const ArmPlan* const> arms);
  void addStandoff(const ArmPlan& plan);
  void addRingCarrier(const RingCarrierPlan& ringCarrier);
  void addRevolved(const RevolvedPlan& plan);
  void addCage(const CagePlan& plan);
  void addFrame(const FramePlan& frame);
  /// Is a bearing of the ground on a pedestal of its own?
  [[nodiscard]] bool isOnPedestal(int c, double at) const {
    return m_plan.isSimple ||
           std::any_of(m_plan.frame.onPedestals.begin(), m_plan.frame.onPedestals.end(),
                       [&](const auto& place) {
                         return place.first == c && std::abs(place.second - at) < 1e-6 * axis(c).module;
                       });
  }

  const Arrangement& m_plan;
  const GearTrain& m_train;
  ByLink<BodyRecipe> m_recipes;
  ByLink<std::vector<const ArmPlan*>> m_armsOf;
};

/// A bearing of the frame that no arm holds is bolted to it: four feet with holes, on the side that looks
/// away from the wheels, where no wheel goes round so near.
void BodyBuilder::addFlange(int c, double at, double hole, double outer) {
  const AxisLayout& layout = axis(c);
  const double module = layout.module;
  const double foot = 0.9 * module;
  const double distance = outer + 1.3 * module;
  if (!hasRoom(c, at, distance + foot)) return;
  double middle = 0;
  for (const Interval& s : layout.wheels)
    middle += (s.low + s.high) / 2 / static_cast<double>(layout.wheels.size());
  const double side = at < middle ? -1 : 1;
  const double far = at + side * 0.45 * layout.width();
  const double near = far - side * 0.4 * layout.width();
  std::vector<Boss> feet;
  for (int i = 0; i < 4; ++i) {
    const double angle = std::numbers::pi / 4 + std::numbers::pi / 2 * i;
    feet.push_back({distance * Eigen::Vector2d(std::cos(angle), std::sin(angle)), foot, 0.45 * foot});
  }
  const double seat = hole + 0.4 * (outer - hole);  // within the bearing's wall
  const Boss hub{{0, 0}, outer + 0.1 * module, seat};
  add(0, SpiderPart{hub, std::move(feet), std::min(near, far), std::max(near, far)}, layout, line(layout));
}

/// A collar about the shaft, with feet.
void BodyBuilder::addPedestal(const PedestalPlan& pedestal) {
  const AxisLayout& layout = axis(pedestal.axisGroup);
  const ShaftSegment* shaft = m_plan.shaftOf(pedestal.axisGroup, 0, pedestal.at);
  if (shaft == nullptr) return;
  const double half = 0.45 * layout.width();
  const double hole = 0.5 * (shaft->inner + shaft->outer);
  const double outer = shaft->outer + bossWall(layout);
  add(0, TubePart{outer, hole, pedestal.at - half, pedestal.at + half}, layout, line(layout));
  if (isOnPedestal(pedestal.axisGroup, pedestal.at)) addFlange(pedestal.axisGroup, pedestal.at, hole, outer);
}

/// Does no gear of another axis come nearer to this one, beside the coordinate?
bool BodyBuilder::hasRoom(int c, double coordinate, double radius) const {
  const AxisLayout& layout = axis(c);
  return std::none_of(m_train.gears.begin(), m_train.gears.end(), [&](const TrainGear& gear) {
    if (gear.axisGroup == c) return false;
    const AxialSpan span = axialSpan(gear.spec);
    const Vector3d k = gear.pose.linear().col(2);
    const Vector3d middle = gear.pose.translation() + (span.low + span.high) / 2 * k;
    const double half = (span.high - span.low) / 2;
    const double tip = outerRadius(gear.spec);
    const double tilt = k.cross(layout.direction).norm();
    const double along = half * std::abs(k.dot(layout.direction)) + tip * tilt;
    if (std::abs(layout.coordinate(middle) - coordinate) > along + layout.width()) return false;
    const double apart = (middle - layout.at(layout.coordinate(middle))).norm();
    return apart < radius + tip + half * tilt;
  });
}

/// Arms of a link that start at one place are one part.
void BodyBuilder::addArms() {
  std::map<std::tuple<int, int, long long>, std::vector<const ArmPlan*>> together;
  for (const ArmPlan& plan : m_plan.arms) {
    const double step = 1e-6 * axis(plan.from).module;
    together[{plan.link, plan.from, std::llround(plan.level / step)}].push_back(&plan);
  }
  for (const auto& [place, arms] : together) addSpider(arms);
  for (const ArmPlan& plan : m_plan.arms) addStandoff(plan);
}

void BodyBuilder::addSpider(std::span<const ArmPlan* const> arms) {
  const ArmPlan& first = *arms.front();
  const AxisLayout& from = axis(first.from);
  const Boss hub = footOf(m_plan, first);
  std::vector<Boss> ends;
  for (const ArmPlan* plan : arms) ends.push_back(endOf(m_plan, *plan));
  const double half = 0.5 * from.width();
  add(first.link, SpiderPart{hub, std::move(ends), -half, half}, from,
      frame(first.from, first.level, Vector3d::UnitX()));
}

void BodyBuilder::addStandoff(const ArmPlan& plan) {
  const AxisLayout& from = axis(plan.from);
  const std::optional<Standoff> standoff = standoffOf(m_plan, plan);
  if (!standoff) return;
  add(plan.link, TubePart{standoff->radius, 0, -0.45 * from.width(), standoff->reach}, from,
      frameAlong(standoff->foot, standoff->way));
}

/// The plate beside the ring's face and the wall that joins them.
void BodyBuilder::addRingCarrier(const RingCarrierPlan& ringCarrier) {
  const TrainGear& gear = m_train.gears[static_cast<std::size_t>(ringCarrier.gear)];
  const AxisLayout& layout = axis(gear.axisGroup);
  const ShaftSegment* own = m_plan.shaftOf(gear.axisGroup, gear.link, ringCarrier.plate);
  if (own == nullptr) return;
  // The wall reaches a little into the ring and stays a little behind its rim: no face of one lies on the
  // other's.
  const double face = layout.coordinate(gear.pose.translation()) +
                      ringCarrier.side * (gear.spec.faceWidth / 2 - 0.2 * gear.spec.module);
  const double half = 0.5 * layout.width();
  const double nearSide = ringCarrier.plate - ringCarrier.side * half;
  const double farSide = ringCarrier.plate + ringCarrier.side * half;
  const double rim = rimDiameter(gear.spec) / 2 - 0.05 * gear.spec.module;
  const double root = nominalRootRadius(gear.spec) + 0.4 * gear.spec.module;
  const double hole = std::max(own->inner, 0.5 * own->outer);
  std::vector<ProfileVertex> profile{{rim, farSide},   {hole, farSide}, {hole, nearSide},
                                     {root, nearSide}, {root, face},    {rim, face}};
  if (ringCarrier.side < 0) std::reverse(profile.begin(), profile.end());
  add(gear.link, RevolvedPart{std::move(profile)}, layout, line(layout));
}

void BodyBuilder::addRevolved(const RevolvedPlan& plan) {
  const AxisLayout& layout = axis(plan.axisGroup);
  for (const std::vector<ProfileVertex>& profile : plan.profiles)
    add(plan.link, RevolvedPart{profile}, layout, line(layout));
}

void BodyBuilder::addCage(const CagePlan& plan) {
  const AxisLayout& layout = axis(plan.axisGroup);
  const double half = std::clamp(1.5 * layout.module / plan.outer, 0.12, 0.4);
  const BarPart bar{plan.outer, plan.inner, plan.low, plan.high, half};
  for (int i = 0; i < kCageBars; ++i) {
    const Eigen::AngleAxisd turn(2 * std::numbers::pi * i / kCageBars, Vector3d::UnitZ());
    add(plan.link, bar, layout, line(layout) * turn);
  }
}

/// The rings, the bars between them, and what holds them.
void BodyBuilder::addCase(const CasePlan& made) {
  const AxisLayout& own = axis(made.axisGroup);
  for (const auto& [low, high] : made.rings)
    add(made.link, TubePart{made.outer, made.inner, low, high}, own, line(own));
  for (const CaseTube& tube : made.tubes) {
    const Vector3d way = tube.to - tube.from;
    add(made.link, TubePart{tube.outer, tube.inner, 0, way.norm()}, own,
        frameAlong(tube.from, way.normalized()));
  }
  if (made.rings.size() < 2) return;
  const auto middle = [](const auto& ring) { return (ring.first + ring.second) / 2; };
  const auto [from, to] = std::minmax({middle(made.rings.front()), middle(made.rings.back())});
  const double rim = 0.15 * own.module;  // no face of one lies on one of the other
  const BarPart bar{made.outer - rim, made.inner + rim, from, to, 1.5 * own.module / made.outer};
  for (int i = 0; i < kCaseBars; ++i) {
    const Eigen::AngleAxisd turn(2 * std::numbers::pi * (i + 0.5) / kCaseBars, Vector3d::UnitZ());
    add(made.link, bar, own, frameAlong(own.point, own.direction, made.towards) * turn);
  }
}

/// The second flange, the pillars, and arms to these from the first.
void BodyBuilder::addFlange(const FlangePlan& made) {
  const AxisLayout& own = axis(made.axisGroup);
  const double half = 0.5 * own.width();
  const auto at = [&](double level) { return frame(made.axisGroup, level, Vector3d::UnitX()); };
  add(made.link, SpiderPart{made.hub, made.ends, -half, half}, own, at(made.level));
  // Arms to pillars are parts of their own, between those to planets; no face of one lies on one of another.
  const auto addArmsToPillars = [&](double level, Boss hub) {
    hub.radius -= 0.1 * own.module;
    hub.hole += hub.hole > 0 ? 0.05 * own.module : 0;
    add(made.link, SpiderPart{hub, made.pillars, -0.9 * half, 0.9 * half}, own, at(level));
  };
  addArmsToPillars(made.level, made.hub);
  addArmsToPillars(made.arms, footOf(m_plan, {made.link, made.axisGroup, made.arms}));
  const auto [low, high] = std::minmax({made.arms, made.level});
  for (const Boss& pillar : made.pillars) {
    Eigen::Isometry3d place = at(low);
    place.translate(Vector3d(pillar.centre.x(), pillar.centre.y(), 0));
    add(made.link, TubePart{pillar.radius - 0.05 * own.module, 0, 0, high - low}, own, place);
  }
}

/// A belt: two arcs round its pulleys and two straight strands, which stay where they are in the carrier.
/// Runs at the running radius in the middle of its thickness.
void BodyBuilder::addStrand(const TrainStrand& strand, LinkOrdinal carrier, bool isCrossed) {
  constexpr double kShareOfFace = 0.8;
  const TrainGear& tail = m_train.gears[static_cast<std::size_t>(int{strand.tailGear})];
  const TrainGear& head = m_train.gears[static_cast<std::size_t>(int{strand.headGear})];
  const Vector3d along = tail.pose.linear().col(2);
  const Vector3d from = tail.pose.translation();
  Vector3d way = head.pose.translation() - from;
  way -= way.dot(along) * along;
  const double distance = way.norm();
  const double tailRadius = pitchRadius(tail.spec), headRadius = pitchRadius(head.spec);
  const double headSide = isCrossed ? -headRadius : headRadius;
  const double cosine = (tailRadius - headSide) / distance;
  if (!(std::abs(cosine) < 1)) return;
  const double angle = std::acos(cosine);
  const double half = kHalfBelt * tail.spec.module;
  const double width = kShareOfFace * std::min(tail.spec.faceWidth, head.spec.faceWidth) / 2;
  const AxisLayout& own = axis(tail.axisGroup);
  const auto arc = [&](const Vector3d& centre, const Vector3d& towards, double radius, double halfAngle) {
    add(carrier, BarPart{radius + half, radius - half, -width, width, halfAngle}, own,
        frameAlong(centre, along, towards));
  };
  arc(from, -way / distance, tailRadius, std::numbers::pi - angle);
  arc(from + way, way / distance, headRadius, isCrossed ? std::numbers::pi - angle : angle);
  for (const double side : {-1.0, 1.0}) {
    const Eigen::Vector2d outward(cosine, side * std::sin(angle));
    const Eigen::Vector2d start = tailRadius * outward;
    const Eigen::Vector2d end = Eigen::Vector2d(distance, 0) + headSide * outward;
    add(carrier, PlatePart{{{start, half, 0}, {end, half, 0}}, -width, width}, own,
        frameAlong(from, along, way / distance));
  }
}

/// Housings, bars, and the base.
void BodyBuilder::addFrame(const FramePlan& frame) {
  for (const HousingPlan& h : frame.housings)
    add(0, TubePart{h.outer, h.inner, h.low, h.high}, axis(h.axisGroup), line(axis(h.axisGroup)));
  for (const FrameBar& bar : frame.bars) {
    const Vector3d way = bar.to - bar.from;
    add(0, TubePart{bar.radius, 0, 0, way.norm()}, m_plan.axes.front(),
        frameAlong(bar.from, way.normalized()));
  }
  if (frame.feet.empty()) return;
  std::vector<Boss> corners;
  for (const FramePlan::Foot& foot : frame.feet) corners.push_back({foot.place, foot.radius, 0});
  add(0, PlatePart{std::move(corners), frame.top - frame.thickness, frame.top}, m_plan.axes.front(),
      Eigen::Isometry3d::Identity());
}

/// The bore about the link's own shaft, or with play about what passes.
void fitBore(const Arrangement& plan, TrainGear& gear) {
  if (isRing(gear.spec) || gear.spec.bore != 0) return;
  const AxisLayout& layout = plan.axes[gear.axisGroup];
  const double sense = gear.pose.linear().col(2).dot(layout.direction) < 0 ? -1 : 1;
  const AxialSpan hub = hubSpan(gear.spec);
  const double middle = layout.coordinate(gear.pose.translation()) + sense * (hub.low + hub.high) / 2;
  const ShaftSegment* own = plan.shaftOf(gear.axisGroup, gear.link, middle);
  if (own != nullptr && own->low <= middle && middle <= own->high) {
    gear.spec.bore = 2 * own->outer;
    return;
  }
  const double passing = plan.shaftAt(gear.axisGroup, middle, gear.link);
  if (passing > 0) gear.spec.bore = 2 * (passing + 0.12 * layout.module);
}

Diagnostic blockedDiagnostic(const Mechanism& mechanism, const std::vector<LinkOrdinal>& links) {
  std::vector<std::string> labels;
  std::vector<ElementId> elements;
  for (const LinkOrdinal link : links) {
    labels.push_back(std::to_string(link));
    elements.emplace_back(mechanism.links[link].id);
  }
  const auto statesPoint = [&](const GearMesh& mesh) {
    const auto isOne = [&](const ElementId& link) { return link == mesh.tail || link == mesh.head; };
    return mesh.pitchPoint && std::any_of(elements.begin(), elements.end(), isOne);
  };
  const bool any = std::any_of(mechanism.gearMeshes.begin(), mechanism.gearMeshes.end(), statesPoint);
  const std::string names = listed(labels, kAllNames);
  return makeDiagnostic(
      Detail::bodiesOverlap,
      any ? translated(
                "Links %1 overlap in 3D: move their joints along the axes, leave pitch points open, or "
                "change the tooth counts.",
                {names})
          : translated(
                "Links %1 overlap in 3D: move their joints along the axes, or change the tooth counts.",
                {names}),
      std::move(elements));
}

}  // namespace

Diagnostics bodyDiagnostics(const Mechanism& mechanism, const GearTrain& train) {
  Diagnostics found;
  for (const auto& links : train.blocked) found.push_back(blockedDiagnostic(mechanism, links));
  return found;
}

LinkBody bodyOf(LinkOrdinal link, BodyRecipe recipe) {
  const auto byModule = [](const BodyPart& a, const BodyPart& b) { return a.module < b.module; };
  const double module = std::min_element(recipe.begin(), recipe.end(), byModule)->module;
  const auto shared = std::make_shared<const BodyRecipe>(std::move(recipe));
  const auto deferred = [&](double tolerance) {
    return std::make_shared<const DeferredSolid>([shared, tolerance] { return madeBy(*shared, tolerance); });
  };
  return {link, module, deferred(kBodyTolerance), deferred(kMaxTolerance), shared};
}

Arrangement addBodies(const Mechanism& mechanism, const Placement& placement, GearTrain& train,
                      const std::stop_token& stop) {
  Arrangement plan = arrangementOf(mechanism, placement, train, stop);
  if (stop.stop_requested()) return plan;
  const std::vector<CasePlan> cases = carrierCases(plan, train, placement);
  const std::vector<FlangePlan> flanges = carrierFlanges(plan, train, placement);
  train.hasSimpleBodies = plan.isSimple;
  train.blocked = plan.blocked;
  for (TrainGear& gear : train.gears) fitBore(plan, gear);
  for (const auto& [gear, diameter] : plan.hubs) {
    GearSpec& spec = train.gears[gear].spec;
    spec.hub = std::max(diameter, 1.2 * spec.bore);
  }
  // Webs with windows are half of what a wheel is made of, and cannot be told apart in so large a train.
  for (TrainGear& gear : train.gears) gear.spec.body = plan.isSimple ? GearBody::plain : gear.spec.body;
  Arrangement built = plan;
  reachFlanges(built, flanges);
  BodyBuilder builder(built, train, mechanism.links.size());
  for (const CasePlan& made : cases) builder.addCase(made);
  for (const FlangePlan& made : flanges) builder.addFlange(made);
  for (const TrainStrand& strand : train.strands) {
    builder.addStrand(strand, placement.meshes[strand.mesh]->carrier,
                      mechanism.gearMeshes[strand.mesh].crossed);
  }
  std::vector<BodyRecipe> recipes = builder.build();
  for (std::size_t link = 0; link < recipes.size() && !stop.stop_requested(); ++link) {
    if (!recipes[link].empty())
      train.bodies.push_back(bodyOf(static_cast<int>(link), std::move(recipes[link])));
  }
  return plan;
}

}  // namespace geargraph

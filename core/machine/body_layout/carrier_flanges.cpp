#include "core/machine/body_layout/carrier_flanges.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <optional>
#include <tuple>
#include <utility>

#include "core/machine/body_layout/body_shapes.h"
#include "core/machine/body_layout/swept_envelope.h"
#include "core/machine/solids/gear_body.h"
#include "core/machine/teeth/wheel_kind.h"

namespace geargraph {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

// In modules of the carrier's axis.
constexpr double kPlay = 0.4;      ///< between a pillar and gears
constexpr double kThinnest = 0.8;  ///< radius of a pillar
constexpr double kThickest = 1.5;
constexpr int kPlaces = 32;  ///< from the axis outwards where a pillar may stand

/// A gear beside which pillars pass, as a circle in the plane of the arms.
struct PassedGear {
  Vector2d centre;
  double radius = 0;
  bool isAround = false;  ///< a ring: pillars stand inside
};

class FlangeMaker {
 public:
  FlangeMaker(const Arrangement& plan, const GearTrain& train, std::vector<const ArmPlan*> arms,
              const std::vector<SweptEnvelope>& envelopes)
      : m_plan(plan), m_train(train), m_arms(std::move(arms)), m_envelopes(envelopes) {}

  std::optional<FlangePlan> make() {
    const ArmPlan& first = *m_arms.front();
    m_made.link = first.link;
    m_made.axisGroup = first.from;
    m_made.arms = first.level;
    if (!findLevel() || !isSlotFree()) return std::nullopt;
    addBosses();
    addPillars();
    if (m_made.pillars.size() < 2 || !isClear()) return std::nullopt;
    return std::move(m_made);
  }

 private:
  [[nodiscard]] const AxisLayout& axis(int c) const { return m_plan.axes[c]; }
  [[nodiscard]] const AxisLayout& own() const { return axis(m_made.axisGroup); }
  [[nodiscard]] bool isOwn(LinkOrdinal link) const {
    return link == m_made.link ||
           std::any_of(m_arms.begin(), m_arms.end(), [&](const ArmPlan* arm) { return arm->child == link; });
  }
  [[nodiscard]] double carried(int c, double at) const { return own().coordinate(axis(c).at(at)); }

  bool findLevel();
  [[nodiscard]] bool isSlotFree() const;
  void addBosses();
  void addPillars();
  [[nodiscard]] std::vector<PassedGear> circles() const;
  [[nodiscard]] bool isClear() const;

  const Arrangement& m_plan;
  const GearTrain& m_train;
  std::vector<const ArmPlan*> m_arms;
  const std::vector<SweptEnvelope>& m_envelopes;
  FlangePlan m_made;
  double m_reach = 0;  ///< of the arms, their ends included
};

/// All planets stand on one side of the arms; the flange beyond.
bool FlangeMaker::findLevel() {
  double low = 1e300, high = -1e300;
  for (const ArmPlan* arm : m_arms) {
    const AxisLayout& to = axis(arm->to);
    const auto wheels = to.wheelsOf(arm->child);
    const bool parallel = own().direction.cross(to.direction).norm() < 1e-6;
    if (!parallel || !wheels || std::abs(arm->level - m_made.arms) > 1e-9 * own().module) return false;
    for (const double at : {wheels->low, wheels->high}) {
      low = std::min(low, carried(arm->to, at));
      high = std::max(high, carried(arm->to, at));
    }
  }
  const double beyond = own().gap() + own().width() / 2;
  if (own().isBelow(high, m_made.arms)) {
    m_made.level = low - beyond;
  } else if (own().isBelow(m_made.arms, low)) {
    m_made.level = high + beyond;
  } else {
    return false;
  }
  return true;
}

/// Nothing stands on the axes there, though shafts may pass along the carrier's own.
bool FlangeMaker::isSlotFree() const {
  const auto isFreeOn = [&](int c) {
    const double middle = axis(c).coordinate(own().at(m_made.level)), half = own().width() / 2;
    return std::none_of(axis(c).occupied.begin(), axis(c).occupied.end(), [&](const Interval& s) {
      return s.link >= 0 && axis(c).overlap(s.low, s.high, middle - half, middle + half);
    });
  };
  return isFreeOn(m_made.axisGroup) &&
         std::all_of(m_arms.begin(), m_arms.end(), [&](const ArmPlan* arm) { return isFreeOn(arm->to); });
}

void FlangeMaker::addBosses() {
  const double wall = bossWall(own());
  const double hole = holeFor(m_plan, m_made.axisGroup, m_made.level, m_made.link);
  m_made.hub = {Vector2d::Zero(), hole + wall, hole};
  for (const ArmPlan* arm : m_arms) {
    m_made.ends.push_back(endOf(m_plan, *arm));
    m_made.children.push_back(arm->child);
    m_reach = std::max(m_reach, m_made.ends.back().centre.norm() + m_made.ends.back().radius);
  }
}

/// Of all gears of the carrier's axis and of its planets, those between the flanges.
std::vector<PassedGear> FlangeMaker::circles() const {
  std::vector<PassedGear> circles;
  const Eigen::Isometry3d frame = frameAlong(own().at(m_made.arms), own().direction, Vector3d::UnitX());
  for (const TrainGear& gear : m_train.gears) {
    const bool isCentral = gear.axisGroup == m_made.axisGroup;
    if (!isCentral && !isOwn(gear.link)) continue;
    const double at = own().coordinate(gear.pose.translation()), half = gear.spec.faceWidth / 2;
    const auto [low, high] = std::minmax({m_made.arms, m_made.level});
    if (!own().overlap(at - half, at + half, low, high)) continue;
    const Vector3d local = frame.inverse() * gear.pose.translation();
    circles.push_back({local.head<2>(), nominalTipRadius(gear.spec), isRing(gear.spec)});
  }
  return circles;
}

/// Between neighbours, where most room is.
void FlangeMaker::addPillars() {
  std::vector<double> planets;
  for (const Boss& end : m_made.ends) planets.push_back(std::atan2(end.centre.y(), end.centre.x()));
  std::sort(planets.begin(), planets.end());
  std::vector<double> angles;
  const double turn = 2 * std::numbers::pi;
  for (std::size_t i = 0; i < planets.size(); ++i) {
    const double next = i + 1 < planets.size() ? planets[i + 1] : planets.front() + turn;
    const int shares = next - planets[i] > 0.7 * turn ? 3 : 2;  // a wide gap has room for two
    for (int k = 1; k < shares; ++k) angles.push_back(planets[i] + (next - planets[i]) * k / shares);
  }
  const std::vector<PassedGear> gears = circles();
  const double module = own().module;
  for (const double angle : angles) {
    const Vector2d way(std::cos(angle), std::sin(angle));
    Boss best;
    best.radius = 0;
    for (int i = 1; i < kPlaces; ++i) {
      const Vector2d place = m_reach * i / kPlaces * way;
      double room = std::min(kThickest * module, m_reach - place.norm());
      for (const PassedGear& gear : gears) {
        const double away = (place - gear.centre).norm();
        room = std::min(room, (gear.isAround ? gear.radius - away : away - gear.radius) - kPlay * module);
      }
      if (room > best.radius + 1e-9 * module) best = {place, room, 0};
    }
    if (best.radius > kThinnest * module) m_made.pillars.push_back(best);
  }
}

/// Is nothing else in the flange or between the flanges in any pose, and does the ground's frame pass?
bool FlangeMaker::isClear() const {
  const double module = own().module, half = own().width() / 2;
  double nearest = 1e300;  // of the pillars
  for (const Boss& pillar : m_made.pillars) nearest = std::min(nearest, pillar.centre.norm() - pillar.radius);
  SweptEnvelope flange;
  flange.point = own().point;
  flange.direction = own().direction;
  flange.low = m_made.level - half;
  flange.high = m_made.level + half;
  flange.inner = m_made.hub.hole;
  flange.outer = m_reach;
  SweptEnvelope drum = flange;
  std::tie(drum.low, drum.high) = std::minmax({m_made.arms, m_made.level});
  drum.inner = nearest;
  const auto meets = [&](const SweptEnvelope& a, const SweptEnvelope& b) {
    const double play = 0.1 * module;
    return a.low < b.high + play && b.low < a.high + play && a.inner < b.outer + play &&
           b.inner < a.outer + play;
  };
  for (const SweptEnvelope& e : m_envelopes) {
    if (isOwn(e.link)) continue;
    if (e.axisGroup != m_made.axisGroup) {
      const Vector3d low = e.point + e.low * e.direction, high = e.point + e.high * e.direction;
      if (drum.isNear(low, high, e.outer) || flange.isNear(low, high, e.outer)) return false;
      continue;
    }
    const bool isGear = e.isOnAxis && e.kind == HullKind::gear;
    const bool isShaft = e.isOnAxis && e.kind == HullKind::shaft && e.outer < m_made.hub.hole;
    if ((!isShaft && meets(flange, e)) || (!isGear && !isShaft && meets(drum, e))) return false;
  }
  for (const RingCarrierPlan& ringCarrier : m_plan.ringCarriers) {  // their walls
    const TrainGear& ring = m_train.gears[ringCarrier.gear];
    const double at = own().coordinate(ring.pose.translation());
    const auto [low, high] = std::minmax({at, ringCarrier.plate});
    if (ring.axisGroup == m_made.axisGroup && low < flange.high && flange.low < high &&
        nominalRootRadius(ring.spec) < m_reach + kPlay * module)
      return false;
  }
  return std::none_of(m_plan.frame.bars.begin(), m_plan.frame.bars.end(), [&](const FrameBar& bar) {
    return flange.isNear(bar.from, bar.to, bar.radius) || drum.isNear(bar.from, bar.to, bar.radius);
  });
}

}  // namespace

std::vector<FlangePlan> carrierFlanges(const Arrangement& plan, const GearTrain& train,
                                       const Placement& placement) {
  if (plan.isSimple) return {};
  std::map<std::pair<int, int>, std::vector<const ArmPlan*>> carriers;  // by link and its axis
  for (const ArmPlan& arm : plan.arms) {
    const bool isOnGround = placement.classes->classes[arm.from].rootLink == 0;
    if (arm.link != 0 && isOnGround) carriers[{arm.link, arm.from}].push_back(&arm);
  }
  std::vector<FlangePlan> flanges;
  std::optional<std::vector<SweptEnvelope>> envelopes;
  for (const auto& [place, arms] : carriers) {
    const auto& [link, home] = place;
    const auto isOfLink = [&, of = link](const Bearing& b) { return b.parent == of; };
    std::ptrdiff_t held = 0;
    for (const AxisLayout& layout : plan.axes)
      held += std::count_if(layout.bearings.begin(), layout.bearings.end(), isOfLink);
    const bool isRevolved = std::any_of(plan.revolvedBodies.begin(), plan.revolvedBodies.end(),
                                        [&, on = home](const RevolvedPlan& l) { return l.axisGroup == on; });
    if (held != static_cast<std::ptrdiff_t>(arms.size()) || isRevolved) continue;
    if (!envelopes) envelopes = sweptEnvelopes(plan, train, placement);
    if (auto made = FlangeMaker(plan, train, arms, *envelopes).make()) flanges.push_back(std::move(*made));
  }
  return flanges;
}

void reachFlanges(Arrangement& plan, const std::vector<FlangePlan>& flanges) {
  for (const FlangePlan& flange : flanges) {
    const AxisLayout& own = plan.axes[flange.axisGroup];
    for (ShaftSegment& shaft : plan.shafts) {
      const auto& children = flange.children;
      if (std::find(children.begin(), children.end(), shaft.link) == children.end()) continue;
      const AxisLayout& on = plan.axes[shaft.axisGroup];
      const double at = on.coordinate(own.at(flange.level)), half = 0.5 * own.width() + 0.2 * own.module;
      shaft.include(at - half, at + half);
    }
  }
}

}  // namespace geargraph

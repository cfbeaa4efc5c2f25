#include "core/machine/body_layout/carrier_cases.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <set>
#include <utility>

#include "core/machine/body_layout/body_shapes.h"

namespace geargraph {
namespace {

using Eigen::Vector3d;

// In modules of the carrier's axis.
constexpr double kRing = 1.4;  ///< thickness of the ring
constexpr double kPlay = 0.6;  ///< between it and all else

Vector3d wideOf(const Vector3& v) {
  return {v[0], v[1], v[2]};
}

DiscHull cylinder(const Vector3d& point, const Vector3d& direction, double low, double high, double radius) {
  DiscHull discs;
  for (const double z : {low, high}) {
    const Vector3d centre = point + z * direction;
    discs.push_back(
        {{centre.x(), centre.y(), centre.z()}, {direction.x(), direction.y(), direction.z()}, radius});
  }
  return discs;
}

/// A pinion's boss about its axis, which meets the carrier's.
struct PinionBoss {
  const ArmPlan* arm = nullptr;
  double intersection = 0;  ///< coordinate along the pinion's axis
  double side = 1;          ///< on which the boss stands of the intersection
};

/// The bosses of a carrier whose axes meet its own at right angles in one point, each on a side of its own,
/// for links that hold nothing themselves; none where it has others or fewer than two. And the point's level.
std::vector<PinionBoss> bossesOf(const Arrangement& plan, const std::vector<const ArmPlan*>& arms,
                                 double& level) {
  const AxisLayout& own = plan.axes[arms.front()->from];
  std::vector<PinionBoss> bosses;
  std::set<std::pair<int, double>> sides;
  for (const ArmPlan* arm : arms) {
    const AxisLayout& to = plan.axes[arm->to];
    if (std::abs(own.direction.dot(to.direction)) > 1e-9) return {};
    const double along = own.coordinate(to.point);  // where axes at right angles come nearest
    const double intersection = to.coordinate(own.at(along));
    const bool meets = (to.at(intersection) - own.at(along)).norm() < 1e-6 * own.module;
    if (!meets || (!bosses.empty() && std::abs(along - level) > 1e-6 * own.module)) return {};
    const auto isHeld = [&](const auto& each) { return each.link == arm->child; };
    if (std::any_of(plan.arms.begin(), plan.arms.end(), isHeld) ||
        std::any_of(plan.pins.begin(), plan.pins.end(), isHeld) ||
        std::any_of(plan.crossShaftBosses.begin(), plan.crossShaftBosses.end(), isHeld))
      return {};
    level = along;
    bosses.push_back({arm, intersection, arm->at < intersection ? -1.0 : 1.0});
    if (!sides.insert({arm->to, bosses.back().side}).second) return {};
  }
  return bosses.size() < 2 ? std::vector<PinionBoss>{} : bosses;
}

class CaseMaker {
 public:
  CaseMaker(const Arrangement& plan, const GearTrain& train, const Placement& placement)
      : m_plan(plan),
        m_envelopes(sweptEnvelopes(plan, train, placement)),
        m_hulls(bodyHulls(plan, train, {0, true})) {}

  [[nodiscard]] std::optional<CasePlan> make(const std::vector<PinionBoss>& bosses, double level) const {
    const ArmPlan& first = *bosses.front().arm;
    const AxisLayout& own = axis(first.from);
    const auto ring = [&](double middle) {
      return std::pair{middle - 0.5 * own.width(), middle + 0.5 * own.width()};
    };
    CasePlan made;
    made.link = first.link;
    made.axisGroup = first.from;
    made.inner = innerRadius(bosses, own);
    made.outer = made.inner + kRing * own.module;
    made.towards = wayOf(bosses.front());
    made.rings = {ring(level), ring(first.level)};
    const bool areInOnePlane = std::all_of(bosses.begin(), bosses.end(), [&](const PinionBoss& boss) {
      return std::abs(boss.arm->level - first.level) < 1e-9 * own.module;
    });
    if (!areInOnePlane || !isFree(made, bosses)) made.rings.pop_back();
    if (!isFree(made, bosses)) return std::nullopt;
    for (const PinionBoss& boss : bosses) addTubes(boss, made);
    return made;
  }

 private:
  [[nodiscard]] const AxisLayout& axis(int c) const { return m_plan.axes[c]; }

  /// From the carrier's axis to the boss.
  [[nodiscard]] Vector3d wayOf(const PinionBoss& boss) const {
    return boss.side * axis(boss.arm->to).direction;
  }

  /// Round all that the pinions' links are made of, and the bosses.
  [[nodiscard]] double innerRadius(const std::vector<PinionBoss>& bosses, const AxisLayout& own) const {
    double inner = 0;
    for (const PinionBoss& boss : bosses) {
      const AxisLayout& to = axis(boss.arm->to);
      inner = std::max(inner, std::abs(boss.arm->at - boss.intersection) + 0.5 * to.width());
      for (const BodyHull& hull : m_hulls) {
        if (hull.link != boss.arm->child) continue;
        for (const Disc& disc : hull.discs) {
          const Vector3d apart = wideOf(disc.centre) - own.point;
          const double away = (apart - apart.dot(own.direction) * own.direction).norm();
          inner = std::max(inner, std::hypot(away, disc.radius));
        }
      }
    }
    return inner + kPlay * own.module;
  }

  /// Where the frame found no way round.
  [[nodiscard]] bool meetsFrame(const SweptEnvelope& whole) const {
    const FramePlan& frame = m_plan.frame;
    if (!frame.feet.empty() && whole.lowestAlong(Vector3d::UnitZ()) < frame.top) return true;
    return std::any_of(frame.bars.begin(), frame.bars.end(),
                       [&](const FrameBar& bar) { return whole.isNear(bar.from, bar.to, bar.radius); }) ||
           std::any_of(frame.housings.begin(), frame.housings.end(), [&](const HousingPlan& h) {
             return whole.isNear(axis(h.axisGroup).at(h.low), axis(h.axisGroup).at(h.high), h.outer);
           });
  }

  /// Is there nothing in the ring but what the carrier holds?
  [[nodiscard]] bool isFree(const CasePlan& made, const std::vector<PinionBoss>& bosses) const {
    const AxisLayout& own = axis(made.axisGroup);
    const double play = kPlay * own.module;
    std::set<int> inside{made.link};
    for (const PinionBoss& boss : bosses) inside.insert(boss.arm->child);
    const SweptEnvelope whole = envelopeOf(made, own);
    const DiscHull filled =
        cylinder(own.point, own.direction, whole.low - play, whole.high + play, made.outer + play);
    const auto isInRing = [&](double low, double high, double inner, double outer) {
      return low < whole.high + play && whole.low - play < high && made.inner - play < outer &&
             inner < made.outer + play;
    };
    for (const SweptEnvelope& e : m_envelopes) {
      if (inside.contains(e.link)) continue;
      const bool isAbout = e.axisGroup == made.axisGroup;
      if (isAbout ? isInRing(e.low, e.high, e.inner, e.outer)
                  : areNear(cylinder(e.point, e.direction, e.low, e.high, e.outer), filled))
        return false;
    }
    if (meetsFrame(whole)) return false;
    return std::none_of(m_hulls.begin(), m_hulls.end(), [&](const BodyHull& hull) {
      if (hull.link != 0) return false;
      if (hull.axisGroup != made.axisGroup || hull.kind == HullKind::arm) return areNear(hull.discs, filled);
      double low = 1e300, high = -1e300, outer = 0;
      for (const Disc& disc : hull.discs) {
        low = std::min(low, own.coordinate(wideOf(disc.centre)));
        high = std::max(high, own.coordinate(wideOf(disc.centre)));
        outer = std::max(outer, disc.radius);
      }
      return isInRing(low, high, 0, outer);
    });
  }

  /// From within the boss's wall into its ring, and from the arm's end into the other one.
  void addTubes(const PinionBoss& boss, CasePlan& made) const {
    const AxisLayout& own = axis(made.axisGroup);
    const AxisLayout& to = axis(boss.arm->to);
    const double wall = bossWall(to), hole = holeFor(m_plan, boss.arm->to, boss.arm->at, made.link);
    const double ring = (made.inner + made.outer) / 2, away = std::abs(boss.arm->at - boss.intersection);
    const Vector3d middle = to.at(boss.intersection), way = wayOf(boss);
    made.tubes.push_back({middle + (away + 0.25 * to.width()) * way, middle + ring * way, hole + 0.1 * wall,
                          hole + 0.9 * wall});
    if (made.rings.size() < 2) return;
    const Vector3d foot = own.at(boss.arm->level);
    made.tubes.push_back({foot + away * way, foot + ring * way, 0, 1.2 * own.module});
  }

  const Arrangement& m_plan;
  std::vector<SweptEnvelope> m_envelopes;
  std::vector<BodyHull> m_hulls;
};

}  // namespace

std::vector<CasePlan> carrierCases(const Arrangement& plan, const GearTrain& train,
                                   const Placement& placement) {
  if (plan.isSimple) return {};
  std::map<std::pair<int, int>, std::vector<const ArmPlan*>> carriers;  // by link and its axis
  for (const ArmPlan& arm : plan.arms) {
    const bool isOnGround = placement.classes->classes[arm.from].rootLink == 0;
    if (arm.link != 0 && isOnGround) carriers[{arm.link, arm.from}].push_back(&arm);
  }
  std::optional<CaseMaker> maker;
  std::vector<CasePlan> cases;
  for (const auto& [place, arms] : carriers) {
    double level = 0;
    const std::vector<PinionBoss> bosses = bossesOf(plan, arms, level);
    if (bosses.empty()) continue;
    if (!maker) maker.emplace(plan, train, placement);
    if (auto made = maker->make(bosses, level)) cases.push_back(std::move(*made));
  }
  return cases;
}

SweptEnvelope envelopeOf(const CasePlan& made, const AxisLayout& axis) {
  SweptEnvelope swept;
  swept.kind = HullKind::arm;
  swept.link = made.link;
  swept.axisGroup = made.axisGroup;
  swept.isOnAxis = true;
  swept.point = axis.point;
  swept.direction = axis.direction;
  swept.low = 1e300;
  swept.high = -1e300;
  for (const auto& [low, high] : made.rings) {
    swept.low = std::min(swept.low, low);
    swept.high = std::max(swept.high, high);
  }
  swept.inner = made.inner;
  swept.outer = made.outer;
  return swept;
}

}  // namespace geargraph

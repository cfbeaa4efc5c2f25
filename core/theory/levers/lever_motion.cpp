#include "core/theory/levers/lever_motion.h"

#include "core/foundations/base/contract.h"
#include "core/theory/states/relative_speed.h"

namespace geargraph {

std::vector<Rational> leverSpeeds(const LeverPlan& plan, const Placement& placement,
                                  std::span<const Rational> rates) {
  std::vector<Rational> speeds;
  for (const LinkOrdinal link : plan.links) {
    // All joints towards the ground are on the main axis: at most one component.
    const std::vector<SpeedAbout> about = absoluteSpeed(placement, rates, link);
    GEARGRAPH_REQUIRE(about.size() <= 1);
    speeds.push_back(about.empty() ? Rational(0)
                                   : Rational(directionSign(placement, about[0].axisGroup, plan.mainAxis)) *
                                         about[0].speed);
  }
  return speeds;
}

Rational speedAt(const LeverPlan& plan, const Lever& lever, std::span<const Rational> speeds,
                 const Rational& place) {
  const auto of = [&](const LeverPoint& point) -> const Rational& {
    return speeds[static_cast<std::size_t>(plan.positionOf(point.links.front()))];
  };
  const Rational& first = of(lever.points.front());  // at 0
  return first + place * (of(lever.points.back()) - first);
}

std::vector<Rational> speedsFromBasis(const LeverPlan& plan, std::span<const Rational> speeds) {
  GEARGRAPH_REQUIRE(speeds.size() == plan.basis.size());
  std::vector<Rational> result;
  for (const auto& point : plan.points) {
    Rational& sum = result.emplace_back(0);
    for (std::size_t k = 0; k < speeds.size(); ++k) sum += point[k] * speeds[k];
  }
  return result;
}

}  // namespace geargraph

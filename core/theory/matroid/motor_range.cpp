#include "core/theory/matroid/motor_range.h"

#include <algorithm>
#include <utility>

#include "core/foundations/base/contract.h"
#include "core/theory/matroid/joint_coupling.h"

namespace geargraph {
namespace {

using Corners = std::vector<MotorCorner>;

std::size_t columnOf(const ExactSolution& solution, JointOrdinal motor) {
  const auto found = std::find(solution.inputs.begin(), solution.inputs.end(), int{motor});
  GEARGRAPH_REQUIRE(found != solution.inputs.end());
  return static_cast<std::size_t>(found - solution.inputs.begin());
}

std::vector<MotorLimit> limitsOf(const Mechanism& mechanism, const ExactSolution& solution,
                                 std::array<std::size_t, 2> columns) {
  std::vector<MotorLimit> limits;
  for (const JointOrdinal joint : mechanism.turningJoints.ordinals()) {
    const JointLimits& own = mechanism.turningJoints[joint].limits;
    if (!own.low && !own.high) continue;
    const std::vector<Rational> gains = gainsOf(solution, joint);
    const Rational &x = gains[columns[0]], &y = gains[columns[1]];
    if (x.isZero() && y.isZero()) continue;
    if (own.low) limits.push_back({joint, false, {-x, -y}, -own.low->exact()});
    if (own.high) limits.push_back({joint, true, {x, y}, own.high->exact()});
  }
  return limits;
}

/// How much of the bound is left at a corner; below 0: beyond it.
Rational slackAt(const MotorLimit& limit, const MotorCorner& corner) {
  return limit.bound - limit.gains[0] * corner.x - limit.gains[1] * corner.y;
}

/// The part of a convex polygon that a limit allows (I. E. Sutherland, G. W. Hodgman, CACM 17, 1974, 32-42).
Corners cut(const Corners& corners, const MotorLimit& limit, std::size_t number) {
  Corners kept;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const MotorCorner& from = corners[i];
    const MotorCorner& to = corners[(i + 1) % corners.size()];
    const Rational here = slackAt(limit, from), there = slackAt(limit, to);
    const bool isIn = here.sign() >= 0;
    if (isIn) kept.push_back(from);
    if (here.sign() * there.sign() >= 0) {
      // A corner on the limit's own line, from which the polygon leaves: the side after it is the limit's.
      if (isIn && here.isZero() && there.sign() < 0) kept.back().side = number;
      continue;
    }
    const Rational part = here / (here - there);
    kept.push_back({from.x + part * (to.x - from.x), from.y + part * (to.y - from.y),
                    isIn ? std::optional(number) : from.side});
  }
  // Corners in one place have a side without length between them.
  Corners distinct;
  for (std::size_t i = 0; i < kept.size(); ++i) {
    const MotorCorner& next = kept[(i + 1) % kept.size()];
    if (kept.size() == 1 || kept[i].x != next.x || kept[i].y != next.y) distinct.push_back(kept[i]);
  }
  if (distinct.empty() && !kept.empty()) distinct.push_back(kept.front());
  return distinct;
}

Corners cutOff(const std::vector<MotorLimit>& limits, const Rational& reach) {
  Corners corners{{-reach, -reach, {}}, {reach, -reach, {}}, {reach, reach, {}}, {-reach, reach, {}}};
  for (std::size_t limit = 0; limit < limits.size(); ++limit) corners = cut(corners, limits[limit], limit);
  return corners;
}

void widen(Rational& reach, const Rational& value) {
  if (value.abs() > reach) reach = value.abs();
}

/// Beyond every place where two limits meet, or one meets the line on which the other motor does not turn.
Rational reachOf(const std::vector<MotorLimit>& limits) {
  Rational reach(1);
  for (std::size_t i = 0; i < limits.size(); ++i) {
    const MotorLimit& a = limits[i];
    for (const Rational& gain : a.gains) {
      if (!gain.isZero()) widen(reach, a.bound / gain);
    }
    for (std::size_t j = 0; j < i; ++j) {
      const MotorLimit& b = limits[j];
      const Rational determinant = a.gains[0] * b.gains[1] - a.gains[1] * b.gains[0];
      if (determinant.isZero()) continue;
      widen(reach, (a.bound * b.gains[1] - b.bound * a.gains[1]) / determinant);
      widen(reach, (a.gains[0] * b.bound - b.gains[0] * a.bound) / determinant);
    }
  }
  return Rational(2) * reach;
}

/// As far as an open range is worth showing: beyond its own corners and where its sides pass the reference
/// pose.
Rational shownReach(const MotorRange& range) {
  Rational reach(180);
  for (std::size_t i = 0; i < range.corners.size(); ++i) {
    const MotorCorner& corner = range.corners[i];
    if (!corner.side) continue;
    const MotorLimit& limit = range.limits[*corner.side];
    const Rational steepest = std::max(limit.gains[0].abs(), limit.gains[1].abs());
    widen(reach, limit.bound / steepest);
    if (!range.corners[(i + range.corners.size() - 1) % range.corners.size()].side) continue;
    widen(reach, corner.x);
    widen(reach, corner.y);
  }
  return Rational(3, 2) * reach;
}

}  // namespace

bool MotorRange::isClosed() const {
  return std::all_of(corners.begin(), corners.end(),
                     [](const MotorCorner& corner) { return corner.side.has_value(); });
}

std::optional<MotorRange> motorRange(const Mechanism& mechanism, const ExactSolution& solution,
                                     JointOrdinal xMotor, JointOrdinal yMotor) {
  GEARGRAPH_REQUIRE(int{xMotor} != int{yMotor});
  MotorRange range;
  range.motors = {xMotor, yMotor};
  range.limits = limitsOf(mechanism, solution, {columnOf(solution, xMotor), columnOf(solution, yMotor)});
  if (range.limits.size() > MotorRange::kMaxLimits) return std::nullopt;
  range.corners = cutOff(range.limits, reachOf(range.limits));
  if (!range.isClosed()) range.corners = cutOff(range.limits, shownReach(range));
  return range;
}

}  // namespace geargraph

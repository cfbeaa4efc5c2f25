#include "core/theory/statics/locking_limits.h"

#include <algorithm>

namespace geargraph::inline statics {
namespace {

constexpr int kPoints = 17;
constexpr double kPrecision = 1e-5;

using IsLocked = bool EfficiencyPoint::*;
using Points = std::vector<EfficiencyPoint>;

/// From the last locked point to the free one behind it; none where no point is locked.
std::optional<CurveRange> bracketIn(const Points& points, IsLocked isLocked) {
  for (std::size_t i = points.size(); i-- > 1;)
    if (points[i - 1].*isLocked && !(points[i].*isLocked))
      return CurveRange{points[i - 1].at, points[i].at, kPoints};
  return std::nullopt;
}

}  // namespace

std::optional<LockingLimits> lockingLimits(const Mechanism& mechanism, const KinematicModel& model,
                                           const Placement& placement, const MatroidAnalysis& analysis,
                                           const StaticsReport& report, const StaticsOptions& options,
                                           const std::stop_token& stop) {
  const auto points = [&](const CurveRange& range) -> std::optional<Points> {
    auto curve = efficiencyCurve(mechanism, model, placement, analysis, report, options,
                                 CurveAxis::meshEfficiency, range, stop);
    return curve ? std::optional(std::move(curve->points)) : std::nullopt;
  };
  const auto coarse = points({Rational(1, 100), Rational(1), kPoints});
  if (!coarse) return std::nullopt;
  LockingLimits limits;
  for (const auto& [isLocked, limit] : {std::pair(&EfficiencyPoint::isLocked, &limits.forward),
                                        std::pair(&EfficiencyPoint::isLockedBackward, &limits.backward)}) {
    std::optional<CurveRange> bracket = bracketIn(*coarse, isLocked);
    while (bracket && (bracket->to - bracket->from).toDouble() > kPrecision) {
      const auto finer = points(*bracket);
      if (!finer) return std::nullopt;
      bracket = bracketIn(*finer, isLocked);
    }
    if (bracket) *limit = ((bracket->from + bracket->to) / 2).toDouble();
  }
  return limits;
}

}  // namespace geargraph::inline statics

#pragma once

#include "core/theory/statics/statics_report.h"

namespace geargraph {

/// The variable of an efficiency curve.
enum class CurveAxis {
  speedRatio,     ///< speed of the second input over that of the first; of trains with two inputs
  meshEfficiency  ///< one efficiency for all meshes, instead of their own
};

struct CurveRange {
  Rational from;
  Rational to;
  int points = 2;  ///< at least 2, evenly spaced, with both ends
};

/// One point of the curve. The efficiencies are empty where no power is fed (a motion at rest), or it is
/// undecided which gears drive.
struct EfficiencyPoint {
  Rational at;  ///< the value of the variable
  std::optional<double> forward;
  std::optional<double> backward;  ///< all known torques reversed
  bool isLocked = false;           ///< forward: no torque of the balances moves the loads
  bool isLockedBackward = false;
  std::vector<double> torques;  ///< of the balances of a forward solution, N m, as in EfficiencyCurve::held
};

struct EfficiencyCurve {
  CurveAxis axis = CurveAxis::meshEfficiency;
  std::vector<int> inputs;  ///< joints; the two whose ratio is followed first
  std::vector<int> held;    ///< positions in StaticsReport::held: balances whose torques are determined
  std::vector<EfficiencyPoint> points;
};

/// The variables for which a solved problem has a curve, the more informative one first: the ratio of speeds
/// needs two inputs, no state, and losses; both need loads in equilibrium, a motion, and no load sharing
/// decided by stiffness.
[[nodiscard]] std::vector<CurveAxis> curveAxes(const MatroidAnalysis& analysis, const StaticsReport& report,
                                               const StaticsOptions& options);
/// The default range: -2 to 2 for the speed ratio, 0.5 to 1 for the efficiency.
[[nodiscard]] CurveRange usualRange(CurveAxis axis);

/// Efficiencies and torques of balances over a variable; the loads stay as they are. std::nullopt if `stop`
/// was requested. Cost: a few exact eliminations per point.
/// @pre all of one mechanism; the axis is one of curveAxes(), `options` are those of the report
[[nodiscard]] std::optional<EfficiencyCurve> efficiencyCurve(
    const Mechanism& mechanism, const KinematicModel& model, const Placement& placement,
    const MatroidAnalysis& analysis, const StaticsReport& report, const StaticsOptions& options,
    CurveAxis axis, const CurveRange& range, const std::stop_token& stop = {});

}  // namespace geargraph

#pragma once

#include "core/theory/statics/statics_report.h"

namespace geargraph::inline statics {

/// What an efficiency is followed over.
enum class CurveAxis {
  speedRatio,     ///< speed of the second input over that of the first; of trains with two inputs
  meshEfficiency  ///< one efficiency of all meshes, whatever they state
};

struct CurveRange {
  Rational from;
  Rational to;
  int points = 2;  ///< at least 2, evenly spaced, with both ends
};

/// The train at one place of the curve. Nothing has a value where nothing is fed (a motion at rest), or the
/// drivers are not decided.
struct EfficiencyPoint {
  Rational at;
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

/// The axes that a solved problem can be followed over, the more telling one first: the ratio of speeds needs
/// two inputs, no state and losses; both need loads in balance, a motion, and no shares that stiffness
/// decides.
[[nodiscard]] std::vector<CurveAxis> curveAxes(const MatroidAnalysis& analysis, const StaticsReport& report,
                                               const StaticsOptions& options);
/// What is shown of an axis where nothing else is wanted: -2 to 2 for speeds, 0.5 to 1 for efficiencies.
[[nodiscard]] CurveRange usualRange(CurveAxis axis);

/// Efficiency and torques of balances along an axis; the loads stay as they are. Nothing where `stop` was
/// requested. Cost: a few exact eliminations a point.
/// @pre all of one mechanism; the axis is one of curveAxes(), `options` are those of the report
[[nodiscard]] std::optional<EfficiencyCurve> efficiencyCurve(
    const Mechanism& mechanism, const KinematicModel& model, const Placement& placement,
    const MatroidAnalysis& analysis, const StaticsReport& report, const StaticsOptions& options,
    CurveAxis axis, const CurveRange& range, const std::stop_token& stop = {});

}  // namespace geargraph::inline statics

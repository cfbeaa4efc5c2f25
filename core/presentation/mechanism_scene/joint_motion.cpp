#include "core/presentation/mechanism_scene/joint_motion.h"

#include <numbers>

#include "core/foundations/base/contract.h"
#include "core/theory/matroid/exact_solution.h"
#include "core/theory/pose/period.h"

namespace geargraph {
namespace {

/// Joints times inputs up to which fractions are worth their time: they are needed for the period only.
constexpr std::size_t kMaxExactGains = 20'000;

double periodOf(const Mechanism& mechanism, const KinematicModel& model, const MatroidAnalysis& analysis,
                const std::stop_token& stop) {
  // What slides does not come back.
  if (analysis.solution) {
    const ByJoint<double>& rates = analysis.solution->rates;
    for (std::size_t joint = 0; joint < rates.size(); ++joint)
      if (rates[joint] != 0 && slides(mechanism.turningJoints[joint])) return 0;
  }
  const auto exact = solveExact(model, analysis.choice.joints, analysis.speeds, stop);
  const auto turns = exact ? commonPeriod(exact->rates) : std::nullopt;
  return turns ? 2 * std::numbers::pi * turns->toDouble() : 0;
}

}  // namespace

void JointMotion::angles(std::span<const double> inputAngles, std::span<double> jointAngles) const {
  GEARGRAPH_REQUIRE(inputAngles.size() == inputs.size() &&
                    jointAngles.size() * inputs.size() == gains.size());
  for (std::size_t joint = 0; joint < jointAngles.size(); ++joint) {
    double angle = 0;
    for (std::size_t k = 0; k < inputs.size(); ++k)
      angle += gains[joint * inputs.size() + k] * inputAngles[k];
    jointAngles[joint] = angle;
  }
}

std::optional<JointMotion> jointMotion(const AnalysisSnapshot& snapshot, const std::stop_token& stop) {
  const MatroidAnalysis* analysis = snapshot.matroid();
  if (analysis == nullptr || !analysis->solution) return std::nullopt;
  const LiveSolution& solution = *analysis->solution;
  const std::size_t columns = solution.inputs.size(), joints = static_cast<std::size_t>(snapshot.graph->t());
  if (columns == 0 || solution.matrix.size() != solution.outputs.size() * columns) return std::nullopt;

  JointMotion motion;
  motion.inputs = solution.inputs;
  for (const Rational& speed : analysis->speeds) motion.speeds.push_back(speed.toDouble());
  motion.gains.assign(joints * columns, 0);
  for (std::size_t k = 0; k < columns; ++k) {
    motion.gains[static_cast<std::size_t>(motion.inputs[k]) * columns + k] = 1;
    for (std::size_t row = 0; row < solution.outputs.size(); ++row) {
      const auto output = static_cast<std::size_t>(solution.outputs[row]);
      motion.gains[output * columns + k] = solution.matrix[row * columns + k];
    }
  }
  if (motion.gains.size() <= kMaxExactGains)
    motion.period = periodOf(*snapshot.mechanism, *snapshot.kinematics->model, *analysis, stop);
  return motion;
}

}  // namespace geargraph

#include "core/presentation/export_api/input_pose.h"

#include <numbers>

#include "core/theory/pose/angle.h"
#include "core/theory/pose/forward_kinematics.h"
#include "core/theory/pose/joint_limits.h"
#include "core/theory/pose/turning_lines.h"

namespace geargraph {
InputAngles restingInputs(const AnalysisSnapshot& snapshot) {
  const std::vector<Rational> zeros(snapshot.matroid()->choice.joints.size());
  return {zeros, zeros};
}

std::optional<InputPose> poseOfInputs(const AnalysisSnapshot& snapshot, const InputAngles& inputs,
                                      const std::stop_token& stop) {
  const KinematicModel& model = *snapshot.kinematics->model;
  const std::vector<int>& joints = snapshot.matroid()->choice.joints;
  const auto inDegrees = solveExact(model, joints, inputs.degrees, stop);
  const auto inRadians = solveExact(model, joints, inputs.radians, stop);
  if (!inDegrees || !inRadians) return std::nullopt;
  InputPose pose;
  pose.angles.resize(static_cast<std::size_t>(model.t()));
  ByJoint<double> reduced;  // only where links are does not depend on whole turns
  reduced.resize(pose.angles.size());
  for (std::size_t joint = 0; joint < pose.angles.size(); ++joint) {
    const Rational turns = inDegrees->rates[joint] / 360;
    const Rational& radians = inRadians->rates[joint];
    reduced[joint] = reducedAngle(turns, radians);
    pose.angles[joint] = turns.toDouble() * 2 * std::numbers::pi + radians.toDouble();
  }
  pose.links =
      ForwardKinematics(*snapshot.tree, turningLines(snapshot.kinematics->placement())).poses(reduced);
  pose.beyondLimits = jointsBeyondLimits(angleLimits(*snapshot.mechanism), pose.angles);
  return pose;
}

}  // namespace geargraph

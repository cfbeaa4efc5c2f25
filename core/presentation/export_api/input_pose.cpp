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
  InputPose pose;
  pose.angles.resize(static_cast<std::size_t>(model.t()));
  ByJoint<double> reduced;  // only where links are does not depend on whole turns
  reduced.resize(pose.angles.size());
  if (model.hasPi()) {
    const auto inDegrees = solvePi(model, joints, inputs.degrees, stop);
    const auto inRadians = solvePi(model, joints, inputs.radians, stop);
    if (!inDegrees || !inRadians) return std::nullopt;
    for (JointOrdinal joint = 0; joint < model.t(); ++joint) {
      const PiNumber angle =
          inDegrees->rates[joint] * PiNumber(Rational(1, 180), 1) + inRadians->rates[joint];
      pose.angles[joint] = reduced[joint] = angle.toDouble();
    }
  } else {
    const auto inDegrees = solveExact(model, joints, inputs.degrees, stop);
    const auto inRadians = solveExact(model, joints, inputs.radians, stop);
    if (!inDegrees || !inRadians) return std::nullopt;
    for (JointOrdinal joint = 0; joint < model.t(); ++joint) {
      const Rational turns = inDegrees->rates[joint] / 360;
      const Rational& radians = inRadians->rates[joint];
      pose.angles[joint] = turns.toDouble() * 2 * std::numbers::pi + radians.toDouble();
      const bool isSlide = slides(snapshot.mechanism->turningJoints[joint]);
      reduced[joint] = isSlide ? pose.angles[joint] : reducedAngle(turns, radians);
    }
  }
  pose.links =
      ForwardKinematics(*snapshot.tree, turningLines(snapshot.kinematics->placement())).poses(reduced);
  pose.beyondLimits = jointsBeyondLimits(angleLimits(*snapshot.mechanism), pose.angles);
  return pose;
}

}  // namespace geargraph

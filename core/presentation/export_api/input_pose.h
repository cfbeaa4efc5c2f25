#pragma once

#include <Eigen/Geometry>
#include <optional>
#include <stop_token>
#include <vector>

#include "core/theory/analysis/analysis.h"

namespace geargraph {

/// Angles of the inputs, by the solution's columns; an angle is the sum of its degrees and its radians.
/// Exact, so that any number of whole turns is subtracted without loss. A travel of an input that slides, in
/// the document's unit, stands among the radians.
struct InputAngles {
  std::vector<Rational> degrees;
  std::vector<Rational> radians;
};

/// The pose of a mechanism for given angles of its inputs.
struct InputPose {
  /// rad, with all turns; infinite beyond the range of doubles. Of sliding joints travels.
  ByJoint<double> angles;
  ByLink<Eigen::Isometry3d> links;  ///< displacement from the reference pose, base frame
  std::vector<int> beyondLimits;    ///< joints whose angles are beyond their limits
};

/// All angles 0. @pre the snapshot has a matroid analysis
[[nodiscard]] InputAngles restingInputs(const AnalysisSnapshot& snapshot);

/// theta = K theta_E, the relation of the rates [AU, Eq. (23)], which the angles obey from the reference pose
/// on. std::nullopt if `stop` was requested. Cost: two exact solutions.
/// @pre the snapshot has a valid solution; an angle of each kind for each input
[[nodiscard]] std::optional<InputPose> poseOfInputs(const AnalysisSnapshot& snapshot,
                                                    const InputAngles& inputs,
                                                    const std::stop_token& stop = {});

}  // namespace geargraph

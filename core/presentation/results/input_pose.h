#pragma once

#include <Eigen/Geometry>
#include <optional>
#include <stop_token>
#include <vector>

#include "core/theory/analysis/analysis.h"

namespace geargraph::inline results {

/// Angles of the inputs, by their place in the solution's columns; those in degrees and those in radians add
/// up. Exact, so that whole turns of any number are taken off without loss.
struct InputAngles {
  std::vector<Rational> degrees;
  std::vector<Rational> radians;
};

/// Where a mechanism is for given angles of its inputs.
struct InputPose {
  std::vector<double> angles;            ///< by joint, rad, above -pi, to pi
  std::vector<double> wholeAngles;       ///< by joint, rad, with all turns, which limits count
  std::vector<Eigen::Isometry3d> links;  ///< by link: displacement from the reference pose, base frame
  std::vector<int> beyondLimits;         ///< joints whose whole angles are beyond their limits
};

/// All angles 0. @pre the snapshot has a matroid analysis
[[nodiscard]] InputAngles restingInputs(const AnalysisSnapshot& snapshot);

/// theta = K theta_E, the relation of the rates [AU, Eq. (23)], which the angles obey from the reference pose
/// on. Nothing where `stop` was requested. Cost: two exact solutions.
/// @pre the snapshot has a valid solution; an angle of each kind for each input
[[nodiscard]] std::optional<InputPose> poseOfInputs(const AnalysisSnapshot& snapshot,
                                                    const InputAngles& inputs,
                                                    const std::stop_token& stop = {});

}  // namespace geargraph::inline results

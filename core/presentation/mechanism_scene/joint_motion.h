#pragma once

#include <optional>
#include <span>
#include <vector>

#include "core/theory/analysis/analysis.h"

namespace geargraph {

/// The motion of all joints with the inputs: theta = K theta_E, exact for any number of turns because K is
/// constant.
struct JointMotion {
  std::vector<int> inputs;     ///< joints, in column order
  std::vector<double> speeds;  ///< rad/s, one per input
  std::vector<double> gains;   ///< K row by row: joints x inputs; the rows of inputs are unit rows
  double period = 0;           ///< of all joints, s; 0 if nothing turns, or it is not known

  /// Computes the angle of every joint, rad. @pre one angle per input, one element per joint
  void angles(std::span<const double> inputAngles, std::span<double> jointAngles) const;
};

/// From the live solution, for its inputs. std::nullopt if they are not valid, nothing can move, or a mesh
/// has no geometry.
/// Cost: O(joints * inputs) and, for mechanisms of up to some hundred links, an exact solution for the
/// period.
[[nodiscard]] std::optional<JointMotion> jointMotion(const AnalysisSnapshot& snapshot,
                                                     const std::stop_token& stop = {});

}  // namespace geargraph

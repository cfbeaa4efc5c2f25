#pragma once

#include <Eigen/Geometry>
#include <vector>

#include "core/presentation/meshfile/mesh_scene.h"

namespace geargraph {

/// Keys of a node that rests at `rest` and turns uniformly about `axis` (unit, in the parent's frame, through
/// the node's origin) by `quarters` quarter turns in `seconds`: one at each quarter, so that slerp between
/// them is exact. Angles are reduced before rounding, so after a whole number of turns the last rotation
/// equals the first one bit by bit (its quaternion may have the opposite sign). At least two keys.
[[nodiscard]] std::vector<RotationKey> uniformTurn(const Eigen::Vector3d& axis,
                                                   const Eigen::Quaterniond& rest, long long quarters,
                                                   double seconds);

/// The same at `rate` rad/s, not 0, for `seconds` of time, which need not be whole quarters: one key at each
/// quarter, and one at the end. @pre seconds > 0
[[nodiscard]] std::vector<RotationKey> turnFor(const Eigen::Vector3d& axis, const Eigen::Quaterniond& rest,
                                               double rate, double seconds);

/// The keys of a motion at `rate` rad/s, not 0, from time 0 to `to`, back to `from` and on to 0: it starts
/// and ends at `rest` and takes 2 (to - from). @pre from <= 0 <= to, not both 0
[[nodiscard]] std::vector<RotationKey> thereAndBack(const Eigen::Vector3d& axis,
                                                    const Eigen::Quaterniond& rest, double rate, double from,
                                                    double to);

}  // namespace geargraph

#pragma once

#include <Eigen/Geometry>

#include "core/machine/solids/solid.h"

namespace geargraph {

/// Mass, centre and inertia of a body, in consistent units: mass in density times length cubed, and so on.
struct MassProperties {
  double mass = 0;
  Eigen::Vector3d center{0, 0, 0};                    ///< of mass
  Eigen::Matrix3d inertia = Eigen::Matrix3d::Zero();  ///< about the centre of mass
};

/// The properties of the homogeneous body that a closed mesh bounds. Where shells of one solid overlap, the
/// overlap counts twice. Integrated over the tetrahedra between the triangles and a point near them.
/// Cost: O(triangles).
[[nodiscard]] MassProperties massProperties(const Solid& solid, double density);

/// Two bodies as one rigid body, by the parallel axis theorem.
[[nodiscard]] MassProperties joined(const MassProperties& a, const MassProperties& b);
/// The body displaced by `placed`.
[[nodiscard]] MassProperties moved(const MassProperties& body, const Eigen::Isometry3d& placed);
/// The body in another unit of length; `factor` new units make one old unit. The mass value stays.
[[nodiscard]] MassProperties rescaled(const MassProperties& body, double factor);

}  // namespace geargraph

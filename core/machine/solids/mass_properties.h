#pragma once

#include <Eigen/Geometry>

#include "core/machine/solids/solid.h"

namespace geargraph::inline solids {

/// Mass of a body, and how it is spread. Any consistent units: density times length to the third, and so on.
struct MassProperties {
  double mass = 0;
  Eigen::Vector3d center{0, 0, 0};                    ///< of mass
  Eigen::Matrix3d inertia = Eigen::Matrix3d::Zero();  ///< about the centre of mass
};

/// The properties of the homogeneous body that a closed mesh bounds. Where shells of one solid overlap, the
/// overlap counts twice. Identity: integrals over the tetrahedra between the triangles and a point near them.
/// Cost: O(triangles).
[[nodiscard]] MassProperties massProperties(const Solid& solid, double density);

/// Two bodies as one rigid body, by the parallel axis theorem.
[[nodiscard]] MassProperties joined(const MassProperties& a, const MassProperties& b);
/// The body at another place.
[[nodiscard]] MassProperties moved(const MassProperties& body, const Eigen::Isometry3d& placed);
/// The body in another unit of length, `factor` of which make one of the old unit; the mass stays.
[[nodiscard]] MassProperties rescaled(const MassProperties& body, double factor);

}  // namespace geargraph::inline solids

#pragma once

#include "core/mechanism/placement/crossing.h"

namespace geargraph {

/// A hypoid pair: two cones on skew axes that touch in the pitch point P. The pitch plane there is spanned by
/// the velocities of both gears, r_A = u_A x (P - p_A) and r_B; the gears slide along their teeth, so that
///
///     t = N_j r_A - s N_i r_B,    n in the plane, across t:    n . r_A : n . r_B = s N_i : N_j
///
/// for any P: the ratio is that of the teeth. The radii alone allow both signs; s is minus the product of the
/// half axes, seen from the feet of the common perpendicular, on which P lies, as for a bevel pair.
///
/// A pitch point that follows: with the gear's axis z and the pinion's axis parallel to x at the offset E,
/// the gear's radius R = m z / 2 and q = z_1 / z_2,
///
///     P = (R cos h, R sin h, +-R q),   sin h = E / (R (1 + q^2))
///
/// which gives the gear the cone of the bevel pair with the same teeth. Axes at other angles need a stated
/// one.
///
/// Sets pitch point, normal, radii, spiral angles (MeshGeometry::tailHelix), sign and kind. False with
/// pitch-geometry where the axes are parallel, meet, or cross at another angle, or the pitch point is on or
/// beside an axis; with teeth-geometry where the offset is too large for the gear.
/// @pre as placeCrossing()
[[nodiscard]] bool placeHypoid(const Mechanism& mechanism, MeshOrdinal mesh, const GearPair<double>& pair,
                               LinePosition position, const SkewChoice& choice, MeshGeometry& geometry,
                               Diagnostics& diagnostics);

/// The pitch cone of one gear: its apex and the half axis from there towards the gear, relative to the point
/// of the tail's line, and the angle between half axis and cone.
struct OffsetCone {
  Vector3 apex{};
  Vector3 axis{};
  double angle = 0;
};

/// The cones of both gears, which have the pitch plane as common tangent plane. @pre a hypoid's geometry
struct OffsetCones {
  OffsetCone tail;
  OffsetCone head;
};
[[nodiscard]] OffsetCones offsetCones(const MeshGeometry& geometry, const Vector3& tailDirection,
                                      const Vector3& headDirection);

}  // namespace geargraph

#pragma once

#include "core/foundations/base/diagnostic.h"
#include "core/mechanism/model/mechanism.h"
#include "core/mechanism/placement/mesh_geometry.h"

namespace geargraph {

/// The line of action of a pair whose wheels do not touch (PairKind::touches): a strand from the one pulley
/// to the other, or the line along which a pin pushes its hole. With r the radii at which it passes the axes
/// (PairRule::radii), rho_i = r_i, rho_j = r_j, or -r_j where the belt is crossed, and d the way from axis to
/// axis, square to them:
///
///     n = u x nu,  d . nu = rho_i - rho_j,  n . d > 0       n . r_A = rho_i,  n . (u x (P - p_B)) = rho_j
///
/// Sets pitch point (the middle of the strand), normal, radii, sign and kind. False with pitch-geometry where
/// the axes are not parallel or one line, with teeth-geometry/belt where the pulleys have no room.
/// `level`: a point of the plane in which the strand lies.
/// @pre as checkGeometry(), and the kind is known
[[nodiscard]] bool placeStrand(const Mechanism& mechanism, MeshOrdinal mesh, const GearPair<double>& pair,
                               LinePosition position, const Vector3& level, MeshGeometry& geometry,
                               Diagnostics& diagnostics);

}  // namespace geargraph

#pragma once

#include <optional>
#include <string>
#include <variant>

#include "core/foundations/base/diagnostic.h"
#include "core/mechanism/model/mechanism.h"
#include "core/mechanism/placement/mesh_geometry.h"

namespace geargraph {

/// Where two skew axes are, as a pair of gears sees it.
struct CrossedAxes {
  double distance = 0;
  /// Sigma: from the tail's direction to the head's about the common perpendicular, which points from the
  /// tail's axis to the head's; rad, in (-pi, pi].
  double angle = 0;
  /// Of a stated pitch point, which lies on that perpendicular: how far from the tail's axis.
  std::optional<double> tailReach;
};

/// The wheels of a pair on skew axes: helix angles at the cylinders that touch in the pitch point (rad,
/// positive right-hand) and the radii of these.
struct CrossedWheels {
  double tailHelix = 0;
  double headHelix = 0;
  double tailRadius = 0;
  double headRadius = 0;
};

/// Why no such wheels exist, as the end of a sentence about the mesh.
struct CrossedProblem {
  Detail detail = Detail::helixAgainstTeeth;
  std::string message;
};

/// What the document leaves open of a pair on skew axes.
struct SkewChoice {
  BevelSides sides;   ///< hypoid: the half axes, from the feet of the common perpendicular
  double module = 0;  ///< hypoid: of the gear
};

using SkewPlacer = bool (*)(const Mechanism& mechanism, MeshOrdinal mesh, const GearPair<double>& pair,
                            LinePosition position, const SkewChoice& choice, MeshGeometry& geometry,
                            Diagnostics& diagnostics);

using CrossedRule = std::variant<CrossedWheels, CrossedProblem> (*)(const GearMesh& mesh,
                                                                    const CrossedAxes& axes);

/// Two helical gears. Their traces coincide in the pitch point: beta_j = -Sigma - beta_i (mod 180 degrees, in
/// (-90, 90)); r = m_n z / (2 cos beta), and both radii are the distance. Without helix angle and hand both
/// angles are equal, half the acute crossing angle, right-hand at 90 degrees. A stated pitch point gives the
/// radii, and with them the helix angle that r_i cos(beta_i) : r_j cos(beta_j) = z_i : z_j asks for: of two,
/// that of the stated hand, else the smaller one.
[[nodiscard]] std::variant<CrossedWheels, CrossedProblem> crossedHelicalWheels(const GearMesh& mesh,
                                                                               const CrossedAxes& axes);
/// A worm and its wheel, of one hand: the wheel has radius m z_2 / 2, the worm the rest of the distance,
/// tan g = z_1 m / d_1. Without module or pitch point: d_1 = 10 m.
[[nodiscard]] std::variant<CrossedWheels, CrossedProblem> wormWheels(const GearMesh& mesh,
                                                                     const CrossedAxes& axes);

/// The tangent of a worm's lead angle, z_1 / q, where the document makes it rational: without module and
/// pitch point z_1 / 10, else z_1 m / (2 a - m z_2) with a rational distance a of the axes. std::nullopt of
/// other kinds.
[[nodiscard]] std::optional<Rational> exactLeadTangent(const GearMesh& mesh, const ExactVector3& tailPoint,
                                                       const ExactVector3& tailDirection,
                                                       const ExactVector3& headPoint,
                                                       const ExactVector3& headDirection);

/// The line of action of a pair on skew axes. With N the common perpendicular from tail to head, e = u x N
/// and the trace t = cos(beta) u + sin(beta) e of the teeth in the pitch point,
///
///     n = cos(beta_i) e_i - sin(beta_i) u_i,     n . r_A = r_i cos(beta_i),  |n . r_B| = r_j cos(beta_j)
///
/// (the pressure angle adds a part along N, which meets both axes and has no moment about them). Sets pitch
/// point, normal, radii, helices, sign and kind. False with pitch-geometry where the axes are parallel, meet
/// or cross at an angle that the kind has no wheels for, or where a stated pitch point is off their common
/// perpendicular; with teeth-geometry where teeth, module, helix and distance contradict each other.
/// @pre as checkGeometry(), and the kind is known and one for skew axes
[[nodiscard]] bool placeCrossing(const Mechanism& mechanism, MeshOrdinal mesh, const GearPair<double>& pair,
                                 LinePosition position, const SkewChoice& choice, MeshGeometry& geometry,
                                 Diagnostics& diagnostics);

}  // namespace geargraph

#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

#include "core/machine/teeth/gear_spec.h"

namespace geargraph {

/// A toothed wheel for the phase calculation, in the frame of the carrier of the mesh (in the reference pose:
/// the base frame).
struct PhaseWheel {
  Eigen::Vector3d centre;  ///< any point of the axis; of a helical wheel: mid face
  Eigen::Vector3d axis;    ///< unit, the +z of the gear's own frame; bevel: from the apex to the gear
  Eigen::Vector3d mark;    ///< unit, normal to the axis: direction of tooth 0 at angle 0
  int teeth = 1;
  double twist = 0;          ///< helical: tan(b) / r, by which sections turn along the axis, rad per length
  bool herringbone = false;  ///< `twist` is that of the half below mid face, the other half mirrors it
};

/// Two wheels, by position, and the point at which their pitch surfaces touch.
struct PhaseMesh {
  int a = 0;
  int b = 0;
  Eigen::Vector3d pitchPoint;
  Eigen::Vector3d toothNormal = Eigen::Vector3d::Zero();  ///< as of meshPhase()
};

/// How the teeth of a pair pass their pitch point.
struct MeshPhase {
  /// Angle of the pitch point about a's axis, from a's mark, less the twist of the section there, rad.
  double psiA = 0;
  double psiB = 0;
  int sign = 1;  ///< teeth of a and b pass the point the same way for equal (+1) or opposite (-1) turns
};

/// The wheel of a spec at a place: mid face or apex, axis, direction of tooth 0.
[[nodiscard]] PhaseWheel phaseWheelOf(const GearSpec& spec, const Eigen::Vector3d& centre,
                                      const Eigen::Vector3d& axis, const Eigen::Vector3d& mark);

/// The normal of a wheel's teeth in the pitch plane at the pitch point, which points as its teeth move in
/// positive turns, of length 1: k x u where the teeth are straight, else that less its part along the helix.
/// On crossed axes the teeth of both wheels have it in common, but for its sign.
[[nodiscard]] Eigen::Vector3d pitchPlaneNormal(const PhaseWheel& wheel, const Eigen::Vector3d& pitchPoint);

/// The geometry of README.md, section 4: u radial towards the pitch point, n the common tooth normal in the
/// pitch plane, sign = sig_a sig_b with sig_i = sign((k_i x u_i) . n), for all pairs alike.
/// `toothNormal` is n, of either sign; where it is zero, n = pitchPlaneNormal(a).
///
/// Identity: z_a w_a = sign z_b w_b for the speeds relative to the carrier, so that phase and kinematics are
/// consistent.
[[nodiscard]] MeshPhase meshPhase(const PhaseWheel& a, const PhaseWheel& b, const Eigen::Vector3d& pitchPoint,
                                  const Eigen::Vector3d& toothNormal = Eigen::Vector3d::Zero());

/// The phase error of the wheels turned by these angles (rad), in pitches, in (-1/2, 1/2]; 0 where a tooth is
/// centred in a space: z_a (angleA - psi_a) - sign z_b (angleB - psi_b) = pi (mod 2 pi) is 0.
[[nodiscard]] double phaseError(const MeshPhase& phase, const PhaseWheel& a, double angleA,
                                const PhaseWheel& b, double angleB);

/// The angle of b nearest 0, rad, at which it meshes with a at angleA.
[[nodiscard]] double meshingAngle(const MeshPhase& phase, const PhaseWheel& a, double angleA,
                                  const PhaseWheel& b);

struct PhaseSolution {
  std::vector<double> angles;     ///< by wheel
  std::vector<double> residuals;  ///< by mesh, in pitches; 0 except for meshes that close a loop
  std::vector<bool> closing;      ///< by mesh: the angles of both wheels already followed from other meshes
};

/// Angles at which the teeth of all meshes are centred in the spaces, as far as loops allow: a spanning
/// forest of the meshes in their order, each tree with its first wheel at angle 0, or, where a loop is
/// locked, at the angle at which that loop's teeth fit. The phase errors of the other meshes are their
/// residuals; the set can be assembled as drawn if and only if all are 0. Cost: O(wheels + meshes).
[[nodiscard]] PhaseSolution solvePhases(std::span<const PhaseWheel> wheels,
                                        std::span<const PhaseMesh> meshes);

/// The tolerance of a residual, in pitches, for a set that can be assembled: coordinates are rounded
/// decimals.
constexpr double kPhaseFits = 1e-3;

}  // namespace geargraph

#pragma once

#include <vector>

#include "core/machine/teeth/gear_spec.h"
#include "core/machine/teeth/half_tooth.h"

namespace geargraph {

/// The innermost radius of a face gear's teeth: where the line of action stands square to its pitch plane,
/// cos(a_X) = r cos(a) / X, and a little outside of it. A length.
[[nodiscard]] double faceInner(const GearSpec& spec);
/// Where the tips end in a land of `kNarrowestLand` modules. A length. Cost: some thousand steps of FaceCut.
[[nodiscard]] double faceOuter(const GearSpec& spec);
/// From faceInner() to faceOuter().
[[nodiscard]] double usualFaceGearFace(const GearSpec& spec);

/// The space that the pinion cuts into a face gear (README.md, section 2c). Lengths in modules.
class FaceCut {
 public:
  /// @pre kind faceGear, with `mateTeeth`
  explicit FaceCut(const GearSpec& spec);

  /// How far a space reaches from its middle at the radius `rho` and the distance `depth` from the pinion's
  /// axis, rad.
  [[nodiscard]] double halfSpace(double rho, double depth) const;
  /// Half a tooth at this radius and depth, rad.
  [[nodiscard]] double halfTooth(double rho, double depth) const;
  [[nodiscard]] double tipDepth() const { return m_tip; }    ///< distance of the tips from the pinion's axis
  [[nodiscard]] double rootDepth() const { return m_root; }  ///< of the roots
  [[nodiscard]] double axisHeight() const { return m_cutter.teeth / 2.0; }  ///< of the pitch plane

 private:
  /// Angle of the cutter's flank from the middle of its tooth.
  [[nodiscard]] double flankAt(double radius) const;

  GearSpec m_cutter;
  HalfTooth m_tooth;
  double m_share;      ///< z_1 / z_2
  double m_halfPitch;  ///< pi / z_2
  double m_tip;
  double m_root;
};

/// The tooth of the rack that a face gear is at its pitch radius, as that of a wheel of so many teeth: for
/// diagnostics. @pre kind faceGear
[[nodiscard]] HalfTooth faceTooth(const GearSpec& spec, double tolerance);

/// Contact ratio at the pitch radius of the face gear `a`, where it is a rack, with its pinion.
[[nodiscard]] double faceContactRatio(const GearSpec& a, const HalfTooth& toothA, const GearSpec& b,
                                      const HalfTooth& toothB, double distance);

}  // namespace geargraph

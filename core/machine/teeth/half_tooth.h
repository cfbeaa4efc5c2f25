#pragma once

#include <vector>

#include "core/machine/teeth/gear_spec.h"

namespace geargraph::inline teeth {

/// A point of a tooth's outline. `rad` is the distance from the axis in modules (plane), or the colatitude
/// from the gear's axis in radians (sphere, bevels); `gam` the angle about the axis from the tooth's centre
/// line. The normal points out of the material: its parts along growing rad and along growing gam, of length
/// 1 together.
struct ProfilePoint {
  double rad = 0;
  double gam = 0;
  double normalRad = 0;
  double normalGam = 0;
};

/// Half a tooth, from the middle of the space (gam = pi/z, root) to the middle of the tip (gam = 0).
/// The other half is its mirror image. A corner is there twice, once with the normal of each side.
struct HalfTooth {
  std::vector<ProfilePoint> points;
  double rootRad = 0;
  double formRad = 0;       ///< where the flank begins, above fillet or undercut
  double tipRad = 0;        ///< after shortening of a pointed tooth
  double tipHalfAngle = 0;  ///< gam at the tip corner
  bool undercut = false;    ///< the rack's tip cut away flank that the involute would need
  bool shortened = false;   ///< the tip was lowered so that a land of 0.2 modules remains
};

/// Narrowest land that a tip may have, in modules.
constexpr double kNarrowestLand = 0.2;

/// Tooth that the ISO 53 rack cuts in the plane: involute, trochoid of the rack's rounded tip, and where the
/// two cross (undercut) the exact corner. Sampled so that no chord is farther than `tolerance` (modules) from
/// the curve; the points themselves are exact. README.md, section 1. Cost: O(points).
/// @pre specDiagnostics(spec) is empty, kind external
[[nodiscard]] HalfTooth externalTooth(const GearSpec& spec, double tolerance);

/// Tooth of a ring: its space is an involute tooth with a circular root fillet tangent to flank and root
/// circle.
/// @pre kind internal
[[nodiscard]] HalfTooth ringTooth(const GearSpec& spec, double tolerance);

/// Straight bevel tooth on the unit sphere about the apex, cut by the crown rack: spherical involute and the
/// trochoid of the rack's rounded tip. Any pitch cone in (0, pi). README.md, section 3. `tolerance` in
/// modules, at the large end. @pre kind bevel
[[nodiscard]] HalfTooth bevelTooth(const GearSpec& spec, double tolerance);

/// Half angle of the external tooth at radius `rad`, on the involute. @pre rad >= base radius
[[nodiscard]] double involuteHalfAngle(const GearSpec& spec, double rad);

/// Azimuth of the spherical involute, the closed form that does not go through the crown rack:
/// gam(c) = gam_p + az(d) - az(c). For tests and thickness. @pre c not inside the base cone
[[nodiscard]] double sphericalInvoluteHalfAngle(const GearSpec& spec, double colatitude);

}  // namespace geargraph::inline teeth

#pragma once

#include <vector>

#include "core/machine/teeth/gear_spec.h"
#include "core/machine/teeth/half_tooth.h"

namespace geargraph {

/// A worm with more starts is a helical gear: it meshes with another one on crossed axes instead.
constexpr int kMaxWormStarts = 8;
/// How far the rim of a worm's wheel reaches past its pitch circle on either side of the throat, in modules
/// (besides its profile shift).
constexpr double kWormRim = 1.5;

/// A worm (`hand` 1: right-hand, -1: left-hand) of this axial module and pitch radius, with heights of 1 and
/// 1.25 axial modules. README.md, section 2b. Lengths in one unit, the normal pressure angle in rad.
[[nodiscard]] GearSpec wormSpec(int starts, double axialModule, double pitchRadius, int hand,
                                double normalPressureAngle, double faceWidth);

/// The throated wheel that such a worm drives: the same hand, the same module and angle.
[[nodiscard]] GearSpec wormWheelSpec(int teeth, int starts, double axialModule, double wormPitchRadius,
                                     int hand, double normalPressureAngle, double faceWidth);

/// The same of specs in the normal section, as WheelKind::withHelix: heights in axial modules.
[[nodiscard]] GearSpec wormWithHelix(GearSpec normal, double helixAngle);
[[nodiscard]] GearSpec wormWheelWithHelix(GearSpec normal, double helixAngle);

/// Angle of the thread of a worm against the transverse plane, positive, rad.
[[nodiscard]] double leadAngle(const GearSpec& worm);
/// Module of a worm in its axial section, a length.
[[nodiscard]] double axialModule(const GearSpec& worm);
/// Advance of the thread in one turn of the worm, a length.
[[nodiscard]] double leadOf(const GearSpec& worm);

/// Between the axes of a wheel and of the worm that it was made for.
[[nodiscard]] double wormDistance(const GearSpec& wheel);
/// The usual face width of the wheel, 0.7 times the worm's tip diameter.
[[nodiscard]] double usualWheelFace(const GearSpec& wheel);
/// The length of a worm beyond which its thread does not reach the wheel.
[[nodiscard]] double usualWormLength(const GearSpec& wheel);

/// usualWormLength() for a worm that knows its wheel (GearSpec::mateTeeth).
[[nodiscard]] double usualWormFace(const GearSpec& worm);

/// A point of a thread in the section through the worm's axis, where a ZA worm is a rack. Lengths in axial
/// modules; the normal, out of the material, is of length 1.
struct ThreadPoint {
  double along = 0;  ///< from the middle of the thread
  double rad = 0;
  double normalAlong = 0;
  double normalRad = 0;
};

/// Half a thread, from the root to the tip corner, sampled so that no chord is farther than `tolerance`
/// (axial modules) from it: fillet, of which there may be none, and straight flank, which ends the list.
/// Roots go on to half a pitch on either side, the land to 0.
/// @pre a worm that specDiagnostics() finds nothing in
[[nodiscard]] std::vector<ThreadPoint> threadProfile(const GearSpec& worm, double tolerance);

/// The worm's transverse section: the axial one, bent round the axis. @pre as above
[[nodiscard]] HalfTooth wormTooth(const GearSpec& worm, double tolerance);

/// Contact ratio in the mid plane, where a worm and its wheel are a rack and a gear: as contactRatio().
[[nodiscard]] double wormContactRatio(const GearSpec& worm, const HalfTooth& thread, const GearSpec& wheel,
                                      const HalfTooth& tooth, double distance);
[[nodiscard]] double wormWheelContactRatio(const GearSpec& wheel, const HalfTooth& tooth,
                                           const GearSpec& worm, const HalfTooth& thread, double distance);

}  // namespace geargraph

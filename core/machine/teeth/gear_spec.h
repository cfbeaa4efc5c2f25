#pragma once

#include <numbers>

namespace geargraph {

/// The kinds of wheels. What differs between them is asked of the kind: of its WheelKind (wheel_kind.h), or
/// of its facet in the table of a layer that adds something. Nothing else compares kinds.
enum class GearKind { external, internal, bevel, pulley, worm, wormWheel, faceGear, hypoid };

/// The style of the part below the teeth.
enum class GearBody {
  plain,   ///< a disc with a bore (ring: with a rim); its volume is that of the section times the face width
  dressed  ///< hub, thinner web and windows where the wheel is large enough for them
};

/// Everything that determines the shape of one gear. Tooth proportions are in modules, as in catalogues and
/// ISO 53; `module` and the dimensions of the body are lengths. Equal specs give equal solids.
///
/// Frame of the gear: axis +z, tooth 0 centred on +x. Spur and ring: centred on z = 0. Bevel: apex at the
/// origin, the axis runs from the apex to the gear.
///
/// A helical wheel is described by its transverse section, like a spur wheel: module m_n / cos b, pressure
/// angle atan(tan a_n / cos b), and proportions and shift of the normal section times cos b (helical()). Its
/// section at z is the one at mid face turned by z tan(b) / r (twistOf()).
///
/// A worm is described like a helical wheel with as many teeth as it has starts: helix angle 90 degrees less
/// its lead angle g, so that its transverse module is the axial one over tan g. Its wheel has the helix angle
/// g and the worm's axial module; the worm's axis passes at `mateRadius` outside its pitch circle, over mid
/// face.
///
/// A spiral bevel is described by its transverse section, as a straight one: module m at the large end,
/// pressure angle atan(tan a_n / cos b), proportions and shift of the normal section times cos b, on every
/// sphere about the apex; the section at distance R is that of the large end turned by spiralOf().
///
/// A face gear has its pitch plane on z = 0 and its teeth towards -z, where the axis of its pinion of
/// `mateTeeth` teeth passes at the height -`mateRadius`; `faceWidth` reaches outwards from faceInner().
///
/// A hypoid is a bevel that is drawn without teeth.
struct GearSpec {
  GearKind kind = GearKind::external;
  int teeth = 20;
  double module = 1;                                   ///< at the reference circle; bevel: at the large end
  double pressureAngle = 20 * std::numbers::pi / 180;  ///< rad
  double profileShift = 0;  ///< positive: external teeth thicker and taller, ring spaces wider and deeper
  double backlashAllowance =
      0;  ///< backlash allowance of this gear: reduction of the tooth thickness at the pitch circle, modules
  double addendum = 1;
  double dedendum = 1.25;
  double rootRadius =
      0.38;  ///< of the rack's tip corner (ring: of the fillet), modules; reduced where there is no room
  double tipRadius = 0;   ///< modules; 0: it follows from the addendum. Not for bevels
  double coneAngle = 0;   ///< bevel: pitch cone, in (0, pi); pi/2 is a crown gear
  double faceWidth = 10;  ///< bevel: along the pitch cone, from the large end towards the apex
  double bore = 0;        ///< diameter, 0: none. Rings have none
  double rim = 0;         ///< ring: outer diameter, 0: from the root
  double hub = 0;         ///< dressed: diameter of the hub, 0: from the bore
  GearBody body = GearBody::plain;
  double helixAngle = 0;     ///< at the reference cylinder, rad, positive: right-hand; bevels: spiral angle
  bool herringbone = false;  ///< `helixAngle` is that of the half below mid face, the other half mirrors it
  int mateTeeth =
      0;  ///< worm wheel, face gear: starts or teeth of what cuts it; worm: of the wheel, if known
  double mateRadius = 0;  ///< pitch radius of that worm, pinion or wheel

  friend bool operator==(const GearSpec&, const GearSpec&) = default;
};

/// A spec with this program's basic rack for the kind: ISO 53 A; for bevels a root radius of 0.30, for rings
/// a fillet of 0.25 modules.
[[nodiscard]] GearSpec standardGear(GearKind kind, int teeth, double module, double faceWidth);

/// The helical wheel whose normal section has these measures. @pre spec.helixAngle is 0, not a bevel
[[nodiscard]] GearSpec helical(GearSpec spec, double helixAngle);
/// The spiral bevel whose normal section has these measures, at an unchanged module of the large end.
[[nodiscard]] GearSpec spiral(GearSpec spec, double spiralAngle);
/// Module, pressure angle and profile shift in the normal section, as they are stated and sold.
[[nodiscard]] double normalModule(const GearSpec& spec);
[[nodiscard]] double normalPressureAngle(const GearSpec& spec);
[[nodiscard]] double normalShift(const GearSpec& spec);
/// The angle by which the section at height z, from mid face, is turned against the one there, rad.
[[nodiscard]] double twistOf(const GearSpec& spec, double height);

/// The angle by which the section of a bevel on the sphere of this radius is turned against that of its large
/// end, rad: a logarithmic spiral, d turn / d R = tan b / (R sin d).
[[nodiscard]] double spiralOf(const GearSpec& spec, double distance);

/// The module by which bodies, gaps and tolerances are measured: that of the spec, of a worm that of its
/// axial section, which is the wheel's.
[[nodiscard]] double toothSize(const GearSpec& spec);

/// Reference pitch radius, m z / 2.
[[nodiscard]] double pitchRadius(const GearSpec& spec);

/// Bevel: distance from the apex to the pitch circle, Re = m z / (2 sin d).
[[nodiscard]] double coneDistance(const GearSpec& spec);

/// Tip and root circles as lengths. Bevel: at the large end, on the back cone.
[[nodiscard]] double nominalTipRadius(const GearSpec& spec);
[[nodiscard]] double nominalRootRadius(const GearSpec& spec);

/// The smallest tooth counts of a gear and of a ring, which has more than its pinion. Two teeth would leave
/// no body below the roots.
constexpr int kMinGearTeeth = 3;
constexpr int kMinRingTeeth = 4;

}  // namespace geargraph

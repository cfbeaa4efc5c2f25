#pragma once

#include <span>
#include <string_view>

#include "core/foundations/base/kind_table.h"
#include "core/machine/teeth/gear_spec.h"
#include "core/machine/teeth/half_tooth.h"

template <>
inline constexpr std::size_t geargraph::kNamedKinds<geargraph::GearKind> = 8;

namespace geargraph {

/// What every layer may know of a kind of wheel; solids, trains and drawings add a facet of their own.
struct WheelKind {
  std::string_view name;   ///< the word in what programs read
  bool isRing = false;     ///< its teeth point to the axis
  bool isConical = false;  ///< its pitch surface is a cone with the apex at the origin (GearSpec::coneAngle)
  bool isFace =
      false;  ///< its teeth stand on a plane face, cut by a pinion across its axis (GearSpec::mateTeeth)
  bool isStandIn = false;      ///< the wheel has teeth, but is drawn without: they are not known here
  double cornerRadius = 0.38;  ///< of the basic rack: GearSpec::rootRadius
  int fewestTeeth = kMinGearTeeth;
  double (*tipRadius)(const GearSpec& spec) = nullptr;   ///< as nominalTipRadius()
  double (*rootRadius)(const GearSpec& spec) = nullptr;  ///< as nominalRootRadius()
  /// Real teeth over virtual ones of the plane that contact is judged in, the back cone of a bevel.
  double (*shareOfVirtual)(const GearSpec& spec) = nullptr;
  /// The generated tooth, with chords of at most `tolerance` modules; null for a wheel without teeth.
  HalfTooth (*tooth)(const GearSpec& spec, double tolerance) = nullptr;
  /// The wheel with a helix, of one whose measures are those of the normal section.
  GearSpec (*withHelix)(GearSpec normal, double helixAngle) = helical;
  /// How large the teeth are, as toothSize(); null: the spec's module.
  double (*toothSize)(const GearSpec& spec) = nullptr;
  /// Gives the face width where the document states none, a length; null: a number of modules.
  double (*usualFace)(const GearSpec& spec) = nullptr;
  /// As contactRatio() (tooth_pair.h), of a wheel `a` of this kind. Unused without teeth.
  double (*contactRatio)(const GearSpec& a, const HalfTooth& toothA, const GearSpec& b,
                         const HalfTooth& toothB, double distance) = nullptr;
};

/// Half of the thickness of a belt, in modules of its pulleys.
constexpr double kHalfBelt = 0.25;

[[nodiscard]] KindTable<GearKind, WheelKind>& wheelKinds();
[[nodiscard]] const WheelKind& wheelKind(GearKind kind);
/// All kinds: those of the enumeration, then any that were added.
[[nodiscard]] std::span<const GearKind> gearKinds();
[[nodiscard]] std::string_view gearKindName(GearKind kind);

/// The tooth of a wheel. @pre it has teeth, and specDiagnostics(spec) is empty
[[nodiscard]] HalfTooth toothOf(const GearSpec& spec, double tolerance);

[[nodiscard]] bool isRing(const GearSpec& spec);
[[nodiscard]] bool isConical(const GearSpec& spec);
[[nodiscard]] bool isToothed(const GearSpec& spec);
[[nodiscard]] bool isFaceGear(const GearSpec& spec);
/// Round its whole axis, with what meshes with it outside.
[[nodiscard]] bool isDisc(const GearSpec& spec);

}  // namespace geargraph

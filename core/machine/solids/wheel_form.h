#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/foundations/base/diagnostic.h"
#include "core/foundations/base/kind_table.h"
#include "core/machine/solids/gear_body.h"
#include "core/machine/solids/gear_mesher.h"
#include "core/machine/solids/solid.h"
#include "core/machine/teeth/half_tooth.h"
#include "core/machine/teeth/wheel_kind.h"

namespace geargraph {

/// What solids know of a kind of wheel: its blank, and where the blank carries teeth.
struct WheelForm {
  /// As bodyProfile(), bodyWindows(), wheelOutline(), axialSpan() and largestBore() (gear_body.h).
  std::vector<ProfileVertex> (*body)(const GearSpec& spec) = nullptr;
  std::optional<WebWindows> (*windows)(const GearSpec& spec) = nullptr;
  std::vector<ProfileVertex> (*outline)(const GearSpec& spec) = nullptr;
  AxialSpan (*span)(const GearSpec& spec) = nullptr;
  double (*largestBore)(const GearSpec& spec) = nullptr;
  /// The tooth's profile at both faces. Unused without teeth, and where there is a `solid`.
  std::vector<OutlinePoint> (*toothFaces)(const HalfTooth& tooth, const GearSpec& spec) = nullptr;
  /// The sections of teeth that no turned cylinder is, of the profile at the faces; `chord` is a length.
  /// Empty: straight. Null: always straight, or turned cylinders.
  std::vector<std::vector<WallPoint>> (*sections)(const std::vector<OutlinePoint>& half, const GearSpec& spec,
                                                  double chord) = nullptr;
  /// As gearSolid(), of teeth that their profile at the faces does not determine.
  Solid (*solid)(const GearSpec& spec, double tolerance) = nullptr;
  /// As toothlessGear(); `chord` is a length.
  Solid (*toothless)(const GearSpec& spec, double chord) = nullptr;
  double steepest = 1.2;  ///< transverse pressure angle that specDiagnostics() accepts, rad
  /// What specDiagnostics() has to say of its measures, and, where that is nothing, of its body.
  void (*check)(const GearSpec& spec, Diagnostics& found) = nullptr;
  void (*checkBody)(const GearSpec& spec, Diagnostics& found) = nullptr;
  /// specDiagnostics(), in a sentence, of fewer teeth than `fewest`.
  std::string (*tooFewTeeth)(const GearSpec& spec, int fewest) = nullptr;
};

[[nodiscard]] KindTable<GearKind, WheelForm>& wheelForms();
[[nodiscard]] const WheelForm& wheelForm(const GearSpec& spec);

/// The forms of the kinds that are there; an added kind may use parts of one.
extern const WheelForm kDiscForm;
extern const WheelForm kRingForm;
extern const WheelForm kConeForm;
extern const WheelForm kPulleyForm;
extern const WheelForm kWormForm;
extern const WheelForm kWormWheelForm;
extern const WheelForm kFaceForm;
extern const WheelForm kSmoothConeForm;

/// Faces of a tooth on a cylinder: straight, square to the axis.
[[nodiscard]] std::vector<OutlinePoint> cylinderFaces(const HalfTooth& tooth, const GearSpec& spec);
/// Is the point a corner's second one?
[[nodiscard]] bool isSameCorner(const HalfTooth& tooth, std::size_t i);

/// The profile and the highest and lowest height of a body alone.
[[nodiscard]] std::vector<ProfileVertex> discProfile(double diameter, double width);
[[nodiscard]] AxialSpan spanOf(std::span<const ProfileVertex> profile);
/// Body, then tips at the body's faces.
[[nodiscard]] std::vector<ProfileVertex> discOutline(const GearSpec& spec);

/// Parts of kDiscForm.
[[nodiscard]] std::vector<ProfileVertex> discBody(const GearSpec& spec);
[[nodiscard]] std::optional<WebWindows> discWindows(const GearSpec& spec);
[[nodiscard]] AxialSpan discSpan(const GearSpec& spec);
[[nodiscard]] double largestDiscBore(const GearSpec& spec);
[[nodiscard]] Solid toothlessDisc(const GearSpec& spec, double chord);

/// teeth-geometry, and a measure with one decimal for its text.
[[nodiscard]] Diagnostic specRejection(std::string message);
[[nodiscard]] std::string oneDecimal(double value);
/// Where the bore leaves no body below the roots.
void checkBore(const GearSpec& spec, Diagnostics& found);
[[nodiscard]] std::string tooFewForRack(const GearSpec& spec, int fewest);

}  // namespace geargraph

#pragma once

#include "core/machine/solids/wheel_form.h"
#include "core/machine/teeth/wheel_kind.h"
#include "core/machine/train/pair_wheels.h"
#include "core/mechanism/document_format/mechanism_file.h"
#include "core/mechanism/kinds/pair_kind.h"
#include "core/mechanism/placement/pair_rule.h"
#include "core/presentation/brep/wheel_brep.h"
#include "core/presentation/schematic/wheel_symbol.h"
#include "core/teaching/exercises/pair_teaching.h"
#include "core/theory/ttgraph/terminal_rule.h"

namespace geargraph::test {

/// A kind of pair that no program has: two rollers that drive each other by friction. Its "teeth" are only
/// the ratio of the diameters. As long as this lives the kind is one of all.
class ToyKind {
 public:
  static constexpr int kBarSide = -4;  ///< of the symbol: the rollers do not touch on paper

  [[nodiscard]] MeshKind pair() const { return m_pair.kind(); }
  [[nodiscard]] GearKind roller() const { return m_wheel.kind(); }

 private:
  static double tipOf(const GearSpec& spec) { return pitchRadius(spec); }
  static double rootOf(const GearSpec& spec) { return pitchRadius(spec); }
  static double noShare(const GearSpec& /*spec*/) { return 1; }
  static std::vector<ProfileVertex> bodyOf(const GearSpec& spec) {
    return discProfile(spec.bore, spec.faceWidth);
  }
  static std::optional<WebWindows> noWindows(const GearSpec& /*spec*/) { return std::nullopt; }
  static AxialSpan spanBetweenFaces(const GearSpec& spec) {
    return {-spec.faceWidth / 2, spec.faceWidth / 2};
  }
  static void nothing(const GearSpec& /*spec*/, Diagnostics& /*found*/) {}
  static std::optional<SecondCentral> noSecond(int /*planet*/, int /*central*/) { return std::nullopt; }
  static std::optional<int> againstEachOther(int sense) { return -sense; }

  static constexpr WheelKind kWheel{.name = "roller",
                                    .fewestTeeth = 1,
                                    .tipRadius = tipOf,
                                    .rootRadius = rootOf,
                                    .shareOfVirtual = noShare};
  // The compiler does not look into constants of another library.
  const WheelForm m_rollerForm{.body = bodyOf,
                               .windows = noWindows,
                               .outline = discOutline,
                               .span = spanBetweenFaces,
                               .largestBore = kDiscForm.largestBore,
                               .toothless = kDiscForm.toothless,
                               .check = nothing,
                               .checkBody = checkBore,
                               .tooFewTeeth = tooFewForRack};
  const PairWheels m_rollers;
  const PairKind m_friction{.name = "friction",
                            .word = "friction",
                            .makeIt = "Make %1 a pair of rollers",
                            .distance = pairKind(kUsualKind).distance,
                            .distanceForm = pairKind(kUsualKind).distanceForm,
                            .secondCentral = noSecond,
                            .other = std::nullopt,
                            .since = kFileVersion};
  static constexpr TerminalRule kTerminals{againstEachOther};
  static constexpr PairTeaching kTeaching{
      .signMistake = "rollers-turn-alike",
      .signInRow = "The rollers of mesh %1 turn against each other.",
      .signInTable = "The rollers of mesh %1 turn opposite ways.",
      .sameWay = "The rollers of mesh %1 turn alike: %2.",
      .againstEachOther = "The rollers of mesh %1 turn against each other: %2."};
  const WheelSymbol m_symbol{.side = kBarSide, .setBar = kDiscSymbol.setBar, .away = kDiscSymbol.away};

  const WheelCad m_cad{.make = kSmoothCad.make};

  AddedFacet<GearKind, WheelKind> m_wheel;
  AddedFacet<GearKind, WheelForm> m_form{wheelForms(), m_wheel.kind(), &m_rollerForm};
  AddedFacet<GearKind, WheelSymbol> m_drawn{wheelSymbols(), m_wheel.kind(), &m_symbol};
  AddedFacet<GearKind, WheelCad> m_faces{wheelCads(), m_wheel.kind(), &m_cad};
  AddedFacet<MeshKind, PairKind> m_pair{pairKinds(), &m_friction};
  AddedFacet<MeshKind, PairRule> m_rule{pairRules(), m_pair.kind(), &kExternalRule};
  AddedFacet<MeshKind, PairWheels> m_wheels{pairWheels(), m_pair.kind(), &m_rollers};
  AddedFacet<MeshKind, TerminalRule> m_terminals{terminalRules(), m_pair.kind(), &kTerminals};
  AddedFacet<MeshKind, PairTeaching> m_teaching{pairTeachings(), m_pair.kind(), &kTeaching};

 public:
  ToyKind()
      : m_rollers{static_cast<GearKind>(gearKinds().size()), static_cast<GearKind>(gearKinds().size())},
        m_wheel(wheelKinds(), &kWheel) {}
};

}  // namespace geargraph::test

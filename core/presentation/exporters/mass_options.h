#pragma once

#include <variant>

#include "core/foundations/base/translation.h"
#include "core/mechanism/model/mechanism.h"
#include "core/presentation/exporters/option_values.h"

namespace geargraph {

/// The mechanism with the density of `--density` (kg/m³) and the gravity of `--gravity` (m/s²), if given.
[[nodiscard]] std::variant<Mechanism, UsageError> withMassOptions(Mechanism mechanism,
                                                                  const OptionValues& given);

inline constexpr OptionText kGravityOption{
    "--gravity", "0,0,-9.81", toTranslate("acceleration of free fall, m/s², instead of the document's")};
inline constexpr OptionText kDensityOption{"--density", "7850",
                                           toTranslate("of all solids, kg/m³, instead of the document's")};

}  // namespace geargraph

#pragma once

#include <optional>
#include <string_view>

#include "core/mechanism/model/number.h"

namespace geargraph::inline model {

/// Parses a torque with its unit and converts it to N m: "10 Nm", "10 N m", "-1/2kNm", "500 Nmm"; the Unicode
/// minus sign is accepted too. std::nullopt for anything else.
[[nodiscard]] std::optional<Number> torqueFromText(std::string_view text);

}  // namespace geargraph::inline model

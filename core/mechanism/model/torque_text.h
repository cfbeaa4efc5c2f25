#pragma once

#include <optional>
#include <string_view>

#include "core/mechanism/model/number.h"

namespace geargraph::inline model {

/// A torque with its unit, in N m: "10 Nm", "10 N m", "-1/2kNm", "500 Nmm"; a true minus sign counts as well.
/// None for anything else.
[[nodiscard]] std::optional<Number> torqueFromText(std::string_view text);

}  // namespace geargraph::inline model

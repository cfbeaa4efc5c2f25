#pragma once

#include <optional>
#include <string_view>

#include "core/mechanism/model/number.h"

namespace geargraph {

/// Parses a typed length and converts it to `unit` exactly: "12", "22/7", "2*3" (in `unit`), or with a unit:
/// "1 in", "2.5cm", "1/2\"", "(1+1/2) in" (typedNumber()). Units: nm, um (µm), mm, cm, dm, m, mil, in ("), ft
/// ('), and `unit` itself, whatever it is. std::nullopt if the text is no number, or the conversion needs a
/// unit that is not listed.
[[nodiscard]] std::optional<Number> lengthFromText(std::string_view text, std::string_view unit);

}  // namespace geargraph

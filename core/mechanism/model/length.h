#pragma once

#include <optional>
#include <string_view>

#include "core/mechanism/model/number.h"

namespace geargraph::inline model {

/// A length as somebody types it, in `unit`: "12", "22/7", or with a unit of its own, which is converted
/// exactly: "1 in", "2.5cm", "1/2\"". Units: nm, um (µm), mm, cm, dm, m, mil, in ("), ft ('), and the
/// document's own whatever it is. Nothing where the text is no number, or a unit would have to be converted
/// that is none of these.
[[nodiscard]] std::optional<Number> lengthFromText(std::string_view text, std::string_view unit);

}  // namespace geargraph::inline model

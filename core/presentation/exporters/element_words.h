#pragma once

#include <optional>
#include <string_view>

#include "core/mechanism/model/mechanism.h"

namespace geargraph::inline exporters {

// Elements named in options: by their label, or by their id where no label is spelled so.

[[nodiscard]] std::optional<JointOrdinal> jointNamed(const Mechanism& mechanism, std::string_view word);
[[nodiscard]] std::optional<LinkOrdinal> linkNamed(const Mechanism& mechanism, std::string_view word);

}  // namespace geargraph::inline exporters

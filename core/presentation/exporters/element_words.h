#pragma once

#include <optional>
#include <string_view>
#include <variant>
#include <vector>

#include "core/mechanism/model/mechanism.h"
#include "core/presentation/exporters/option_values.h"

namespace geargraph {

// Elements named in options: by their label, or by their id where no label is spelled so.

[[nodiscard]] std::optional<JointOrdinal> jointNamed(const Mechanism& mechanism, std::string_view word);
[[nodiscard]] std::optional<LinkOrdinal> linkNamed(const Mechanism& mechanism, std::string_view word);

/// The joints that the value of an option names, with commas between them; an error for what is no joint, and
/// for one that is named twice.
[[nodiscard]] std::variant<std::vector<JointOrdinal>, UsageError> jointsNamed(const Mechanism& mechanism,
                                                                              std::string_view option,
                                                                              std::string_view text);

}  // namespace geargraph

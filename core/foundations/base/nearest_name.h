#pragma once

#include <optional>
#include <span>
#include <string_view>

namespace geargraph {

/// The known name that a mistyped one is probably meant to be: the same letters in another case or with other
/// separators ("tail_teeth"), else the fewest letters that are wrong, left out, added or exchanged with their
/// neighbour, at most one in four letters but always one ("efficency", "input"). The first of equally near
/// ones; std::nullopt if none is near. Cost: O(known names x letters²).
[[nodiscard]] std::optional<std::string_view> nearestName(std::string_view name,
                                                          std::span<const std::string_view> known);

}  // namespace geargraph

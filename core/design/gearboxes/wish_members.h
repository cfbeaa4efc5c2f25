#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/design/gearboxes/wanted_ratio.h"
#include "core/mechanism/document_format/json_object.h"

namespace geargraph {

/// A whole number in lowest..highest, or `otherwise` where the member is missing.
[[nodiscard]] int wholeMember(JsonObject& object, std::string_view name, int lowest, int highest,
                              int otherwise);
/// Two whole numbers in lowest..highest, the first not above the second.
[[nodiscard]] std::array<int, 2> rangeMember(JsonObject& object, std::string_view name, int lowest,
                                             int highest, const std::array<int, 2>& otherwise);
/// A number above 0.
[[nodiscard]] std::optional<Rational> positiveMember(JsonObject& object, std::string_view name);
/// A tolerance: at least 0, below 1.
[[nodiscard]] std::optional<Rational> toleranceMember(JsonObject& object);
/// A list of 1 to `most` ratios; with a diagnostic for each that is none.
[[nodiscard]] std::vector<WantedRatio> ratiosMember(JsonObject& object, std::string_view name,
                                                    std::size_t most,
                                                    const std::optional<Rational>& tolerance);
/// A ratio, below or above 0, by its size.
[[nodiscard]] std::optional<WantedRatio> sizeOf(JsonObject& object, std::string_view name, JsonValue value,
                                                const std::optional<Rational>& tolerance);
/// A diagnostic for each member that was not read.
void rejectUnknown(JsonObject& object, JsonValue value);

}  // namespace geargraph

#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

namespace geargraph {

/// What a joint leaves free: a turn about the line of its axis, with rates in rad/s, or a slide along the
/// line's direction, with rates in the document's unit of length a second.
enum class JointKind : std::uint8_t { turning, sliding };

/// The word in documents.
[[nodiscard]] std::string_view jointKindName(JointKind kind);
/// By its name; std::nullopt where no kind has it.
[[nodiscard]] std::optional<JointKind> jointKindFrom(std::string_view name);

}  // namespace geargraph

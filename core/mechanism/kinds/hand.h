#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace geargraph {

/// The hand of a helix: a right-hand one, followed along its axis either way, turns like a common screw.
/// Turning an axis round does not change it; a mirror does.
enum class Hand : std::uint8_t { right, left };

/// The word in documents.
[[nodiscard]] std::string_view handName(Hand hand);
/// Its word in the language in use.
[[nodiscard]] std::string handWord(Hand hand);
/// By its name; std::nullopt where no hand has it.
[[nodiscard]] std::optional<Hand> handFrom(std::string_view name);

/// +1 for right, -1 for left: the sign of helix angles.
[[nodiscard]] constexpr int signOf(Hand hand) {
  return hand == Hand::right ? 1 : -1;
}
[[nodiscard]] constexpr Hand handOf(double helix) {
  return helix < 0 ? Hand::left : Hand::right;
}

}  // namespace geargraph

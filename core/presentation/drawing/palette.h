#pragma once

#include <cstdint>
#include <optional>
#include <string>

namespace geargraph::inline drawing {

/// High contrast is light on black, for weak eyes and weak projectors.
enum class Theme { light, dark, highContrast };

/// An sRGB colour, opaque.
struct Color {
  std::uint8_t red = 0;
  std::uint8_t green = 0;
  std::uint8_t blue = 0;
  friend bool operator==(const Color&, const Color&) = default;
};

/// What a colour is for. A colour never carries a meaning alone: labels, dashes and icons say it too.
enum class ColorRole {
  sheet,         ///< the ground of drawings and tables
  ink,           ///< text and lines
  secondary,     ///< what may be overlooked: axes, hints, hatching
  hairline,      ///< borders and rules
  control,       ///< borders of what is filled in, ticked or dragged
  panel,         ///< the ground of tool bars and docks
  accent,        ///< selection and highlight
  halo,          ///< the soft band around what is selected or hovered
  input,         ///< motors: border
  inputFill,     ///< motors: ground
  inputInk,      ///< motors: text on inputFill
  error,         ///< and the other two severities
  warning,       //
  fine,          //
  positiveFill,  ///< cells with +1
  positiveInk,   //
  negativeFill,  ///< cells with -1
  negativeInk,   //
};

constexpr int kColorRoleCount = static_cast<int>(ColorRole::negativeInk) + 1;

[[nodiscard]] Color colorOf(ColorRole role, Theme theme);

/// The colour of a link in every view and both themes, by its label (0: the ground). Eight hues that the
/// colour-blind can tell apart, then the same lighter, then darker, then from the start again.
[[nodiscard]] Color linkColor(int label);

/// "#0072B2"
[[nodiscard]] std::string hexOf(Color color);

/// A colour of a drawing before the theme is known: a role, or the colour of a link.
struct Tint {
  ColorRole role = ColorRole::ink;
  std::optional<int> link;  ///< a link's label; then `role` does not count
  bool soft = false;        ///< mixed with the sheet, for areas under lines and text

  Tint() = default;
  Tint(ColorRole colorRole) : role(colorRole) {}  // NOLINT(google-explicit-constructor)
  [[nodiscard]] static Tint ofLink(int label);
  [[nodiscard]] Tint softened() const;
  friend bool operator==(const Tint&, const Tint&) = default;
};

[[nodiscard]] Color colorOf(const Tint& tint, Theme theme);
/// "accent", "link 3": for golden tests and style classes.
[[nodiscard]] std::string nameOf(const Tint& tint);

}  // namespace geargraph::inline drawing

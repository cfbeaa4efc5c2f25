#pragma once

#include <cstdint>
#include <optional>
#include <string>

namespace geargraph {

/// High contrast is light on black, for low vision and weak projectors.
enum class Theme { light, dark, highContrast };

/// An sRGB colour, opaque.
struct Color {
  std::uint8_t red = 0;
  std::uint8_t green = 0;
  std::uint8_t blue = 0;
  friend bool operator==(const Color&, const Color&) = default;
};

/// The role of a colour. No meaning is conveyed by colour alone: labels, dashes and icons convey it too.
enum class ColorRole {
  sheet,         ///< background of drawings and tables
  ink,           ///< text and lines
  secondary,     ///< less important marks: axes, hints, hatching
  hairline,      ///< borders and rules
  control,       ///< borders of input controls
  panel,         ///< background of tool bars and docks
  accent,        ///< selection and highlight
  halo,          ///< the soft band around selected and hovered elements
  input,         ///< motors: border
  inputFill,     ///< motors: background
  inputInk,      ///< motors: text on inputFill
  error,         ///< the three severities
  warning,       //
  fine,          //
  positiveFill,  ///< cells with +1
  positiveInk,   //
  negativeFill,  ///< cells with -1
  negativeInk,   //
};

constexpr int kColorRoleCount = static_cast<int>(ColorRole::negativeInk) + 1;

[[nodiscard]] Color colorOf(ColorRole role, Theme theme);

/// The colour of a link in every view and both themes, by the number of its colour (Mechanism::colorNumber();
/// 0: the ground). Eight hues that are
/// distinguishable with colour blindness, then the same lighter, then darker, then again from the start.
[[nodiscard]] Color linkColor(int number);

/// "#0072B2"
[[nodiscard]] std::string hexOf(Color color);

/// A colour of a drawing before the theme is known: a role, or the colour of a link.
struct Tint {
  ColorRole role = ColorRole::ink;
  std::optional<int> link;  ///< a link's label; then `role` is ignored
  int linkColor = 0;        ///< the number of its colour
  bool soft = false;        ///< mixed with the sheet's colour, for areas under lines and text

  Tint() = default;
  Tint(ColorRole colorRole) : role(colorRole) {}  // NOLINT(google-explicit-constructor)
  [[nodiscard]] static Tint ofLink(int label, int colorNumber);
  [[nodiscard]] Tint softened() const;
  friend bool operator==(const Tint&, const Tint&) = default;
};

[[nodiscard]] Color colorOf(const Tint& tint, Theme theme);
/// "accent", "link 3": for golden tests and style classes.
[[nodiscard]] std::string nameOf(const Tint& tint);

}  // namespace geargraph

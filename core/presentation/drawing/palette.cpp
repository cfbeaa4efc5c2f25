#include "core/presentation/drawing/palette.h"

#include <array>
#include <string_view>

#include "core/foundations/base/contract.h"

namespace geargraph {
namespace {

constexpr Color rgb(std::uint32_t hex) {
  return {static_cast<std::uint8_t>(hex >> 16), static_cast<std::uint8_t>(hex >> 8 & 0xFF),
          static_cast<std::uint8_t>(hex & 0xFF)};
}

struct RoleColors {
  std::string_view name;
  Color light;
  Color dark;
  Color highContrast;
};

constexpr std::array<RoleColors, kColorRoleCount> kRoles{{
    {"sheet", rgb(0xFFFFFF), rgb(0x1E2227), rgb(0x000000)},
    {"ink", rgb(0x23272E), rgb(0xE6E9EE), rgb(0xFFFFFF)},
    {"secondary", rgb(0x616975), rgb(0x98A1AE), rgb(0xD6D6D6)},
    {"hairline", rgb(0xD9DDE3), rgb(0x3A414B), rgb(0x8C8C8C)},
    {"control", rgb(0x808893), rgb(0x7A838F), rgb(0xD6D6D6)},
    {"panel", rgb(0xF5F6F8), rgb(0x262B31), rgb(0x0B0B0B)},
    {"accent", rgb(0x2A68E4), rgb(0x6C9BFF), rgb(0xFFE14D)},
    {"halo", rgb(0xBFD2FB), rgb(0x2C4474), rgb(0x5C4B00)},
    {"input", rgb(0xE69F00), rgb(0xFFB833), rgb(0xFFB833)},
    {"input-fill", rgb(0xFFF3DA), rgb(0x4A3A14), rgb(0x3A2900)},
    {"input-ink", rgb(0x8A5A00), rgb(0xFFD27A), rgb(0xFFE0A0)},
    {"error", rgb(0xC62828), rgb(0xFF7B72), rgb(0xFF8A80)},
    {"warning", rgb(0xA36000), rgb(0xF0B24A), rgb(0xFFC663)},
    {"fine", rgb(0x1B6B45), rgb(0x6CD39B), rgb(0x7DF0AE)},
    {"positive-fill", rgb(0xDCEBFA), rgb(0x1F3B57), rgb(0x00417F)},
    {"positive-ink", rgb(0x0B4F86), rgb(0x9CCBFF), rgb(0xFFFFFF)},
    {"negative-fill", rgb(0xFBE3D6), rgb(0x54301A), rgb(0x7A2E00)},
    {"negative-ink", rgb(0xA34400), rgb(0xFFB48A), rgb(0xFFFFFF)},
}};

constexpr Color kGroundLink = rgb(0x8A9099);
constexpr std::array<Color, 8> kHues{rgb(0x0072B2), rgb(0xD55E00), rgb(0x009E73), rgb(0xCC79A7),
                                     rgb(0xE69F00), rgb(0x56B4E9), rgb(0x8C6BB1), rgb(0xB5A500)};

/// `share` of `other` mixed into `color`, channel by channel.
Color mixed(Color color, Color other, double share) {
  const auto mix = [share](std::uint8_t a, std::uint8_t b) {
    return static_cast<std::uint8_t>(a + (b - a) * share + 0.5);
  };
  return {mix(color.red, other.red), mix(color.green, other.green), mix(color.blue, other.blue)};
}

}  // namespace

Color colorOf(ColorRole role, Theme theme) {
  const RoleColors& colors = kRoles[static_cast<std::size_t>(role)];
  switch (theme) {
    case Theme::light:
      return colors.light;
    case Theme::dark:
      return colors.dark;
    case Theme::highContrast:
      return colors.highContrast;
  }
  GEARGRAPH_REQUIRE(false);
}

Color linkColor(int number) {
  GEARGRAPH_REQUIRE(number >= 0);
  if (number == 0) return kGroundLink;
  const auto place = static_cast<std::size_t>(number - 1);
  const Color hue = kHues[place % kHues.size()];
  switch (place / kHues.size() % 3) {
    case 1:
      return mixed(hue, rgb(0xFFFFFF), 0.4);
    case 2:
      return mixed(hue, rgb(0x000000), 0.4);
    default:
      return hue;
  }
}

std::string hexOf(Color color) {
  constexpr std::string_view kDigits = "0123456789ABCDEF";
  std::string hex = "#";
  for (const std::uint8_t channel : {color.red, color.green, color.blue}) {
    hex += kDigits[channel >> 4];
    hex += kDigits[channel & 15];
  }
  return hex;
}

Tint Tint::ofLink(int label, int colorNumber) {
  Tint tint;
  tint.link = label;
  tint.linkColor = colorNumber;
  return tint;
}

Tint Tint::softened() const {
  Tint tint = *this;
  tint.soft = true;
  return tint;
}

Color colorOf(const Tint& tint, Theme theme) {
  const Color full = tint.link ? linkColor(tint.linkColor) : colorOf(tint.role, theme);
  const double sheet = theme == Theme::light ? 0.7 : 0.6;
  return tint.soft ? mixed(full, colorOf(ColorRole::sheet, theme), sheet) : full;
}

std::string nameOf(const Tint& tint) {
  const std::string name = tint.link ? "link " + std::to_string(*tint.link)
                                     : std::string(kRoles[static_cast<std::size_t>(tint.role)].name);
  return tint.soft ? "soft " + name : name;
}

}  // namespace geargraph

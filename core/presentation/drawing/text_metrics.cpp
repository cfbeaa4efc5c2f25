#include "core/presentation/drawing/text_metrics.h"

namespace geargraph {
namespace {

bool startsCharacter(char byte) {
  return (static_cast<unsigned char>(byte) & 0xC0) != 0x80;
}

/// In em, DejaVu Sans regular.
double advance(char c) {
  constexpr std::string_view kNarrow = "ijl'|.,:;! ()[]ftI";
  constexpr std::string_view kWide = "mwMWOQ@%+=<>";
  if (c >= '0' && c <= '9') return 0.636;
  if (kNarrow.find(c) != std::string_view::npos) return 0.39;
  if (kWide.find(c) != std::string_view::npos) return 0.9;
  return (c >= 'A' && c <= 'Z') || static_cast<unsigned char>(c) >= 0x80 ? 0.72 : 0.62;
}

}  // namespace

double textWidth(std::string_view utf8, double size, bool bold) {
  double ems = 0;
  for (const char c : utf8) {
    if (startsCharacter(c)) ems += advance(c);
  }
  return ems * size * (bold ? 1.1 : 1.0);
}

std::string elided(std::string_view utf8, std::size_t characters) {
  std::size_t seen = 0;
  std::size_t cut = 0;  // where the last character that may stay ends
  for (std::size_t i = 0; i < utf8.size(); ++i) {
    if (!startsCharacter(utf8[i])) continue;
    if (seen + 1 == characters) cut = i;
    if (++seen > characters) return std::string(utf8.substr(0, cut)) + "…";
  }
  return std::string(utf8);
}

}  // namespace geargraph

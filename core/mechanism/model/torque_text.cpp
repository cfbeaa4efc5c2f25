#include "core/mechanism/model/torque_text.h"

#include <array>
#include <string>
#include <utility>

namespace geargraph::inline model {

std::optional<Number> torqueFromText(std::string_view text) {
  constexpr std::array<std::pair<std::string_view, std::int64_t>, 3> kUnits = {
      {{"kNm", 1'000'000}, {"Nmm", 1}, {"Nm", 1'000}}};
  constexpr std::string_view kMinus = "\xE2\x88\x92";
  std::string plain;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text.substr(i).starts_with(kMinus)) {
      plain += '-';
      i += kMinus.size() - 1;
    } else if (text[i] != ' ') {
      plain += text[i];
    }
  }
  for (const auto& [unit, millis] : kUnits) {
    if (!plain.ends_with(unit)) continue;
    const auto number = Number::fromText(plain.substr(0, plain.size() - unit.size()));
    if (!number) return std::nullopt;
    if (millis == 1'000) return number;  // as it is written
    return Number(number->exact() * Rational(millis, 1'000));
  }
  return std::nullopt;
}

}  // namespace geargraph::inline model

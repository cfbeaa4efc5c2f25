#include "core/design/gearboxes/wanted_ratio.h"

namespace geargraph {
namespace {

/// Half a unit of the last digit of a decimal; 0 of a fraction or a whole number.
Rational halfUnit(std::string_view text) {
  constexpr std::size_t kMaxDigits = 4300;
  const std::size_t exponentAt = text.find_first_of("eE");
  const std::string_view digits = text.substr(0, exponentAt);
  const std::size_t point = digits.find('.');
  if (point == std::string_view::npos || digits.find('/') != std::string_view::npos) return 0;
  const std::size_t places = digits.size() - point - 1;
  if (places > kMaxDigits) return 0;
  std::string unit = "5e-" + std::to_string(places + 1);
  Rational half = Rational::fromText(unit).value_or(Rational(0));
  if (exponentAt != std::string_view::npos) {
    const auto scale = Rational::fromText("1" + std::string(text.substr(exponentAt)));
    half *= scale.value_or(Rational(0));
  }
  return half;
}

}  // namespace

std::optional<WantedRatio> wantedRatio(std::string_view text, const std::optional<Rational>& tolerance) {
  const auto value = Rational::fromText(text);
  if (!value || value->sign() <= 0) return std::nullopt;
  WantedRatio wanted;
  wanted.text = text;
  wanted.value = *value;
  if (tolerance) {
    wanted.lowest = *value * (Rational(1) - *tolerance);
    wanted.highest = *value * (Rational(1) + *tolerance);
  } else {
    const Rational half = halfUnit(text);
    wanted.lowest = *value - half;
    wanted.highest = *value + half;
    wanted.isHighestIn = half.isZero();
  }
  if (wanted.lowest.sign() <= 0) return std::nullopt;
  return wanted;
}

}  // namespace geargraph

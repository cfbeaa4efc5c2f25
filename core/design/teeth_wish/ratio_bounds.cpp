#include "core/design/teeth_wish/ratio_bounds.h"

#include <string>

namespace geargraph {
namespace {

/// The unit of the last digit of "6.32e-1": 1/1000. std::nullopt for what is no decimal.
std::optional<Rational> lastDigitOf(std::string_view written) {
  const std::size_t point = written.find('.');
  if (point == std::string_view::npos || written.find('/') != std::string_view::npos) return std::nullopt;
  const std::size_t e = written.find_first_of("eE");
  const std::size_t decimals = (e == std::string_view::npos ? written.size() : e) - point - 1;
  const std::string exponent = e == std::string_view::npos ? "0" : std::string(written.substr(e + 1));
  const auto power = Rational::fromText("1e" + exponent);
  const auto places = Rational::fromText("1e-" + std::to_string(decimals));
  if (!power || !places) return std::nullopt;
  return *power * *places;
}

}  // namespace

RatioBounds boundsWithin(const Rational& ratio, const Rational& tolerance) {
  const Rational reach = ratio.abs() * tolerance;
  return {ratio, ratio - reach, ratio + reach, true};
}

RatioBounds boundsBetween(const Rational& low, const Rational& high) {
  return {(low + high) / Rational(2), low, high, true};
}

std::optional<RatioBounds> boundsOf(std::string_view written) {
  const auto ratio = Rational::fromText(written);
  if (!ratio || ratio->isZero()) return std::nullopt;
  const auto unit = lastDigitOf(written);
  if (!unit) return RatioBounds{*ratio, *ratio, *ratio, true};
  const Rational half = *unit / Rational(2);
  if (half >= ratio->abs()) return std::nullopt;
  return RatioBounds{*ratio, *ratio - half, *ratio + half, false};
}

}  // namespace geargraph

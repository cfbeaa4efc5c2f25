#include "core/mechanism/number.h"

#include <charconv>
#include <cmath>

#include "core/base/contract.h"

namespace geargraph {
namespace {

constexpr int kMostDecimals = 6;

/// "5", "0.125" where at most kMostDecimals decimals give the exact value, else "22/7".
std::string spelled(const Rational& exact) {
  if (exact.isInteger()) return exact.toString();
  Rational scaled = exact;
  for (int decimals = 1; decimals <= kMostDecimals; ++decimals) {
    scaled *= 10;
    if (!scaled.isInteger()) continue;
    std::string digits = scaled.abs().toString();
    const auto places = static_cast<std::size_t>(decimals);
    if (digits.size() <= places) digits.insert(0, places + 1 - digits.size(), '0');
    digits.insert(digits.size() - places, ".");
    return (exact.sign() < 0 ? "-" : "") + digits;
  }
  return exact.toString();
}

}  // namespace

Number::Number(Rational exact, std::string text)
    : m_exact(std::move(exact)), m_value(m_exact.toDouble()), m_text(std::move(text)) {}

Number::Number(std::int64_t whole) : Number(Rational(whole), std::to_string(whole)) {}

Number::Number(Rational exact)
    : m_exact(std::move(exact)), m_value(m_exact.toDouble()), m_text(spelled(m_exact)) {}

Number Number::fromDouble(double value) {
  GEARGRAPH_REQUIRE(std::isfinite(value));
  std::array<char, 32> buffer{};
  const auto [end, error] = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value);
  GEARGRAPH_REQUIRE(error == std::errc{});
  const auto number =
      fromText(std::string_view(buffer.data(), static_cast<std::size_t>(end - buffer.data())));
  GEARGRAPH_REQUIRE(number.has_value());
  return *number;
}

std::optional<Number> Number::fromText(std::string_view text) {
  auto exact = Rational::fromText(text);
  if (!exact) return std::nullopt;
  Number number(std::move(*exact), std::string(text));
  if (!std::isfinite(number.m_value)) return std::nullopt;
  return number;
}

}  // namespace geargraph

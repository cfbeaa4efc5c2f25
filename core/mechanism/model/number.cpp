#include "core/mechanism/model/number.h"

#include <charconv>
#include <cmath>

#include "core/foundations/base/contract.h"

namespace geargraph {
namespace {

constexpr int kMaxDecimals = 6;

/// "5", "0.125" where at most kMaxDecimals decimals give the exact value, else "22/7".
std::string spelled(const Rational& exact) {
  if (exact.isInteger()) return exact.toString();
  Rational scaled = exact;
  for (int decimals = 1; decimals <= kMaxDecimals; ++decimals) {
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

/// The shortest decimal that reads back as this double.
class ShortestDecimal {
 public:
  explicit ShortestDecimal(double value) {
    const auto [end, error] = std::to_chars(m_buffer.data(), m_buffer.data() + m_buffer.size(), value);
    GEARGRAPH_REQUIRE(error == std::errc{});
    m_size = static_cast<std::size_t>(end - m_buffer.data());
  }
  [[nodiscard]] std::string_view text() const { return {m_buffer.data(), m_size}; }

 private:
  std::array<char, 32> m_buffer{};
  std::size_t m_size = 0;
};

}  // namespace

// The text is read as `exact`; so where the double's own decimal is the same text, it has the same value.
Number::Number(const Rational& exact, std::string_view text) : m_value(exact.toDouble()) {
  if (std::isfinite(m_value) && text == ShortestDecimal(m_value).text()) return;
  m_written = std::make_unique<const Written>(Written{exact, std::string(text)});
}

Number::Number(std::int64_t whole) : Number(Rational(whole), std::to_string(whole)) {}

Number::Number(const Rational& exact) : Number(exact, spelled(exact)) {}

Number::Number(const Number& other) : m_value(other.m_value) {
  if (other.m_written) m_written = std::make_unique<const Written>(*other.m_written);
}

Number& Number::operator=(const Number& other) {
  return *this = Number(other);
}

Rational Number::exact() const {
  if (m_written) return m_written->exact;
  constexpr double kLargestWhole = 9007199254740992;  // 2^53
  if (std::abs(m_value) < kLargestWhole && m_value == std::trunc(m_value)) {
    return {static_cast<std::int64_t>(m_value)};
  }
  auto exact = Rational::fromText(ShortestDecimal(m_value).text());
  GEARGRAPH_REQUIRE(exact.has_value());
  return std::move(*exact);
}

std::string Number::text() const {
  return m_written ? m_written->text : std::string(ShortestDecimal(m_value).text());
}

Number Number::fromDouble(double value) {
  GEARGRAPH_REQUIRE(std::isfinite(value));
  const auto number = fromText(ShortestDecimal(value).text());
  GEARGRAPH_REQUIRE(number.has_value());
  return *number;
}

std::optional<Number> Number::fromText(std::string_view text) {
  const auto exact = Rational::fromText(text);
  if (!exact) return std::nullopt;
  Number number(*exact, text);
  if (!std::isfinite(number.m_value)) return std::nullopt;
  return number;
}

}  // namespace geargraph

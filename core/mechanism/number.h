#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "core/base/rational.h"

namespace geargraph {

/// A number of the document: its exact value, its nearest double, and the text it was written as, so that
/// saving a file gives back what its author wrote ("22/7", 0.10, 1e-3).
class Number {
 public:
  Number() : Number(0) {}
  Number(std::int64_t whole);       // NOLINT(google-explicit-constructor)
  explicit Number(Rational exact);  ///< written as a whole number, a short decimal or a fraction
  /// The exact value of the shortest decimal that reads back as this double. @pre finite
  [[nodiscard]] static Number fromDouble(double value);
  /// Keeps the text. Nothing where Rational::fromText gives nothing, or the value has no finite double.
  [[nodiscard]] static std::optional<Number> fromText(std::string_view text);

  [[nodiscard]] const Rational& exact() const { return m_exact; }
  [[nodiscard]] double value() const { return m_value; }
  [[nodiscard]] const std::string& text() const { return m_text; }
  /// Written with a slash: a JSON string in the file; otherwise a JSON number.
  [[nodiscard]] bool isFractionText() const { return m_text.find('/') != std::string::npos; }

  /// The same value; the spelling counts too, because a saved file shows it.
  friend bool operator==(const Number& a, const Number& b) {
    return a.m_text == b.m_text && a.m_exact == b.m_exact;
  }
  friend bool operator!=(const Number& a, const Number& b) { return !(a == b); }

 private:
  Number(Rational exact, std::string text);

  Rational m_exact;
  double m_value = 0;
  std::string m_text;
};

/// A point or direction in the base frame, x y z.
using NumberTriple = std::array<Number, 3>;

[[nodiscard]] inline bool isZero(const NumberTriple& triple) {
  return triple[0].exact().isZero() && triple[1].exact().isZero() && triple[2].exact().isZero();
}

}  // namespace geargraph

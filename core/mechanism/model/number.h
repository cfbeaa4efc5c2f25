#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "core/foundations/base/rational.h"

namespace geargraph {

/// A number of the document: its exact value, its nearest double, and its text, so that saving a file
/// preserves the spelling ("22/7", 0.10, 1e-3).
///
/// A document has thousands of them and every analysis reads them, so they are small: only a double if its
/// shortest decimal is the text, as for nearly all typed numbers; exact() and text() are then computed on
/// demand.
class Number {
 public:
  Number() = default;                      ///< 0
  Number(std::int64_t whole);              // NOLINT(google-explicit-constructor)
  explicit Number(const Rational& exact);  ///< written as a whole number, a short decimal or a fraction
  Number(const Number& other);
  Number(Number&& other) noexcept = default;
  Number& operator=(const Number& other);
  Number& operator=(Number&& other) noexcept = default;
  ~Number() = default;

  /// The exact value of the shortest decimal that reads back as this double. @pre finite
  [[nodiscard]] static Number fromDouble(double value);
  /// Keeps the text. std::nullopt if Rational::fromText() fails, or the value has no finite double.
  [[nodiscard]] static std::optional<Number> fromText(std::string_view text);

  [[nodiscard]] Rational exact() const;
  [[nodiscard]] double value() const { return m_value; }
  [[nodiscard]] std::string text() const;
  [[nodiscard]] bool isZero() const { return m_written ? m_written->exact.isZero() : m_value == 0; }
  /// Written with a slash: a JSON string in the file; otherwise a JSON number.
  [[nodiscard]] bool isFractionText() const {
    return m_written && m_written->text.find('/') != std::string::npos;
  }

  /// Equal value and equal spelling, because a saved file shows the spelling.
  friend bool operator==(const Number& a, const Number& b) {
    if (!a.m_written || !b.m_written) return !a.m_written && !b.m_written && a.m_value == b.m_value;
    return *a.m_written == *b.m_written;
  }
  friend bool operator!=(const Number& a, const Number& b) { return !(a == b); }

 private:
  struct Written {
    Rational exact;
    std::string text;
    friend bool operator==(const Written&, const Written&) = default;
  };

  Number(const Rational& exact, std::string_view text);

  double m_value = 0;
  std::unique_ptr<const Written> m_written;  ///< null if the double represents value and text
};

/// A point or direction in the base frame, x y z.
using NumberTriple = std::array<Number, 3>;

[[nodiscard]] inline bool isZero(const NumberTriple& triple) {
  return triple[0].isZero() && triple[1].isZero() && triple[2].isZero();
}

}  // namespace geargraph

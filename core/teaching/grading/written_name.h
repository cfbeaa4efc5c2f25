#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace geargraph {

/// A parsed symbol, independent of its notation: \omega_{51}'', ω₅₁'' and w51'' are {"w", "51", 2}.
struct WrittenName {
  std::string base;       ///< i n N d theta w
  std::string subscript;  ///< digits; two numbers are separated by '_'
  int primes = 0;
};

/// The text with signs, Greek letters and LaTeX commands in the plain notation of the parsers.
[[nodiscard]] std::string plainNotation(std::string_view text);

/// Reads a symbol at `at` of a text in plain notation and moves past it: "i15", "n_{41}", "n15,1", "N7''".
[[nodiscard]] std::optional<WrittenName> nameAt(const std::string& text, std::size_t& at);

}  // namespace geargraph

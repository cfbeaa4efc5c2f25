#pragma once

#include <optional>
#include <string_view>

#include "core/foundations/base/rational.h"

namespace geargraph {

/// The exact value of an expression of numbers as Rational::fromText() reads them, with + - * / ^,
/// parentheses and blanks: "2*3", "1/3+1/5", "-(100/22)^2"; × · ÷ and the Unicode minus sign are accepted
/// too. Powers are whole numbers and bind more tightly than a sign. std::nullopt for anything else: a
/// division by 0, nesting deeper than 64, an exponent beyond ±1,000, and a result of more than some 15,000
/// digits.
[[nodiscard]] std::optional<Rational> arithmeticFromText(std::string_view text);

}  // namespace geargraph

#pragma once

#include <string>
#include <string_view>

namespace geargraph {

/// A formula in the TeX that core writes as MathML Core, what goes between <math> and </math>. Understood are
/// letters, numbers, signs, sub- and superscripts, primes; \frac \dot \hat, Greek letters and signs by name,
/// \left[ \right] and ( ); array (with bars and \hline), pmatrix, aligned. Rules of arrays are classes:
/// "bar" left of a cell, "rule" above it.
/// @pre the formula uses no others: it is the program's own
/// Cost: linear in its length.
[[nodiscard]] std::string mathMl(std::string_view tex);

}  // namespace geargraph

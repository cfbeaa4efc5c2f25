#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "core/presentation/typeset/formula.h"

namespace geargraph::inline typeset {

/// A formula, and what kept its text from being read.
struct ReadFormula {
  FormulaNode formula;     ///< a row; the whole elements before the fault
  std::string fault = {};  ///< a sentence, empty where all of it was read
};

/// Reads the TeX that core writes. Understood are letters, numbers, signs, sub- and superscripts, primes;
/// \frac \dot \ddot \hat, Greek letters and signs by name; \quad and \,; \left[ \right] and ( ); array (with
/// bars and \hline), pmatrix, aligned, nested up to 100 deep. Anything else is a fault. What is read can be
/// set, with a fault or without. Cost: linear in its length.
[[nodiscard]] ReadFormula readTex(std::string_view tex);

/// @pre the formula can be read: it is the program's own
[[nodiscard]] FormulaNode formulaOf(std::string_view tex);

}  // namespace geargraph::inline typeset

#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "core/presentation/typeset/formula.h"

namespace geargraph {

/// A parsed formula, and the error if it could not be parsed completely.
struct ReadFormula {
  FormulaNode formula;     ///< a row; on an error the complete elements before it
  std::string fault = {};  ///< a sentence; empty on success
};

/// Parses the subset of TeX that core writes: letters, numbers, signs, sub- and superscripts, primes; \frac
/// \dot \ddot \hat, Greek letters and signs by name; \quad and \,; \left[ \right] and ( ); array (with bars
/// and \hline), pmatrix, aligned, nested up to 100 levels. Anything else is an error. The parsed formula can
/// always be typeset. Cost: linear in its length.
[[nodiscard]] ReadFormula readTex(std::string_view tex);

/// @pre the formula is in that subset: it is the program's own
[[nodiscard]] FormulaNode formulaOf(std::string_view tex);

}  // namespace geargraph

#pragma once

#include <vector>

#include "core/foundations/base/expected.h"
#include "core/teaching/paper_check/vocabulary.h"
#include "core/teaching/paper_check/written_paper.h"

namespace geargraph::inline paper_check {

/// A number as the user writes it: with ratios as symbols, teeth and diameters as numbers.
struct WrittenAmount {
  RationalFunction value;
  bool hasRatios = false;   ///< i15, n41
  bool hasNumbers = false;  ///< other than 0 and 1, or teeth, diameters: meant for this mechanism's numbers
  Rational slack = 0;       ///< of decimals: how far the value may be from the true one
};

/// amount + the sum of each coefficient times its velocity, in the order in which they are written.
struct WrittenFormula {
  struct Term {
    WrittenName name;
    RateSum rates;
    WrittenAmount coefficient;
  };
  WrittenAmount amount;
  std::vector<Term> terms;
};

/// Reads sums, products, quotients and whole powers of numbers and names, in plain text, Unicode or LaTeX:
/// "-i_{18} i_{17}", "-\frac{N_4}{N_1}", "n41*(w40 - w20)", "0,75". Velocities may be added and multiplied
/// by numbers.
///
/// Errors are `syntax` with the place of the cell. Cost: linear in the text, times that of the functions.
[[nodiscard]] Expected<WrittenFormula> readFormula(const Vocabulary& vocabulary, const WrittenCell& cell);
/// The same without velocities.
[[nodiscard]] Expected<WrittenAmount> readAmount(const Vocabulary& vocabulary, const WrittenCell& cell);

/// The name that a label or a symbol is; nothing where the text is none.
[[nodiscard]] std::optional<WrittenName> readName(const std::string& text);

/// The signs, Greek letters and commands of print and LaTeX as the readers take them.
[[nodiscard]] std::string plainNotation(std::string_view text);

}  // namespace geargraph::inline paper_check

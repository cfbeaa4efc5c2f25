#pragma once

#include <vector>

#include "core/foundations/base/expected.h"
#include "core/teaching/work_check/submitted_text.h"
#include "core/teaching/work_check/vocabulary.h"

namespace geargraph {

/// A number in the user's notation: with ratios as symbols, teeth and diameters as numbers.
struct WrittenAmount {
  RationalFunction value;
  bool hasRatios = false;   ///< i15, n41
  bool hasNumbers = false;  ///< other than 0 and 1, or teeth, diameters: specific to this mechanism
  Rational slack = 0;       ///< tolerance of decimals
};

/// amount + the sum of each coefficient times its velocity, in written order.
struct WrittenFormula {
  struct Term {
    WrittenName name;
    RateSum rates;
    WrittenAmount coefficient;
  };
  WrittenAmount amount;
  std::vector<Term> terms;
};

/// Parses sums, products, quotients and whole powers of numbers and names, in plain text, Unicode or LaTeX:
/// "-i_{18} i_{17}", "-\frac{N_4}{N_1}", "n41*(w40 - w20)", "0,75". Velocities may be added and multiplied by
/// numbers.
///
/// Fails with `syntax` at the place of the cell. Cost: linear in the text, times that of the functions.
[[nodiscard]] Expected<WrittenFormula> readFormula(const Vocabulary& vocabulary, const WrittenCell& cell);
/// The same without velocities.
[[nodiscard]] Expected<WrittenAmount> readAmount(const Vocabulary& vocabulary, const WrittenCell& cell);

/// Parses a label or a symbol; std::nullopt if the text is none.
[[nodiscard]] std::optional<WrittenName> readName(const std::string& text);

}  // namespace geargraph

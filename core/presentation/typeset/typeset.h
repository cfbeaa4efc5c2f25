#pragma once

#include <vector>

#include "core/presentation/typeset/formula.h"
#include "core/presentation/typeset/formula_box.h"

namespace geargraph {

/// TeX's text and display style: fractions are small in a sentence.
enum class FormulaPlace { inLine, ownLine };

/// Typesets a formula with the spaces, shifts and sizes of TeX. A table with labels in its first row and
/// column (isLabelled()) is set as a matrix in brackets with the labels outside, and its other bars are
/// dashed. Cost: linear in the formula, times its depth.
[[nodiscard]] FormulaBox typesetFormula(const FormulaNode& formula, FormulaPlace place);

/// A line of a formula, and the row of "aligned" that it belongs to.
struct FormulaLine {
  FormulaBox box;
  std::size_t row = 0;
};

/// A displayed formula as lines: those of `aligned`, broken further if wider than `width` (em). Lines break
/// before a relation, a plus or minus sign or a growing bracket, and continue indented; a labelled matrix at
/// the end of the formula is split into parts of equally many columns, with open brackets in between. All
/// lines share one left edge. A line without a break point stays wider.
[[nodiscard]] std::vector<FormulaLine> typesetLines(const FormulaNode& formula, double width);

/// The widest line.
[[nodiscard]] double widthOf(const std::vector<FormulaLine>& lines);

}  // namespace geargraph

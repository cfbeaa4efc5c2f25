#pragma once

#include <vector>

#include "core/presentation/typeset/formula.h"
#include "core/presentation/typeset/formula_box.h"

namespace geargraph::inline typeset {

/// Within a sentence fractions are small, on a line of its own they are not.
enum class FormulaPlace { inLine, ownLine };

/// Sets a formula with the spaces, shifts and sizes of TeX. A table whose first row and column are parted
/// from the rest is set as a matrix between brackets with its labels outside of them, and its other bars are
/// dashed. Cost: linear in the formula, times its depth.
[[nodiscard]] FormulaBox typesetFormula(const FormulaNode& formula, FormulaPlace place);

/// A line of a formula, and which one of "aligned" it belongs to.
struct FormulaLine {
  FormulaBox box;
  std::size_t row = 0;
};

/// A formula on lines of its own: those of `aligned`, and more where one is wider than `width` (em). Lines
/// break before a relation, a plus or minus sign or a bracket that grows, and go on indented; a matrix with
/// labels that is the last of its formula becomes parts of as many columns each, with the bracket open where
/// they go on. All lines stand as they are to one left edge. Where nothing breaks a line stays wider.
[[nodiscard]] std::vector<FormulaLine> typesetLines(const FormulaNode& formula, double width);

/// The widest line.
[[nodiscard]] double widthOf(const std::vector<FormulaLine>& lines);

}  // namespace geargraph::inline typeset

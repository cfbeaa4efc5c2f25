#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace geargraph {

enum class FormulaKind {
  row,       ///< parts side by side; as a part of another row: the content of braces
  number,    ///< text: digits and a point
  letter,    ///< text: one letter, Latin or Greek, or the name of a function
  sign,      ///< text: one sign, or primes
  negative,  ///< the unary minus sign
  scripts,   ///< parts: the base; below and above: at most one each
  fraction,  ///< parts: above the bar, below it
  accent,    ///< parts: the base; text: the accent
  space,     ///< width; text: the width with its unit
  fenced,    ///< parts: a row; text: the brackets before and after it
  table,     ///< cells
};

enum class FormulaTableKind { array, brackets, aligned };

/// A formula as a tree, from which MathML and typeset boxes are made. A regular value.
struct FormulaNode {
  FormulaKind kind = FormulaKind::row;
  std::string text = {};  ///< UTF-8
  double width = 0;       ///< of a space, em
  std::vector<FormulaNode> parts = {};
  std::vector<FormulaNode> below = {};
  std::vector<FormulaNode> above = {};

  // Of tables.
  FormulaTableKind table = FormulaTableKind::array;
  std::string alignment = {};                        ///< l, c or r by column, as far as given
  std::vector<char> bars = {};                       ///< by column: a bar left of it
  std::vector<char> rules = {};                      ///< by row: a line above it
  std::vector<std::vector<FormulaNode>> cells = {};  ///< by row: rows of a formula
  bool opens = true, closes = true;  ///< for a part of a matrix: has it the left, the right bracket?

  /// Are the first row and the first column labels?
  [[nodiscard]] bool isLabelled() const {
    return table == FormulaTableKind::array && hasBar(1) && hasRule(1) && cells.size() > 1;
  }
  /// The alignment of a column: l, c or r.
  [[nodiscard]] char alignmentOf(std::size_t column) const;
  [[nodiscard]] bool hasBar(std::size_t column) const { return column < bars.size() && bars[column] != 0; }
  [[nodiscard]] bool hasRule(std::size_t row) const { return row < rules.size() && rules[row] != 0; }

  friend bool operator==(const FormulaNode&, const FormulaNode&) = default;
};

}  // namespace geargraph

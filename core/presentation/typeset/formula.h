#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace geargraph::inline typeset {

enum class FormulaKind {
  row,       ///< parts beside one another; as a part of another row: what braces hold
  number,    ///< text: digits and a point
  letter,    ///< text: one letter, Latin or Greek
  sign,      ///< text: one sign, or primes
  negative,  ///< the minus sign of what follows
  scripts,   ///< parts: the base; below and above: one each, or none
  fraction,  ///< parts: above the bar, below it
  accent,    ///< parts: what it stands on; text: the accent
  space,     ///< width; text: the width with its unit
  fenced,    ///< parts: a row; text: the bracket before it and the one behind it
  table,     ///< cells
};

enum class FormulaTableKind { array, brackets, aligned };

/// A formula as a tree: what MathML and the typesetter are made of. A regular value.
struct FormulaNode {
  FormulaKind kind = FormulaKind::row;
  std::string text = {};  ///< UTF-8
  double width = 0;       ///< of a space, em
  std::vector<FormulaNode> parts = {};
  std::vector<FormulaNode> below = {};
  std::vector<FormulaNode> above = {};

  // Of tables.
  FormulaTableKind table = FormulaTableKind::array;
  std::string alignment = {};                        ///< l, c or r by column, as far as it was said
  std::vector<char> bars = {};                       ///< by column: a bar left of it
  std::vector<char> rules = {};                      ///< by row: a line above it
  std::vector<std::vector<FormulaNode>> cells = {};  ///< by row: rows of a formula
  bool opens = true, closes = true;  ///< of a part of a matrix: has it the left, the right bracket?

  /// Are the first row and column labels?
  [[nodiscard]] bool isLabelled() const {
    return table == FormulaTableKind::array && hasBar(1) && hasRule(1) && cells.size() > 1;
  }
  /// l, c or r.
  [[nodiscard]] char alignmentOf(std::size_t column) const;
  [[nodiscard]] bool hasBar(std::size_t column) const { return column < bars.size() && bars[column] != 0; }
  [[nodiscard]] bool hasRule(std::size_t row) const { return row < rules.size() && rules[row] != 0; }

  friend bool operator==(const FormulaNode&, const FormulaNode&) = default;
};

}  // namespace geargraph::inline typeset

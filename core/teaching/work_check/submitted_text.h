#pragma once

#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "core/foundations/base/expected.h"

namespace geargraph {

constexpr std::size_t kLargestPaper = 1'000'000;  ///< bytes

/// A piece of the user's text with its line and column, counted from 1, columns in characters.
struct WrittenCell {
  std::string text;
  int line = 1;
  int column = 1;
};

/// A matrix as written: rows of one length, with the labels separated, if there are any.
struct WrittenTable {
  std::string name;  ///< "C" of "C = [...]"; may be empty
  std::vector<std::vector<WrittenCell>> cells;
  std::vector<WrittenCell> rowLabels;     ///< one per row, or none
  std::vector<WrittenCell> columnLabels;  ///< one per column, or none

  [[nodiscard]] int rows() const { return static_cast<int>(cells.size()); }
  [[nodiscard]] int columns() const { return cells.empty() ? 0 : static_cast<int>(cells.front().size()); }
};

/// "a = b = c": the sides of an equation, at least two.
struct WrittenEquation {
  std::vector<WrittenCell> sides;
};

using WrittenPaper = std::variant<WrittenTable, std::vector<WrittenEquation>>;

/// Parses a matrix in CSV (commas, semicolons, tabs, blanks or bars), LaTeX (matrix and array environments,
/// also between the vectors of an equation, which then give the labels), MATLAB or NumPy, as written by this
/// program or by hand; or equations, one per line, in plain text or LaTeX.
///
/// Fails with `syntax` with line and column: no text, a row of another length, a bracket that is not closed.
/// Cost: linear in the text.
[[nodiscard]] Expected<WrittenPaper> readPaper(std::string_view text);

/// Is the text of a cell a label (of a row, a link, a rate, or empty) rather than an entry?
[[nodiscard]] bool isLabelText(std::string_view text);

}  // namespace geargraph

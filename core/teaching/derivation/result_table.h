#pragma once

#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "core/foundations/base/rational.h"
#include "core/mechanism/graph/integer_matrix.h"
#include "core/teaching/derivation/cell_explanation.h"

namespace geargraph {

struct NamedResult;
struct ValueTable;

/// The form of the entries of a result.
enum class EntryForm { decimals, fractions, symbols };

/// One entry that is not 0.
struct ResultEntry {
  int column = 0;
  std::string text;  ///< "-15/2", "-i18*i17", "0.707107"; "≈ 0.707107": no fraction
  std::string latex;
  double value = 0;
  bool isFormula = false;  ///< in the gear ratios
};

/// An entry that is not 0, as a number.
struct ResultValue {
  int column = 0;
  double value = 0;
};

/// A result as a table with labels: an immutable value whose rows are computed on demand. All that is written
/// and shown of results is made of this (result_text.h).
class ResultTable {
 public:
  virtual ~ResultTable() = default;
  ResultTable(const ResultTable&) = delete;
  ResultTable& operator=(const ResultTable&) = delete;

  /// Its entry in the catalogue: name, symbol, definition.
  [[nodiscard]] const NamedResult& result() const { return m_result; }
  [[nodiscard]] EntryForm form() const { return m_form; }
  [[nodiscard]] virtual int rows() const = 0;
  [[nodiscard]] virtual int columns() const = 0;
  /// `element` of a heading is empty if nothing is highlighted with it (the components of a screw).
  [[nodiscard]] virtual Heading rowHeading(int row) const = 0;
  [[nodiscard]] virtual Heading columnHeading(int column) const = 0;
  /// The non-zeros by column. Cost: O(length of the cycle), for a solution O(inputs).
  [[nodiscard]] virtual std::vector<ResultEntry> row(int row) const = 0;
  /// The same without texts, for what reads millions of them.
  [[nodiscard]] virtual std::vector<ResultValue> values(int row) const;
  /// The elements that a row is about: that of its heading, unless a table knows more.
  [[nodiscard]] virtual std::set<ElementId> elementsOfRow(int row) const;
  /// The elements to highlight for a cell: those of its row and, where the headings are rates, that of its
  /// column, unless a table knows more.
  [[nodiscard]] virtual std::set<ElementId> elementsOfCell(int row, int column) const;
  /// What the entry means; row, column and value with the definition of the result, unless a table knows
  /// more.
  [[nodiscard]] virtual CellExplanation explanation(int row, int column) const;
  /// The first column after the dashed line.
  [[nodiscard]] virtual std::optional<int> partition() const { return std::nullopt; }
  /// Do the headings name rates (θ̇8) rather than elements?
  [[nodiscard]] virtual bool headsAreRates() const { return false; }
  /// The matrix of the digraph that this is a table of, for what looks at millions of entries; else null.
  [[nodiscard]] virtual IntegerMatrixPtr integers() const { return nullptr; }
  /// The records that this is a table of: texts and numbers, with head, unit and definition of each column.
  /// They have no labels of rows. Null for a table of numbers.
  [[nodiscard]] virtual const ValueTable* records() const { return nullptr; }
  /// The entry at a position; std::nullopt for a zero. Cost: that of row().
  [[nodiscard]] std::optional<ResultEntry> entry(int row, int column) const;

 protected:
  /// `result` lives longer than the table.
  ResultTable(const NamedResult& result, EntryForm form) : m_result(result), m_form(form) {}

 private:
  const NamedResult& m_result;
  EntryForm m_form;
};

using ResultTablePtr = std::shared_ptr<const ResultTable>;

[[nodiscard]] ResultEntry decimalEntry(int column, double value);
[[nodiscard]] ResultEntry fractionEntry(int column, const Rational& value);
/// For an irrational value that was requested as a fraction.
[[nodiscard]] ResultEntry irrationalEntry(int column, double value);

/// "-15/2" as "-\frac{15}{2}".
[[nodiscard]] std::string latexOf(const Rational& value);
/// The same for people: about six digits in place of a long fraction.
[[nodiscard]] std::string readableLatex(const Rational& value);
[[nodiscard]] std::string readableLatex(const ResultEntry& entry);
/// The value with about six digits, for the screen.
[[nodiscard]] std::string shortDecimal(double value);

}  // namespace geargraph

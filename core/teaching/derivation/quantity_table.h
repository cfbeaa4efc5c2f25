#pragma once

#include <memory>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "core/foundations/files/byte_sink.h"
#include "core/teaching/derivation/cell_explanation.h"
#include "core/theory/analysis/analysis.h"

namespace geargraph {
struct CsvOptions;
}  // namespace geargraph

namespace geargraph {

/// The quantities of both methods other than the matrices of the digraph.
enum class QuantityKind {
  screws,        ///< û of every joint of every cycle [AU, Eqs. (6)-(12)]
  coefficients,  ///< P [AU, Eqs. (17)-(20), (24)]
  solution,      ///< the outputs over the inputs [AU, Eqs. (22), (23), (25)]
  ttCircuits,    ///< B = [B_t | U], the f-circuits of the T-T graph [AU, Eqs. (31)-(38)]
  ttCutsets,     ///< Q' = [U | -B_t^T], its f-cutsets: the equations of its statics
};

/// The form of the entries of a quantity.
enum class EntryForm { decimals, fractions, symbols };

[[nodiscard]] const std::vector<QuantityKind>& allQuantityKinds();
[[nodiscard]] std::string_view quantitySymbol(QuantityKind kind);  ///< "û", "P", "θ̇", "B", "Q′"
[[nodiscard]] std::string_view quantityTitle(QuantityKind kind);
/// The paper's equation that prints the quantity in this form: P in numbers (19), in gear ratios (24).
[[nodiscard]] PaperEquation quantityEquation(QuantityKind kind, EntryForm form);
[[nodiscard]] std::string_view quantityCommandName(
    QuantityKind kind);  ///< "screw", "p", "solution", "tt-circuits", "tt-cutsets"
[[nodiscard]] std::string_view quantityAsciiName(QuantityKind kind);  ///< "U", "P", "S": for programs

/// One entry that is not 0.
struct QuantityEntry {
  int column = 0;
  std::string text;  ///< "-15/2", "-i18*i17", "0.707107"; "≈ 0.707107": no fraction
  std::string latex;
  double value = 0;
  bool isFormula = false;  ///< in the gear ratios
};

/// A quantity as a table with labels: an immutable value whose rows are computed on demand.
class QuantityTable {
 public:
  virtual ~QuantityTable() = default;
  QuantityTable(const QuantityTable&) = delete;
  QuantityTable& operator=(const QuantityTable&) = delete;

  [[nodiscard]] QuantityKind kind() const { return m_kind; }
  [[nodiscard]] EntryForm form() const { return m_form; }
  [[nodiscard]] virtual int rows() const = 0;
  [[nodiscard]] virtual int columns() const = 0;
  /// `element` of a heading is empty if nothing is highlighted with it (the components of a screw).
  [[nodiscard]] virtual Heading rowHeading(int row) const = 0;
  [[nodiscard]] virtual Heading columnHeading(int column) const = 0;
  /// The non-zeros by column. Cost: O(length of the cycle), for a solution O(inputs).
  [[nodiscard]] virtual std::vector<QuantityEntry> row(int row) const = 0;
  /// The elements that a row is about.
  [[nodiscard]] virtual std::set<ElementId> elementsOfRow(int row) const = 0;
  [[nodiscard]] virtual CellExplanation explanation(int row, int column) const = 0;
  /// The first column after the dashed line.
  [[nodiscard]] virtual std::optional<int> partition() const { return std::nullopt; }
  /// Do the headings name rates (θ̇8) rather than elements?
  [[nodiscard]] virtual bool headsAreRates() const { return false; }
  /// The entry at a position; std::nullopt for a zero. Cost: that of row().
  [[nodiscard]] std::optional<QuantityEntry> entry(int row, int column) const;

 protected:
  QuantityTable(QuantityKind kind, EntryForm form) : m_kind(kind), m_form(form) {}

 private:
  QuantityKind m_kind;
  EntryForm m_form;
};

using QuantityTablePtr = std::shared_ptr<const QuantityTable>;

/// The forms available in this snapshot: symbols only if they were solved within their budget, fractions of a
/// solution only with the exact part. Empty if the quantity is undefined.
[[nodiscard]] std::vector<EntryForm> formsOf(const AnalysisSnapshot& snapshot, QuantityKind kind);

/// The table; null if the snapshot does not have it in this form.
[[nodiscard]] QuantityTablePtr quantityTable(const SnapshotPtr& snapshot, QuantityKind kind, EntryForm form);

// As text for other programs, with the labels, in the formats of matrix_text.h; symbols as formulas.
// Cost: O(rows * columns).
[[nodiscard]] std::string quantityTsv(const QuantityTable& table);
[[nodiscard]] std::string quantityCsv(const QuantityTable& table);
/// The same row by row, until the sink fails. Texts that contain the separator are quoted; the decimal point
/// of the options applies to decimals, not to symbols and fractions.
void writeQuantityCsv(ByteSink& sink, const QuantityTable& table, const CsvOptions& options);
[[nodiscard]] std::string quantityLatex(const QuantityTable& table);
/// The same for people: about six digits in place of a long fraction.
[[nodiscard]] std::string readableLatex(const QuantityTable& table);
[[nodiscard]] std::string quantityMatlab(const QuantityTable& table);
[[nodiscard]] std::string quantityNumpy(const QuantityTable& table);

/// "-15/2" as "-\frac{15}{2}".
[[nodiscard]] std::string latexOf(const Rational& value);
/// The same for people: about six digits in place of a long fraction.
[[nodiscard]] std::string readableLatex(const Rational& value);
[[nodiscard]] std::string readableLatex(const QuantityEntry& entry);
/// The value with about six digits, for the screen.
[[nodiscard]] std::string shortDecimal(double value);

}  // namespace geargraph

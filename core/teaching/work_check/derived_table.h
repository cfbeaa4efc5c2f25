#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/mechanism/graph/paper_equation.h"
#include "core/teaching/work_check/written_formula.h"

namespace geargraph {

/// The matrices against which a user's text is checked, in the order of the derivation.
enum class PaperMatrix {
  incidence,
  reducedIncidence,
  path,
  spanningTree,
  cycleBasis,
  cutset,
  coefficients,
  solution,
};

[[nodiscard]] const std::vector<PaperMatrix>& allPaperMatrices();
[[nodiscard]] std::string_view paperMatrixName(PaperMatrix kind);    ///< "cycle-basis", as `export --matrix`
[[nodiscard]] std::string_view paperMatrixSymbol(PaperMatrix kind);  ///< "C"
[[nodiscard]] std::string_view paperMatrixTitle(PaperMatrix kind);   ///< "Cycle-basis matrix"
[[nodiscard]] std::optional<PaperMatrix> paperMatrixFromName(std::string_view name);
[[nodiscard]] PaperEquation paperMatrixEquation(PaperMatrix kind);

/// In what two correct forms of a row may differ.
enum class RowFreedom {
  none,
  sign,      ///< a cycle may be walked the other way
  multiple,  ///< an equation may be multiplied by any number but 0
};
[[nodiscard]] RowFreedom rowFreedom(PaperMatrix kind);

/// A derived entry: as a function of the ratios, and its value for these teeth.
struct DerivedEntry {
  RationalFunction function;
  Rational value;
  bool hasFunction = true;  ///< false if the formula exceeded its budget

  [[nodiscard]] DerivedEntry negated() const { return {-function, -value, hasFunction}; }
};

/// A derived matrix with its labels: the right one, or one with a known mistake.
struct DerivedTable {
  PaperMatrix kind = PaperMatrix::incidence;
  std::vector<Heading> rows;
  std::vector<Heading> columns;
  std::vector<std::vector<DerivedEntry>> entries;

  [[nodiscard]] int height() const { return static_cast<int>(rows.size()); }
  [[nodiscard]] int width() const { return static_cast<int>(columns.size()); }
  [[nodiscard]] DerivedTable transposed() const;
};

/// std::nullopt if the mechanism has no such matrix: its turning joints are no spanning tree, or a mesh has
/// no geometry. P is in ratios with the head's gear at 1, Eq. (24), its joints in the order of labels; the
/// solution has the outputs by label and the inputs in the order of the document, Eq. (25).
/// Cost: that of the matrix; of the solution one in symbols.
[[nodiscard]] std::optional<DerivedTable> derivedTable(const Vocabulary& vocabulary, PaperMatrix kind);

/// The entry as printed: "-1", "-i16*i15".
[[nodiscard]] std::string entryText(const DerivedEntry& entry);

/// Does the written amount equal this entry? forTheseTeeth: the numbers agree, but the formulas do not, and
/// no mesh is redundant.
enum class TableAgreement { none, forTheseTeeth, full };  // ascending
[[nodiscard]] TableAgreement agreementOf(const Vocabulary& vocabulary, const WrittenAmount& written,
                                         const DerivedEntry& derived);

}  // namespace geargraph

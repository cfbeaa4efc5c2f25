// What differs in a row, a column or an entry, by name.

#include <algorithm>

#include "core/foundations/base/translation.h"
#include "core/teaching/derivation/cell_explanation.h"
#include "core/teaching/exercises/pair_teaching.h"
#include "core/teaching/work_check/table_mistakes.h"

namespace geargraph {
namespace {

constexpr const char* kMinus = "\u2212";

std::string printed(const DerivedEntry& entry) {
  std::string text = entryText(entry);
  if (text.starts_with('-')) text.replace(0, 1, kMinus);
  return text;
}

/// A known mistake in one row, as the row then reads.
struct MistakenRow {
  std::string name;
  std::string reason;
  std::vector<DerivedEntry> entries;  ///< in derived order
  std::vector<ElementId> elements;
};

class TableDifferences {
 public:
  TableDifferences(const Vocabulary& vocabulary, const DerivedTable& right, const WrittenAmounts& written,
                   const Alignment& alignment)
      : m_vocabulary(vocabulary),
        m_source(vocabulary.source()),
        m_right(right),
        m_written(written),
        m_alignment(alignment),
        m_freedom(rowFreedom(right.kind)) {
    for (std::size_t i = 0; i < written.size(); ++i) {
      const std::vector<DerivedEntry> expected =
          scaledRow(vocabulary, written[i], derivedRow(i), m_freedom, alignment.columns);
      auto& agreements = m_agreements.emplace_back();
      for (std::size_t k = 0; k < expected.size(); ++k) {
        // Also a multiple of an entry that is right in lowest terms agrees.
        agreements.push_back(agreementOf(vocabulary, written[i][k], expected[k]));
      }
      m_expected.push_back(expected);
    }
  }

  std::vector<WorkDifference> all() {
    addColumns();
    for (std::size_t row = 0; row < m_written.size(); ++row) addRow(row);
    return std::move(m_all);
  }

 private:
  [[nodiscard]] const std::vector<DerivedEntry>& derivedRow(std::size_t row) const {
    return m_right.entries[static_cast<std::size_t>(m_alignment.rows[row])];
  }
  [[nodiscard]] bool differs(std::size_t row, std::size_t column) const {
    return m_agreements[row][column] != TableAgreement::full;
  }
  [[nodiscard]] const Heading& rowHeading(std::size_t row) const {
    return m_right.rows[static_cast<std::size_t>(m_alignment.rows[row])];
  }
  [[nodiscard]] const Heading& columnHeading(std::size_t column) const {
    return m_right.columns[static_cast<std::size_t>(m_alignment.columns[column])];
  }

  /// Does the whole column read like this?
  [[nodiscard]] bool columnReads(std::size_t column, int derived, bool isNegative) const {
    for (std::size_t row = 0; row < m_written.size(); ++row) {
      DerivedEntry entry = derivedRow(row)[static_cast<std::size_t>(derived)];
      if (isNegative) entry = entry.negated();
      if (agreementOf(m_vocabulary, m_written[row][column], entry) != TableAgreement::full) return false;
    }
    return true;
  }

  void addColumn(std::size_t column, std::string name, std::string reason, std::vector<ElementId> elements) {
    WorkDifference difference{std::move(name), {}, std::move(elements), std::move(reason)};
    for (std::size_t row = 0; row < m_written.size(); ++row) {
      if (!differs(row, column)) continue;
      difference.entries.push_back({static_cast<int>(row), static_cast<int>(column)});
      m_agreements[row][column] = TableAgreement::full;  // explained
    }
    m_all.push_back(std::move(difference));
  }

  /// Arrows turned round, and the walks of other links.
  void addColumns() {
    const bool isIncidence =
        m_right.kind == PaperMatrix::incidence || m_right.kind == PaperMatrix::reducedIncidence;
    const bool isPath = m_right.kind == PaperMatrix::path;
    for (std::size_t column = 0; column < m_alignment.columns.size() && (isIncidence || isPath); ++column) {
      if (columnReads(column, m_alignment.columns[column], false)) continue;
      const Heading& heading = columnHeading(column);
      if (isIncidence && columnReads(column, m_alignment.columns[column], true)) {
        addColumn(column, "arrow-reversed", arrowText(heading.text, m_alignment.columns[column]),
                  {heading.element});
      }
      for (int other = 0; other < m_right.width() && isPath; ++other) {
        const Heading& of = m_right.columns[static_cast<std::size_t>(other)];
        if (other == m_alignment.columns[column] || !columnReads(column, other, false)) continue;
        addColumn(column, "another-link",
                  translated("This is the walk of link %1, not of link %2.", {of.text, heading.text}),
                  {heading.element, of.element});
        break;
      }
    }
  }

  [[nodiscard]] std::string arrowText(const std::string& name, int edge) const {
    const DigraphEdge& ends = m_source.graph().edge(edge);
    return translated("You turn the arrow of edge %1 round: it points from link %2 to link %3.",
                      {name, m_source.linkLabel(ends.tail), m_source.linkLabel(ends.head)});
  }

  void addRow(std::size_t row) {
    std::vector<EntryPlace> places;
    for (std::size_t column = 0; column < m_written[row].size(); ++column) {
      if (differs(row, column)) places.push_back({static_cast<int>(row), static_cast<int>(column)});
    }
    if (places.empty()) return;
    const bool isWrong = std::any_of(places.begin(), places.end(), [&](const EntryPlace& place) {
      return m_agreements[row][static_cast<std::size_t>(place.column)] == TableAgreement::none;
    });
    if (!isWrong) {
      m_all.push_back({"another-ratio-symbol", places,
                       elementsOf(m_right, m_alignment.rows[row],
                                  m_alignment.columns[static_cast<std::size_t>(places.front().column)]),
                       translated("The number is right for these teeth and the formula is not: it holds "
                                  "another mesh's ratio.")});
      return;
    }
    for (MistakenRow& mistaken : mistakenRows(row)) {
      if (!reads(row, mistaken.entries)) continue;
      m_all.push_back(
          {std::move(mistaken.name), places, std::move(mistaken.elements), std::move(mistaken.reason)});
      return;
    }
    for (const EntryPlace& place : places) addEntry(place);
  }

  [[nodiscard]] bool reads(std::size_t row, const std::vector<DerivedEntry>& entries) const {
    const std::vector<DerivedEntry> scaled =
        scaledRow(m_vocabulary, m_written[row], entries, m_freedom, m_alignment.columns);
    for (std::size_t k = 0; k < scaled.size(); ++k) {
      if (agreementOf(m_vocabulary, m_written[row][k], scaled[k]) != TableAgreement::full) return false;
    }
    return std::any_of(m_written[row].begin(), m_written[row].end(),
                       [](const WrittenAmount& w) { return !w.value.isZero(); });
  }

  [[nodiscard]] std::vector<MistakenRow> mistakenRows(std::size_t row) const {
    std::vector<MistakenRow> rows;
    const int own = m_alignment.rows[row];
    if (m_right.kind == PaperMatrix::coefficients) addCoefficientRows(own, rows);
    if (m_right.kind == PaperMatrix::solution) addSolutionRows(own, rows);
    if (m_right.kind == PaperMatrix::cutset) addCutsetRow(own, rows);
    if (m_right.kind == PaperMatrix::incidence || m_right.kind == PaperMatrix::reducedIncidence) return rows;
    const bool isCycle = m_right.kind == PaperMatrix::spanningTree ||
                         m_right.kind == PaperMatrix::cycleBasis || m_right.kind == PaperMatrix::coefficients;
    const char* const name = isCycle                                 ? "another-cycle"
                             : m_right.kind == PaperMatrix::solution ? "another-output"
                                                                     : "another-joint";
    for (int other = 0; other < m_right.height(); ++other) {
      if (other == own) continue;
      const Heading& of = m_right.rows[static_cast<std::size_t>(other)];
      rows.push_back(
          {name,
           translated("This is the row of %1, not of %2.", {rowName(of), rowName(rowHeading(row))}),
           m_right.entries[static_cast<std::size_t>(other)],
           {of.element, rowHeading(row).element}});
    }
    return rows;
  }

  [[nodiscard]] std::string rowName(const Heading& heading) const {
    return heading.text.starts_with('C') ? heading.text : translated("joint %1", {heading.text});
  }

  void addCutsetRow(int own, std::vector<MistakenRow>& rows) const {
    std::vector<DerivedEntry> entries = m_right.entries[static_cast<std::size_t>(own)];
    for (auto column = static_cast<std::size_t>(m_source.graph().t()); column < entries.size(); ++column)
      entries[column] = entries[column].negated();
    rows.push_back(
        {"cutset-as-cycle",
         translated("You take the signs of the cycles: Q holds −T transposed beside the unit matrix."),
         entries,
         {m_right.rows[static_cast<std::size_t>(own)].element}});
  }

  /// An entry of a row of P: the gear's ratio or 1, with a sign.
  [[nodiscard]] DerivedEntry coefficient(MeshOrdinal mesh, int sign, bool isTail) const {
    DerivedEntry entry{RationalFunction::power(m_vocabulary.ring(), sign, mesh, isTail ? 1 : 0), 0};
    entry.value = m_vocabulary.atTeeth(entry.function);
    return entry;
  }

  void addCoefficientRows(MeshOrdinal mesh, std::vector<MistakenRow>& rows) const {
    const auto& right = m_right.entries[static_cast<std::size_t>(mesh)];
    const auto tree = m_source.matrix(MatrixKind::spanningTree);
    std::vector<DerivedEntry> inverse = right, headTurned = right, both = right, cycle = right,
                              senseless = right;
    for (std::size_t joint = 0; joint < right.size(); ++joint) {
      const int sign = right[joint].value.sign();
      if (sign == 0) continue;
      const bool isTail = !(right[joint].function == m_vocabulary.constant(sign));
      const int walk = tree->entry(mesh, static_cast<int>(joint));
      inverse[joint] = coefficient(mesh, sign, !isTail);
      if (!isTail) headTurned[joint] = coefficient(mesh, -sign, false);
      both[joint] = coefficient(mesh, isTail ? sign : -sign, !isTail);
      cycle[joint] = coefficient(mesh, walk, false);
      senseless[joint] = coefficient(mesh, sign * walk, isTail);
    }
    const std::string label = m_source.meshLabel(mesh);
    const std::vector<ElementId> elements{m_source.meshId(mesh)};
    const PairTeaching& teaching = pairTeaching(m_source.meshKind(mesh));
    rows.push_back(
        {"ratio-upside-down",
         translated("You exchange the gears of mesh %1: i%1 belongs to the joints on the tail's axis.",
                    {label}),
         inverse, elements});
    rows.push_back({teaching.signMistake, filled(translated(std::string_view(teaching.signInTable)), {label}),
                    headTurned, elements});
    rows.push_back({"sign-and-ratio",
                    translated("The ratio of mesh %1 is upside down and its sign is wrong.", {label}), both,
                    elements});
    rows.push_back(
        {"coefficients-left-out",
         translated(
             "This is the row of the cycle: in P its signs are multiplied by the coefficients of mesh %1.",
             {label}),
         cycle, elements});
    rows.push_back(
        {"arrow-sense-lost",
         translated("You leave out the signs of the cycle of mesh %1, which walks against some arrows.",
                    {label}),
         senseless, elements});
  }

  void addSolutionRows(int row, std::vector<MistakenRow>& rows) const {
    const auto& right = m_right.entries[static_cast<std::size_t>(row)];
    const Heading& heading = m_right.rows[static_cast<std::size_t>(row)];
    std::vector<DerivedEntry> negative = right;
    std::vector<DerivedEntry> inverse = right;
    const bool hasInverse = std::count_if(right.begin(), right.end(),
                                          [](const DerivedEntry& e) { return !e.value.isZero(); }) > 1;
    for (std::size_t k = 0; k < right.size(); ++k) {
      negative[k] = right[k].negated();
      if (right[k].value.isZero()) continue;
      inverse[k] = inverseOf(right[k]);
    }
    rows.push_back({"mesh-sign",
                    translated("Joint %1 turns the other way: the sign of one mesh of its chain is wrong.",
                               {heading.text}),
                    negative,
                    {heading.element}});
    if (hasInverse)
      rows.push_back(
          {"speed-inverted",
           translated("The row of joint %1 is upside down: it is output over input.", {heading.text}),
           inverse,
           {heading.element}});
  }

  [[nodiscard]] DerivedEntry inverseOf(const DerivedEntry& entry) const {
    if (!entry.hasFunction) return {{}, Rational(1) / entry.value, false};
    return {m_vocabulary.constant(1) / entry.function, Rational(1) / entry.value, true};
  }

  void addEntry(const EntryPlace& place) {
    const auto row = static_cast<std::size_t>(place.row);
    const auto column = static_cast<std::size_t>(place.column);
    const DerivedEntry& expected = m_expected[row][column];
    const WrittenAmount& written = m_written[row][column];
    WorkDifference difference{
        "wrong-entry", {place}, elementsOf(m_right, m_alignment.rows[row], m_alignment.columns[column]), {}};
    const bool isNegated = !expected.value.isZero() &&
                           agreementOf(m_vocabulary, written, expected.negated()) == TableAgreement::full;
    const bool isSolution = m_right.kind == PaperMatrix::solution;
    if (isSolution || m_right.kind == PaperMatrix::coefficients) {
      nameOfNumber(expected, written, isNegated, difference.name);
      difference.reason = numberReason(row, column, expected);
    } else {
      nameOfSign(m_alignment.rows[row], m_alignment.columns[column], written, isNegated, difference.name);
      const CellExplanation cell =
          explainCell(static_cast<MatrixKind>(m_right.kind), m_source.graph(), m_source.tree(),
                      m_alignment.rows[row], m_alignment.columns[column]);
      const bool isTurned =
          !(expected.value == derivedRow(row)[static_cast<std::size_t>(m_alignment.columns[column])].value);
      const int number = numberOf(matrixEquation(static_cast<MatrixKind>(m_right.kind)));
      const std::string equation = ' ' + translated("Eq. (%1)", {std::to_string(number)});
      difference.reason =
          cell.text.substr(0, cell.text.rfind(equation)) + ' ' +
          (isTurned ? translated("In the sense that you walk it, the entry is %1.", {printed(expected)})
                    : translated("So the entry is %1.", {printed(expected)}));
      if (difference.name == "entry-not-a-sign")
        difference.reason = translated("Entries of this matrix are −1, 0 or 1.") + ' ' + difference.reason;
    }
    m_all.push_back(std::move(difference));
  }

  void nameOfNumber(const DerivedEntry& expected, const WrittenAmount& written, bool isNegated,
                    std::string& name) const {
    const bool isSolution = m_right.kind == PaperMatrix::solution;
    if (expected.value.isZero()) {
      name = isSolution ? "input-without-effect" : "joint-off-the-walk";
    } else if (written.value.isZero()) {
      name = isSolution ? "input-ignored" : "joint-left-out";
    } else if (isNegated) {
      name = isSolution ? "sign-lost" : "walked-against-arrow";
    } else if (agreementOf(m_vocabulary, written, inverseOf(expected)) == TableAgreement::full) {
      name = isSolution ? "speed-inverted" : "ratio-upside-down";
    }
  }

  [[nodiscard]] std::string numberReason(std::size_t row, std::size_t column,
                                         const DerivedEntry& expected) const {
    const std::string joint = columnHeading(column).text;
    const std::string value = printed(expected);
    if (m_right.kind == PaperMatrix::coefficients) {
      const std::string cycle = rowHeading(row).text;
      return expected.value.isZero()
                 ? translated("Joint %1 is not on cycle %2, so its coefficient is 0.", {joint, cycle})
                 : translated("In the multiple of row %1 that you write, joint %2 has %3.",
                              {cycle, joint, value});
    }
    const std::string output = rowHeading(row).text;
    return expected.value.isZero() ? translated("Joint %1 does not feel input %2: 0.", {output, joint})
                                   : translated("With input %1 alone, joint %2 turns at %3 times its speed.",
                                                {joint, output, value});
  }

  /// Names of wrong entries of matrices of -1, 0 and 1; row and column are derived ones.
  void nameOfSign(int row, int column, const WrittenAmount& written, bool isNegated,
                  std::string& name) const {
    const int expected =
        m_right.entries[static_cast<std::size_t>(row)][static_cast<std::size_t>(column)].value.sign();
    const Rational value = m_vocabulary.atTeeth(written.value);
    if (!(value.isZero() || value.abs() == Rational(1))) {
      name = "entry-not-a-sign";
      return;
    }
    const int t = m_source.graph().t();
    const bool isExtra = expected == 0;
    switch (m_right.kind) {
      case PaperMatrix::incidence:
      case PaperMatrix::reducedIncidence:
        name = isExtra ? "not-an-end" : isNegated ? "arrow-reversed" : "end-left-out";
        return;
      case PaperMatrix::cutset:
        if (column < t) {
          name = isExtra ? "joint-in-cutset" : isNegated ? "crosses-backwards" : "joint-left-out";
        } else {
          name = isExtra ? "mesh-not-cut" : isNegated ? "crosses-backwards" : "mesh-not-counted";
        }
        return;
      default:
        if (column >= t && m_right.kind == PaperMatrix::cycleBasis) {
          name = isExtra ? "another-mesh-in-cycle" : isNegated ? "cycle-backwards" : "own-mesh-left-out";
        } else {
          name = isExtra ? "joint-off-the-walk" : isNegated ? "walked-against-arrow" : "joint-left-out";
        }
    }
  }

  const Vocabulary& m_vocabulary;
  const ExerciseSource& m_source;
  const DerivedTable& m_right;
  const WrittenAmounts& m_written;
  const Alignment& m_alignment;
  RowFreedom m_freedom;
  std::vector<std::vector<DerivedEntry>> m_expected;  ///< by written row and column
  std::vector<std::vector<TableAgreement>> m_agreements;
  std::vector<WorkDifference> m_all;
};

}  // namespace

std::vector<ElementId> elementsOf(const DerivedTable& table, int row, int column) {
  const ElementId& ofRow = table.rows[static_cast<std::size_t>(row)].element;
  const ElementId& ofColumn = table.columns[static_cast<std::size_t>(column)].element;
  if (ofRow == ofColumn) return {ofRow};
  return {ofRow, ofColumn};
}

std::vector<WorkDifference> tableDifferences(const Vocabulary& vocabulary, const DerivedTable& right,
                                             const WrittenAmounts& written, const Alignment& alignment) {
  return TableDifferences(vocabulary, right, written, alignment).all();
}

}  // namespace geargraph

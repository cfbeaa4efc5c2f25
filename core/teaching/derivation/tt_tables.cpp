#include <algorithm>

#include "core/foundations/base/translation.h"
#include "core/teaching/derivation/result_tables.h"
#include "core/theory/ttgraph/notation.h"
#include "core/theory/ttgraph/tt_matrices.h"

namespace geargraph {
namespace {

/// What both matrices of the T-T graph share: their columns, the branches and the chords.
class TtTable : public ResultTable {
 public:
  TtTable(const NamedResult& result, SnapshotPtr snapshot)
      : ResultTable(result, EntryForm::fractions),
        m_snapshot(std::move(snapshot)),
        m_graph(*m_snapshot->kinematics->ttGraph),
        m_matrices(m_graph) {}

  [[nodiscard]] int columns() const override { return m_matrices.columns(); }
  [[nodiscard]] std::optional<int> partition() const override {
    if (m_matrices.chords() == 0) return std::nullopt;
    return m_matrices.branches();
  }
  [[nodiscard]] Heading columnHeading(int column) const override {
    return column < m_matrices.branches() ? branchHeading(column)
                                          : chordHeading(column - m_matrices.branches());
  }

 protected:
  [[nodiscard]] const TtGraph& graph() const { return m_graph; }
  [[nodiscard]] const TtMatrices& matrices() const { return m_matrices; }

  [[nodiscard]] Heading branchHeading(JointOrdinal joint) const {
    const int label = m_graph.graph().edgeLabel(joint);
    return {label, std::to_string(label), m_graph.graph().edgeId(joint)};
  }

  /// "51''": gear 5, its carrier 1, the primes of its mesh; the name of a coupling.
  [[nodiscard]] Heading chordHeading(int chord) const {
    const TtChordOf of = m_matrices.chord(chord);
    if (of.held >= 0) {
      const ShiftElementId id = couplingOf(of.held).id;
      return {0, id.text(), id};
    }
    const int edge = m_graph.graph().t() + of.mesh;
    return {m_graph.graph().edgeLabel(edge), nameOf(of).toText().substr(1), m_graph.graph().edgeId(edge)};
  }

  /// "the chord 51'' from gear 5 to carrier 1"
  [[nodiscard]] std::string chordWords(int chord) const {
    const TtChordOf of = m_matrices.chord(chord);
    const std::string name = chordHeading(chord).text;
    if (of.held >= 0) return translated("the chord of coupling %1", {name});
    const VelocityName ends = nameOf(of);
    return translated("the chord %1 from gear %2 to carrier %3",
                      {name, std::to_string(ends.of), std::to_string(ends.relativeTo)});
  }
  [[nodiscard]] std::string jointWords(JointOrdinal joint) const {
    return translated("joint %1", {branchHeading(joint).text});
  }

  [[nodiscard]] static std::vector<ResultEntry> entriesOf(const std::vector<TtEntry>& row) {
    std::vector<ResultEntry> entries;
    entries.reserve(row.size());
    for (const TtEntry& entry : row) {
      const std::string text = entry.value < 0 ? "-1" : "1";
      entries.push_back({entry.column, text, text, static_cast<double>(entry.value), false});
    }
    return entries;
  }
  [[nodiscard]] static int valueAt(const std::vector<TtEntry>& row, int column) {
    const auto place =
        std::find_if(row.begin(), row.end(), [&](const TtEntry& entry) { return entry.column == column; });
    return place == row.end() ? 0 : place->value;
  }
  [[nodiscard]] std::set<ElementId> elementsOf(const std::vector<TtEntry>& row) const {
    std::set<ElementId> elements;
    for (const TtEntry& entry : row) elements.insert(columnHeading(entry.column).element);
    return elements;
  }

 private:
  [[nodiscard]] VelocityName nameOf(const TtChordOf& of) const {
    const TerminalPair& pair = *m_graph.terminal(of.mesh);
    return of.isTail ? tailChordName(pair) : headChordName(pair);
  }
  [[nodiscard]] const ShiftElement& couplingOf(int held) const {
    const int position = m_graph.held()[static_cast<std::size_t>(held)].coupling;
    return m_snapshot->mechanism->couplings[position];
  }

  SnapshotPtr m_snapshot;
  const TtGraph& m_graph;
  TtMatrices m_matrices;
};

class TtCircuitTable final : public TtTable {
 public:
  using TtTable::TtTable;

  [[nodiscard]] int rows() const override { return matrices().chords(); }
  [[nodiscard]] Heading rowHeading(int row) const override { return chordHeading(row); }
  [[nodiscard]] std::vector<ResultEntry> row(int row) const override {
    return entriesOf(matrices().circuit(row));
  }
  [[nodiscard]] std::set<ElementId> elementsOfRow(int row) const override {
    return elementsOf(matrices().circuit(row));
  }

  [[nodiscard]] CellExplanation explanation(int row, int column) const override {
    const int value = valueAt(matrices().circuit(row), column);
    CellExplanation cell{translated("f-circuit of %1, %2: %3",
                                    {rowHeading(row).text, columnHeading(column).text, printedEntry(value)}),
                         {}};
    cell.text = textOf(row, column, value) + " " + translated("Eqs. (31) to (38)");
    return cell;
  }

 private:
  [[nodiscard]] std::string textOf(int row, int column, int value) const {
    if (column >= matrices().branches()) {
      return value != 0 ? translated("The f-circuit that %1 closes: the chord itself counts as 1.",
                                     {chordWords(row)})
                        : translated("An f-circuit holds one chord, its own: here %1.", {chordWords(row)});
    }
    const std::string joint = jointWords(column);
    if (value == 0)
      return translated("%1 is not between the ends of %2.", {capitalised(joint), chordWords(row)});
    return value < 0 ? translated(
                           "The velocity of %1 is a sum of branches, in which %2 counts with "
                           "plus. On one side with the chord it is −1.",
                           {chordWords(row), joint})
                     : translated(
                           "The velocity of %1 is a sum of branches, in which %2 counts with "
                           "minus. On one side with the chord it is 1.",
                           {chordWords(row), joint});
  }

  [[nodiscard]] static std::string capitalised(std::string text) {
    if (!text.empty() && text.front() >= 'a' && text.front() <= 'z')
      text.front() = static_cast<char>(text.front() - 'a' + 'A');
    return text;
  }
};

class TtCutsetTable final : public TtTable {
 public:
  using TtTable::TtTable;

  [[nodiscard]] int rows() const override { return matrices().branches(); }
  [[nodiscard]] Heading rowHeading(int row) const override { return branchHeading(row); }
  [[nodiscard]] std::vector<ResultEntry> row(int row) const override {
    return entriesOf(matrices().cutset(row));
  }
  [[nodiscard]] std::set<ElementId> elementsOfRow(int row) const override {
    return elementsOf(matrices().cutset(row));
  }

  [[nodiscard]] CellExplanation explanation(int row, int column) const override {
    const int value = valueAt(matrices().cutset(row), column);
    CellExplanation cell{translated("f-cutset of joint %1, %2: %3",
                                    {rowHeading(row).text, columnHeading(column).text, printedEntry(value)}),
                         {}};
    cell.text = textOf(row, column, value) + " " + translated("Not in the paper.");
    return cell;
  }

 private:
  [[nodiscard]] std::string textOf(int row, int column, int value) const {
    const std::string joint = jointWords(row);
    if (column == row) {
      return translated(
          "Without %1 the tree falls into two halves; the torque in the joint itself "
          "counts as 1.",
          {joint});
    }
    if (column < matrices().branches())
      return translated("An f-cutset holds one branch, its own: %1, not %2.", {joint, jointWords(column)});
    const std::string chord = chordWords(column - matrices().branches());
    if (value == 0) {
      return translated(
          "Both ends of %1 are in the same half without %2: its torque is not in this "
          "equation.",
          {chord, joint});
    }
    return value > 0 ? translated(
                           "The torque of %1 acts across the cut, in the sense of %2: minus its "
                           "entry in the f-circuit.",
                           {chord, joint})
                     : translated(
                           "The torque of %1 acts across the cut, against the sense of %2: minus "
                           "its entry in the f-circuit.",
                           {chord, joint});
  }
};

}  // namespace

ResultTablePtr ttCircuitTable(const NamedResult& result, SnapshotPtr snapshot) {
  return std::make_shared<const TtCircuitTable>(result, std::move(snapshot));
}

ResultTablePtr ttCutsetTable(const NamedResult& result, SnapshotPtr snapshot) {
  return std::make_shared<const TtCutsetTable>(result, std::move(snapshot));
}

}  // namespace geargraph

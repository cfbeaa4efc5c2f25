#include "core/foundations/base/translation.h"
#include "core/teaching/derivation/result_tables.h"

namespace geargraph {
namespace {

class SolutionTable final : public ResultTable {
 public:
  SolutionTable(const NamedResult& result, SnapshotPtr snapshot, EntryForm form)
      : ResultTable(result, form), m_snapshot(std::move(snapshot)) {}

  [[nodiscard]] int rows() const override { return static_cast<int>(live().outputs.size()); }
  [[nodiscard]] int columns() const override { return static_cast<int>(live().inputs.size()); }
  [[nodiscard]] bool headsAreRates() const override { return true; }
  [[nodiscard]] Heading rowHeading(int row) const override {
    return headingOf(live().outputs[static_cast<std::size_t>(row)]);
  }
  [[nodiscard]] Heading columnHeading(int column) const override {
    return headingOf(live().inputs[static_cast<std::size_t>(column)]);
  }
  [[nodiscard]] std::set<ElementId> elementsOfRow(int row) const override {
    const JointOrdinal joint = live().outputs[static_cast<std::size_t>(row)];
    const Mechanism& mechanism = *m_snapshot->mechanism;
    return {graph().edgeId(joint), mechanism.turningJoints[joint].head};
  }

  [[nodiscard]] std::vector<ResultEntry> row(int row) const override {
    std::vector<ResultEntry> entries;
    for (int column = 0; column < columns(); ++column) {
      if (!isZero(row, column)) entries.push_back(shownEntry(row, column));
    }
    return entries;
  }

  [[nodiscard]] CellExplanation explanation(int row, int column) const override {
    const std::string output = rowHeading(row).text;
    const std::string input = columnHeading(column).text;
    const bool zero = isZero(row, column);
    const std::string text = zero ? "0" : shownEntry(row, column).text;
    CellExplanation cell{translated("Joint %1 over joint %2: %3", {output, input, text}), {}};
    cell.text = zero ? translated("Joint %1 does not feel input %2.", {output, input})
                     : translated(
                           "How fast joint %1 turns for one unit of speed at joint %2, the other inputs at "
                           "rest.",
                           {output, input});
    if (form() == EntryForm::symbols && !zero && hasFractions()) {
      cell.text += ' ' + translated("With these teeth: %1.", {exactAt(row, column).toString()});
    }
    cell.text += ' ' + translated("Eq. (%1)", {form() == EntryForm::symbols ? "25" : "23"});
    return cell;
  }

 private:
  [[nodiscard]] const Digraph& graph() const { return *m_snapshot->graph; }
  [[nodiscard]] const LiveSolution& live() const { return *m_snapshot->matroid()->solution; }
  [[nodiscard]] Heading headingOf(JointOrdinal joint) const {
    const int label = graph().edgeLabel(joint);
    return {label, std::to_string(label), graph().edgeId(joint)};
  }
  [[nodiscard]] std::size_t at(int row, int column) const {
    return static_cast<std::size_t>(row) * live().inputs.size() + static_cast<std::size_t>(column);
  }
  [[nodiscard]] bool hasFractions() const {
    return m_snapshot->solved && m_snapshot->solved->exact && !m_snapshot->solved->exact->matrix.empty();
  }
  [[nodiscard]] const Rational& exactAt(int row, int column) const {
    return m_snapshot->solved->exact->matrix[at(row, column)];
  }
  [[nodiscard]] bool isZero(int row, int column) const {
    // Where the exact part is not there yet: zeros of the live solution are exact.
    return form() == EntryForm::decimals ? live().matrix[at(row, column)] == 0
                                         : exactAt(row, column).isZero();
  }

  [[nodiscard]] ResultEntry shownEntry(int row, int column) const {
    if (form() == EntryForm::decimals) return decimalEntry(column, live().matrix[at(row, column)]);
    if (form() == EntryForm::fractions) return fractionEntry(column, exactAt(row, column));
    const auto& symbol = m_snapshot->solved->symbolic->matrix[at(row, column)];
    if (!symbol) return fractionEntry(column, exactAt(row, column));  // the formula would fill pages
    return {column, symbol->toText(), symbol->toLatex(), exactAt(row, column).toDouble(), true};
  }

  SnapshotPtr m_snapshot;
};

}  // namespace

ResultTablePtr solutionTable(const NamedResult& result, SnapshotPtr snapshot, EntryForm form) {
  return std::make_shared<const SolutionTable>(result, std::move(snapshot), form);
}

}  // namespace geargraph

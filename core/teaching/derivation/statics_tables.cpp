// The results of statics as tables.

#include "core/teaching/derivation/result_tables.h"
#include "core/teaching/derivation/solved_statics.h"
#include "core/theory/statics/cutset_equations.h"

namespace geargraph {
namespace {

Heading headingOfJoint(const Mechanism& mechanism, JointOrdinal joint) {
  const int label = mechanism.jointLabel(joint);
  return {label, std::to_string(label), ElementId(mechanism.turningJoints[joint].id)};
}

/// The balanced torques over the loaded ones.
class TorqueTable final : public ResultTable {
 public:
  TorqueTable(const NamedResult& result, SolvedStaticsPtr statics, EntryForm form)
      : ResultTable(result, form), m_statics(std::move(statics)) {}

  [[nodiscard]] int rows() const override { return static_cast<int>(report().balancedJoints.size()); }
  [[nodiscard]] int columns() const override { return static_cast<int>(report().matrix->loaded.size()); }
  [[nodiscard]] Heading rowHeading(int row) const override {
    return headingOf(report().balancedJoints[static_cast<std::size_t>(row)]);
  }
  [[nodiscard]] Heading columnHeading(int column) const override {
    return headingOf(report().matrix->loaded[static_cast<std::size_t>(column)]);
  }
  [[nodiscard]] std::vector<ResultEntry> row(int row) const override {
    std::vector<ResultEntry> entries;
    for (int column = 0; column < columns(); ++column) {
      const std::size_t at =
          static_cast<std::size_t>(row) * report().matrix->loaded.size() + static_cast<std::size_t>(column);
      const Rational& value = report().matrix->entries[at];
      if (value.isZero()) continue;
      if (form() == EntryForm::symbols) {
        const auto& formula = report().symbolic->matrix[at];
        entries.push_back({column, formula->toText(), formula->toLatex(), value.toDouble(), true});
      } else {
        entries.push_back(form() == EntryForm::fractions ? fractionEntry(column, value)
                                                         : decimalEntry(column, value.toDouble()));
      }
    }
    return entries;
  }

 private:
  [[nodiscard]] const StaticsReport& report() const { return *m_statics->report; }
  [[nodiscard]] Heading headingOf(JointOrdinal joint) const {
    return headingOfJoint(*m_statics->snapshot->mechanism, joint);
  }

  SolvedStaticsPtr m_statics;
};

/// P transposed.
class CutsetEquationTable final : public ResultTable {
 public:
  CutsetEquationTable(const NamedResult& result, SnapshotPtr snapshot)
      : ResultTable(result, EntryForm::decimals),
        m_snapshot(std::move(snapshot)),
        m_cutsets(CoefficientMatrix(*m_snapshot->mechanism, *m_snapshot->kinematics->model,
                                    m_snapshot->kinematics->placement())) {}

  [[nodiscard]] int rows() const override { return m_cutsets.count(); }
  [[nodiscard]] int columns() const override { return m_snapshot->mechanism->c(); }
  [[nodiscard]] Heading rowHeading(int row) const override {
    return headingOfJoint(*m_snapshot->mechanism, row);
  }
  [[nodiscard]] Heading columnHeading(int column) const override {
    const Mechanism& mechanism = *m_snapshot->mechanism;
    const int label = mechanism.meshLabel(column);
    return {label, std::to_string(label), ElementId(mechanism.gearMeshes[column].id)};
  }
  [[nodiscard]] std::vector<ResultEntry> row(int row) const override {
    std::vector<ResultEntry> entries;
    for (const CutsetEquations::Term& term : m_cutsets.terms(row))
      entries.push_back(decimalEntry(term.mesh, term.length));
    return entries;
  }
  [[nodiscard]] std::vector<ResultValue> values(int row) const override {
    std::vector<ResultValue> values;
    for (const CutsetEquations::Term& term : m_cutsets.terms(row)) values.push_back({term.mesh, term.length});
    return values;
  }

 private:
  SnapshotPtr m_snapshot;
  CutsetEquations m_cutsets;
};

/// Texts and numbers.
class RecordTable final : public ResultTable {
 public:
  RecordTable(const NamedResult& result, ValueTable records)
      : ResultTable(result, EntryForm::decimals), m_records(std::move(records)) {}

  [[nodiscard]] const ValueTable* records() const override { return &m_records; }
  [[nodiscard]] int rows() const override { return static_cast<int>(m_records.rows.size()); }
  [[nodiscard]] int columns() const override { return static_cast<int>(m_records.columns.size()); }
  [[nodiscard]] Heading rowHeading(int row) const override {
    const std::vector<ElementId>& elements = m_records.rows[static_cast<std::size_t>(row)].elements;
    return {row + 1, std::to_string(row + 1), elements.empty() ? ElementId() : elements.front()};
  }
  [[nodiscard]] Heading columnHeading(int column) const override {
    return {column + 1, m_records.columns[static_cast<std::size_t>(column)].head, {}};
  }
  [[nodiscard]] std::set<ElementId> elementsOfRow(int row) const override {
    const std::vector<ElementId>& elements = m_records.rows[static_cast<std::size_t>(row)].elements;
    return {elements.begin(), elements.end()};
  }
  [[nodiscard]] std::vector<ResultEntry> row(int row) const override {
    std::vector<ResultEntry> entries;
    for (const ForceCell& cell : m_records.rows[static_cast<std::size_t>(row)].cells) {
      const int column = static_cast<int>(entries.size());
      entries.push_back(cell.number ? decimalEntry(column, *cell.number)
                                    : ResultEntry{column, cell.text, "\\text{" + cell.text + '}', 0, true});
    }
    return entries;
  }

 private:
  ValueTable m_records;
};

}  // namespace

ResultTablePtr torqueTable(const NamedResult& result, SolvedStaticsPtr statics, EntryForm form) {
  return std::make_shared<const TorqueTable>(result, std::move(statics), form);
}

ResultTablePtr cutsetEquationTable(const NamedResult& result, SnapshotPtr snapshot) {
  return std::make_shared<const CutsetEquationTable>(result, std::move(snapshot));
}

ResultTablePtr recordTable(const NamedResult& result, ValueTable records) {
  return std::make_shared<const RecordTable>(result, std::move(records));
}

}  // namespace geargraph

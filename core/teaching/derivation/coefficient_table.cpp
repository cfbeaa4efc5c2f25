#include <algorithm>
#include <numeric>

#include "core/foundations/base/translation.h"
#include "core/teaching/derivation/result_tables.h"
#include "core/theory/matroid/coefficient_matrix.h"

namespace geargraph {
namespace {

class CoefficientTable final : public ResultTable {
 public:
  CoefficientTable(const NamedResult& result, SnapshotPtr snapshot, EntryForm form)
      : ResultTable(result, form),
        m_snapshot(std::move(snapshot)),
        m_matrix(*m_snapshot->mechanism, *m_snapshot->kinematics->model,
                 m_snapshot->kinematics->placement()) {
    m_joints.resize(static_cast<std::size_t>(m_matrix.columns()));
    std::iota(m_joints.begin(), m_joints.end(), 0);
    if (form == EntryForm::symbols) putInputsFirst();
    m_columns.resize(m_joints.size());
    for (std::size_t i = 0; i < m_joints.size(); ++i) {
      m_columns[m_joints[i]] = static_cast<int>(i);
    }
  }

  [[nodiscard]] int rows() const override { return m_matrix.rows(); }
  [[nodiscard]] int columns() const override { return m_matrix.columns(); }
  [[nodiscard]] std::optional<int> partition() const override {
    if (m_inputs == 0) return std::nullopt;
    return m_inputs;
  }
  [[nodiscard]] Heading rowHeading(int row) const override {
    const int label = graph().edgeLabel(graph().t() + row);
    return {label, "C" + std::to_string(label), graph().edgeId(graph().t() + row)};
  }
  [[nodiscard]] Heading columnHeading(int column) const override {
    const int label = graph().edgeLabel(jointAt(column));
    return {label, std::to_string(label), graph().edgeId(jointAt(column))};
  }
  [[nodiscard]] std::set<ElementId> elementsOfRow(int row) const override {
    return geargraph::elementsOfRow(MatrixKind::spanningTree, graph(), m_snapshot->tree.get(), row);
  }

  [[nodiscard]] std::vector<ResultEntry> row(int row) const override {
    std::vector<ResultEntry> entries;
    for (const CoefficientMatrix::Entry& entry : m_matrix.row(row)) {
      entries.push_back(shownEntry(row, entry));
    }
    std::sort(entries.begin(), entries.end(),
              [](const ResultEntry& a, const ResultEntry& b) { return a.column < b.column; });
    return entries;
  }

  [[nodiscard]] std::vector<ResultValue> values(int row) const override {
    if (form() != EntryForm::decimals) return ResultTable::values(row);
    std::vector<ResultValue> values;
    for (const CoefficientMatrix::Entry& entry : m_matrix.row(row))
      values.push_back({m_columns[entry.joint], entry.length});
    std::sort(values.begin(), values.end(),
              [](const ResultValue& a, const ResultValue& b) { return a.column < b.column; });
    return values;
  }

  [[nodiscard]] CellExplanation explanation(int row, int column) const override {
    const JointOrdinal joint = jointAt(column);
    const std::string jointName = translated("joint %1", {std::to_string(graph().edgeLabel(joint))});
    const std::string cycle = rowHeading(row).text;
    const std::string mesh = std::to_string(graph().edgeLabel(graph().t() + row));
    const std::string equation = ' ' + translated("Eq. (%1)", {form() == EntryForm::symbols ? "24" : "18"});
    for (const CoefficientMatrix::Entry& entry : m_matrix.row(row)) {
      if (entry.joint != joint) continue;
      const ResultEntry shown = shownEntry(row, entry);
      CellExplanation cell{cycle + ", " + jointName + ": " + shown.text, {}};
      if (form() == EntryForm::symbols) {
        cell.text = entry.tail
                        ? translated(
                              "The row divided by the radius of the head's gear: %1 turns about the axis of "
                              "the tail's gear, which leaves the ratio i%2 = %3.",
                              {jointName, mesh, m_matrix.piRatio(row).toString()})
                        : translated(
                              "The row divided by the radius of the head's gear: %1 turns about the axis of "
                              "the head's gear, which leaves 1.",
                              {jointName});
      } else {
        cell.text = entry.tail
                        ? translated(
                              "T times the moment of %1's axis about the pitch point of mesh %2, along the "
                              "normal of the mesh: the radius of the tail's gear.",
                              {jointName, mesh})
                        : translated(
                              "T times the moment of %1's axis about the pitch point of mesh %2, along the "
                              "normal of the mesh: the radius of the head's gear.",
                              {jointName, mesh});
      }
      cell.text += equation;
      return cell;
    }
    return {cycle + ", " + jointName + ": 0",
            translated("%1 does not use %2, so it has no part in the equation of mesh %3.",
                       {cycle, jointName, mesh}) +
                equation};
  }

 private:
  [[nodiscard]] const Digraph& graph() const { return *m_snapshot->graph; }
  [[nodiscard]] int jointAt(int column) const { return m_joints[static_cast<std::size_t>(column)]; }

  void putInputsFirst() {
    const MatroidAnalysis* matroid = m_snapshot->matroid();
    if (matroid == nullptr) return;
    ByJoint<char> isInput(m_joints.size(), 0);
    for (const JointOrdinal joint : matroid->choice.joints) isInput[joint] = 1;
    std::stable_partition(m_joints.begin(), m_joints.end(),
                          [&](JointOrdinal joint) { return isInput[joint] != 0; });
    m_inputs = static_cast<int>(matroid->choice.joints.size());
  }

  [[nodiscard]] ResultEntry shownEntry(MeshOrdinal mesh, const CoefficientMatrix::Entry& entry) const {
    const int column = m_columns[entry.joint];
    const std::string minus = entry.sign < 0 ? "-" : "";
    if (form() == EntryForm::symbols) {
      const std::string label = std::to_string(graph().edgeLabel(graph().t() + mesh));
      const double value = entry.sign * (entry.tail ? m_matrix.piRatio(mesh).toDouble() : 1);
      if (!entry.tail) return {column, minus + "1", minus + "1", value, false};
      return {column, minus + "i" + label, minus + "i_{" + label + "}", value, true};
    }
    if (form() == EntryForm::decimals) return decimalEntry(column, entry.length);
    const auto radius = m_matrix.exactRadius(mesh, entry.tail);
    return radius ? fractionEntry(column, Rational(entry.sign) * *radius)
                  : irrationalEntry(column, entry.length);
  }

  SnapshotPtr m_snapshot;
  CoefficientMatrix m_matrix;
  std::vector<int> m_joints;  ///< by column
  ByJoint<int> m_columns;
  int m_inputs = 0;
};

}  // namespace

ResultTablePtr coefficientTable(const NamedResult& result, SnapshotPtr snapshot, EntryForm form) {
  return std::make_shared<const CoefficientTable>(result, std::move(snapshot), form);
}

}  // namespace geargraph

#pragma once

#include <QAbstractTableModel>
#include <QTimer>
#include <optional>
#include <set>
#include <unordered_map>

#include "core/teaching/derivation/named_results.h"
#include "core/theory/analysis/analysis.h"
#include "ui/models/joint_preview.h"

namespace geargraph {

/// One result of the newest snapshot as a table: of whole numbers, or in decimals, fractions or symbols.
/// Entries are computed on demand, so a matrix of 10,000 rows costs only the rows on the screen.
///
/// While an arrow is being drawn the matrix includes its joint.
class MatrixModel : public QAbstractTableModel {
  Q_OBJECT

 public:
  enum Role {
    ValueRole = Qt::UserRole,  ///< int: the sign of the entry
    ChangedRole,               ///< bool: the last edit changed the entry, less than 0.6 s ago
    PreviewRole,               ///< bool: of the joint being drawn
    FormulaRole,               ///< bool: the text is a formula in the gear ratios
    RateRole,                  ///< bool, of headings: the text names the rate of that joint
  };
  static constexpr int kGlowMilliseconds = 600;

  explicit MatrixModel(QObject* parent = nullptr);

  [[nodiscard]] const NamedResult& result() const { return *m_result; }
  /// Shows a result in the wanted form, or in the nearest available one. @pre it lives longer than the model
  void setResult(const NamedResult& result);
  void setWantedForm(EntryForm form);
  void setSnapshot(const SnapshotPtr& snapshot);
  void setPreview(std::optional<PreviewSnapshot> preview);

  /// What is shown; null if there is none: no snapshot yet, or the result is undefined.
  [[nodiscard]] const ResultTablePtr& table() const { return m_table; }
  [[nodiscard]] bool isThere() const { return m_table != nullptr; }
  /// The newest snapshot without the preview; null before the first.
  [[nodiscard]] const SnapshotPtr& snapshot() const { return m_snapshot; }

  /// The element of a heading; an empty id if it has none (a component of a screw).
  [[nodiscard]] ElementId rowElement(int row) const { return rowHeading(row).element; }
  [[nodiscard]] ElementId columnElement(int column) const { return columnHeading(column).element; }
  /// The elements to highlight for a row: for T and C the whole cycle.
  [[nodiscard]] std::set<ElementId> elementsOfRow(int row) const;
  /// The elements to highlight for a cell: the whole cycle or cutset, else the elements of its row and
  /// column.
  [[nodiscard]] std::set<ElementId> elementsOfCell(int row, int column) const;
  /// @pre the index is in the model
  [[nodiscard]] CellExplanation explanation(const QModelIndex& index) const;
  /// The first column behind the dashed line, or -1.
  [[nodiscard]] int partition() const;

  [[nodiscard]] int rowCount(const QModelIndex& parent = {}) const override;
  [[nodiscard]] int columnCount(const QModelIndex& parent = {}) const override;
  [[nodiscard]] QVariant data(const QModelIndex& index, int role = Qt::DisplayRole) const override;
  [[nodiscard]] QVariant headerData(int section, Qt::Orientation orientation,
                                    int role = Qt::DisplayRole) const override;

 signals:
  void matrixChanged();  ///< another matrix, or none: update titles and empty states

 private:
  [[nodiscard]] ResultTablePtr tableOf(const SnapshotPtr& snapshot) const;
  void show(bool glow);
  [[nodiscard]] Heading rowHeading(int row) const { return m_table->rowHeading(row); }
  [[nodiscard]] Heading columnHeading(int column) const { return m_table->columnHeading(column); }
  [[nodiscard]] QVariant entryData(int row, int column, int role) const;
  [[nodiscard]] bool isPreview(int row, int column) const;
  [[nodiscard]] bool hasChanged(int row, int column) const;

  const NamedResult* m_result = &resultOf(MatrixKind::cycleBasis);
  SnapshotPtr m_snapshot;
  std::optional<PreviewSnapshot> m_preview;
  EntryForm m_form = EntryForm::symbols;
  ResultTablePtr m_table;
  IntegerMatrixPtr m_matrix;    ///< that m_table is of, if any
  mutable int m_rowAsked = -1;  ///< row of m_rowEntries: views ask cell by cell
  mutable std::vector<ResultEntry> m_rowEntries;
  IntegerMatrixPtr m_before;  ///< while changed cells are highlighted: the matrix before the edit; else null
  std::unordered_map<ElementId, int> m_rowsBefore;
  std::unordered_map<ElementId, int> m_columnsBefore;
  QTimer m_glow;
};

}  // namespace geargraph

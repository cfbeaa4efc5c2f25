#pragma once

#include <QAbstractTableModel>
#include <QTimer>
#include <optional>
#include <set>
#include <unordered_map>

#include "core/teaching/derivation/cell_explanation.h"
#include "core/teaching/derivation/quantity_table.h"
#include "core/theory/analysis/analysis.h"
#include "ui/models/joint_preview.h"

namespace geargraph {

/// One matrix of the newest snapshot as a table: an integer matrix, or a quantity (screws, P, solution) in
/// decimals, fractions or symbols. Entries are computed on demand, so a matrix of 10,000 rows costs only the
/// rows on the screen.
///
/// While an arrow is being drawn the matrix includes its joint.
class MatrixModel : public QAbstractTableModel {
  Q_OBJECT

 public:
  enum Role {
    ValueRole = Qt::UserRole,  ///< int: the entry; the sign of a quantity
    ChangedRole,               ///< bool: the last edit changed the entry, less than 0.6 s ago
    PreviewRole,               ///< bool: of the joint being drawn
    FormulaRole,               ///< bool: the text is a formula in the gear ratios
    RateRole,                  ///< bool, of headings: the text names the rate of that joint
  };
  static constexpr int kGlowMilliseconds = 600;

  explicit MatrixModel(QObject* parent = nullptr);

  [[nodiscard]] MatrixKind kind() const { return m_kind; }
  void setKind(MatrixKind kind);
  /// Shows a quantity in this form, or in the nearest available one.
  void setQuantity(QuantityKind kind, EntryForm form);
  [[nodiscard]] std::optional<QuantityKind> quantityKind() const { return m_quantityKind; }
  [[nodiscard]] EntryForm wantedForm() const { return m_form; }
  void setSnapshot(const SnapshotPtr& snapshot);
  void setPreview(std::optional<PreviewSnapshot> preview);

  /// The shown quantity; null if there is none, or an integer matrix is shown.
  [[nodiscard]] const QuantityTablePtr& quantity() const { return m_quantity; }
  [[nodiscard]] bool isThere() const { return m_matrix || m_quantity; }
  /// The shown integer matrix; null if there is none (no snapshot yet, or no spanning tree), or a quantity is
  /// shown.
  [[nodiscard]] const IntegerMatrixPtr& matrix() const { return m_matrix; }
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
  [[nodiscard]] const AnalysisSnapshot* shown() const;
  void show(bool glow);
  void showQuantity();
  [[nodiscard]] Heading rowHeading(int row) const;
  [[nodiscard]] Heading columnHeading(int column) const;
  [[nodiscard]] QVariant quantityData(int row, int column, int role) const;
  [[nodiscard]] bool isPreview(int row, int column) const;
  [[nodiscard]] bool hasChanged(int row, int column) const;

  MatrixKind m_kind = MatrixKind::cycleBasis;
  SnapshotPtr m_snapshot;
  std::optional<PreviewSnapshot> m_preview;
  std::optional<QuantityKind> m_quantityKind;
  EntryForm m_form = EntryForm::symbols;
  QuantityTablePtr m_quantity;
  mutable int m_rowAsked = -1;  ///< row of m_rowEntries: views ask cell by cell
  mutable std::vector<QuantityEntry> m_rowEntries;
  IntegerMatrixPtr m_matrix;
  IntegerMatrixPtr m_before;  ///< while changed cells are highlighted: the matrix before the edit; else null
  std::unordered_map<ElementId, int> m_rowsBefore;
  std::unordered_map<ElementId, int> m_columnsBefore;
  QTimer m_glow;
};

}  // namespace geargraph

#pragma once

#include <QTableView>
#include <QTimer>
#include <unordered_set>

#include "ui/document/selection.h"
#include "ui/models/matrix_model.h"

namespace geargraph {

/// A matrix as in print: labels above and beside, brackets, the partition as a dashed line, ±1 tinted, zeros
/// as faint dots. Hovered cells highlight their elements in all views through the selection, and elements
/// hovered or selected elsewhere highlight their rows and columns here. One entry can be framed.
class MatrixView : public QTableView {
  Q_OBJECT

 public:
  static constexpr int kColumnWidth = 44;  ///< down to kNarrowest if the whole matrix then fits
  static constexpr int kNarrowest = 31;
  static constexpr int kWidest = 360;  ///< of a formula; longer ones are elided
  static constexpr int kRowHeight = 32;
  static constexpr int kLowest = 20;
  static constexpr int kRestMilliseconds = 500;

  MatrixView(MatrixModel* model, Selection* selection, QWidget* parent = nullptr);

  void setZerosAsDots(bool dots);
  [[nodiscard]] bool zerosAsDots() const { return m_zerosAsDots; }

  [[nodiscard]] bool isRowHighlighted(int row) const;
  [[nodiscard]] bool isColumnHighlighted(int column) const;
  /// Is it the column of the only hovered element? It is tinted as a whole.
  [[nodiscard]] bool isColumnTinted(int column) const;

  /// Frames the entry of this mesh and this joint in every matrix that has one: of T, C and P the mesh is the
  /// row, of Q the joint. Empty: none. Cost: linear in the number of headings, here and when another matrix
  /// is shown.
  void setFramed(const ElementId& mesh, const ElementId& joint);
  [[nodiscard]] bool isFramed(int row, int column) const {
    return row >= 0 && row == m_framedRow && column == m_framedColumn;
  }
  /// Scrolls to the framed entry, makes it current and explains it; false if there is none.
  bool showFramed();

 signals:
  /// The mouse has rested on a cell for kRestMilliseconds; an invalid index: it has left the cell.
  void restedOn(const QModelIndex& index);
  /// The elements of the row and column of the hovered cell; both empty: none.
  void entryHovered(const geargraph::ElementId& row, const geargraph::ElementId& column);
  /// The mouse is over the row of this mesh's cycle; empty: over none.
  void cycleHovered(geargraph::MeshId mesh);
  /// A right click on a label or a row.
  void menuWanted(const geargraph::ElementId& element, QPoint globalPlace);

 protected:
  void paintEvent(QPaintEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void leaveEvent(QEvent* event) override;
  void contextMenuEvent(QContextMenuEvent* event) override;
  void changeEvent(QEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;

 private:
  void setUpHeaders();
  void fitSections();
  [[nodiscard]] std::vector<int> widthsOfQuantity() const;
  void hoverCell(const QModelIndex& index);
  void tellCycle(int row);
  void placeFrame();
  void frameTheChordThatCounts();
  void repaintHighlighted();

  MatrixModel* m_model;
  Selection* m_selection;
  std::unordered_set<ElementId> m_highlighted;
  bool m_zerosAsDots = true;
  ElementId m_framedMesh;
  ElementId m_framedJoint;
  int m_framedRow = -1;
  int m_framedColumn = -1;
  QPersistentModelIndex m_under;
  QTimer m_rest;
};

}  // namespace geargraph

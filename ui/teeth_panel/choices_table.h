#pragma once

#include <QTableView>

#include "ui/teeth_panel/choices_model.h"

namespace geargraph {

/// The table of choices. Keys: Up and Down go to the next row, Return takes it, Esc puts back the drawn
/// teeth, Ctrl+C copies. In a narrow panel the backward efficiency, the decimal and the planets are hidden in
/// turn.
class ChoicesTable : public QTableView {
  Q_OBJECT

 public:
  explicit ChoicesTable(ChoicesModel* model, QWidget* parent = nullptr);
  void fitColumns();
  /// The row that is chosen; -1: none. One that only has the focus is not.
  [[nodiscard]] int chosenRow() const;

 signals:
  void taken(int row);
  void putBack();
  void copyWanted();

 protected:
  void keyPressEvent(QKeyEvent* event) override;
  void mouseDoubleClickEvent(QMouseEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;

 private:
  [[nodiscard]] int widthOf(int column) const;

  ChoicesModel* m_choices;
};

}  // namespace geargraph

#pragma once

#include <QTableView>
#include <functional>

#include "ui/document/selection.h"
#include "ui/forces/value_table_model.h"

namespace geargraph {

/// A table of values whose rows are linked with the selection in both directions. Its first column, which
/// names the row, stays in place while the others scroll.
class LinkedTable : public QTableView {
  Q_OBJECT

 public:
  LinkedTable(ValueTableModel* model, Selection* selection, QWidget* parent = nullptr);

  /// Selects the row of the selection; to be called when the model has new rows, because it does not signal
  /// this.
  void selectRowOfSelection();
  /// Shows the columns that are chosen, each as wide as its contents.
  void fitColumns(const std::function<bool(int column)>& isShown);

 protected:
  bool viewportEvent(QEvent* event) override;
  void changeEvent(QEvent* event) override;

 private:
  void fitRows();

  ValueTableModel* m_values;
  Selection* m_selection;
};

}  // namespace geargraph

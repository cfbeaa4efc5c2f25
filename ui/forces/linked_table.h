#pragma once

#include <QTableView>

#include "ui/document/selection.h"
#include "ui/forces/value_table_model.h"

namespace geargraph {

/// A table of values whose rows are linked with the selection in both directions.
class LinkedTable : public QTableView {
  Q_OBJECT

 public:
  LinkedTable(ValueTableModel* model, Selection* selection, QWidget* parent = nullptr);

  /// Selects the row of the selection; to be called when the model has new rows, because it does not signal
  /// this.
  void selectRowOfSelection();

 protected:
  bool viewportEvent(QEvent* event) override;

 private:
  ValueTableModel* m_values;
  Selection* m_selection;
};

}  // namespace geargraph

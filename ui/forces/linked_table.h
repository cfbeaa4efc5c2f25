#pragma once

#include <QTableView>

#include "ui/forces/value_table_model.h"
#include "ui/selection/selection.h"

namespace geargraph::inline forces {

/// A table of values whose rows are linked with the selection both ways.
class LinkedTable : public QTableView {
  Q_OBJECT

 public:
  LinkedTable(ValueTableModel* model, Selection* selection, QWidget* parent = nullptr);

  /// The row of what is selected; the model does not tell when it has other rows.
  void selectRowOfSelection();

 protected:
  bool viewportEvent(QEvent* event) override;

 private:
  ValueTableModel* m_values;
  Selection* m_selection;
};

}  // namespace geargraph::inline forces

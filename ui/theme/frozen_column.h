#pragma once

#include <QTableView>

namespace geargraph {

/// The first column of a table, which stays in place while the others scroll beneath it. It lies over the
/// table, shares its model and selection, and hands on clicks and hovers as the table's own.
class FrozenColumn : public QTableView {
  Q_OBJECT

 public:
  /// Owned by the table, whose delegate is set. `heads`: of the same class as the table's, if that is of its
  /// own.
  explicit FrozenColumn(QTableView* table, QHeaderView* heads = nullptr);

 signals:
  void left();  ///< the mouse has left the column

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;
  bool viewportEvent(QEvent* event) override;

 private:
  void follow();
  void place();
  void revealCurrent(const QModelIndex& current);

  QTableView* m_table;
};

}  // namespace geargraph

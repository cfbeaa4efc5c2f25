#pragma once

#include <QObject>

namespace geargraph::inline mainwindow {

/// Keys do nothing while a dock is being dragged. Commands that show, hide or restore docks in the middle of
/// a drag leave QMainWindow with items that it has deleted already, and end the program.
class DockDrag : public QObject {
  Q_OBJECT

 public:
  explicit DockDrag(QObject* parent);

  bool eventFilter(QObject* watched, QEvent* event) override;
};

}  // namespace geargraph::inline mainwindow

#pragma once

#include <QMainWindow>

namespace geargraph::inline mainwindow {

/// Keys do nothing while a dock is being dragged, and the drag ends before its window does. Commands that
/// show, hide or restore docks in the middle of a drag leave QMainWindow with items that it has deleted
/// already, and end the program; so does the end of the window.
class DockDrag : public QObject {
  Q_OBJECT

 public:
  explicit DockDrag(QMainWindow* window);

  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  [[nodiscard]] QDockWidget* dragged() const;
  void end() const;

  QMainWindow* m_window;
};

}  // namespace geargraph::inline mainwindow

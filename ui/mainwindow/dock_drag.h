#pragma once

#include <QMainWindow>

namespace geargraph {

/// Keys do nothing while a dock is being dragged, and the drag ends before its window does. Commands that
/// show, hide or restore docks in the middle of a drag leave QMainWindow with items that it has deleted
/// already, and end the program; so does the end of the window.
///
/// A drop that leaves a floating group of docks without any dock in it is taken back. That is what becomes of
/// one that is dragged out of a group and dropped on the rest of it (Qt 6.4): it could neither be docked nor
/// saved.
class DockDrag : public QObject {
  Q_OBJECT

 public:
  explicit DockDrag(QMainWindow* window);

  /// The dock of the window that is being dragged; null if none is. QMainWindow::saveState() must wait for
  /// the end: it writes the room that is made for a group of docks as a dock without a name.
  [[nodiscard]] static QDockWidget* draggedOf(const QMainWindow& window);

  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void end() const;
  void takeBackIfLost();

  QMainWindow* m_window;
  QByteArray m_before;  ///< the layout before the last drag; empty when that has ended
};

}  // namespace geargraph

#pragma once

#include <QMainWindow>

namespace geargraph::inline mainwindow {

/// Docks that share a place are told apart by their tabs, so they need no title bar; a dock that floats or
/// stands alone shows one. Keeps that so while docks are moved.
class DockTitles : public QObject {
  Q_OBJECT

 public:
  explicit DockTitles(QMainWindow* window);

  void watch(QDockWidget* dock);

 private:
  void renew();
  void renewSoon();

  QMainWindow* m_window;
  QList<QDockWidget*> m_docks;
  bool m_pending = false;
};

}  // namespace geargraph::inline mainwindow

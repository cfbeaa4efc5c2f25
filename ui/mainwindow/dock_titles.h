#pragma once

#include <QMainWindow>

namespace geargraph {

/// Hides the title bars of tabbed docks, which have tabs instead; a dock that floats or is alone shows its
/// title bar, with buttons in the theme's colour. Updated while docks are moved. The window of a floating
/// group of tabs closes all docks in it: Qt would close the one in front, and hide the others without saying
/// so.
class DockTitles : public QObject {
  Q_OBJECT

 public:
  explicit DockTitles(QMainWindow* window);

  void watch(QDockWidget* dock);

  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void renew();
  void updateSoon();
  void updateButtons();

  QMainWindow* m_window;
  QList<QDockWidget*> m_docks;
  bool m_pending = false;
};

}  // namespace geargraph

#pragma once

#include <QByteArray>
#include <QObject>

class QLabel;
class QMainWindow;

namespace geargraph::inline mainwindow {

/// The window as a lecture hall wants it: full screen, large type, no bars, the drawing and the panels that
/// were chosen. The choice is remembered apart from the layout for work; either comes back as it was.
///
/// Esc ends it, unless there is something else to give up: a gesture, a menu, what is being typed. Space is
/// played(), whatever has the focus but a field that text is typed into.
class Presentation : public QObject {
  Q_OBJECT

 public:
  static constexpr double kTypeScale = 1.5;

  explicit Presentation(QMainWindow* window);

  [[nodiscard]] bool isOn() const { return m_on; }

 public slots:
  void setOn(bool on);
  void toggle() { setOn(!m_on); }

 signals:
  void changed(bool on);
  void played();

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void enter();
  void leave();
  void setBarsVisible(bool visible);
  void choosePanels();
  void showHint();

  QMainWindow* m_window;
  QLabel* m_hint = nullptr;
  QByteArray m_workLayout;
  QByteArray m_workGeometry;
  Qt::WindowStates m_workState;
  bool m_on = false;
};

}  // namespace geargraph::inline mainwindow

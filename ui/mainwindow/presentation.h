#pragma once

#include <QByteArray>
#include <QObject>

class QLabel;
class QMainWindow;

namespace geargraph {

/// Presentation mode for lecture halls: full screen, large type, no bars, the drawing and the chosen panels.
/// Its layout is remembered separately from the working layout; both are restored.
///
/// Esc ends it, unless there is something else to cancel: a gesture, a menu, typing. Space emits played(),
/// unless a text field has the focus.
class Presentation : public QObject {
  Q_OBJECT

 public:
  static constexpr double kTypeScale = 1.5;
  /// The property of docks that the first presentation shows.
  static constexpr const char* kIsPresented = "isPresented";

  struct Layout {
    QByteArray geometry;  ///< QWidget::saveGeometry()
    QByteArray state;     ///< QMainWindow::saveState()
  };

  explicit Presentation(QMainWindow* window);

  [[nodiscard]] bool isOn() const { return m_on; }
  /// The working layout, which a presentation hides: what is to be remembered of the window.
  [[nodiscard]] Layout workLayout() const;
  /// Ends it with its window, which is not laid out again.
  void end();

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
  void finish();
  void setBarsVisible(bool visible);
  void choosePanels();
  void showHint();

  QMainWindow* m_window;
  QLabel* m_hint = nullptr;
  Layout m_workLayout;
  Qt::WindowStates m_workState;
  bool m_on = false;
};

}  // namespace geargraph

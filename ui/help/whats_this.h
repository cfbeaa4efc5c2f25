#pragma once

#include <QObject>

class QAction;
class QMainWindow;

namespace geargraph {

/// "What's This?" for everything in a window: widgets without a text of their own show their tool tip, and
/// those without one the purpose of their panel with a link to the manual.
class WhatsThis : public QObject {
  Q_OBJECT

 public:
  explicit WhatsThis(QMainWindow* window);

  /// The text for a widget; empty for those of other windows.
  [[nodiscard]] static QString textFor(const QWidget* widget);
  /// The text for a command: what it does, or why it is unavailable.
  [[nodiscard]] static QString textFor(const QAction& action);

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void prepareActions();

  QMainWindow* m_window;
};

}  // namespace geargraph

#pragma once

#include <QObject>

class QAction;
class QMainWindow;

namespace geargraph::inline ui_help {

/// "What's this" for everything in a window: what states no text of its own answers with its tooltip, and
/// what has none with the purpose of its panel and the way to the manual.
class WhatsThis : public QObject {
  Q_OBJECT

 public:
  explicit WhatsThis(QMainWindow* window);

  /// What is told of a widget; empty for those of other windows.
  [[nodiscard]] static QString textFor(const QWidget* widget);
  /// What is told of a command: what it does, or why it is not possible now.
  [[nodiscard]] static QString textFor(const QAction& action);

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void prepareActions();

  QMainWindow* m_window;
};

}  // namespace geargraph::inline ui_help

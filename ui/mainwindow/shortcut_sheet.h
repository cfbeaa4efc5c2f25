#pragma once

#include <QDialog>

class QMenuBar;
class QTextBrowser;

namespace geargraph::inline mainwindow {

/// All keyboard shortcuts on one sheet: those of the menus, and the mouse and keyboard actions in the
/// drawings and the 3D view.
class ShortcutSheet : public QDialog {
  Q_OBJECT

 public:
  ShortcutSheet(const QMenuBar& menus, QWidget* parent);

  /// The sheet as HTML.
  [[nodiscard]] static QString textFor(const QMenuBar& menus);

 protected:
  void showEvent(QShowEvent* event) override;

 private:
  const QMenuBar* m_menus;
  QTextBrowser* m_text;
};

}  // namespace geargraph::inline mainwindow

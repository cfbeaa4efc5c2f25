#pragma once

#include <QDialog>

class QMenuBar;

namespace geargraph::inline mainwindow {

/// All keys on one sheet: those of the menus as they are now, and what mouse and keys do in the drawings and
/// in the 3D view.
class ShortcutSheet : public QDialog {
  Q_OBJECT

 public:
  ShortcutSheet(const QMenuBar& menus, QWidget* parent);

  /// The sheet as HTML.
  [[nodiscard]] static QString textFor(const QMenuBar& menus);
};

}  // namespace geargraph::inline mainwindow

#pragma once

#include <QString>

class QWidget;

namespace geargraph::inline mainwindow {

/// The program and what it runs on, a line each: version, Qt, system, platform, OpenGL driver. For reports of
/// problems; names neither user nor files. @pre there is an application
[[nodiscard]] QString programDetails();

/// What this program is, with a button that copies programDetails().
void showAboutDialog(QWidget* parent);

}  // namespace geargraph::inline mainwindow

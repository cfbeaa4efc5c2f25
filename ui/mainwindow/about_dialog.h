#pragma once

#include <QString>

class QWidget;

namespace geargraph {

/// The program and its environment, one line each: version, Qt, system, platform, OpenGL driver. For bug
/// reports; without names of users or files. @pre there is an application
[[nodiscard]] QString programDetails();

/// Shows the About dialog, with a button that copies programDetails().
void showAboutDialog(QWidget* parent);

}  // namespace geargraph

#pragma once

#include <QString>
#include <functional>

class QMenu;

namespace geargraph::inline workbench {
class Workbench;
}  // namespace geargraph::inline workbench

namespace geargraph::inline mainwindow {

/// While an entry of the menu is tried (MenuPreview), all that is derived from the document (results, speeds,
/// motion) is that of the document as the entry would leave it. The document itself, its history and its
/// drawings stay. `tell` gets a sentence about what is shown, or why it cannot be; empty once it is over.
/// The workbench has to outlive the menu.
void showPreviews(QMenu& menu, Workbench& workbench, std::function<void(const QString&)> tell);

}  // namespace geargraph::inline mainwindow

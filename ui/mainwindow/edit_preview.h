#pragma once

#include <QString>
#include <functional>

class QMenu;

namespace geargraph {
class Workbench;
}  // namespace geargraph

namespace geargraph {

/// While an entry of the menu is previewed (MenuPreview), everything derived from the document (results,
/// speeds, motion) shows the document after the entry's edit. The document itself, its history and its
/// drawings do not change. `tell` is called with a sentence about the preview, or why there is none; empty
/// when it ends. The workbench outlives the menu.
void showPreviews(QMenu& menu, Workbench& workbench, std::function<void(const QString&)> tell);

}  // namespace geargraph

#pragma once

#include <vector>

#include "ui/workbench/view_entry.h"

namespace geargraph {

/// All views of a window, in the language in use: the one list from which its tabs and panels, the menu View,
/// the search, the manual, lessons and presentations are made. A view comes after those that it takes from
/// Views. The first ten panels have the keys Alt+1 to Alt+0, so new ones are appended.
[[nodiscard]] std::vector<ViewEntry> viewTable();

}  // namespace geargraph

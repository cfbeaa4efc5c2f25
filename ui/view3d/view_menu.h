#pragma once

#include <optional>

#include "ui/view3d/view3d.h"

class QMenu;

namespace geargraph::inline view3d {

/// Fills a menu with what the 3D view can show, each entry checked as it is now: faces, section, exploded
/// view, ghosts, labels, what is drawn of geometry and motion, and what is hidden or ridden.
void fillViewMenu(QMenu& menu, View3D& view);

/// Fills a menu for the part under the mouse, or for the empty ground.
void fillPartMenu(QMenu& menu, View3D& view, const std::optional<Hit>& hit);

}  // namespace geargraph::inline view3d

#pragma once

namespace geargraph::inline view3d {

/// Makes the links in 3D views known to screen readers, by QAccessible: each is a child of the canvas, with
/// its name and whether it is selected, and can be pressed. Once for the program; windows call it.
void installStageAccessibility();

}  // namespace geargraph::inline view3d

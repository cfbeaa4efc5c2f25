#pragma once

namespace geargraph {

/// Makes the links in 3D views accessible to screen readers by QAccessible: each is a child of the canvas
/// with its name and selection state, and can be pressed. Further calls have no effect.
void installStageAccessibility();

}  // namespace geargraph

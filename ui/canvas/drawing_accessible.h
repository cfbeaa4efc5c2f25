#pragma once

namespace geargraph {

/// Makes the elements of drawings accessible to screen readers (QAccessible): each is a child of its drawing,
/// with name, rectangle and selected state, and can be pressed. Installed once per program; windows call it.
void installDrawingAccessibility();

}  // namespace geargraph

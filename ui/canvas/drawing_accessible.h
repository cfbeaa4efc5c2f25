#pragma once

namespace geargraph::inline canvas {

/// Makes the elements of drawings known to screen readers, by QAccessible: each is a child of its drawing,
/// with its name, its place and whether it is selected, and can be pressed. Once for the program; windows
/// call it.
void installDrawingAccessibility();

}  // namespace geargraph::inline canvas

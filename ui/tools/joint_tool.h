#pragma once

#include "ui/tools/tool.h"

/// Adds a turning joint or a gear mesh between two links: drag from one to the other, or click one, then the
/// other.
///
///     Idle --press link--> Dragging --release on another link--> Idle + AddJoint
///                             |--release on the first link--> Picked
///                             +--release on anything else---> Idle
///     Picked --press another link--> Idle + AddJoint
///     Picked --press anything else--> Idle
///     any --Esc--> Idle
namespace geargraph::joint_tool {

struct Idle {};
/// The mouse button is down; the arrow follows the mouse.
struct Dragging {
  LinkId tail;
  LinkId over;  ///< another link under the mouse, or empty
  CanvasPoint cursor;
};
/// The first link was clicked; the arrow follows the mouse with the button up.
struct Picked {
  LinkId tail;
  LinkId over;
  CanvasPoint cursor;
};
using State = std::variant<Idle, Dragging, Picked>;

/// The transition function. `kind`: turningJoint or gearMesh.
[[nodiscard]] Outcome<State> on(const State& state, const ToolEvent& event, ElementKind kind);

}  // namespace geargraph::joint_tool

#pragma once

#include "ui/tools/tool.h"

/// Selects and moves.
///
///     Idle --press element--> Armed --release--> Idle + SelectOnly / ToggleSelected
///                               |--move, on a link--> Moving --move--> Moving + MoveSelected
///                               |                       |--release--> Idle + MoveEnded
///                               |                       +--Esc------> Idle + MoveCancelled
///                               +--move, on an arrow--> Banding
///     Idle --press nothing--> Banding --release--> Idle + SelectInside (a click: ClearSelection)
///     any --Esc--> Idle
///
/// Pressing a link that is not selected selects it, so that a drag moves it; selected elements stay selected
/// until the release, so that a drag moves all of them.
namespace geargraph::select_tool {

struct Idle {};
struct Armed {
  ElementId on;
  CanvasPoint from;
  bool add = false;
  bool wasSelected = false;
};
struct Moving {
  CanvasPoint from;
};
struct Banding {
  CanvasPoint from;
  CanvasPoint to;
  bool add = false;
  bool wide = false;  ///< moved further than a click may
};
using State = std::variant<Idle, Armed, Moving, Banding>;

[[nodiscard]] Outcome<State> on(const State& state, const ToolEvent& event);

}  // namespace geargraph::select_tool

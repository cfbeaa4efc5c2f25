#pragma once

#include <string_view>

#include "ui/tools/tool.h"

namespace geargraph {

/// Draws links: click on an empty area.
///
///     Hovering --press nothing--> Placing --release--> Hovering + AddLink
///     any --Esc--> Hovering
namespace link_tool {

/// `place`: the mouse position if over an empty area, where a link would be added.
struct Hovering {
  std::optional<CanvasPoint> place;
};
struct Placing {
  CanvasPoint place;
};
using State = std::variant<Hovering, Placing>;

[[nodiscard]] Outcome<State> on(const State& state, const ToolEvent& event);

}  // namespace link_tool

/// Makes a joint an input, or removes that input: click a turning joint or its head link.
///
///     Idle --press turning joint or link--> Idle + ToggleInput
namespace input_tool {

struct Idle {};
using State = std::variant<Idle>;

[[nodiscard]] Outcome<State> on(const State& state, const ToolEvent& event);

}  // namespace input_tool

/// Writes notes: a click on an empty area adds a note, a click on a note edits its text.
///
///     Idle --press nothing, or a note--> Placing --release--> Idle + WriteNote
///     Placing --Esc--> Idle
namespace note_tool {

struct Idle {};
struct Placing {
  std::optional<NoteId> note;
};
using State = std::variant<Idle, Placing>;

[[nodiscard]] Outcome<State> on(const State& state, const ToolEvent& event);

}  // namespace note_tool

/// Measures: a click takes an element as the first or the second end. The drawing hands it to what the views
/// of a window share; the tool has no state of its own.
namespace measure_tool {

struct Idle {};
using State = std::variant<Idle>;

/// What the user can do first, as a sentence for the status bar.
[[nodiscard]] std::string_view hint();

}  // namespace measure_tool

/// Pans the sheet. The grabbed point stays under the mouse, so each PanBy is relative to the sheet's position
/// before it.
///
///     Idle --press--> Panning --move--> Panning + PanBy
///                        +--release, Esc--> Idle
namespace pan_tool {

struct Idle {};
struct Panning {
  CanvasPoint grabbed;
};
using State = std::variant<Idle, Panning>;

[[nodiscard]] Outcome<State> on(const State& state, const ToolEvent& event);

}  // namespace pan_tool
}  // namespace geargraph

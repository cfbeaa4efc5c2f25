#include "ui/tools/section_tool.h"

#include <cmath>

#include "core/foundations/base/translation.h"
#include "ui/tools/click_tools.h"
#include "ui/tools/load_tool.h"

namespace geargraph::section_tool {
namespace {

LinkId linkUnder(const Pointer& pointer) {
  const bool isLink = pointer.on && pointer.on->kind == ElementKind::link;
  return isLink ? LinkId(pointer.on->id) : LinkId();
}

bool wandered(CanvasPoint from, const Pointer& pointer) {
  return std::hypot(pointer.at.x - from.x, pointer.at.y - from.y) > pointer.slop;
}

/// What a drawing that is under way does; it moves with the mouse.
template <class Drawn>
Step drawnTo(Drawn state, const Moved& event) {
  state.to = event.pointer.at;
  return {state, {}};
}

struct Transition {
  ToolKind tool;

  Step operator()(const Idle& idle, const Pressed& event) const {
    const Pointer& pointer = event.pointer;
    if (tool == ToolKind::link) return {Shaft{pointer.at, pointer.at}, {}};
    if (tool == ToolKind::select && pointer.on && pointer.on->kind == ElementKind::axis && !pointer.add)
      return {Grabbed{AxisId(pointer.on->id), pointer.at}, {}};
    const LinkId link = linkUnder(pointer);
    if (link.empty()) return {idle, {}};
    if (tool == ToolKind::turningJoint) return {Carried{link, pointer.at, pointer.at}, {}};
    if (tool == ToolKind::gearMesh) return {Meshing{link, pointer.at, pointer.at}, {}};
    return {idle, {}};
  }
  Step operator()(const Shaft& state, const Moved& event) const { return drawnTo(state, event); }
  Step operator()(const Carried& state, const Moved& event) const { return drawnTo(state, event); }
  Step operator()(const Meshing& state, const Moved& event) const { return drawnTo(state, event); }
  Step operator()(const Shaft& state, const Released& event) const {
    return {Idle{}, AddShaft{state.from, event.pointer.at, {}}};
  }
  Step operator()(const Carried& state, const Released& event) const {
    if (!wandered(state.from, event.pointer)) return {Idle{}, {}};
    return {Idle{}, AddShaft{event.pointer.at, event.pointer.at, state.carrier}};
  }
  Step operator()(const Meshing& state, const Released& event) const {
    const LinkId head = linkUnder(event.pointer);
    if (!wandered(state.from, event.pointer) || head == state.tail) return {Idle{}, {}};
    return {Idle{}, MeshLinks{state.tail, head, state.from, event.pointer.at}};
  }
  Step operator()(const Grabbed& state, const Moved& event) const {
    if (!wandered(state.from, event.pointer)) return {state, {}};
    return (*this)(Dragging{state.axis, state.from, state.from}, event);
  }
  Step operator()(const Grabbed&, const Released&) const { return {Idle{}, {}}; }
  Step operator()(const Dragging& state, const Moved& event) const {
    const Pointer& pointer = event.pointer;
    return {Dragging{state.axis, state.from, pointer.at},
            DragAxis{state.axis, state.from, pointer.at, pointer.unsnapped}};
  }
  Step operator()(const Dragging&, const Released&) const { return {Idle{}, AxisDropped{}}; }
  Step operator()(const Dragging&, const Escaped&) const { return {Idle{}, AxisPutBack{}}; }
  template <class AnyState>
  Step operator()(const AnyState&, const Escaped&) const {
    return {Idle{}, {}};
  }
  template <class AnyState, class AnyEvent>
  Step operator()(const AnyState& state, const AnyEvent&) const {
    return {state, {}};
  }
};

}  // namespace

Step on(const State& state, const ToolEvent& event, ToolKind tool) {
  return std::visit(Transition{tool}, state, event);
}

std::string_view hint(const State& state, ToolKind tool) {
  const bool idle = std::holds_alternative<Idle>(state);
  switch (tool) {
    case ToolKind::link:
      return idle ? toTranslate("Shaft: drag along an axis, or on an empty area for a new axis")
                  : toTranslate("Shaft: release where it ends. Esc cancels");
    case ToolKind::turningJoint:
      return idle ? toTranslate("Carried shaft: drag from the link that carries it to its place")
                  : toTranslate("Carried shaft: release at the place of its axis. Esc cancels");
    case ToolKind::gearMesh:
      return idle
                 ? toTranslate("Gear mesh: drag from a shaft to the one it drives")
                 : toTranslate("Gear mesh: release on the other shaft, or beyond it for a ring. Esc cancels");
    case ToolKind::input:
      return toTranslate("Input: click a turning joint, or the link it carries, to drive it or not");
    case ToolKind::load:
      return load_tool::hint({});
    case ToolKind::note:
      return toTranslate("Notes are written on the sheet of the digraph");
    case ToolKind::measure:
      return measure_tool::hint();
    case ToolKind::pan:
      return toTranslate("Drag to move the sheet");
    case ToolKind::select:
      if (std::holds_alternative<Dragging>(state)) return toTranslate("Alt places freely. Esc puts back");
      return toTranslate(
          "Click to select, drag an axis to move it or the rim of a gear for its teeth. The program lays the "
          "drawing out");
  }
  return {};
}

std::optional<Draft> draft(const State& state) {
  using Style = Draft::Style;
  if (const auto* shaft = std::get_if<Shaft>(&state)) return Draft{shaft->from, shaft->to, Style::shaft};
  if (const auto* carried = std::get_if<Carried>(&state))
    return Draft{carried->from, carried->to, Style::connection};
  if (const auto* meshing = std::get_if<Meshing>(&state))
    return Draft{meshing->from, meshing->to, Style::connection};
  if (const auto* drag = std::get_if<Dragging>(&state)) return Draft{drag->from, drag->to, Style::axis};
  return std::nullopt;
}

}  // namespace geargraph::section_tool

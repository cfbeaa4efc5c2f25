#include "ui/tools/select_tool.h"

#include <cmath>

namespace geargraph::select_tool {
namespace {

bool isMovable(const ElementId& element) {
  return element.kind == ElementKind::link || element.kind == ElementKind::note;
}

bool isFar(CanvasPoint from, const Pointer& to) {
  return std::hypot(to.at.x - from.x, to.at.y - from.y) > to.slop;
}

Outcome<State> press(const Pointer& pointer) {
  if (!pointer.on) return {Banding{pointer.at, pointer.at, pointer.add, false}, {}};
  const Armed armed{*pointer.on, pointer.at, pointer.add, pointer.onSelected};
  const bool taken = isMovable(*pointer.on) && !pointer.onSelected && !pointer.add;
  if (taken) return {armed, {SelectOnly{*pointer.on}}};
  return {armed, {}};
}

Outcome<State> drag(const Armed& armed, const Pointer& pointer) {
  if (!isFar(armed.from, pointer)) return {armed, {}};
  if (!isMovable(armed.on)) return {Banding{armed.from, pointer.at, armed.add, true}, {}};
  const MoveSelected move{pointer.at.x - armed.from.x, pointer.at.y - armed.from.y, pointer.unsnapped};
  if (armed.add && !armed.wasSelected) return {Moving{armed.from}, {ToggleSelected{armed.on}, move}};
  return {Moving{armed.from}, {move}};
}

struct Transition {
  Outcome<State> operator()(const Idle&, const Pressed& event) const { return press(event.pointer); }
  Outcome<State> operator()(const Armed& armed, const Moved& event) const {
    return drag(armed, event.pointer);
  }
  Outcome<State> operator()(const Armed& armed, const Released&) const {
    if (armed.add) return {Idle{}, {ToggleSelected{armed.on}}};
    return {Idle{}, {SelectOnly{armed.on}}};
  }
  Outcome<State> operator()(const Moving& moving, const Moved& event) const {
    const Pointer& pointer = event.pointer;
    return {moving,
            {MoveSelected{pointer.at.x - moving.from.x, pointer.at.y - moving.from.y, pointer.unsnapped}}};
  }
  Outcome<State> operator()(const Moving&, const Released&) const { return {Idle{}, {MoveEnded{}}}; }
  Outcome<State> operator()(const Moving&, const Escaped&) const { return {Idle{}, {MoveCancelled{}}}; }
  Outcome<State> operator()(const Banding& band, const Moved& event) const {
    const bool wide = band.wide || isFar(band.from, event.pointer);
    return {Banding{band.from, event.pointer.at, band.add, wide}, {}};
  }
  Outcome<State> operator()(const Banding& band, const Released&) const {
    if (band.wide) return {Idle{}, {SelectInside{band.from, band.to, band.add}}};
    if (band.add) return {Idle{}, {}};
    return {Idle{}, {ClearSelection{}}};
  }
  template <class AnyState>
  Outcome<State> operator()(const AnyState&, const Escaped&) const {
    return {Idle{}, {}};
  }
  template <class AnyState, class AnyEvent>
  Outcome<State> operator()(const AnyState& state, const AnyEvent&) const {
    return {state, {}};
  }
};

}  // namespace

Outcome<State> on(const State& state, const ToolEvent& event) {
  return std::visit(Transition{}, state, event);
}

}  // namespace geargraph::select_tool

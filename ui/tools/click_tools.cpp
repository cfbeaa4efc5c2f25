#include "ui/tools/click_tools.h"

#include "core/foundations/base/translation.h"

namespace geargraph {
namespace link_tool {
namespace {

struct Transition {
  Outcome<State> operator()(const Hovering&, const Moved& event) const { return hovering(event.pointer); }
  Outcome<State> operator()(const Hovering& state, const Pressed& event) const {
    if (event.pointer.on) return {state, {}};
    return {Placing{event.pointer.at}, {}};
  }
  Outcome<State> operator()(const Placing&, const Moved& event) const {
    return {Placing{event.pointer.at}, {}};
  }
  Outcome<State> operator()(const Placing&, const Released& event) const {
    return {Hovering{}, {AddLink{event.pointer.at}}};
  }
  template <class AnyState>
  Outcome<State> operator()(const AnyState&, const Escaped&) const {
    return {Hovering{}, {}};
  }
  template <class AnyState, class AnyEvent>
  Outcome<State> operator()(const AnyState& state, const AnyEvent&) const {
    return {state, {}};
  }

  [[nodiscard]] static Outcome<State> hovering(const Pointer& pointer) {
    if (pointer.on) return {Hovering{}, {}};
    return {Hovering{pointer.at}, {}};
  }
};

}  // namespace

Outcome<State> on(const State& state, const ToolEvent& event) {
  return std::visit(Transition{}, state, event);
}

}  // namespace link_tool

namespace input_tool {

Outcome<State> on(const State& state, const ToolEvent& event) {
  const auto* press = std::get_if<Pressed>(&event);
  if (press == nullptr || !press->pointer.on) return {state, {}};
  const ElementId element = *press->pointer.on;
  const bool driveable = element.kind == ElementKind::turningJoint || element.kind == ElementKind::link;
  if (!driveable) return {state, {}};
  return {state, {ToggleInput{element}}};
}

}  // namespace input_tool

namespace note_tool {
namespace {

struct Transition {
  Outcome<State> operator()(const Idle& state, const Pressed& event) const {
    const std::optional<ElementId>& on = event.pointer.on;
    if (!on) return {Placing{}, {}};
    if (on->kind != ElementKind::note) return {state, {}};
    return {Placing{NoteId(on->id)}, {}};
  }
  Outcome<State> operator()(const Placing& state, const Released& event) const {
    return {Idle{}, {WriteNote{event.pointer.at, state.note}}};
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

}  // namespace note_tool

namespace measure_tool {

std::string_view hint() {
  return toTranslate("Measure: click an axis, a pitch point or a gear");
}

}  // namespace measure_tool

namespace pan_tool {
namespace {

struct Transition {
  Outcome<State> operator()(const Idle&, const Pressed& event) const {
    return {Panning{event.pointer.at}, {}};
  }
  Outcome<State> operator()(const Panning& state, const Moved& event) const {
    return {state, {PanBy{event.pointer.at.x - state.grabbed.x, event.pointer.at.y - state.grabbed.y}}};
  }
  Outcome<State> operator()(const Panning&, const Released&) const { return {Idle{}, {}}; }
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

}  // namespace pan_tool
}  // namespace geargraph

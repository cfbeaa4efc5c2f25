#include "ui/tools/load_tool.h"

#include <algorithm>
#include <cmath>

#include "core/foundations/base/translation.h"

namespace geargraph::load_tool {
namespace {

/// How far the mouse was pulled, in clicks' slops: the sheet's y points down.
double pulled(CanvasPoint from, const Pointer& pointer) {
  return ((pointer.at.x - from.x) - (pointer.at.y - from.y)) / pointer.slop;
}

Step pull(const ElementId& element, CanvasPoint from, const Pointer& pointer) {
  const auto steps = static_cast<int>(std::lround(std::clamp(pulled(from, pointer), -1e4, 1e4)));
  return {Pulling{element, from}, PullTorque{element, steps, pointer.unsnapped}};
}

struct Transition {
  Step operator()(const Idle&, const Pressed& event) const {
    const std::optional<ElementId>& on = event.pointer.on;
    const bool canBearOne = on && (on->kind == ElementKind::turningJoint || on->kind == ElementKind::link);
    if (!canBearOne) return {Idle{}, {}};
    return {Grabbed{*on, event.pointer.at}, {}};
  }
  Step operator()(const Grabbed& state, const Moved& event) const {
    const CanvasPoint way{event.pointer.at.x - state.from.x, event.pointer.at.y - state.from.y};
    if (std::hypot(way.x, way.y) < event.pointer.slop) return {state, {}};
    return pull(state.element, state.from, event.pointer);
  }
  Step operator()(const Grabbed& state, const Released&) const { return {Idle{}, TypeTorque{state.element}}; }
  Step operator()(const Pulling& state, const Moved& event) const {
    return pull(state.element, state.from, event.pointer);
  }
  Step operator()(const Pulling&, const Released&) const { return {Idle{}, TorqueSet{}}; }
  Step operator()(const Pulling&, const Escaped&) const { return {Idle{}, TorquePutBack{}}; }
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

Step on(const State& state, const ToolEvent& event) {
  return std::visit(Transition{}, state, event);
}

std::string_view hint(const State& state) {
  if (std::holds_alternative<Idle>(state))
    return toTranslate(
        "Load: drag from a turning joint or a link for its torque, or click it and type 10 Nm");
  return toTranslate("Load: to the right or upwards is more; Alt: tenths. Esc puts back");
}

}  // namespace geargraph::load_tool

#include "ui/tools/joint_tool.h"

namespace geargraph::joint_tool {
namespace {

LinkId linkUnder(const Pointer& pointer) {
  const bool isLink = pointer.on && pointer.on->kind == ElementKind::link;
  return isLink ? LinkId(pointer.on->id) : LinkId();
}

LinkId linkUnder(const Pointer& pointer, LinkId other) {
  const LinkId link = linkUnder(pointer);
  return link == other ? LinkId() : link;
}

struct Transition {
  ElementKind kind;

  Outcome<State> operator()(const Idle& idle, const Pressed& event) const {
    const LinkId link = linkUnder(event.pointer);
    if (link.empty()) return {idle, {}};
    return {Dragging{link, {}, event.pointer.at}, {}};
  }
  Outcome<State> operator()(const Dragging& state, const Moved& event) const {
    return {Dragging{state.tail, linkUnder(event.pointer, state.tail), event.pointer.at}, {}};
  }
  Outcome<State> operator()(const Dragging& state, const Released& event) const {
    const LinkId link = linkUnder(event.pointer);
    if (link == state.tail) return {Picked{state.tail, {}, event.pointer.at}, {}};
    return finished(state.tail, link);
  }
  Outcome<State> operator()(const Picked& state, const Moved& event) const {
    return {Picked{state.tail, linkUnder(event.pointer, state.tail), event.pointer.at}, {}};
  }
  Outcome<State> operator()(const Picked& state, const Pressed& event) const {
    return finished(state.tail, linkUnder(event.pointer, state.tail));
  }
  template <class AnyState>
  Outcome<State> operator()(const AnyState&, const Escaped&) const {
    return {Idle{}, {}};
  }
  template <class AnyState, class AnyEvent>
  Outcome<State> operator()(const AnyState& state, const AnyEvent&) const {
    return {state, {}};
  }

  [[nodiscard]] Outcome<State> finished(LinkId tail, LinkId head) const {
    if (head.empty()) return {Idle{}, {}};
    return {Idle{}, {AddJoint{kind, tail, head}}};
  }
};

}  // namespace

Outcome<State> on(const State& state, const ToolEvent& event, ElementKind kind) {
  return std::visit(Transition{kind}, state, event);
}

}  // namespace geargraph::joint_tool

#include "ui/tools/tool_machine.h"

#include <utility>

#include "core/foundations/base/translation.h"

namespace geargraph {
namespace {

ElementKind jointKind(ToolKind tool) {
  return tool == ToolKind::gearMesh ? ElementKind::gearMesh : ElementKind::turningJoint;
}

template <class State>
std::vector<Proposal> step(State& state, Outcome<State> outcome) {
  state = std::move(outcome.next);
  return std::move(outcome.proposals);
}

std::string_view jointHint(const joint_tool::State& state, ToolKind tool) {
  const bool mesh = tool == ToolKind::gearMesh;
  if (std::holds_alternative<joint_tool::Idle>(state)) {
    return mesh ? toTranslate("Gear mesh: drag from a gear to the gear it drives")
                : toTranslate("Turning joint: drag from a link to the link it carries");
  }
  return mesh ? toTranslate("Gear mesh: release on the second gear. Esc cancels")
              : toTranslate("Turning joint: release on the link that is carried. Esc cancels");
}

std::string_view selectHint(const select_tool::State& state) {
  if (std::holds_alternative<select_tool::Moving>(state))
    return toTranslate("Alt places freely. Esc puts back");
  if (std::holds_alternative<select_tool::Banding>(state))
    return toTranslate("Release to select what is inside");
  return toTranslate("Click to select, drag to move, drag on an empty area to select several");
}

}  // namespace

std::string_view toolName(ToolKind tool) {
  switch (tool) {
    case ToolKind::select:
      return toTranslate("Select");
    case ToolKind::link:
      return toTranslate("Link");
    case ToolKind::turningJoint:
      return toTranslate("Turning joint");
    case ToolKind::gearMesh:
      return toTranslate("Gear mesh");
    case ToolKind::input:
      return toTranslate("Input");
    case ToolKind::load:
      return toTranslate("Load");
    case ToolKind::note:
      return toTranslate("Note");
    case ToolKind::measure:
      return toTranslate("Measure");
    case ToolKind::pan:
      return toTranslate("Pan");
  }
  return {};
}

char toolKey(ToolKind tool) {
  constexpr std::string_view kKeys = "VLTGIWNMH";
  return kKeys[static_cast<std::size_t>(tool)];
}

ToolMachine::ToolMachine(ToolKind tool) : m_tool(tool), m_state(firstState(tool)) {}

ToolMachine::State ToolMachine::firstState(ToolKind tool) {
  switch (tool) {
    case ToolKind::select:
      return select_tool::State{};
    case ToolKind::link:
      return link_tool::State{};
    case ToolKind::turningJoint:
    case ToolKind::gearMesh:
      return joint_tool::State{};
    case ToolKind::input:
      return input_tool::State{};
    case ToolKind::load:
      return load_tool::State{};
    case ToolKind::note:
      return note_tool::State{};
    case ToolKind::measure:
      return measure_tool::State{};
    case ToolKind::pan:
      return pan_tool::State{};
  }
  return {};
}

std::vector<Proposal> ToolMachine::on(const ToolEvent& event) {
  if (auto* select = std::get_if<select_tool::State>(&m_state)) {
    return step(*select, select_tool::on(*select, event));
  }
  if (auto* link = std::get_if<link_tool::State>(&m_state)) return step(*link, link_tool::on(*link, event));
  if (auto* joint = std::get_if<joint_tool::State>(&m_state)) {
    return step(*joint, joint_tool::on(*joint, event, jointKind(m_tool)));
  }
  if (auto* input = std::get_if<input_tool::State>(&m_state)) {
    return step(*input, input_tool::on(*input, event));
  }
  if (auto* note = std::get_if<note_tool::State>(&m_state)) return step(*note, note_tool::on(*note, event));
  // Loads are pulled with Select, too, and in every drawing: the view steps the tool itself. What is measured
  // is shared with the 3D view.
  if (std::holds_alternative<load_tool::State>(m_state)) return {};
  if (std::holds_alternative<measure_tool::State>(m_state)) return {};
  auto& pan = std::get<pan_tool::State>(m_state);
  return step(pan, pan_tool::on(pan, event));
}

bool ToolMachine::isIdle() const {
  // Every tool lists the state of rest first.
  return std::visit([](const auto& state) { return state.index() == 0; }, m_state);
}

std::string_view ToolMachine::hint() const {
  switch (m_tool) {
    case ToolKind::select:
      return selectHint(std::get<select_tool::State>(m_state));
    case ToolKind::link:
      return toTranslate("Link: click on an empty area");
    case ToolKind::turningJoint:
    case ToolKind::gearMesh:
      return jointHint(std::get<joint_tool::State>(m_state), m_tool);
    case ToolKind::input:
      return toTranslate("Input: click a turning joint, or the link it carries, to drive it or not");
    case ToolKind::load:
      return load_tool::hint(std::get<load_tool::State>(m_state));
    case ToolKind::note:
      return toTranslate("Note: click on an empty area, or on a note to change it");
    case ToolKind::measure:
      return measure_tool::hint();
    case ToolKind::pan:
      return toTranslate("Drag to move the sheet");
  }
  return {};
}

std::optional<RubberBand> ToolMachine::rubberBand() const {
  const auto* select = std::get_if<select_tool::State>(&m_state);
  const auto* band = select == nullptr ? nullptr : std::get_if<select_tool::Banding>(select);
  if (band == nullptr || !band->wide) return std::nullopt;
  return RubberBand{band->from, band->to};
}

std::optional<ArrowDraft> ToolMachine::arrowDraft() const {
  const auto* joint = std::get_if<joint_tool::State>(&m_state);
  if (joint == nullptr) return std::nullopt;
  const ElementKind kind = jointKind(m_tool);
  if (const auto* drag = std::get_if<joint_tool::Dragging>(joint)) {
    return ArrowDraft{kind, drag->tail, drag->over, drag->cursor};
  }
  if (const auto* picked = std::get_if<joint_tool::Picked>(joint)) {
    return ArrowDraft{kind, picked->tail, picked->over, picked->cursor};
  }
  return std::nullopt;
}

std::optional<CanvasPoint> ToolMachine::linkDraft() const {
  const auto* link = std::get_if<link_tool::State>(&m_state);
  if (link == nullptr) return std::nullopt;
  if (const auto* placing = std::get_if<link_tool::Placing>(link)) return placing->place;
  return std::get<link_tool::Hovering>(*link).place;
}

}  // namespace geargraph

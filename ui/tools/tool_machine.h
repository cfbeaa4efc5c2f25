#pragma once

#include "ui/tools/click_tools.h"
#include "ui/tools/joint_tool.h"
#include "ui/tools/load_tool.h"
#include "ui/tools/select_tool.h"

namespace geargraph {

/// A tool with its current state: passes events to the tool's transition function and gives what to show.
class ToolMachine {
 public:
  explicit ToolMachine(ToolKind tool);

  [[nodiscard]] ToolKind tool() const { return m_tool; }
  /// Goes to the next state and returns the tool's proposals, in order.
  std::vector<Proposal> on(const ToolEvent& event);

  /// Is no gesture in progress? Then Esc may mean something else.
  [[nodiscard]] bool isIdle() const;
  /// What the user can do next, as a sentence for the status bar.
  [[nodiscard]] std::string_view hint() const;
  [[nodiscard]] std::optional<RubberBand> rubberBand() const;
  [[nodiscard]] std::optional<ArrowDraft> arrowDraft() const;
  /// Where a click would now add a link.
  [[nodiscard]] std::optional<CanvasPoint> linkDraft() const;

 private:
  using State = std::variant<select_tool::State, link_tool::State, joint_tool::State, input_tool::State,
                             load_tool::State, note_tool::State, measure_tool::State, pan_tool::State>;
  [[nodiscard]] static State firstState(ToolKind tool);

  ToolKind m_tool;
  State m_state;
};

}  // namespace geargraph

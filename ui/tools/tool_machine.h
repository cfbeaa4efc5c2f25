#pragma once

#include "ui/tools/click_tools.h"
#include "ui/tools/joint_tool.h"
#include "ui/tools/load_tool.h"
#include "ui/tools/select_tool.h"

namespace geargraph::inline tools {

/// One tool in one of its states: feeds events to the tool's transition function and tells what to show.
class ToolMachine {
 public:
  explicit ToolMachine(ToolKind tool);

  [[nodiscard]] ToolKind tool() const { return m_tool; }
  /// Steps to the next state; what the tool wants done, in order.
  std::vector<Proposal> on(const ToolEvent& event);

  /// Nothing has been begun: Esc may mean something else.
  [[nodiscard]] bool isIdle() const;
  /// What the tool expects next, a sentence for the status bar.
  [[nodiscard]] std::string_view hint() const;
  [[nodiscard]] std::optional<RubberBand> rubberBand() const;
  [[nodiscard]] std::optional<ArrowDraft> arrowDraft() const;
  /// Where a link would come if the mouse were clicked now.
  [[nodiscard]] std::optional<SheetPoint> linkDraft() const;

 private:
  using State = std::variant<select_tool::State, link_tool::State, joint_tool::State, input_tool::State,
                             load_tool::State, note_tool::State, pan_tool::State>;
  [[nodiscard]] static State firstState(ToolKind tool);

  ToolKind m_tool;
  State m_state;
};

}  // namespace geargraph::inline tools

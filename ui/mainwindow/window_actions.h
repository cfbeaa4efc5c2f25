#pragma once

#include <QAction>
#include <QActionGroup>
#include <array>
#include <initializer_list>
#include <optional>
#include <vector>

#include "core/presentation/drawing/palette.h"
#include "ui/mainwindow/commands.h"
#include "ui/tools/tool.h"

class QMainWindow;

namespace geargraph {

/// The actions of the commands of a window, for menus and the tool bar, made from commandTable(). An
/// unavailable one is disabled, with the reason as its tool tip.
struct WindowActions {
  explicit WindowActions(QMainWindow* window);

  [[nodiscard]] QAction* operator[](CommandId command) const {
    return m_actions[static_cast<std::size_t>(command)];
  }
  [[nodiscard]] QList<QAction*> of(std::initializer_list<CommandId> commands) const;

  /// Enables what is possible now, and says why all else is not.
  void renew(const CommandState& now);
  /// Enables or disables an action; `why` becomes the tip of a disabled one.
  static void setAvailable(QAction* action, bool available, const QString& why);
  void setTheme(Theme theme, bool asSystem, double typeScale);

  QActionGroup* tools;
  std::array<QAction*, kToolCount> tool{};
  std::array<QAction*, 5> planets{};  ///< 2 to 6 planets like the selected one
  QActionGroup* typeSizes;            ///< with the scale as data

 private:
  QAction* make(const Command& command);
  void makeTools();
  void makePlanets();
  void makeTypeSizes();

  QMainWindow* m_window;
  std::vector<Command> m_commands;
  std::array<QAction*, kCommandCount> m_actions{};
  std::vector<std::pair<QAction*, QString>> m_icons;
  std::optional<Theme> m_iconTheme;  ///< that the icons have the colours of; none: not yet
};

}  // namespace geargraph

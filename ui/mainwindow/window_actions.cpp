#include "ui/mainwindow/window_actions.h"

#include <QMainWindow>
#include <string>
#include <utility>

#include "ui/help/search_entries.h"
#include "ui/theme/icons.h"

namespace geargraph {
namespace {

/// Where the tip of an enabled action is kept while it is disabled.
constexpr const char* kTip = "tip";

}  // namespace

QAction* WindowActions::make(const Command& command) {
  auto* action = new QAction(command.text, m_window);
  action->setObjectName(QLatin1String(command.name));
  action->setShortcuts(command.keys);
  action->setCheckable(command.isCheckable);
  action->setProperty(kSearchWords, QLatin1String(command.searchWords));
  QString full = command.tip;
  if (!command.keys.isEmpty())
    full += QStringLiteral(" (%1)").arg(command.keys.first().toString(QKeySequence::NativeText));
  action->setToolTip(full);
  action->setProperty(kTip, full);
  if (*command.icon != 0) m_icons.emplace_back(action, QLatin1String(command.icon));
  m_window->addAction(action);
  return action;
}

QList<QAction*> WindowActions::of(std::initializer_list<CommandId> commands) const {
  QList<QAction*> actions;
  for (const CommandId command : commands) actions << (*this)[command];
  return actions;
}

void WindowActions::renew(const CommandState& now) {
  for (const Command& command : m_commands) {
    if (command.whyNot == nullptr) continue;
    const QString why = command.whyNot(now);
    setAvailable((*this)[command.id], why.isEmpty(), why);
  }
  for (QAction* action : planets)
    setAvailable(action, now.links == 1 && !now.isOnlyGround(), QMainWindow::tr("Select one planet."));
  (*this)[CommandId::restoreSession]->setChecked(now.restoresSession);
}

void WindowActions::setAvailable(QAction* action, bool available, const QString& why) {
  action->setEnabled(available);
  action->setToolTip(available ? action->property(kTip).toString() : why);
}

void WindowActions::makeTools() {
  struct ToolEntry {
    ToolKind kind;
    const char* icon;
    QString tip;
    const char* searchWords = "";
  };
  const ToolEntry entries[] = {
      {ToolKind::select, "select", QMainWindow::tr("Select, move, and change what is drawn")},
      {ToolKind::link, "link", QMainWindow::tr("Draw links: click on an empty place")},
      {ToolKind::turningJoint, "turning-joint",
       QMainWindow::tr("Draw a turning joint: drag from a link to the link it carries")},
      {ToolKind::gearMesh, "gear-mesh",
       QMainWindow::tr("Draw a gear mesh: drag from a gear to the one it drives")},
      {ToolKind::input, "input",
       QMainWindow::tr("Drive a joint: click a turning joint or the link it carries")},
      {ToolKind::load, "load",
       QMainWindow::tr(
           "Load a joint or a link: drag for its torque, or click and type 10 Nm; where one is selected, "
           "its torque is typed at once")},
      {.kind = ToolKind::note,
       .icon = "note",
       .tip = QMainWindow::tr(
           "Write a note on the sheet of the digraph: click where it should be; a double click changes one"),
       .searchWords = "text comment label annotation write remark caption sticky post-it"},
      {.kind = ToolKind::measure,
       .icon = "measure",
       .tip = QMainWindow::tr(
           "Measure distances, angles and diameters: click an axis, a pitch point or a gear, then another "
           "one, in a drawing or in 3D"),
       .searchWords = "distance angle diameter centre center ruler dimension length caliper how far"},
      {ToolKind::pan, "pan",
       QMainWindow::tr("Move the sheet; the middle mouse button does so with any tool")},
  };
  tools = new QActionGroup(m_window);
  for (const ToolEntry& entry : entries) {
    const QString name = QMainWindow::tr(std::string(toolName(entry.kind)).c_str());
    const QChar key = QLatin1Char(toolKey(entry.kind));
    const std::string id = std::string("tool.") + entry.icon;
    QAction* action = make({.name = id.c_str(),
                            .text = name,
                            .tip = entry.tip,
                            .keys = {QKeySequence(QString(key))},
                            .icon = entry.icon,
                            .searchWords = entry.searchWords,
                            .isCheckable = true});
    action->setIconText(name + QStringLiteral("  ") + key);
    action->setData(static_cast<int>(entry.kind));
    tools->addAction(action);
    tool[static_cast<std::size_t>(entry.kind)] = action;
  }
  tool[static_cast<std::size_t>(ToolKind::select)]->setChecked(true);
}

WindowActions::WindowActions(QMainWindow* window) : m_window(window), m_commands(commandTable()) {
  for (const Command& command : m_commands) m_actions[static_cast<std::size_t>(command.id)] = make(command);
  auto* themes = new QActionGroup(m_window);
  for (QAction* theme : of({CommandId::asSystem, CommandId::light, CommandId::dark, CommandId::highContrast}))
    themes->addAction(theme);
  makeTools();
  makePlanets();
  makeTypeSizes();
}

void WindowActions::makePlanets() {
  for (std::size_t i = 0; i < planets.size(); ++i) {
    const QString count = QString::number(i + 2);
    const std::string id = "mechanism.planets" + count.toStdString();
    planets[i] =
        make({.name = id.c_str(),
              .text = QMainWindow::tr("%1 planets").arg(count),
              .tip = QMainWindow::tr("Copies of the selected planet, equally spaced, %1 in all").arg(count)});
  }
}

void WindowActions::makeTypeSizes() {
  typeSizes = new QActionGroup(m_window);
  for (const int percent : {90, 100, 115, 130, 150, 200}) {
    const std::string id = "view.typeSize" + std::to_string(percent);
    QAction* size =
        make({.name = id.c_str(),
              .text = QMainWindow::tr("%1 %").arg(percent),
              .tip = QMainWindow::tr("Words of the window at %1 % of their size").arg(percent),
              .searchWords = percent == 150 ? "font larger bigger text letters size accessibility" : "",
              .isCheckable = true});
    size->setData(percent / 100.0);
    typeSizes->addAction(size);
  }
}

void WindowActions::setTheme(Theme theme, bool isAsSystem, double typeScale) {
  if (std::exchange(m_iconTheme, theme) != theme) {
    for (const auto& [action, name] : m_icons) action->setIcon(icon(name, ColorRole::ink, theme));
  }
  const CommandId chosen = theme == Theme::light  ? CommandId::light
                           : theme == Theme::dark ? CommandId::dark
                                                  : CommandId::highContrast;
  (*this)[isAsSystem ? CommandId::asSystem : chosen]->setChecked(true);
  for (QAction* size : typeSizes->actions()) {
    if (size->data().toDouble() == typeScale) size->setChecked(true);
  }
}

}  // namespace geargraph

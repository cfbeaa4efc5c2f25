#include "ui/mainwindow/window_help.h"

#include <QApplication>
#include <QDialog>
#include <QDockWidget>
#include <QKeyEvent>
#include <QMainWindow>
#include <QMenu>
#include <QMenuBar>
#include <algorithm>

#include "ui/help/help_page_of.h"
#include "ui/help/help_window.h"
#include "ui/help/search_entries.h"
#include "ui/help/search_field.h"
#include "ui/help/tour.h"
#include "ui/help/whats_this.h"
#include "ui/settings/settings.h"

namespace geargraph {
namespace {

constexpr const char* kTourOffered = "tourOffered";

/// The window that a widget of a dialog belongs to in the end, also where the dialog is another one's.
const QWidget* outermost(const QWidget* widget) {
  while (widget->parentWidget() != nullptr) widget = widget->parentWidget();
  return widget;
}

}  // namespace

WindowHelp::WindowHelp(QMainWindow* window, TourStage stage)
    : QObject(window), m_window(window), m_stage(std::move(stage)) {
  new WhatsThis(window);
  qApp->installEventFilter(this);
}

void WindowHelp::showPage(const QString& pageAndAnchor) {
  if (m_manual == nullptr) {
    m_manual = new HelpWindow(m_window);
    connect(m_manual, &HelpWindow::commandWanted, this, &WindowHelp::runCommand);
    connect(m_manual, &HelpWindow::lessonWanted, this, &WindowHelp::lessonWanted);
  }
  m_manual->open(pageAndAnchor);
  m_manual->show();
  m_manual->raise();
  m_manual->activateWindow();
}

void WindowHelp::showPageForFocus() {
  const QWidget* focus = QApplication::focusWidget();
  const QString page = focus == nullptr ? QString() : helpPageOf(focus);
  showPage(page.isEmpty() ? QStringLiteral("first-steps") : page);
}

void WindowHelp::runCommand(const QString& menuPath) {
  QAction* command = commandAt(*m_window->menuBar(), menuPath);
  if (command == nullptr) return emit rejected(tr("There is no command %1 in this window.").arg(menuPath));
  if (!command->isEnabled()) return emit rejected(command->toolTip());
  m_window->activateWindow();
  m_window->raise();
  if (command->menu() != nullptr) return command->menu()->popup(QCursor::pos());
  const bool isShown = command->property(kRevealsPanel).toBool() && command->isChecked();
  if (!isShown) command->trigger();
}

/// In the dialogs of the window, which its own key does not reach.
bool WindowHelp::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() != QEvent::KeyPress || !watched->isWidgetType())
    return QObject::eventFilter(watched, event);
  const auto* widget = static_cast<QWidget*>(watched);
  const auto* key = static_cast<QKeyEvent*>(event);
  const bool isHelp = key->key() == Qt::Key_F1 && key->modifiers() == Qt::NoModifier;
  const bool isMine = isHelp && widget->window() != m_window && outermost(widget) == m_window &&
                      qobject_cast<QDialog*>(widget->window()) != nullptr;
  if (!isMine) return QObject::eventFilter(watched, event);
  showPage(helpPageOf(widget));
  return true;
}

// --- the tour ---------------------------------------------------------------------------------------------

QRect WindowHelp::areaOf(const QWidget* part) const {
  if (part == nullptr || !part->isVisible()) return {};
  return {part->mapTo(m_window, QPoint()), part->size()};
}

QRegion WindowHelp::searchAndLearn() const {
  const QMenuBar* menus = m_window->menuBar();
  QRegion area = areaOf(m_window->findChild<SearchField*>(QStringLiteral("search"))).adjusted(-4, -4, 4, 4);
  for (QAction* top : menus->actions()) {
    const QList<QAction*> inside = top->menu() != nullptr ? top->menu()->actions() : QList<QAction*>();
    const bool isMeant = std::any_of(inside.begin(), inside.end(), [](const QAction* action) {
      return action->objectName() == QLatin1String("learn.lessons");
    });
    if (isMeant) area += menus->actionGeometry(top).translated(menus->mapTo(m_window, QPoint()));
  }
  return area;
}

TourStep WindowHelp::panelStep(const QString& view, const QString& title, const QString& text) {
  QDockWidget* const panel = m_stage.panel(view);
  return {title, text,
          [panel] {
            panel->show();
            panel->raise();
          },
          [this, panel] { return areaOf(panel); }};
}

TourStep WindowHelp::drawingStep(const QString& drawing, const QString& title, const QString& text) {
  return {title, text, [this, drawing] { m_stage.showDrawing(drawing); },
          [this] { return areaOf(m_window->centralWidget()); }};
}

std::vector<TourStep> WindowHelp::tourSteps() {
  std::vector<TourStep> steps;
  steps.push_back(
      {tr("Welcome to GearGraph"),
       tr("Gear trains as graphs, as equations, and in motion. The tour shows the parts of the window "
          "with a robot as example; it takes two minutes. Help > Tour repeats it."),
       {},
       {}});
  TourStep drawing = drawingStep(
      QStringLiteral("digraph"), tr("Draw links, joints and meshes"),
      tr("Each circle is a link, each solid arrow a turning joint, each dashed arrow a pair of gears. Press "
         "L and "
         "click for a link, T or G and drag from one link to another. Everything can be undone."));
  drawing.prepare = [this, show = drawing.prepare] {
    m_stage.begin();
    show();
  };
  steps.push_back(std::move(drawing));
  steps.push_back(
      panelStep(QStringLiteral("matrices"), tr("The Matroid method"),
                tr("The matrices follow from the drawing at once. Rest the mouse on an entry to have it "
                   "explained; the arrow "
                   "that it stands for lights up. Each row of C is the cycle that a mesh closes.")));
  steps.push_back(drawingStep(
      QStringLiteral("ttgraph"), tr("The T–T graph method"),
      tr("The same mechanism by the second method: levels on the branches, two chords for each mesh, carrier "
         "arms "
         "with a second ring. Select a mesh to see its equations. Both methods give the same speeds.")));
  steps.push_back(panelStep(QStringLiteral("view3d"), tr("The gears in motion"),
                            tr("Space plays. Drag a gear to turn the train by hand, drag elsewhere to look "
                               "from another side. Section "
                               "cuts it open.")));
  steps.push_back(panelStep(QStringLiteral("inputs"), tr("Motors and speeds"),
                            tr("The sliders set the speeds of the motors. Below are the speeds of all other "
                               "joints: as formulas in the "
                               "gear ratios, and as they are now.")));
  steps.push_back(panelStep(QStringLiteral("problems"), tr("When something is wrong"),
                            tr("Problems says what is wrong, where, and what to do. A click on a line shows "
                               "the place, and many lines "
                               "bring a button that mends it.")));
  steps.push_back(
      {tr("Learn, and find anything"),
       tr("Learn > Lessons is a course from one gear pair to this robot. Ctrl+K finds commands, terms and "
          "pages of the manual. F1 opens the page about what you are working with."),
       [this] {
         m_stage.showDrawing(QStringLiteral("digraph"));
         m_stage.panel(QStringLiteral("matrices"))->raise();
       },
       [this] { return searchAndLearn(); }});
  return steps;
}

void WindowHelp::startTour() {
  if (m_tour != nullptr) return;
  if (const QString why = m_stage.unavailableReason(); !why.isEmpty()) return emit rejected(why);
  m_tour = new Tour(tourSteps(), m_window);
  connect(m_tour, &Tour::ended, this, [this] { m_stage.end(); });
}

void WindowHelp::offerTour() {
  if (savedSetting(QLatin1String(kTourOffered), false).toBool()) return;
  saveSetting(QLatin1String(kTourOffered), true);
  startTour();
}

}  // namespace geargraph

#include "moc_window_help.cpp"

#include "ui/mainwindow/view_docks.h"

#include <QAction>
#include <QApplication>
#include <algorithm>
#include <map>
#include <utility>

#include "ui/help/help_page_of.h"
#include "ui/help/search_entries.h"
#include "ui/mainwindow/dock_titles.h"
#include "ui/mainwindow/layout_pause.h"
#include "ui/mainwindow/presentation.h"
#include "ui/mainwindow/window_actions.h"

namespace geargraph {

ViewDocks::ViewDocks(QMainWindow* window, std::function<void()> leave)
    : QObject(window), m_window(window), m_leave(std::move(leave)), m_titles(new DockTitles(window)) {}

QDockWidget* ViewDocks::add(const ViewEntry& entry, ResultsView& view) {
  auto* dock = new QDockWidget(entry.title, m_window);
  dock->setObjectName(QStringLiteral("dock.") + entry.id);
  dock->setProperty(kHelpPage, entry.helpPage);
  dock->setProperty(kPurpose, entry.purpose);
  dock->setProperty(Presentation::kIsPresented, entry.isPresented);
  dock->setWidget(&view.widget());
  // Keys would change what is not seen.
  connect(dock, &QDockWidget::visibilityChanged, this, [this, dock](bool isSeen) {
    const QWidget* focus = QApplication::focusWidget();
    if (!isSeen && focus != nullptr && dock->isAncestorOf(focus)) m_leave();
  });
  connect(dock, &QDockWidget::visibilityChanged, &view.widget(),
          [&view](bool isSeen) { view.setAwake(isSeen); });
  connect(&view.widget(), &QWidget::windowTitleChanged, dock, &QWidget::setWindowTitle);
  QDockWidget* before = nullptr;
  for (const Panel& each : m_panels)
    if (each.entry.place == entry.place) before = each.dock;
  Panel& made = m_panels.emplace_back(Panel{entry, &view, dock, nullptr});
  makeAction(made);
  m_titles->watch(dock);
  place(made, before);
  return dock;
}

/// Qt's own action hides a panel that lies behind the tab of another.
void ViewDocks::makeAction(Panel& panel) {
  QDockWidget* dock = panel.dock;
  auto* action = new QAction(dock->windowTitle(), dock);
  action->setObjectName(dock->objectName());
  action->setCheckable(true);
  action->setProperty(kRevealsPanel, true);
  action->setProperty(kSearchWords, panel.entry.searchWords);
  constexpr std::size_t kMaxAltKeys = 10;  // the tenth has 0
  if (m_panels.size() <= kMaxAltKeys)
    action->setShortcut(QKeySequence(QStringLiteral("Alt+%1").arg(m_panels.size() % kMaxAltKeys)));
  connect(dock, &QDockWidget::visibilityChanged, action, &QAction::setChecked);
  connect(action, &QAction::triggered, dock, [dock](bool isWanted) {
    dock->setVisible(isWanted);
    if (isWanted) dock->raise();
  });
  m_window->addAction(action);
  panel.action = action;
}

const ViewDocks::Panel& ViewDocks::panel(const ResultsView& view) const {
  const auto found =
      std::find_if(m_panels.begin(), m_panels.end(), [&](const Panel& each) { return each.view == &view; });
  GEARGRAPH_REQUIRE(found != m_panels.end());
  return *found;
}

QDockWidget* ViewDocks::firstAt(ViewPlace place) const {
  const auto found = std::find_if(m_panels.begin(), m_panels.end(),
                                  [&](const Panel& each) { return each.entry.place == place; });
  return found == m_panels.end() ? nullptr : found->dock;
}

QList<QAction*> ViewDocks::actions() const {
  QList<QAction*> actions;
  for (const Panel& each : m_panels) actions << each.action;
  return actions;
}

void ViewDocks::reveal(const ResultsView& view) {
  of(view)->show();
  of(view)->raise();
}

/// Each goes straight into its tab: docks beside each other, if only for a moment, make the window wider than
/// a projector.
void ViewDocks::place(const Panel& panel, QDockWidget* before) {
  if (before != nullptr) return m_window->tabifyDockWidget(before, panel.dock);
  switch (panel.entry.place) {
    case ViewPlace::drawings:
      GEARGRAPH_REQUIRE(false);
      return;
    case ViewPlace::bottom:
      return m_window->addDockWidget(Qt::BottomDockWidgetArea, panel.dock);
    case ViewPlace::left:
      return m_window->addDockWidget(Qt::LeftDockWidgetArea, panel.dock);
    case ViewPlace::top:
      return m_window->addDockWidget(Qt::RightDockWidgetArea, panel.dock);
    case ViewPlace::right:
      if (QDockWidget* above = firstAt(ViewPlace::top))
        return m_window->splitDockWidget(above, panel.dock, Qt::Vertical);
      return m_window->addDockWidget(Qt::RightDockWidgetArea, panel.dock);
  }
}

void ViewDocks::putAway() {
  if (arePutAway()) return;
  m_away = m_window->saveState();
  const LayoutPause pause(m_window);
  for (const Panel& each : m_panels)
    if (!each.dock->isFloating()) each.dock->hide();
}

void ViewDocks::bringBack() {
  if (!arePutAway()) return;
  const LayoutPause pause(m_window);
  m_window->restoreState(std::exchange(m_away, {}));
}

void ViewDocks::reset() {
  m_away.clear();
  {
    const LayoutPause pause(m_window);
    // Those that a lesson keeps closed, and those that it has opened, stay so.
    std::vector<QDockWidget*> shown;
    for (const Panel& each : m_panels) {
      if (each.action->isEnabled() || !each.dock->isHidden()) shown.push_back(each.dock);
      if (each.dock->isFloating()) each.dock->setFloating(false);  // hides and shows it, floating or not
      m_window->removeDockWidget(each.dock);
    }
    std::map<ViewPlace, QDockWidget*> last;
    for (const Panel& each : m_panels) place(each, std::exchange(last[each.entry.place], each.dock));
    for (const Panel& each : m_panels)
      each.dock->setVisible(std::find(shown.begin(), shown.end(), each.dock) != shown.end());
  }
  QDockWidget* const bottom = firstAt(ViewPlace::bottom);
  QDockWidget* const top = firstAt(ViewPlace::top);
  QDockWidget* const right = firstAt(ViewPlace::right);
  const QSize size = m_window->size();
  m_window->resizeDocks({right}, {size.width() * 41 / 100}, Qt::Horizontal);
  m_window->resizeDocks({bottom}, {size.height() * 36 / 100}, Qt::Vertical);
  m_window->resizeDocks({top, right}, {size.height() * 46 / 100, size.height() * 54 / 100}, Qt::Vertical);
  bottom->raise();
}

void ViewDocks::setAnswersOpen(bool isOpen, const QString& why) {
  for (const Panel& each : m_panels) {
    if (!each.entry.holdsAnswers) continue;
    WindowActions::setAvailable(each.action, isOpen, why);
    if (!isOpen) each.dock->hide();
  }
}

void ViewDocks::showForDrawing(bool isDrawn) {
  for (const Panel& each : m_panels)
    if (each.entry.servesDrawing) each.dock->setVisible(isDrawn);
}

void ViewDocks::showOnly(const std::vector<const ResultsView*>& views) {
  for (const Panel& each : m_panels)
    each.dock->setVisible(std::find(views.begin(), views.end(), each.view) != views.end());
}

}  // namespace geargraph

#include "moc_view_docks.cpp"

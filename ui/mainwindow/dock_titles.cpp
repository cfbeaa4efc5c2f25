#include "ui/mainwindow/dock_titles.h"

#include <QAbstractButton>
#include <QChildEvent>
#include <QDockWidget>
#include <QStyle>
#include <QStyleOption>

namespace geargraph {

DockTitles::DockTitles(QMainWindow* window) : QObject(window), m_window(window) {
  connect(window, &QMainWindow::tabifiedDockWidgetActivated, this, &DockTitles::updateSoon);
  window->installEventFilter(this);
}

bool DockTitles::eventFilter(QObject* watched, QEvent* event) {
  if (watched == m_window && event->type() == QEvent::ChildPolished) {
    QObject* child = static_cast<QChildEvent*>(event)->child();
    if (child->inherits("QDockWidgetGroupWindow")) child->installEventFilter(this);
  }
  if (watched == m_window && event->type() == QEvent::PaletteChange) updateButtons();
  if (watched == m_window || event->type() != QEvent::Close) return QObject::eventFilter(watched, event);
  for (auto* dock : watched->findChildren<QDockWidget*>(QString(), Qt::FindDirectChildrenOnly)) dock->close();
  event->ignore();  // it hides itself when it is empty
  return true;
}

void DockTitles::watch(QDockWidget* dock) {
  m_docks << dock;
  connect(dock, &QDockWidget::topLevelChanged, this, &DockTitles::updateSoon);
  connect(dock, &QDockWidget::dockLocationChanged, this, &DockTitles::updateSoon);
  connect(dock, &QDockWidget::visibilityChanged, this, &DockTitles::updateSoon);
  updateSoon();
}

/// When the move that is under way has ended: a dock must not lose its title bar in the middle of a drag.
void DockTitles::updateSoon() {
  if (m_pending) return;
  m_pending = true;
  QMetaObject::invokeMethod(this, &DockTitles::renew, Qt::QueuedConnection);
}

void DockTitles::renew() {
  m_pending = false;
  for (QDockWidget* dock : std::as_const(m_docks)) {
    const bool tabbed = !dock->isFloating() && !m_window->tabifiedDockWidgets(dock).isEmpty();
    const bool bare = dock->titleBarWidget() != nullptr;
    if (tabbed == bare) continue;
    QWidget* old = dock->titleBarWidget();
    dock->setTitleBarWidget(tabbed ? new QWidget(dock) : nullptr);
    delete old;
  }
}

/// Qt asks the style for their pictures when it makes a title bar, and not again for another theme.
void DockTitles::updateButtons() {
  const std::pair<QString, QStyle::StandardPixmap> buttons[] = {
      {QStringLiteral("qt_dockwidget_closebutton"), QStyle::SP_TitleBarCloseButton},
      {QStringLiteral("qt_dockwidget_floatbutton"), QStyle::SP_TitleBarNormalButton}};
  QStyleOption option;
  option.palette = m_window->palette();
  for (QDockWidget* dock : std::as_const(m_docks)) {
    for (const auto& [name, picture] : buttons) {
      auto* button = dock->findChild<QAbstractButton*>(name, Qt::FindDirectChildrenOnly);
      if (button != nullptr) button->setIcon(dock->style()->standardIcon(picture, &option, dock));
    }
  }
}

}  // namespace geargraph

#include "moc_dock_titles.cpp"

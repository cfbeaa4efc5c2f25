#include "ui/mainwindow/presentation.h"

#include <QDockWidget>
#include <QLabel>
#include <QMainWindow>
#include <QMenuBar>
#include <QSettings>
#include <QStatusBar>
#include <QTimer>
#include <QToolBar>

namespace geargraph::inline mainwindow {
namespace {

constexpr int kHintMilliseconds = 5000;
const QString kLayoutKey = QStringLiteral("presentation/state");

}  // namespace

Presentation::Presentation(QMainWindow* window) : QObject(window), m_window(window) {}

void Presentation::setBarsVisible(bool visible) {
  m_window->menuBar()->setVisible(visible);
  m_window->statusBar()->setVisible(visible);
  m_window->findChild<QToolBar*>(QStringLiteral("toolBar"))->setVisible(visible);
}

/// The panels of the last presentation; at first the matrices alone, below the drawing.
void Presentation::choosePanels() {
  const QByteArray layout = QSettings().value(kLayoutKey).toByteArray();
  if (!layout.isEmpty() && m_window->restoreState(layout)) return;
  for (auto* dock : m_window->findChildren<QDockWidget*>()) {
    dock->setVisible(dock->objectName() == QLatin1String("dock.matrices"));
  }
}

void Presentation::setOn(bool on) {
  if (on == m_on) return;
  m_on = on;
  on ? enter() : leave();
}

void Presentation::enter() {
  m_workLayout = m_window->saveState();
  m_workGeometry = m_window->saveGeometry();
  m_workState = m_window->windowState();
  setBarsVisible(false);
  choosePanels();
  m_window->setWindowState(m_workState | Qt::WindowFullScreen);
  emit changed(true);
  showHint();
}

/// The type shrinks first: large panels would push the window wider than it was.
void Presentation::leave() {
  QSettings().setValue(kLayoutKey, m_window->saveState());
  delete m_hint;
  m_hint = nullptr;
  emit changed(false);
  m_window->setWindowState(m_workState);
  setBarsVisible(true);
  m_window->restoreState(m_workLayout);
  m_window->restoreGeometry(m_workGeometry);
}

void Presentation::showHint() {
  m_hint = new QLabel(tr("F11 ends the presentation.  Alt+1, Alt+2, … show and hide panels."), m_window);
  m_hint->setObjectName(QStringLiteral("presentationHint"));
  m_hint->setProperty("look", "toast");
  m_hint->setAttribute(Qt::WA_TransparentForMouseEvents);
  m_hint->adjustSize();
  m_hint->move((m_window->width() - m_hint->width()) / 2, 48);
  m_hint->show();
  m_hint->raise();
  QTimer::singleShot(kHintMilliseconds, m_hint, &QWidget::hide);
}

}  // namespace geargraph::inline mainwindow

// The panels of a window round its drawing: which comes to the front, and the layout that is restored when
// the window is shown.

#include <QApplication>
#include <QScreen>
#include <algorithm>

#include "ui/canvas/drawing_view.h"
#include "ui/forces/inputs_and_results.h"
#include "ui/mainwindow/main_window.h"
#include "ui/mainwindow/notice_bar.h"
#include "ui/mainwindow/view_docks.h"
#include "ui/panels/gearbox_panel.h"
#include "ui/panels/matrices_panel.h"
#include "ui/panels/problems_panel.h"
#include "ui/settings/settings.h"
#include "ui/theme/in_sight.h"

namespace geargraph {
namespace {

constexpr int kTitleBar = 40;  // px: at most that of a window manager

/// What somebody who opens a document has to know before anything else. A harmless remark is not.
bool isUrgent(const Diagnostic& diagnostic) {
  if (diagnostic.code == Code::disconnected) return false;  // the next stroke repairs it
  return diagnostic.severity() == Severity::error || diagnostic.code == Code::locked ||
         diagnostic.code == Code::assembly;
}

/// Is the widget in a panel that is covered by another tab?
bool isCovered(const QWidget* widget) {
  while (widget != nullptr && qobject_cast<const QDockWidget*>(widget) == nullptr)
    widget = widget->parentWidget();
  return widget != nullptr && !isInSight(*widget);
}

}  // namespace

bool MainWindow::focusNextPrevChild(bool next) {
  const QWidget* first = focusWidget();
  do {
    if (!QMainWindow::focusNextPrevChild(next)) return false;
  } while (focusWidget() != first && isCovered(focusWidget()));
  return true;
}

/// Kept at once, for the windows to come: without that the next one would have the layout before.
void MainWindow::resetLayout() {
  applyDefaultLayout();
  // A lesson's panels are others.
  if (m_lesson == nullptr) saveSetting(QStringLiteral("window/state"), workLayout().state);
}

void MainWindow::applyDefaultLayout() {
  m_docks->reset();
  raiseResults();
}

void MainWindow::restoreLayout() {
  restoreLayout(savedSetting(QStringLiteral("window/geometry")).toByteArray(),
                savedSetting(QStringLiteral("window/state")).toByteArray());
}

void MainWindow::restoreLayout(const QByteArray& geometry, const QByteArray& state) {
  if (!geometry.isEmpty()) {
    restoreGeometry(geometry);
  } else if (const QSize room = screen()->availableSize();
             room.height() < height() + kTitleBar && room.width() >= minimumSizeHint().width()) {
    setWindowState(Qt::WindowMaximized);  // else the status bar would lie below the screen
  }
  m_layout = state;
}

void MainWindow::showEvent(QShowEvent* event) {
  QMainWindow::showEvent(event);
  if (m_layoutApplied) return;
  m_layoutApplied = true;
  // Not before: a window that has no size yet squeezes its docks.
  if (m_layout.isEmpty() || !restoreState(m_layout)) applyDefaultLayout();
  giveRoom();
  m_notices->renew();
  drawing().setFocus();
}

/// Before the window is shown its docks have no layout that could be brought back.
void MainWindow::giveRoom() {
  if (!m_layoutApplied) return;
  const bool wantsRoom = m_drawings->currentWidget()->property(kWantsRoom).toBool();
  wantsRoom ? m_docks->putAway() : m_docks->bringBack();
}

Presentation::Layout MainWindow::workLayout() const {
  Presentation::Layout layout = m_presentation->workLayout();
  if (m_docks->arePutAway()) layout.state = m_docks->layout();
  return layout;
}

/// Of the panels of results the one that this document is about.
void MainWindow::raiseResults() {
  const bool shifts = !m_document->mechanism()->states.empty();
  const ResultsView& results =
      shifts ? static_cast<const ResultsView&>(gearbox()) : m_views->get<InputsAndResults>();
  m_docks->of(results)->raise();
}

/// Another document has been opened: what it needs first comes to the front, once it is known.
void MainWindow::onOpened() {
  const bool isGearbox = !m_document->mechanism()->states.empty();
  if (isGearbox || isInSight(gearbox())) raiseResults();
  m_isOpened = true;
}

void MainWindow::raiseProblems(const AnalysisSnapshot& snapshot) {
  if (!m_isOpened) return;
  if (std::any_of(snapshot.diagnostics.begin(), snapshot.diagnostics.end(), isUrgent)) {
    m_docks->of(problems())->raise();
  } else if (snapshot.isComplete && isInSight(problems())) {
    m_docks->of(matrices())->raise();
  }
  m_isOpened = !snapshot.isComplete;
}

}  // namespace geargraph

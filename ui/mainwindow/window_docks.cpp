// The panels of a window round its drawing: which there are, where they stand, and which comes to the front;
// and the layout that is restored when the window is shown.

#include <QAction>
#include <QApplication>
#include <QBoxLayout>
#include <QDockWidget>
#include <QFrame>
#include <QScreen>
#include <algorithm>

#include "ui/derivation/derivation_panel.h"
#include "ui/dynamics/dynamics_panel.h"
#include "ui/forces/duality_line.h"
#include "ui/forces/forces_caption.h"
#include "ui/forces/forces_panel.h"
#include "ui/forces/torque_rows.h"
#include "ui/mainwindow/dock_drag.h"
#include "ui/mainwindow/dock_titles.h"
#include "ui/mainwindow/layout_pause.h"
#include "ui/mainwindow/main_window.h"
#include "ui/mainwindow/notice_bar.h"
#include "ui/panels/gearbox_panel.h"
#include "ui/panels/inputs_panel.h"
#include "ui/panels/matrices_panel.h"
#include "ui/panels/matrix_view.h"
#include "ui/panels/problems_panel.h"
#include "ui/panels/properties_panel.h"
#include "ui/panels/results_panel.h"
#include "ui/search/search_entries.h"
#include "ui/settings/settings.h"
#include "ui/theme/in_sight.h"
#include "ui/view3d/motion_panel.h"
#include "ui/view3d/view3d.h"

namespace geargraph::inline mainwindow {
namespace {

constexpr int kTitleBar = 40;  // px: at most that of a window manager

/// What somebody who opens a document has to know before anything else. A harmless remark is not.
bool isUrgent(const Diagnostic& diagnostic) {
  if (diagnostic.code == Code::disconnected) return false;  // the next stroke repairs it
  return diagnostic.severity() == Severity::error || diagnostic.code == Code::locked ||
         diagnostic.code == Code::assembly;
}

/// The entry that an equation of speeds and its dual of torques share is framed in Matrices, too: a click on
/// it shows it there, in P or where that is too large in Q, and the cell under the mouse there is shown in
/// Forces.
void wireSharedEntry(DualityLine& line, MatricesPanel& matrices, QDockWidget& dock) {
  MatrixView& view = matrices.view();
  QObject::connect(&line, &DualityLine::entryChanged, &view, &MatrixView::setFramed);
  QObject::connect(&view, &MatrixView::entryHovered, &line, &DualityLine::pointAt);
  QObject::connect(&line, &DualityLine::entryWanted, &matrices, [&matrices, &view, &dock] {
    dock.show();
    dock.raise();
    matrices.showQuantity(QuantityKind::coefficients);
    if (!view.showFramed()) matrices.showMatrix(MatrixKind::cutset);
    view.showFramed();
  });
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

QDockWidget* MainWindow::addDock(const char* name, const QString& title, QWidget* widget) {
  auto* dock = new QDockWidget(title, this);
  dock->setObjectName(QLatin1String(name));
  dock->setWidget(widget);
  m_docks.push_back(dock);
  // Keys would change what is not seen.
  connect(dock, &QDockWidget::visibilityChanged, this, [this, dock](bool isSeen) {
    const QWidget* focus = QApplication::focusWidget();
    if (!isSeen && focus != nullptr && dock->isAncestorOf(focus)) drawing().setFocus();
  });
  addAction(makePanelAction(dock));
  m_titles->watch(dock);
  return dock;
}

/// Shows the panel; hides it where it is in front already. Qt's own action hides a panel that lies behind the
/// tab of another.
QAction* MainWindow::makePanelAction(QDockWidget* dock) {
  auto* action = new QAction(dock->windowTitle(), dock);
  action->setObjectName(dock->objectName());
  action->setCheckable(true);
  action->setProperty(kRevealsPanel, true);
  constexpr std::size_t kMaxKeys = 10;  // the tenth has 0
  if (m_docks.size() <= kMaxKeys)
    action->setShortcut(QKeySequence(QStringLiteral("Alt+%1").arg(m_docks.size() % kMaxKeys)));
  connect(dock, &QDockWidget::visibilityChanged, action, &QAction::setChecked);
  connect(action, &QAction::triggered, dock, [dock](bool isWanted) {
    dock->setVisible(isWanted);
    if (isWanted) dock->raise();
  });
  m_panelActions.push_back(action);
  return action;
}

QWidget* MainWindow::makeInputsAndResults() {
  auto* both = new QWidget(this);
  auto* layout = new QVBoxLayout(both);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(0);
  m_inputs = new InputsPanel(m_document, m_selection, both);
  connect(m_results, &ResultsPanel::inputsWanted, m_inputs, &InputsPanel::drive);
  layout->addWidget(m_inputs);
  layout->addWidget(new TorqueRows(m_document, m_selection, &m_workbench->forces(), both));
  auto* rule = new QFrame(both);
  rule->setProperty("look", "rule");
  rule->setFixedHeight(1);
  layout->addWidget(rule);
  layout->addWidget(m_results, 1);
  return both;
}

void MainWindow::makeDocks() {
  new DockDrag(this);
  m_matrices = new MatricesPanel(m_selection, this);
  m_problems = new ProblemsPanel(m_selection, this);
  m_properties = new PropertiesPanel(m_document, m_selection, this);
  m_results = new ResultsPanel(m_selection, this);
  addDock("dock.matrices", tr("Matrices"), m_matrices);
  QDockWidget* problems = addDock("dock.problems", tr("Problems"), m_problems);
  m_view3d = new View3D(m_selection, this);
  addDock("dock.view3d", tr("3D"), m_view3d);
  QDockWidget* results = addDock("dock.inputs", tr("Inputs and results"), makeInputsAndResults());
  connect(results, &QDockWidget::visibilityChanged, m_results, &ResultsPanel::setAwake);
  m_gearbox = new GearboxPanel(m_document, m_selection, this);
  QDockWidget* gearbox = addDock("dock.gearbox", tr("Gearbox"), m_gearbox);
  connect(m_gearbox, &GearboxPanel::torquesWanted, &m_workbench->forces(),
          [this](bool wanted) { m_workbench->forces().setWatched(m_gearbox, wanted); });
  connect(gearbox, &QDockWidget::visibilityChanged, m_gearbox, &GearboxPanel::setAwake);
  addDock("dock.properties", tr("Properties"), m_properties);
  m_motion = new MotionPanel(m_selection, m_view3d, this);
  addDock("dock.speeds", tr("Speeds"), m_motion);
  m_derivation = new DerivationPanel(m_selection, this);
  QDockWidget* derivation = addDock("dock.derivation", tr("Derivation"), m_derivation);
  connect(derivation, &QDockWidget::visibilityChanged, m_derivation, &DerivationPanel::setAwake);
  m_forces = new ForcesPanel(m_document, m_selection, &m_workbench->forces(), this);
  QDockWidget* forces = addDock("dock.forces", tr("Forces"), m_forces);
  connect(forces, &QDockWidget::visibilityChanged, m_forces, &ForcesPanel::setAwake);
  m_dynamics = new DynamicsPanel(m_document, m_selection, m_view3d, this);
  QDockWidget* dynamics = addDock("dock.dynamics", tr("Dynamics"), m_dynamics);
  connect(dynamics, &QDockWidget::visibilityChanged, m_dynamics, &DynamicsPanel::setAwake);
  connect(m_problems, &ProblemsPanel::countChanged, problems,
          [problems](int count) { problems->setWindowTitle(tr("Problems %1").arg(count)); });
  m_view3d->setForces(nullptr, forcesCaption(nullptr));
  wireSharedEntry(m_forces->dualityLine(), *m_matrices, *dock("dock.matrices"));
  placeDocks();
}

QDockWidget* MainWindow::dock(const char* name) const {
  return findChild<QDockWidget*>(QLatin1String(name));
}

/// Each goes straight into its tab: docks beside each other, if only for a moment, make the window wider than
/// a projector.
void MainWindow::placeDocks() {
  addDockWidget(Qt::BottomDockWidgetArea, dock("dock.matrices"));
  tabifyDockWidget(dock("dock.matrices"), dock("dock.problems"));
  tabifyDockWidget(dock("dock.problems"), dock("dock.speeds"));
  tabifyDockWidget(dock("dock.speeds"), dock("dock.derivation"));
  tabifyDockWidget(dock("dock.derivation"), dock("dock.forces"));
  tabifyDockWidget(dock("dock.forces"), dock("dock.dynamics"));
  addDockWidget(Qt::RightDockWidgetArea, dock("dock.view3d"));
  splitDockWidget(dock("dock.view3d"), dock("dock.inputs"), Qt::Vertical);
  tabifyDockWidget(dock("dock.inputs"), dock("dock.gearbox"));
  tabifyDockWidget(dock("dock.gearbox"), dock("dock.properties"));
}

void MainWindow::applyDefaultLayout() {
  {
    const LayoutPause pause(this);
    for (QDockWidget* each : m_docks) {
      if (each->isFloating()) each->setFloating(false);  // hides and shows it, floating or not
      removeDockWidget(each);
    }
    placeDocks();
    for (QDockWidget* each : m_docks) each->show();
  }
  resizeDocks({dock("dock.inputs")}, {width() * 41 / 100}, Qt::Horizontal);
  resizeDocks({dock("dock.matrices")}, {height() * 36 / 100}, Qt::Vertical);
  resizeDocks({dock("dock.view3d"), dock("dock.inputs")}, {height() * 46 / 100, height() * 54 / 100},
              Qt::Vertical);
  dock("dock.matrices")->raise();
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
  m_notices->renew();
  drawing().setFocus();
}

/// Of the panels of results the one that this document is about.
void MainWindow::raiseResults() {
  const bool shifts = !m_document->mechanism()->states.empty();
  dock(shifts ? "dock.gearbox" : "dock.inputs")->raise();
}

/// Another document has been opened: what it needs first comes to the front, once it is known.
void MainWindow::onOpened() {
  const bool isGearbox = !m_document->mechanism()->states.empty();
  if (isGearbox || isInSight(*m_gearbox)) raiseResults();
  m_isOpened = true;
}

void MainWindow::raiseProblems(const AnalysisSnapshot& snapshot) {
  if (!m_isOpened) return;
  if (std::any_of(snapshot.diagnostics.begin(), snapshot.diagnostics.end(), isUrgent)) {
    dock("dock.problems")->raise();
  } else if (snapshot.isComplete && isInSight(*m_problems)) {
    dock("dock.matrices")->raise();
  }
  m_isOpened = !snapshot.isComplete;
}

}  // namespace geargraph::inline mainwindow

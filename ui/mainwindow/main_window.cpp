#include "ui/mainwindow/main_window.h"

#include <QApplication>
#include <QCloseEvent>
#include <QDockWidget>
#include <QMenu>
#include <QMimeData>
#include <algorithm>

#include "core/mechanism/model/edits.h"
#include "core/mechanism/model/validate.h"
#include "ui/canvas/digraph_view.h"
#include "ui/canvas/drawing_accessible.h"
#include "ui/canvas/tt_graph_view.h"
#include "ui/derivation/derivation_panel.h"
#include "ui/dynamics/dynamics_panel.h"
#include "ui/forces/forces_caption.h"
#include "ui/forces/forces_panel.h"
#include "ui/mainwindow/dock_titles.h"
#include "ui/mainwindow/document_files.h"
#include "ui/mainwindow/edit_commands.h"
#include "ui/mainwindow/edit_preview.h"
#include "ui/mainwindow/export_jobs.h"
#include "ui/mainwindow/notice_bar.h"
#include "ui/mainwindow/picture_clipboard.h"
#include "ui/mainwindow/power_arrows.h"
#include "ui/mainwindow/power_view.h"
#include "ui/mainwindow/presentation.h"
#include "ui/mainwindow/recent_files.h"
#include "ui/mainwindow/renumbering_notice.h"
#include "ui/mainwindow/start_page.h"
#include "ui/mainwindow/status_line.h"
#include "ui/mainwindow/window_exports.h"
#include "ui/mainwindow/window_files.h"
#include "ui/mainwindow/window_help.h"
#include "ui/models/joint_preview.h"
#include "ui/models/term_tips.h"
#include "ui/panels/gearbox_panel.h"
#include "ui/panels/inputs_panel.h"
#include "ui/panels/matrices_panel.h"
#include "ui/panels/matrix_view.h"
#include "ui/panels/problems_panel.h"
#include "ui/panels/results_panel.h"
#include "ui/recovery/autosave.h"
#include "ui/schematic/schematic_view.h"
#include "ui/settings/settings.h"
#include "ui/theme/application_theme.h"
#include "ui/theme/icons.h"
#include "ui/view3d/motion_panel.h"
#include "ui/view3d/stage_accessible.h"
#include "ui/view3d/view3d.h"

namespace geargraph::inline mainwindow {
namespace {

QString whyNoGears(const AnalysisSnapshot& snapshot) {
  if (snapshot.mechanism->n() == 0)
    return MainWindow::tr("The gears appear here. Draw the first link: L, then click.");
  if (!snapshot.tree) {
    return MainWindow::tr(
        "The gears appear when the turning joints tie every link to the ground and close no loop.");
  }
  if (snapshot.mechanism->n() > kMaxStageLinks) {
    return MainWindow::tr("The 3D view shows trains of up to %1 links; this one has %2.")
        .arg(kMaxStageLinks)
        .arg(snapshot.mechanism->n());
  }
  if (snapshot.kinematics && snapshot.mechanism->c() > 0) return View3D::waitingText();
  return MainWindow::tr("The gears appear when a mesh joins two of the links: G, then drag.");
}

}  // namespace

MainWindow::MainWindow(QWidget* parent) : MainWindow(new Workbench, parent) {}

MainWindow::MainWindow(Workbench* workbench, QWidget* parent)
    : QMainWindow(parent),
      m_workbench(workbench),
      m_document(&m_workbench->document()),
      m_selection(&m_workbench->selection()),
      m_actions(std::make_unique<WindowActions>(this)) {
  m_workbench->setParent(this);
  installDrawingAccessibility();
  installStageAccessibility();
  setObjectName(QStringLiteral("mainWindow"));
  setAttribute(Qt::WA_DeleteOnClose, false);
  setWindowIcon(applicationIcon());
  setDockOptions(QMainWindow::AllowTabbedDocks | QMainWindow::AllowNestedDocks |
                 QMainWindow::GroupedDragging);
  setTabPosition(Qt::AllDockWidgetAreas, QTabWidget::North);
  setDocumentMode(true);
  setCorner(Qt::BottomRightCorner, Qt::RightDockWidgetArea);
  setCorner(Qt::TopRightCorner, Qt::RightDockWidgetArea);

  m_status = new StatusLine(m_selection, this);
  setStatusBar(m_status);
  m_recent = new RecentFiles(this);
  m_notices = new NoticeBar(this);
  m_exportJobs = new ExportJobs(m_notices, this);
  m_files = std::make_unique<WindowFiles>(*m_workbench, this, m_notices, m_recent,
                                          [this] { return documentToSave(); });
  m_titles = new DockTitles(this);
  m_presentation = new Presentation(this);
  makeDrawings();
  makeDocks();
  makeCommands();
  makeHelp();
  makeMenus();
  makeToolBar();
  addToolBarBreak();
  addToolBar(m_notices);
  m_notices->renew();
  m_start = new StartPage(this);
  wireActions();
  wireFiles();
  wireViews();
  wireView3D();
  setAcceptDrops(true);
  wireMotion();
  setTheme(themeOf(QApplication::palette()));
  resize(1366, 768);
  m_workbench->request();
  onDocumentChanged();
  renewPowerFlow();
  renewTitle();
}

MainWindow::~MainWindow() {
  // A widget that is visible hides its children when it goes, which is after what the panels read; so do
  // windows of docks that float together.
  hide();
  for (auto* own : findChildren<QWidget*>(QString(), Qt::FindDirectChildrenOnly))
    if (own->isWindow()) own->hide();
  // The history empties itself while the window is taken apart.
  disconnect(m_document, nullptr, this, nullptr);
  disconnect(&m_document->undoStack(), nullptr, this, nullptr);
}

void MainWindow::requestStop() {
  for (BackgroundWork* work : backgroundWork()) work->requestStop();
}

bool MainWindow::hasStopped() const {
  const std::vector<BackgroundWork*> all = backgroundWork();
  return std::all_of(all.begin(), all.end(), [](const BackgroundWork* work) { return work->hasStopped(); });
}

std::vector<BackgroundWork*> MainWindow::backgroundWork() const {
  std::vector<BackgroundWork*> all;
  for (auto* each : findChildren<QObject*>())
    if (auto* work = dynamic_cast<BackgroundWork*>(each)) all.push_back(work);
  if (Autosave* autosave = m_files->autosave()) all.push_back(autosave);
  return all;
}

void MainWindow::makeDrawings() {
  m_drawings = new QTabWidget(this);
  m_drawings->setObjectName(QStringLiteral("drawings"));
  m_drawings->setDocumentMode(true);
  setCentralWidget(m_drawings);
  m_digraph = new DigraphView(m_document, m_selection, m_drawings);
  addDrawing(m_digraph, "digraph", tr("Digraph"), tipOf(Term::digraph));
  m_ttGraph = new TtGraphView(m_document, m_selection, m_drawings);
  addDrawing(m_ttGraph, "ttgraph", tr("T–T graph"), tipOf(Term::ttGraph));
  m_schematic = new SchematicView(m_document, m_selection, m_drawings);
  addDrawing(m_schematic, "schematic", tr("Schematic"), tipOf(Term::functionalSchematic));
  connect(m_schematic, &SchematicView::drawn, this, &MainWindow::tellWhenSettled);
  connect(m_ttGraph, &TtGraphView::drawn, this, &MainWindow::tellWhenSettled);
  m_power = new PowerView(*m_workbench, m_allDrawings, this);
  connect(m_power, &PowerView::shown, this, &MainWindow::tellWhenSettled);
  connect(m_drawings, &QTabWidget::currentChanged, this, &MainWindow::onDrawingChosen);
  onDrawingChosen();
}

void MainWindow::addDrawing(DrawingView* drawing, const char* name, const QString& title,
                            const QString& tip) {
  drawing->setObjectName(QLatin1String(name));
  const int tab = m_drawings->addTab(drawing, title);
  m_drawings->setTabToolTip(tab, tip);
  m_allDrawings.push_back(drawing);
  // Files are dropped on the window; a drawing would swallow them.
  drawing->setAcceptDrops(false);
  drawing->viewport()->setAcceptDrops(false);
  wireDrawing(drawing);
}

bool MainWindow::showDrawing(const QString& name) {
  for (DrawingView* each : m_allDrawings) {
    if (each->objectName() != name) continue;
    m_drawings->setCurrentWidget(each);
    return true;
  }
  return false;
}

DrawingView& MainWindow::drawing() {
  return *m_allDrawings[static_cast<std::size_t>(m_drawings->currentIndex())];
}

/// The tool that is picked stays picked, whatever drawing comes to the front.
void MainWindow::onDrawingChosen() {
  drawing().setTool(static_cast<ToolKind>(m_actions->tools->checkedAction()->data().toInt()));
  m_status->setHint(drawing().hint());
}

void MainWindow::makeCommands() {
  auto* clipboard = new PictureClipboard(this);
  connect(clipboard, &PictureClipboard::rejected, m_status, &StatusLine::showRejection);
  m_commands = new EditCommands(
      *m_workbench, clipboard, [this] { return drawing().pictureMaker(); }, this);
  connect(m_commands, &EditCommands::rejected, m_status, &StatusLine::showRejection);
  connect(m_commands, &EditCommands::noted, m_status, &StatusLine::showNote);
  m_exports = new WindowExports(*m_workbench, *m_files, {m_allDrawings, m_schematic, m_view3d, m_motion},
                                m_exportJobs, clipboard, this);
  connect(m_exports, &WindowExports::rejected, m_status, &StatusLine::showRejection);
  connect(m_exports, &WindowExports::noted, m_status, &StatusLine::showNote);
  connect(m_derivation, &DerivationPanel::exportWanted, m_exports, &WindowExports::chooseAndExportDerivation);
}

void MainWindow::makeHelp() {
  TourStage stage;
  stage.whyNone = [this] {
    return m_lesson == nullptr ? QString()
                               : tr("A lesson is played in this window: take the tour in another one.");
  };
  stage.begin = [this] {
    m_presentation->setOn(false);
    const bool isEmpty = m_document->mechanism()->n() == 0;
    if (isEmpty && m_files->isUnused()) openDocument(robotExamplePath());
    m_start->dismiss(&drawing());
  };
  stage.showDrawing = [this](const QString& name) { showDrawing(name); };
  stage.end = [this] {
    if (m_start->isHidden()) return drawing().setFocus();
    m_start->setFocus();
  };
  m_help = new WindowHelp(this, std::move(stage));
  connect(m_help, &WindowHelp::lessonWanted, this, &MainWindow::playLessonNamed);
  connect(m_help, &WindowHelp::rejected, m_status, &StatusLine::showRejection);
}

void MainWindow::wireViews() {
  connect(m_document, &Document::changed, this, &MainWindow::onDocumentChanged);
  new RenumberingNotice(m_document, m_selection, m_status, this);
  connect(m_document, &Document::modifiedChanged, this, &MainWindow::renewTitle);
  connect(m_document, &Document::filePathChanged, this, &MainWindow::renewTitle);
  connect(m_document, &Document::rejected, this, [this](const Diagnostics& why) {
    m_status->showRejection(shownText(why.front().message));
    m_selection->hover({why.front().elements.begin(), why.front().elements.end()});
  });
  m_workbench->analysis().onAnswer(this, [this](const SnapshotPtr& snapshot) { onSnapshot(snapshot); });
  for (ServiceSignals* service : findChildren<ServiceSignals*>()) {  // those of the views, too
    connect(service, &ServiceSignals::failed, this, [this](const QString& why) {
      m_status->showRejection(tr("The views could not be updated: %1.").arg(why));
      tellWhenSettled();
    });
  }
  connect(m_selection, &Selection::selectionChanged, this, &MainWindow::onSelectionChanged);
  connect(&m_matrices->view(), &MatrixView::menuWanted, this, &MainWindow::popUpMenuFor);
  connect(m_results, &ResultsPanel::menuWanted, this, &MainWindow::popUpMenuFor);
  connect(m_presentation, &Presentation::changed, this, [this](bool on) {
    m_actions->presentation->setChecked(on);
    setTheme(themeOf(QApplication::palette()), !on);
  });
  connect(m_presentation, &Presentation::played, this, [this] { m_view3d->playback().toggle(); });
  m_workbench->motionCheck().onAnswer(this, [this](const MotionReportPtr& report) {
    m_problems->setMotionDiagnostics(
        report ? report->diagnostics : Diagnostics(),
        shownText(motionNote(*m_workbench->analysis().snapshot(), report.get())));
    tellWhenSettled();
  });
  m_workbench->forces().onAnswer(this, [this](const ForcesPtr& forces) { onForces(forces); });
  connect(m_problems, &ProblemsPanel::fixesOffered, this, &MainWindow::tellWhenSettled);
  connect(m_problems, &ProblemsPanel::momentWanted, this, [this](double time) {
    m_view3d->showMoment(time);
    auto* dock = findChild<QDockWidget*>(QStringLiteral("dock.view3d"));
    dock->show();
    dock->raise();
  });
  connect(m_problems, &ProblemsPanel::fixWanted, this, [this](const Fix& fix) {
    m_document->apply({shownText(fix.text), fix.edit, 0});
  });
  connect(m_matrices, &MatricesPanel::rejected, this,
          [this](const QString& why) { m_status->showRejection(why); });
  connect(m_matrices, &MatricesPanel::exportWanted, m_exports, &WindowExports::chooseAndExport);
  for (GraphView* graph : std::initializer_list<GraphView*>{m_digraph, m_ttGraph}) {
    connect(&m_matrices->view(), &MatrixView::cycleHovered, graph, &GraphView::showCycle);
  }
  connect(m_gearbox, &GearboxPanel::exportWanted, m_exports, &WindowExports::chooseAndExportTable);
  connect(m_forces, &ForcesPanel::exportWanted, m_exports, &WindowExports::chooseAndExportTable);
  connect(m_dynamics, &DynamicsPanel::exportWanted, m_exports, &WindowExports::chooseAndExportTable);
  connect(m_matrices, &MatricesPanel::quantityExportWanted, m_exports,
          &WindowExports::chooseAndExportQuantity);
  connect(&m_matrices->model(), &MatrixModel::matrixChanged, this, &MainWindow::renewExport);
}

void MainWindow::wireDrawing(DrawingView* drawing) {
  connect(drawing, &DrawingView::toolChanged, this,
          [this](ToolKind tool) { m_actions->tool[static_cast<std::size_t>(tool)]->setChecked(true); });
  connect(drawing, &DrawingView::hintChanged, this, [this, drawing](const QString& hint) {
    if (drawing == m_drawings->currentWidget()) m_status->setHint(hint);
  });
  connect(drawing, &DrawingView::previewChanged, this, [this](const std::optional<JointPreview>& preview) {
    m_matrices->setPreview(preview ? previewOf(*m_document->mechanism(), *preview) : std::nullopt);
  });
  connect(drawing, &DrawingView::propertiesWanted, this, [this](const ElementId& element) {
    m_selection->select({element});
    auto* dock = findChild<QDockWidget*>(QStringLiteral("dock.properties"));
    dock->show();
    dock->raise();
  });
  connect(drawing, &DrawingView::menuOpening, this,
          [this, drawing](QMenu* menu, const std::optional<ElementId>& element) {
            if (element) {
              return showPreviews(*menu, *m_workbench, [this](const QString& hint) {
                m_status->setHint(hint.isEmpty() ? this->drawing().hint() : hint);
              });
            }
            menu->addSeparator();
            menu->addAction(m_actions->copyPicture->text(), m_exports,
                            [this, drawing] { m_exports->copyPicture(drawing->objectName()); });
          });
  connect(drawing, &DrawingView::spaceTapped, this, [this] { m_view3d->playback().toggle(); });
}

void MainWindow::wireView3D() {
  connect(m_digraph, &DigraphView::settled, this, &MainWindow::tellWhenSettled);
  m_workbench->stages().setPaintedByWindow(!m_view3d->isImage());
  m_workbench->stages().onAnswer(this, [this](const StagePtr& stage) { onStage(stage); });
  connect(m_document, &Document::replaced, this, &MainWindow::startView3DAnew);
  wireView3DCommands();
}

/// While a link hangs loose or the joints close a loop there is no picture: then the last one stays.
void MainWindow::onStage(const StagePtr& stage) {
  const bool empty = stage->scene.instances.empty();
  const Mechanism& mechanism = *m_document->mechanism();
  const Diagnostics why =
      empty && m_hasPicture && mechanism.n() > 0 ? treeDiagnostics(mechanism) : Diagnostics();
  if (why.empty()) {
    m_view3d->setStage(stage);
    m_hasPicture = !empty;
  }
  const QString notShown =
      stage->notes.empty() ? QString() : QString::fromStdString(stage->notes.front().text);
  m_view3d->setNote(why.empty()
                        ? notShown
                        : tr("Shown as before the last changes. %1").arg(shownText(why.front().message)));
  Diagnostics missing;
  for (const StageNote& note : stage->notes)
    if (note.isMissingFile) missing.push_back({Code::missingFile, note.text, {note.element}, {}});
  m_problems->setShapeDiagnostics(missing);
  tellWhenSettled();
}

/// Views may show what is gone (the last picture in 3D): it cannot be selected.
void MainWindow::onSelectionChanged() {
  const ElementIndex& elements = m_document->elements();
  const auto isThere = [&](const ElementId& element) { return elements.contains(element); };
  const auto& selected = m_selection->selected();
  if (!std::all_of(selected.begin(), selected.end(), isThere)) return m_selection->keepOnly(isThere);
  renewActions();
}

void MainWindow::popUpMenuFor(const ElementId& element, QPoint at) {
  if (!m_document->elements().contains(element)) return;
  QMenu* menu = drawing().contextMenuFor(element, {});
  menu->setAttribute(Qt::WA_DeleteOnClose);
  menu->popup(at);
}

bool MainWindow::isSettled() const {
  return m_workbench->isUpToDate() && m_schematic->isSettled() && m_digraph->isSettled() &&
         m_ttGraph->isUpToDate() && m_problems->isSettled() && m_power->isSettled() &&
         findChild<PowerArrows*>()->isSettled();
}

void MainWindow::tellWhenSettled() {
  if (isSettled()) emit settled();
}

void MainWindow::onDocumentChanged() {
  if (!m_selection->selected().empty() || !m_selection->hovered().empty()) {
    m_selection->keepOnly(
        [this](const ElementId& element) { return m_document->elements().contains(element); });
  }
  m_results->setNames(m_document->mechanism());
  m_motion->setNames(m_document->mechanism());
  m_status->clearRejection();
  renewActions();
}

void MainWindow::onSnapshot(const SnapshotPtr& snapshot) {
  m_matrices->setSnapshot(snapshot);
  for (DrawingView* each : m_allDrawings) each->setSnapshot(snapshot);
  m_results->setSnapshot(snapshot);
  m_gearbox->setSnapshot(snapshot);
  m_forces->setSnapshot(snapshot);
  m_dynamics->setSnapshot(snapshot);
  m_inputs->setSnapshot(snapshot);
  m_problems->setSnapshot(snapshot);
  m_status->setSnapshot(snapshot);
  m_derivation->setSnapshot(snapshot, m_exports->whyNoDerivation());
  m_view3d->setEmptyText(whyNoGears(*snapshot));
  renewExport();
  raiseProblems(*snapshot);
  tellWhenSettled();
}

/// Null: the document has no loads, and no view shows torques.
void MainWindow::onForces(const ForcesPtr& forces) {
  m_problems->setLoadDiagnostics(forces ? forces->diagnostics : Diagnostics());
  const ForceTable* const torques = forces ? forces->table(ForceTableKind::states) : nullptr;
  // A first part comes without: the torques before it stay, else they would blink.
  if (torques != nullptr || m_workbench->forces().isComplete())
    m_gearbox->setTorques(std::shared_ptr<const ForceTable>(forces, torques),
                          forces ? forces->snapshot->mechanism : nullptr);
  m_view3d->setForces(forces ? forces->arrows : nullptr, forcesCaption(forces));
  renewPowerFlow();
  tellWhenSettled();
}

void MainWindow::renewPowerFlow() {
  const QString why = m_power->whyNone();
  WindowActions::setAvailable(m_actions->powerFlow, why.isEmpty(), why);
}

void MainWindow::renewExport() {
  WindowActions::setAvailable(m_actions->exportMatrix, m_matrices->model().isThere(),
                              m_matrices->model().quantityKind()
                                  ? tr("This matrix needs a mechanism without errors.")
                                  : tr("This matrix needs the turning joints to be a spanning tree."));
  const QString why = m_exports->whyNoDerivation();
  for (QAction* action : {m_actions->exportDerivation, m_actions->exportHandout, m_actions->showDerivation,
                          m_actions->compareMethods})
    WindowActions::setAvailable(action, why.isEmpty(), why);
}

bool MainWindow::openDocument(const QString& path) {
  return m_files->open(path);
}

bool MainWindow::saveDocument(const QString& path) {
  return m_files->save(path);
}

void MainWindow::renewTitle() {
  const QString readOnly = m_files->isReadOnly() ? tr(" (read-only)") : QString();
  setWindowTitle(m_files->title() + readOnly + QStringLiteral("[*] — GearGraph"));
  setWindowModified(m_document->isModified());
}

void MainWindow::setTheme(Theme theme, bool isLaidOutNext) {
  const double scale = savedTypeScale() * (m_presentation->isOn() ? Presentation::kTypeScale : 1);
  const bool applied = themeOf(QApplication::palette()) == theme && scaledPixels(100) == qRound(100 * scale);
  if (!applied) applyTheme(*qApp, theme, scale, isLaidOutNext);
  m_actions->setTheme(theme, followsSystemTheme(), savedTypeScale());
  const double largest = DrawingView::kLargestFit * savedTypeScale() * (m_presentation->isOn() ? 2.5 : 1);
  for (DrawingView* each : m_allDrawings) {
    each->setTheme(theme);
    each->setLargestFit(largest);
  }
  m_view3d->setDark(theme != Theme::light);
}

bool MainWindow::event(QEvent* event) {
  const bool isOther = event->type() == QEvent::ThemeChange && followsSystemTheme();
  if (event->type() == QEvent::ThemeChange) renewSystemTheme();
  if (isOther && systemTheme() != themeOf(QApplication::palette())) setTheme(systemTheme());
  return QMainWindow::event(event);
}

void MainWindow::closeEvent(QCloseEvent* event) {
  if (!m_files->mayDiscard()) return event->ignore();
  m_files->discard();
  if (m_lesson == nullptr) {  // whose panels are others
    const auto [geometry, state] = m_presentation->workLayout();
    saveSetting(QStringLiteral("window/geometry"), geometry);
    saveSetting(QStringLiteral("window/state"), state);
  }
  m_presentation->end();
  event->accept();
  emit closed();
}

}  // namespace geargraph::inline mainwindow

#include "moc_main_window.cpp"

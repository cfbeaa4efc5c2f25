#include "ui/mainwindow/main_window.h"

#include <QApplication>
#include <QCloseEvent>
#include <QDockWidget>
#include <QMenu>
#include <QMimeData>
#include <QTabBar>
#include <QToolButton>
#include <algorithm>

#include "core/mechanism/model/edits.h"
#include "core/mechanism/model/validate.h"
#include "ui/canvas/digraph_view.h"
#include "ui/canvas/drawing_accessible.h"
#include "ui/canvas/mini_map.h"
#include "ui/canvas/schematic_view.h"
#include "ui/canvas/tt_graph_view.h"
#include "ui/forces/forces_panel.h"
#include "ui/forces/inputs_and_results.h"
#include "ui/help/help_page_of.h"
#include "ui/help/search_field.h"
#include "ui/mainwindow/dock_drag.h"
#include "ui/mainwindow/document_files.h"
#include "ui/mainwindow/edit_commands.h"
#include "ui/mainwindow/edit_preview.h"
#include "ui/mainwindow/export_jobs.h"
#include "ui/mainwindow/notice_bar.h"
#include "ui/mainwindow/picture_clipboard.h"
#include "ui/mainwindow/power_arrows.h"
#include "ui/mainwindow/power_view.h"
#include "ui/mainwindow/presentation.h"
#include "ui/mainwindow/recent_exports.h"
#include "ui/mainwindow/recent_files.h"
#include "ui/mainwindow/renumbering_notice.h"
#include "ui/mainwindow/start_page.h"
#include "ui/mainwindow/status_line.h"
#include "ui/mainwindow/view_docks.h"
#include "ui/mainwindow/view_table.h"
#include "ui/mainwindow/window_exports.h"
#include "ui/mainwindow/window_files.h"
#include "ui/mainwindow/window_help.h"
#include "ui/models/joint_preview.h"
#include "ui/models/term_tips.h"
#include "ui/motion_panel/dynamics_panel.h"
#include "ui/panels/gearbox_panel.h"
#include "ui/panels/matrices_panel.h"
#include "ui/panels/matrix_view.h"
#include "ui/panels/problems_panel.h"
#include "ui/panels/properties_panel.h"
#include "ui/panels/results_panel.h"
#include "ui/reading/derivation_panel.h"
#include "ui/recovery/autosave.h"
#include "ui/settings/languages.h"
#include "ui/settings/settings.h"
#include "ui/theme/application_theme.h"
#include "ui/theme/icons.h"
#include "ui/view3d/motion_panel.h"
#include "ui/view3d/scene_accessible.h"
#include "ui/view3d/view3d.h"

namespace geargraph {

MainWindow::MainWindow(QWidget* parent) : MainWindow(new Workbench, parent) {}

MainWindow::MainWindow(Workbench* workbench, QWidget* parent)
    : QMainWindow(parent),
      m_workbench(workbench),
      m_document(&m_workbench->document()),
      m_selection(&m_workbench->selection()),
      m_actions(std::make_unique<WindowActions>(this)),
      m_views(new Views(*m_workbench, this)) {
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

  m_document->setHistoryLanguage(currentLanguage());
  m_status = new StatusLine(m_selection, this);
  setStatusBar(m_status);
  m_recent = new RecentFiles(this);
  m_recentExports = new RecentExports(this);
  m_notices = new NoticeBar(this);
  m_exportJobs = new ExportJobs(m_notices, this);
  m_files = std::make_unique<WindowFiles>(*m_workbench, this, m_notices, m_recent,
                                          [this] { return documentToSave(); });
  m_presentation = new Presentation(this);
  makeViews();
  makeCommands();
  makeHelp();
  makeMenus();
  makeToolBar();
  addToolBarBreak();
  addToolBar(m_notices);
  m_notices->renew();
  m_start = new StartPage(this);
  makeOffer();
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
  updateTitle();
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

DigraphView& MainWindow::digraph() const {
  return m_views->get<DigraphView>();
}
TtGraphView& MainWindow::ttGraph() const {
  return m_views->get<TtGraphView>();
}
View3D& MainWindow::view3d() const {
  return m_views->get<View3D>();
}
MatricesPanel& MainWindow::matrices() const {
  return m_views->get<MatricesPanel>();
}
DerivationPanel& MainWindow::derivation() const {
  return m_views->get<DerivationPanel>();
}
ResultsPanel& MainWindow::results() const {
  return m_views->get<InputsAndResults>().results();
}
GearboxPanel& MainWindow::gearbox() const {
  return m_views->get<GearboxPanel>();
}
ForcesPanel& MainWindow::forces() const {
  return m_views->get<ForcesPanel>();
}
DynamicsPanel& MainWindow::dynamics() const {
  return m_views->get<DynamicsPanel>();
}
ProblemsPanel& MainWindow::problems() const {
  return m_views->get<ProblemsPanel>();
}
MotionPanel& MainWindow::motion() const {
  return m_views->get<MotionPanel>();
}

void MainWindow::makeViews() {
  new DockDrag(this);
  m_docks = new ViewDocks(this, [this] { drawing().setFocus(); });
  connect(m_views, &Views::settled, this, &MainWindow::emitSettledIfIdle);
  connect(m_views, &Views::revealWanted, m_docks,
          [this](const ResultsView* view) { m_docks->reveal(*view); });
  connect(m_views, &Views::rejected, m_status, &StatusLine::showRejection);
  connect(m_views, &Views::menuWanted, this, &MainWindow::popUpMenuFor);
  connect(m_views, &Views::documentWanted, this,
          [this](const MechanismPtr& mechanism) { m_files->showMade(mechanism); });
  makeDrawings();
  for (const ViewEntry& entry : viewTable()) {
    if (entry.place == ViewPlace::drawings) {
      addDrawing(entry);
    } else {
      m_docks->add(entry, m_views->make(entry, this));
    }
  }
  m_power = new PowerView(*m_workbench, m_allDrawings, this);
  connect(m_power, &PowerView::shown, this, &MainWindow::emitSettledIfIdle);
  connect(m_drawings, &QTabWidget::currentChanged, this, &MainWindow::onDrawingChosen);
  onDrawingChosen();
}

void MainWindow::makeDrawings() {
  m_drawings = new QTabWidget(this);
  m_drawings->setObjectName(QStringLiteral("drawings"));
  m_drawings->setDocumentMode(true);
  setCentralWidget(m_drawings);
}

void MainWindow::addDrawing(const ViewEntry& entry) {
  ResultsView& view = m_views->make(entry, m_drawings);
  view.widget().setObjectName(entry.id);
  view.widget().setProperty(kHelpPage, entry.helpPage);
  view.widget().setProperty(kPurpose, entry.purpose);
  const int tab = m_drawings->addTab(&view.widget(), entry.title);
  m_drawings->setTabToolTip(tab, entry.tip);
  view.widget().setProperty(kWantsRoom, entry.wantsRoom);
  if (entry.wantsRoom) addCloseButton(tab);
  auto* drawing = dynamic_cast<DrawingView*>(&view);
  if (drawing == nullptr) {
    connect(m_drawings, &QTabWidget::currentChanged, &view.widget(),
            [this, &view] { view.setAwake(m_drawings->currentWidget() == &view.widget()); });
    return;
  }
  m_allDrawings.push_back(drawing);
  // Files are dropped on the window; a drawing would swallow them.
  drawing->setAcceptDrops(false);
  drawing->viewport()->setAcceptDrops(false);
  wireDrawing(drawing);
}

/// A tab for which the panels go away is there once it has been asked for, and can be closed.
void MainWindow::addCloseButton(int tab) {
  auto* close = new QToolButton(m_drawings);
  close->setText(QStringLiteral("✕"));
  close->setProperty("look", "flat");
  close->setFocusPolicy(Qt::NoFocus);
  close->setObjectName(QStringLiteral("close.") + m_drawings->widget(tab)->objectName());
  close->setToolTip(tr("Closes this tab; what it holds stays"));
  close->setAccessibleName(tr("Close %1").arg(m_drawings->tabText(tab)));
  connect(close, &QToolButton::clicked, this, [this, page = m_drawings->widget(tab)] {
    showDrawing(drawing().objectName());
    m_drawings->setTabVisible(m_drawings->indexOf(page), false);
  });
  m_drawings->tabBar()->setTabButton(tab, QTabBar::RightSide, close);
  m_drawings->setTabVisible(tab, false);
}

bool MainWindow::showDrawing(const QString& name) {
  for (int tab = 0; tab < m_drawings->count(); ++tab) {
    if (m_drawings->widget(tab)->objectName() != name) continue;
    m_drawings->setTabVisible(tab, true);
    m_drawings->setCurrentIndex(tab);
    return true;
  }
  return false;
}

DrawingView& MainWindow::drawing() {
  if (auto* front = qobject_cast<DrawingView*>(m_drawings->currentWidget())) m_drawing = front;
  return *m_drawing;
}

QString MainWindow::drawingHint() {
  const bool isDrawing = m_drawings->currentWidget() == &drawing();
  return isDrawing ? drawing().hint() : m_drawings->tabToolTip(m_drawings->currentIndex());
}

/// The tool that is picked stays picked, whatever drawing comes to the front.
void MainWindow::onDrawingChosen() {
  drawing().setTool(static_cast<ToolKind>(m_actions->tools->checkedAction()->data().toInt()));
  m_status->setHint(drawingHint());
  giveRoom();
}

void MainWindow::makeCommands() {
  auto* clipboard = new PictureClipboard(this);
  connect(clipboard, &PictureClipboard::rejected, m_status, &StatusLine::showRejection);
  m_commands = new EditCommands(
      *m_workbench, clipboard, [this] { return drawing().pictureMaker(); }, this);
  connect(m_commands, &EditCommands::rejected, m_status, &StatusLine::showRejection);
  connect(m_commands, &EditCommands::noted, m_status, &StatusLine::showNote);
  m_exports = new WindowExports(*m_workbench, *m_files,
                                {m_allDrawings, &m_views->get<SchematicView>(), &view3d(), &motion()},
                                m_exportJobs, clipboard, this);
  connect(m_exports, &WindowExports::rejected, m_status, &StatusLine::showRejection);
  connect(m_exports, &WindowExports::noted, m_status, &StatusLine::showNote);
  connect(&derivation(), &DerivationPanel::exportWanted, m_exports,
          &WindowExports::chooseAndExportDerivation);
  connect(&derivation(), &DerivationPanel::handoutWanted, m_exports, &WindowExports::exportHandoutNow);
}

void MainWindow::makeHelp() {
  TourStage stage;
  stage.unavailableReason = [this] {
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
  stage.panel = [this](const QString& id) { return m_docks->of(m_views->byId(id)); };
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
  connect(m_document, &Document::modifiedChanged, this, &MainWindow::updateTitle);
  connect(m_document, &Document::filePathChanged, this, &MainWindow::updateTitle);
  connect(m_document, &Document::rejected, this, [this](const Diagnostics& why) {
    m_status->showRejection(shownText(why.front().message));
    m_selection->hover({why.front().elements.begin(), why.front().elements.end()});
  });
  m_workbench->analysis().onAnswer(this, [this](const SnapshotPtr& snapshot) { onSnapshot(snapshot); });
  for (ServiceSignals* service : findChildren<ServiceSignals*>()) {  // those of the views, too
    connect(service, &ServiceSignals::failed, this, [this](const QString& why) {
      m_status->showRejection(tr("The views could not be updated: %1.").arg(why));
      emitSettledIfIdle();
    });
  }
  connect(m_selection, &Selection::selectionChanged, this, &MainWindow::onSelectionChanged);
  connect(m_presentation, &Presentation::changed, this, [this](bool on) {
    (*m_actions)[CommandId::presentation]->setChecked(on);
    // Names are read in a lecture hall; afterwards they are as they were.
    QAction* captions = (*m_actions)[CommandId::captions];
    if (on) m_hadCaptions = captions->isChecked();
    captions->setChecked(on || m_hadCaptions);
    setTheme(themeOf(QApplication::palette()), !on);
  });
  connect(m_presentation, &Presentation::played, this, [this] { view3d().playback().toggle(); });
  m_workbench->motionCheck().onAnswer(this, [this](const MotionReportPtr&) { emitSettledIfIdle(); });
  m_workbench->forces().onAnswer(this, [this](const ForcesPtr&) { onForces(); });
  connect(m_views, &Views::tableExportWanted, m_exports, &WindowExports::chooseAndExportTable);
  MatricesPanel& matrices = this->matrices();
  connect(&matrices, &MatricesPanel::exportWanted, m_exports, &WindowExports::chooseAndExportResult);
  connect(&matrices.model(), &MatrixModel::matrixChanged, this, &MainWindow::updateCommands);
  for (GraphView* graph : std::initializer_list<GraphView*>{&digraph(), &ttGraph()}) {
    connect(&matrices.view(), &MatrixView::cycleHovered, graph, &GraphView::showCycle);
  }
}

void MainWindow::wireDrawing(DrawingView* drawing) {
  new MiniMap(drawing);
  connect(drawing, &DrawingView::toolChanged, this,
          [this](ToolKind tool) { m_actions->tool[static_cast<std::size_t>(tool)]->setChecked(true); });
  connect(drawing, &DrawingView::hintChanged, this, [this, drawing](const QString& hint) {
    if (drawing == m_drawings->currentWidget()) m_status->setHint(hint);
  });
  connect(drawing, &DrawingView::previewChanged, this, [this](const std::optional<JointPreview>& preview) {
    matrices().setPreview(preview ? previewOf(*m_document->mechanism(), *preview) : std::nullopt);
  });
  connect(drawing, &DrawingView::propertiesWanted, this, [this](const ElementId& element) {
    m_selection->select({element});
    m_docks->reveal(m_views->get<PropertiesPanel>());
  });
  connect(drawing, &DrawingView::menuOpening, this,
          [this, drawing](QMenu* menu, const std::optional<ElementId>& element) {
            if (element) {
              return showPreviews(*menu, *m_workbench, [this](const QString& hint) {
                m_status->setHint(hint.isEmpty() ? drawingHint() : hint);
              });
            }
            menu->addSeparator();
            menu->addAction((*m_actions)[CommandId::copyPicture]->text(), m_exports,
                            [this, drawing] { m_exports->copyPicture(drawing->objectName()); });
          });
  connect(drawing, &DrawingView::spaceTapped, this, [this] { view3d().playback().toggle(); });
}

void MainWindow::wireView3D() {
  m_workbench->stages().setPaintedByWindow(!view3d().isImage());
  m_workbench->stages().onAnswer(this, [this](const MechanismScenePtr& stage) { onStage(stage); });
  connect(m_document, &Document::replaced, this, &MainWindow::startView3DAnew);
  wireView3DCommands();
}

/// While a link hangs loose or the joints close a loop there is no picture: then the last one stays.
void MainWindow::onStage(const MechanismScenePtr& stage) {
  const bool empty = stage->scene.instances.empty();
  const Mechanism& mechanism = *m_document->mechanism();
  const Diagnostics why =
      empty && m_hasPicture && mechanism.n() > 0 ? treeDiagnostics(mechanism) : Diagnostics();
  if (why.empty()) {
    view3d().setScene(stage);
    m_hasPicture = !empty;
  }
  const QString notShown =
      stage->notes.empty() ? QString() : QString::fromStdString(stage->notes.front().text);
  view3d().setNote(why.empty()
                       ? notShown
                       : tr("Shown as before the last changes. %1").arg(shownText(why.front().message)));
  emitSettledIfIdle();
}

/// Views may show what is gone (the last picture in 3D): it cannot be selected.
void MainWindow::onSelectionChanged() {
  const ElementIndex& elements = m_document->elements();
  const auto isThere = [&](const ElementId& element) { return elements.contains(element); };
  const auto& selected = m_selection->selected();
  if (!std::all_of(selected.begin(), selected.end(), isThere)) return m_selection->keepOnly(isThere);
  updateCommands();
}

void MainWindow::popUpMenuFor(const ElementId& element, QPoint at) {
  if (!m_document->elements().contains(element)) return;
  QMenu* menu = drawing().contextMenuFor(element, {});
  menu->setAttribute(Qt::WA_DeleteOnClose);
  menu->popup(at);
}

bool MainWindow::isSettled() const {
  return m_workbench->isUpToDate() && m_views->isSettled() && m_power->isSettled() &&
         findChild<PowerArrows*>()->isSettled();
}

void MainWindow::emitSettledIfIdle() {
  if (isSettled()) emit settled();
}

void MainWindow::onDocumentChanged() {
  if (!m_selection->selected().empty() || !m_selection->hovered().empty()) {
    m_selection->keepOnly(
        [this](const ElementId& element) { return m_document->elements().contains(element); });
  }
  m_views->setMechanism(m_document->mechanism());
  m_status->clearRejection();
  updateCommands();
  updateOffer();
}

void MainWindow::onSnapshot(const SnapshotPtr& snapshot) {
  m_views->setSnapshot(snapshot);
  m_status->setSnapshot(snapshot);
  m_search->setSnapshot(snapshot);
  updateCommands();
  raiseProblems(*snapshot);
  emitSettledIfIdle();
}

void MainWindow::onForces() {
  updateCommands();
  emitSettledIfIdle();
}

bool MainWindow::openDocument(const QString& path) {
  return m_files->open(path);
}

bool MainWindow::saveDocument(const QString& path) {
  return m_files->save(path);
}

void MainWindow::updateTitle() {
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
  view3d().setDark(theme != Theme::light);
}

bool MainWindow::event(QEvent* event) {
  const bool isOther = event->type() == QEvent::ThemeChange && followsSystemTheme();
  if (event->type() == QEvent::ThemeChange) updateSystemTheme();
  if (isOther && systemTheme() != themeOf(QApplication::palette())) setTheme(systemTheme());
  return QMainWindow::event(event);
}

void MainWindow::closeEvent(QCloseEvent* event) {
  if (!m_files->mayDiscard()) return event->ignore();
  m_files->discard();
  if (m_lesson == nullptr) {  // whose panels are others
    const auto [geometry, state] = workLayout();
    saveSetting(QStringLiteral("window/geometry"), geometry);
    saveSetting(QStringLiteral("window/state"), state);
  }
  m_presentation->end();
  event->accept();
  emit closed();
}

}  // namespace geargraph

#include "moc_main_window.cpp"

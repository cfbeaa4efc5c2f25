// What the window does when a command is given: menus, tool bar, dialogs.

#include <QApplication>
#include <QClipboard>
#include <QDockWidget>
#include <QDragEnterEvent>
#include <QFileDialog>
#include <QFileInfo>
#include <QMenuBar>
#include <QMimeData>
#include <QScreen>
#include <QTimer>
#include <QWhatsThis>

#include "core/mechanism/model/edits.h"
#include "core/presentation/report/report.h"
#include "ui/atlas_panel/atlas_panel.h"
#include "ui/canvas/digraph_view.h"
#include "ui/designer/designer_panel.h"
#include "ui/designer/hub_panel.h"
#include "ui/help/search_entries.h"
#include "ui/help/search_field.h"
#include "ui/mainwindow/about_dialog.h"
#include "ui/mainwindow/document_files.h"
#include "ui/mainwindow/edit_commands.h"
#include "ui/mainwindow/export_jobs.h"
#include "ui/mainwindow/history_dialog.h"
#include "ui/mainwindow/main_window.h"
#include "ui/mainwindow/picture_dialog.h"
#include "ui/mainwindow/power_arrows.h"
#include "ui/mainwindow/power_view.h"
#include "ui/mainwindow/presentation.h"
#include "ui/mainwindow/recent_exports.h"
#include "ui/mainwindow/recent_files.h"
#include "ui/mainwindow/sheet_offer.h"
#include "ui/mainwindow/shortcut_sheet.h"
#include "ui/mainwindow/start_page.h"
#include "ui/mainwindow/status_line.h"
#include "ui/mainwindow/view_docks.h"
#include "ui/mainwindow/window_exports.h"
#include "ui/mainwindow/window_files.h"
#include "ui/mainwindow/window_help.h"
#include "ui/models/term_tips.h"
#include "ui/panels/engagement_edits.h"
#include "ui/panels/insert_set_dialog.h"
#include "ui/panels/matrices_panel.h"
#include "ui/panels/problems_panel.h"
#include "ui/reading/derivation_panel.h"
#include "ui/reading/print_dialog.h"
#include "ui/settings/languages.h"
#include "ui/settings/settings.h"
#include "ui/teeth_panel/teeth_panel.h"
#include "ui/theme/application_theme.h"
#include "ui/view3d/view3d.h"
#include "ui/workbench/measuring.h"

namespace geargraph {
namespace {

/// Only English begins such a name with a small letter: "Undo add link", "Rückgängig: Glied hinzufügen".
QString inSentence(const QString& edit) {
  return currentLanguage() == QLatin1String("en") ? edit.toLower() : edit;
}

}  // namespace

void MainWindow::makeMenus() {
  using enum CommandId;
  const WindowActions& a = *m_actions;
  const auto menu = [this](const QString& title) {
    QMenu* made = menuBar()->addMenu(title);
    made->setToolTipsVisible(true);
    return made;
  };
  QMenu* file = menu(tr("&File"));
  file->addActions(a.of({newDocument, newWindow, startPage, open}));
  file->addMenu(m_recent);
  QMenu* examples = file->addMenu(tr("Open e&xample"));
  for (const ExampleGroup& group : exampleGroups()) {
    examples->addSection(group.title);
    for (const QString& path : group.paths) {
      QAction* example =
          examples->addAction(exampleTitle(path), this, [this, path] { m_files->openByUser(path); });
      example->setObjectName(QStringLiteral("example.") + QFileInfo(path).completeBaseName());
      example->setProperty(kSearchWords,
                           QString(QFileInfo(path).completeBaseName() + QLatin1Char(' ') + group.title));
    }
  }
  examples->addSeparator();
  examples->addAction(tr("With pictures…"), this, [this] { showStartPage(); })
      ->setToolTip(tr("The start page with titles, pictures and a sentence about each example"));
  examples->setToolTipsVisible(true);
  file->addSeparator();
  file->addActions(a.of({save, saveAs, revert}));
  file->addSeparator();
  file->addAction(a[exportAny]);
  file->addMenu(m_recentExports);
  file->addActions(a.of({exportMatrix, exportPicture, exportDerivation, exportHandout}));
  file->addSeparator();
  file->addAction(a[print]);
  file->addSeparator();
  file->addAction(a[restoreSession]);
  file->addSeparator();
  file->addActions(a.of({close, quit}));

  QMenu* edit = menu(tr("&Edit"));
  edit->addActions(a.of({undo, redo, history}));
  edit->addSeparator();
  edit->addActions(a.of({cut, copy, copyPicture, paste, duplicate, remove}));
  edit->addSeparator();
  edit->addActions(a.of({rename, selectAll}));

  QMenu* view = menu(tr("&View"));
  view->addActions(a.of({fit, fitSelected, zoomIn, zoomOut, grid, captions}));
  view->addSeparator();
  view->addAction(a[powerFlow]);
  QMenu* observers = view->addMenu(tr("Power seen fro&m"));
  connect(observers, &QMenu::aboutToShow, this, [this, observers] { m_power->fillObservers(*observers); });
  view->addSeparator();
  view->addActions(m_docks->actions());
  view->addAction(a[resetLayout]);
  view->addSeparator();
  QMenu* theme = view->addMenu(tr("&Theme"));
  theme->addActions(a.of({asSystem, light, dark, highContrast}));
  view->addMenu(tr("T&ype size"))->addActions(a.typeSizes->actions());
  addLanguages(*view->addMenu(tr("La&nguage")));
  view->addActions(a.of({half3d, projector, presentation}));

  QMenu* mechanism = menu(tr("&Mechanism"));
  mechanism->addActions(a.tools->actions());
  mechanism->addSeparator();
  mechanism->addActions(a.of({flip, drive, load, hold, releaseAll, attachGear, weld, split, makeGround}));
  mechanism->addSeparator();
  mechanism->addActions(a.of({insertSet, findTeeth, designGearbox, hardware, atlas}));
  QMenu* planets = mechanism->addMenu(tr("&Planets like the selected one"));
  for (QAction* count : a.planets) planets->addAction(count);
  mechanism->addSeparator();
  mechanism->addAction(a[tidy]);

  QMenu* motion = menu(tr("M&otion"));
  motion->addActions(a.of({play, toStart}));
  motion->addSeparator();
  motion->addActions(a.of({faster, slower, normalSpeed, backwards}));

  menu(tr("&Learn"))
      ->addActions(a.of({lessons, lessonFile, lessonPages, exercises, handoutNow, checkPaper, showDerivation,
                         compareMethods, lookUp}));
  menu(tr("&Help"))->addActions(a.of({manual, whatsThis, tour, search, shortcuts, about}));
}

void MainWindow::wireActions() {
  using enum CommandId;
  const WindowActions& a = *m_actions;
  QUndoStack& stack = m_document->undoStack();
  connect(a[exportAny], &QAction::triggered, this, [this] { m_exports->chooseAndExport(); });
  connect(a[exportMatrix], &QAction::triggered, this, [this] { matrices().wantExport(); });
  connect(a[exportPicture], &QAction::triggered, this, &MainWindow::askForPicture);
  connect(a[exportDerivation], &QAction::triggered, m_exports, &WindowExports::chooseAndExportDerivation);
  connect(a[exportHandout], &QAction::triggered, m_exports, &WindowExports::chooseAndExportHandout);
  connect(a[print], &QAction::triggered, this, &MainWindow::showPrintDialog);
  connect(a[history], &QAction::triggered, this, &MainWindow::showHistory);
  connect(a[copyPicture], &QAction::triggered, this, [this] {
    m_exports->copyPicture(isView3DInFocus() ? QStringLiteral("3d") : drawing().objectName());
  });
  connect(a[showDerivation], &QAction::triggered, this, &MainWindow::showDerivation);
  connect(a[compareMethods], &QAction::triggered, this, [this] {
    this->showDerivation();
    derivation().showSection(shownText(translated(kComparisonHeading)));
  });
  connect(a[lessons], &QAction::triggered, this, &MainWindow::showCourse);
  connect(a[lessonFile], &QAction::triggered, this, &MainWindow::chooseLessonFile);
  connect(a[lessonPages], &QAction::triggered, m_exports, &WindowExports::chooseAndExportLessons);
  connect(a[exercises], &QAction::triggered, this, &MainWindow::showExercises);
  connect(a[handoutNow], &QAction::triggered, m_exports, &WindowExports::exportHandoutNow);
  connect(a[checkPaper], &QAction::triggered, this, &MainWindow::showPaperCheck);
  connect(a[undo], &QAction::triggered, &stack, &QUndoStack::undo);
  connect(a[redo], &QAction::triggered, &stack, &QUndoStack::redo);
  connect(&stack, &QUndoStack::indexChanged, this, &MainWindow::updateCommands);
  connect(a[cut], &QAction::triggered, m_commands, &EditCommands::cut);
  connect(a[copy], &QAction::triggered, this, [this] {
    const QString measured = m_workbench->measuring().text();
    if (measured.isEmpty()) return static_cast<void>(m_commands->copy());
    QGuiApplication::clipboard()->setText(measured);
  });
  connect(&m_workbench->measuring(), &Measuring::changed, this, [this] {
    if (m_workbench->measuring().isOn()) m_status->setHint(m_workbench->measuring().hint());
    updateCommands();
  });
  connect(a[paste], &QAction::triggered, m_commands, &EditCommands::paste);
  connect(a[duplicate], &QAction::triggered, m_commands, &EditCommands::duplicate);
  connect(a[remove], &QAction::triggered, this, [this] { drawing().deleteSelected(); });
  connect(a[rename], &QAction::triggered, this, [this] {
    showDrawing(drawing().objectName());
    drawing().renameSelected();
  });
  connect(a[selectAll], &QAction::triggered, this, [this] { drawing().selectAll(); });
  connect(a.tools, &QActionGroup::triggered, this, [this](QAction* tool) {
    const auto kind = static_cast<ToolKind>(tool->data().toInt());
    // What is to be measured may be in the 3D view, where the keys stay.
    const bool isIn3D = kind == ToolKind::measure && view3d().hasFocus();
    showDrawing(kind == ToolKind::note ? digraph().objectName() : drawing().objectName());
    drawing().setTool(kind);
    isIn3D ? view3d().setFocus() : drawing().setFocus();
    if (kind == ToolKind::load) drawing().editLoad();
  });
  connect(a[flip], &QAction::triggered, this, [this] { drawing().flipSelected(); });
  connect(a[weld], &QAction::triggered, this, [this] { drawing().weldSelected(); });
  connect(a[split], &QAction::triggered, this, [this] { drawing().splitSelected(); });
  connect(a[drive], &QAction::triggered, this, [this] { drawing().toggleInputs(); });
  connect(a[hold], &QAction::triggered, this, [this] { drawing().toggleBrake(); });
  connect(a[load], &QAction::triggered, this, [this] { drawing().editLoad(); });
  connect(a[releaseAll], &QAction::triggered, this, [this] { m_document->apply(releaseAllEdit()); });
  connect(a[tidy], &QAction::triggered, this, [this] { drawing().tidy(); });
  connect(a[makeGround], &QAction::triggered, m_commands, &EditCommands::makeGround);
  connect(a[insertSet], &QAction::triggered, this, [this] { showInsertSet(); });
  connect(a[findTeeth], &QAction::triggered, this, [this] {
    auto& panel = m_views->get<TeethPanel>();
    m_docks->reveal(panel);
    panel.askForRatio();
  });
  connect(a[atlas], &QAction::triggered, this, [this] { showTab(m_views->get<AtlasPanel>()); });
  connect(a[designGearbox], &QAction::triggered, this, [this] { showTab(m_views->get<DesignerPanel>()); });
  connect(a[hardware], &QAction::triggered, this, [this] { showTab(m_views->get<HubPanel>()); });
  for (std::size_t i = 0; i < a.planets.size(); ++i) {
    connect(a.planets[i], &QAction::triggered, m_commands,
            [this, total = static_cast<int>(i) + 2] { m_commands->makePlanets(total); });
  }
  connect(a[fit], &QAction::triggered, this, [this] { drawing().fit(); });
  connect(a[zoomIn], &QAction::triggered, this, [this] { drawing().zoomIn(); });
  connect(a[zoomOut], &QAction::triggered, this, [this] { drawing().zoomOut(); });
  connect(a[fitSelected], &QAction::triggered, this, [this] { drawing().fitSelected(); });
  connect(a[asSystem], &QAction::triggered, this, [this] { chooseTheme(std::nullopt); });
  connect(a.typeSizes, &QActionGroup::triggered, this,
          [this](const QAction* size) { chooseTypeScale(size->data().toDouble()); });
  connect(a[half3d], &QAction::triggered, this, &MainWindow::showView3DOnHalf);
  connect(a[projector], &QAction::triggered, this, &MainWindow::layOutForProjector);
  connect(a[light], &QAction::triggered, this, [this] { chooseTheme(Theme::light); });
  connect(a[dark], &QAction::triggered, this, [this] { chooseTheme(Theme::dark); });
  connect(a[highContrast], &QAction::triggered, this, [this] { chooseTheme(Theme::highContrast); });
  connect(a[grid], &QAction::toggled, this, [this](bool on) {
    saveSetting(QStringLiteral("grid"), on);
    for (DrawingView* each : m_allDrawings) each->setGrid(on);
  });
  a[grid]->setChecked(savedSetting(QStringLiteral("grid"), false).toBool());
  connect(a[captions], &QAction::toggled, this, [this](bool on) {
    for (DrawingView* each : m_allDrawings) each->setCaptioned(on);
  });
  connect(a[captions], &QAction::triggered, this,
          [](bool on) { saveSetting(QStringLiteral("captions"), on); });
  a[captions]->setChecked(savedSetting(QStringLiteral("captions"), false).toBool());
  connect(a[powerFlow], &QAction::toggled, this, [this](bool on) {
    saveSetting(QStringLiteral("powerFlow"), on);
    m_power->setOn(on);
  });
  a[powerFlow]->setChecked(savedSetting(QStringLiteral("powerFlow"), false).toBool());
  const auto* arrows = new PowerArrows(*m_workbench, view3d(), *m_power, *a[powerFlow], m_power);
  connect(arrows, &PowerArrows::changed, this, &MainWindow::emitSettledIfIdle);
  connect(a[presentation], &QAction::triggered, m_presentation, &Presentation::setOn);
  connect(a[attachGear], &QAction::triggered, this, [this] { drawing().attachGear(); });
  connect(a[shortcuts], &QAction::triggered, this, &MainWindow::showShortcuts);
  connect(a[resetLayout], &QAction::triggered, this, &MainWindow::resetLayout);
  connect(a[search], &QAction::triggered, this, [this] { m_search->begin(); });
  connect(a[lookUp], &QAction::triggered, this, [this] { m_search->begin(SearchField::Scope::terms); });
  connect(a[about], &QAction::triggered, this, &MainWindow::showAbout);
  connect(a[manual], &QAction::triggered, m_help, &WindowHelp::showPageForFocus);
  connect(a[whatsThis], &QAction::triggered, m_help, [] { QWhatsThis::enterWhatsThisMode(); });
  connect(a[tour], &QAction::triggered, m_help, &WindowHelp::startTour);
}

void MainWindow::wireFiles() {
  using enum CommandId;
  const WindowActions& a = *m_actions;
  WindowFiles* files = m_files.get();
  connect(files, &WindowFiles::titleChanged, this, &MainWindow::updateTitle);
  connect(files, &WindowFiles::joined, this, &MainWindow::updateCommands);
  connect(files, &WindowFiles::rejected, m_status, &StatusLine::showRejection);
  connect(files, &WindowFiles::noted, m_status, &StatusLine::showNote);
  connect(files, &WindowFiles::read, &problems(), &ProblemsPanel::clearFileProblems);
  connect(files, &WindowFiles::unreadable, this, [this](const QString& name, const Diagnostics& why) {
    problems().setFileProblems(name, why);
    m_docks->reveal(problems());
  });
  connect(m_recentExports, &RecentExports::chosen, m_exports, &WindowExports::exportAgain);
  const auto listExports = [this] { m_recentExports->setDocument(m_files->source()); };
  connect(m_exports, &WindowExports::written, m_recentExports, listExports);
  connect(files, &WindowFiles::titleChanged, m_recentExports, listExports);
  connect(m_recentExports, &QMenu::aboutToShow, m_recentExports, listExports);
  connect(m_document, &Document::changed, m_exportJobs, &ExportJobs::forgetWritten);
  connect(m_recent, &RecentFiles::chosen, files, &WindowFiles::openByUser);
  connect(a[newDocument], &QAction::triggered, files, &WindowFiles::newByUser);
  connect(a[newWindow], &QAction::triggered, files, &WindowFiles::newWindow);
  connect(a[startPage], &QAction::triggered, this, [this] { showStartPage(); });
  connect(a[open], &QAction::triggered, files, &WindowFiles::chooseAndOpen);
  connect(a[save], &QAction::triggered, files, &WindowFiles::saveOrChoose);
  connect(a[saveAs], &QAction::triggered, files, &WindowFiles::chooseAndSave);
  connect(a[revert], &QAction::triggered, files, &WindowFiles::revert);
  connect(a[restoreSession], &QAction::triggered, files, &WindowFiles::setRestoresSession);
  connect(a[close], &QAction::triggered, this, &QWidget::close);
  connect(a[quit], &QAction::triggered, files, &WindowFiles::quit);
  connect(m_start, &StartPage::newWanted, files, &WindowFiles::newByUser);
  connect(m_start, &StartPage::openWanted, files, &WindowFiles::chooseAndOpen);
  connect(m_start, &StartPage::designWanted, (*m_actions)[CommandId::designGearbox], &QAction::trigger);
  connect(m_start, &StartPage::chosen, files, &WindowFiles::openByUser);
  connect(m_document, &Document::replaced, this, &MainWindow::onOpened);
  // Whoever begins to draw, or opens something, is done with the start page.
  for (const auto signal : {&Document::changed, &Document::replaced}) {
    connect(m_document, signal, m_start, [this] { m_start->dismiss(&drawing()); });
  }
  connect(a.tools, &QActionGroup::triggered, m_start, [this] { m_start->dismiss(&drawing()); });
}

void MainWindow::showStartPage(bool withRecent) {
  m_start->open(withRecent);
}

void MainWindow::dragEnterEvent(QDragEnterEvent* event) {
  if (!WindowFiles::filesIn(*event->mimeData()).isEmpty()) event->acceptProposedAction();
}

void MainWindow::dropEvent(QDropEvent* event) {
  for (const QString& path : WindowFiles::filesIn(*event->mimeData())) m_files->openByUser(path);
  event->acceptProposedAction();
}

CommandState MainWindow::commandState() {
  const QUndoStack& stack = m_document->undoStack();
  const auto& selected = m_selection->selected();
  const Mechanism& mechanism = *m_document->mechanism();
  const auto count = [&](ElementKind kind) {
    return static_cast<int>(std::count_if(selected.begin(), selected.end(),
                                          [kind](const ElementId& element) { return element.kind == kind; }));
  };
  CommandState now;
  now.canUndo = stack.canUndo();
  now.canRedo = stack.canRedo();
  now.links = count(ElementKind::link);
  now.joints = count(ElementKind::turningJoint);
  now.meshes = count(ElementKind::gearMesh);
  now.notes = count(ElementKind::note);
  now.selected = static_cast<int>(selected.size());
  now.isGroundSelected = selected.contains(ElementId(mechanism.links.front().id));
  now.hasLinks = mechanism.n() > 0;
  now.isEngaged = !mechanism.engaged.empty();
  m_files->describe(now);
  now.hasMatrix = matrices().model().isThere();
  now.isQuantity = matrices().model().result().of != ResultOf::graph;
  now.areAnswersOpen = m_areAnswersOpen;
  now.isMeasured = !m_workbench->measuring().text().isEmpty();
  now.whyNoLoad = drawing().whyNoLoad();
  now.whyNoGear = now.isOneLink() ? drawing().whyNoGear() : QString();
  now.whyNoWeld = drawing().whyNoWeld();
  now.whyNoSplit = drawing().whyNoSplit();
  now.whyNoDerivation = m_exports->whyNoDerivation();
  now.whyNoPowerFlow = m_power->unavailableReason();
  return now;
}

void MainWindow::updateCommands() {
  const WindowActions& a = *m_actions;
  const QUndoStack& stack = m_document->undoStack();
  a[CommandId::undo]->setText(stack.canUndo() ? tr("&Undo %1").arg(inSentence(stack.undoText()))
                                              : tr("&Undo"));
  a[CommandId::redo]->setText(stack.canRedo() ? tr("&Redo %1").arg(inSentence(stack.redoText()))
                                              : tr("&Redo"));
  m_actions->renew(commandState());
}

/// None: the system's.
void MainWindow::chooseTheme(const std::optional<Theme>& theme) {
  theme ? saveTheme(*theme) : followSystemTheme();
  for (QWidget* window : QApplication::topLevelWidgets()) {
    if (auto* main = qobject_cast<MainWindow*>(window)) main->setTheme(savedTheme());
  }
}

void MainWindow::chooseTypeScale(double scale) {
  saveTypeScale(scale);
  for (QWidget* window : QApplication::topLevelWidgets()) {
    if (auto* main = qobject_cast<MainWindow*>(window)) main->setTheme(themeOf(QApplication::palette()));
  }
}

void MainWindow::showView3DOnHalf() {
  QDockWidget* view = m_docks->of(view3d());
  view->setFloating(false);
  view->show();
  view->raise();
  resizeDocks({view}, {width() / 2}, Qt::Horizontal);
}

/// The smallest words, those of captions, are then larger than 14 px.
void MainWindow::layOutForProjector() {
  constexpr double kTypeScale = 1.5, kShareOf3D = 0.38;
  chooseTypeScale(kTypeScale);
  showDrawing(drawing().objectName());
  m_docks->showOnly({&view3d()});
  QDockWidget* view = m_docks->of(view3d());
  view->setFloating(false);
  resizeDocks({view}, {static_cast<int>(kShareOf3D * width())}, Qt::Horizontal);
}

void MainWindow::showShortcuts() {
  (new ShortcutSheet(*menuBar(), this))->show();
}

void MainWindow::makeOffer() {
  m_offer = new SheetOffer(&digraph());
  connect(m_offer, &SheetOffer::drawWanted, m_actions->tool[static_cast<std::size_t>(ToolKind::link)],
          &QAction::trigger);
  connect(m_offer, &SheetOffer::setWantedOf, this, &MainWindow::showInsertSet);
  connect(m_offer, &SheetOffer::examplesWanted, this, [this] { showStartPage(); });
  connect(m_offer, &SheetOffer::designWanted, (*m_actions)[CommandId::designGearbox], &QAction::trigger);
  connect(&digraph(), &DrawingView::toolChanged, this, &MainWindow::updateOffer);
}

void MainWindow::updateOffer() {
  if (m_offer == nullptr) return;
  const Mechanism& mechanism = *m_document->mechanism();
  const bool isEmpty = mechanism.n() == 0 && mechanism.view.notes.empty();
  m_offer->setWanted(isEmpty && m_lesson == nullptr && !m_files->isReadOnly() &&
                     digraph().tool() == ToolKind::select);
}

void MainWindow::showInsertSet(const QString& kind) {
  if (m_insertSet == nullptr) {
    m_insertSet = new InsertSetDialog(this);
    connect(m_insertSet, &InsertSetDialog::insertWanted, this, [this](const Mechanism& set) {
      m_commands->insertSet(set);
      drawing().fit();
    });
    connect(m_insertSet, &InsertSetDialog::designWanted, (*m_actions)[CommandId::designGearbox],
            &QAction::trigger);
  }
  if (!kind.isEmpty()) m_insertSet->choose(kind);
  m_insertSet->show();
  m_insertSet->raise();
  m_insertSet->activateWindow();
}

/// Brings a tab to the front that is no drawing.
void MainWindow::showTab(ResultsView& view) {
  m_start->dismiss(&drawing());
  showDrawing(view.widget().objectName());
  view.widget().setFocus();
}

void MainWindow::askForPicture() {
  std::vector<std::pair<QString, QString>> views;
  for (DrawingView* each : m_allDrawings)
    views.emplace_back(each->objectName(), m_drawings->tabText(m_drawings->indexOf(each)));
  views.emplace_back(QStringLiteral("3d"), tr("3D"));
  auto* dialog = new PictureDialog(views, isView3DInFocus() ? QStringLiteral("3d") : drawing().objectName(),
                                   drawing().theme() == Theme::dark, this);
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  connect(dialog, &PictureDialog::wanted, m_exports, &WindowExports::chooseAndExportPicture);
  dialog->show();
}

bool MainWindow::isView3DInFocus() const {
  const QWidget* focus = QApplication::focusWidget();
  return focus == &view3d() || view3d().isAncestorOf(focus);
}

/// Prints the document as it is now, whatever is edited while the dialog is open.
void MainWindow::showPrintDialog() {
  PrintSource source;
  const QString name = shownText(m_document->mechanism()->name);
  source.title = name.isEmpty() ? m_files->title() : name;
  drawForPrint(std::move(source), m_document->mechanism(), 0);
}

/// The drawings from `next` on, each in an event of its own, as one that has not been shown lately takes as
/// long as one may wait for.
void MainWindow::drawForPrint(PrintSource source, const MechanismPtr& mechanism, int next) {
  if (m_document->mechanism() != mechanism) return showPrintDialog();  // edited meanwhile
  const auto index = static_cast<std::size_t>(next);
  if (index == m_allDrawings.size()) return openPrintDialog(std::move(source));
  DrawingView* each = m_allDrawings[index];
  std::function<DisplayList()> draw = each->pictureMaker();
  if (each->whyNoPicture().isEmpty()) {
    if (each == &drawing()) source.inFront = source.drawings.size();
    source.drawings.push_back({m_drawings->tabText(m_drawings->indexOf(each)), std::move(draw)});
  }
  QTimer::singleShot(0, this, [this, source = std::move(source), mechanism, next]() mutable {
    drawForPrint(std::move(source), mechanism, next + 1);
  });
}

void MainWindow::openPrintDialog(PrintSource source) {
  source.whyNoDerivation = m_exports->whyNoDerivation();
  if (source.whyNoDerivation.isEmpty() && !analysis().isComplete())
    source.whyNoDerivation = tr("The solution is still being worked out.");
  if (source.whyNoDerivation.isEmpty()) source.snapshot = analysis().snapshot();
  auto* dialog = new PrintDialog(std::move(source), this);
  connect(dialog, &PrintDialog::printWanted, m_exports, &WindowExports::print);
  dialog->show();
}

void MainWindow::showHistory() {
  (new HistoryDialog(m_document, this))->show();
}

void MainWindow::showDerivation() {
  m_docks->reveal(derivation());
}

void MainWindow::showAbout() {
  showAboutDialog(this);
}

}  // namespace geargraph

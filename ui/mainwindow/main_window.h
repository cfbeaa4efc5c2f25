#pragma once

#include <QMainWindow>
#include <QTabWidget>
#include <memory>

#include "ui/mainwindow/presentation.h"
#include "ui/mainwindow/window_actions.h"
#include "ui/workbench/views.h"
#include "ui/workbench/workbench.h"

namespace geargraph {
class DigraphView;
class DrawingView;
class TtGraphView;
}  // namespace geargraph
namespace geargraph {
class ForcesPanel;
}  // namespace geargraph
namespace geargraph {
struct Lesson;
}  // namespace geargraph
namespace geargraph {
class GearboxPanel;
class InsertSetDialog;
class MatricesPanel;
class ProblemsPanel;
class ResultsPanel;
}  // namespace geargraph
namespace geargraph {
struct PrintSource;
}  // namespace geargraph
namespace geargraph {
class SearchField;
}  // namespace geargraph
namespace geargraph {
class DynamicsPanel;
}  // namespace geargraph
namespace geargraph {
class DerivationPanel;
}  // namespace geargraph
namespace geargraph {
class CourseDialog;
class LessonPanel;
}  // namespace geargraph
namespace geargraph {
class ExercisesDialog;
}  // namespace geargraph
namespace geargraph {
class WorkCheckDialog;
}  // namespace geargraph
namespace geargraph {
class SchematicView;
}  // namespace geargraph
namespace geargraph {
class MotionPanel;
class View3D;
}  // namespace geargraph

namespace geargraph {

class EditCommands;
class NoticeBar;
class ExportJobs;
class FileWatch;
class PowerView;
class Presentation;
class RecentExports;
class RecentFiles;
class SheetOffer;
class StatusLine;
class StartPage;
class ViewDocks;
class WindowExports;
class WindowFiles;
class WindowHelp;

/// The window of one document with the views of the table (view_table.h): makes them and lays them out,
/// passes the results of the workbench on, and connects them with its commands.
class MainWindow : public QMainWindow {
  Q_OBJECT

 public:
  explicit MainWindow(QWidget* parent = nullptr);
  /// Creates a replacement for a window in the current language: with its document and history, selection,
  /// layout, drawing, tool, camera and time of the motion; not shown yet. The former window is hidden; delete
  /// it before the new one, after control has returned to the event loop.
  [[nodiscard]] static std::unique_ptr<MainWindow> inPlaceOf(MainWindow& former);
  ~MainWindow() override;

  [[nodiscard]] Workbench& workbench() { return *m_workbench; }
  [[nodiscard]] Document& document() { return *m_document; }
  [[nodiscard]] Selection& selection() { return *m_selection; }
  [[nodiscard]] AnalysisService& analysis() { return m_workbench->analysis(); }
  /// The views of the window; `views().get<LeverPanel>()` is one of them.
  [[nodiscard]] Views& views() { return *m_views; }
  [[nodiscard]] ViewDocks& docks() { return *m_docks; }
  [[nodiscard]] DigraphView& digraph() const;
  [[nodiscard]] TtGraphView& ttGraph() const;
  /// The drawing in front, to which commands and tools apply; behind a tab that is no drawing, the last one.
  [[nodiscard]] DrawingView& drawing();
  /// Brings a tab to the front by name: "digraph", "ttgraph", "atlas". False if there is no such tab.
  bool showDrawing(const QString& name);
  [[nodiscard]] View3D& view3d() const;
  [[nodiscard]] MatricesPanel& matrices() const;
  [[nodiscard]] DerivationPanel& derivation() const;
  [[nodiscard]] ResultsPanel& results() const;
  [[nodiscard]] GearboxPanel& gearbox() const;
  [[nodiscard]] ForcesPanel& forces() const;
  [[nodiscard]] DynamicsPanel& dynamics() const;
  [[nodiscard]] ProblemsPanel& problems() const;
  [[nodiscard]] StatusLine& statusLine() { return *m_status; }
  [[nodiscard]] WindowActions& actions() { return *m_actions; }
  [[nodiscard]] WindowFiles& files() { return *m_files; }
  [[nodiscard]] NoticeBar& notices() { return *m_notices; }
  [[nodiscard]] ExportJobs& exportJobs() { return *m_exportJobs; }
  [[nodiscard]] StartPage& startPage() { return *m_start; }

  /// Opens a file or an example. The errors of an invalid one are listed in the problems panel with their
  /// positions, and the open document stays. True if it was opened.
  bool openDocument(const QString& path);
  /// False (and reported in the status bar) if it could not be written.
  bool saveDocument(const QString& path);
  /// The document with the state of views to be saved: the camera of the 3D view, if the user has changed it.
  [[nodiscard]] Mechanism documentToSave() const;
  [[nodiscard]] WindowExports& exports() { return *m_exports; }
  [[nodiscard]] MotionPanel& motion() const;

  /// Restores places and sizes of windows and docks from when the last window closed.
  void restoreLayout();
  void restoreLayout(const QByteArray& geometry, const QByteArray& state);
  /// Shows the start page over an empty document, until there is another one. `withRecent`: with recent
  /// files.
  void showStartPage(bool withRecent = true);
  void setTheme(Theme theme, bool isLaidOutNext = false);
  /// Plays a lesson in this window from the stored progress; the document then belongs to the lesson and is
  /// never saved. `place`: "Lesson 4 of 15". `file`: of a preview, which is reloaded when the file changes.
  void playLesson(const std::shared_ptr<const Lesson>& lesson, const QString& place, const QString& file);
  /// Previews the lesson of a file; errors are reported in the status bar.
  void openLessonFile(const QString& path);
  /// Null in windows without a lesson.
  [[nodiscard]] LessonPanel* lesson() { return m_lesson; }
  void showCourse();
  /// Shows the dialog of exercises about the document, to be practised or exported.
  void showExercises();
  /// Shows the dialog that compares the user's matrices with those of the document.
  void showPaperCheck();
  [[nodiscard]] WindowHelp& help() { return *m_help; }
  [[nodiscard]] Presentation& presentation() { return *m_presentation; }
  /// What is to be remembered of the window, whatever a presentation or a tab has put away.
  [[nodiscard]] Presentation::Layout workLayout() const;
  /// Are all views up to date with the document?
  [[nodiscard]] bool isSettled() const;

  /// Requests the end of all background work of the window, to be called when it is closed. Does not wait.
  void requestStop();
  /// Has all background work ended? Then the window can be destroyed without waiting.
  [[nodiscard]] bool hasStopped() const;

 signals:
  /// Analysis and stage of the current document have reached all views.
  void settled();
  /// The window has been closed, and its document saved or discarded.
  void closed();
  /// A lesson should be played in a window of its own.
  void lessonWanted(const std::shared_ptr<const Lesson>& lesson, const QString& place, const QString& file);
  /// All windows should switch to this language; empty: the system's.
  void languageWanted(const QString& code);

 protected:
  bool event(QEvent* event) override;
  bool eventFilter(QObject* watched, QEvent* event) override;
  /// Passes over panels that are covered by another tab.
  bool focusNextPrevChild(bool next) override;
  void closeEvent(QCloseEvent* event) override;
  void showEvent(QShowEvent* event) override;
  void dragEnterEvent(QDragEnterEvent* event) override;
  void dropEvent(QDropEvent* event) override;

 private:
  MainWindow(Workbench* workbench, QWidget* parent);
  [[nodiscard]] std::vector<BackgroundWork*> backgroundWork() const;
  void makeDrawings();
  void addDrawing(const ViewEntry& entry);
  void onDrawingChosen();
  void giveRoom();
  void addCloseButton(int tab);
  /// What can be done in the tab in front.
  [[nodiscard]] QString drawingHint();
  void makeViews();
  void makeCommands();
  void makeHelp();
  void resetLayout();
  void applyDefaultLayout();
  void raiseResults();
  void onOpened();
  void raiseProblems(const AnalysisSnapshot& snapshot);
  void makeMenus();
  void makeToolBar();
  void wireActions();
  void wireFiles();
  void wireViews();
  void wireDrawing(DrawingView* drawing);
  void wireView3D();
  void wireMotion();
  void wireView3DCommands();
  void wireAxisDrag();
  void startView3DAnew();

  void onDocumentChanged();
  void onSnapshot(const SnapshotPtr& snapshot);
  void onForces();
  void emitSettledIfIdle();
  [[nodiscard]] CommandState commandState();
  void updateCommands();
  void updateTitle();
  void showInsertSet(const QString& kind = {});
  void makeOffer();
  /// An empty sheet offers what to begin with, until a tool is picked.
  void updateOffer();
  void showTab(ResultsView& view);
  void showElement(const ElementId& element);
  void chooseTheme(const std::optional<Theme>& theme);
  void chooseTypeScale(double scale);
  void addLanguages(QMenu& menu);
  void showView3DOnHalf();
  void layOutForProjector();
  void onStage(const MechanismScenePtr& stage);
  void onSelectionChanged();
  void popUpMenuFor(const ElementId& element, QPoint at);
  void showShortcuts();

  void showPrintDialog();
  void drawForPrint(PrintSource source, const MechanismPtr& mechanism, int next);
  void openPrintDialog(PrintSource source);
  void showHistory();
  [[nodiscard]] bool isView3DInFocus() const;
  void showDerivation();
  void askForPicture();
  void showAbout();
  void chooseLessonFile();
  void wantLesson(const std::shared_ptr<const Lesson>& lesson, const QString& place, const QString& file);
  void makeLesson();
  void playNextLesson();
  void playLessonNamed(const QString& id);
  void setAnswersOpen(bool isOpen);
  void resumeLesson(const MainWindow& former);

  Workbench* m_workbench;
  Document* m_document;    ///< the workbench's
  Selection* m_selection;  ///< the workbench's
  std::unique_ptr<WindowActions> m_actions;
  std::unique_ptr<WindowFiles> m_files;

  Views* m_views;
  ViewDocks* m_docks = nullptr;
  QTabWidget* m_drawings = nullptr;        ///< of DrawingViews, and of other views as large as those
  DrawingView* m_drawing = nullptr;        ///< the last that was in front
  InsertSetDialog* m_insertSet = nullptr;  ///< created on first use
  StatusLine* m_status = nullptr;
  NoticeBar* m_notices = nullptr;
  StartPage* m_start = nullptr;
  SheetOffer* m_offer = nullptr;
  QAction* m_transport = nullptr;  ///< of the tool bar
  RecentFiles* m_recent = nullptr;
  RecentExports* m_recentExports = nullptr;
  SearchField* m_search = nullptr;
  Presentation* m_presentation = nullptr;
  std::vector<DrawingView*> m_allDrawings;
  QByteArray m_layout;  ///< to be restored when the window is shown
  bool m_layoutApplied = false;
  bool m_hasPicture = false;  ///< the 3D view shows something of this document
  bool m_areAnswersOpen = true;
  bool m_hadCaptions = false;  ///< before the presentation
  bool m_isOpened = false;     ///< since the last complete snapshot
  ExportJobs* m_exportJobs = nullptr;
  PowerView* m_power = nullptr;
  EditCommands* m_commands = nullptr;
  WindowExports* m_exports = nullptr;
  WindowHelp* m_help = nullptr;
  LessonPanel* m_lesson = nullptr;          ///< made with the first lesson
  CourseDialog* m_course = nullptr;         ///< created on first use
  ExercisesDialog* m_exercises = nullptr;   ///< the same
  WorkCheckDialog* m_paperCheck = nullptr;  ///< the same
  FileWatch* m_lessonWatch = nullptr;       ///< of a preview
  QString m_lessonFile;
};

}  // namespace geargraph

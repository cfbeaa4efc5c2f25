#pragma once

#include <QMainWindow>
#include <QTabWidget>
#include <memory>

#include "ui/mainwindow/window_actions.h"
#include "ui/workbench/workbench.h"

namespace geargraph::inline canvas {
class DigraphView;
class DrawingView;
class TtGraphView;
}  // namespace geargraph::inline canvas
namespace geargraph::inline forces {
class ForcesPanel;
}  // namespace geargraph::inline forces
namespace geargraph::inline lessons {
struct Lesson;
}  // namespace geargraph::inline lessons
namespace geargraph::inline panels {
class GearboxPanel;
class InputsPanel;
class InsertSetDialog;
class MatricesPanel;
class ProblemsPanel;
class PropertiesPanel;
class ResultsPanel;
}  // namespace geargraph::inline panels
namespace geargraph::inline printing {
struct PrintSource;
}  // namespace geargraph::inline printing
namespace geargraph::inline search {
class SearchField;
}  // namespace geargraph::inline search
namespace geargraph::inline ui_dynamics {
class DynamicsPanel;
}  // namespace geargraph::inline ui_dynamics
namespace geargraph::inline ui_derivation {
class DerivationPanel;
}  // namespace geargraph::inline ui_derivation
namespace geargraph::inline ui_lessons {
class CourseDialog;
class LessonPanel;
}  // namespace geargraph::inline ui_lessons
namespace geargraph::inline ui_exercises {
class ExercisesDialog;
}  // namespace geargraph::inline ui_exercises
namespace geargraph::inline ui_paper_check {
class PaperCheckDialog;
}  // namespace geargraph::inline ui_paper_check
namespace geargraph::inline ui_schematic {
class SchematicView;
}  // namespace geargraph::inline ui_schematic
namespace geargraph::inline view3d {
class MotionPanel;
class View3D;
}  // namespace geargraph::inline view3d

namespace geargraph::inline mainwindow {

class DockTitles;
class EditCommands;
class NoticeBar;
class ExportJobs;
class FileWatch;
class PowerView;
class Presentation;
class RecentFiles;
class StatusLine;
class StartPage;
class WindowExports;
class WindowFiles;
class WindowHelp;

/// One document and all its views: builds them, lays them out, and passes to each what the workbench answers.
class MainWindow : public QMainWindow {
  Q_OBJECT

 public:
  explicit MainWindow(QWidget* parent = nullptr);
  /// Built anew in the place of a window, in the language that is now in use: with its document and history,
  /// selection, layout, drawing, tool, camera and moment of the motion; not shown yet. The former one is
  /// hidden, and to be deleted before the new one, once control has returned to the event loop.
  [[nodiscard]] static std::unique_ptr<MainWindow> inPlaceOf(MainWindow& former);
  ~MainWindow() override;

  [[nodiscard]] Workbench& workbench() { return *m_workbench; }
  [[nodiscard]] Document& document() { return *m_document; }
  [[nodiscard]] Selection& selection() { return *m_selection; }
  [[nodiscard]] AnalysisService& analysis() { return m_workbench->analysis(); }
  [[nodiscard]] DigraphView& digraph() { return *m_digraph; }
  [[nodiscard]] TtGraphView& ttGraph() { return *m_ttGraph; }
  /// The drawing whose tab is in front: commands and tools are its.
  [[nodiscard]] DrawingView& drawing();
  /// Brings a drawing to the front by its name: "digraph", "ttgraph". False where there is none of that name.
  bool showDrawing(const QString& name);
  [[nodiscard]] View3D& view3d() { return *m_view3d; }
  [[nodiscard]] MatricesPanel& matrices() { return *m_matrices; }
  [[nodiscard]] DerivationPanel& derivation() { return *m_derivation; }
  [[nodiscard]] ResultsPanel& results() { return *m_results; }
  [[nodiscard]] GearboxPanel& gearbox() { return *m_gearbox; }
  [[nodiscard]] ForcesPanel& forces() { return *m_forces; }
  [[nodiscard]] DynamicsPanel& dynamics() { return *m_dynamics; }
  [[nodiscard]] ProblemsPanel& problems() { return *m_problems; }
  [[nodiscard]] StatusLine& statusLine() { return *m_status; }
  [[nodiscard]] WindowActions& actions() { return *m_actions; }
  [[nodiscard]] WindowFiles& files() { return *m_files; }
  [[nodiscard]] NoticeBar& notices() { return *m_notices; }
  [[nodiscard]] ExportJobs& exportJobs() { return *m_exportJobs; }
  [[nodiscard]] StartPage& startPage() { return *m_start; }

  /// Opens a file or an example. A broken one is listed in the problems with its places, and the document
  /// that was open stays. True where it was opened.
  bool openDocument(const QString& path);
  /// False, and said in the status bar, where it could not be written.
  bool saveDocument(const QString& path);
  /// The document with what the views want kept: the camera of the 3D view, where somebody has chosen one.
  [[nodiscard]] Mechanism documentToSave() const;
  [[nodiscard]] WindowExports& exports() { return *m_exports; }
  [[nodiscard]] MotionPanel& motion() { return *m_motion; }

  /// The places and sizes of windows and docks as they were when the last window closed.
  void restoreLayout();
  void restoreLayout(const QByteArray& geometry, const QByteArray& state);
  /// Over an empty document, until there is another one. `withRecent`: with the files of late.
  void showStartPage(bool withRecent = true);
  void setTheme(Theme theme);
  /// Plays a lesson in this window from where the learner left it; its document belongs to the lesson from
  /// now on and is never saved. `place`: "Lesson 4 of 15". `file`: of a preview, which is reloaded when it is
  /// written.
  void playLesson(const std::shared_ptr<const Lesson>& lesson, const QString& place, const QString& file);
  /// Previews the lesson of a file; what is wrong with it is reported in the status bar.
  void openLessonFile(const QString& path);
  /// Null in windows that play no lesson.
  [[nodiscard]] LessonPanel* lesson() { return m_lesson; }
  void showCourse();
  /// Questions about the document, to be practised or exported, in a window beside it.
  void showExercises();
  /// Compares matrices of the user's with those of the document, in a window beside it.
  void showPaperCheck();
  [[nodiscard]] WindowHelp& help() { return *m_help; }
  [[nodiscard]] Presentation& presentation() { return *m_presentation; }
  /// Is everything shown as the document is now?
  [[nodiscard]] bool isSettled() const;

  /// Once it is closed: all that works beside it is told to end. Does not wait.
  void tellToEnd();
  /// Has all of that ended? Then the window goes without waiting for anything.
  [[nodiscard]] bool hasEnded() const;

 signals:
  /// Analysis and stage of the document as it is now have reached all views.
  void settled();
  /// The window has been closed, and its document given up or saved.
  void closed();
  /// A lesson is to be played in a window of its own.
  void lessonWanted(const std::shared_ptr<const Lesson>& lesson, const QString& place, const QString& file);
  /// All windows are to be in this language; empty: the system's.
  void languageWanted(const QString& code);

 protected:
  bool event(QEvent* event) override;
  void closeEvent(QCloseEvent* event) override;
  void showEvent(QShowEvent* event) override;
  void dragEnterEvent(QDragEnterEvent* event) override;
  void dropEvent(QDropEvent* event) override;

 private:
  MainWindow(Workbench* workbench, QWidget* parent);
  [[nodiscard]] std::vector<BackgroundWork*> backgroundWork() const;
  void makeDrawings();
  void addDrawing(DrawingView* drawing, const char* name, const QString& title, const QString& tip);
  void onDrawingChosen();
  void makeDocks();
  void makeCommands();
  void makeHelp();
  QWidget* makeInputsAndResults();
  QAction* makePanelAction(QDockWidget* dock);
  QDockWidget* addDock(const char* name, const QString& title, QWidget* widget);
  [[nodiscard]] QDockWidget* dock(const char* name) const;
  void placeDocks();
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
  void onForces(const ForcesPtr& forces);
  void renewPowerFlow();
  void tellWhenSettled();
  void renewActions();
  void renewExport();
  void renewTitle();
  void showInsertSet();
  void showElement(const ElementId& element);
  void chooseTheme(const std::optional<Theme>& theme);
  void chooseTypeScale(double scale);
  void addLanguages(QMenu& menu);
  void showView3DOnHalf();
  void onStage(const StagePtr& stage);
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
  void goOnWithLesson(const MainWindow& former);

  Workbench* m_workbench;
  Document* m_document;    ///< the workbench's
  Selection* m_selection;  ///< the workbench's
  std::unique_ptr<WindowActions> m_actions;
  std::unique_ptr<WindowFiles> m_files;

  QTabWidget* m_drawings = nullptr;  ///< of DrawingViews
  DigraphView* m_digraph = nullptr;
  TtGraphView* m_ttGraph = nullptr;
  SchematicView* m_schematic = nullptr;
  InputsPanel* m_inputs = nullptr;
  MatricesPanel* m_matrices = nullptr;
  ProblemsPanel* m_problems = nullptr;
  PropertiesPanel* m_properties = nullptr;
  ResultsPanel* m_results = nullptr;
  GearboxPanel* m_gearbox = nullptr;
  MotionPanel* m_motion = nullptr;
  DerivationPanel* m_derivation = nullptr;
  ForcesPanel* m_forces = nullptr;
  DynamicsPanel* m_dynamics = nullptr;
  InsertSetDialog* m_insertSet = nullptr;  ///< made when it is first wanted
  View3D* m_view3d = nullptr;
  StatusLine* m_status = nullptr;
  NoticeBar* m_notices = nullptr;
  StartPage* m_start = nullptr;
  RecentFiles* m_recent = nullptr;
  SearchField* m_search = nullptr;
  DockTitles* m_titles = nullptr;
  Presentation* m_presentation = nullptr;
  std::vector<DrawingView*> m_allDrawings;
  std::vector<QDockWidget*> m_docks;
  std::vector<QAction*> m_panelActions;  ///< of the docks
  QByteArray m_layout;                   ///< to be restored when the window is shown
  bool m_layoutApplied = false;
  bool m_hasPicture = false;  ///< the 3D view shows something of this document
  bool m_isOpened = false;    ///< since the last complete snapshot
  ExportJobs* m_exportJobs = nullptr;
  PowerView* m_power = nullptr;
  EditCommands* m_commands = nullptr;
  WindowExports* m_exports = nullptr;
  WindowHelp* m_help = nullptr;
  LessonPanel* m_lesson = nullptr;           ///< made with the first lesson
  CourseDialog* m_course = nullptr;          ///< made when it is first wanted
  ExercisesDialog* m_exercises = nullptr;    ///< the same
  PaperCheckDialog* m_paperCheck = nullptr;  ///< the same
  FileWatch* m_lessonWatch = nullptr;        ///< of a preview
  QString m_lessonFile;
};

}  // namespace geargraph::inline mainwindow

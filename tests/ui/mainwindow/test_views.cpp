#include <QDockWidget>
#include <QLabel>
#include <QSet>
#include <QTest>

#include "core/mechanism/model/edits.h"
#include "tests/ui/mainwindow/hand.h"
#include "ui/help/help_page_of.h"
#include "ui/help/search_entries.h"
#include "ui/help/whats_this.h"
#include "ui/mainwindow/document_files.h"
#include "ui/mainwindow/view_docks.h"
#include "ui/mainwindow/view_table.h"

namespace geargraph {
namespace {

/// A view that records what it is told.
class RecordingView : public QLabel, public ResultsView {
 public:
  using QLabel::QLabel;

  [[nodiscard]] QWidget& widget() override { return *this; }
  void setMechanism(const MechanismPtr& newest) override { mechanism = newest; }
  void setSnapshot(const SnapshotPtr& newest) override { snapshot = newest; }
  void setAwake(bool awake) override { isAwake = awake; }
  void setAnswersOpen(bool isOpen) override { areAnswersOpen = isOpen; }
  [[nodiscard]] bool isSettled() const override { return isDone; }

  MechanismPtr mechanism;
  SnapshotPtr snapshot;
  bool isAwake = false;
  bool areAnswersOpen = true;
  bool isDone = true;
};

ViewEntry recordingEntry() {
  return {.id = "recording",
          .title = "Recording",
          .purpose = "What views are told.",
          .helpPage = "problems",
          .searchWords = "tape diary",
          .place = ViewPlace::bottom,
          .minimumSize = {90, 60},
          .make = [](Views&, QWidget* parent) -> ResultsView* { return new RecordingView(parent); }};
}

}  // namespace

/// The table of views, and what follows from an entry.
class ViewsTest : public QObject {
  Q_OBJECT

  std::unique_ptr<MainWindow> window;

  [[nodiscard]] QDockWidget* dockOf(const QString& id) const {
    return window->findChild<QDockWidget*>(QStringLiteral("dock.") + id);
  }

 private slots:
  void initTestCase() { test::setUpProgram(); }
  void init() {
    window = test::openedWindow(robotExamplePath());
    QVERIFY(window != nullptr);
  }
  void cleanup() { window.reset(); }

  // Layouts saved by users have these names, and users these keys in their fingers.
  void panelsKeepTheirNamesAndKeys() {
    QStringList names;
    for (const QAction* action : window->docks().actions())
      names << action->objectName() + ' ' + action->shortcut().toString();
    names = names.mid(0, 10);
    QCOMPARE(names, (QStringList{"dock.matrices Alt+1", "dock.problems Alt+2", "dock.view3d Alt+3",
                                 "dock.inputs Alt+4", "dock.gearbox Alt+5", "dock.properties Alt+6",
                                 "dock.speeds Alt+7", "dock.derivation Alt+8", "dock.forces Alt+9",
                                 "dock.dynamics Alt+0"}));
    for (const char* drawing : {"digraph", "ttgraph", "schematic", "levers"})
      QVERIFY(window->showDrawing(drawing));
  }

  void everyViewIsDescribed() {
    QSet<QString> ids;
    for (const ViewEntry& view : viewTable()) {
      QVERIFY2(!view.id.isEmpty() && !ids.contains(view.id), qPrintable(view.id));
      ids << view.id;
      QVERIFY2(!view.title.isEmpty() && view.purpose.endsWith('.'), qPrintable(view.id));
      QVERIFY2(view.make != nullptr, qPrintable(view.id));
      const bool isDrawing = view.place == ViewPlace::drawings;
      QVERIFY2(isDrawing ? !view.tip.isEmpty() : !view.searchWords.isEmpty(), qPrintable(view.id));
      QVERIFY2(view.place != ViewPlace::left, "the left is for lessons");
    }
  }

  void viewsOfAnEmptyDocumentTellWhatTheyNeed() {
    MainWindow empty;
    empty.show();
    QVERIFY(QTest::qWaitForWindowExposed(&empty));
    for (const Views::Made& each : empty.views().made()) {
      if (each.entry.id == "problems" || each.entry.id == "properties" || each.entry.id == "atlas")
        continue;                          // they are never without
      if (each.entry.wantsRoom) continue;  // they need no document
      if (each.entry.place == ViewPlace::drawings) {
        empty.showDrawing(each.entry.id);
      } else {
        empty.docks().reveal(*each.view);
      }
      QTRY_VERIFY2(!each.view->emptyText().isEmpty(), qPrintable(each.entry.id));
    }
    empty.close();
  }

  void viewsOfTheRobotShowSomething() {
    for (const Views::Made& each : window->views().made()) {
      // The robot has neither brakes nor states, and its axes point in several directions.
      if (each.entry.id == "gearbox" || each.entry.id == "levers") continue;
      if (each.entry.place == ViewPlace::drawings) {
        window->showDrawing(each.entry.id);
      } else {
        window->docks().reveal(*each.view);
      }
      QTRY_VERIFY2(each.view->emptyText().isEmpty(), qPrintable(each.entry.id + each.view->emptyText()));
    }
  }

  void panelsThatHoldAnswersAreClosedAndStayClosed() {
    const QString why = "not yet";
    window->docks().setAnswersOpen(false, why);
    window->actions()[CommandId::resetLayout]->trigger();
    for (const Views::Made& each : window->views().made()) {
      if (each.entry.place == ViewPlace::drawings) continue;
      const QAction* action = window->docks().actionOf(*each.view);
      QCOMPARE(window->docks().of(*each.view)->isHidden(), each.entry.holdsAnswers);
      QCOMPARE(action->isEnabled(), !each.entry.holdsAnswers);
      QCOMPARE(action->toolTip() == why, each.entry.holdsAnswers);
    }
    QVERIFY(dockOf("matrices")->isHidden() && !dockOf("view3d")->isHidden());
    window->docks().setAnswersOpen(true, why);
    for (const QAction* action : window->docks().actions()) QVERIFY(action->isEnabled());
  }

  // All that a new panel has to bring.
  void aPanelIsItsEntry() {
    ResultsView& made = window->views().make(recordingEntry(), window.get());
    QDockWidget* dock = window->docks().add(recordingEntry(), made);
    auto& view = window->views().get<RecordingView>();
    QCOMPARE(dock->objectName(), QString("dock.recording"));
    QCOMPARE(dock->windowTitle(), QString("Recording"));
    QVERIFY(window->tabifiedDockWidgets(dockOf("matrices")).contains(dock));
    QCOMPARE(view.minimumSize(), QSize(90, 60));
    QCOMPARE(helpPageOf(&view), QString("problems"));
    QVERIFY(WhatsThis::textFor(&view).contains("What views are told."));
    const QAction* action = window->docks().actionOf(view);
    QCOMPARE(action->property(kSearchWords).toString(), QString("tape diary"));
    QVERIFY(action->shortcut().isEmpty());  // ten have keys

    window->docks().reveal(view);
    QTRY_VERIFY(view.isAwake);
    window->docks().reveal(window->views().byId("matrices"));
    QTRY_VERIFY(!view.isAwake);

    window->document().apply({"Add link",
                              [](const Mechanism& before) {
                                return withLink(before, CanvasPoint{90, 90});
                              },
                              0});
    QCOMPARE(view.mechanism, window->document().mechanism());
    QTRY_VERIFY(view.snapshot && view.snapshot->isComplete &&
                view.snapshot->mechanism == window->document().mechanism());
    QTRY_VERIFY(window->isSettled());
    view.isDone = false;
    QVERIFY(!window->isSettled());
    view.isDone = true;
    QVERIFY(window->isSettled());
    window->views().setAnswersOpen(false);
    QVERIFY(!view.areAnswersOpen);
    window->views().setAnswersOpen(true);
  }

  // A new panel comes with an update of the program: the layout of before knows nothing of it.
  void aLayoutOfBeforeAPanelExistedIsRestored() {
    dockOf("speeds")->hide();
    const QByteArray former = window->saveState();
    MainWindow next;
    ResultsView& made = next.views().make(recordingEntry(), &next);
    QDockWidget* dock = next.docks().add(recordingEntry(), made);
    next.restoreLayout({}, former);
    next.show();
    QVERIFY(QTest::qWaitForWindowExposed(&next));
    auto* matrices = next.findChild<QDockWidget*>("dock.matrices");
    QVERIFY(next.findChild<QDockWidget*>("dock.speeds")->isHidden());
    QVERIFY(next.tabifiedDockWidgets(matrices).contains(dock));
    QVERIFY(!dock->isFloating() && next.width() <= 1366);
    next.close();
  }
};

}  // namespace geargraph

QTEST_MAIN(geargraph::ViewsTest)

#include "test_views.moc"

#include <QDockWidget>
#include <QFile>
#include <QFileInfo>
#include <QHelpEvent>
#include <QLabel>
#include <QMessageBox>
#include <QPushButton>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>
#include <QTimer>
#include <QToolButton>

#include "core/mechanism/model/edits.h"
#include "tests/ui/mainwindow/hand.h"
#include "ui/canvas/digraph_view.h"
#include "ui/mainwindow/document_files.h"
#include "ui/mainwindow/play_controls.h"
#include "ui/mainwindow/status_line.h"
#include "ui/mainwindow/window_exports.h"
#include "ui/panels/matrices_panel.h"
#include "ui/panels/problems_panel.h"
#include "ui/theme/application_theme.h"
#include "ui/theme/in_sight.h"

namespace geargraph {

class MainWindowTest : public QObject {
  Q_OBJECT

  std::unique_ptr<MainWindow> window;
  const QTemporaryDir folder;

  [[nodiscard]] const MechanismPtr& now() const { return window->document().mechanism(); }
  QString written(const QString& name, const QByteArray& bytes) {
    QFile file(folder.filePath(name));
    if (!file.open(QIODevice::WriteOnly) || file.write(bytes) != bytes.size()) return {};
    return file.fileName();
  }
  void addLink() {
    window->document().apply({QStringLiteral("Add link"),
                              [](const Mechanism& mechanism) {
                                return withLink(mechanism, CanvasPoint{90, 90});
                              },
                              0});
  }
  /// Answers the close question when it comes up.
  static void answerWith(QMessageBox::StandardButton button) {
    QTimer::singleShot(0, qApp, [button] {
      auto* box = qobject_cast<QMessageBox*>(QApplication::activeModalWidget());
      QVERIFY(box != nullptr);
      QTest::mouseClick(box->button(button), Qt::LeftButton);
    });
  }

 private slots:
  void initTestCase() { test::setUpProgram(); }
  void init() {
    window = test::openedWindow(robotExamplePath());
    QVERIFY(window != nullptr);
  }
  void cleanup() { window.reset(); }

  // A window that is taken apart restyles its tool bar when its 3D view is gone.
  void playControlsMayOutliveThePlayback() {
    auto playback = std::make_unique<Playback>();
    PlayControls controls(playback.get());
    playback.reset();
    QPalette other = controls.palette();
    other.setColor(QPalette::Window, Qt::red);
    controls.setPalette(other);
    QVERIFY(!controls.findChild<QToolButton*>()->toolTip().isEmpty());
  }

  void aBrokenFileIsAListOfProblems() {
    const MechanismPtr before = now();
    QVERIFY(
        !window->openDocument(written("cut.geargraph", "{\n  \"format\": \"geargraph\",\n  \"links\": [")));
    QCOMPARE(now().get(), before.get());
    DiagnosticModel& model = window->problems().model();
    QVERIFY(model.rowCount() > 0);
    QVERIFY(model.index(0).data(DiagnosticModel::PlaceRole).toString().startsWith("line 3"));
    QVERIFY(window->statusLine().text().contains("cut.geargraph"));
    QVERIFY(window->problems().isVisible());

    const QByteArray wrong = R"({"format": "geargraph", "version": 1, "links": [{"id": "0"}, {"id": "0"}],
      "axes": [], "turningJoints": [{"id": "8", "tail": "0", "head": "9", "axis": "z"}], "gearMeshes": []})";
    QVERIFY(!window->openDocument(written("wrong.geargraph", wrong)));
    QVERIFY(model.rowCount() > 1);  // all problems of a file together
    QCOMPARE(now().get(), before.get());

    QVERIFY(!window->openDocument(folder.filePath(QStringLiteral("missing.geargraph"))));
    QCOMPARE(now().get(), before.get());
    QVERIFY(window->openDocument(robotExamplePath()));
    QTRY_VERIFY(window->isSettled());
    QCOMPARE(window->windowTitle(), QStringLiteral("robot.geargraph[*] — GearGraph"));
  }

  void arbitraryBytesAreRejected() {
    const MechanismPtr before = now();
    QByteArray bytes;
    for (int i = 0; i < 4096; ++i) bytes += static_cast<char>((i * 2'654'435'761U) >> 24U);
    QVERIFY(!window->openDocument(written("noise.geargraph", bytes)));
    QVERIFY(!window->openDocument(written("empty.geargraph", {})));
    QVERIFY(!window->openDocument(folder.path()));
    QCOMPARE(now().get(), before.get());
  }

  void aRejectedEditSaysWhyAndChangesNothing() {
    const MechanismPtr before = now();
    test::Hand hand(*window);
    hand.key(Qt::Key_T);
    hand.drag(3, 6);  // closes a loop of turning joints
    QCOMPARE(now().get(), before.get());
    QCOMPARE(window->document().undoStack().count(), 0);
    QVERIFY2(window->statusLine().text().contains("loop"), qPrintable(window->statusLine().text()));
    const QString rejection = window->statusLine().text();
    addLink();
    QVERIFY(window->statusLine().text() != rejection);
  }

  void everyDisabledActionSaysWhy() {
    window->document().replace(emptyMechanism(), {});
    for (const QAction* action : window->findChildren<QAction*>()) {
      if (action->isEnabled() || action->objectName().isEmpty()) continue;
      QVERIFY2(action->toolTip().endsWith(QLatin1Char('.')), qPrintable(action->objectName()));
    }
    QVERIFY(!window->actions()[CommandId::undo]->isEnabled());
    QCOMPARE(window->actions()[CommandId::undo]->toolTip(), QStringLiteral("There is nothing to undo."));
  }

  void chipsCountAndAreHighlighted() {
    auto* links = window->findChild<QToolButton*>(QStringLiteral("chip.n"));
    auto* meshes = window->findChild<QToolButton*>(QStringLiteral("chip.c"));
    QCOMPARE(links->text(), QStringLiteral("n 7"));
    QCOMPARE(meshes->text(), QStringLiteral("c 4"));
    QTest::mouseMove(meshes);
    QTRY_COMPARE(window->selection().hovered().size(), std::size_t{4});
    QTest::mouseMove(links);
    QTRY_COMPARE(window->selection().hovered().size(), std::size_t{7});
    QVERIFY(links->toolTip().contains("Moving links"));
  }

  void unsavedChangesAreAskedAbout() {
    addLink();
    QVERIFY(window->isWindowModified());
    answerWith(QMessageBox::Cancel);
    QVERIFY(!window->close());
    QVERIFY(window->isVisible());
    answerWith(QMessageBox::Discard);
    QVERIFY(window->close());
  }

  void layoutIsRemembered() {
    auto* dock = window->findChild<QDockWidget*>(QStringLiteral("dock.problems"));
    dock->hide();
    QVERIFY(window->close());
    MainWindow next;
    next.restoreLayout();
    next.show();
    QVERIFY(QTest::qWaitForWindowExposed(&next));
    QVERIFY(!next.findChild<QDockWidget*>(QStringLiteral("dock.problems"))->isVisible());
    next.actions()[CommandId::resetLayout]->trigger();
    QVERIFY(!next.findChild<QDockWidget*>(QStringLiteral("dock.problems"))->isHidden());
    next.close();
  }

  void theWindowFitsASmallScreen() {
    QCOMPARE(window->size(), QSize(1366, 768));  // docks side by side have made it wider at the first show
    window->actions()[CommandId::resetLayout]->trigger();
    QVERIFY(QTest::qWaitForWindowExposed(window.get()));
    QCoreApplication::sendPostedEvents();
    QCOMPARE(window->size(), QSize(1366, 768));
    QVERIFY(window->minimumSizeHint().width() <= 1366 && window->minimumSizeHint().height() <= 700);
  }

  void whatADocumentNeedsFirstComesToTheFront() {
    const auto isInFront = [this](const char* dock) {
      return isInSight(*window->findChild<QDockWidget*>(QLatin1String(dock))->widget());
    };
    const auto open = [this](const QString& name) {
      for (const QString& path : examplePaths()) {
        if (!path.contains(name)) continue;
        QVERIFY(window->openDocument(path));
        QTRY_VERIFY(window->isSettled());
      }
    };
    QVERIFY(isInFront("dock.inputs") && isInFront("dock.matrices"));
    open(QStringLiteral("simpson"));
    QTRY_VERIFY(isInFront("dock.gearbox"));
    open(QStringLiteral("robot-to-mend"));
    QTRY_VERIFY(isInFront("dock.inputs") && isInFront("dock.problems"));  // no empty panel of gears
    open(QStringLiteral("redundant-planetary"));                          // remarks that harm nothing
    QTRY_VERIFY(isInFront("dock.matrices"));
    open(QStringLiteral("locked-train"));
    QTRY_VERIFY(isInFront("dock.problems"));
    open(QStringLiteral("reverted-train"));
    QTRY_VERIFY(isInFront("dock.matrices"));
    QVERIFY(isInFront("dock.inputs"));
  }

  void aGearboxOpensWithItsStates() {
    for (const QString& path : examplePaths()) {
      if (path.contains(QStringLiteral("ravigneaux"))) window = test::openedWindow(path);
    }
    auto* states = window->findChild<QDockWidget*>(QStringLiteral("dock.gearbox"));
    QVERIFY(isInSight(*states->widget()));
  }

  void everyDockHasANameToBeRememberedBy() {
    const auto docks = window->findChildren<QDockWidget*>();
    QVERIFY(docks.size() >= 5);
    for (const QDockWidget* dock : docks) QVERIFY(dock->objectName().startsWith("dock."));
  }

  void themesSwitchInARunningWindow() {
    window->actions()[CommandId::dark]->trigger();
    QCOMPARE(themeOf(QApplication::palette()), Theme::dark);
    QCOMPARE(window->digraph().theme(), Theme::dark);
    window->actions()[CommandId::light]->trigger();
    QCOMPARE(themeOf(QApplication::palette()), Theme::light);
  }

  void examplesOpen() {
    for (const QString& path : examplePaths()) {
      QVERIFY2(window->openDocument(path), qPrintable(path));
      QTRY_VERIFY(window->isSettled());
      QVERIFY(window->document().filePath().isEmpty());  // Save asks for a name
    }
  }

  /// What is wider than the status bar ends in an ellipsis, and is whole in the tool tip.
  void longStatusTextsEndInAnEllipsis() {
    auto* message = dynamic_cast<StatusMessage*>(
        window->statusLine().findChild<QLabel*>(QStringLiteral("statusMessage")));
    QVERIFY(message != nullptr);
    const QString sentence = QStringLiteral("word ").repeated(400);
    window->statusLine().showNote(sentence);
    QVERIFY(message->shown().endsWith(QChar(0x2026)));
    QVERIFY(message->fontMetrics().horizontalAdvance(message->shown()) <= message->contentsRect().width());
    QCOMPARE(window->statusLine().text(), sentence);
    QHelpEvent help(QEvent::ToolTip, message->rect().center(),
                    message->mapToGlobal(message->rect().center()));
    QApplication::sendEvent(message, &help);
    QCOMPARE(message->toolTip(), sentence);
    window->statusLine().showNote(QStringLiteral("short"));
    QCOMPARE(message->shown(), QStringLiteral("short"));
    QApplication::sendEvent(message, &help);
    QVERIFY(message->toolTip().isEmpty());
  }

  void whatCannotBeWrittenIsSaid() {
    const QString nowhere = folder.filePath(QStringLiteral("no/such/folder/a.geargraph"));
    addLink();
    QVERIFY(!window->saveDocument(nowhere));
    QVERIFY(window->isWindowModified());
    QVERIFY(!window->statusLine().text().isEmpty());
    QSignalSpy rejected(&window->exports(), &WindowExports::rejected);
    window->exports().exportCsv(exactTable(resultOf(MatrixKind::incidence), {window->analysis().snapshot()}),
                                nowhere);
    QVERIFY(rejected.wait());
    QVERIFY(!QFileInfo::exists(nowhere));
  }
};

}  // namespace geargraph

QTEST_MAIN(geargraph::MainWindowTest)
#include "test_main_window.moc"

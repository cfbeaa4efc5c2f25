#include <QComboBox>
#include <QDialog>
#include <QDockWidget>
#include <QLabel>
#include <QPushButton>
#include <QStandardPaths>
#include <QTemporaryDir>
#include <QTest>
#include <QToolButton>

#include "tests/ui/mainwindow/person.h"
#include "tests/ui/mainwindow/readings.h"
#include "ui/mainwindow/start_page.h"
#include "ui/mainwindow/window_set.h"
#include "ui/panels/gearbox_panel.h"
#include "ui/panels/matrices_panel.h"
#include "ui/panels/problems_panel.h"
#include "ui/panels/results_panel.h"
#include "ui/theme/application_theme.h"

namespace geargraph {

using test::Person;

/// Stories from an empty window: what somebody does with mouse and keyboard, with the gestures counted.
class StoriesTest : public QObject {
  Q_OBJECT

  std::unique_ptr<QTemporaryDir> folder;
  std::unique_ptr<WindowSet> windows;
  MainWindow* window = nullptr;

  [[nodiscard]] const MechanismPtr& now() const { return window->document().mechanism(); }
  void insertSet() {
    window->actions()[CommandId::insertSet]->trigger();
    auto* dialog = window->findChild<QDialog*>(QStringLiteral("insertSet"));
    QVERIFY(QTest::qWaitForWindowExposed(dialog));
    QTest::mouseClick(dialog->findChild<QPushButton*>(QStringLiteral("insert")), Qt::LeftButton);
  }

  [[nodiscard]] QString rateOfLink(int label) const { return test::rateOfLink(*window, label); }
  [[nodiscard]] QStringList formulas(int row) const { return test::formulas(*window, row); }
  [[nodiscard]] QString chip(const char* name) const { return test::chip(*window, name); }

 private slots:
  void initTestCase() {
    test::isolateSettings();
    QStandardPaths::setTestModeEnabled(true);
    applyTheme(*qApp, Theme::light);
  }
  void init() {
    folder = std::make_unique<QTemporaryDir>();
    windows = std::make_unique<WindowSet>(folder->path());
    windows->start({});
    window = windows->windows().front();
    window->resize(1366, 768);
    window->activateWindow();
    QVERIFY(QTest::qWaitForWindowActive(window));
  }
  void cleanup() { windows.reset(); }

  void aBeginnerDrawsAPlanetarySetAndReadsItsRatio() {
    Person person(*window);
    person.clickButton(window->startPage().findChild<QPushButton*>(QStringLiteral("startNew")));
    person.key(Qt::Key_L);
    person.click(0.25, 0.2);  // 1, the sun
    person.click(0.75, 0.8);  // 2, the carrier
    person.click(0.8, 0.2);   // 3, the planet
    person.key(Qt::Key_T);
    person.drag(0, 1);
    person.drag(0, 2);
    person.drag(2, 3);
    person.key(Qt::Key_G);
    person.drag(1, 3);  // sun and planet
    person.drag(3, 0);  // planet and ring, which stands still
    person.key(Qt::Key_I);
    person.clickLink(1);
    QTRY_VERIFY(window->isSettled());

    QCOMPARE(rateOfLink(2), QStringLiteral("1/4"));  // 20/(20 + 60)
    QCOMPARE(chip("chip.dof"), QStringLiteral("DOF 1"));
    QCOMPARE(window->problems().model().rowCount(), 0);
    QVERIFY(window->results().isVisible());
    qInfo("A planetary set and its ratio: %d gestures", person.gestures);
    QVERIFY(person.gestures < 20);
  }

  void anExpertDrawsThePapersRobot() {
    Person person(*window);
    person.clickButton(window->startPage().findChild<QPushButton*>(QStringLiteral("startNew")));
    for (int i = 0; i < 3; ++i) person.key(Qt::Key_Minus, Qt::ControlModifier);
    person.key(Qt::Key_L);
    const double places[7][2] = {{0.36, 0.8},  {0.62, 0.3}, {0.88, 0.15}, {0.14, 0.2},
                                 {0.36, 0.12}, {0.62, 0.9}, {0.88, 0.85}};
    for (const auto& place : places) person.click(place[0], place[1]);
    person.key(Qt::Key_T);
    const int joints[7][2] = {{0, 4}, {0, 5}, {0, 1}, {1, 6}, {1, 2}, {2, 7}, {2, 3}};
    for (const auto& joint : joints) person.drag(joint[0], joint[1]);
    person.key(Qt::Key_G);
    const int meshes[4][2] = {{4, 1}, {5, 2}, {6, 7}, {7, 3}};
    for (const auto& mesh : meshes) person.drag(mesh[0], mesh[1]);
    person.key(Qt::Key_V);
    person.clickMesh(1);
    person.clickMesh(2, Qt::ShiftModifier);
    person.clickMesh(3, Qt::ShiftModifier);
    QVERIFY(person.raise(QStringLiteral("Properties")));
    auto* kind = window->findChild<QComboBox*>(QStringLiteral("meshKind"));
    QVERIFY(kind != nullptr);
    ++person.gestures;
    QTest::keyClick(kind, Qt::Key_B);  // bevel
    person.key(Qt::Key_I);
    for (const int link : {4, 5, 6}) person.clickLink(link);
    QTRY_VERIFY(window->isSettled());

    // [AU, Eqs. (2), (5), (25)]
    QCOMPARE(test::shownRows(*window, MatrixKind::reducedIncidence),
             (QStringList{"0 0 1 -1 -1 0 0 1 0 0 0", "0 0 0 0 1 -1 -1 0 1 0 0", "0 0 0 0 0 0 1 0 0 0 1",
                          "1 0 0 0 0 0 0 -1 0 0 0", "0 1 0 0 0 0 0 0 -1 0 0", "0 0 0 1 0 0 0 0 0 -1 0",
                          "0 0 0 0 0 1 0 0 0 1 -1"}));
    QCOMPARE(test::shownRows(*window, MatrixKind::cycleBasis),
             (QStringList{"1 0 -1 0 0 0 0 1 0 0 0", "0 1 -1 0 -1 0 0 0 1 0 0", "0 0 0 1 -1 -1 0 0 0 1 0",
                          "0 0 0 0 0 1 -1 0 0 0 1"}));
    QCOMPARE(window->problems().model().rowCount(), 0);
    QCOMPARE(chip("chip.dof"), QStringLiteral("DOF 3"));
    // A digraph does not say on which side of an apex bevel wheels sit. Those of meshes 16 and 17 are placed
    // on the other side than in Fig. 3, so i16 and i17 bear the other sign than in (25).
    QCOMPARE(formulas(0), (QStringList{"-i15", "0", "0"}));
    QCOMPARE(formulas(1), (QStringList{"i16*i15", "i16", "0"}));
    QCOMPARE(formulas(2), (QStringList{"-i17*i16*i15", "-i17*i16", "i17"}));
    QCOMPARE(formulas(3), (QStringList{"-i18*i17*i16*i15", "-i18*i17*i16", "i18*i17"}));
    qInfo("The paper's robot: %d gestures", person.gestures);
    QVERIFY(person.gestures < 40);
  }

  void theRobotDrawnWrongIsRepairedInTheProblemsPanel() {
    Person person(*window);
    QVERIFY(window->openDocument(QStringLiteral(":/examples/robot-to-mend.geargraph")));
    QTRY_VERIFY(window->isSettled());
    QVERIFY(person.raise(QStringLiteral("Problems")));
    ProblemsPanel& problems = window->problems();
    QTRY_VERIFY(problems.isVisible());
    const auto codes = [&problems] {
      QStringList all;
      for (int row = 0; row < problems.model().rowCount(); ++row)
        all << problems.model().index(row).data(DiagnosticModel::CodeRole).toString();
      return all;
    };
    // One mistake hides the next: each click brings up what is still wrong.
    for (const QString& wrong : {QStringLiteral("turning-loop"), QStringLiteral("teeth-geometry"),
                                 QStringLiteral("invalid-inputs")}) {
      QVERIFY2(codes().contains(wrong), qPrintable(codes().join(' ')));
      QPushButton* fix = nullptr;
      for (auto* button : problems.findChildren<QPushButton*>(QStringLiteral("fix"))) {
        if (button->isVisible() && fix == nullptr) fix = button;
      }
      QVERIFY(fix != nullptr);
      person.clickButton(fix);
      QTRY_VERIFY(window->isSettled());
      QVERIFY2(!codes().contains(wrong), qPrintable(codes().join(' ')));
    }
    QVERIFY2(codes().isEmpty(), qPrintable(codes().join(' ')));
    QCOMPARE(window->document().undoStack().count(), 3);
    QCOMPARE(chip("chip.dof"), QStringLiteral("DOF 3"));
    QCOMPARE(formulas(0), (QStringList{"-i15", "0", "0"}));  // [AU, Eq. (25)]
    QVERIFY(person.gestures == 4);
  }

  void aPlanetarySetFromTheDialogTakesThreeGestures() {
    window->actions()[CommandId::newDocument]->trigger();  // 1
    insertSet();                                           // 2 and 3
    QCOMPARE(now()->n(), 6);
    QTRY_VERIFY(window->isSettled());
    QCOMPARE(window->results().verdict(),
             QStringLiteral("Matroid method = T–T graph method, exactly, for all 5 joints"));
    // Its brake holds the ring. The carrier turns at 2/7 of the sun: the ratio 7/2 that the dialog proposes.
    QCOMPARE(window->results().model().index(0, 2).data().toString(), QStringLiteral("0"));
    QCOMPARE(window->results().model().index(1, 2).data().toString(), QStringLiteral("2/7"));
    window->document().undoStack().undo();
    QCOMPARE(now()->n(), 0);
  }

  void aPlanetGetsCompanionsWithTwoGestures() {
    window->document().replace(emptyMechanism(), {});
    insertSet();
    const std::vector<ElementId> planets{now()->links[5].id, now()->links[6].id};
    for (const ElementId& planet : planets) {
      window->selection().select({planet});
      window->actions()[CommandId::remove]->trigger();
    }
    QCOMPARE(now()->n(), 4);
    window->selection().select({now()->links[4].id});
    window->actions().planets[1]->trigger();
    QCOMPARE(now()->n(), 6);
    QCOMPARE(now()->c(), 6);
    QTRY_VERIFY(window->isSettled());
  }

  void aGearboxRunsInTheStateThatIsChosen() {
    QVERIFY(window->openDocument(QStringLiteral(":/examples/eight-speed-gearbox.geargraph")));
    QTRY_VERIFY(window->isSettled());
    StatesModel& states = window->gearbox().model();
    QCOMPARE(states.rowCount(), 9);
    window->gearbox().engage(4);
    QTRY_VERIFY(window->isSettled());
    QVERIFY(states.isRunning(4));
    QVERIFY(!states.isRunning(0));
    QCOMPARE(now()->inputs->size(), std::size_t(1));  // nothing that is held is a motor
    const auto chip = [&](const char* name) {
      return window->findChild<QToolButton*>(QLatin1String(name))->text();
    };
    QCOMPARE(chip("chip.rank"), QStringLiteral("rank 8 + 3"));
    QCOMPARE(chip("chip.dof"), QStringLiteral("DOF 1 (engaged: B, C, D)"));
    const auto* engaged = window->findChild<QLabel*>(QStringLiteral("engaged"));
    QVERIFY(engaged->text().startsWith(QStringLiteral("Engaged: state 5, with B (link 3 held)")));
    QTest::keyClick(window, Qt::Key_B, Qt::ControlModifier);
    QTRY_VERIFY(window->isSettled());
    QVERIFY(now()->engaged.empty());
    QVERIFY(!states.isRunning(4));
    QCOMPARE(chip("chip.dof"), QStringLiteral("DOF 4"));
    window->actions()[CommandId::undo]->trigger();
    QTRY_VERIFY(window->isSettled());
    QVERIFY(states.isRunning(4));
  }
};

}  // namespace geargraph

QTEST_MAIN(geargraph::StoriesTest)
#include "test_stories.moc"

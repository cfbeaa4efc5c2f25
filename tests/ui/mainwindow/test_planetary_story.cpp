#include <QDialog>
#include <QLabel>
#include <QPushButton>
#include <QTest>

#include "tests/ui/mainwindow/hand.h"
#include "ui/mainwindow/document_files.h"
#include "ui/panels/gearbox_panel.h"
#include "ui/panels/results_panel.h"
#include "ui/theme/application_theme.h"

namespace geargraph {

/// A planetary train with three planets, from an empty document to its ratio; and a gearbox in its gears.
class PlanetaryStoryTest : public QObject {
  Q_OBJECT

  std::unique_ptr<MainWindow> window;

  [[nodiscard]] const MechanismPtr& now() const { return window->document().mechanism(); }
  void insertSet() {
    window->actions().insertSet->trigger();
    auto* dialog = window->findChild<QDialog*>(QStringLiteral("insertSet"));
    QVERIFY(QTest::qWaitForWindowExposed(dialog));
    QTest::mouseClick(dialog->findChild<QPushButton*>(QStringLiteral("insert")), Qt::LeftButton);
  }

 private slots:
  void initTestCase() {
    test::isolateSettings();
    applyTheme(*qApp, Theme::light);
    window = std::make_unique<MainWindow>();
    window->resize(1366, 768);
    window->show();
    QVERIFY(QTest::qWaitForWindowExposed(window.get()));
  }
  void cleanupTestCase() { window.reset(); }

  void threeGesturesMakeAPlanetaryTrain() {
    window->actions().newDocument->trigger();  // 1
    insertSet();                               // 2 and 3
    QCOMPARE(now()->n(), 6);
    QTRY_VERIFY(window->isSettled());
    QCOMPARE(window->results().verdict(),
             QStringLiteral("Matroid method = T–T graph method, exactly, for all 4 joints"));
    // The carrier turns at 2/7 of the sun: the ratio 7/2 that the dialog proposes.
    QCOMPARE(window->results().model().index(0, 3).data().toString(), QStringLiteral("2/7"));
    window->document().undoStack().undo();
    QCOMPARE(now()->n(), 0);
  }

  void aPlanetGetsCompanionsWithTwoGestures() {
    window->document().replace(emptyMechanism(), {});
    insertSet();
    const std::vector<ElementId> twins{now()->links[5].id, now()->links[6].id};
    for (const ElementId& twin : twins) {
      window->selection().select({twin});
      window->actions().remove->trigger();
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
    window->gearbox().run(4);
    QTRY_VERIFY(window->isSettled());
    QVERIFY(states.isRunning(4));
    QVERIFY(!states.isRunning(0));
  }
};

}  // namespace geargraph

QTEST_MAIN(geargraph::PlanetaryStoryTest)
#include "test_planetary_story.moc"

#include <QPushButton>
#include <QStandardPaths>
#include <QTabBar>
#include <QTemporaryDir>
#include <QTest>
#include <QToolButton>

#include "core/mechanism/geometry_edits/wheel_map.h"
#include "tests/ui/mainwindow/person.h"
#include "ui/mainwindow/start_page.h"
#include "ui/mainwindow/status_line.h"
#include "ui/mainwindow/window_set.h"
#include "ui/panels/problems_panel.h"
#include "ui/panels/results_panel.h"
#include "ui/theme/in_sight.h"

namespace geargraph {

using test::Person;

/// What the window makes of a drawing while it grows: guesses that give way, and no errors for what the next
/// stroke repairs.
class DrawingByHandTest : public QObject {
  Q_OBJECT

  std::unique_ptr<QTemporaryDir> folder;
  std::unique_ptr<WindowSet> windows;
  std::unique_ptr<Person> person;
  MainWindow* window = nullptr;

  using Strokes = std::vector<std::pair<int, int>>;

  [[nodiscard]] const MechanismPtr& now() const { return window->document().mechanism(); }
  [[nodiscard]] QString axes() const {
    QString letters;
    for (const TurningJoint& joint : now()->turningJoints)
      letters += QString::fromStdString(joint.axis.text());
    return letters;
  }
  [[nodiscard]] std::vector<MeshKind> kinds() const {
    std::vector<MeshKind> all;
    for (const auto& mesh : window->document().placed().placement().meshes) {
      if (mesh) all.push_back(mesh->kind);
    }
    return all;
  }
  [[nodiscard]] bool hasTab(const QString& title) const {
    for (const auto* bar : window->findChildren<QTabBar*>()) {
      for (int i = 0; i < bar->count(); ++i) {
        if (bar->tabText(i) == title) return true;
      }
    }
    return false;
  }
  void drawLinks(const std::vector<std::pair<double, double>>& places) {
    person->key(Qt::Key_L);
    for (const auto& [across, down] : places) person->click(across, down);
    QCOMPARE(now()->links.size(), places.size() + 1);
  }
  void draw(Qt::Key tool, const Strokes& arrows) {
    person->key(tool);
    for (const auto& [tail, head] : arrows) person->drag(tail, head);
  }

 private slots:
  void initTestCase() {
    test::setUpProgram();
    QStandardPaths::setTestModeEnabled(true);
  }
  void init() {
    folder = std::make_unique<QTemporaryDir>();
    windows = std::make_unique<WindowSet>(folder->path());
    windows->start({});
    window = windows->windows().front();
    window->resize(1366, 768);
    window->activateWindow();
    QVERIFY(QTest::qWaitForWindowActive(window));
    person = std::make_unique<Person>(*window);
    person->clickButton(window->startPage().findChild<QPushButton*>(QStringLiteral("startNew")));
  }
  void cleanup() { windows.reset(); }

  /// 1 the case, 2 and 3 its wheels, 4 and 5 the pinions. At first the program takes them for spur gears and
  /// rings; one axis laid square makes them all bevels.
  void aBevelDifferentialComesOutRight() {
    drawLinks({{0.66, 0.5}, {0.2, 0.2}, {0.2, 0.85}, {0.88, 0.15}, {0.88, 0.85}});
    draw(Qt::Key_T, {{0, 1}, {0, 2}, {0, 3}, {1, 4}, {1, 5}});
    draw(Qt::Key_G, {{2, 4}, {4, 3}, {2, 5}, {5, 3}});
    QCOMPARE(axes(), QStringLiteral("aaabc"));
    QCOMPARE(kinds(),
             (std::vector{MeshKind::external, MeshKind::internal, MeshKind::external, MeshKind::internal}));
    QVERIFY(person->chooseForJoint(3, QStringLiteral("Lay axis b>Square to>Axis a")));
    QCOMPARE(kinds(), std::vector(4, MeshKind::bevel));
    const PlacedMechanism& placed = window->document().placed();
    const WheelMap wheels(placed.mechanism(), placed.placement());
    QCOMPARE(wheels.count(), 4);
    QCOMPARE(wheels.wheelOf(1), wheels.wheelOf(2));  // a pinion's one gear meshes both wheels
    QCOMPARE(wheels.wheelOf(5), wheels.wheelOf(6));
    for (const GearMesh& mesh : now()->gearMeshes) QCOMPARE(mesh.tailTeeth, mesh.headTeeth);

    person->key(Qt::Key_V);
    person->clickLink(2);
    person->key(Qt::Key_B);
    person->key(Qt::Key_I);
    person->clickLink(1);
    QTRY_VERIFY(window->isSettled());
    // The second pinion shares the load of the first: a harmless warning, and all that there is to say.
    const DiagnosticModel& problems = window->problems().model();
    QCOMPARE(problems.rowCount(), 1);
    QCOMPARE(problems.index(0).data(DiagnosticModel::CodeRole).toString(), QStringLiteral("redundant-mesh"));
    QCOMPARE(window->findChild<QToolButton*>(QStringLiteral("chip.dof"))->text(),
             QStringLiteral("DOF 1 (engaged: A)"));
    // One wheel is held: the other one turns twice as fast as the case.
    const ResultsModel& results = window->results().model();
    bool isFound = false;
    for (int row = 0; row < results.rowCount(); ++row) {
      if (results.index(row, 0).data(ResultsModel::LinkLabelRole).toInt() != 3) continue;
      isFound = true;
      QCOMPARE(results.index(row, results.columnCount() - 1).data().toString(), QStringLiteral("2"));
    }
    QVERIFY(isFound);
  }

  void linksWithoutJointsAreNotWrong() {
    drawLinks({{0.25, 0.2}, {0.75, 0.8}});
    QTRY_VERIFY(window->isSettled());
    QVERIFY(hasTab(QStringLiteral("Problems 0")));
    const DiagnosticModel& model = window->problems().model();
    QCOMPARE(model.rowCount(), 1);
    QVERIFY(model.index(0).data(DiagnosticModel::UnfinishedRole).toBool());
    QVERIFY(model.index(0).data(DiagnosticModel::SeverityRole).toInt() != static_cast<int>(Severity::error));
    QVERIFY(!isInSight(window->problems()));
  }

  void aRejectedJointBearsNoLabelOfSomethingElse() {
    drawLinks({{0.25, 0.2}, {0.75, 0.2}, {0.75, 0.8}});
    draw(Qt::Key_T, {{0, 1}, {0, 2}, {2, 3}});
    draw(Qt::Key_G, {{1, 3}});  // bears label 7, which the next joint would have
    const MechanismPtr before = now();
    draw(Qt::Key_T, {{3, 1}});
    QCOMPARE(now(), before);
    const QString why = window->statusLine().text();
    QVERIFY2(why.startsWith(QStringLiteral("A turning joint from link 3 to link 1 would close a loop with "
                                           "joints 4, 5 and 6.")),
             qPrintable(why));
  }

  void lettersOfAxesRunOnAfterADeletion() {
    drawLinks({{0.25, 0.2}, {0.75, 0.8}, {0.75, 0.2}});
    draw(Qt::Key_T, {{0, 1}, {0, 2}, {0, 3}});
    QCOMPARE(axes(), QStringLiteral("abc"));
    person->key(Qt::Key_V);
    person->clickLink(2);
    person->key(Qt::Key_Delete);
    QCOMPARE(axes(), QStringLiteral("ab"));
    person->key(Qt::Key_Z, Qt::ControlModifier);
    QCOMPARE(axes(), QStringLiteral("abc"));
  }
};

}  // namespace geargraph

QTEST_MAIN(geargraph::DrawingByHandTest)
#include "test_drawing_by_hand.moc"

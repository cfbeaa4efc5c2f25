#include <QPushButton>
#include <QStandardPaths>
#include <QTemporaryDir>
#include <QTest>
#include <QToolButton>

#include "core/theory/matroid/coefficient_matrix.h"
#include "tests/ui/mainwindow/person.h"
#include "tests/ui/mainwindow/readings.h"
#include "ui/mainwindow/start_page.h"
#include "ui/mainwindow/window_set.h"
#include "ui/panels/gearbox_panel.h"
#include "ui/panels/problems_panel.h"
#include "ui/panels/results_panel.h"
#include "ui/panels/states_table.h"
#include "ui/theme/in_sight.h"
#include "ui/view3d/view3d.h"

namespace geargraph {

using test::Person;

/// First strokes from the start page with mouse and keys: every gesture counts, and what they make is checked
/// exactly. Each mechanism is also drawn in the wrong order, uncounted.
class FirstStrokesTest : public QObject {
  Q_OBJECT

  std::unique_ptr<QTemporaryDir> folder;
  std::unique_ptr<WindowSet> windows;
  MainWindow* window = nullptr;

  using Strokes = std::vector<std::pair<int, int>>;
  using Places = std::vector<std::pair<double, double>>;

  [[nodiscard]] const MechanismPtr& now() const { return window->document().mechanism(); }
  [[nodiscard]] SnapshotPtr snapshot() const { return window->analysis().snapshot(); }

  [[nodiscard]] QString rateOfLink(int label) const { return test::rateOfLink(*window, label); }
  [[nodiscard]] QStringList formulas(int row) const { return test::formulas(*window, row); }
  [[nodiscard]] QString chip(const char* name) const { return test::chip(*window, name); }
  [[nodiscard]] QString axes() const {
    QString letters;
    for (const TurningJoint& joint : now()->turningJoints)
      letters += QString::fromStdString(joint.axis.text());
    return letters;
  }
  [[nodiscard]] const Placement& placement() const { return window->document().placed().placement(); }
  /// x, y or z, by the axis' letter; ? for other directions.
  [[nodiscard]] QString directions() const {
    QString all;
    for (const AxisLine& line : placement().axes) {
      QChar along = QLatin1Char('?');
      for (std::size_t i = 0; i < 3; ++i) {
        if (line.direction[i] > 1 - 1e-12) along = QLatin1Char("xyz"[i]);
      }
      all += along;
    }
    return all;
  }
  [[nodiscard]] QStringList problems() const {
    QStringList all;
    const DiagnosticModel& model = window->problems().model();
    for (int row = 0; row < model.rowCount(); ++row) all << model.index(row).data().toString();
    return all;
  }
  /// Is everything that is found only what the next stroke goes on with, and stays the panel behind?
  [[nodiscard]] bool isNothingWrong() const {
    const DiagnosticModel& model = window->problems().model();
    for (int row = 0; row < model.rowCount(); ++row) {
      const QModelIndex index = model.index(row);
      if (!index.data(DiagnosticModel::UnfinishedRole).toBool()) return false;
      if (index.data(DiagnosticModel::SeverityRole).toInt() == static_cast<int>(Severity::error))
        return false;
    }
    return !isInSight(window->problems());
  }
  [[nodiscard]] QStringList kinds() const {
    QStringList all;
    for (const auto& mesh : placement().meshes)
      all << (mesh ? QString::fromUtf8(meshKindName(mesh->kind).data()) : QStringLiteral("none"));
    return all;
  }
  /// Do both methods say the same in fractions of everything?
  [[nodiscard]] bool doMethodsAgree() const {
    const SnapshotPtr shown = snapshot();
    return shown->solved && shown->solved->agreement && shown->solved->agreement->equal &&
           shown->solved->agreement->compared > 0;
  }
  /// A row of P in the ratios, as in [AU, Eq. (24)], its columns by joint.
  [[nodiscard]] QString coefficients(int mesh) const {
    const SnapshotPtr shown = snapshot();
    const LiveKinematics& kinematics = *shown->kinematics;
    const CoefficientMatrix matrix(*shown->mechanism, *kinematics.model, kinematics.placement());
    QStringList row;
    for (int joint = 0; joint < now()->t(); ++joint) row << QStringLiteral("0");
    for (const CoefficientMatrix::Entry& entry : matrix.row(mesh)) {
      const QString size =
          entry.tail ? QStringLiteral("i%1").arg(now()->meshLabel(mesh)) : QStringLiteral("1");
      row[entry.joint] = (entry.sign > 0 ? QLatin1Char('+') : QLatin1Char('-')) + size;
    }
    return row.join(QLatin1Char(' '));
  }
  /// The pitch point of a mesh from the point of an axis.
  [[nodiscard]] Vector3 pitchFrom(int mesh, int axis) const {
    const Vector3& pitch = placement().meshes.at(static_cast<std::size_t>(mesh))->pitchPoint;
    const Vector3& point = placement().axes.at(static_cast<std::size_t>(axis)).point;
    return {pitch[0] - point[0], pitch[1] - point[1], pitch[2] - point[2]};
  }

  void startNew(Person& person) {
    person.clickButton(window->startPage().findChild<QPushButton*>(QStringLiteral("startNew")));
  }
  [[nodiscard]] int links() const { return now()->n(); }
  void drawLinks(Person& person, const Places& places) {
    person.key(Qt::Key_L);
    const int before = links();
    for (const auto& [across, down] : places) person.click(across, down);
    QCOMPARE(links() - before, static_cast<int>(places.size()));
  }
  static void drawJoints(Person& person, const Strokes& joints) {
    person.key(Qt::Key_T);
    for (const auto& [tail, head] : joints) person.drag(tail, head);
  }
  static void drawMeshes(Person& person, const Strokes& meshes) {
    person.key(Qt::Key_G);
    for (const auto& [tail, head] : meshes) person.drag(tail, head);
  }

  // A planetary set: 1 the sun, 2 the carrier, 3 the ring, 4 the planet.
  const Places setPlaces{{0.25, 0.2}, {0.5, 0.85}, {0.85, 0.5}, {0.6, 0.2}};
  const Strokes setJoints{{0, 1}, {0, 2}, {0, 3}, {2, 4}};
  const Strokes setMeshes{{1, 4}, {4, 3}};

  /// The ring is held by a brake, the sun drives: what the carrier makes of it.
  void holdRingAndDriveSun(Person& person) {
    person.key(Qt::Key_V);
    person.clickLink(3);
    person.key(Qt::Key_B);
    person.key(Qt::Key_I);
    person.clickLink(1);
  }
  void verifySetWithRingHeld() {
    QTRY_VERIFY(window->isSettled());
    QCOMPARE(chip("chip.dof"), QStringLiteral("DOF 1 (engaged: A)"));
    QCOMPARE(now()->inputs->size(), std::size_t(1));
    QCOMPARE(rateOfLink(3), QStringLiteral("0"));
    QCOMPARE(rateOfLink(2), QStringLiteral("1/4"));  // 20/(20 + 60)
    QVERIFY(window->results().isVisible());
    QVERIFY2(problems().isEmpty(), qPrintable(problems().join(QLatin1Char('\n'))));
    QVERIFY(doMethodsAgree());
  }

  // The robot as in [AU, Fig. 2].
  const Places robotPlaces{{0.36, 0.8},  {0.62, 0.3}, {0.88, 0.15}, {0.14, 0.2},
                           {0.36, 0.12}, {0.62, 0.9}, {0.88, 0.85}};
  const Strokes robotJoints{{0, 4}, {0, 5}, {0, 1}, {1, 6}, {1, 2}, {2, 7}, {2, 3}};
  const Strokes robotMeshes{{4, 1}, {5, 2}, {6, 7}, {7, 3}};

  /// The axes of [AU, Fig. 1], from those of a train of spur gears: d and e, laid by their meshes with it,
  /// follow axis c; link 7 has one gear, so that mesh 18 becomes a bevel with mesh 17.
  void layAxesOfRobot(Person& person) {
    QVERIFY(person.chooseForJoint(4, QStringLiteral("Lay axis c>Along y")));
    QVERIFY(person.chooseForJoint(5, QStringLiteral("Lay axis d>Along z")));
    QCOMPARE(kinds(), (QStringList{"external", "bevel", "bevel", "bevel"}));
  }
  /// Gear 2 sits at y < 0, gear 6 at y > 0 [AU, Fig. 1].
  void moveGearsOfRobot(Person& person) {
    QVERIFY(person.chooseForMesh(1, QStringLiteral("Move gear 2 to the other side of the apex")));
    QVERIFY(person.chooseForMesh(2, QStringLiteral("Move gear 6 to the other side of the apex")));
  }
  /// The bearing of gear 6 at y = B2 > 0 [AU, Table 1], far enough out that the bodies of links 2, 3 and 7
  /// have room beside it.
  void moveBearingOfRobot(Person& person) {
    person.key(Qt::Key_V);
    person.clickJoint(3);
    QVERIFY(person.raise(QStringLiteral("Properties")));
    QVERIFY(person.typeInto(window->findChild<QWidget*>(QStringLiteral("offset")), QStringLiteral("80")));
    QCOMPARE(now()->turningJoints[3].offset, Number(80));
    QVERIFY(person.raise(QStringLiteral("Inputs and results")));
  }
  void verifyRobot() {
    QTRY_VERIFY(window->isSettled());
    QCOMPARE(axes(), QStringLiteral("abbccde"));      // [AU, Fig. 5]
    QCOMPARE(directions(), QStringLiteral("zzyzy"));  // a b c d e
    QVERIFY2(problems().isEmpty(), qPrintable(problems().join(QLatin1Char('\n'))));
    QCOMPARE(chip("chip.dof"), QStringLiteral("DOF 3"));
    // [AU, Table 1]: the pitch points from the axes b, c, c, e.
    QVERIFY(pitchFrom(0, 1)[1] < 0);
    QVERIFY(pitchFrom(1, 2)[2] < 0);
    QVERIFY(pitchFrom(1, 1)[1] < 0);
    QVERIFY(pitchFrom(2, 2)[2] > 0);
    QVERIFY(pitchFrom(2, 1)[1] > 0);
    QVERIFY(pitchFrom(3, 4)[2] < 0);
    QVERIFY(pitchFrom(3, 1)[1] > 0);
    // P by joint, 8 to 14 [AU, Eqs. (19), (24)].
    QCOMPARE(coefficients(0), QStringLiteral("-i15 0 -1 0 0 0 0"));
    QCOMPARE(coefficients(1), QStringLiteral("0 +i16 -i16 0 +1 0 0"));
    QCOMPARE(coefficients(2), QStringLiteral("0 0 0 +i17 -i17 +1 0"));
    QCOMPARE(coefficients(3), QStringLiteral("0 0 0 0 0 -i18 +1"));
    // Rows 10, 12, 13, 14 of [AU, Eq. (25)].
    QCOMPARE(window->results().model().rowCount(), 4);
    QCOMPARE(formulas(0), (QStringList{"-i15", "0", "0"}));
    QCOMPARE(formulas(1), (QStringList{"-i16*i15", "-i16", "0"}));
    QCOMPARE(formulas(2), (QStringList{"-i17*i16*i15", "-i17*i16", "-i17"}));
    QCOMPARE(formulas(3), (QStringList{"-i18*i17*i16*i15", "-i18*i17*i16", "-i18*i17"}));
    QVERIFY(doMethodsAgree());
  }

  // A gearbox of Simpson's: 1 both suns, 2 the ring of the first set, 3 its carrier and the ring of the
  // second set, 4 and 6 planets, 5 the carrier of the second set.
  const Places boxPlaces{{0.5, 0.35}, {0.15, 0.15}, {0.3, 0.85}, {0.5, 0.12}, {0.85, 0.8}, {0.85, 0.3}};
  const Strokes boxJoints{{0, 1}, {0, 2}, {0, 3}, {0, 5}, {3, 4}, {5, 6}};
  const Strokes boxMeshes{{1, 4}, {4, 2}, {1, 6}, {6, 3}};

  void press(Person& person, const char* button) {
    person.clickButton(window->gearbox().findChild<QToolButton*>(QLatin1String(button)));
  }
  [[nodiscard]] bool clickTable(Person& person, int row, int column) {
    const StatesTable& table = *window->gearbox().findChild<StatesTable*>();
    return person.clickCell(table, window->gearbox().model().index(row, column));
  }
  [[nodiscard]] int columnOf(StatesModel::Tail tail) const {
    return window->gearbox().model().couplingCount() + 1 + static_cast<int>(tail);
  }
  void addCouplings(Person& person) {
    person.clickLink(5);
    press(person, "addBrake");
    person.clickLink(1);
    press(person, "addBrake");
    person.clickLink(1);
    person.clickLink(2, Qt::ShiftModifier);
    press(person, "addClutch");
    QCOMPARE(now()->couplings.size(), std::size_t(3));
  }
  /// Link 2 drives link 3, in all states.
  void chooseLinks(Person& person) {
    QVERIFY(clickTable(person, 0, columnOf(StatesModel::Tail::links)));
    QVERIFY(person.chooseFromMenu(QStringLiteral("Link 2")));
    QVERIFY(person.chooseFromMenu(QStringLiteral("Link 3")));
  }
  /// With k = 60/20 of both sets: the second carrier held 2 + 1/k, the suns held 1 + 1/k, and all as one.
  void verifyShiftTable() {
    QTRY_VERIFY(window->isSettled());
    const StatesModel& model = window->gearbox().model();
    QCOMPARE(model.rowCount(), 3);
    const Rational ratios[] = {Rational(7, 3), Rational(4, 3), Rational(1)};
    const char* const texts[] = {"7/3", "4/3", "1"};
    for (int row = 0; row < 3; ++row) {
      QTRY_VERIFY(model.solutionAt(row) != nullptr);
      const StateSolution& solution = *model.solutionAt(row);
      QVERIFY(solution.diagnostics.empty());
      QCOMPARE(solution.dof, 1);
      QCOMPARE(solution.engaged, std::vector<int>{row});
      QVERIFY(solution.ratio.has_value());
      QCOMPARE(*solution.ratio, ratios[row]);
      QCOMPARE(model.index(row, columnOf(StatesModel::Tail::ratio)).data().toString(),
               QString::fromLatin1(texts[row]));
      QCOMPARE(model.index(row, columnOf(StatesModel::Tail::links)).data().toString(),
               QStringLiteral("2 → 3"));
    }
    QVERIFY2(problems().isEmpty(), qPrintable(problems().join(QLatin1Char('\n'))));
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
  }
  void cleanup() { windows.reset(); }

  void aPlanetarySetMovesAndTellsItsRatioWithTheRingBraked() {
    Person person(*window);
    startNew(person);
    drawLinks(person, setPlaces);
    drawJoints(person, setJoints);
    drawMeshes(person, setMeshes);
    QTRY_VERIFY(window->isSettled());
    QCOMPARE(chip("chip.dof"), QStringLiteral("DOF 2"));
    QCOMPARE(kinds(), (QStringList{"external", "internal"}));
    QVERIFY2(problems().isEmpty(), qPrintable(problems().join(QLatin1Char('\n'))));
    person.key(Qt::Key_Space);
    QVERIFY(window->view3d().playback().isPlaying());
    QTRY_VERIFY(window->view3d().playback().time() > 0);
    QVERIFY(doMethodsAgree());
    qInfo("A planetary set to motion: %d gestures", person.gestures);
    QVERIFY(person.gestures <= 16);

    const int before = person.gestures;
    holdRingAndDriveSun(person);
    verifySetWithRingHeld();
    QVERIFY(window->view3d().playback().isPlaying());
    qInfo("Its ratio with the ring held by a brake: %d more", person.gestures - before);
    QVERIFY(person.gestures - before <= 5);
  }

  void aPlanetarySetDrawnInTheWrongOrderIsTheSame() {
    Person person(*window);
    startNew(person);
    drawLinks(person, setPlaces);
    drawMeshes(person, setMeshes);  // before any joint
    QTRY_VERIFY(window->isSettled());
    QCOMPARE(now()->c(), 2);
    QVERIFY2(isNothingWrong(), qPrintable(problems().join(QLatin1Char('\n'))));
    const MechanismPtr meshed = now();
    drawJoints(person, {{0, 1}, {3, 0}});  // the second one against the arrow
    person.key(Qt::Key_Z, Qt::ControlModifier);
    person.key(Qt::Key_Z, Qt::ControlModifier);
    QCOMPARE(now(), meshed);
    drawJoints(person, setJoints);
    QTRY_VERIFY(window->isSettled());
    QCOMPARE(kinds(), (QStringList{"external", "internal"}));
    QCOMPARE(chip("chip.dof"), QStringLiteral("DOF 2"));
    QCOMPARE(axes(), QStringLiteral("aaab"));
    holdRingAndDriveSun(person);
    verifySetWithRingHeld();
  }

  /// What was drawn before its joints is guessed again with the last joint, but for what has been typed.
  void teethTypedBeforeTheJointsStay() {
    Person person(*window);
    startNew(person);
    drawLinks(person, setPlaces);
    drawMeshes(person, {{1, 4}});
    QVERIFY(person.raise(QStringLiteral("Properties")));
    QVERIFY(person.typeInto(window->findChild<QWidget*>(QStringLiteral("tailTeeth")), QStringLiteral("30")));
    QCOMPARE(now()->gearMeshes[0].tailTeeth, 30);
    drawMeshes(person, {{4, 3}});
    drawJoints(person, {{0, 1}, {0, 2}, {0, 3}});
    const MechanismPtr before = now();
    QCOMPARE(axes(), QStringLiteral("abc"));
    person.drag(2, 4);
    QCOMPARE(axes(), QStringLiteral("aaab"));
    QCOMPARE(kinds(), (QStringList{"external", "internal"}));
    QCOMPARE(now()->gearMeshes[0].tailTeeth, 30);
    QCOMPARE(now()->gearMeshes[1].headTeeth, 30 + 2 * 20);
    person.key(Qt::Key_Z, Qt::ControlModifier);
    QCOMPARE(now(), before);  // one step
  }

  void thePapersRobotHasTheAxesAndSignsOfThePaper() {
    Person person(*window);
    startNew(person);
    drawLinks(person, robotPlaces);
    drawJoints(person, robotJoints);
    drawMeshes(person, robotMeshes);
    layAxesOfRobot(person);
    moveGearsOfRobot(person);
    moveBearingOfRobot(person);
    person.key(Qt::Key_I);
    for (const int link : {4, 5, 6}) person.clickLink(link);
    verifyRobot();
    QVERIFY(window->results().isVisible());
    qInfo("The paper's robot with its axes and signs: %d gestures", person.gestures);
    QVERIFY(person.gestures <= 40);
  }

  void thePapersRobotDrawnInTheWrongOrderIsTheSame() {
    Person person(*window);
    startNew(person);
    drawLinks(person, robotPlaces);
    drawMeshes(person, robotMeshes);  // before any joint
    QTRY_VERIFY(window->isSettled());
    QCOMPARE(now()->c(), 4);
    QVERIFY2(isNothingWrong(), qPrintable(problems().join(QLatin1Char('\n'))));
    drawJoints(person, robotJoints);
    layAxesOfRobot(person);
    const MechanismPtr laid = now();
    for (int i = 0; i < 2; ++i) person.key(Qt::Key_Z, Qt::ControlModifier);
    QVERIFY(kinds() != (QStringList{"external", "bevel", "bevel", "bevel"}));
    for (int i = 0; i < 2; ++i) person.key(Qt::Key_Y, Qt::ControlModifier);
    QCOMPARE(now(), laid);
    QVERIFY(person.chooseForMesh(3, QStringLiteral("Move gear 3 to the other side of the apex")));
    person.key(Qt::Key_Z, Qt::ControlModifier);
    QCOMPARE(now(), laid);
    moveGearsOfRobot(person);
    moveBearingOfRobot(person);
    person.key(Qt::Key_I);
    for (const int link : {4, 5, 6}) person.clickLink(link);  // the columns are in this order
    QCOMPARE(now()->inputs->size(), std::size_t{3});
    verifyRobot();
  }

  void aTwoSetGearboxGetsItsShiftTable() {
    Person person(*window);
    startNew(person);
    for (int i = 0; i < 2; ++i) person.key(Qt::Key_Minus, Qt::ControlModifier);
    drawLinks(person, boxPlaces);
    drawJoints(person, boxJoints);
    drawMeshes(person, boxMeshes);
    QTRY_VERIFY(window->isSettled());
    QCOMPARE(kinds(), (QStringList{"external", "internal", "external", "internal"}));
    QCOMPARE(chip("chip.dof"), QStringLiteral("DOF 2"));

    person.key(Qt::Key_V);
    QVERIFY(person.raise(QStringLiteral("Gearbox")));
    addCouplings(person);
    for (int i = 0; i < 3; ++i) press(person, "addState");
    for (int i = 0; i < 3; ++i) QVERIFY(clickTable(person, i, i + 1));
    chooseLinks(person);
    verifyShiftTable();
    qInfo("A two-set gearbox with its shift table: %d gestures", person.gestures);
    QVERIFY(person.gestures <= 60);

    // It runs in the state that is clicked: the output turns at the inverse of the ratio.
    const char* const rates[] = {"3/7", "3/4", "1"};
    const char* const engaged[] = {"A", "B", "C"};
    for (int row = 0; row < 3; ++row) {
      QVERIFY(clickTable(person, row, 0));
      QTRY_VERIFY(window->isSettled());
      QVERIFY(window->gearbox().model().isRunning(row));
      QCOMPARE(chip("chip.dof"), QStringLiteral("DOF 1 (engaged: %1)").arg(QLatin1String(engaged[row])));
      QCOMPARE(rateOfLink(3), QString::fromLatin1(rates[row]));
    }
  }

  /// A state before its couplings, the wrong dot, and a clutch of one link.
  void aShiftTableBegunInTheWrongOrderIsTheSame() {
    Person person(*window);
    startNew(person);
    for (int i = 0; i < 2; ++i) person.key(Qt::Key_Minus, Qt::ControlModifier);
    drawLinks(person, boxPlaces);
    drawMeshes(person, boxMeshes);
    drawJoints(person, boxJoints);
    QTRY_VERIFY(window->isSettled());
    QCOMPARE(kinds(), (QStringList{"external", "internal", "external", "internal"}));
    person.key(Qt::Key_V);
    QVERIFY(person.raise(QStringLiteral("Gearbox")));
    press(person, "addState");
    chooseLinks(person);
    const auto ratio = [&](int row) {
      return window->gearbox().model().index(row, columnOf(StatesModel::Tail::ratio)).data().toString();
    };
    QTRY_VERIFY(window->isSettled());
    QCOMPARE(ratio(0), QStringLiteral("2 free"));
    addCouplings(person);
    for (int i = 0; i < 2; ++i) press(person, "addState");
    for (int i = 0; i < 3; ++i) QVERIFY(clickTable(person, i, i + 1));
    QVERIFY(clickTable(person, 0, 2));  // the suns held as well: nothing turns
    QTRY_COMPARE(ratio(0), QStringLiteral("locked"));
    QVERIFY(!window->gearbox().remark().isEmpty());
    QVERIFY(clickTable(person, 0, 2));
    QTRY_COMPARE(ratio(0), QStringLiteral("7/3"));
    verifyShiftTable();
  }
};

}  // namespace geargraph

QTEST_MAIN(geargraph::FirstStrokesTest)
#include "test_first_strokes.moc"

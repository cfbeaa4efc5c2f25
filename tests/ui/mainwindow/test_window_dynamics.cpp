#include <QClipboard>
#include <QDockWidget>
#include <QGuiApplication>
#include <QTest>
#include <QToolButton>

#include "core/mechanism/model/edits.h"
#include "core/mechanism/model/mass_edits.h"
#include "tests/core/support/trains.h"
#include "tests/ui/mainwindow/hand.h"
#include "ui/mainwindow/document_files.h"
#include "ui/motion_panel/dynamics_panel.h"
#include "ui/motion_panel/equation_page.h"
#include "ui/motion_panel/inertia_bars.h"
#include "ui/motion_panel/mass_page.h"
#include "ui/motion_panel/motion_page.h"
#include "ui/panels/number_field.h"
#include "ui/theme/in_sight.h"
#include "ui/view3d/motion_plot.h"
#include "ui/view3d/view3d.h"

namespace geargraph {

/// Dynamics of the document in a window.
class WindowDynamicsTest : public QObject {
  Q_OBJECT

  std::unique_ptr<MainWindow> window;

  DynamicsPanel& panel() { return window->dynamics(); }
  template <class Widget>
  Widget& child(const char* name) {
    return *panel().findChild<Widget*>(QLatin1String(name));
  }
  void press(const char* name) { QTest::mouseClick(&child<QToolButton>(name), Qt::LeftButton); }
  void type(NumberField& field, const char* text) {
    field.setFocus();
    field.selectAll();
    QTest::keyClicks(&field, QLatin1String(text));
    QTest::keyClick(&field, Qt::Key_Return);
  }
  void settle() {
    QTRY_VERIFY(window->isSettled());
    QTRY_VERIFY(panel().isUpToDate());
  }
  void open(Mechanism mechanism) {
    window->document().replace(std::move(mechanism), {});
    settle();
  }
  const Mechanism& mechanism() { return *window->document().mechanism(); }
  double mass(int row) {
    return panel().masses().model().index(row, static_cast<int>(MassColumn::mass)).data().toDouble();
  }
  /// Types a mass into the table.
  void typeMass(int row, const char* text) {
    LinkedTable& table = panel().masses().table();
    table.setCurrentIndex(panel().masses().model().index(row, static_cast<int>(MassColumn::mass)));
    table.setFocus();
    QTest::keyClick(&table, Qt::Key_F2);
    auto* field = table.findChild<NumberField*>(QStringLiteral("mass"));
    QVERIFY(field != nullptr);
    type(*field, text);
    QTest::keyClick(&table, Qt::Key_Escape);
    settle();
  }
  /// A rod of 1 kg that hangs on the y axis, its centre 100 mm below: the fields of a pendulum.
  static Mechanism pendulum() {
    test::TrainBuilder train("pendulum");
    train.link(0, train.axis({0, 0, 0}, {0, 1, 0}));
    train.input(0);
    const auto number = [](double value) { return Number::fromDouble(value); };
    LinkMass mass{number(1), NumberTriple{0, 0, -100}};
    mass.inertia = InertiaNumbers{number(0.01), number(0.01), 0, 0, 0, 0};
    Mechanism mechanism = *withLinkMass(train.mechanism(), LinkId("1"), mass);
    return *withGravity(std::move(mechanism), NumberTriple{0, 0, number(-9.81)});
  }

 private slots:
  void initTestCase() { test::setUpProgram(); }
  void init() {
    window = test::openedWindow(robotExamplePath());
    QVERIFY(window != nullptr);
    auto* dock = window->findChild<QDockWidget*>(QStringLiteral("dock.dynamics"));
    dock->show();
    dock->raise();
    QTRY_VERIFY(isInSight(panel()));
    settle();
  }
  void cleanup() { window.reset(); }

  void massesAreThoseOfTheSolidsUntilTheyAreStated() {
    QCOMPARE(panel().emptyText(), QString());
    QCOMPARE(panel().masses().model().rowCount(), mechanism().n());
    const double before = mass(2);
    QVERIFY(before > 0);
    const int steps = window->document().undoStack().count();
    typeMass(2, "2.5");
    QCOMPARE(mechanism().links[3].mass->mass.exact(), Rational(5, 2));
    QCOMPARE(window->document().undoStack().count(), steps + 1);
    QTRY_COMPARE(mass(2), 2.5);
    typeMass(2, "-1");
    QCOMPARE(mechanism().links[3].mass->mass.exact(), Rational(5, 2));
    window->document().undoStack().undo();
    settle();
    QTRY_COMPARE(mass(2), before);
    type(child<NumberField>("density"), "15700");
    settle();
    QTRY_VERIFY(std::abs(mass(2) / before - 2) < 1e-4);
    type(child<NumberField>("gravity.z"), "-9.81");
    QCOMPARE((*mechanism().gravity)[2].value(), -9.81);
    settle();
  }

  void theBarsPartTheInertiaOfEachMotorByLinks() {
    press("chip.inertia");
    settle();
    const auto& bars = panel().inertia().bars();
    QCOMPARE(bars.size(), std::size_t{3});
    const Eigen::MatrixXd& inertia = panel().dynamics()->state.equation.inertia;
    for (std::size_t i = 0; i < bars.size(); ++i) {
      double sum = 0;
      for (std::size_t part = 0; part < bars[i].parts.size(); ++part) {
        sum += bars[i].parts[part].inertia;
        QVERIFY(panel().inertia().tipOf(i, part).contains(QStringLiteral("kg m²")));
      }
      const auto at = static_cast<Eigen::Index>(i);
      QVERIFY(std::abs(sum - inertia(at, at)) < 1e-12);
    }
    const InertiaBars::Part& last = bars[0].parts.back();
    QTest::mouseClick(&panel().inertia(), Qt::LeftButton, {},
                      panel().inertia().placeOf(0, bars[0].parts.size() - 1).center().toPoint());
    QVERIFY(window->selection().isSelected(last.link));
    QTest::keyClick(&panel().inertia(), Qt::Key_Right);
    QVERIFY(window->selection().isSelected(bars[0].parts.front().link));
  }

  void theEquationIsThatOfTheMomentInThe3DView() {
    press("chip.equation");
    settle();
    QVERIFY(panel().equation().tex().find("\\ddot{\\theta}_{8}") != std::string::npos);
    QCOMPARE(panel().equation().model().rowCount(), 3);
    const Eigen::MatrixXd before = panel().dynamics()->state.equation.inertia;
    QVERIFY(window->view3d().stage() != nullptr);
    window->view3d().playback().setTime(0.4);
    settle();
    QVERIFY((panel().dynamics()->state.equation.inertia - before).cwiseAbs().maxCoeff() > 1e-9);
  }

  void torquesMoveTheTrainInPlotsAndIn3D() {
    press("chip.motion");
    settle();
    QVERIFY(!child<QToolButton>("playMotion").isEnabled());
    type(child<NumberField>("torque.8"), "0.0005");
    type(child<NumberField>("startSpeed.9"), "1");
    type(child<NumberField>("seconds"), "0.25");
    press("simulate");
    QTRY_VERIFY(!panel().motion().isRunning() && panel().motion().hasMotion());
    const Simulation& simulation = panel().motion().motion()->simulation;
    QCOMPARE(simulation.end, SimulationEnd::complete);
    QCOMPARE(simulation.samples.back().time, 0.25);
    QCOMPARE(simulation.samples.front().speeds[1], 1.0);
    QCOMPARE(simulation.samples.back().torques[0], 0.0005);
    QVERIFY(panel().remark().contains(QLatin1String("they balance")));
    QCOMPARE(panel().motion().plot().sheet().curves.size(), std::size_t{3});
    window->selection().select({mechanism().turningJoints[5].id});
    QCOMPARE(panel().motion().plot().sheet().curves.size(), std::size_t{4});
    press("plotEnergy");
    QCOMPARE(panel().motion().plot().sheet().unit, std::string("J"));
    const MotionCurve& balance = panel().motion().plot().sheet().curves.back();
    for (const double defect : balance.values)
      QVERIFY(std::abs(defect) < 1e-6 * (1 + simulation.samples.back().work));
    press("plotTorques");
    QCOMPARE(panel().motion().plot().sheet().curves.front().values.front(), 0.0005);

    press("playMotion");
    View3D& view = window->view3d();
    QVERIFY(view.trajectory() != nullptr && view.playback().isPlaying());
    QCOMPARE(view.playback().period(), 0.25);
    view.playback().setPlaying(false);
    view.playback().setTime(0.125);
    const auto angles = inputAngles(*view.stage(), view.view());
    const MotionSample& middle = simulation.samples[500];
    for (std::size_t i = 0; i < angles.size(); ++i)
      QVERIFY(std::abs(angles[i] - middle.angles[static_cast<Eigen::Index>(i)]) < 1e-9);

    press("copyDynamics");
    const QString copied = QGuiApplication::clipboard()->text();
    QVERIFY2(copied.startsWith(QLatin1String("\ttime\tangle 8\tangle 9\tangle 11\tspeed 8")),
             qPrintable(copied.left(60)));
    QCOMPARE(copied.count(QLatin1Char('\n')), 1002);

    // Another mechanism moves otherwise.
    window->document().apply({QStringLiteral("Density"),
                              [](const Mechanism& before) { return withDensity(before, Number(1000)); }, 0});
    settle();
    QVERIFY(!panel().motion().hasMotion());
    QVERIFY(view.trajectory() == nullptr);
    QVERIFY(!child<QToolButton>("playMotion").isEnabled());
  }

  void aLongMotionIsStoppedAndKeptUntilThere() {
    open(pendulum());
    press("chip.motion");
    settle();
    type(child<NumberField>("angle.2"), "90");
    type(child<NumberField>("seconds"), "100000");
    press("simulate");
    QVERIFY(panel().motion().isRunning());
    QCOMPARE(child<QToolButton>("simulate").text(), QStringLiteral("Stop"));
    press("simulate");
    QTRY_VERIFY(!panel().motion().isRunning());
    QVERIFY(panel().remark().contains(QLatin1String("Stopped.")));
    QVERIFY(panel().motion().motion()->simulation.samples.back().time < 100000);
    QCOMPARE(child<QToolButton>("simulate").text(), QStringLiteral("Simulate"));
  }

  void whyThereIsNoneIsSaid() {
    open(emptyMechanism());
    QVERIFY(!panel().emptyText().isEmpty());
    Mechanism massless = *withLinkMass(pendulum(), LinkId("1"), LinkMass{Number(0)});
    open(massless);
    QVERIFY2(panel().remark().contains(QLatin1String("moves no mass")), qPrintable(panel().remark()));
    press("chip.motion");
    settle();
    press("simulate");
    QTRY_VERIFY(!panel().motion().isRunning() && panel().motion().motion());
    QVERIFY(!panel().motion().hasMotion());
    QVERIFY(!child<QToolButton>("exportDynamics").isEnabled());
    Mechanism unknown = pendulum();
    unknown.unit = "furlong";
    open(unknown);
    QVERIFY2(panel().emptyText().contains(QLatin1String("furlong")), qPrintable(panel().emptyText()));
  }
};

}  // namespace geargraph

QTEST_MAIN(geargraph::WindowDynamicsTest)
#include "test_window_dynamics.moc"

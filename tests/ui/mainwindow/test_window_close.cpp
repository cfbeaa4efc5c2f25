#include <QSignalSpy>
#include <QTest>
#include <ctime>

#include "tests/core/support/deep_train.h"
#include "tests/core/support/example_files.h"
#include "tests/ui/mainwindow/hand.h"
#include "ui/theme/application_theme.h"

namespace geargraph {
namespace {

double secondsOn(clockid_t clock) {
  timespec time{};
  clock_gettime(clock, &time);
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

/// Processor time of all threads but this one: it does not matter what else the machine does.
double secondsOfOthers() {
  return secondsOn(CLOCK_PROCESS_CPUTIME_ID) - secondsOn(CLOCK_THREAD_CPUTIME_ID);
}

Mechanism robotOfManyTeeth() {
  Mechanism robot = test::example("robot");
  for (GearMesh& mesh : robot.gearMeshes) {
    mesh.tailTeeth *= 1000;
    mesh.headTeeth *= 1000;
  }
  return robot;
}

Mechanism farOffsets(const char* name) {
  Mechanism mechanism = test::example(name);
  std::int64_t sign = 1;
  for (TurningJoint& joint : mechanism.turningJoints)
    joint.offset = Number((sign = -sign) * 1'000'000'000'000'000);
  return mechanism;
}

}  // namespace

/// The program ends as soon as its window is closed, whatever was being worked on.
class WindowCloseTest : public QObject {
  Q_OBJECT

 private slots:
  void initTestCase() {
    test::isolateSettings();
    applyTheme(*qApp, Theme::light);
  }

  void closingEndsAllWork_data() {
    QTest::addColumn<std::function<Mechanism()>>("document");
    QTest::addRow("1,000 links") << std::function([] { return test::deepTrain(1, 1000); });
    QTest::addRow("300 links") << std::function([] { return test::deepTrain(3, 300); });
    QTest::addRow("180 links") << std::function([] { return test::deepTrain(2, 180); });
    QTest::addRow("many teeth") << std::function(robotOfManyTeeth);
    QTest::addRow("far offsets") << std::function([] { return farOffsets("eight-speed-gearbox"); });
  }
  void closingEndsAllWork() {
    constexpr double kWorkers = 3;  // that are at work at once, a tenth of a second each
    QFETCH(std::function<Mechanism()>, document);
    const Mechanism mechanism = document();
    for (const int after : {0, 40, 400, 2000}) {
      auto window = std::make_unique<MainWindow>();
      window->show();
      QVERIFY(QTest::qWaitForWindowExposed(window.get()));
      window->document().replace(mechanism, {});
      QTest::qWait(after);
      QVERIFY(window->close());
      const double before = secondsOfOthers();
      window.reset();
      const double more = secondsOfOthers() - before;
      QVERIFY2(more < kWorkers * 0.1,
               qPrintable(QStringLiteral("%1 s more after %2 ms").arg(more).arg(after)));
    }
  }
};

}  // namespace geargraph

QTEST_MAIN(geargraph::WindowCloseTest)
#include "test_window_close.moc"

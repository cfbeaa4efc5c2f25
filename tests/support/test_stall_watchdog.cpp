#include <QTest>
#include <QTimer>

#include "tests/support/stall_watchdog.h"

namespace geargraph::test {
namespace {

double cpuTime() {
  timespec time{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
  return static_cast<double>(time.tv_sec) * 1e3 + static_cast<double>(time.tv_nsec) / 1e6;
}

void computeFor(double milliseconds) {
  for (const double end = cpuTime() + milliseconds; cpuTime() < end;) {
  }
}

}  // namespace

class StallWatchdogTest : public QObject {
  Q_OBJECT
 private slots:
  void workOnTheThreadIsAStallOfThatLength() {
    StallWatchdog watchdog;
    QTRY_VERIFY(!watchdog.longestByActivity().empty());
    watchdog.reset();
    watchdog.setActivity(QStringLiteral("computing"));
    QTimer::singleShot(0, this, [] { computeFor(80); });
    QTRY_VERIFY(watchdog.longestCpu() > 60);
    const auto stall = watchdog.longestByActivity()[QStringLiteral("computing")];
    QVERIFY2(stall.cpu < 120, qPrintable(QString::number(stall.cpu)));
    QVERIFY(stall.wall >= stall.cpu - 1);
  }

  void shortEventsAreNoStall() {
    StallWatchdog watchdog;
    int left = 200;
    QTimer timer;
    connect(&timer, &QTimer::timeout, this, [&] {
      computeFor(1);
      --left;
    });
    timer.start(0);
    QTRY_VERIFY(left < 0);
    QVERIFY2(watchdog.longestCpu() < 40, qPrintable(QString::number(watchdog.longestCpu())));
  }
};

}  // namespace geargraph::test

QTEST_GUILESS_MAIN(geargraph::test::StallWatchdogTest)
#include "test_stall_watchdog.moc"

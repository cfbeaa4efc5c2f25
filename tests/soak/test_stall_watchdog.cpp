#include <QTest>
#include <QTimer>
#include <mutex>
#include <semaphore>
#include <thread>

#include "tests/soak/stall_watchdog.h"

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
    QTRY_VERIFY(watchdog.longest() > 60);
    const auto stall = watchdog.longestByActivity()[QStringLiteral("computing")];
    QVERIFY2(stall.cpu < 120, qPrintable(QString::number(stall.cpu)));
    QVERIFY(stall.wall >= stall.cpu - 1);
  }

  void whatIsTakenIsForgotten() {
    StallWatchdog watchdog(QStringLiteral("computing"));
    QTimer::singleShot(0, this, [] { computeFor(80); });
    QTRY_VERIFY(watchdog.longest() > 60);
    const auto taken = watchdog.take();
    QVERIFY(taken.at(QStringLiteral("computing")).length() > 60);
    QVERIFY(watchdog.longest() < 60);
  }

  void waitingForAnIdleLockIsAStallOfThatLength() {
    StallWatchdog watchdog;
    QTRY_VERIFY(!watchdog.longestByActivity().empty());
    watchdog.reset();
    QTimer::singleShot(0, this, [] {
      std::timed_mutex mutex;
      std::binary_semaphore isTaken{0};
      std::binary_semaphore isOver{0};
      const std::jthread other([&] {
        const std::lock_guard lock(mutex);
        isTaken.release();
        isOver.acquire();
      });
      isTaken.acquire();
      static_cast<void>(mutex.try_lock_for(std::chrono::milliseconds(80)));
      isOver.release();
    });
    QTRY_VERIFY(watchdog.longest() > 60);
    const auto stall = watchdog.longestByActivity()[QString()];
    QVERIFY2(stall.waiting > 60, qPrintable(QString::number(stall.waiting)));
    QVERIFY2(stall.cpu < 20, qPrintable(QString::number(stall.cpu)));
  }

  void waitingForAWorkingThreadIsAStall() {
    StallWatchdog watchdog;
    QTRY_VERIFY(!watchdog.longestByActivity().empty());
    watchdog.reset();
    QTimer::singleShot(0, this, [] { std::jthread([] { computeFor(80); }).join(); });
    QTRY_VERIFY(watchdog.longest() > 60);
    QVERIFY(watchdog.longestByActivity()[QString()].cpu < 20);
  }

  void whatTheThreadWasAtIsNamed() {
    StallWatchdog watchdog({}, StallWatchdog::Stacks::sampled);
    QTRY_VERIFY(!watchdog.longestByActivity().empty());
    watchdog.reset();
    QTimer::singleShot(0, this, [] { computeFor(80); });
    QTRY_VERIFY(watchdog.longest() > 60);
    const StallWatchdog::Stall stall = watchdog.longestByActivity()[QString()];
    QString path;
    for (const std::string& each : stall.path) path += QString::fromStdString(each) + u'\n';
    QVERIFY2(path.contains(QStringLiteral("QTestEventLoop")) || path.contains(QStringLiteral("QEventLoop")) ||
                 path.contains(QStringLiteral("computeFor")),
             qPrintable(path));
  }

  void aHangIsToldOnceWhileItGoesOn() {
    StallWatchdog watchdog(QStringLiteral("waiting"));
    std::counting_semaphore<2> told{0};
    QString during;
    watchdog.onHang(std::chrono::milliseconds(30), [&](const QString& activity) {
      during = activity;
      told.release();
    });
    QTRY_VERIFY(!watchdog.longestByActivity().empty());
    bool came = false;
    QTimer::singleShot(0, this, [&] { came = told.try_acquire_for(std::chrono::seconds(20)); });
    QTRY_VERIFY(came);
    QCOMPARE(during, QStringLiteral("waiting"));
    watchdog.reset();
    QTimer::singleShot(0, this, [] { computeFor(80); });
    QTRY_VERIFY(watchdog.longest() > 60);
    QVERIFY(!told.try_acquire());
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
    QVERIFY2(watchdog.longest() < 40, qPrintable(QString::number(watchdog.longest())));
  }
};

}  // namespace geargraph::test

QTEST_GUILESS_MAIN(geargraph::test::StallWatchdogTest)
#include "test_stall_watchdog.moc"

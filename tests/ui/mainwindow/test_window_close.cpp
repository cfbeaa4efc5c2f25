#include <QDir>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>
#include <cmath>
#include <ctime>

#include "tests/core/support/deep_train.h"
#include "tests/core/support/extreme_documents.h"
#include "tests/ui/mainwindow/hand.h"
#include "ui/mainwindow/export_jobs.h"
#include "ui/mainwindow/picture_dialog.h"
#include "ui/mainwindow/window_exports.h"
#include "ui/theme/application_theme.h"
#include "ui/view3d/view3d.h"

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
    QTest::addRow("many teeth") << std::function(test::robotOfManyTeeth);
    QTest::addRow("far offsets") << std::function([] { return test::farOffsets("eight-speed-gearbox"); });
  }
  void closingEndsAllWork() {
    QFETCH(std::function<Mechanism()>, document);
    const Mechanism mechanism = document();
    for (const int after : {0, 40, 400, 2000}) {
      const double more = leastOfThree(kMostSeconds, [&] {
        auto window = shownWindow();
        window->document().replace(mechanism, {});
        QTest::qWait(after);
        return secondsOfClosing(std::move(window));
      });
      QVERIFY2(more < kMostSeconds, qPrintable(QStringLiteral("%1 s more after %2 ms").arg(more).arg(after)));
    }
  }

  void closingEndsAnExport_data() {
    QTest::addColumn<PictureWish>("wish");
    QTest::addColumn<int>("links");
    PictureWish wish;
    wish.view = QStringLiteral("3d");
    wish.solid = SolidForm::glb;
    QTest::addRow("solids") << wish << 180;
    wish.solid = SolidForm::png;
    QTest::addRow("picture") << wish << 1000;
    wish.film = Film{FilmKind::motion, 72, 24, 0};
    QTest::addRow("film") << wish << 1000;
    wish.solid = SolidForm::pictures;
    QTest::addRow("pictures of a film") << wish << 1000;
  }
  /// No part of a file is left, and at once after the wish none is written at all.
  void closingEndsAnExport() {
    QFETCH(PictureWish, wish);
    QFETCH(int, links);
    const Mechanism mechanism = test::deepTrain(links == 180 ? 2 : 1, links);
    for (const int after : {0, 60, 400}) {
      QStringList found;
      const double more = leastOfThree(kMostWithExport, [&] {
        auto window = shownWindow();
        window->document().replace(mechanism, {});
        if (!QTest::qWaitFor([&] { return window->isSettled() && window->view3d().stage(); }, 120'000))
          return HUGE_VAL;
        const QTemporaryDir folder;
        window->exports().exportPicture(wish, folder.filePath("export"));
        if (!window->exportJobs().isBusy()) return HUGE_VAL;
        QTest::qWait(after);
        const double seconds = secondsOfClosing(std::move(window));
        found += QDir(folder.path()).entryList(kAllFiles);
        return seconds;
      });
      if (after > 0) found.removeAll(QStringLiteral("export"));  // it was faster than the test
      QCOMPARE(found, QStringList());
      QVERIFY2(more < kMostWithExport,
               qPrintable(QStringLiteral("%1 s more after %2 ms").arg(more).arg(after)));
    }
  }

 private:
  static constexpr double kMostSeconds = 0.3;  // three workers at once, a tenth of a second each
  static constexpr double kMostWithExport = kMostSeconds + 0.1;  // the export is one more worker

  static constexpr auto kAllFiles = QDir::AllEntries | QDir::Hidden | QDir::NoDotAndDotDot;

  static std::unique_ptr<MainWindow> shownWindow() {
    auto window = std::make_unique<MainWindow>();
    window->show();
    return QTest::qWaitForWindowExposed(window.get()) ? std::move(window) : nullptr;
  }

  /// The least of at most three measurements, the first that is below the limit: what else the machine does
  /// makes one of them longer, work that goes on after closing makes each longer.
  template <class Measure>
  static double leastOfThree(double limit, Measure measure) {
    double least = HUGE_VAL;
    for (int i = 0; i < 3 && least >= limit; ++i) least = std::min(least, measure());
    return least;
  }

  /// Processor time that goes on in other threads while the window is destroyed.
  static double secondsOfClosing(std::unique_ptr<MainWindow> window) {
    if (!window->close()) return HUGE_VAL;
    const double before = secondsOfOthers();
    window.reset();
    return secondsOfOthers() - before;
  }
};

}  // namespace geargraph

QTEST_MAIN(geargraph::WindowCloseTest)
#include "test_window_close.moc"

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
      auto window = std::make_unique<MainWindow>();
      window->show();
      QVERIFY(QTest::qWaitForWindowExposed(window.get()));
      window->document().replace(mechanism, {});
      QTest::qWait(after);
      const double more = secondsOfClosing(std::move(window));
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
  /// Nothing is written, not in part either.
  void closingEndsAnExport() {
    QFETCH(PictureWish, wish);
    QFETCH(int, links);
    const Mechanism mechanism = test::deepTrain(links == 180 ? 2 : 1, links);
    for (const int after : {0, 60, 400}) {
      auto window = std::make_unique<MainWindow>();
      window->show();
      QVERIFY(QTest::qWaitForWindowExposed(window.get()));
      window->document().replace(mechanism, {});
      QTRY_VERIFY_WITH_TIMEOUT(window->isSettled() && window->view3d().stage(), 120'000);
      const QTemporaryDir folder;
      bool isDone = false;
      connect(&window->exports(), &WindowExports::written, window.get(), [&] { isDone = true; });
      window->exports().exportPicture(wish, folder.filePath("export"));
      QVERIFY(window->exportJobs().isBusy());
      QTest::qWait(after);
      if (isDone) return;  // faster than the test
      const double more = secondsOfClosing(std::move(window));
      QVERIFY2(more < kMostSeconds + 0.1,  // the export is one more worker
               qPrintable(QStringLiteral("%1 s more after %2 ms").arg(more).arg(after)));
      const auto all = QDir::AllEntries | QDir::Hidden | QDir::NoDotAndDotDot;
      QCOMPARE(QDir(folder.path()).entryList(all), QStringList());
    }
  }

 private:
  static constexpr double kMostSeconds = 0.3;  // three workers at once, a tenth of a second each

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

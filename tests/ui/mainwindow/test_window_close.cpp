#include <QDialog>
#include <QDir>
#include <QDockWidget>
#include <QEventLoop>
#include <QPointer>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>
#include <QTimer>

#include "tests/core/support/deep_train.h"
#include "tests/core/support/extreme_documents.h"
#include "tests/ui/mainwindow/hand.h"
#include "ui/mainwindow/export_jobs.h"
#include "ui/mainwindow/picture_dialog.h"
#include "ui/mainwindow/window_exports.h"
#include "ui/mainwindow/window_set.h"
#include "ui/theme/application_theme.h"
#include "ui/view3d/view3d.h"

namespace geargraph {
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
    for (const int after : {0, 400}) {
      auto window = shownWindow();
      window->document().replace(mechanism, {});
      QTest::qWait(after);
      QVERIFY(window->close());
      window.reset();  // waits for what works for it; the time limit of the program ends a test of what does
                       // not stop
    }
  }

  /// Of what works for a window each part would otherwise be waited for in turn.
  void aClosedWindowGoesOnceItsWorkHasEnded() {
    const QTemporaryDir folder;
    WindowSet windows(folder.path());
    QPointer<MainWindow> window(&windows.openNew());
    QVERIFY(QTest::qWaitForWindowExposed(window));
    window->document().replace(test::deepTrain(1, 1000), {});
    QTest::qWait(40);
    QVERIFY(!window->hasStopped());
    QVERIFY(window->close());
    QVERIFY(windows.windows().empty());
    QVERIFY(!window.isNull());  // nothing was waited for
    QVERIFY(!window->isVisible());
    QTRY_VERIFY_WITH_TIMEOUT(window.isNull(), 20'000);
  }

  /// The dialog, and the function of the window that waits for its answer, are on the stack.
  void aWindowStaysWhileItAsks() {
    const QTemporaryDir folder;
    WindowSet windows(folder.path());
    const QPointer<MainWindow> window(&windows.openNew());
    QVERIFY(QTest::qWaitForWindowExposed(window));
    const QPointer<QDialog> question(new QDialog(window));
    bool stayed = false;
    QEventLoop program;
    QTimer::singleShot(0, &program, [&] {
      constexpr int kTicks = 20;  // WindowSet deletes closed windows by a timer as fast as this one
      int ticks = 0;
      QTimer timer;
      connect(&timer, &QTimer::timeout, question, [&] {
        if (window->hasStopped() && ++ticks > kTicks) question->reject();
      });
      timer.start(5);
      QTimer::singleShot(0, question, [&] { window->close(); });
      question->exec();
      stayed = !question.isNull();
      delete question;
      program.quit();
    });
    program.exec();
    QVERIFY(stayed);
    QTRY_VERIFY(window.isNull());
  }

  /// Panels that are hidden no longer want what they read, which renews the commands of the window.
  void aWindowMayGoWhileItIsVisible() {
    auto window = shownWindow();
    QVERIFY(window->openDocument(QStringLiteral(":/examples/eight-speed-gearbox.geargraph")));
    window->findChild<QDockWidget*>(QStringLiteral("dock.gearbox"))->raise();
    ForcesService& forces = window->workbench().forces();
    QTRY_VERIFY(window->isSettled() && forces.answer() != nullptr);
    QStringList classes;  // what the window was at each answer
    forces.onAnswer(this, [&classes, of = static_cast<QWidget*>(window.get())](const ForcesPtr&) {
      classes << QString::fromLatin1(of->metaObject()->className());
    });
    window.reset();
    QCOMPARE(classes, QStringList(QString::fromLatin1(MainWindow::staticMetaObject.className())));
  }

  void closingEndsAnExport_data() {
    QTest::addColumn<PictureOptions>("wish");
    QTest::addColumn<int>("links");
    QTest::addRow("solids") << pictureIn3d(SolidForm::glb) << 180;
    QTest::addRow("picture") << pictureIn3d(SolidForm::png) << 1000;
    PictureOptions animation = pictureIn3d(SolidForm::png);
    animation.animation = Animation{AnimationKind::motion, 72, 24, 0};
    QTest::addRow("film") << animation << 1000;
    animation.solid = SolidForm::pictures;
    QTest::addRow("pictures of a film") << animation << 1000;
  }
  /// No part of a file is left, and right after the request none is written at all.
  void closingEndsAnExport() {
    QFETCH(PictureOptions, wish);
    QFETCH(int, links);
    const Mechanism mechanism = test::deepTrain(links == 180 ? 2 : 1, links);
    for (const int after : {0, 60, 400}) {
      auto window = shownWindow();
      window->document().replace(mechanism, {});
      QVERIFY(hasItsStage(*window));
      const QTemporaryDir folder;
      window->exports().exportPicture(wish, folder.filePath("export"));
      QVERIFY(window->exportJobs().isBusy());
      QTest::qWait(after);
      QVERIFY(window->close());
      window.reset();
      QStringList found = QDir(folder.path()).entryList(kAllFiles);
      if (after > 0) found.removeAll(QStringLiteral("export"));  // it was faster than the test
      QCOMPARE(found, QStringList());
    }
  }

 private:
  static constexpr auto kAllFiles = QDir::AllEntries | QDir::Hidden | QDir::NoDotAndDotDot;

  static std::unique_ptr<MainWindow> shownWindow() {
    auto window = std::make_unique<MainWindow>();
    window->show();
    return QTest::qWaitForWindowExposed(window.get()) ? std::move(window) : nullptr;
  }

  static PictureOptions pictureIn3d(SolidForm form) {
    PictureOptions options;
    options.view = QStringLiteral("3d");
    options.solid = form;
    return options;
  }

  static bool hasItsStage(MainWindow& window) {
    return QTest::qWaitFor([&] { return window.isSettled() && window.view3d().stage(); }, 120'000);
  }
};

}  // namespace geargraph

QTEST_MAIN(geargraph::WindowCloseTest)
#include "test_window_close.moc"

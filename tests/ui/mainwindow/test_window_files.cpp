#include <QDockWidget>
#include <QDragEnterEvent>
#include <QFile>
#include <QListView>
#include <QMimeData>
#include <QPointer>
#include <QProgressDialog>
#include <QPushButton>
#include <QRegularExpression>
#include <QSemaphore>
#include <QTabBar>
#include <QTemporaryFile>
#include <QTest>
#include <QTimer>

#include "core/mechanism/document_format/mechanism_table.h"
#include "tests/ui/mainwindow/file_windows.h"
#include "ui/canvas/digraph_view.h"
#include "ui/mainwindow/document_card.h"
#include "ui/mainwindow/document_files.h"
#include "ui/mainwindow/presentation.h"
#include "ui/mainwindow/recent_files.h"
#include "ui/mainwindow/start_page.h"
#include "ui/mainwindow/status_line.h"
#include "ui/mainwindow/thumbnails.h"
#include "ui/mainwindow/window_files.h"
#include "ui/settings/languages.h"
#include "ui/settings/settings.h"

namespace geargraph {

/// Windows, files, and what happens when either goes away.
class WindowFilesTest : public QObject, protected test::FileWindows {
  Q_OBJECT

  static constexpr int kManyLinks = 4'000;

  /// A file that takes longer than some frames to read.
  [[nodiscard]] QString writtenLarge() const {
    Mechanism mechanism = emptyMechanism();
    for (int i = 1; i <= kManyLinks; ++i) {
      Link link;
      link.id = LinkId("link-" + std::to_string(i));
      mechanism.view.nodes[link.id] = {100.0 * i, 90};
      mechanism.links.push_back(link);
    }
    const QString path = folder->filePath(QStringLiteral("large.geargraph"));
    if (writeDocument(mechanism, path)) qFatal("%s", qPrintable(path));
    return path;
  }
  /// Reads an empty document when the gate opens.
  static std::function<Expected<Mechanism>()> readerOf(const std::shared_ptr<QSemaphore>& gate) {
    return [gate]() -> Expected<Mechanism> {
      gate->acquire();
      return emptyMechanism();
    };
  }
  /// That of the first window in the session.
  static QByteArray recordedLayout() {
    flushSettings();
    return QSettings().value(QStringLiteral("session/windows/1/state")).toByteArray();
  }
  void startAgain(const QStringList& documents = {}) {
    set.reset();  // without closing anything, as in a crash
    set = std::make_unique<WindowSet>(app());
    set->start(documents);
  }

 public:
  /// Newer releases of Qt fit a restored window into the screen, and that of "offscreen" is 800 pixels wide.
  static void initMain() {
    if (qgetenv("QT_QPA_PLATFORM") != "offscreen") return;
    static QTemporaryFile screens;
    if (!screens.open()) return;
    screens.write(R"({"screens": [{"name": "wide", "x": 0, "y": 0, "width": 1920, "height": 1080,
                      "logicalDpi": 96, "logicalBaseDpi": 96, "dpr": 1}]})");
    screens.close();
    qputenv("QT_QPA_PLATFORM", "offscreen:configfile=" + QFile::encodeName(screens.fileName()));
  }

 private slots:
  void initTestCase() { setUpWindows(); }
  void init() { makeFolder(); }
  void cleanup() { set.reset(); }

  void itStartsWithTheStartPage() {
    set->start({});
    QCOMPARE(set->windows().size(), std::size_t{1});
    StartPage& page = first().startPage();
    QVERIFY(page.isVisible());
    QCOMPARE(page.examples().model()->rowCount(), int(examplePaths().size()));
    for (int i = 0; i < page.examples().model()->rowCount(); ++i) {
      const QModelIndex example = page.examples().model()->index(i, 0);
      QVERIFY(!example.data().toString().isEmpty());
      QVERIFY(example.data(Qt::ToolTipRole).toString().endsWith(QLatin1Char('.')));
    }
    const QModelIndex second = page.examples().model()->index(1, 0);
    QTest::mouseClick(page.examples().viewport(), Qt::LeftButton, {},
                      page.examples().visualRect(second).center());
    QCOMPARE(set->windows().size(), std::size_t{1});
    QVERIFY(page.isHidden());
    QCOMPARE(first().files().source(), examplePaths().at(1));
    QVERIFY(first().document().mechanism()->n() > 0);
  }

  void theStartPageShowsOneGroupOfExamples() {
    set->start({});
    StartPage& page = first().startPage();
    auto* tabs = page.findChild<QTabBar*>(QStringLiteral("startGroups"));
    const std::vector<ExampleGroup> groups = exampleGroups();
    QVERIFY(groups.size() >= 3);
    QCOMPARE(tabs->count(), int(groups.size()) + 1);
    const auto shown = [&] {
      QStringList paths;
      for (int i = 0; i < page.examples().model()->rowCount(); ++i) {
        if (!page.examples().isRowHidden(i))
          paths << page.examples().model()->index(i, 0).data(kPathRole).toString();
      }
      return paths;
    };
    QCOMPARE(shown(), examplePaths());
    for (std::size_t g = 0; g < groups.size(); ++g) {
      tabs->setCurrentIndex(int(g) + 1);
      QVERIFY(!groups[g].paths.isEmpty());
      QCOMPARE(shown(), groups[g].paths);
    }
    tabs->setCurrentIndex(0);
    QCOMPARE(shown(), examplePaths());
  }

  void drawingPutsTheStartPageAway() {
    set->start({});
    first().actions().tool[static_cast<std::size_t>(ToolKind::link)]->trigger();
    QVERIFY(first().startPage().isHidden());
    first().actions()[CommandId::startPage]->trigger();
    QVERIFY(first().startPage().isVisible());
    QTest::mouseClick(first().startPage().findChild<QPushButton*>(QStringLiteral("startNew")),
                      Qt::LeftButton);
    QVERIFY(first().startPage().isHidden());
  }

  void aSecondFileGetsAWindowOfItsOwn() {
    const QString one = written(QStringLiteral("one.geargraph"), 1);
    const QString two = written(QStringLiteral("two.geargraph"), 2);
    set->start({});
    set->openFrom(one, first().files());
    QCOMPARE(set->windows().size(), std::size_t{1});  // the empty one is used
    set->openFrom(two, first().files());
    QCOMPARE(set->windows().size(), std::size_t{2});
    QCOMPARE(set->windows().back()->document().mechanism()->n(), 2);
    set->openFrom(one, set->windows().back()->files());  // it is open already
    QCOMPARE(set->windows().size(), std::size_t{2});
    first().actions()[CommandId::newWindow]->trigger();
    QCOMPARE(set->windows().size(), std::size_t{3});
    QVERIFY(set->windows().back()->close());
    QTRY_COMPARE(set->windows().size(), std::size_t{2});
  }

  void aBrokenFileIsSaidWhereItWasAskedFor() {
    set->start({});
    QFile file(folder->filePath(QStringLiteral("broken.geargraph")));
    QVERIFY(file.open(QIODevice::WriteOnly) && file.write("{") == 1);
    file.close();
    set->openFrom(file.fileName(), first().files());
    QCOMPARE(set->windows().size(), std::size_t{1});
    QVERIFY(first().statusLine().text().contains(QStringLiteral("broken.geargraph")));
  }

  /// The table is not the document's file: it would lose what it has no place for.
  void aTableIsImported() {
    set->start({});
    QVERIFY(first().files().open(examplePaths().front()));
    const MechanismPtr robot = first().document().mechanism();
    const QString table = folder->filePath(QStringLiteral("robot.csv"));
    QFile file(table);
    QVERIFY(file.open(QIODevice::WriteOnly));
    file.write(QByteArray::fromStdString(writeMechanismTable(*robot)));
    file.close();
    set->openFrom(table, first().files());
    QCOMPARE(set->windows().size(), std::size_t{1});  // only an example was looked at
    const Document& document = first().document();
    QCOMPARE(*document.mechanism(), tablePart(*robot).mechanism);
    QVERIFY(document.isModified() && document.filePath().isEmpty());
    QVERIFY(first().statusLine().text().contains(QStringLiteral("robot.csv")));
    first().document().undoStack().undo();
    QCOMPARE(document.mechanism()->n(), 0);
    QVERIFY(!document.isModified());
  }

  void aWrongTableIsListedAndTheDocumentStays() {
    set->start({written(QStringLiteral("one.geargraph"), 1)});
    QFile file(folder->filePath(QStringLiteral("wrong.csv")));
    QVERIFY(file.open(QIODevice::WriteOnly));
    file.write("element,label\nlink,1\nturningJoint,a\n");
    file.close();
    set->openFrom(file.fileName(), first().files());
    QCOMPARE(first().document().mechanism()->n(), 1);
    QVERIFY(first().statusLine().text().contains(QStringLiteral("wrong.csv")));
  }

  void theWindowLivesWhileALargeFileIsRead() {
    const QString path = writtenLarge();
    set->start({});
    int alive = 0;
    QTimer ticks;
    connect(&ticks, &QTimer::timeout, this, [&alive] { ++alive; });
    ticks.start(0);
    QVERIFY(first().files().open(path));
    QVERIFY(alive > 0);
    QCOMPARE(first().document().mechanism()->n(), kManyLinks);
    QVERIFY(first().findChild<QProgressDialog*>() == nullptr);
  }

  void readingCanBeCancelled() {
    set->start({});
    const auto gate = std::make_shared<QSemaphore>();
    QTimer ticks;
    connect(&ticks, &QTimer::timeout, this, [this] {
      const auto* dialog = first().findChild<QProgressDialog*>();
      if (dialog != nullptr) dialog->findChild<QPushButton*>()->click();
    });
    ticks.start(0);
    QVERIFY(!readInBackground(readerOf(gate), QStringLiteral("slow.geargraph"), &first(), 1).has_value());
    gate->release();
  }

  /// By Ctrl+Q in another window, for example. What reads is on the stack, with the window that asked for it.
  void aWindowMayBeClosedWhileItReads() {
    set->start({});
    const QPointer<MainWindow> window(&first());
    const auto gate = std::make_shared<QSemaphore>();
    int waits = 0;
    QTimer ticks;
    connect(&ticks, &QTimer::timeout, this, [&] {
      if (window->findChild<QProgressDialog*>() == nullptr) return;
      ++waits;
      window->close();
    });
    ticks.start(0);
    QVERIFY(!readInBackground(readerOf(gate), QStringLiteral("slow.geargraph"), window, 1).has_value());
    ticks.stop();
    QCOMPARE(waits, 1);
    QVERIFY(!window.isNull());
    QVERIFY(set->windows().empty());
    gate->release();
    QTRY_VERIFY(window.isNull());
  }

  void theProgramMayBeQuitWhileItReadsItsFirstDocument() {
    QTimer ticks;
    connect(&ticks, &QTimer::timeout, this, [this] { set->quit(); });
    ticks.start(0);
    set->start({writtenLarge(), written(QStringLiteral("next.geargraph"), 1)});
    QVERIFY(set->windows().empty());
  }

  void theLanguageStaysWhileAFileIsRead() {
    set->start({});
    const MainWindow* const window = &first();
    const auto gate = std::make_shared<QSemaphore>();
    QTimer::singleShot(0, this, [&] {
      emit first().languageWanted(QStringLiteral("de"));
      gate->release();
    });
    QVERIFY(readInBackground(readerOf(gate), QStringLiteral("slow.geargraph"), &first()).has_value());
    QCOMPARE(&first(), window);
    QCOMPARE(currentLanguage(), QStringLiteral("en"));
    QVERIFY(first().statusLine().text().contains(QStringLiteral("language")));
  }

  void filesAreDropped() {
    const QString one = written(QStringLiteral("one.geargraph"), 1);
    const QString two = written(QStringLiteral("two.geargraph"), 2);
    set->start({});
    QMimeData files;
    files.setUrls({QUrl::fromLocalFile(one), QUrl::fromLocalFile(two)});
    // Over the drawing, which must not swallow them.
    QWidget* sheet = first().digraph().viewport();
    QDragEnterEvent enter({40, 40}, Qt::CopyAction, &files, Qt::LeftButton, {});
    QApplication::sendEvent(sheet, &enter);
    QVERIFY(enter.isAccepted());
    QDropEvent drop({40, 40}, Qt::CopyAction, &files, Qt::LeftButton, {});
    QApplication::sendEvent(sheet, &drop);
    QCOMPARE(set->windows().size(), std::size_t{2});
    QCOMPARE(first().files().source(), one);
    QCOMPARE(set->windows().back()->files().source(), two);

    QMimeData text;
    text.setText(QStringLiteral("a text"));
    QDragEnterEvent other({40, 40}, Qt::CopyAction, &text, Qt::LeftButton, {});
    QApplication::sendEvent(sheet, &other);
    QVERIFY(!other.isAccepted());
  }

  void recentFilesHavePictures() {
    const QString one = written(QStringLiteral("one.geargraph"), 1);
    set->start({one});
    QCOMPARE(RecentFiles::paths(), QStringList{one});
    QTRY_VERIFY(!Thumbnails::kept(one, Theme::light).isNull());
    QTRY_VERIFY(!Thumbnails::kept(one, Theme::dark).isNull());
    QVERIFY(Thumbnails::kept(one, Theme::light) != Thumbnails::kept(one, Theme::dark));
    first().actions()[CommandId::startPage]->trigger();
    QCOMPARE(first().startPage().recent().model()->rowCount(), 1);
  }

  void whatAnotherProgramWroteIsSaidAndTakenOver() {
    const QString path = written(QStringLiteral("one.geargraph"), 1);
    set->start({path});
    addLink(first());
    const MechanismPtr own = first().document().mechanism();
    written(QStringLiteral("one.geargraph"), 5);
    QTRY_VERIFY(first().notices().current() != nullptr);
    QVERIFY2(first().notices().current()->text.contains(QStringLiteral("4 links added")),
             qPrintable(first().notices().current()->text));
    QCOMPARE(first().document().mechanism().get(), own.get());
    answer(first(), QStringLiteral("Reload"));
    QCOMPARE(first().document().mechanism()->n(), 5);
    QVERIFY(!first().document().isModified());
    first().document().undoStack().undo();
    QCOMPARE(first().document().mechanism().get(), own.get());
  }

  void whatAnotherProgramWroteIsNotOverwrittenUnasked() {
    const QString path = written(QStringLiteral("one.geargraph"), 1);
    set->start({path});
    addLink(first());
    written(QStringLiteral("one.geargraph"), 5);
    QVERIFY(!first().saveDocument(path));
    QVERIFY(first().document().isModified());
    QCOMPARE(readDocument(path)->n(), 5);
    answer(first(), QStringLiteral("Overwrite"));
    QCOMPARE(readDocument(path)->n(), 2);
    QVERIFY(!first().document().isModified());
    QVERIFY(first().notices().current() == nullptr);
  }

  void ownSavesAreNoForeignChange() {
    const QString path = written(QStringLiteral("one.geargraph"), 1);
    set->start({path});
    for (int i = 0; i < 3; ++i) {
      addLink(first());
      QVERIFY(first().saveDocument(path));
    }
    QTest::qWait(0);
    QVERIFY(first().notices().current() == nullptr);
  }

  void aFileThatIsGoneIsSaid() {
    const QString path = written(QStringLiteral("one.geargraph"), 1);
    set->start({path});
    QVERIFY(QFile::remove(path));
    QTRY_VERIFY(first().notices().current() != nullptr);
    answer(first(), QStringLiteral("Save again"));
    QCOMPARE(readDocument(path)->n(), 1);
  }

  void revertingCanBeUndone() {
    const QString path = written(QStringLiteral("one.geargraph"), 1);
    set->start({path});
    QVERIFY(!first().actions()[CommandId::revert]->isEnabled());
    addLink(first());
    QVERIFY(first().actions()[CommandId::revert]->isEnabled());
    first().actions()[CommandId::revert]->trigger();
    QCOMPARE(first().document().mechanism()->n(), 1);
    QVERIFY(!first().isWindowModified());
    first().document().undoStack().undo();
    QCOMPARE(first().document().mechanism()->n(), 2);
    QVERIFY(first().isWindowModified());
  }

  void theSessionIsThereAgain() {
    const QString one = written(QStringLiteral("one.geargraph"), 1);
    const QString two = written(QStringLiteral("two.geargraph"), 2);
    set->start({one, two});
    set->quit();
    QVERIFY(set->windows().empty());
    startAgain();
    QCOMPARE(set->windows().size(), std::size_t{2});
    QCOMPARE(first().files().source(), one);
    QCOMPARE(set->windows().back()->files().source(), two);
    QVERIFY(first().startPage().isHidden());
    QVERIFY(QFile::remove(two));
    startAgain();  // after a crash, and with a file that is gone
    QCOMPARE(set->windows().size(), std::size_t{1});
    QVERIFY(first().statusLine().text().contains(QStringLiteral("two.geargraph")));
    first().actions()[CommandId::restoreSession]->trigger();
    QVERIFY(!set->restoresSession());
    startAgain();
    QVERIFY(first().startPage().isVisible());
  }

  void theSessionHasItsLayout() {
    set->start({written(QStringLiteral("one.geargraph"), 1)});
    QVERIFY(QTest::qWaitForWindowExposed(&first()));
    const auto width = [this] { return first().findChild<QWidget*>(QStringLiteral("dock.view3d"))->width(); };
    const int before = width();
    auto* dock = first().findChild<QDockWidget*>(QStringLiteral("dock.view3d"));
    first().resizeDocks({dock}, {before - 77}, Qt::Horizontal);
    QTRY_COMPARE(width(), before - 77);
    set->quit();
    startAgain();
    QVERIFY(QTest::qWaitForWindowExposed(&first()));
    QTRY_COMPARE(width(), before - 77);
  }

  void theSessionHasTheLayoutBehindAPresentation() {
    set->start({written(QStringLiteral("one.geargraph"), 1)});
    QVERIFY(QTest::qWaitForWindowExposed(&first()));
    const QStringList shown = test::shownDocks(first());
    const QByteArray before = first().saveState();
    first().presentation().setOn(true);
    QVERIFY(first().saveState() != before);
    QVERIFY(test::shownDocks(first()) != shown);
    set->quit();
    QCOMPARE(savedSetting(QStringLiteral("window/state")).toByteArray(), before);
    QCOMPARE(recordedLayout(), before);
    QVERIFY(!savedSetting(QStringLiteral("presentation/state")).toByteArray().isEmpty());
    startAgain();
    QVERIFY(QTest::qWaitForWindowExposed(&first()));
    QTRY_COMPARE(test::shownDocks(first()), shown);
    QVERIFY(!first().isFullScreen());
  }

  /// In the middle of a drag the layout holds room for docks that float as a group, which has no name; and
  /// what is dropped on the rest of its group would be lost.
  void theSessionWaitsForADragOfDocks() {
    QTest::failOnWarning(QRegularExpression(QStringLiteral("saveState")));
    set->start({written(QStringLiteral("one.geargraph"), 1)});
    QVERIFY(QTest::qWaitForWindowExposed(&first()));
    QTRY_VERIFY(first().isSettled());
    QTRY_VERIFY(first().isSettled());
    auto* dock = first().findChild<QDockWidget*>(QStringLiteral("dock.view3d"));
    auto* floating = first().findChild<QDockWidget*>(QStringLiteral("dock.properties"));
    floating->setFloating(true);
    floating->move(first().mapToGlobal(QPoint(300, 300)));
    const QPoint title(60, 12);
    const auto drag = [&](QDockWidget* on, const QPoint& to) {
      const QPoint from = on->mapToGlobal(title);
      QTest::mouseMove(on, title);
      QTest::mousePress(on, Qt::LeftButton, {}, title);
      for (int i = 1; i <= 8; ++i) QTest::mouseMove(on, on->mapFromGlobal(from + (to - from) * i / 8));
      QVERIFY(QWidget::mouseGrabber() == on);
    };
    const auto drop = [&](QDockWidget* on) { QTest::mouseRelease(on, Qt::LeftButton, {}, title); };
    drag(dock, floating->mapToGlobal(QPoint(20, floating->height() / 2)));
    drop(dock);
    QCOMPARE(dock->parentWidget(), floating->parentWidget());  // the group
    drag(floating, first().mapToGlobal(first().rect().center()));
    const QByteArray before = recordedLayout();
    set->openNew();  // so all are recorded, after a second
    QTest::qWait(1500);
    QVERIFY(QWidget::mouseGrabber() == floating);
    QCOMPARE(recordedLayout(), before);
    drop(floating);
    QTRY_VERIFY(recordedLayout() != before);
    QCOMPARE(recordedLayout(), first().saveState());
    QCOMPARE(dock->parentWidget(), floating->parentWidget());  // else Qt has lost one of them
    QVERIFY(dock->isVisible() && floating->isVisible() && !floating->isWindow());
  }

  void aSecondProgramLeavesTheSessionAlone() {
    const QString one = written(QStringLiteral("one.geargraph"), 1);
    set->start({one});
    WindowSet other(app());
    other.start({});
    QVERIFY(other.windows().front()->startPage().isVisible());
    QVERIFY(other.windows().front()->close());
    startAgain();
    QCOMPARE(first().files().source(), one);
  }

  void unsavedChangesOfAFileAreOfferedAndRestored() {
    const QString path = written(QStringLiteral("one.geargraph"), 1);
    set->start({path});
    addLink(first());
    addLink(first());
    startAgain();  // the session opens the file
    QCOMPARE(first().document().mechanism()->n(), 1);
    QVERIFY(!first().document().isModified());
    const QString said = first().notices().current()->text;
    QVERIFY2(said.contains(QStringLiteral("one.geargraph")) && said.contains(QStringLiteral("2 edits")) &&
                 said.contains(QStringLiteral("2 links added")),
             qPrintable(said));
    answer(first(), QStringLiteral("Restore"));
    QVERIFY(first().notices().current() == nullptr);
    QCOMPARE(first().document().mechanism()->n(), 3);
    QVERIFY(first().isWindowModified());
    QCOMPARE(readDocument(path)->n(), 1);  // the file is the person's to write
    startAgain();                          // restored, but still not saved
    answer(first(), QStringLiteral("Restore"));
    QCOMPARE(first().document().mechanism()->n(), 3);
    first().document().undoStack().undo();
    QCOMPARE(first().document().mechanism()->n(), 1);
  }

  void aDocumentWithoutAFileIsOfferedAndRestored() {
    set->start({});
    first().actions()[CommandId::newDocument]->trigger();
    addLink(first());
    startAgain();
    QVERIFY(first().startPage().isVisible());
    QVERIFY(first().notices().current()->text.contains(QStringLiteral("1 edit ")));
    answer(first(), QStringLiteral("Restore"));
    QVERIFY(first().startPage().isHidden());
    QCOMPARE(first().document().mechanism()->n(), 1);
    QVERIFY(first().document().filePath().isEmpty());
  }

  void whatIsDiscardedIsNotOfferedAgain() {
    set->start({});
    addLink(first());
    startAgain();
    answer(first(), QStringLiteral("Discard"));
    startAgain();
    QVERIFY(first().notices().current() == nullptr);
  }

  void whatIsPutOffIsOfferedAgain() {
    const QString path = written(QStringLiteral("one.geargraph"), 1);
    set->start({path});
    addLink(first());
    startAgain();
    answer(first(), QStringLiteral("Later"));
    addLink(first());  // its side file is another one
    addLink(first());
    startAgain();
    const QString one = first().notices().current()->text;
    answer(first(), QStringLiteral("Later"));
    const QString two = first().notices().current()->text;
    QVERIFY(one.contains(QStringLiteral("1 edit ")) != two.contains(QStringLiteral("1 edit ")));
    QVERIFY(one.contains(QStringLiteral("2 edits ")) != two.contains(QStringLiteral("2 edits ")));
  }

  void whatWasSavedOrGivenUpIsNotOffered() {
    const QString path = written(QStringLiteral("one.geargraph"), 1);
    set->start({path});
    addLink(first());
    QVERIFY(first().saveDocument(path));
    startAgain();
    QVERIFY(first().notices().current() == nullptr);
  }

  void aWindowThatStandsAloneKeepsNothing() {
    MainWindow alone;
    QVERIFY(alone.openDocument(written(QStringLiteral("one.geargraph"), 1)));
    addLink(alone);
    QVERIFY(alone.files().autosave() == nullptr);
    QVERIFY(RecentFiles::paths().isEmpty());
  }
};

}  // namespace geargraph

QTEST_MAIN(geargraph::WindowFilesTest)
#include "test_window_files.moc"

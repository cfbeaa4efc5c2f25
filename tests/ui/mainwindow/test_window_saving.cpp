#include <sys/stat.h>
#include <unistd.h>

#include <QApplication>
#include <QDockWidget>
#include <QFile>
#include <QLineEdit>
#include <QMessageBox>
#include <QRegularExpression>
#include <QTest>
#include <QTimer>
#include <filesystem>

#include "core/foundations/files/file_identity.h"
#include "tests/ui/mainwindow/file_windows.h"
#include "ui/canvas/digraph_view.h"
#include "ui/mainwindow/status_line.h"
#include "ui/mainwindow/window_files.h"
#include "ui/panels/number_field.h"
#include "ui/panels/states_table.h"

namespace geargraph {

namespace fs = std::filesystem;

/// Ctrl+S saves or tells why not: whatever else is told, and whatever happened to the file.
class WindowSavingTest : public QObject, protected test::FileWindows {
  Q_OBJECT

  [[nodiscard]] std::string nativeOf(const char* name) const {
    return pathOf(QLatin1String(name)).toStdString();
  }
  static QString noticeOf(MainWindow& window) {
    const Notice* notice = window.notices().current();
    return notice == nullptr ? QString() : notice->text;
  }
  static void pressSave(MainWindow& window) { window.actions()[CommandId::save]->trigger(); }
  /// An informational notice, as an export posts one.
  static void postOther(MainWindow& window) {
    window.notices().post({QStringLiteral("other"), Severity::info, QStringLiteral("Painting."), {}});
  }
  /// Answers the question whether to save, as soon as it is asked.
  static void answerQuestion(QMessageBox::StandardButton button) {
    QTimer::singleShot(0, qApp, [button] {
      auto* box = qobject_cast<QMessageBox*>(QApplication::activeModalWidget());
      if (box == nullptr) return answerQuestion(button);
      box->button(button)->click();
    });
  }
  void showShiftTable(StatesTable*& table) {
    first().activateWindow();
    QVERIFY(QTest::qWaitForWindowActive(&first()));
    table = first().findChild<StatesTable*>();
    first().findChild<QDockWidget*>(QStringLiteral("dock.gearbox"))->raise();
    QTRY_VERIFY(table->isVisible());
  }
  /// A notice is in front, the title is dirty, nothing of the notices before is lost.
  void verifyNotSaved(MainWindow& window, const QString& why) {
    QVERIFY2(noticeOf(window).contains(QStringLiteral("was not saved")) && noticeOf(window).contains(why),
             qPrintable(noticeOf(window)));
    QVERIFY2(!window.statusLine().text().isEmpty(), "the status bar");
    QVERIFY(window.isWindowModified());
    QVERIFY(window.document().isModified());
  }

 private slots:
  void initTestCase() { setUpWindows(); }
  void init() { makeFolder(); }
  void cleanup() { set.reset(); }

  void saveTakesWhatIsBeingTyped() {
    const QString path = pathOf(QStringLiteral("robot.geargraph"));
    QVERIFY(QFile::copy(robotExamplePath(), path));
    set->start({path});
    first().activateWindow();
    QVERIFY(QTest::qWaitForWindowActive(&first()));
    const Input& input = first().document().mechanism()->inputs->front();
    const QString name = QStringLiteral("speed.%1").arg(QString::fromStdString(input.joint.text()));
    auto* field = first().findChild<NumberField*>(name);
    QVERIFY(field != nullptr);
    field->setFocus();
    field->selectAll();
    QTest::keyClicks(field, QStringLiteral("77"));
    pressSave(first());
    QVERIFY(!first().document().isModified());
    QCOMPARE(readDocument(path).value().inputs->front().speed, Number(Rational(77)));

    first().selection().select({LinkId("1")});
    first().digraph().renameSelected();
    QTest::keyClicks(first().focusWidget(), QStringLiteral("Arm"));
    pressSave(first());
    QCOMPARE(readDocument(path).value().find(LinkId("1"))->name, std::string("Arm"));
    QTRY_VERIFY(first().digraph().hasFocus());
  }

  void saveTakesTheNamesBeingTypedInTheShiftTable() {
    QTest::failOnWarning(QRegularExpression(QStringLiteral("closeEditor")));
    const QString path = pathOf(QStringLiteral("gearbox.geargraph"));
    QVERIFY(QFile::copy(QStringLiteral(":/examples/eight-speed-gearbox.geargraph"), path));
    QVERIFY(QFile::setPermissions(path, QFile::ReadOwner | QFile::WriteOwner));
    set->start({path});
    StatesTable* table = nullptr;
    showShiftTable(table);
    QVERIFY(!QTest::currentTestFailed());
    table->heads().rename(1);
    QTest::keyClicks(first().focusWidget(), QStringLiteral("Brake"));
    pressSave(first());
    QCOMPARE(readDocument(path)->couplings.front().id.text(), std::string("Brake"));

    table->edit(table->model()->index(0, 0));
    QTest::keyClicks(first().focusWidget(), QStringLiteral("First"));
    pressSave(first());
    QCOMPARE(readDocument(path)->states.front().name, std::string("First"));
    QVERIFY(!first().document().isModified());
  }

  void aNameOfACouplingIsCancelledByEscAndGoesWithItsColumn() {
    set->start({QStringLiteral(":/examples/eight-speed-gearbox.geargraph")});
    StatesTable* table = nullptr;
    showShiftTable(table);
    QVERIFY(!QTest::currentTestFailed());
    const Mechanism other = readDocument(QStringLiteral(":/examples/simpson.geargraph")).value();
    for (const bool isEscaped : {true, false}) {
      table->heads().rename(1);
      const QPointer<QWidget> editor(first().focusWidget());
      QVERIFY(qobject_cast<QLineEdit*>(editor.data()) != nullptr);
      QTest::keyClicks(editor, QStringLiteral("Brake"));
      if (isEscaped) {
        QTest::keyClick(editor, Qt::Key_Escape);
      } else {
        first().document().replace(other, {});
      }
      QTRY_VERIFY(editor.isNull());
      QVERIFY(first().document().mechanism()->couplings.front().id.text() != "Brake");
      QVERIFY(!first().document().isModified());
    }
    QVERIFY(*first().document().mechanism() == other);
  }

  // --- the question comes to the front ---------------------------------------------------------------------

  void theQuestionComesBeforeOtherNotices_whichComeBack() {
    const QString path = written("one.geargraph", 1);
    set->start({path});
    addLink(first());
    postOther(first());
    written("one.geargraph", 5);
    pressSave(first());
    verifyNotSaved(first(), QStringLiteral("another program has changed it (4 links added)"));
    QVERIFY(buttonOf(first(), QStringLiteral("Overwrite")) != nullptr);
    QCOMPARE(readDocument(path)->n(), 5);
    answer(first(), QStringLiteral("Overwrite"));
    QCOMPARE(readDocument(path)->n(), 2);
    QVERIFY(!first().isWindowModified());
    QCOMPARE(noticeOf(first()), QStringLiteral("Painting."));
  }

  void theWatchsOwnQuestionWaitsItsTurn_untilSavingNeedsIt() {
    const QString path = written("one.geargraph", 1);
    set->start({path});
    postOther(first());
    addLink(first());
    written("one.geargraph", 5);
    QTest::qWait(100);  // the watch has told by now, behind the other notice
    QCOMPARE(noticeOf(first()), QStringLiteral("Painting."));
    pressSave(first());
    verifyNotSaved(first(), QStringLiteral("another program"));
    answer(first(), QStringLiteral("Later"));
    QCOMPARE(noticeOf(first()), QStringLiteral("Painting."));
    QVERIFY(first().isWindowModified());
    pressSave(first());  // and asks again
    verifyNotSaved(first(), QStringLiteral("another program"));
  }

  void aTouchedFileWithTheSameContentsIsSavedOver() {
    const QString path = written("one.geargraph", 1);
    set->start({path});
    addLink(first());
    written("one.geargraph", 1);
    pressSave(first());
    QCOMPARE(readDocument(path)->n(), 2);
    QVERIFY(!first().isWindowModified());
    QVERIFY(first().notices().current() == nullptr);
  }

  void aFileOfTheSameSizeAndTimeIsForeign() {
    const QString path = written("one.geargraph", 1);
    set->start({path});
    Mechanism other = *first().document().mechanism();
    other.name = "a";
    QVERIFY(!writeDocument(other, path));
    QVERIFY(first().files().open(path));
    const auto time = fs::last_write_time(nativeOf("one.geargraph"));
    addLink(first());
    other.name = "b";
    QVERIFY(!writeDocument(other, path));
    fs::last_write_time(nativeOf("one.geargraph"), time);
    pressSave(first());
    verifyNotSaved(first(), QStringLiteral("another program"));
  }

  // --- writing fails
  // ----------------------------------------------------------------------------------------

  void aFullDiskIsTold_beforeOtherNotices() {
    set->start({written("one.geargraph", 1)});
    addLink(first());
    postOther(first());
    QVERIFY(!first().saveDocument(QStringLiteral("/dev/full")));
    verifyNotSaved(first(), QStringLiteral("No space left on device"));
    QVERIFY(buttonOf(first(), QStringLiteral("Try again")) != nullptr);
    QCOMPARE(first().document().filePath(), pathOf("one.geargraph"));
    pressSave(first());  // to its own file, which works
    QVERIFY(!first().isWindowModified());
    QCOMPARE(noticeOf(first()), QStringLiteral("Painting."));
  }

  void aFolderThatIsGoneIsTold() {
    QVERIFY(QDir(folder->path()).mkdir(QStringLiteral("sub")));
    set->start({written("sub/one.geargraph", 1)});
    addLink(first());
    fs::remove_all(nativeOf("sub"));
    pressSave(first());
    verifyNotSaved(first(), QStringLiteral("No such file or directory"));
    QVERIFY(QDir(folder->path()).mkdir(QStringLiteral("sub")));
    answer(first(), QStringLiteral("Try again"));
    QCOMPARE(readDocument(pathOf("sub/one.geargraph"))->n(), 2);
    QVERIFY(!first().isWindowModified());
    QVERIFY(first().notices().current() == nullptr);
  }

  void aFileThatMayNotBeWrittenIsTold() {
    // As a user who is not root, to whom everything is allowed.
    const bool isRoot = ::geteuid() == 0;
    const QString path = written("one.geargraph", 1);
    set->start({path});
    addLink(first());
    fs::permissions(nativeOf("one.geargraph"), fs::perms(0444));
    fs::permissions(folder->path().toStdString(), fs::perms(0555));
    if (isRoot) QCOMPARE(::setresuid(65534, 65534, 0), 0);
    pressSave(first());
    if (isRoot) QCOMPARE(::setresuid(0, 0, 0), 0);
    fs::permissions(folder->path().toStdString(), fs::perms(0755));
    verifyNotSaved(first(), QStringLiteral("Permission denied"));
    QCOMPARE(readDocument(path)->n(), 1);
  }

  void aDeletedFileMakesTheWindowDirty_andIsWrittenAgain() {
    const QString path = written("one.geargraph", 1);
    set->start({path});
    QVERIFY(QFile::remove(path));
    QTRY_VERIFY(first().isWindowModified());
    QTimer::singleShot(0, this, [] { answerQuestion(QMessageBox::Cancel); });
    QVERIFY(!first().close());  // it asks: the document is nowhere else
    pressSave(first());
    QCOMPARE(readDocument(path)->n(), 1);
    QVERIFY(!first().isWindowModified());
    QVERIFY(first().notices().current() == nullptr);
  }

  // --- closing
  // ----------------------------------------------------------------------------------------------

  void saveOnCloseThatFailsKeepsTheWindow() {
    const QString path = written("one.geargraph", 1);
    set->start({path});
    addLink(first());
    postOther(first());
    written("one.geargraph", 5);
    answerQuestion(QMessageBox::Save);
    QVERIFY(!first().close());
    verifyNotSaved(first(), QStringLiteral("another program"));
    QCOMPARE(readDocument(path)->n(), 5);
  }

  void quittingStopsAtTheWindowThatCannotBeSaved() {
    set->start({written("one.geargraph", 1), written("two.geargraph", 1)});
    addLink(last());
    written("two.geargraph", 5);
    answerQuestion(QMessageBox::Save);
    set->quit();
    QCOMPARE(set->windows().size(), std::size_t{1});
    verifyNotSaved(first(), QStringLiteral("two.geargraph"));
  }

  // --- one file, two windows
  // --------------------------------------------------------------------------------

  void oneFileUnderAnotherNameIsShownInItsWindow() {
    const QString path = written("one.geargraph", 1);
    fs::create_symlink("one.geargraph", nativeOf("soft.geargraph"));
    fs::create_hard_link(nativeOf("one.geargraph"), nativeOf("hard.geargraph"));
    set->start({path});
    set->openFrom(written("two.geargraph", 2), first().files());
    for (const char* name : {"soft.geargraph", "hard.geargraph", "./app/.././one.geargraph"}) {
      set->openFrom(pathOf(name), last().files());
      QCOMPARE(set->windows().size(), std::size_t{2});
      QVERIFY(first().statusLine().text().contains(QStringLiteral("open in this window already")));
    }
  }

  void aFileNamedTwiceAtTheStartGetsOneWindow() {
    const QString path = written("one.geargraph", 1);
    fs::create_symlink("one.geargraph", nativeOf("soft.geargraph"));
    set->start({path, pathOf("soft.geargraph")});
    QCOMPARE(set->windows().size(), std::size_t{1});
  }

  void savingOverTheFileOfAnotherWindowIsRejected() {
    const QString one = written("one.geargraph", 1);
    set->start({one, written("two.geargraph", 2)});
    addLink(last());
    fs::create_symlink("one.geargraph", nativeOf("soft.geargraph"));
    postOther(last());
    QVERIFY(!last().saveDocument(pathOf("soft.geargraph")));
    verifyNotSaved(last(), QStringLiteral("soft.geargraph is open in another window"));
    QCOMPARE(readDocument(one)->n(), 1);
    answer(last(), QStringLiteral("Show that window"));
    QCOMPARE(set->windows().size(), std::size_t{2});  // it has a document of its own
    QVERIFY(last().isWindowModified());
  }

  void savingKeepsLinks() {
    const QString path = written("one.geargraph", 1);
    fs::create_symlink("one.geargraph", nativeOf("soft.geargraph"));
    fs::create_hard_link(nativeOf("one.geargraph"), nativeOf("hard.geargraph"));
    set->start({pathOf("soft.geargraph")});
    addLink(first());
    pressSave(first());
    QVERIFY(!first().isWindowModified());
    QVERIFY(fs::is_symlink(nativeOf("soft.geargraph")));
    QVERIFY(isSameFile(nativeOf("one.geargraph"), nativeOf("hard.geargraph")));
    QCOMPARE(readDocument(pathOf("hard.geargraph"))->n(), 2);
    addLink(first());
    pressSave(first());  // its own writing in place is not another program's
    QVERIFY(!first().isWindowModified());
  }

  void anInterruptedWriteIsOffered() {
    const QString path = written("one.geargraph", 1);
    written(".one.geargraph.999999999-0.saving", 3);
    set->start({path});
    QVERIFY2(noticeOf(first()).contains(QStringLiteral("was interrupted")), qPrintable(noticeOf(first())));
    answer(first(), QStringLiteral("Open the copy"));
    QCOMPARE(last().document().mechanism()->n(), 3);
    QVERIFY(QFile::exists(path));
  }
};

}  // namespace geargraph

QTEST_MAIN(geargraph::WindowSavingTest)
#include "test_window_saving.moc"

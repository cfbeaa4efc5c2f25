#include <QApplication>
#include <QClipboard>
#include <QDialog>
#include <QDir>
#include <QFile>
#include <QMessageBox>
#include <QPlainTextEdit>
#include <QPointer>
#include <QProcess>
#include <QPushButton>
#include <QStandardPaths>
#include <QTemporaryDir>
#include <QTest>
#include <csignal>
#include <filesystem>

#include "core/mechanism/model/edits.h"
#include "tests/ui/mainwindow/hand.h"
#include "ui/mainwindow/document_files.h"
#include "ui/mainwindow/notice_bar.h"
#include "ui/mainwindow/window_files.h"
#include "ui/mainwindow/window_set.h"
#include "ui/theme/application_theme.h"

namespace geargraph {

/// The editor itself as another process: on the same file, and crashing.
class TwoProgramsTest : public QObject {
  Q_OBJECT

  static constexpr int kPatience = 120'000;  ///< ms, on a machine that is busy
  std::unique_ptr<QTemporaryDir> folder;
  std::unique_ptr<QProcess> editor;
  std::unique_ptr<WindowSet> set;

  /// Where the editor keeps side files and lists, under the data folder that startEditor() gives it.
  [[nodiscard]] QString recovery() const {
    return folder->filePath(QStringLiteral("GearGraph/GearGraph/recovery"));
  }
  [[nodiscard]] QString document() const { return folder->filePath(QStringLiteral("one.geargraph")); }
  [[nodiscard]] QStringList lists() const {
    return QDir(recovery() + QStringLiteral("/open")).entryList({QStringLiteral("*.json")}, QDir::Files);
  }
  [[nodiscard]] MainWindow& first() const { return *set->windows().front(); }
  [[nodiscard]] QString notice() const {
    const Notice* current = first().notices().current();
    return current == nullptr ? QString() : current->text;
  }
  void startEditor() {
    QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
    for (const char* name : {"XDG_DATA_HOME", "XDG_CONFIG_HOME", "XDG_CACHE_HOME"}) {
      environment.insert(QString::fromLatin1(name), folder->path());
    }
    environment.insert(QStringLiteral("QT_QPA_PLATFORM"), QStringLiteral("offscreen"));
    environment.insert(QStringLiteral("ASAN_OPTIONS"), QStringLiteral(GEARGRAPH_NO_SANITIZER_SIGNALS));
    editor = std::make_unique<QProcess>();
    editor->setProcessEnvironment(environment);
    editor->start(QStringLiteral(GEARGRAPH_EDITOR), {document()});
    QVERIFY(editor->waitForStarted(kPatience));
    QTRY_VERIFY_WITH_TIMEOUT(lists().size() == 1, kPatience);  // its window has the document
  }
  /// Its windows are there and answer.
  void waitUntilEditorAnswers() {
    OpenDocuments asking(recovery());
    const auto holder = asking.holderOf(document());
    QVERIFY(holder.has_value());
    QCOMPARE(holder->process, editor->processId());
    bool isShown = false;
    bool isAsking = false;
    const auto ask = [&] {
      if (!isShown && !std::exchange(isAsking, true)) {
        asking.show(*holder, this, [&](bool shown) {
          isShown = shown;
          isAsking = false;
        });
      }
      return isShown;
    };
    QTRY_VERIFY_WITH_TIMEOUT(ask(), kPatience);
  }
  void signalEditor(int number) const { ::kill(static_cast<pid_t>(editor->processId()), number); }
  void startSecond(const QString& path = {}) {
    set.reset();
    set = std::make_unique<WindowSet>(recovery());
    set->start(path.isEmpty() ? QStringList() : QStringList{path});
  }
  void answer(const QString& text) {
    for (auto* button : first().notices().findChildren<QPushButton*>()) {
      if (!button->isHidden() && button->text() == text) return button->click();
    }
    QFAIL(qPrintable(text + QStringLiteral(" in: ") + notice()));
  }
  void addLink() {
    first().document().apply({QStringLiteral("Add link"),
                              [](const Mechanism& mechanism) {
                                return withLink(mechanism, CanvasPoint{90, 300});
                              },
                              0});
  }

 private slots:
  void initTestCase() {
    test::isolateSettings();
    QStandardPaths::setTestModeEnabled(true);
    applyTheme(*qApp, Theme::light);
  }
  void init() {
    test::clearSettings();
    folder = std::make_unique<QTemporaryDir>();
    QVERIFY(!writeDocument(withLink(emptyMechanism(), {300, 90}).value(), document()));
  }
  void cleanup() {
    set.reset();
    if (!editor) return;
    editor->kill();
    editor->waitForFinished();
    editor.reset();
  }

  void theSecondIsReadOnly_underAnyName_data() {
    QTest::addColumn<QString>("name");
    for (const char* name : {"one.geargraph", "soft.geargraph", "hard.geargraph", "sub/../one.geargraph"}) {
      QTest::newRow(name) << QString::fromLatin1(name);
    }
  }

  void theSecondIsReadOnly_underAnyName() {
    QFETCH(QString, name);
    namespace fs = std::filesystem;
    const fs::path native = folder->path().toStdString();
    fs::create_directory(native / "sub");
    fs::create_symlink("one.geargraph", native / "soft.geargraph");
    fs::create_hard_link(native / "one.geargraph", native / "hard.geargraph");
    startEditor();
    const QString path = folder->filePath(name);
    startSecond(path);
    QVERIFY(first().files().isReadOnly());
    QVERIFY(first().windowTitle().contains(QStringLiteral("(read-only)")));
    QVERIFY2(notice().contains(QStringLiteral("open in another window")), qPrintable(notice()));
    answer(QStringLiteral("Read-only"));
    addLink();  // can be tried out
    first().actions()[CommandId::save]->trigger();
    QVERIFY2(notice().contains(QStringLiteral("was not saved")), qPrintable(notice()));
    QVERIFY(first().isWindowModified());
    QCOMPARE(readDocument(document())->n(), 1);
    QVERIFY(first().saveDocument(folder->filePath(QStringLiteral("copy.geargraph"))));
    QVERIFY(!first().files().isReadOnly());
    QVERIFY(first().notices().current() == nullptr);
  }

  void theFirstIsShown_andTheSecondCloses() {
    startEditor();
    startSecond(document());
    waitUntilEditorAnswers();
    answer(QStringLiteral("Show that window"));
    QTRY_VERIFY_WITH_TIMEOUT(set->windows().empty(), kPatience);
    QCOMPARE(editor->state(), QProcess::Running);
  }

  void whatWasChangedInTheSecondStaysOpen() {
    startEditor();
    startSecond(document());
    addLink();
    waitUntilEditorAnswers();
    answer(QStringLiteral("Show that window"));
    QTest::qWait(OpenDocuments::kPatience);
    QCOMPARE(set->windows().size(), std::size_t{1});
    QVERIFY(first().isWindowModified());
  }

  void aFirstThatDoesNotAnswerIsTold() {
    startEditor();
    startSecond(document());
    signalEditor(SIGSTOP);
    answer(QStringLiteral("Show that window"));
    QTRY_VERIFY_WITH_TIMEOUT(notice().contains(QStringLiteral("does not answer")), kPatience);
    signalEditor(SIGCONT);
  }

  void whenTheFirstIsGoneTheSecondSaves() {
    startEditor();
    startSecond(document());
    addLink();
    editor->kill();
    QVERIFY(editor->waitForFinished());
    first().actions()[CommandId::save]->trigger();
    QVERIFY(!first().isWindowModified());
    QVERIFY(!first().files().isReadOnly());
    QCOMPARE(readDocument(document())->n(), 2);
  }

  void theListOfAKilledProgramIsRemoved() {
    startEditor();
    const QString stale = lists().front();
    editor->kill();
    QVERIFY(editor->waitForFinished());
    startSecond(document());
    QVERIFY(!first().files().isReadOnly());
    QVERIFY(first().notices().current() == nullptr);
    QCOMPARE(lists().size(), qsizetype{1});  // its own
    QVERIFY(!lists().contains(stale));
  }

  void whatItCrashedWithIsOfferedAtTheNextStart_data() {
    QTest::addColumn<int>("number");
    QTest::newRow("SIGSEGV") << SIGSEGV;
    QTest::newRow("SIGABRT") << SIGABRT;
  }

  void whatItCrashedWithIsOfferedAtTheNextStart() {
    QFETCH(int, number);
    startEditor();
    waitUntilEditorAnswers();
    signalEditor(number);
    QVERIFY(editor->waitForFinished(kPatience));
    QCOMPARE(editor->exitStatus(), QProcess::CrashExit);

    startSecond();
    QVERIFY2(notice().contains(QStringLiteral("GearGraph crashed")), qPrintable(notice()));
    answer(QStringLiteral("Show report"));
    QPointer<QDialog> dialog = first().findChild<QDialog*>(QStringLiteral("crashReport"));
    QVERIFY(!dialog.isNull());
    const QString report = dialog->findChild<QPlainTextEdit*>()->toPlainText();
    for (const char* told : {"Version: ", "Qt: ", "Platform: offscreen", "OpenGL: ", "Signal: SIG",
                             "Thread: main", "show mainWindow", "Backtrace:", "main"}) {
      QVERIFY2(report.contains(QLatin1String(told)), qPrintable(report));
    }
    QVERIFY2(report.contains(QLatin1String(QTest::currentDataTag())), qPrintable(report));
    QVERIFY2(!report.contains(QStringLiteral("one.geargraph")), qPrintable(report));
    QVERIFY2(!report.contains(folder->path()), qPrintable(report));
    QTest::keyClick(dialog.data(), Qt::Key_Return);  // closes, and deletes nothing
    QTRY_VERIFY(dialog.isNull());
    QCOMPARE(QDir(recovery()).entryList({QStringLiteral("crash-*")}, QDir::Files).size(), qsizetype{1});
    startSecond();
    QVERIFY2(first().notices().current() == nullptr, qPrintable(notice()));  // it has been seen
  }

  void aReportIsCopiedOrDeleted() {
    startEditor();
    signalEditor(SIGSEGV);
    QVERIFY(editor->waitForFinished(kPatience));
    startSecond();
    answer(QStringLiteral("Later"));
    startSecond();
    answer(QStringLiteral("Delete"));
    startSecond();
    QVERIFY2(first().notices().current() == nullptr, qPrintable(notice()));
    const auto left = QDir(recovery()).entryList({QStringLiteral("crash-*")}, QDir::Files);
    QVERIFY(left.isEmpty());
  }

  void aboutCopiesTheDetails() {
    startSecond();
    first().actions()[CommandId::about]->trigger();
    auto* about = first().findChild<QMessageBox*>(QStringLiteral("about"));
    QVERIFY(about != nullptr);
    for (auto* button : about->findChildren<QPushButton*>()) {
      if (button->text() == QStringLiteral("Copy details")) button->click();
    }
    QVERIFY(about->isVisible());
    const QString copied = QApplication::clipboard()->text();
    for (const char* told : {"Version: ", "Qt: ", "System: ", "Platform: ", "OpenGL: "}) {
      QVERIFY2(copied.contains(QLatin1String(told)), qPrintable(copied));
    }
  }
};

}  // namespace geargraph

QTEST_MAIN(geargraph::TwoProgramsTest)
#include "test_two_programs.moc"

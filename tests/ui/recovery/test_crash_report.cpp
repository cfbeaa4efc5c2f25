#include <sys/resource.h>

#include <QAction>
#include <QApplication>
#include <QDir>
#include <QFile>
#include <QLineEdit>
#include <QMainWindow>
#include <QMenuBar>
#include <QProcess>
#include <QTemporaryDir>
#include <QTest>
#include <csignal>
#include <stdexcept>
#include <thread>

#include "core/foundations/base/contract.h"
#include "ui/recovery/action_log.h"
#include "ui/recovery/action_recorder.h"
#include "ui/recovery/crash_handler.h"
#include "ui/recovery/crash_report.h"

namespace geargraph {
namespace {

/// The names of its functions are looked for in the backtraces, so nothing is inlined.
[[gnu::noinline]] int overflowStack(volatile int* depth) {
  volatile char room[4096] = {};
  room[0] = 1;
  if (*depth < 0) return 0;  // never, but the compiler cannot know
  *depth = room[0] + overflowStack(depth);
  return *depth;
}

[[gnu::noinline]] void throwSecret() {
  throw std::runtime_error("secret of a document");
}

[[gnu::noinline]] void crashBy(const QString& kind) {
  volatile int zero = 0;
  if (kind == QStringLiteral("memory"))
    *reinterpret_cast<volatile int*>(static_cast<std::intptr_t>(zero)) = 1;
  if (kind == QStringLiteral("contract")) GEARGRAPH_REQUIRE(zero == 1);
  if (kind == QStringLiteral("stack")) overflowStack(&zero);
  if (kind == QStringLiteral("exception")) {
    []() noexcept { throwSecret(); }();
  }
  if (kind == QStringLiteral("thread")) {
    std::thread([] { crashBy(QStringLiteral("memory")); }).join();
  }
  const int number = kind.toInt();
  if (number > 0) std::raise(number);
}

/// The program that crashes: a window, some gestures, and then.
int crashingProgram(const QString& folder, const QString& kind) {
  const rlimit noCore{0, 0};
  ::setrlimit(RLIMIT_CORE, &noCore);
  installCrashHandler(QFile::encodeName(folder).toStdString(), "Version: 1.2.3\n");
  const ActionRecorder recorder(nullptr);
  QMainWindow window;
  window.setObjectName(QStringLiteral("mainWindow"));
  auto* field = new QLineEdit(&window);
  field->setObjectName(QStringLiteral("search"));
  window.setCentralWidget(field);
  QAction* save =
      window.menuBar()->addMenu(QStringLiteral("File"))->addAction(QStringLiteral("secret.geargraph"));
  save->setObjectName(QStringLiteral("file.save"));
  window.show();
  QTest::mouseClick(field, Qt::LeftButton);
  QTest::keyClicks(field, QStringLiteral("secret"));
  QTest::keyClick(field, Qt::Key_Escape);
  save->trigger();
  crashBy(kind);
  return 0;
}

}  // namespace

/// A crash leaves a report that helps, and that tells nothing of the user.
class CrashReportTest : public QObject {
  Q_OBJECT

  std::unique_ptr<QTemporaryDir> folder;

  [[nodiscard]] QString reports() const { return folder->filePath(QStringLiteral("recovery")); }
  /// What a program reports that crashes in this way.
  QString reportOf(const QString& kind) {
    QProcess program;
    QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
    environment.insert(QStringLiteral("ASAN_OPTIONS"), QStringLiteral(GEARGRAPH_NO_SANITIZER_SIGNALS));
    program.setProcessEnvironment(environment);
    program.start(QCoreApplication::applicationFilePath(), {QStringLiteral("--crash"), reports(), kind});
    if (!program.waitForFinished(120'000)) return {};
    if (program.exitStatus() != QProcess::CrashExit) return {};  // it ends as without a handler
    const auto found = newCrashReports(reports());
    return found.size() == 1 ? found.front().text : QString();
  }

 private slots:
  void init() { folder = std::make_unique<QTemporaryDir>(); }

  void everyCrashIsReported_data() {
    QTest::addColumn<QString>("kind");
    QTest::addColumn<QStringList>("told");
    const QString main = QStringLiteral("Thread: main");
    const QString place = QStringLiteral("crashBy(QString const&)");
    const auto row = [](const char* kind, const QStringList& told) {
      QTest::newRow(kind) << QString::fromLatin1(kind) << told;
    };
    row("memory", {QStringLiteral("Signal: SIGSEGV"), main, place});
    row("contract", {QStringLiteral("Signal: SIGABRT"), main, place,
                     QStringLiteral("Broken contract: test_crash_report.cpp:"), QStringLiteral("zero == 1")});
    row("exception",
        {QStringLiteral("Signal: SIGABRT"), main, QStringLiteral("Uncaught exception: std::runtime_error")});
    row("stack", {QStringLiteral("Signal: SIGSEGV"), main, QStringLiteral("overflowStack(int volatile*)")});
    row("thread", {QStringLiteral("Signal: SIGSEGV"), QStringLiteral("Thread: test_crash"), place});
    for (const auto& [number, name] : {std::pair{SIGBUS, "SIGBUS"}, std::pair{SIGILL, "SIGILL"},
                                       std::pair{SIGFPE, "SIGFPE"}, std::pair{SIGABRT, "SIGABRT"}}) {
      row(std::to_string(number).c_str(),
          {QStringLiteral("Signal: ") + QString::fromLatin1(name), main, place});
    }
  }

  void everyCrashIsReported() {
    QFETCH(QString, kind);
    QFETCH(QStringList, told);
    const QString report = reportOf(kind);
    told << QStringLiteral("GearGraph crash report") << QStringLiteral("Version: 1.2.3")
         << QStringLiteral("UTC") << QStringLiteral("press left on search") << QStringLiteral("key (text) x6")
         << QStringLiteral("key Esc") << QStringLiteral("command file.save");
    for (const QString& each : told) QVERIFY2(report.contains(each), qPrintable(each + "\n" + report));
    QVERIFY2(!report.contains(QStringLiteral("secret")), qPrintable(report));
    QVERIFY2(!report.contains(folder->path()), qPrintable(report));
  }

  void withoutACrashThereIsNoReport() {
    QVERIFY(reportOf(QStringLiteral("none")).isEmpty());
    QVERIFY(newCrashReports(reports()).isEmpty());
  }

  void aReportThatWasSeenIsKept_butNotOffered() {
    for (int i = 0; i < kKeptReports + 2; ++i) {
      QVERIFY(QDir().mkpath(reports()));
      QFile file(QDir(reports()).filePath(QStringLiteral("crash-%1-1.txt").arg(i)));
      QVERIFY(file.open(QIODevice::WriteOnly) && file.write("GearGraph crash report\n") > 0);
    }
    const auto all = newCrashReports(reports());
    QCOMPARE(all.size(), kKeptReports + 2);
    for (const CrashReport& each : all) keepCrashReport(each);
    QVERIFY(newCrashReports(reports()).isEmpty());
    QCOMPARE(QDir(reports()).entryList(QDir::Files).size(), qsizetype{kKeptReports});
  }

  void namesAreSpelledOut_otherLinesStay() {
    const QByteArray written =
        "Signal: x\n  #00 _ZN9geargraph4nextEi+0x10 at a.cpp:3\n  #01 main+0x2\n  #02 _Z\n";
    QCOMPARE(
        readableReport(written),
        QStringLiteral("Signal: x\n  #00 geargraph::next(int)+0x10 at a.cpp:3\n  #01 main+0x2\n  #02 _Z\n"));
  }

  void theLogKeepsTheLastActions() {
    ActionLog log;
    for (std::size_t i = 0; i < 3 * ActionLog::kCapacity; ++i) {
      log.note("action " + std::to_string(i));
      log.note("action " + std::to_string(i));
    }
    log.note(std::string(500, 'x'));
    std::vector<ActionLog::Entry> entries;
    log.visit([&](const ActionLog::Entry& entry) { entries.push_back(entry); });
    QCOMPARE(entries.size(), ActionLog::kCapacity);
    QCOMPARE(std::string(entries.back().name.data()), std::string(ActionLog::kMaxNameLength, 'x'));
    const std::string newest = "action " + std::to_string(3 * ActionLog::kCapacity - 1);
    QCOMPARE(std::string(entries[ActionLog::kCapacity - 2].name.data()), newest);
    QCOMPARE(entries.front().count, 2U);
  }
};

}  // namespace geargraph

int main(int argc, char** argv) {
  QApplication application(argc, argv);
  const QStringList arguments = QApplication::arguments();
  if (arguments.size() == 4 && arguments.at(1) == QStringLiteral("--crash")) {
    return geargraph::crashingProgram(arguments.at(2), arguments.at(3));
  }
  geargraph::CrashReportTest test;
  return QTest::qExec(&test, argc, argv);
}

#include "test_crash_report.moc"

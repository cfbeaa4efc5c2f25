#include <fcntl.h>
#include <unistd.h>

#include <QDir>
#include <QFileInfo>
#include <QProcess>
#include <QTemporaryDir>
#include <QTest>
#include <map>

#include "core/foundations/sandbox/sandbox.h"

using namespace geargraph;

namespace {

using Outcomes = std::map<QByteArray, QByteArray>;  ///< per attempt: "allowed" or the name of the error

constexpr int kInherited = 7;  // the descriptor that attempts.cpp looks for

}  // namespace

/// What code of an attacker can do in the process that reads a file of unknown origin.
class SandboxTest : public QObject {
  Q_OBJECT

  QTemporaryDir folder;

  /// Runs the attempts; empty where the report is not whole.
  static Outcomes outcomesOf(QProcess& process, const QByteArray& input = {}) {
    process.setProcessChannelMode(QProcess::ForwardedErrorChannel);
    process.start();
    process.write(input);
    process.closeWriteChannel();
    if (!process.waitForFinished() || process.exitStatus() != QProcess::NormalExit || process.exitCode() != 0)
      return {};
    QList<QByteArray> lines = process.readAllStandardOutput().split('\n');
    if (lines.size() < 2 || lines[lines.size() - 2] != "end") return {};
    Outcomes outcomes;
    for (const QByteArray& line : lines.mid(0, lines.size() - 2)) {
      const auto gap = line.indexOf(' ');
      outcomes[line.left(gap)] = line.mid(gap + 1);
    }
    return outcomes;
  }
  Outcomes payload(const char* walls) const {
    QProcess process;
    process.setProgram(QStringLiteral(GEARGRAPH_PAYLOAD));
    process.setArguments({QLatin1String(walls), folder.path()});
    return outcomesOf(process);
  }
  static void verifyAllDenied(const Outcomes& outcomes) {
    QVERIFY(outcomes.size() > 35);
    for (const auto& [attempt, outcome] : outcomes) {
      const bool isWanted = attempt == "plain-memory";
      QVERIFY2(outcome == (isWanted ? "allowed" : "EPERM"), (attempt + ": " + outcome).constData());
    }
  }

 private slots:
  void initTestCase() {
    // A descriptor that a careless program leaves open for its children.
    const QByteArray path = folder.filePath(QStringLiteral("secret")).toLocal8Bit();
    const int secret = ::open(path.constData(), O_RDWR | O_CREAT | O_CLOEXEC, 0600);
    QVERIFY(secret >= 0 && ::write(secret, "secret", 6) == 6);
    QCOMPARE(::dup2(secret, kInherited), kInherited);
  }
  void cleanup() const {  // no attempt left anything
    QCOMPARE(QDir(folder.path()).entryList(QDir::AllEntries | QDir::System | QDir::NoDotAndDotDot),
             QStringList{QStringLiteral("secret")});
  }

  void withoutASandboxTheAttemptsSucceed() {
    Outcomes outcomes = payload("none");
    for (const char* attempt : {"open",
                                "openat",
                                "list",
                                "create",
                                "truncate",
                                "rename",
                                "unlink",
                                "mkdir",
                                "symlink",
                                "read-inherited",
                                "write-inherited",
                                "fork",
                                "clone",
                                "execve",
                                "kill-parent",
                                "prctl",
                                "socket",
                                "socket-local",
                                "connect-local",
                                "plain-memory",
                                "make-executable",
                                "executable-memory"})
      QVERIFY2(outcomes[attempt] == "allowed", (QByteArray(attempt) + ": " + outcomes[attempt]).constData());
  }

  void everyAttemptIsDenied() {
    const qint64 size = QFileInfo(folder.filePath(QStringLiteral("secret"))).size();
    verifyAllDenied(payload("all"));
    QCOMPARE(QFileInfo(folder.filePath(QStringLiteral("secret"))).size(), size);
  }

  void theFilterOfSystemCallsDeniesByItself() { verifyAllDenied(payload("filter")); }

  void landlockDeniesFilesByItself() {
    Outcomes outcomes = payload("landlock");
    const QByteArray denied = landlockVersion() > 0 ? "EACCES" : "allowed";
    for (const char* attempt : {"open", "openat", "list", "create", "mkdir", "symlink"})
      QVERIFY2(outcomes[attempt] == denied, (QByteArray(attempt) + ": " + outcomes[attempt]).constData());
    if (landlockVersion() >= 6) QCOMPARE(outcomes["kill-parent"], QByteArray("EPERM"));
  }

  void theReaderOfMeshesIsConfined() {
    QProcess process;
    process.setProgram(QStringLiteral(GEARGRAPH_MESH_READER));
    process.setArguments({"stl", "1000000", "1000", "1073741824", "10"});
    QProcessEnvironment environment;
    environment.insert(QStringLiteral("LD_PRELOAD"), QStringLiteral(GEARGRAPH_HOSTILE_IMPORTER));
    environment.insert(QStringLiteral("ASAN_OPTIONS"), QStringLiteral("verify_asan_link_order=0"));
    process.setProcessEnvironment(environment);
    verifyAllDenied(outcomesOf(process, folder.path().toLocal8Bit()));
  }
};

QTEST_GUILESS_MAIN(SandboxTest)
#include "test_sandbox.moc"

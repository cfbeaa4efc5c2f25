#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>

#include <QTemporaryDir>
#include <QTest>
#include <csignal>

#include "core/foundations/files/file.h"
#include "tests/core/mechanism/document_format/support.h"

using namespace geargraph;
using geargraph::test::contentsOf;

namespace fs = std::filesystem;

/// A folder of its own for each test.
class FileTest : public QObject {
  Q_OBJECT

 private slots:
  void init() { m_folder = std::make_unique<QTemporaryDir>(); }

  void whatIsWritten_isRead() {
    const std::string bytes = std::string("a\0b\n", 4) + std::string(1'000'000, 'x');
    QVERIFY(!writeFile(path("f"), bytes));
    QVERIFY(std::get<std::string>(readFile(path("f"), 2'000'000)) == bytes);
    QCOMPARE(std::get<std::string>(readFile(path("f"), 10)).size(), std::size_t{11});
    QCOMPARE(names(), QStringList{"f"});
  }

  void beforeCommit_theOldFileIsThere_andAbandoningKeepsIt() {
    QVERIFY(!writeFile(path("f"), "old"));
    {
      AtomicFile file(path("f"));
      file.write("new");
      QCOMPARE(contentsOf(path("f")), std::string("old"));
      QCOMPARE(names().size(), 2);
    }
    QCOMPARE(contentsOf(path("f")), std::string("old"));
    QCOMPARE(names(), QStringList{"f"});
  }

  /// A limit on file sizes stands for the full disk.
  void aFailingWrite_leavesTheOldFileUntouched() {
    QVERIFY(!writeFile(path("f"), "old"));
    rlimit before{};
    getrlimit(RLIMIT_FSIZE, &before);
    const rlimit small{1000, before.rlim_max};
    const auto handler = std::signal(SIGXFSZ, SIG_IGN);
    setrlimit(RLIMIT_FSIZE, &small);
    const auto error = writeFile(path("f"), std::string(5000, 'x'));
    setrlimit(RLIMIT_FSIZE, &before);
    std::signal(SIGXFSZ, handler);
    QVERIFY(error.has_value());
    QVERIFY(error->message.find("could not be written") != std::string::npos);
    QCOMPARE(contentsOf(path("f")), std::string("old"));
    QCOMPARE(names(), QStringList{"f"});
  }

  void permissionsAreKept_andNewFilesFollowTheUmask() {
    QVERIFY(!writeFile(path("f"), "old"));
    fs::permissions(path("f"), fs::perms(0751));
    QVERIFY(!writeFile(path("f"), "new"));
    QCOMPARE(static_cast<int>(fs::status(path("f")).permissions()), 0751);
    const mode_t before = ::umask(027);
    QVERIFY(!writeFile(path("g"), "new"));
    ::umask(before);
    QCOMPARE(static_cast<int>(fs::status(path("g")).permissions()), 0640);
  }

  void symbolicLinksStay_andWhatTheyPointToIsReplaced() {
    fs::create_directory(path("sub"));
    QVERIFY(!writeFile(path("sub/target"), "old"));
    fs::create_symlink("sub/target", path("one"));
    fs::create_symlink("one", path("two"));
    QVERIFY(!writeFile(path("two"), "new"));
    QVERIFY(fs::is_symlink(path("one")) && fs::is_symlink(path("two")));
    QCOMPARE(contentsOf(path("sub/target")), std::string("new"));
    fs::create_symlink("sub/later", path("three"));  // points to nothing yet
    QVERIFY(!writeFile(path("three"), "made"));
    QCOMPARE(contentsOf(path("sub/later")), std::string("made"));
    fs::create_symlink("loop", path("loop"));
    QVERIFY(writeFile(path("loop"), "x").has_value());
  }

  void devicesAreWrittenTo_notReplaced() {
    QVERIFY(!writeFile("/dev/null", "x"));
    QVERIFY(fs::is_character_file("/dev/null"));
    QVERIFY(writeFile("/dev/full", "x")->message.find("No space left") != std::string::npos);
  }

  void errorsNameTheFile() {
    const auto message = [](const fs::path& where) {
      return QString::fromStdString(writeFile(where, "x")->message);
    };
    QVERIFY(message(path("no/such/folder")).endsWith("could not be written: No such file or directory."));
    QVERIFY(message(m_folder->path().toStdString()).contains("it is a folder"));
    QVERIFY(!writeFile(path("f"), "x"));
    QVERIFY(message(path("f/g")).contains("Not a directory"));
    QVERIFY(
        message("/proc/geargraph").contains("could not be written"));  // no folder to write to, even for root
    QVERIFY(std::get<FileError>(readFile(path("none"), 10)).message.find("none") != std::string::npos);
    QVERIFY(std::holds_alternative<FileError>(readFile(m_folder->path().toStdString(), 10)));
  }

 private:
  [[nodiscard]] std::string path(const char* name) const { return m_folder->filePath(name).toStdString(); }
  [[nodiscard]] QStringList names() const {
    return QDir(m_folder->path()).entryList(QDir::Files | QDir::Hidden | QDir::NoDotAndDotDot, QDir::Name);
  }

  std::unique_ptr<QTemporaryDir> m_folder;
};

QTEST_APPLESS_MAIN(FileTest)
#include "test_file.moc"

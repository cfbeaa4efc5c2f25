#include <fcntl.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <sys/xattr.h>
#include <unistd.h>

#include <QTemporaryDir>
#include <QTest>
#include <csignal>

#include "core/foundations/files/file.h"
#include "core/foundations/files/file_identity.h"
#include "tests/core/mechanism/document_format/support.h"

using namespace geargraph;
using geargraph::test::contentsOf;

namespace fs = std::filesystem;

namespace {

/// Bytes of one letter: any mixture of two of them is recognised.
bool isWhole(const std::string& bytes) {
  return !bytes.empty() && bytes.size() == (bytes[0] == 'a' ? 3'000'000U : 4'000'000U) &&
         bytes.find_first_not_of(bytes[0]) == std::string::npos;
}

}  // namespace

/// What a file keeps when it is written again: its other names, owner and attributes.
class FileLinksTest : public QObject {
  Q_OBJECT

 private slots:
  void init() { m_folder = std::make_unique<QTemporaryDir>(); }

  void hardLinksStay_whateverTheSize() {
    QVERIFY(!writeFile(path("f"), "old"));
    fs::create_hard_link(path("f"), path("g"));
    fs::permissions(path("f"), fs::perms(0640));
    for (const std::string& bytes :
         {std::string("much longer than before"), std::string("n"), std::string()}) {
      QVERIFY(!writeFile(path("g"), bytes));
      QCOMPARE(contentsOf(path("f")), bytes);
      QCOMPARE(contentsOf(path("g")), bytes);
    }
    QVERIFY(isSameFile(path("f"), path("g")));
    QCOMPARE(static_cast<int>(fs::status(path("f")).permissions()), 0640);
    QCOMPARE(names(), (QStringList{"f", "g"}));
  }

  void aHardLinkBehindASymbolicLinkStays() {
    QVERIFY(!writeFile(path("f"), "old"));
    fs::create_hard_link(path("f"), path("g"));
    fs::create_symlink("g", path("s"));
    QVERIFY(!writeFile(path("s"), "new"));
    QVERIFY(fs::is_symlink(path("s")));
    QCOMPARE(contentsOf(path("f")), std::string("new"));
  }

  /// A limit on file sizes stands for the full disk.
  void aFailingWriteInPlace_leavesTheOldBytes() {
    const std::string old(2000, 'o');
    QVERIFY(!writeFile(path("f"), old));
    fs::create_hard_link(path("f"), path("g"));
    AtomicFile file(path("g"));
    file.write(std::string(5000, 'x'));
    rlimit before{};
    getrlimit(RLIMIT_FSIZE, &before);
    const rlimit small{3000, before.rlim_max};
    const auto handler = std::signal(SIGXFSZ, SIG_IGN);
    setrlimit(RLIMIT_FSIZE, &small);
    const auto error = file.commit();
    setrlimit(RLIMIT_FSIZE, &before);
    std::signal(SIGXFSZ, handler);
    QVERIFY(error.has_value());
    QCOMPARE(contentsOf(path("f")), old);
    QCOMPARE(names(), (QStringList{"f", "g"}));
  }

  void aFileThatGoesWhileItIsWritten_isMadeAnew() {
    QVERIFY(!writeFile(path("f"), "old"));
    fs::create_hard_link(path("f"), path("g"));
    fs::permissions(path("f"), fs::perms(0644));
    AtomicFile file(path("g"));
    file.write("new");
    fs::remove(path("g"));
    QVERIFY(!file.commit());
    QCOMPARE(contentsOf(path("g")), std::string("new"));
    QCOMPARE(contentsOf(path("f")), std::string("old"));
    QCOMPARE(static_cast<int>(fs::status(path("g")).permissions()), 0644);
  }

  /// kill -9 while a hard link is written: the file or the copy beside it is whole.
  void aKilledWriteInPlace_leavesAWholeCopy() {
    const std::string a(3'000'000, 'a');
    const std::string b(4'000'000, 'b');
    for (int round = 0; round < 20; ++round) {
      init();
      QVERIFY(!writeFile(path("f"), a));
      fs::create_hard_link(path("f"), path("g"));
      const pid_t child = ::fork();
      if (child == 0) {
        for (int i = 0;; ++i) {
          if (writeFile(path("g"), i % 2 == 0 ? b : a)) ::_exit(1);
        }
      }
      ::usleep(static_cast<useconds_t>(2'000 + 977 * round));
      ::kill(child, SIGKILL);
      int status = 0;
      QCOMPARE(::waitpid(child, &status, 0), child);
      QVERIFY(WIFSIGNALED(status));
      QVERIFY(isSameFile(path("f"), path("g")));
      const auto copies = interruptedWrites(path("g"));
      if (isWhole(contentsOf(path("g")))) continue;
      QCOMPARE(copies.size(), std::size_t{1});
      QVERIFY(isWhole(contentsOf(copies.front().string())));
    }
  }

  void copiesOfLivingWritersAreNotInterrupted() {
    const std::string name = ".f." + std::to_string(::getpid()) + "-0.saving";
    QVERIFY(!writeFile(path("f"), "x"));
    QVERIFY(!writeFile(path(name.c_str()), "x"));
    QVERIFY(interruptedWrites(path("f")).empty());
    QVERIFY(!writeFile(path(".f.999999999-7.saving"), "y"));
    QCOMPARE(interruptedWrites(path("f")).size(), std::size_t{1});
    QVERIFY(interruptedWrites(path("other")).empty());
    QVERIFY(interruptedWrites(path("no/such/folder")).empty());
  }

  void extendedAttributesAreKept() {
    QVERIFY(!writeFile(path("f"), "old"));
    if (::setxattr(path("f").c_str(), "user.origin", "course", 6, 0) != 0) {
      QCOMPARE(errno, EOPNOTSUPP);  // the file system of the temporary folder has none
    }
    QVERIFY(!writeFile(path("f"), "new"));
    std::string value(16, '\0');
    const ssize_t size = ::getxattr(path("f").c_str(), "user.origin", value.data(), value.size());
    if (size < 0) {
      QCOMPARE(errno, EOPNOTSUPP);
    } else {
      QCOMPARE(value.substr(0, static_cast<std::size_t>(size)), std::string("course"));
    }
  }

  /// Only root can set the stage; for another user the file is their own, and this checks that it stays so.
  void theOwnerIsKept_alsoWhereFilesMayNotBeGivenAway() {
    constexpr uid_t kNobody = 65534;
    const bool isRoot = ::geteuid() == 0;
    QVERIFY(!writeFile(path("f"), "old"));
    if (isRoot) {
      fs::permissions(m_folder->path().toStdString(), fs::perms(0777));
      fs::permissions(path("f"), fs::perms(0666));
      QCOMPARE(::seteuid(kNobody), 0);
    }
    const auto error = writeFile(path("f"), "written by another user");
    if (isRoot) QCOMPARE(::seteuid(0), 0);
    QVERIFY2(!error, error ? error->message.c_str() : "");
    struct stat status {};
    QCOMPARE(::stat(path("f").c_str(), &status), 0);
    QCOMPARE(status.st_uid, ::geteuid());
    QCOMPARE(contentsOf(path("f")), std::string("written by another user"));
    QCOMPARE(names(), QStringList{"f"});
  }

  void oneFileIsKnownByAllItsNames() {
    fs::create_directory(path("sub"));
    QVERIFY(!writeFile(path("sub/f"), "x"));
    fs::create_hard_link(path("sub/f"), path("hard"));
    fs::create_symlink("sub/f", path("soft"));
    fs::create_directory_symlink("sub", path("folder"));
    QVERIFY(!writeFile(path("other"), "x"));
    for (const char* name : {"sub/f", "./sub/../sub/./f", "hard", "soft", "folder/f"}) {
      QVERIFY2(isSameFile(path("sub/f"), path(name)), name);
    }
    QVERIFY(!isSameFile(path("sub/f"), path("other")));
    // Not there yet.
    fs::create_symlink("sub/later", path("dangling"));
    QVERIFY(isSameFile(path("sub/later"), path("folder/./later")));
    QVERIFY(isSameFile(path("sub/later"), path("dangling")));
    QVERIFY(!isSameFile(path("sub/later"), path("sub/f")));
    QVERIFY(!isSameFile(path("none"), path("never")));
    QVERIFY(!isSameFile({}, path("sub/f")));
  }

 private:
  [[nodiscard]] std::string path(const char* name) const { return m_folder->filePath(name).toStdString(); }
  [[nodiscard]] QStringList names() const {
    return QDir(m_folder->path()).entryList(QDir::Files | QDir::Hidden | QDir::NoDotAndDotDot, QDir::Name);
  }

  std::unique_ptr<QTemporaryDir> m_folder;
};

QTEST_APPLESS_MAIN(FileLinksTest)
#include "test_file_links.moc"

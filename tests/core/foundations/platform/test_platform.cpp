// The layer that knows the system, and files through it. Compiled twice: with the calls of Linux, and with
// the portable fallback.

#include <QTemporaryDir>
#include <QTest>
#include <filesystem>
#include <thread>

#include "core/foundations/files/file.h"
#include "core/foundations/files/file_identity.h"
#include "core/foundations/files/folder.h"
#include "core/foundations/platform/child_process.h"
#include "core/foundations/platform/open_file.h"
#include "core/foundations/platform/system.h"

using namespace geargraph;
namespace fs = std::filesystem;

class PlatformTest : public QObject {
  Q_OBJECT

 private:
  using Deadline = decltype(ChildProgram::deadline);
  static constexpr Deadline kNever = Deadline::max();
  static constexpr Deadline kLongAgo = Deadline::min();

  std::unique_ptr<QTemporaryDir> m_folder;
  [[nodiscard]] fs::path place(const char* name) const {
    return fs::path(m_folder->path().toStdString()) / name;
  }
  static std::string contentsOf(const fs::path& path) {
    const auto bytes = readFile(path, 1'000'000);
    return std::holds_alternative<std::string>(bytes) ? std::get<std::string>(bytes) : "none";
  }
  [[nodiscard]] std::size_t filesInFolder() const {
    const fs::directory_iterator each(m_folder->path().toStdString());
    return static_cast<std::size_t>(std::distance(begin(each), end(each)));
  }

 private slots:
  void init() { m_folder = std::make_unique<QTemporaryDir>(); }

  void itIsTheOneThatThisProgramTests() { QCOMPARE(platformName(), std::string_view(PLATFORM)); }

  void aProcessHasANumberOfItsOwn() {
    QVERIFY(processId() > 0);
    QCOMPARE(processId(), processId());
    QVERIFY(isProcessRunning(processId()));
    QVERIFY(!isProcessRunning(0) && !isProcessRunning(-1));
    std::thread([] { lowerThreadPriority(); }).join();
  }

  void aNewFileIsWrittenAndReadBack() {
    std::error_code error = std::make_error_code(std::errc::io_error);
    OpenFile file(place("f"), OpenMode::createNew, error);
    QVERIFY(!error && file.isOpen());
    file.write("one ", error);
    file.write("two", error);
    QCOMPARE(file.contents(error), std::string("one two"));
    file.write("!", error);  // where the last one ended
    file.sync(error);
    QVERIFY(!error);
    QCOMPARE(file.contents(error), std::string("one two!"));
    file.close(error);
    QVERIFY(!error && !file.isOpen());
    QCOMPARE(contentsOf(place("f")), std::string("one two!"));
    OpenFile again(place("f"), OpenMode::createNew, error);
    QVERIFY(error == std::errc::file_exists && !again.isOpen());
  }

  void contentsAreReplacedLongerAndShorter() {
    QVERIFY(!writeFile(place("f"), "a long text"));
    std::error_code error;
    OpenFile file(place("f"), OpenMode::change, error);
    QVERIFY(!error);
    for (const std::string& text : {std::string("short"), std::string(100'000, 'x'), std::string()}) {
      file.reserve(0, text.size() + 1, error);
      file.setContents(text, error);
      QVERIFY(!error);
      QCOMPARE(file.contents(error), text);
      QCOMPARE(contentsOf(place("f")), text);
    }
    file.setContents("abc", error);
    file.truncate(1, error);
    QCOMPARE(contentsOf(place("f")), std::string("a"));
  }

  void failuresAreReported() {
    std::error_code error;
    OpenFile none(place("none"), OpenMode::read, error);
    QVERIFY(error == std::errc::no_such_file_or_directory && !none.isOpen());
    OpenFile nowhere(place("none") / "f", OpenMode::createNew, error);
    QVERIFY(error == std::errc::no_such_file_or_directory);
    QVERIFY(!isWritable(place("none"), error) && error);
    QVERIFY(!attributesOf(place("none")));
    QVERIFY(!writeFile(place("f"), "text"));
    QVERIFY(isWritable(place("f"), error) && !error);
    OpenFile file(place("f"), OpenMode::read, error);
    QVERIFY(!error);
    file.write("more", error);
    QVERIFY(error);
    QCOMPARE(contentsOf(place("f")), std::string("text"));
    const auto folder = readFile(place(""), 10);
    QVERIFY(std::holds_alternative<FileError>(folder));
    QVERIFY(std::get<FileError>(folder).message.find("could not be read: ") != std::string::npos);
  }

  void whatIsFullIsReported() {
    if (!fs::exists("/dev/full")) QSKIP("The system has no /dev/full.");
    QVERIFY(writeFile("/dev/full", "bytes"));
    QVERIFY(!writeFile("/dev/null", "bytes"));
  }

  void aChangeShowsInTheStamp() {
    QVERIFY(!fileStamp(place("f")));
    QVERIFY(!writeFile(place("f"), "old"));
    const auto before = fileStamp(place("f"));
    QVERIFY(before && before->size == 3);
    const auto again = fileStamp(place("f"));
    QVERIFY(again->modified == before->modified && again->changed == before->changed);
    fs::last_write_time(place("f"), fs::last_write_time(place("f")) - std::chrono::nanoseconds(2'000));
    QCOMPARE(before->modified - fileStamp(place("f"))->modified, std::int64_t{2'000});
    QCOMPARE(before->numbers.has_value(), platformName() == "Linux");
  }

  void aFileIsWrittenWholeOrNotAtAll() {
    QVERIFY(!writeFile(place("f"), "old"));
    {
      AtomicFile file(place("f"));
      file.write("new");
      QCOMPARE(contentsOf(place("f")), std::string("old"));
    }
    QCOMPARE(contentsOf(place("f")), std::string("old"));
    QCOMPARE(filesInFolder(), std::size_t{1});
    fs::permissions(place("f"), fs::perms::owner_all);
    AtomicFile file(place("f"));
    file.write(std::string(300'000, 'n'));
    QVERIFY(!file.commit());
    QCOMPARE(contentsOf(place("f")), std::string(300'000, 'n'));
    QVERIFY(fs::status(place("f")).permissions() == fs::perms::owner_all);
    QCOMPARE(filesInFolder(), std::size_t{1});
    const auto rejected = writeFile(place(""), "x");
    QVERIFY(rejected && rejected->message.find("it is a folder") != std::string::npos);
  }

  void symbolicAndHardLinksStay() {
    QVERIFY(!writeFile(place("f"), "old"));
    fs::create_symlink("f", place("symbolic"));
    fs::create_hard_link(place("f"), place("hard"));
    QVERIFY(isSameFile(place("f"), place("symbolic")) && isSameFile(place("f"), place("hard")));
    QVERIFY(!isSameFile(place("f"), place("g")) && isSameFile(place("g"), place("./g")));
    for (const char* const name : {"f", "symbolic", "hard"}) {
      QVERIFY(!writeFile(place(name), name));
      QCOMPARE(contentsOf(place("f")), std::string(name));
      QCOMPARE(contentsOf(place("hard")), std::string(name));
      QVERIFY(fs::is_symlink(place("symbolic")));
      QCOMPARE(fs::hard_link_count(place("f")), std::uintmax_t{2});
    }
    QCOMPARE(filesInFolder(), std::size_t{3});
  }

  void leftCopiesOfWritersThatAreGoneAreFound() {
    QVERIFY(!writeFile(place("f"), "mixture"));
    QVERIFY(
        !writeFile(place((".f." + std::to_string(processId()) + "-0.saving").c_str()), "of a living one"));
    QVERIFY(interruptedWrites(place("f")).empty());
    QVERIFY(!writeFile(place(".f.0-0.saving"), "whole"));
    QCOMPARE(interruptedWrites(place("f")), std::vector<fs::path>{place(".f.0-0.saving")});
  }

  void aProgramReadsAFileAndAnswers() {
    QVERIFY(!writeFile(place("f"), "what the program reads"));
    ChildProgram child{"/bin/cat", {"-"}, place("f"), 100, 9, 100};
    child.deadline = kNever;
    const ChildResult copied = runChild(child, {});
    QCOMPARE(confinesChildren(), platformName() == "Linux");
    QVERIFY(copied.end == ChildEnd::exited && copied.status == 0);
    QCOMPARE(copied.output, std::string("what the "));
    child.mostInput = 21;
    QVERIFY(runChild(child, {}).end == ChildEnd::inputTooLarge);
    child.input = place("");
    QVERIFY(runChild(child, {}).end == ChildEnd::inputNoFile);
    child.input = place("none");
    QVERIFY(runChild(child, {}).end == ChildEnd::inputMissing);
    child = {place("none"), {}, place("f"), 100, 100, 100, child.deadline};
    QVERIFY(runChild(child, {}).end == ChildEnd::notStarted);
    child = {"/bin/sleep", {"1000"}, place("f"), 100, 100, 100, kLongAgo};
    QVERIFY(runChild(child, {}).end == ChildEnd::outOfTime);
    std::stop_source stop;
    stop.request_stop();
    child.deadline = kNever;
    QVERIFY(runChild(child, stop.get_token()).end == ChildEnd::stopped);
  }

  void aProgramIsEndedWhole() {
    QVERIFY(!writeFile(place("f"), "input"));
    ChildProgram child{"/bin/sh", {"-c", "echo out; echo err >&2; exit 7"}, place("f"), 100, 100, 100};
    child.deadline = kNever;
    const ChildResult ended = runChild(child, {});
    QVERIFY(ended.end == ChildEnd::exited && ended.status == 7);
    QCOMPARE(ended.output, std::string("out\n"));
    QCOMPARE(ended.errors, std::string("err\n"));
    child.words[1] = "kill -SEGV $$";
    QVERIFY(runChild(child, {}).end == ChildEnd::crashed);
    child.words[1] = "exec /bin/sleep 1000";
    std::stop_source stop;
    std::thread later([&] { stop.request_stop(); });
    QVERIFY(runChild(child, stop.get_token()).end == ChildEnd::stopped);
    later.join();
    // A program that never ends its answer costs its deadline at most.
    child.words[1] = "exec /bin/cat /dev/zero";
    child.deadline = kLongAgo;
    const ChildEnd poured = runChild(child, {}).end;
    QVERIFY(poured == ChildEnd::outOfTime || poured == ChildEnd::crashed);
  }

  void theProgramKnowsWhereItIs() {
    QVERIFY(fs::equivalent(programPath(), QCoreApplication::applicationFilePath().toStdString()));
  }

  void aFolderIsWrittenWhole() {
    QVERIFY(!writeFolder(place("made"), {{"a.txt", "a"}, {"deep/b.txt", "b"}}));
    QCOMPARE(contentsOf(place("made/deep/b.txt")), std::string("b"));
    QVERIFY(writeFolder(place("made"), {{"a.txt", "other"}}));
    QCOMPARE(contentsOf(place("made/a.txt")), std::string("a"));
    QCOMPARE(filesInFolder(), std::size_t{1});
  }
};

QTEST_GUILESS_MAIN(PlatformTest)
#include "test_platform.moc"

#include <QDir>
#include <QFile>
#include <QTemporaryDir>
#include <QTest>

#include "core/foundations/files/file.h"
#include "core/mechanism/document_format/mechanism_file.h"
#include "core/mechanism/model/edits.h"
#include "ui/recovery/side_file.h"

namespace geargraph {

class SideFileTest : public QObject {
  Q_OBJECT

  std::unique_ptr<QTemporaryDir> folder;

  [[nodiscard]] QString path(const QString& name) const { return folder->filePath(name); }
  static Mechanism drawn() { return withLink(emptyMechanism(), {10, 20}, "sun").value(); }
  static void write(const QString& path, const std::string& bytes) {
    QVERIFY(!writeFile(QFile::encodeName(path).toStdString(), bytes));
  }
  static std::string bytes(int edits) {
    return sideFileBytes(drawn(), {QStringLiteral("/a/b.geargraph"), QStringLiteral("b"), edits,
                                   QDateTime::currentDateTime()});
  }

 private slots:
  void init() { folder = std::make_unique<QTemporaryDir>(); }

  void whatIsWrittenIsRead() {
    const QString side = path(QStringLiteral("side.geargraph"));
    const QDateTime time(QDate(2026, 3, 4), QTime(5, 6, 7));
    write(side,
          sideFileBytes(drawn(), {QStringLiteral("/a/ü \"b\".geargraph"), QStringLiteral("b"), 12, time}));
    const auto held = SideFile::hold(side);
    const auto read = held->read();
    QVERIFY(read.has_value());
    QVERIFY(read->mechanism == drawn());  // without the note
    QCOMPARE(read->note.filePath, QStringLiteral("/a/ü \"b\".geargraph"));
    QCOMPARE(read->note.title, QStringLiteral("b"));
    QCOMPARE(read->note.edits, 12);
    QCOMPARE(read->note.savedAt, time);
  }

  void aSideFileIsADocument() {
    const Expected<Mechanism> read = readMechanism(bytes(1));
    QVERIFY(read.has_value());
    QCOMPARE(read->links.size(), std::size_t{2});
  }

  void whatIsNoSideFileIsNotTakenForOne() {
    const QString side = path(QStringLiteral("side.geargraph"));
    write(side, writeMechanism(drawn()));
    QVERIFY(!SideFile::hold(side)->read());
    write(side, "{\"format\": \"gear");
    QVERIFY(!SideFile::hold(side)->read());
  }

  void onlyOneHoldsIt() {
    const QString side = path(QStringLiteral("side.geargraph"));
    auto first = SideFile::hold(side);
    QVERIFY(first != nullptr);
    QVERIFY(SideFile::hold(side) == nullptr);
    first.reset();
    QVERIFY(SideFile::hold(side) != nullptr);
  }

  void aDeadProcessHoldsNothing() {
    const QString side = path(QStringLiteral("side.geargraph"));
    write(side, bytes(3));
    // The lock of a process that cannot be: numbers end at 2^22.
    write(side + QStringLiteral(".lock"),
          "99999999\ngeargraph\n" + QSysInfo::machineHostName().toStdString() + "\n");
    QVERIFY(SideFile::hold(side) != nullptr);
  }

  void tornBytesOfADeadProcessGo() {
    const QString side = path(QStringLiteral("side.geargraph"));
    const QString torn = path(QStringLiteral(".side.geargraph.4711-0.tmp"));
    write(torn, "half");
    QVERIFY(SideFile::hold(side) != nullptr);
    QVERIFY(!QFile::exists(torn));
  }

  void itLiesBesideTheDocument() {
    const QString document = path(QStringLiteral("robot.geargraph"));
    const auto side = freshSideFile(document, path(QStringLiteral("app")));
    QCOMPARE(QFileInfo(side->path()).absolutePath(), QFileInfo(document).absolutePath());
    QVERIFY(side->path() != document);
  }

  void aDocumentWithoutAFileHasItInTheFolder() {
    const QString app = path(QStringLiteral("app"));
    const auto first = freshSideFile({}, app);
    const auto second = freshSideFile({}, app);
    QCOMPARE(QFileInfo(first->path()).absolutePath(), app);
    QVERIFY(first->path() != second->path());
  }

  void recoverableFilesAreNeverOverwritten() {
    const QString document = path(QStringLiteral("robot.geargraph"));
    const QString app = path(QStringLiteral("app"));
    const QString left = freshSideFile(document, app)->path();
    write(left, bytes(3));
    const auto next = freshSideFile(document, app);
    QVERIFY(next != nullptr);
    QVERIFY(next->path() != left);
  }

  void recoverableFilesAreFound() {
    const QString document = path(QStringLiteral("robot.geargraph"));
    const QString app = path(QStringLiteral("app"));
    write(freshSideFile(document, app)->path(), bytes(3));
    write(freshSideFile({}, app)->path(), bytes(4));
    {
      const SideFiles found = recoverableFilesOf(document, app);
      QCOMPARE(found.size(), std::size_t{1});
      QCOMPARE(found.front()->read()->note.edits, 3);
      // What is held is not offered twice.
      QCOMPARE(recoverableFiles(app, {document}).size(), std::size_t{1});
    }
    QCOMPARE(recoverableFiles(app, {document}).size(), std::size_t{2});
    QCOMPARE(recoverableFiles(app, {}).size(), std::size_t{1});
  }

  void aFolderThatCannotBeWrittenToIsPassedBy() {
    const QString nowhere = QStringLiteral("/proc/none/robot.geargraph");
    const QString app = path(QStringLiteral("app"));
    const auto side = freshSideFile(nowhere, app);
    QVERIFY(side != nullptr);
    QCOMPARE(QFileInfo(side->path()).absolutePath(), app);
    QVERIFY(freshSideFile(nowhere, QStringLiteral("/proc/none/app")) == nullptr);
  }
};

}  // namespace geargraph

QTEST_GUILESS_MAIN(geargraph::SideFileTest)
#include "test_side_file.moc"

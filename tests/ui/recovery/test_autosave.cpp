#include <QFile>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>

#include "core/foundations/files/file.h"
#include "core/mechanism/document_format/mechanism_file.h"
#include "core/mechanism/model/edits.h"
#include "ui/recovery/autosave.h"

namespace geargraph {

class AutosaveTest : public QObject {
  Q_OBJECT

  std::unique_ptr<QTemporaryDir> folder;
  std::unique_ptr<Document> document;
  std::unique_ptr<Autosave> autosave;

  [[nodiscard]] QString app() const { return folder->filePath(QStringLiteral("app")); }
  [[nodiscard]] QString file() const { return folder->filePath(QStringLiteral("robot.geargraph")); }
  void addLink() {
    document->apply({QStringLiteral("Add link"),
                     [](const Mechanism& mechanism) {
                       return withLink(mechanism, CanvasPoint{10, 20});
                     },
                     0});
  }
  /// The document's state is in the side file, and nobody holds it any more.
  [[nodiscard]] SideDocument leftBy(const QString& filePath) {
    autosave.reset();
    const SideFiles left = recoverableFilesOf(filePath, app());
    if (left.size() != 1) qFatal("%d side files are left", int(left.size()));
    return left.front()->read().value();
  }

 private slots:
  void init() {
    folder = std::make_unique<QTemporaryDir>();
    document = std::make_unique<Document>();
    autosave = std::make_unique<Autosave>(document.get(), app());
  }
  void cleanup() {
    autosave.reset();
    document.reset();
  }

  void anEditIsSoonInTheSideFile() {
    document->replace(emptyMechanism(), file());
    autosave->setTitle(QStringLiteral("robot.geargraph"));
    QVERIFY(autosave->isUpToDate());
    addLink();
    QVERIFY(!autosave->isUpToDate());
    QTRY_VERIFY(autosave->isUpToDate());
    QVERIFY(QFile::exists(autosave->sidePath()));
    QVERIFY(!QFile::exists(file()));  // never the document's own file
    addLink();
    QTRY_VERIFY(autosave->isUpToDate());
    const SideDocument left = leftBy(file());
    QVERIFY(left.mechanism == *document->mechanism());
    QCOMPARE(left.note.edits, 2);
    QCOMPARE(left.note.filePath, file());
    QCOMPARE(left.note.title, QStringLiteral("robot.geargraph"));
  }

  void whatIsNotWrittenYetIsWrittenAtTheEnd() {
    addLink();
    const SideDocument left = leftBy({});
    QVERIFY(left.mechanism == *document->mechanism());
    QVERIFY(left.note.filePath.isEmpty());
  }

  void whatIsSavedNeedsNoSideFile() {
    addLink();
    QTRY_VERIFY(autosave->isUpToDate());
    const QString side = autosave->sidePath();
    QVERIFY(QFile::exists(side));
    document->markSaved(file());
    QVERIFY(autosave->sidePath().isEmpty());
    QTRY_VERIFY(!QFile::exists(side));
    addLink();  // from now on it lies beside the file
    QTRY_VERIFY(autosave->isUpToDate());
    QCOMPARE(QFileInfo(autosave->sidePath()).absolutePath(), folder->path());
  }

  void whatIsUndoneNeedsNoSideFile() {
    addLink();
    QTRY_VERIFY(autosave->isUpToDate());
    const QString side = autosave->sidePath();
    document->undoStack().undo();
    QTRY_VERIFY(!QFile::exists(side));
    QVERIFY(autosave->isUpToDate());
  }

  void whatIsGivenUpIsGone() {
    addLink();
    autosave->discard();
    autosave.reset();
    QVERIFY(recoverableFiles(app(), {}).empty());
  }

  void restoredChangesGoOnInTheirSideFile() {
    addLink();
    addLink();
    addLink();
    SideDocument left = leftBy({});
    SideFiles files = recoverableFilesOf({}, app());
    const QString path = files.front()->path();

    document = std::make_unique<Document>();
    autosave = std::make_unique<Autosave>(document.get(), app());
    document->apply({QStringLiteral("Restore"),
                     [&](const Mechanism&) -> Expected<Mechanism> { return left.mechanism; }, 0});
    autosave->adopt(std::move(files.front()), left.note);
    QTRY_VERIFY(autosave->isUpToDate());
    QCOMPARE(autosave->sidePath(), path);
    addLink();
    QTRY_VERIFY(autosave->isUpToDate());
    QCOMPARE(leftBy({}).note.edits, 4);
  }

  void whatCannotBeWrittenIsSaidOnce() {
    autosave = std::make_unique<Autosave>(document.get(), QStringLiteral("/proc/none"));
    const QSignalSpy failed(autosave.get(), &Autosave::failed);
    addLink();
    QTRY_COMPARE(failed.size(), 1);
    QVERIFY(failed.front().front().toString().contains(QStringLiteral("/proc/none")));
    addLink();
    QTRY_VERIFY(autosave->isUpToDate());
    QCOMPARE(failed.size(), 1);
  }

  void twoProgramsDoNotShareASideFile() {
    document->replace(emptyMechanism(), file());
    Document other;
    other.replace(emptyMechanism(), file());
    Autosave second(&other, app());
    addLink();
    other.apply({QStringLiteral("Rename"),
                 [](Mechanism mechanism) -> Expected<Mechanism> {
                   mechanism.name = "other";
                   return mechanism;
                 },
                 0});
    QTRY_VERIFY(autosave->isUpToDate() && second.isUpToDate());
    QVERIFY(autosave->sidePath() != second.sidePath());
  }
};

}  // namespace geargraph

QTEST_GUILESS_MAIN(geargraph::AutosaveTest)
#include "test_autosave.moc"

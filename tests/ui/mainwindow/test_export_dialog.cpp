#include <QCheckBox>
#include <QComboBox>
#include <QDesktopServices>
#include <QDirIterator>
#include <QFile>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>
#include <QToolButton>
#include <QUrl>
#include <algorithm>

#include "tests/core/support/deep_train.h"
#include "tests/core/support/example_files.h"
#include "tests/core/support/snapshot_of.h"
#include "tests/ui/mainwindow/hand.h"
#include "ui/mainwindow/export_dialog.h"
#include "ui/mainwindow/export_jobs.h"
#include "ui/mainwindow/export_options_form.h"
#include "ui/mainwindow/notice_bar.h"
#include "ui/mainwindow/recent_exports.h"
#include "ui/mainwindow/window_exports.h"
#include "ui/mainwindow/window_files.h"

namespace geargraph {

/// File > Export: every format of the registry, with its options, written on the thread of the exports.
class ExportDialogTest : public QObject {
  Q_OBJECT

  const QTemporaryDir folder;
  QList<QUrl> opened;

  static QString wordOf(std::string_view text) {
    return QString::fromUtf8(text.data(), static_cast<qsizetype>(text.size()));
  }
  static QPushButton* exportButton(const ExportDialog& dialog) {
    for (auto* button : dialog.findChildren<QPushButton*>()) {
      if (button->isDefault()) return button;
    }
    return nullptr;
  }

 public slots:
  void open(const QUrl& url) { opened << url; }

 private slots:
  void initTestCase() { test::setUpProgram(); }

  /// Every exporter is found under what it is for, below the title of its family.
  void theListsAreTheRegistry() {
    ExportDialog dialog(test::snapshotOf(test::example("robot")));
    const auto* formats = dialog.findChild<QListWidget*>("exportFormats");
    QStringList listed, registered;
    for (const ExportPurpose purpose : kExportPurposes) {
      const QString title = QString::fromStdString(exportPurposeTitle(purpose));
      for (auto* chip : dialog.findChildren<QToolButton*>()) {
        if (chip->text() == title) chip->click();
      }
      QCOMPARE(familyOf(dialog.exporter()).purpose, purpose);
      QVERIFY(formats->currentItem() != nullptr);
      for (int i = 0; i < formats->count(); ++i) {
        const QString id = formats->item(i)->data(Qt::UserRole).toString();
        if (!id.isEmpty()) listed << id;
      }
    }
    for (const Exporter* exporter : allExporters()) registered << wordOf(exporter->id);
    listed.sort();
    registered.sort();
    QCOMPARE(listed, registered);
  }

  void everyOptionHasAFieldOfItsType() {
    ExportDialog dialog(test::snapshotOf(test::example("robot")));
    for (const Exporter* exporter : allExporters()) {
      dialog.choose(exporter->id);
      QCOMPARE(dialog.exporter().id, exporter->id);
      for (const ExportOption& option : exporter->options) {
        auto* field = dialog.findChild<QWidget*>(wordOf(option.name));
        QVERIFY2(field != nullptr && !field->toolTip().isEmpty(), option.name.data());
        QCOMPARE(qobject_cast<QCheckBox*>(field) != nullptr, option.type == OptionType::flag);
        QCOMPARE(qobject_cast<QComboBox*>(field) != nullptr, option.type == OptionType::choice);
      }
      // What nobody has touched leaves the options as they are without it, and chooses this exporter.
      const OptionValues given = dialog.options();
      QCOMPARE(exporterOf(exporter->form, given)->id, exporter->id);
      QVERIFY(!uselessOption(*exporter, given));
    }
  }

  void whatIsSetIsGiven() {
    ExportDialog dialog(test::snapshotOf(test::example("robot")));
    dialog.choose("mjcf");
    auto* usual = dialog.findChild<QPushButton*>("exportUsual");
    QVERIFY(!usual->isEnabled());
    auto* const motor = dialog.findChild<QComboBox*>("--motor");
    motor->setCurrentIndex(motor->findData("torque"));
    auto* step = dialog.findChild<QWidget*>("--timestep")->findChild<QLineEdit*>();
    step->setText("0,002");
    OptionValues given = dialog.options();
    QCOMPARE(given.value("--motor"), std::optional<std::string>("torque"));
    QCOMPARE(given.value("--timestep"), std::optional<std::string>("0.002"));
    QVERIFY(!given.has("--gravity"));
    step->setText("2 ms");  // in another unit
    QCOMPARE(dialog.options().value("--timestep"), std::optional<std::string>("1/500"));
    usual->click();
    QVERIFY(!dialog.options().has("--motor") && !dialog.options().has("--timestep"));
    dialog.choose("csv");
    dialog.findChild<QCheckBox*>("--bom")->setChecked(true);
    given = dialog.options();
    QVERIFY(given.has("--bom") && !given.has("--no-labels") && !given.has("--motor"));
    QCOMPARE(given.value("--matrix"), std::optional<std::string>("incidence"));
  }

  void numbersTakeArithmeticAndUnits() {
    QCOMPARE(exportedNumber("1/2+1/3", {}), QString("1/2+1/3"));
    QCOMPARE(exportedNumber(" 0,5 ", {}), QString("0.5"));
    QCOMPARE(exportedNumber("1 cm", "mm"), QString("10"));
    QCOMPARE(exportedNumber("1/100 in", "mm"), QString("127/500"));
    QCOMPARE(exportedNumber("0.5 min", "s"), QString("30"));
    QCOMPARE(exportedNumber("3 apples", "mm"), QString());
    QCOMPARE(exportedNumber("1 cm", "s"), QString());
  }

  void aFormatThatTheDocumentHasNothingForSaysWhy() {
    Mechanism loose = emptyMechanism();
    loose.links.push_back({LinkId("1"), {}});
    ExportDialog dialog(test::snapshotOf(loose));
    dialog.choose("mjcf");
    const auto* reason = dialog.findChild<QLabel*>("exportReason");
    QVERIFY(!exportButton(dialog)->isEnabled() && !reason->text().isEmpty());
    QCOMPARE(exportButton(dialog)->toolTip(), reason->text());
    const auto* formats = dialog.findChild<QListWidget*>("exportFormats");
    QCOMPARE(formats->currentItem()->toolTip(), reason->text());  // where it is listed, too
    dialog.choose("dot");
    QVERIFY(exportButton(dialog)->isEnabled() && reason->text().isEmpty());
    dialog.choose("mjcf");
    dialog.setSnapshot(test::snapshotOf(test::example("robot")));
    QVERIFY(exportButton(dialog)->isEnabled());
  }

  /// What would be written is known before a file is chosen: names and sizes are those of the export.
  void thePreviewIsWhatIsWritten_data() {
    QTest::addColumn<QString>("id");
    for (const char* id : {"dot", "csv", "csv-all", "latex", "modelica", "obj", "mjcf", "kit"})
      QTest::newRow(id) << id;
  }
  void thePreviewIsWhatIsWritten() {
    QFETCH(QString, id);
    const auto window = test::openedWindow(QString::fromStdString(test::examplePath("spur-pair")));
    QVERIFY(window != nullptr);
    ExportDialog dialog(window->analysis().snapshot(), {window->files().source(), window->files().title()});
    dialog.choose(id.toStdString());
    QTRY_VERIFY_WITH_TIMEOUT(dialog.preview() != nullptr, 60'000);
    const ExportPreviewPtr preview = dialog.preview();
    QVERIFY2(preview->why.isEmpty(), qPrintable(preview->why));
    QSignalSpy written(&window->exports(), &WindowExports::written);
    const QTemporaryDir place;
    const Exporter& exporter = dialog.exporter();
    const bool isFolder = exporter.files == ExportFiles::folder;
    const QString path = place.filePath(proposedName(exporter, {{}, window->files().title()}));
    window->exports().exportAs(exporter, dialog.options(), path);
    QVERIFY(written.wait(60'000));
    const QDir root(isFolder ? path : place.path());
    QDirIterator files(root.path(), QDir::Files, QDirIterator::Subdirectories);
    qsizetype count = 0;
    for (; files.hasNext(); ++count) {
      const QFileInfo file(files.next());
      const QString name = root.relativeFilePath(file.filePath());
      const auto same = std::find_if(preview->files.begin(), preview->files.end(),
                                     [&](const PreviewedFile& each) { return each.name == name; });
      QVERIFY2(same != preview->files.end(), qPrintable(name));
      QCOMPARE(same->bytes, file.size());
    }
    QCOMPARE(static_cast<qsizetype>(preview->files.size()), count);
    QVERIFY(count > 0);
  }

  void aTextShowsItsBeginningAndASolidAPicture() {
    ExportDialog dialog(test::snapshotOf(test::example("spur-pair")), {{}, "spur-pair"});
    dialog.choose("dot");
    QTRY_VERIFY(dialog.preview() != nullptr);
    const auto* text = dialog.findChild<QPlainTextEdit*>("exportText");
    QVERIFY2(text->toPlainText().startsWith("digraph"), qPrintable(text->toPlainText().left(40)));
    dialog.choose("svg");
    QTRY_VERIFY_WITH_TIMEOUT(dialog.preview() != nullptr && dialog.preview()->files.size() == 1, 60'000);
    QCOMPARE(dialog.preview()->files.front().name, QString("spur-pair.svg"));
    QVERIFY(!dialog.preview()->shown.image.isNull());
  }

  /// A reason that only the export itself finds is told before a file is chosen, in the words of the dialog.
  void whatIsRefusedIsToldBeforeAFileIsChosen() {
    ExportDialog dialog(test::snapshotOf(test::example("spur-pair")), {{}, "spur-pair"});
    dialog.choose("kit");
    auto* bed = dialog.findChild<QWidget*>("--bed")->findChild<QLineEdit*>();
    bed->setText("10x10");
    const auto* reason = dialog.findChild<QLabel*>("exportReason");
    QTRY_VERIFY_WITH_TIMEOUT(!reason->text().isEmpty(), 60'000);
    QVERIFY2(!reason->text().contains("--") && reason->text().contains("Plate of the printer"),
             qPrintable(reason->text()));
    QVERIFY(!exportButton(dialog)->isEnabled());
    bed->clear();
    QTRY_VERIFY_WITH_TIMEOUT(dialog.preview() != nullptr && reason->text().isEmpty(), 60'000);
    QVERIFY(exportButton(dialog)->isEnabled());
  }

  void aLargeTrainIsPreviewedWhenItIsAskedFor() {
    Mechanism large = test::deepTrain(1, ExportDialog::kQuickLinks + 1);
    ExportDialog dialog(test::snapshotOf(large), {{}, "large"});
    dialog.choose("stl");
    QVERIFY(dialog.preview() == nullptr);
    QVERIFY(exportButton(dialog)->isEnabled());
    dialog.choose("dot");  // quick for any train
    QTRY_VERIFY(dialog.preview() != nullptr);
  }

  void theChoiceIsRemembered() {
    QString id;
    {
      ExportDialog dialog(test::snapshotOf(test::example("robot")));
      dialog.setAttribute(Qt::WA_DeleteOnClose, false);
      dialog.choose("csv");
      auto* const separator = dialog.findChild<QComboBox*>("--separator");
      separator->setCurrentIndex(separator->findData("semicolon"));
      connect(&dialog, &ExportDialog::wanted, this, [&](const QString& wanted) { id = wanted; });
      exportButton(dialog)->click();
    }
    QCOMPARE(id, QString("csv"));
    const ExportDialog next(test::snapshotOf(test::example("robot")));
    QCOMPARE(next.exporter().id, std::string_view("csv"));
    QCOMPARE(next.options().value("--separator"), std::optional<std::string>("semicolon"));
  }

  /// A finished export is told in the window, opens its folder, and is repeated from the menu.
  void whatWasWrittenIsToldAndRepeated() {
    const auto window = test::openedWindow(QString::fromStdString(test::examplePath("spur-pair")));
    QVERIFY(window != nullptr);
    const QString path = folder.filePath("told.dot");
    QSignalSpy written(&window->exports(), &WindowExports::written);
    window->exports().exportAs(*exporterWithId("dot"), {}, path);
    QVERIFY(written.wait(60'000));
    const Notice* notice = window->notices().current();
    QVERIFY(notice != nullptr && notice->text.contains("told.dot"));
    opened.clear();
    QDesktopServices::setUrlHandler("file", this, "open");
    for (auto* button : window->notices().findChildren<QPushButton*>()) {
      if (button->text() == "Show in folder") button->click();
    }
    QDesktopServices::unsetUrlHandler("file");
    QCOMPARE(opened, QList<QUrl>{QUrl::fromLocalFile(folder.path())});
    QVERIFY(window->notices().current() == nullptr);

    QVERIFY(QFile::remove(path));
    auto* menu = window->findChild<RecentExports*>();
    QVERIFY(menu != nullptr);
    const QList<QAction*> entries = menu->actions();
    const auto again = std::find_if(entries.begin(), entries.end(),
                                    [](const QAction* each) { return each->text().startsWith("told.dot"); });
    QVERIFY(again != entries.end());
    (*again)->trigger();
    QVERIFY(written.wait(60'000));
    QVERIFY(QFileInfo(path).size() > 0);
    QVERIFY(window->notices().current() != nullptr);
    window->document().apply({"Rename", [](Mechanism before) -> Expected<Mechanism> {
                                before.name = "another";
                                return before;
                              }});
    QVERIFY(window->notices().current() == nullptr);  // it is the document of before
  }

  void exportsOfOtherDocumentsAreNotListed() {
    test::clearSettings();
    RecentExports::add({"/a.geargraph", "dot", {}, "/a.dot"});
    RecentExports::add({"/b.geargraph", "stl", {}, "/b.stl"});
    RecentExports::add({"/a.geargraph", "no such format", {}, "/a.none"});
    const QString a = "/a.geargraph";
    QCOMPARE(RecentExports::all(&a).size(), std::size_t{1});
    QCOMPARE(RecentExports::all().size(), std::size_t{2});
    OptionValues options;
    options.options["--view"] = {"ttgraph"};
    RecentExports::add({a, "graphml", options, "/a.dot"});  // replaces what was written there
    QCOMPARE(RecentExports::all(&a).size(), std::size_t{1});
    QCOMPARE(RecentExports::all(&a).front().options.value("--view"), std::optional<std::string>("ttgraph"));
  }

  void aHandoutIsWrittenBesideTheDocumentAtOnce() {
    const QTemporaryDir place;
    const QString document = place.filePath("pair.geargraph");
    QVERIFY(QFile::copy(QString::fromStdString(test::examplePath("spur-pair")), document));
    const auto window = test::openedWindow(document);
    QVERIFY(window != nullptr);
    QTRY_VERIFY(window->analysis().isComplete());
    QFile other(place.filePath("pair-handout.html"));  // of somebody else
    QVERIFY(other.open(QIODevice::WriteOnly) && other.write("mine") == 4);
    other.close();
    QSignalSpy written(&window->exports(), &WindowExports::written);
    for (int time = 0; time < 2; ++time) {
      window->actions()[CommandId::handoutNow]->trigger();
      QVERIFY(written.wait(60'000));
      QCOMPARE(written.last().first().toString(), place.filePath("pair-handout-2.html"));
    }
    QCOMPARE(QFileInfo(other).size(), qint64{4});
    QVERIFY(QFileInfo(place.filePath("pair-handout-2.html")).size() > 10'000);
  }

  void theWindowWritesOnItsOwnThread_data() {
    QTest::addColumn<QString>("id");
    for (const char* id : {"dot", "graphml", "node-link", "mjcf", "urdf", "modelica", "glb", "3mf"})
      QTest::newRow(id) << id;
  }
  void theWindowWritesOnItsOwnThread() {
    QFETCH(QString, id);
    const auto window = test::openedWindow(QString::fromStdString(test::examplePath("spur-pair")));
    QVERIFY(window != nullptr);
    const Exporter& exporter = *exporterWithId(id.toStdString());
    const QString path = folder.filePath(id);
    QSignalSpy written(&window->exports(), &WindowExports::written);
    QSignalSpy rejected(&window->exports(), &WindowExports::rejected);
    window->exports().exportAs(exporter, withImplied(exporter, {}), path);
    QVERIFY(window->exportJobs().isBusy());
    QVERIFY(written.wait(60'000));
    QVERIFY(rejected.empty());
    const QFileInfo made(path);
    QVERIFY(exporter.files == ExportFiles::folder ? !QDir(path).isEmpty() : made.size() > 0);
  }
};

}  // namespace geargraph

QTEST_MAIN(geargraph::ExportDialogTest)
#include "test_export_dialog.moc"

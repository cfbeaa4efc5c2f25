#include <QComboBox>
#include <QDir>
#include <QFile>
#include <QImage>
#include <QPushButton>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>

#include "core/teaching/lessons/course.h"
#include "tests/core/support/train_sketch.h"
#include "tests/ui/mainwindow/hand.h"
#include "ui/canvas/digraph_view.h"
#include "ui/canvas/tt_graph_view.h"
#include "ui/mainwindow/document_files.h"
#include "ui/mainwindow/export_jobs.h"
#include "ui/mainwindow/notice_bar.h"
#include "ui/mainwindow/picture_dialog.h"
#include "ui/mainwindow/window_exports.h"
#include "ui/reading/derivation_panel.h"
#include "ui/theme/application_theme.h"
#include "ui/theme/in_sight.h"
#include "ui/view3d/view3d.h"

namespace geargraph {

/// The drawings of one window: tabs that share tools, selection and commands, and their pictures.
class DrawingsTest : public QObject {
  Q_OBJECT

  std::unique_ptr<MainWindow> window;
  const QTemporaryDir folder;

  QByteArray exported(const PictureOptions& options, const QString& name) {
    const QString path = folder.filePath(name);
    QSignalSpy done(&window->exports(), &WindowExports::written);
    window->exports().exportPicture(options, path);
    if (done.empty()) done.wait(60'000);
    QFile file(path);
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
  }
  QByteArray derivation(const QString& name) {
    return written(name, [this](const QString& path) { window->exports().exportDerivation(path); });
  }
  QByteArray handout(const QString& name) {
    return written(name, [this](const QString& path) { window->exports().exportHandout(path); });
  }
  QByteArray written(const QString& name, const std::function<void(const QString&)>& write) {
    const QString path = folder.filePath(name);
    QSignalSpy done(&window->exports(), &WindowExports::written);
    write(path);
    if (done.empty()) done.wait(60'000);
    QFile file(path);
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
  }
  static PictureOptions optionsFor(const QString& view, PictureForm form) {
    return {view, DrawingPicture{.form = form}};
  }

 private slots:
  void initTestCase() { test::setUpProgram(); }
  void init() {
    window = test::openedWindow(robotExamplePath());
    QVERIFY(window != nullptr);
  }
  void cleanup() { window.reset(); }

  void drawingsShareSelectionAndHover() {
    QVERIFY(window->showDrawing("ttgraph"));
    QCOMPARE(&window->drawing(), static_cast<DrawingView*>(&window->ttGraph()));
    window->selection().select({MeshId("16")});
    QCOMPARE(window->ttGraph().caption().size(), qsizetype{4});
    QCOMPARE(window->digraph().caption().size(), qsizetype{1});
    QVERIFY(!window->showDrawing("nothing"));
  }

  // A drawing in a tab behind waits, but nobody's file has an old one.
  void anExportedSchematicIsThatOfTheDocument() {
    const auto schematic = [this](const QString& name) {
      return exported(optionsFor("schematic", PictureForm::svg), name);
    };
    const QByteArray before = schematic("before.svg");
    window->selection().select({LinkId("3")});
    window->actions()[CommandId::remove]->trigger();
    const QByteArray behind = schematic("behind.svg");
    QVERIFY(!behind.isEmpty() && behind != before);
    QVERIFY(window->showDrawing("schematic"));
    QTRY_VERIFY(window->isSettled());
    QCOMPARE(schematic("shown.svg"), behind);
  }

  // A page with the three drawings as they are in the window, the curves, and both methods' last equations.
  void theDerivationIsAFile() {
    QVERIFY(window->actions()[CommandId::exportDerivation]->isEnabled());
    const QByteArray page = derivation("derivation.html");
    QCOMPARE(page.count("<svg"), qsizetype{4});
    QVERIFY(page.contains("id=\"eq25\"") && page.contains("id=\"eq45\""));
    QVERIFY(derivation("derivation.tex").startsWith("\\documentclass"));
    QVERIFY(derivation("derivation.md").startsWith("# Geared robotic mechanism"));
    QVERIFY(derivation("derivation.pdf").startsWith("%PDF-"));
  }

  // The page has what the file on disk would give, with the train and its still picture.
  void theHandoutIsAFile() {
    QVERIFY(window->actions()[CommandId::exportHandout]->isEnabled());
    const QByteArray page = handout("handout.html");
    QCOMPARE(page.count("<figure data-name="), qsizetype{3});
    QVERIFY(page.contains("id=\"geometry\"") && page.contains("src=\"data:image/png;base64,"));
    QVERIFY(page.contains("id=\"eq25\"") && page.endsWith("</html>\n"));
  }

  void theHandoutAsksWhereItIsTold() {
    QVERIFY(!handout("plain.html").contains("exercises-key\">"));
    const QByteArray page = written("asking.html", [&](const QString& path) {
      window->exports().exportHandoutAsking(path, SheetPlan{"Exercises", {}});
    });
    QVERIFY(page.count("<article class=\"question\"") >= 14);
    QVERIFY(page.contains("id=\"exercises-key\">") && page.endsWith("</html>\n"));
  }

  void theHandoutAsksWhatWasChosen() {
    const SheetPlan plan{"Home", {ExerciseKind::cycle, ExerciseKind::cycle, ExerciseKind::freedom}, 7};
    const auto write = [&](const QString& path) { window->exports().exportHandoutAsking(path, plan); };
    const QByteArray page = written("chosen.html", write);
    QCOMPARE(page.count("<article class=\"question\""), qsizetype{3});
    QVERIFY(page.contains("Home"));
  }

  // SCORM 1.2: a ZIP archive with the manifest and the page.
  void aPackageIsForLearningPlatforms() {
    const QByteArray package = handout("handout.zip");
    QVERIFY(package.startsWith("PK\x03\x04"));
    QVERIFY(package.contains("imsmanifest.xml") && package.contains("index.html"));
  }

  void sheetsAreWrittenIntoAFolderOfTheirOwn() {
    const SheetRequest request{
        {"Home", {ExerciseKind::cycle, ExerciseKind::freedom}, 7, 3}, {}, {SheetFileForm::html}};
    const QString sheets = folder.filePath("sheets");
    QSignalSpy done(&window->exports(), &WindowExports::written);
    window->exports().exportSheets(sheets, request);
    QTRY_COMPARE_WITH_TIMEOUT(done.count(), qsizetype{1}, 60'000);
    QStringList expected;
    for (const std::string& name : sheetFileNames(request)) expected += QString::fromStdString(name);
    expected.sort();
    QCOMPARE(QDir(sheets).entryList(QDir::Files, QDir::Name), expected);
    QCOMPARE(expected.size(), qsizetype{10});
    // A folder that is there is left alone, and that is told.
    QSignalSpy rejection(&window->exports(), &WindowExports::rejected);
    window->exports().exportSheets(sheets, request);
    QCOMPARE(rejection.count(), qsizetype{1});
    QVERIFY(rejection[0][0].toString().contains("sheets"));
  }

  void lessonsAreWrittenAsPagesAndPackages() {
    const QString lessons = folder.filePath("lessons");
    QSignalSpy done(&window->exports(), &WindowExports::written);
    window->exports().exportLessons(lessons);
    QTRY_COMPARE_WITH_TIMEOUT(done.count(), qsizetype{1}, 120'000);
    QStringList expected{QStringLiteral("index.html")};
    for (const Lesson& lesson : course()) {
      for (const char* suffix : {".html", ".zip"})
        expected += QString::fromStdString(lesson.id) + QLatin1String(suffix);
    }
    expected.sort();
    QCOMPARE(QDir(lessons).entryList(QDir::Files, QDir::Name), expected);
    QSignalSpy rejection(&window->exports(), &WindowExports::rejected);
    window->exports().exportLessons(lessons);
    QCOMPARE(rejection.count(), qsizetype{1});
  }

  // One key, and both methods are there, as the document is now.
  void theDerivationIsShownInTheWindow() {
    DerivationPanel& panel = window->derivation();
    QVERIFY(!isInSight(panel) && panel.view().report() == nullptr);
    QTest::keyClick(&window->digraph(), Qt::Key_F6);
    QTRY_VERIFY(isInSight(panel) && panel.isUpToDate() && panel.view().report() != nullptr);
    QVERIFY(!panel.view().equationPlace(45).isEmpty());
    window->selection().select({LinkId("3")});
    window->actions()[CommandId::remove]->trigger();
    QTRY_VERIFY(panel.isUpToDate() && panel.view().equationPlace(45).isEmpty());
  }

  void anEmptyDocumentHasNoDerivation() {
    MainWindow empty;
    QTRY_VERIFY(empty.isSettled());
    QVERIFY(!empty.actions()[CommandId::exportDerivation]->isEnabled());
    QVERIFY(!empty.actions()[CommandId::exportHandout]->isEnabled());
    QVERIFY(empty.actions()[CommandId::exportDerivation]->toolTip().contains("nothing drawn"));
  }

  void toolAndCommandsBelongToTheDrawingInFront() {
    window->digraph().setTool(ToolKind::gearMesh);
    QVERIFY(window->showDrawing("ttgraph"));
    QCOMPARE(window->ttGraph().tool(), ToolKind::gearMesh);
    window->ttGraph().setTool(ToolKind::select);
    QVERIFY(window->showDrawing("digraph"));
    QCOMPARE(window->digraph().tool(), ToolKind::select);
    QVERIFY(window->showDrawing("ttgraph"));
    window->selection().select({LinkId("3")});
    window->actions()[CommandId::remove]->trigger();
    QCOMPARE(window->document().mechanism()->n(), 6);
  }

  void everyDrawingIsExportedInEveryForm() {
    QVERIFY(exported(optionsFor("digraph", PictureForm::svg), "a.svg").contains(">motor<"));
    QVERIFY(exported(optionsFor("ttgraph", PictureForm::svg), "b.svg").contains("16′′"));
    QVERIFY(exported(optionsFor("ttgraph", PictureForm::pdf), "c.pdf").startsWith("%PDF-"));
    PictureOptions sized = optionsFor("digraph", PictureForm::png);
    sized.picture.style.size = SheetStyle::Size{300, 200};
    QCOMPARE(QImage::fromData(exported(sized, "d.png")).size(), QSize(300, 200));
  }

  void pictureHasNoTraceOfTheSelection() {
    const QByteArray plain = exported(optionsFor("digraph", PictureForm::svg), "e.svg");
    window->selection().select({LinkId("3")});
    QCOMPARE(exported(optionsFor("digraph", PictureForm::svg), "f.svg"), plain);
  }

  void solidViewIsExportedAsPixels() {
    PictureOptions solid = optionsFor("3d", PictureForm::png);
    solid.picture.style.size = SheetStyle::Size{160, 100};
    QCOMPARE(QImage::fromData(exported(solid, "g.png")).size(), QSize(160, 100));
  }

  void exportsOfTheSolidViewWaitForEachOtherAndNotTheWindow() {
    PictureOptions animation = optionsFor("3d", PictureForm::png);
    animation.picture.style.size = SheetStyle::Size{64, 48};
    animation.animation = Animation{AnimationKind::turntable, 4, 24, 0};
    PictureOptions pictures = animation, solids = animation;
    pictures.solid = SolidForm::pictures;
    solids.solid = SolidForm::glb;
    QSignalSpy done(&window->exports(), &WindowExports::written);
    window->exports().exportPicture(animation, folder.filePath("film.png"));
    window->exports().exportPicture(pictures, folder.filePath("pictures"));
    window->exports().exportPicture(solids, folder.filePath("view.glb"));
    QVERIFY(window->notices().current() != nullptr);
    QVERIFY(done.empty());  // nothing was waited for
    QTRY_COMPARE_WITH_TIMEOUT(done.size(), qsizetype{3}, 60'000);
    QCOMPARE(QDir(folder.filePath("pictures")).entryList(QDir::Files).size(), qsizetype{4});
    QCOMPARE(done.back().front().toString(), folder.filePath("view.glb"));
    const Notice* last = window->notices().current();  // none is under way, the last one is told
    QVERIFY(last != nullptr && last->text.contains(QStringLiteral("view.glb")));
  }

  void anExportThatIsStoppedWritesNothing() {
    PictureOptions animation = optionsFor("3d", PictureForm::png);
    animation.picture.style.size = SheetStyle::Size{64, 48};
    animation.animation = Animation{AnimationKind::turntable, kMaxAnimationFrames, 24, 0};
    QSignalSpy failed(&window->exportJobs(), &ExportJobs::failed);
    window->exports().exportPicture(animation, folder.filePath("long.png"));
    auto answers = window->notices().current()->answers;
    QCOMPARE(answers.front().text, QString("Stop"));
    answers.front().run();
    QTRY_COMPARE_WITH_TIMEOUT(failed.size(), qsizetype{1}, 60'000);
    QVERIFY(!QFile::exists(folder.filePath("long.png")));
    QVERIFY(!window->exportJobs().isBusy());
  }

  void aLargeMatrixIsExportedBesideTheWindowAndCanBeStopped() {
    const auto large = analyze(std::make_shared<const Mechanism>(test::randomTrain(7, 3000, 1200)));
    const ResultTablePtr matrix = exactTable(resultOf(MatrixKind::incidence), {large});
    QSignalSpy failed(&window->exports(), &WindowExports::rejected);
    QSignalSpy done(&window->exports(), &WindowExports::written);
    window->exports().exportCsv(matrix, folder.filePath("stopped.csv"));
    QVERIFY(window->notices().current() != nullptr);
    window->notices().current()->answers.front().run();
    QTRY_COMPARE_WITH_TIMEOUT(failed.size(), qsizetype{1}, 60'000);
    QVERIFY(!QFile::exists(folder.filePath("stopped.csv")));
    window->exports().exportCsv(matrix, folder.filePath("whole.csv"));
    QTRY_COMPARE_WITH_TIMEOUT(done.size(), qsizetype{1}, 60'000);
    QFile file(folder.filePath("whole.csv"));
    QVERIFY(file.open(QIODevice::ReadOnly));
    QCOMPARE(file.readAll().count('\n'), qsizetype{matrix->rows() + 1});
  }

  void anExportShowsWhatTheWindowShows() {
    PictureOptions solid = optionsFor("3d", PictureForm::png);
    solid.picture.style.size = SheetStyle::Size{160, 100};
    const QByteArray before = exported(solid, "h.png");
    window->view3d().setCamera(Camera::looking(StandardView::top).placedAt({0, 0, 0}, 600));
    const QByteArray turned = exported(solid, "i.png");
    QVERIFY(turned != before);
    ViewOptions options = window->view3d().options();
    options.section = SectionChoice{};
    window->view3d().setOptions(options);
    QVERIFY(exported(solid, "j.png") != turned);
    options.section.reset();
    options.linkLabels = false;
    window->view3d().setOptions(options);
    QVERIFY(exported(solid, "k.png") != turned);  // labels are painted too
    solid.picture.style.transparent = true;
    QCOMPARE(QImage::fromData(exported(solid, "l.png")).pixelColor(2, 2).alpha(), 0);
  }

  void whatCannotBeWrittenIsSaid() {
    QSignalSpy done(&window->exports(), &WindowExports::written);
    window->exports().exportPicture(optionsFor("digraph", PictureForm::svg), "/nowhere/at/all.svg");
    QVERIFY(done.empty());
  }

  void dialogOffersPixelsOnlyForTheSolidView() {
    PictureDialog dialog({{"digraph", "Digraph"}, {"3d", "3D"}}, "digraph", true);
    QCOMPARE(dialog.options().view, QString("digraph"));
    QCOMPARE(dialog.options().picture.form, PictureForm::svg);
    QCOMPARE(dialog.options().picture.style.theme, Theme::dark);
    QVERIFY(!dialog.options().picture.style.size);
    dialog.findChildren<QComboBox*>().front()->setCurrentIndex(1);
    QCOMPARE(dialog.options().picture.form, PictureForm::png);
    QVERIFY(dialog.options().picture.style.size.has_value());
    QVERIFY(!dialog.options().animation);
    dialog.findChild<QComboBox*>("film")->setCurrentIndex(2);
    QVERIFY(dialog.options().animation->kind == AnimationKind::motion);
    dialog.findChildren<QComboBox*>()[1]->setCurrentIndex(4);
    QVERIFY(dialog.options().solid == SolidForm::glb && !dialog.options().animation);
  }
};

}  // namespace geargraph

QTEST_MAIN(geargraph::DrawingsTest)
#include "test_drawings.moc"

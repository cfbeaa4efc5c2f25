#include <QAction>
#include <QApplication>
#include <QClipboard>
#include <QDockWidget>
#include <QLabel>
#include <QListView>
#include <QSlider>
#include <QTest>
#include <QToolButton>

#include "tests/core/support/train_sketch.h"
#include "tests/ui/mainwindow/hand.h"
#include "ui/canvas/digraph_view.h"
#include "ui/help/search_field.h"
#include "ui/mainwindow/document_files.h"
#include "ui/mainwindow/status_line.h"
#include "ui/mainwindow/view_docks.h"
#include "ui/view3d/view3d.h"

namespace geargraph {

/// The search field and the motion controls of the tool bar, by keyboard and mouse.
class WindowSearchTest : public QObject {
  Q_OBJECT

  std::unique_ptr<MainWindow> window;

  SearchField* search() { return window->findChild<SearchField*>("search"); }
  SearchPopup& popup() { return search()->popup(); }
  template <class Widget>
  Widget* part(const char* name) {
    return window->findChild<Widget*>(QLatin1String(name));
  }
  void ask(const QString& query) {
    QTest::keyClick(window.get(), Qt::Key_K, Qt::ControlModifier);
    QTRY_VERIFY(search()->hasFocus());
    QTest::keyClicks(search(), query);
  }
  void press(Qt::Key key) { QTest::keyClick(search(), key); }

 private slots:
  void initTestCase() { test::setUpProgram(); }
  void init() {
    window = test::openedWindow(robotExamplePath());
    QVERIFY(window != nullptr);
    window->digraph().setFocus();
  }
  void cleanup() { window.reset(); }

  void enterSelectsTheElementAndGivesTheKeyboardBack() {
    ask("joint 12");
    QVERIFY(popup().isVisible());
    QCOMPARE(window->selection().hovered(),
             std::set<ElementId>{JointId("12")});  // highlighted before it is chosen
    press(Qt::Key_Return);
    QVERIFY(!popup().isVisible());
    QCOMPARE(window->selection().selected(), std::set<ElementId>{JointId("12")});
    QVERIFY(window->selection().hovered().empty());
    QVERIFY(window->digraph().hasFocus());
    QVERIFY(search()->text().isEmpty());
  }

  void whatIsTooLongToSearchForIsCut() {
    QApplication::clipboard()->setText(QString(100'000, QLatin1Char('x')));
    search()->paste();
    QCOMPARE(search()->text().size(), 200);
    search()->clear();
  }

  void elementsOfALargeDocumentFollow() {
    window->document().replace(test::randomTrain(7, 3000, 1000), {});
    ask("joint 4321");
    QTRY_COMPARE(search()->model().rowCount(), 1);
    QVERIFY(search()->model().entryAt(0).element.has_value());
    QTest::keyClicks(search(), "0");  // no such joint
    QCOMPARE(search()->model().rowCount(), 0);
    press(Qt::Key_Escape);
    window->document().replace(test::randomTrain(7, 3, 1), {});
    ask("joint 4321");
    QCOMPARE(search()->model().rowCount(), 0);  // those of another document are not offered
  }

  void whatIsChosenIsBroughtIntoSight() {
    QTest::keyClick(&window->digraph(), Qt::Key_1, Qt::ControlModifier);
    for (int i = 0; i < 8; ++i) window->digraph().zoomIn();
    const auto inSight = [this](int link) {
      return window->digraph().viewport()->rect().contains(test::Hand(*window).placeOf(link));
    };
    for (const int link : {3, 0, 6}) {
      ask(QStringLiteral("link %1").arg(link));
      press(Qt::Key_Return);
      QVERIFY2(inSight(link), qPrintable(QString::number(link)));
    }
  }

  void aCommandIsCarriedOutByItsName() {
    ask("link draw");
    ask("select all");
    press(Qt::Key_Return);
    QCOMPARE(window->selection().selected().size(), std::size_t{19});
    ask("example spur");
    press(Qt::Key_Return);
    QCOMPARE(window->windowTitle(), QString("spur-pair.geargraph[*] — GearGraph"));
  }

  void anImpossibleCommandSaysWhy() {
    ask("undo");
    QCOMPARE(part<QLabel>("searchDetail")->text(), QString("There is nothing to undo."));
    press(Qt::Key_Return);
    QCOMPARE(window->statusLine().text(), QString("There is nothing to undo."));
  }

  void aPanelBehindAnotherComesToTheFront() {
    auto* panel = window->findChild<QDockWidget*>("dock.gearbox");
    QVERIFY(!panel->findChild<QAction*>("dock.gearbox")->isChecked());
    ask("shift");
    press(Qt::Key_Return);
    auto* action = panel->findChild<QAction*>("dock.gearbox");
    QTRY_VERIFY(action->isChecked());
    QVERIFY(!panel->isHidden());
    ask("gearbox");  // it stays
    press(Qt::Key_Return);
    QCoreApplication::processEvents();
    QVERIFY(action->isChecked());
    action->trigger();
    QTRY_VERIFY(panel->isHidden());
  }

  void aTermShowsItsDefinition() {
    ask("cutset");
    press(Qt::Key_Return);
    QVERIFY(popup().isDefinition());
    QVERIFY(part<QLabel>("searchDefinition")->text().contains("two halves"));
    press(Qt::Key_Escape);
    QVERIFY(!popup().isVisible());
    window->actions()[CommandId::lookUp]->trigger();  // terms alone
    QTest::keyClicks(search(), "turning joint");
    QCOMPARE(search()->model().index(0).data(SearchModel::KindRole).toString(), QString("term"));
  }

  void arrowKeysAndTheMouseChoose() {
    ask("mesh");
    press(Qt::Key_Down);
    press(Qt::Key_Down);
    press(Qt::Key_Up);
    QCOMPARE(popup().currentRow(), 1);
    press(Qt::Key_Escape);
    QVERIFY(window->selection().hovered().empty());
    QVERIFY(window->digraph().hasFocus());
    ask("gear mesh 17");
    QListView& list = popup().list();
    QTest::mouseClick(list.viewport(), Qt::LeftButton, {},
                      list.visualRect(list.model()->index(0, 0)).center());
    QCOMPARE(window->selection().selected(), std::set<ElementId>{MeshId("17")});
  }

  void synonymsFindTheirFeature_data() {
    QTest::addColumn<QString>("command");
    constexpr std::pair<const char*, const char*> kWanted[] = {
        {"brake", "dock.gearbox|mechanism.hold"},
        {"hold", "dock.gearbox|mechanism.hold"},
        {"clutch", "dock.gearbox"},
        {"engage", "dock.gearbox|mechanism.hold"},
        {"release", "mechanism.releaseAll|dock.gearbox"},
        {"unlock", "mechanism.releaseAll"},
        {"shift", "dock.gearbox"},
        {"gear ratio", "dock.gearbox|dock.inputs"},
        {"ratio", "dock.inputs|dock.gearbox"},
        {"transmission", "dock.inputs|dock.gearbox"},
        {"reduction", "dock.inputs"},
        {"speed", "dock.inputs|dock.speeds|mechanism.drive"},
        {"rpm", "dock.inputs"},
        {"relative", "dock.inputs"},
        {"result", "dock.inputs"},
        {"motor", "mechanism.drive|dock.inputs"},
        {"actuator", "mechanism.drive"},
        {"torque", "mechanism.load|dock.forces"},
        {"force", "dock.forces|mechanism.load"},
        {"load", "mechanism.load|dock.forces"},
        {"efficiency", "dock.forces"},
        {"losses", "dock.forces|view.powerFlow"},
        {"bearing", "dock.forces"},
        {"power", "view.powerFlow|dock.forces"},
        {"watt", "view.powerFlow"},
        {"inertia", "dock.dynamics"},
        {"mass", "dock.dynamics"},
        {"gravity", "dock.dynamics"},
        {"simulation", "dock.dynamics|motion.play"},
        {"teeth", "dock.properties|mechanism.attachGear"},
        {"pinion", "mechanism.attachGear"},
        {"wheel", "mechanism.attachGear"},
        {"planetary", "mechanism.insertSet"},
        {"epicyclic", "mechanism.insertSet"},
        {"differential", "mechanism.insertSet"},
        {"sun", "mechanism.insertSet"},
        {"frame", "mechanism.ground"},
        {"fix", "mechanism.ground|mechanism.hold|dock.problems"},
        {"reverse", "mechanism.flip|motion.backwards"},
        {"arrange", "mechanism.tidy"},
        {"spreadsheet", "file.exportCsv"},
        {"excel", "file.exportCsv"},
        {"png", "file.exportPicture|edit.copyPicture"},
        {"svg", "file.exportPicture|edit.copyPicture"},
        {"video", "file.exportPicture"},
        {"film", "file.exportPicture"},
        {"web page", "file.exportHandout"},
        {"html", "file.exportHandout"},
        {"printer", "file.print"},
        {"paper", "file.print|learn.check"},
        {"clipboard", "edit.copyPicture"},
        {"screenshot", "edit.copyPicture"},
        {"remove", "edit.delete"},
        {"clone", "edit.duplicate"},
        {"undo", "edit.undo|edit.history"},
        {"error", "dock.problems"},
        {"mistake", "dock.problems"},
        {"graph", "dock.speeds"},
        {"chart", "dock.speeds"},
        {"plot", "dock.speeds"},
        {"matrix", "dock.matrices|file.exportCsv"},
        {"equation", "dock.derivation|learn.derivation|learn.check|dock.dynamics"},
        {"proof", "dock.derivation|learn.derivation"},
        {"quiz", "learn.exercises"},
        {"homework", "learn.exercises|learn.check"},
        {"tutorial", "learn.lessons"},
        {"course", "learn.lessons"},
        {"dictionary", "learn.lookUp"},
        {"definition", "learn.lookUp"},
        {"animate", "motion.play"},
        {"rewind", "motion.start|motion.backwards"},
        {"beamer", "view.presentation"},
        {"projector", "view.presentation"},
        {"full screen", "view.presentation"},
        {"night", "view.dark"},
        {"theme", "view.dark|view.light|view.highContrast|view.asSystem"},
        {"font", "view.typeSize150"},
        {"language", "view.language.de|view.language.en|view.language.|view.language.tr"},
        {"raster", "view.grid"},
        {"zoom", "view.fit|view.zoomIn|view.zoomOut"},
        {"hotkeys", "help.shortcuts"},
        {"documentation", "help.manual"},
        {"licence", "help.about"},
        {"examples", "file.startPage"},
        {"solid", "dock.view3d|view.half3d"},
    };
    for (const auto& [word, command] : kWanted) QTest::newRow(word) << QString(command);
  }
  void synonymsFindTheirFeature() {
    QFETCH(QString, command);
    const QStringList wanted = command.split('|');
    ask(QString(QTest::currentDataTag()));
    constexpr int kInSight = 6;
    const SearchModel& model = search()->model();
    QStringList found;
    for (int row = 0; row < std::min(kInSight, model.rowCount()); ++row) {
      const SearchEntry& entry = model.entryAt(row);
      found << (entry.action != nullptr ? entry.action->objectName() : entry.title);
    }
    const bool isFound =
        std::any_of(found.begin(), found.end(), [&](const QString& name) { return wanted.contains(name); });
    QVERIFY2(isFound, qPrintable(found.join(", ")));
    press(Qt::Key_Escape);
  }

  void whatIsNotThereIsSaid() {
    ask("xyzzy");
    QCOMPARE(popup().currentRow(), -1);
    press(Qt::Key_Return);
    QVERIFY(popup().isVisible());
    press(Qt::Key_Escape);
    QVERIFY(!popup().isVisible());
  }

  void lettersTypedAreNoTools() {
    ask("tlg");
    QCOMPARE(window->digraph().tool(), ToolKind::select);
    QCOMPARE(search()->text(), QString("tlg"));
    QTest::keyClick(search(), Qt::Key_Backspace);
    QTest::keyClick(search(), Qt::Key_Delete);
    QVERIFY(!window->document().isModified());
  }

  // While the 3D view with its own transport is away.
  void theMotionPlaysFromTheToolBar() {
    Playback& playback = window->view3d().playback();
    window->docks().of(window->view3d())->hide();
    auto* play = part<QToolButton>("play");
    QTest::mouseClick(play, Qt::LeftButton);
    QVERIFY(playback.isPlaying());
    QVERIFY(play->toolTip().startsWith("Pause"));
    QTest::keyClick(&window->digraph(), Qt::Key_Space);
    QVERIFY(!playback.isPlaying());
    window->actions()[CommandId::play]->trigger();
    QVERIFY(playback.isPlaying());
    QVERIFY(window->actions()[CommandId::play]->text().startsWith("&Pause"));
    window->actions()[CommandId::play]->trigger();
  }

  void theSliderSetsTheSpeed() {
    Playback& playback = window->view3d().playback();
    window->docks().of(window->view3d())->hide();
    auto* slider = part<QSlider>("playSpeed");
    auto* shown = part<QLabel>("playSpeedText");
    QCOMPARE(shown->text(), QString("1.0×"));
    slider->setFocus();
    QTest::keyClick(slider, Qt::Key_End);
    QCOMPARE(playback.speed(), 8.0);
    QCOMPARE(shown->text(), QString("8.0×"));
    window->actions()[CommandId::faster]->trigger();
    QCOMPARE(playback.speed(), 8.0);  // the fastest
    window->actions()[CommandId::slower]->trigger();
    QVERIFY(playback.speed() < 8);
    QTest::mouseDClick(slider, Qt::LeftButton);
    QCOMPARE(playback.speed(), 1.0);
    window->actions()[CommandId::backwards]->trigger();
    QCOMPARE(shown->text(), QString("−1.0×"));
    QTest::keyClick(slider, Qt::Key_Home);
    QCOMPARE(playback.speed(), -0.125);
    QCOMPARE(shown->text(), QString("−0.13×"));
    window->actions()[CommandId::normalSpeed]->trigger();
    QVERIFY(!window->actions()[CommandId::backwards]->isChecked());
  }
};

}  // namespace geargraph

QTEST_MAIN(geargraph::WindowSearchTest)
#include "test_window_search.moc"

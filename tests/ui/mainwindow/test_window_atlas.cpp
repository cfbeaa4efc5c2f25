#include <QLabel>
#include <QTest>

#include "tests/ui/mainwindow/file_windows.h"
#include "ui/atlas_panel/atlas_panel.h"
#include "ui/canvas/digraph_view.h"
#include "ui/mainwindow/window_actions.h"

namespace geargraph {

/// The atlas in its window: a tab that is no drawing.
class WindowAtlasTest : public QObject, protected test::FileWindows {
  Q_OBJECT

  static AtlasPanel& atlasOf(MainWindow& window) { return window.views().get<AtlasPanel>(); }

 private slots:
  void initTestCase() { setUpWindows(); }
  void init() {
    makeFolder();
    set->start({robotExamplePath()});
    QVERIFY(QTest::qWaitForWindowExposed(&first()));
    QTRY_VERIFY(first().isSettled());
  }
  void cleanup() {
    set.reset();
    folder.reset();
  }

  void theCommandBringsItToTheFront() {
    AtlasPanel& atlas = atlasOf(first());
    QVERIFY(!atlas.isVisible());
    first().actions()[CommandId::atlas]->trigger();
    QVERIFY(atlas.isVisible());
    QTRY_VERIFY(first().isSettled());
    QVERIFY(atlas.findChild<QLabel*>("train")->text().contains("4-1.1.2"));
    // Commands apply to the drawing that was in front; a tool brings it back.
    QCOMPARE(&first().drawing(), static_cast<DrawingView*>(&first().digraph()));
    first().actions().tool[static_cast<std::size_t>(ToolKind::link)]->trigger();
    QVERIFY(!atlas.isVisible() && first().digraph().isVisible());
    first().showDrawing("ttgraph");
    first().showDrawing("atlas");
    QCOMPARE(first().drawing().objectName(), QString("ttgraph"));
  }

  void aChainOpensInAWindowOfItsOwn() {
    const MechanismPtr before = first().document().mechanism();
    first().actions()[CommandId::atlas]->trigger();
    QTRY_VERIFY(first().isSettled());
    QVERIFY(atlasOf(first()).showChain({6, 1, 12, 1}));
    atlasOf(first()).openChosen();
    QTRY_COMPARE(set->windows().size(), std::size_t{2});
    QTRY_VERIFY(last().isSettled());
    QCOMPARE(last().document().mechanism()->links.size(), std::size_t{6});
    QCOMPARE(last().document().undoStack().count(), 1);
    QVERIFY(last().document().filePath().isEmpty() && last().document().isModified());
    QCOMPARE(first().document().mechanism(), before);
  }

  void aWindowAloneSaysWhyNot() {
    auto window = test::openedWindow(robotExamplePath());
    QVERIFY(window != nullptr);
    QString why;
    connect(&window->files(), &WindowFiles::rejected, this, [&](const QString& text) { why = text; });
    window->showDrawing("atlas");
    QTRY_VERIFY(window->isSettled());
    QVERIFY(atlasOf(*window).showChain({4, 1, 1, 1}));
    atlasOf(*window).openChosen();
    QTRY_VERIFY(!why.isEmpty());
  }
};

}  // namespace geargraph

QTEST_MAIN(geargraph::WindowAtlasTest)

#include "test_window_atlas.moc"

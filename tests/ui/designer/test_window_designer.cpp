#include <QDockWidget>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QTabWidget>
#include <QTest>
#include <QToolButton>
#include <algorithm>

#include "tests/ui/mainwindow/file_windows.h"
#include "ui/designer/designer_panel.h"
#include "ui/designer/hits_table.h"
#include "ui/mainwindow/view_docks.h"
#include "ui/mainwindow/window_actions.h"
#include "ui/mainwindow/window_files.h"

namespace geargraph {

/// The designer in its window: its command, and the document that comes of it.
class WindowDesignerTest : public QObject, protected test::FileWindows {
  Q_OBJECT

 private slots:
  void initTestCase() { setUpWindows(); }
  void init() {
    makeFolder();
    set->start({});
  }
  void cleanup() { set.reset(); }

  void aFoundGearboxIsOpenedAsADocumentWithStates() {
    MainWindow& window = first();
    QVERIFY(QTest::qWaitForWindowExposed(&window));
    window.actions()[CommandId::designGearbox]->trigger();
    auto& panel = window.views().get<DesignerPanel>();
    QTRY_VERIFY(panel.isVisible());
    const auto docks = window.findChildren<QDockWidget*>();
    const auto isAround = [](const QDockWidget* dock) { return !dock->isHidden() && !dock->isFloating(); };
    QVERIFY(std::none_of(docks.begin(), docks.end(), isAround));  // the panels make room
    QVERIFY(panel.width() >= window.width() - 20);
    panel.findChild<QPlainTextEdit*>("wishRatios")->setPlainText("2.52 1.52 1");
    QTest::mouseClick(panel.findChild<QPushButton*>("searchGearboxes"), Qt::LeftButton);
    QTRY_VERIFY_WITH_TIMEOUT(panel.isDone(), 120'000);
    QVERIFY(panel.hits()->chosen() != nullptr);
    const std::size_t windows = set->windows().size();
    QTest::mouseClick(panel.findChild<QPushButton*>("openHit"), Qt::LeftButton);
    QTRY_COMPARE(set->windows().size(), windows + 1);
    MainWindow& opened = last();
    const Mechanism& made = *opened.document().mechanism();
    QCOMPARE(made.states.size(), 4U);  // three forward gears and a reverse
    QCOMPARE(opened.document().undoStack().count(), 1);
    QCOMPARE(window.document().mechanism()->n(), 0);  // the one of before stays as it is
    QTRY_VERIFY(opened.isSettled());
    opened.document().undoStack().undo();
    QCOMPARE(opened.document().mechanism()->n(), 0);
  }

  void theStartPageAndTheDialogOfSetsLeadToIt() {
    MainWindow& window = first();
    QVERIFY(QTest::qWaitForWindowExposed(&window));
    auto& panel = window.views().get<DesignerPanel>();
    auto* start = window.findChild<QPushButton*>("startDesign");
    QVERIFY(start != nullptr && start->isVisible() && !panel.isVisible());
    QTest::mouseClick(start, Qt::LeftButton);
    QVERIFY(panel.isVisible() && !start->isVisible());
    window.showDrawing("digraph");
    window.actions()[CommandId::insertSet]->trigger();
    auto* instead = window.findChild<QPushButton*>("designInstead");
    QVERIFY(instead != nullptr && instead->isVisible());
    QTest::mouseClick(instead, Qt::LeftButton);
    QVERIFY(panel.isVisible() && !instead->isVisible());
  }

  /// With another drawing the panels are where they were, and what is saved is never the layout without them.
  void panelsComeBackAsTheyWere() {
    MainWindow& window = first();
    QVERIFY(QTest::qWaitForWindowExposed(&window));
    const auto shown = [&window] {
      QStringList names;
      for (const auto* dock : window.findChildren<QDockWidget*>())
        if (!dock->isHidden()) names << dock->objectName();
      names.sort();
      return names;
    };
    window.docks().of(window.views().byId("inputs"))->hide();
    const QStringList before = shown();
    QVERIFY(!before.isEmpty());
    for (const CommandId command : {CommandId::designGearbox, CommandId::hardware}) {
      window.actions()[command]->trigger();
      QVERIFY(shown().isEmpty());
      QCOMPARE(window.workLayout().state, window.docks().layout());
    }
    auto* drawings = window.findChild<QTabWidget*>("drawings");
    auto* close = window.findChild<QToolButton*>("close.hardware");
    QVERIFY(close != nullptr && close->isVisible());
    const int tab = drawings->currentIndex();
    QTest::mouseClick(close, Qt::LeftButton);
    QVERIFY(!drawings->isTabVisible(tab));
    QCOMPARE(drawings->currentWidget()->objectName(), QString("digraph"));
    QCOMPARE(shown(), before);
    window.actions()[CommandId::hardware]->trigger();
    QVERIFY(drawings->isTabVisible(tab) && shown().isEmpty());
  }
};

}  // namespace geargraph

QTEST_MAIN(geargraph::WindowDesignerTest)

#include "test_window_designer.moc"

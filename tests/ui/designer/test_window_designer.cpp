#include <QDockWidget>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QScreen>
#include <QTest>
#include <algorithm>

#include "tests/ui/mainwindow/file_windows.h"
#include "ui/designer/designer_panel.h"
#include "ui/designer/hits_table.h"
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
    const QSize screen = panel.screen()->availableSize();  // not squeezed into a row of panels
    QVERIFY(panel.width() >= std::min(900, screen.width() * 3 / 4) && panel.height() >= 400);
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
};

}  // namespace geargraph

QTEST_MAIN(geargraph::WindowDesignerTest)

#include "test_window_designer.moc"

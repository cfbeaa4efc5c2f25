#include <QContextMenuEvent>
#include <QMenu>
#include <QTest>

#include "core/theory/states/state_edits.h"
#include "tests/ui/mainwindow/hand.h"
#include "tests/ui/mainwindow/readings.h"
#include "ui/canvas/digraph_view.h"
#include "ui/canvas/schematic_view.h"
#include "ui/mainwindow/status_line.h"
#include "ui/panels/results_panel.h"
#include "ui/view3d/view3d.h"

namespace geargraph {

/// What a brake or a clutch would do, shown while the mouse is on its entry in a menu.
class BrakePreviewTest : public QObject {
  Q_OBJECT

  std::unique_ptr<MainWindow> window;

  [[nodiscard]] MechanismPtr now() const { return window->document().mechanism(); }
  [[nodiscard]] MechanismPtr derived() const { return window->analysis().snapshot()->mechanism; }
  [[nodiscard]] QString rateOfLink(int label) const { return test::rateOfLink(*window, label); }
  /// The menu of a link, as the menu key opens it in a drawing or in 3D.
  QMenu* menuOfLink(QWidget& view, const char* link) {
    window->workbench().selection().select({LinkId(link)});
    QContextMenuEvent event(QContextMenuEvent::Keyboard, {1, 1}, view.mapToGlobal(QPoint(1, 1)));
    auto* area = qobject_cast<QAbstractScrollArea*>(&view);
    QApplication::sendEvent(area != nullptr ? area->viewport() : &view, &event);
    QMenu* open = nullptr;
    const bool isOpen = QTest::qWaitFor([&] {
      open = qobject_cast<QMenu*>(QApplication::activePopupWidget());
      return open != nullptr;
    });
    return isOpen ? open : nullptr;
  }
  static QAction* entry(const QMenu& menu, const QString& text) {
    for (QAction* action : menu.actions()) {
      if (action->text().remove(QLatin1Char('&')).startsWith(text)) return action;
    }
    return nullptr;
  }
  static void moveOn(QMenu& menu, QAction* action) {
    const QPoint at = menu.actionGeometry(action).center();
    // A menu that opens under the mouse ignores its first few motions.
    for (int before = 9; before >= 0; --before) QTest::mouseMove(&menu, at - QPoint(before, 0));
  }
  static void clickOn(QMenu& menu, QAction* action) {
    QTest::mouseClick(&menu, Qt::LeftButton, {}, menu.actionGeometry(action).center());
  }
  /// Everything is that of the document again, and nothing of it has changed.
  void verifyUntouched(const MechanismPtr& before, const QString& rate) {
    QTRY_COMPARE(derived(), before);
    QTRY_VERIFY(window->isSettled());
    QCOMPARE(now(), before);
    QCOMPARE(window->document().undoStack().count(), 0);
    QVERIFY(!window->document().isModified());
    QCOMPARE(rateOfLink(3), rate);
    QVERIFY(!window->statusLine().text().startsWith("Preview"));
  }
  /// The ring as the entry's brake holds it: results, and the train in 3D.
  void verifyHeld(const MechanismScenePtr& before) {
    QTRY_VERIFY(derived()->engaged.size() == 1);
    QTRY_COMPARE(rateOfLink(3), QStringLiteral("0"));
    QTRY_VERIFY(window->view3d().stage() != before);
    QVERIFY2(window->statusLine().text().startsWith("Preview"), qPrintable(window->statusLine().text()));
  }
  void tryAndLeave(QWidget& view, const QString& text, const QString& elsewhere) {
    const MechanismPtr before = now();
    const QString rate = rateOfLink(3);
    QVERIFY(!rate.isEmpty() && rate != QStringLiteral("0"));
    const MechanismScenePtr stage = window->view3d().stage();
    QMenu* menu = menuOfLink(view, "3");
    QVERIFY(menu != nullptr && entry(*menu, text) != nullptr);
    QCOMPARE(derived(), before);  // nothing is tried before the mouse is on it
    moveOn(*menu, entry(*menu, text));
    verifyHeld(stage);
    moveOn(*menu, entry(*menu, elsewhere));
    verifyUntouched(before, rate);
    const MechanismScenePtr again = window->view3d().stage();
    moveOn(*menu, entry(*menu, text));
    verifyHeld(again);
    QTest::keyClick(menu, Qt::Key_Escape);
    verifyUntouched(before, rate);
  }

 private slots:
  void initTestCase() { test::setUpProgram(); }
  void init() {
    window = test::openedWindow(QStringLiteral(":/examples/ravigneaux.geargraph"));
    QVERIFY(window != nullptr);
    window->resize(1280, 720);
    const Expected<Mechanism> released = withCouplingsEngaged(*now(), {});
    QVERIFY(released.has_value());
    Mechanism driven = *released;
    driven.couplings.clear();
    driven.states.clear();
    driven.inputs = {{JointId("7"), Number(3), {}}, {JointId("8"), Number(1), {}}};
    window->document().replace(driven, {});
    QTRY_VERIFY(window->isSettled());
    QTRY_VERIFY(window->analysis().isComplete());
  }
  void cleanup() { window.reset(); }

  void theDigraphShowsWhatABrakeWouldDo() {
    tryAndLeave(window->digraph(), QStringLiteral("Hold it with a brake"), QStringLiteral("Rename"));
  }

  void soDoesThe3DView() {
    tryAndLeave(window->view3d(), QStringLiteral("Hold with a brake"), QStringLiteral("Rename"));
  }

  void keysTryAnEntryToo() {
    const MechanismPtr before = now();
    QMenu* menu = menuOfLink(window->digraph(), "3");
    QVERIFY(menu != nullptr);
    for (int i = 0; i < 12 && menu->activeAction() != entry(*menu, "Hold it"); ++i)
      QTest::keyClick(menu, Qt::Key_Down);
    QTRY_COMPARE(derived()->engaged.size(), std::size_t{1});
    QTest::keyClick(menu, Qt::Key_Up);
    QTRY_COMPARE(derived(), before);
    menu->close();
  }

  /// A choice is one step, that of the entry itself.
  void aClickKeepsIt() {
    const MechanismPtr before = now();
    QMenu* menu = menuOfLink(window->digraph(), "3");
    QVERIFY(menu != nullptr);
    moveOn(*menu, entry(*menu, "Hold it"));
    QTRY_COMPARE(derived()->engaged.size(), std::size_t{1});
    clickOn(*menu, entry(*menu, "Hold it"));
    QTRY_COMPARE(window->document().undoStack().count(), 1);
    QCOMPARE(now()->engaged.size(), std::size_t{1});
    QTRY_COMPARE(derived(), now());
    QTRY_COMPARE(rateOfLink(3), QStringLiteral("0"));
    // An engaged brake is released on trial, and engaged again.
    menu = menuOfLink(window->digraph(), "3");
    QVERIFY(menu != nullptr);
    moveOn(*menu, entry(*menu, "Release brake"));
    QTRY_VERIFY(derived()->engaged.empty());
    QCOMPARE(now()->engaged.size(), std::size_t{1});
    QTest::keyClick(menu, Qt::Key_Escape);
    QTRY_COMPARE(derived(), now());
    window->document().undoStack().undo();
    QCOMPARE(*now(), *before);
  }

  /// The schematic is drawn and edited as before: only what is derived is tried.
  void theDrawingsStayThoseOfTheDocument() {
    const DisplayList before = window->digraph().picture();
    QMenu* menu = menuOfLink(window->digraph(), "3");
    QVERIFY(menu != nullptr);
    moveOn(*menu, entry(*menu, "Hold it"));
    QTRY_COMPARE(derived()->engaged.size(), std::size_t{1});
    QCOMPARE(window->digraph().picture().outlines.size(), before.outlines.size());
    menu->close();
    QTRY_COMPARE(derived(), now());
  }
};

}  // namespace geargraph

QTEST_MAIN(geargraph::BrakePreviewTest)
#include "test_brake_preview.moc"

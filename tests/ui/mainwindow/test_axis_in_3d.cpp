#include <QAction>
#include <QApplication>
#include <QMenu>
#include <QMouseEvent>
#include <QTest>

#include "core/mechanism/geometry_edits/axis_drag.h"
#include "core/mechanism/geometry_edits/fitted_edits.h"
#include "core/mechanism/model/edits.h"
#include "tests/ui/mainwindow/hand.h"
#include "ui/canvas/digraph_view.h"
#include "ui/mainwindow/status_line.h"
#include "ui/view3d/axis_handle.h"
#include "ui/view3d/view3d.h"

namespace geargraph {

/// Dragging an axis in the 3D view of the window, by mouse and by keys.
class AxisIn3DTest : public QObject {
  Q_OBJECT

  std::unique_ptr<MainWindow> window;

  AxisHandle* handle() { return window->view3d().findChild<AxisHandle*>(); }
  [[nodiscard]] AxisReach reach(AxisId axis) { return *axisReach(window->document().placed(), axis); }
  [[nodiscard]] AxisId second() { return window->document().mechanism()->axes[1].id; }
  int steps() { return window->document().undoStack().index(); }

  void open(const char* example) {
    window = test::openedWindow(QStringLiteral(":/examples/%1.geargraph").arg(QLatin1String(example)));
    QVERIFY(window != nullptr);
    QTRY_VERIFY(window->view3d().stage() != nullptr && !window->view3d().stage()->labels.empty());
    window->view3d().showFrom(StandardView::front);
    window->view3d().fit();
  }
  void send(QEvent::Type type, QPoint away, Qt::MouseButtons down, Qt::KeyboardModifiers keys = {}) {
    const QPointF middle = QRectF(handle()->rect()).center();
    const QPointF global = QPointF(m_grabbedAt) + away;
    QMouseEvent event(type, middle, global, type == QEvent::MouseMove ? Qt::NoButton : Qt::LeftButton, down,
                      keys);
    QApplication::sendEvent(handle(), &event);
  }
  void grab() {
    m_grabbedAt = handle()->mapToGlobal(handle()->rect().center());
    send(QEvent::MouseButtonPress, {}, Qt::LeftButton);
  }
  void pull(QPoint away, Qt::KeyboardModifiers keys = {}) {
    send(QEvent::MouseMove, away, Qt::LeftButton, keys);
  }
  void release(QPoint away) { send(QEvent::MouseButtonRelease, away, Qt::NoButton); }
  /// A way on the screen that leads outward from the other axis: tried, as the view may be turned.
  QPoint outward(AxisId axis) {
    const double before = reach(axis).distance;
    for (const QPoint way : {QPoint(40, 0), QPoint(-40, 0), QPoint(0, 40), QPoint(0, -40)}) {
      grab();
      pull(way, Qt::AltModifier);
      const bool grows = reach(axis).distance > before * 1.01;
      QTest::keyClick(handle(), Qt::Key_Escape);
      release(way);
      if (grows) return way;
    }
    return {};
  }

  QPoint m_grabbedAt;

 private slots:
  void initTestCase() { test::setUpProgram(); }
  void cleanup() { window.reset(); }

  void theHandleIsThereWhereOneAxisIsSelected() {
    open("spur-pair");
    QVERIFY(handle()->isHidden());
    window->selection().select({window->document().mechanism()->links[1].id});  // a link has none
    QVERIFY(handle()->isHidden());
    window->selection().select({second()});
    QVERIFY(handle()->isVisible());
    QVERIFY(window->view3d().rect().contains(handle()->geometry()));
    QVERIFY(handle()->accessibleName().startsWith(QStringLiteral("Handle of axis")));
    window->selection().select({window->document().mechanism()->turningJoints[1].id});
    QVERIFY(handle()->isVisible());
    QVERIFY(handle()->accessibleName().startsWith(QStringLiteral("Handle of the axis of joint")));
    window->selection().select({second(), LinkId("1")});
    QVERIFY(handle()->isHidden());
  }

  void draggingItMovesTheAxisAsOneStep() {
    open("spur-pair");
    window->selection().select({second()});
    const AxisReach before = reach(second());
    const Camera camera = window->view3d().camera();
    const QPoint way = outward(second());
    QVERIFY(!way.isNull());
    QCOMPARE(steps(), 0);  // what was put back left no step
    QCOMPARE(reach(second()).distance, before.distance);
    grab();
    pull(way / 2);
    pull(way);
    const AxisReach during = reach(second());
    QVERIFY(during.distance > before.distance);
    const double steps20 = during.module / kModuleStep;
    QVERIFY(std::abs(steps20 - std::round(steps20)) < 1e-6);  // it snaps as in the schematic
    QVERIFY(window->statusLine().text().contains(QStringLiteral("module")));
    release(way);
    if (QWidget* offer = QApplication::activePopupWidget()) {
      QCOMPARE(offer->objectName(), QStringLiteral("axisOffer"));
      offer->close();
    }
    QCoreApplication::processEvents();
    QCOMPARE(steps(), 1);
    QCOMPARE(window->document().undoStack().undoText(),
             QStringLiteral("Move axis %1").arg(QString::fromStdString(second().text())));
    QVERIFY(window->view3d().camera() == camera);  // the picture stays as it was
    window->actions()[CommandId::undo]->trigger();
    QCOMPARE(reach(second()).distance, before.distance);
  }

  void arrowKeysMoveIt() {
    open("spur-pair");
    window->selection().select({second()});
    const double before = reach(second()).distance;
    const QPoint way = outward(second());
    QVERIFY(window->view3d().takeAxisHandle());
    const Qt::Key key = way.x() > 0   ? Qt::Key_Right
                        : way.x() < 0 ? Qt::Key_Left
                        : way.y() > 0 ? Qt::Key_Down
                                      : Qt::Key_Up;
    QTest::keyClick(handle(), key);
    QVERIFY(reach(second()).distance > before);
    QVERIFY(window->statusLine().text().contains(QStringLiteral("module")));
    QCOMPARE(steps(), 1);
    const double coarse = reach(second()).distance - before;
    QTest::keyClick(handle(), key, Qt::ShiftModifier);
    QVERIFY(reach(second()).distance - before - coarse < coarse / 2);
    QCOMPARE(steps(), 2);
  }

  /// The wrong way: an axis that is pinned.
  void aPinnedAxisSaysWhyItStays() {
    open("spur-pair");
    window->document().apply(
        {QStringLiteral("Pin"),
         [axis = second()](const PlacedMechanism& m) { return withPinned(m, axis, true); }, 0});
    QTRY_VERIFY(window->isSettled());
    window->selection().select({second()});
    const MechanismPtr before = window->document().mechanism();
    grab();
    pull({50, 30});
    release({50, 30});
    QCOMPARE(*window->document().mechanism(), *before);
    QVERIFY2(window->statusLine().text().contains(QStringLiteral("pinned")),
             qPrintable(window->statusLine().text()));
  }

  /// Axes are those of the reference pose.
  void grabbingItGoesBackToTheReferencePose() {
    open("planetary-ring-held");
    window->view3d().playback().setPlaying(false);
    window->view3d().playback().setTime(1.7);
    window->selection().select({second()});
    grab();
    pull({20, 0}, Qt::AltModifier);
    QCOMPARE(window->view3d().playback().time(), 0.0);
    QTest::keyClick(handle(), Qt::Key_Escape);
    release({20, 0});
    QCOMPARE(steps(), 0);
  }
};

}  // namespace geargraph

QTEST_MAIN(geargraph::AxisIn3DTest)
#include "test_axis_in_3d.moc"

#include <QApplication>
#include <QContextMenuEvent>
#include <QLabel>
#include <QMainWindow>
#include <QMenu>
#include <QNativeGestureEvent>
#include <QPointingDevice>
#include <QScopeGuard>
#include <QScreen>
#include <QSettings>
#include <QSignalSpy>
#include <QSlider>
#include <QTemporaryDir>
#include <QTest>
#include <QToolButton>
#include <QWheelEvent>

#include "core/foundations/base/locale.h"
#include "tests/ui/view3d/toy_stage.h"
#include "ui/view3d/view3d.h"

using namespace geargraph;

namespace {

/// The view in a window, with the toy on its stage, painted at least once; without the plates that would lie
/// over the places where tests look.
struct Shown {
  Selection selection;
  View3D view{&selection};

  explicit Shown(const MechanismScenePtr& stage = test::toyStage()) {
    ViewOptions options = view.options();
    options.linkLabels = false;
    view.setOptions(options);
    view.resize(640, 420);
    view.setScene(stage);
    view.show();
    if (!QTest::qWaitForWindowExposed(&view)) qFatal("The window was not exposed");
    canvas()->setFocus();
    view.grab();
    QTest::qWait(0);
  }

  [[nodiscard]] QWidget* canvas() { return view.findChild<QWidget*>("view3dCanvas"); }
  [[nodiscard]] Viewport viewport() { return {canvas()->width(), canvas()->height()}; }
  /// Where a point of the world is, on the canvas.
  [[nodiscard]] QPoint at(const Eigen::Vector3d& point) {
    const ScreenPoint place = view.camera().project(point, viewport());
    return QPoint(qRound(place.x), qRound(place.y));
  }
  void moveTo(const QPoint& place) { QTest::mouseMove(canvas(), place); }
  void drag(Qt::MouseButton button, Qt::KeyboardModifiers keys, const QPoint& from, const QPoint& by) {
    QTest::mousePress(canvas(), button, keys, from);
    const auto move = [&](const QPoint& to) {
      QMouseEvent event(QEvent::MouseMove, to, canvas()->mapToGlobal(to), Qt::NoButton, button, keys);
      QApplication::sendEvent(canvas(), &event);
    };
    for (int step = 1; step <= 4; ++step) move(from + by * step / 4);
    QTest::mouseRelease(canvas(), button, keys, from + by);
  }
  void wheel(const QPoint& at, int delta) {
    QWheelEvent event(at, canvas()->mapToGlobal(at), {}, {0, delta}, Qt::NoButton, Qt::NoModifier,
                      Qt::NoScrollPhase, false);
    QApplication::sendEvent(canvas(), &event);
  }
};

/// Events of a kind that an object gets.
struct Counter : QObject {
  int count = 0;
  QEvent::Type type;

  Counter(QObject* watched, QEvent::Type counted) : type(counted) { watched->installEventFilter(this); }
  bool eventFilter(QObject*, QEvent* event) override {
    if (event->type() == type) ++count;
    return false;
  }
};

const Eigen::Vector3d kOnBox(0, 0, 30), kOnFirst(0, -36, 4), kOnSecond(0, 36, 4);

int distance(const QColor& a, const QColor& b) {
  return std::abs(a.red() - b.red()) + std::abs(a.green() - b.green()) + std::abs(a.blue() - b.blue());
}

}  // namespace

class View3DTest : public QObject {
  Q_OBJECT

 private slots:
  void initTestCase() {
    static const QTemporaryDir folder;
    QSettings::setDefaultFormat(QSettings::IniFormat);
    QSettings::setPath(QSettings::IniFormat, QSettings::UserScope, folder.path());
    QCoreApplication::setOrganizationName(QStringLiteral("GearGraphTest"));
  }
  void thePlatformDecidesHowItPaints() {
    Shown shown;
    const bool wantsWindow = qgetenv("GEARGRAPH_3D") == "window";
    const bool software = shown.view.rendererName().contains("pipe");
    QVERIFY(!shown.view.rendererName().isEmpty());
    QCOMPARE(shown.view.isImage(),
             QGuiApplication::platformName() == "offscreen" || (software && !wantsWindow));
    QCOMPARE(shown.view.findChild<QLabel*>("view3dPainter")->isVisible(), software);
  }

  void thePictureOfTheMomentComesToTheScreen() {
    Shown shown;
    QTRY_VERIFY(shown.view.isUpToDate());
    shown.drag(Qt::MiddleButton, {}, shown.at(kOnBox), {60, 20});
    QCOMPARE(shown.view.isUpToDate(), !shown.view.isImage());
    QTRY_VERIFY(shown.view.isUpToDate());
    shown.view.resize(500, 400);
    QTRY_VERIFY(shown.view.isUpToDate());
    shown.view.setScene(nullptr);
    QTRY_VERIFY(shown.view.isUpToDate());
  }

  /// The buttons and the clock on the picture are painted with it, and the window is laid out with the clock.
  void aStepOfADragPaintsThePictureOnceAndLaysNothingOut() {
    Shown shown;
    QTRY_VERIFY(shown.view.isUpToDate());
    QCoreApplication::sendPostedEvents();
    Counter paints(shown.canvas(), QEvent::Paint), layouts(&shown.view, QEvent::LayoutRequest);
    shown.view.setScene(test::toyStage());
    shown.view.playback().setTime(3);
    QTRY_VERIFY(shown.view.isUpToDate());
    QCoreApplication::processEvents();
    QCOMPARE(shown.view.findChild<QLabel*>("view3dTime")->text(), QString("3.0 s / 4.0 s"));
    QCOMPARE(layouts.count, 0);
    QVERIFY2(paints.count <= 2, qPrintable(QString::number(paints.count)));  // clock, picture
  }

  void aTrajectoryIsPlayedUntilItsButtonEndsIt() {
    Shown shown;
    QSignalSpy changed(&shown.view, &View3D::trajectoryChanged);
    auto* end = shown.view.findChild<QToolButton*>("view3dEndTrajectory");
    QVERIFY(!end->isVisible());
    shown.view.playback().setTime(3);
    using Sample = InputTrajectory::Sample;
    const auto trajectory =
        std::make_shared<const InputTrajectory>(std::vector<Sample>{{0, {0}, {0}}, {0.25, {1}, {8}}});
    shown.view.setTrajectory(trajectory);
    QCOMPARE(changed.count(), 1);
    QVERIFY(end->isVisible());
    QCOMPARE(shown.view.playback().time(), 0.0);
    QCOMPARE(shown.view.playback().period(), 0.25);
    shown.view.playback().setTime(0.125);
    QCOMPARE(shown.view.findChild<QLabel*>("view3dTime")->text(), QString("0.125 s / 0.250 s"));
    QCOMPARE(shown.view.view().time, 0.125);
    // Its angles follow from the time alone, so parts are not dragged.
    const Camera before = shown.view.camera();
    shown.drag(Qt::LeftButton, {}, shown.at(kOnBox), {40, 0});
    QTRY_VERIFY(!(shown.view.camera() == before));
    QCOMPARE(shown.view.playback().time(), 0.125);
    // The same train again, as another edit gives it, keeps it; one with other inputs does not.
    shown.view.setScene(test::toyStage());
    QCOMPARE(shown.view.trajectory(), trajectory);
    QTest::mouseClick(end, Qt::LeftButton);
    QCOMPARE(shown.view.trajectory(), nullptr);
    QVERIFY(!end->isVisible());
    QCOMPARE(shown.view.playback().period(), 4.0);
    shown.view.setTrajectory(trajectory);
    auto two = std::make_shared<MechanismScene>(*test::toyStage());
    two->inputSpeeds = {1, 1};
    shown.view.setScene(two);
    QCOMPARE(shown.view.trajectory(), nullptr);
  }

  /// Between a train and its first picture the view does not look as if there were none.
  void untilTheFirstPictureIsThereTheViewSaysSo() {
    Shown shown(nullptr);
    if (!shown.view.isImage()) return;  // painted at once
    QTRY_VERIFY(shown.view.isUpToDate());
    const auto middle = [&] {
      shown.canvas()->repaint();
      const QPixmap screen = shown.view.screen()->grabWindow(shown.view.winId());
      return screen.toImage().copy(220, 180, 200, 60);
    };
    const auto hasWords = [&](const QImage& image) {
      for (int y = 0; y < image.height(); ++y) {
        for (int x = 0; x < image.width(); ++x) {
          if (image.pixelColor(x, y).lightness() < 170) return true;
        }
      }
      return false;
    };
    shown.view.setEmptyText({});
    QVERIFY(!hasWords(middle()));
    shown.view.setScene(test::toyStage());
    QVERIFY(!shown.view.isUpToDate());
    const QImage waiting = middle();
    QVERIFY(hasWords(waiting));
    QTRY_VERIFY(shown.view.isUpToDate());
    QVERIFY(middle() != waiting);
    shown.view.setScene(nullptr);
    QTRY_VERIFY(shown.view.isUpToDate());
    QVERIFY(!hasWords(middle()));
  }

  void theGrabbedWindowShowsTheTrain() {
    Shown shown;
    const QImage image = shown.view.grab().toImage();
    const QColor box = image.pixelColor(shown.at(kOnBox));
    QVERIFY2(box.green() > box.red() + 40, qPrintable(box.name()));
    const QColor wheel = image.pixelColor(shown.at(kOnFirst));
    QVERIFY2(wheel.blue() > wheel.red() + 40, qPrintable(wheel.name()));
    const QColor ground = image.pixelColor(4, image.height() / 2);
    QVERIFY2(ground.lightness() > 200, qPrintable(ground.name()));
  }

  void theDarkGroundIsDark() {
    Shown shown;
    shown.view.setDark(true);
    const QImage image = shown.view.grab().toImage();
    QVERIFY(image.pixelColor(4, image.height() / 2).lightness() < 90);
    QVERIFY(image.pixelColor(shown.at(kOnBox)).green() > 80);
  }

  void hoveringLightsUpAndLeavingDoesNot() {
    Shown shown;
    shown.moveTo(shown.at(kOnBox));
    QTRY_VERIFY(shown.selection.isHovered(LinkId("3")));
    shown.moveTo(shown.at(kOnSecond));
    QTRY_VERIFY(shown.selection.isHovered(LinkId("2")));
    QVERIFY(!shown.selection.isHovered(LinkId("3")));
    QEvent leave(QEvent::Leave);
    QApplication::sendEvent(shown.canvas(), &leave);
    QVERIFY(shown.selection.hovered().empty());
  }

  void aClickSelectsAndControlAddsAndTheGroundClears() {
    Shown shown;
    QTest::mouseClick(shown.canvas(), Qt::LeftButton, {}, shown.at(kOnBox));
    QTRY_COMPARE(shown.selection.selected(), std::set<ElementId>{LinkId("3")});
    QTest::mouseClick(shown.canvas(), Qt::LeftButton, Qt::ControlModifier, shown.at(kOnFirst));
    QTRY_COMPARE(shown.selection.selected(), (std::set<ElementId>{LinkId("1"), LinkId("3")}));
    QTest::mouseClick(shown.canvas(), Qt::LeftButton, Qt::ControlModifier, shown.at(kOnBox));
    QTRY_COMPARE(shown.selection.selected(), std::set<ElementId>{LinkId("1")});
    QTest::mouseClick(shown.canvas(), Qt::LeftButton, {}, QPoint(3, 200));
    QTRY_VERIFY(shown.selection.selected().empty());
  }

  void whatIsSelectedElsewhereGetsAHalo() {
    Shown shown;
    const QImage before = shown.view.grab().toImage();
    shown.selection.select({LinkId("3")});
    const QImage after = shown.view.grab().toImage();
    QVERIFY(distance(before.pixelColor(shown.at(kOnBox)), after.pixelColor(shown.at(kOnBox))) > 10);
    QVERIFY(distance(before.pixelColor(shown.at(kOnFirst)), after.pixelColor(shown.at(kOnFirst))) < 6);
  }

  void leftAndMiddleDragsOrbitAndSelectNothing() {
    Shown shown;
    for (const Qt::MouseButton button : {Qt::LeftButton, Qt::MiddleButton}) {
      const Camera before = shown.view.camera();
      shown.drag(button, {}, shown.at(kOnBox), {60, 20});
      QTRY_VERIFY(shown.view.camera() != before);  // what the left button has taken is known a moment later
      const Camera after = shown.view.camera();
      QVERIFY(after.yaw() != before.yaw() && after.pitch() != before.pitch());
      QCOMPARE(after.target(), before.target());
      QVERIFY(shown.selection.selected().empty());
    }
  }

  void rightAndShiftDragsPan() {
    Shown shown;
    for (const auto& [button, keys] :
         {std::pair(Qt::RightButton, Qt::KeyboardModifiers()), {Qt::LeftButton, Qt::ShiftModifier}}) {
      const Camera before = shown.view.camera();
      shown.drag(button, keys, {200, 200}, {40, -24});
      const Camera after = shown.view.camera();
      QCOMPARE(after.yaw(), before.yaw());
      const ScreenPoint moved = after.project(before.target(), shown.viewport());
      QVERIFY(std::abs(moved.x - (0.5 * shown.viewport().width + 40)) < 1e-6);
      QVERIFY(std::abs(moved.y - (0.5 * shown.viewport().height - 24)) < 1e-6);
    }
  }

  void theWheelZoomsAtWhatIsUnderThePointer() {
    Shown shown;
    const QPoint at = shown.at({8, -8, 30});
    const double before = shown.view.camera().distance();
    shown.wheel(at, 240);
    QTRY_VERIFY(shown.view.camera().distance() < 0.8 * before);
    QVERIFY((shown.at({8, -8, 30}) - at).manhattanLength() <= 2);
    shown.wheel(at, -240);
    QTRY_VERIFY(std::abs(shown.view.camera().distance() - before) < 1e-6 * before);
  }

  void buttonsAndKeysGiveStandardViews() {
    Shown shown;
    const auto seesAlong = [&](const Eigen::Vector3d& direction) {
      return (shown.view.camera().forward() - direction).norm() < 1e-9;
    };
    QTest::mouseClick(shown.view.findChild<QToolButton*>("view3dTop"), Qt::LeftButton);
    QVERIFY(seesAlong({0, 0, -1}));
    QTest::mouseClick(shown.view.findChild<QToolButton*>("view3dFront"), Qt::LeftButton);
    QVERIFY(seesAlong({0, 1, 0}));
    QTest::keyClick(&shown.view, Qt::Key_2);
    QVERIFY(seesAlong({-1, 0, 0}));
    QTest::keyClick(&shown.view, Qt::Key_0);
    QVERIFY(seesAlong(Eigen::Vector3d(-1, 1, -1).normalized()));
  }

  void fitBringsTheTrainBack() {
    Shown shown;
    shown.drag(Qt::RightButton, {}, {200, 200}, {3000, 0});
    QVERIFY(!QRect({}, shown.canvas()->size()).contains(shown.at(kOnBox)));
    QTest::mouseClick(shown.view.findChild<QToolButton*>("view3dFit"), Qt::LeftButton);
    for (const Eigen::Vector3d& point : {kOnBox, kOnFirst, kOnSecond}) {
      QVERIFY(QRect({}, shown.canvas()->size()).contains(shown.at(point)));
    }
  }

  void spacePlaysAndPauses() {
    Shown shown;
    QSignalSpy times(&shown.view.playback(), &Playback::timeChanged);
    QTest::keyClick(&shown.view, Qt::Key_Space);
    QVERIFY(shown.view.playback().isPlaying());
    QTRY_VERIFY(times.count() > 3);
    QTest::keyClick(&shown.view, Qt::Key_Space);
    QVERIFY(!shown.view.playback().isPlaying());
  }

  void theScrubBarIsTheTimeWithinThePeriod() {
    Shown shown;
    auto* scrub = shown.view.findChild<QSlider*>("view3dScrub");
    QVERIFY(scrub->isVisible());
    scrub->setValue(scrub->maximum() / 4);
    QCOMPARE(shown.view.playback().time(), 1.0);
    shown.view.playback().setTime(3);
    QCOMPARE(scrub->value(), scrub->maximum() * 3 / 4);
    QCOMPARE(shown.view.findChild<QLabel*>("view3dTime")->text(), QString("3.0 s / 4.0 s"));
  }

  void everyTimeHasRoomInTheBar() {
    for (const double period : {4.0, 339.0, 0.0}) {
      Shown shown;
      Playback& playback = shown.view.playback();
      playback.setPeriod(period);
      auto* clock = shown.view.findChild<QLabel*>("view3dTime");
      for (const double time : {0.0, 3.9, 88.8, 188.8, 12345.0, 2.0}) {
        if (period > 0 && time >= period) continue;
        playback.setTime(time);
        QVERIFY2(clock->minimumWidth() >= clock->sizeHint().width(), qPrintable(clock->text()));
      }
    }
  }

  void whatIsSeenAndPickedFollowsTheTime() {
    Shown shown(test::toyStage(0));
    shown.view.showFrom(StandardView::right);
    const Eigen::Vector3d swung(0, 17, 30);  // the box reaches here when its sine is 1
    shown.view.grab();
    shown.selection.select({LinkId("1")});
    QTest::mouseClick(shown.canvas(), Qt::LeftButton, {}, shown.at(swung));
    QTRY_VERIFY(shown.selection.selected().empty());
    shown.view.playback().setTime(1.5707963 / 1.5);
    shown.view.grab();
    QTest::mouseClick(shown.canvas(), Qt::LeftButton, {}, shown.at(swung));
    QTRY_COMPARE(shown.selection.selected(), std::set<ElementId>{LinkId("3")});
  }

  void aPartDraggedWithControlTurnsAndTakesTheTrainWithIt() {
    Shown shown;
    shown.view.showFrom(StandardView::top);
    shown.view.grab();
    // from the right side of the first wheel up, a quarter of its circle: counter-clockwise from above
    const Eigen::Vector3d middle(0, -22, 4), from(15, -22, 4), to(0, -7, 4);
    const Camera before = shown.view.camera();
    const QPoint start = shown.at(from), end = shown.at(to), centre = shown.at(middle);
    QTest::mousePress(shown.canvas(), Qt::LeftButton, Qt::ControlModifier, start);
    const QPointF arm = start - centre;
    for (int step = 1; step <= 45; ++step) {
      const double angle = 1.5707963 * step / 45;
      const QPointF at = centre + QPointF(arm.x() * std::cos(angle), -arm.x() * std::sin(angle));
      QMouseEvent event(QEvent::MouseMove, at, shown.canvas()->mapToGlobal(at), Qt::NoButton, Qt::LeftButton,
                        Qt::ControlModifier);
      QApplication::sendEvent(shown.canvas(), &event);
    }
    QTest::mouseRelease(shown.canvas(), Qt::LeftButton, Qt::ControlModifier, end);
    QTRY_VERIFY(!shown.view.turnedByHand().empty() && shown.view.turnedByHand().front() != 0);
    QCOMPARE(shown.view.camera(), before);
    QVERIFY(shown.selection.selected().empty());
    QCOMPARE(shown.view.turnedByHand().size(), std::size_t{1});
    QVERIFY2(std::abs(shown.view.turnedByHand().front() - 1.57) < 0.12,
             qPrintable(QString::number(shown.view.turnedByHand().front())));
    QTest::keyClick(&shown.view, Qt::Key_Backspace);
    QCOMPARE(shown.view.turnedByHand(), std::vector<double>{0});
  }

  void aPartThatIsDraggedTakesTheTimeWithIt() {
    Shown shown;
    shown.view.showFrom(StandardView::top);
    shown.view.grab();
    const Camera before = shown.view.camera();
    QSignalSpy hints(&shown.view, &View3D::hintChanged);
    const QPoint start = shown.at({15, -22, 4}), centre = shown.at({0, -22, 4});
    shown.moveTo(start);
    QTRY_VERIFY(!hints.empty());
    QVERIFY(hints.back().front().toString().contains(QLatin1String("turn the train")));
    shown.view.playback().setPlaying(true);
    QTest::mousePress(shown.canvas(), Qt::LeftButton, {}, start);
    const QPointF arm = start - centre;
    const auto turnTo = [&](double from, double to) {
      for (int step = 0; step <= 45; ++step) {
        const double angle = from + (to - from) * step / 45;
        const QPointF at = centre + QPointF(arm.x() * std::cos(angle), -arm.x() * std::sin(angle));
        QMouseEvent event(QEvent::MouseMove, at, shown.canvas()->mapToGlobal(at), Qt::NoButton,
                          Qt::LeftButton, {});
        QApplication::sendEvent(shown.canvas(), &event);
      }
    };
    turnTo(0, 0.1);
    QTRY_VERIFY(!shown.view.playback().isPlaying());  // the hand holds it
    const double held = shown.view.playback().time();
    turnTo(0.1, 1.5);
    const double turned = 1.5 * (shown.view.playback().time() - held);  // the input runs at 1.5 rad/s
    QVERIFY2(std::abs(turned - 1.4) < 0.12, qPrintable(QString::number(turned)));
    turnTo(1.5, 0.1);
    QVERIFY(std::abs(shown.view.playback().time() - held) < 0.05);
    QTest::mouseRelease(shown.canvas(), Qt::LeftButton, {}, start);
    QCOMPARE(shown.view.turnedByHand(), std::vector<double>{0});
    QCOMPARE(shown.view.camera(), before);
    QVERIFY(shown.selection.selected().empty());
    shown.moveTo(shown.at(kOnBox));
    QTRY_VERIFY(hints.back().front().toString().contains(QLatin1String("does not turn")));
  }

  void theMiddleButtonDoesWhatHandsAreUsedTo() {
    Shown shown;
    enum Moved { orbited, panned, zoomed };
    const auto dragged = [&](Qt::KeyboardModifiers keys) {
      const Camera before = shown.view.camera();
      shown.drag(Qt::MiddleButton, keys, {200, 200}, {0, 40});
      const auto isOther = [&] { return shown.view.camera() != before; };
      if (!QTest::qWaitFor(isOther)) qFatal("The camera stays");
      const Camera after = shown.view.camera();
      if (after.pitch() != before.pitch()) return orbited;
      return after.distance() != before.distance() ? zoomed : panned;
    };
    shown.view.chooseNavigation(Navigation::freeCad);
    QCOMPARE(dragged({}), panned);
    QCOMPARE(dragged(Qt::ShiftModifier), orbited);
    QCOMPARE(dragged(Qt::ControlModifier), zoomed);
    shown.view.chooseNavigation(Navigation::solidWorks);
    QCOMPARE(dragged({}), orbited);
    QCOMPARE(dragged(Qt::ShiftModifier), zoomed);
    QCOMPARE(dragged(Qt::ControlModifier), panned);
    QCOMPARE(View3D::savedNavigation(), Navigation::solidWorks);
    shown.view.chooseNavigation(Navigation::blender);
    QCOMPARE(dragged({}), orbited);
    QCOMPARE(dragged(Qt::ShiftModifier), panned);
    QCOMPARE(dragged(Qt::ControlModifier), zoomed);
  }

  void keysSelectTurnAndPan() {
    Shown shown;
    QTest::keyClick(&shown.view, Qt::Key_PageDown);
    QCOMPARE(shown.selection.selected(), std::set<ElementId>{LinkId("1")});
    QTest::keyClick(&shown.view, Qt::Key_PageUp);
    QCOMPARE(shown.selection.selected(), std::set<ElementId>{LinkId("3")});
    shown.view.setHidden({LinkId("1")});
    QTest::keyClick(&shown.view, Qt::Key_PageDown);
    QCOMPARE(shown.selection.selected(), std::set<ElementId>{LinkId("2")});
    const Camera before = shown.view.camera();
    QTest::keyClick(&shown.view, Qt::Key_Left, Qt::ShiftModifier);
    QCOMPARE(shown.view.camera().yaw(), before.yaw());
    QVERIFY(shown.view.camera().target() != before.target());
    QContextMenuEvent menu(QContextMenuEvent::Keyboard, {1, 1}, shown.view.mapToGlobal(QPoint(1, 1)));
    QApplication::sendEvent(&shown.view, &menu);
    auto* open = shown.view.findChild<QMenu*>(QStringLiteral("view3dPartMenu"));
    QVERIFY(open != nullptr && open->isVisible());
    QCOMPARE(open->findChild<QAction*>(QStringLiteral("view3dRide"))->text(),
             QStringLiteral("Follow link 2"));
    open->close();
  }

  void controlOnAFixedPartOrbits() {
    Shown shown;
    const Camera before = shown.view.camera();
    shown.drag(Qt::LeftButton, Qt::ControlModifier, shown.at(kOnBox), {40, 0});
    QTRY_VERIFY(shown.view.camera().yaw() != before.yaw());
    QCOMPARE(shown.view.turnedByHand(), std::vector<double>{0});
  }

  void labelsAreDiscsOnTheirPartsAndCanBeHidden() {
    Shown shown;
    const QImage without = shown.view.grab().toImage();
    ViewOptions options = shown.view.options();
    options.linkLabels = true;
    shown.view.setOptions(options);
    const QImage with = shown.view.grab().toImage();
    int white = 0;
    for (int y = 0; y < with.height(); ++y) {
      for (int x = 0; x < with.width(); ++x) {
        white += with.pixel(x, y) != without.pixel(x, y) && with.pixelColor(x, y) == QColor(Qt::white);
      }
    }
    QVERIFY2(white > 3 * 150, qPrintable(QString::number(white)));
  }

  void stepsAreASpeedsTwentiethOfASecond() {
    Shown shown;
    Playback& playback = shown.view.playback();
    QTest::keyClick(&shown.view, Qt::Key_Period);
    QCOMPARE(playback.time(), 0.05);
    QTest::keyClick(&shown.view, Qt::Key_Comma);
    QCOMPARE(playback.time(), 0.0);
    playback.setSpeed(-0.25);
    playback.setPlaying(true);
    QTest::mouseClick(shown.view.findChild<QToolButton*>("view3dStep"), Qt::LeftButton);
    QVERIFY(!playback.isPlaying());
    QVERIFY(std::abs(playback.time() - 0.0125) < 1e-3 ||
            playback.time() > 3.9);  // it may have run a frame back
    QCOMPARE(shown.view.findChild<QToolButton*>("view3dSpeed")->text(), QString("−1/4×"));
  }

  void theSpeedMenuSetsSpeedAndDirection() {
    Shown shown;
    const auto actions = shown.view.findChild<QToolButton*>("view3dSpeed")->menu()->actions();
    const auto choose = [&](const QString& text) {
      for (QAction* action : actions) {
        if (action->text() == text) action->trigger();
      }
    };
    choose("1/8×");
    QCOMPARE(shown.view.playback().speed(), 0.125);
    choose("Backwards");
    QCOMPARE(shown.view.playback().speed(), -0.125);
    choose("2×");
    QCOMPARE(shown.view.playback().speed(), -2.0);
  }

  void theReferenceLinkStandsStillAndTheRestTurnsAboutIt() {
    Shown shown;
    Viewer* viewer = shown.view.findChild<Viewer*>();
    QVERIFY(viewer != nullptr);
    shown.view.fixReferenceFrame(ElementId(LinkId("1")));
    const std::vector<Pose> before(viewer->poses().begin(), viewer->poses().end());
    shown.view.playback().setTime(1);
    QVERIFY(viewer->poses()[0].isApprox(before[0], 1e-12));
    QVERIFY((viewer->poses()[1].translation() - before[1].translation()).norm() > 10);
    const double apart = (before[1].translation() - before[0].translation()).norm();
    QVERIFY(std::abs((viewer->poses()[1].translation() - viewer->poses()[0].translation()).norm() - apart) <
            1e-9);
    shown.selection.select({LinkId("1")});
    QTest::keyClick(&shown.view, Qt::Key_R);
    QVERIFY(!shown.view.referenceLink());
  }

  void aRightClickOffersWhatCanBeDoneWithThePart() {
    Shown shown;
    std::optional<ElementId> meant;
    connect(&shown.view, &View3D::menuOpening, this,
            [&](QMenu*, const std::optional<ElementId>& element) { meant = element; });
    const auto menuAt = [&](const QPoint& at) {
      QTest::mouseClick(shown.canvas(), Qt::RightButton, {}, at);
      const auto menu = [&] { return shown.view.findChild<QMenu*>("view3dPartMenu"); };
      return QTest::qWaitFor([&] { return menu() != nullptr; }) ? menu() : nullptr;
    };
    const auto choose = [&](QMenu* menu, const char* name) {
      auto* action = menu->findChild<QAction*>(name);
      QVERIFY2(action != nullptr && action->isEnabled(), name);
      action->trigger();
      menu->close();
      QTRY_VERIFY(shown.view.findChild<QMenu*>("view3dPartMenu") == nullptr);
    };
    choose(menuAt(shown.at(kOnFirst)), "view3dRide");
    QCOMPARE(meant, std::optional<ElementId>(LinkId("1")));
    QCOMPARE(shown.selection.selected(), std::set<ElementId>{LinkId("1")});
    QCOMPARE(shown.view.referenceLink(), std::optional<ElementId>(LinkId("1")));
    choose(menuAt(shown.at(kOnFirst)), "view3dStopRiding");
    QVERIFY(!shown.view.referenceLink());
    choose(menuAt(shown.at(kOnFirst)), "view3dHideOthers");
    QCOMPARE(shown.view.hidden(), (std::set<ElementId>{LinkId("2"), LinkId("3")}));
    choose(menuAt(QPoint(3, 200)), "view3dShowAll");
    QVERIFY(shown.view.hidden().empty());
    QVERIFY(!meant);
    choose(menuAt(shown.at(kOnFirst)), "view3dLookAlong");
    QVERIFY((shown.view.camera().forward() - Eigen::Vector3d(0, 0, -1)).norm() < 1e-9);
  }

  void whatHasBeenDeletedSinceHasNoMenu() {
    Shown shown;
    std::optional<ElementId> meant;
    connect(&shown.view, &View3D::menuOpening, this,
            [&](QMenu*, const std::optional<ElementId>& element) { meant = element; });
    shown.selection.setExists([](const ElementId& element) { return element != ElementId(LinkId("1")); });
    QTest::mouseClick(shown.canvas(), Qt::RightButton, {}, shown.at(kOnFirst));
    const auto menu = [&] { return shown.view.findChild<QMenu*>("view3dPartMenu"); };
    QTRY_VERIFY(menu() != nullptr);
    QVERIFY(menu()->findChild<QAction*>("view3dRide") == nullptr);
    QVERIFY(!meant && shown.selection.selected().empty());
    menu()->close();
  }

  void aTracedPointSaysHowFarItTravels() {
    Shown shown;
    QString note;
    connect(&shown.view, &View3D::noteMade, this, [&](const QString& text) { note = text; });
    shown.view.trace({0, LinkId("1"), {15, -22, 4}});
    QTRY_COMPARE(note, QString("The point travels 90 mm in 4 s."));
    const auto restored = qScopeGuard([] { setDecimalSign('.'); });
    setDecimalSign(',');
    shown.view.trace({0, LinkId("1"), {15.3, -22, 4}});
    QTRY_COMPARE(note, QString("The point travels 91,8 mm in 4 s."));
    const QImage with = shown.view.grab().toImage();
    shown.view.clearTraces();
    QVERIFY(with != shown.view.grab().toImage());
  }

  void aSectionOpensTheTrainAndItsSliderMovesIt() {
    Shown shown;
    shown.view.showFrom(StandardView::right);
    const QPoint at = shown.at(kOnBox);
    const QColor whole = shown.view.grab().toImage().pixelColor(at);
    auto* place = shown.view.findChild<QSlider*>("view3dCutPlace");
    QVERIFY(!place->isVisible());
    QTest::keyClick(&shown.view, Qt::Key_S);
    QVERIFY(place->isVisible());
    QTest::mouseClick(shown.view.findChild<QToolButton*>("view3dCutX"), Qt::LeftButton);
    QCOMPARE(shown.view.options().section->axis, 0);
    place->setValue(0);
    QCOMPARE(shown.view.options().section->place, 0.0);
    const QColor gone = shown.view.grab().toImage().pixelColor(at);
    QVERIFY2(distance(whole, gone) > 60, qPrintable(gone.name()));
    QTest::mouseClick(shown.view.findChild<QToolButton*>("view3dSection"), Qt::LeftButton);
    QVERIFY(!place->isVisible());
    QVERIFY(distance(whole, shown.view.grab().toImage().pixelColor(at)) < 6);
  }

  void theMoreMenuTellsWhatIsOn() {
    Shown shown;
    QMenu* menu = shown.view.findChild<QToolButton*>("view3dMore")->menu();
    const auto entry = [&](const char* name) {
      emit menu->aboutToShow();
      return menu->findChild<QAction*>(name);
    };
    QVERIFY(!entry("view3dWireframe")->isChecked());
    entry("view3dWireframe")->trigger();
    QVERIFY(entry("view3dWireframe")->isChecked());
    QVERIFY(shown.view.options().faces == Faces::wireframe);
    entry("view3dPitchCircles")->trigger();
    entry("view3dVelocities")->trigger();
    QVERIFY(shown.view.options().marks.pitchCircles && shown.view.options().marks.velocities);
    entry("view3dExploded")->trigger();
    QCOMPARE(shown.view.options().explosion, 1.0);
    QVERIFY(shown.view.findChild<QSlider*>("view3dApart")->isVisible());
  }

  void whatIsNotSelectedBecomesTranslucent() {
    Shown shown;
    ViewOptions options = shown.view.options();
    options.translucentOthers = true;
    shown.view.setOptions(options);
    const QColor plain = shown.view.grab().toImage().pixelColor(shown.at(kOnBox));
    shown.selection.select({LinkId("1")});
    const QColor translucent = shown.view.grab().toImage().pixelColor(shown.at(kOnBox));
    QVERIFY2(translucent.lightness() > plain.lightness() + 50, qPrintable(translucent.name()));
    shown.selection.clear();
    QVERIFY(distance(plain, shown.view.grab().toImage().pixelColor(shown.at(kOnBox))) < 6);
  }

  void aPadPansWithTwoFingersAndZoomsWithAPinch() {
    Shown shown;
    const QPointingDevice pad("pad", 77, QInputDevice::DeviceType::TouchPad,
                              QPointingDevice::PointerType::Finger, QInputDevice::Capability::Scroll, 2, 0);
    const QPoint at(200, 150);
    const Camera before = shown.view.camera();
    QWheelEvent scroll(at, shown.canvas()->mapToGlobal(at), {30, -12}, {0, 0}, Qt::NoButton, Qt::NoModifier,
                       Qt::ScrollUpdate, false, Qt::MouseEventNotSynthesized, &pad);
    QApplication::sendEvent(shown.canvas(), &scroll);
    const ScreenPoint moved = shown.view.camera().project(before.target(), shown.viewport());
    QVERIFY(std::abs(moved.x - (0.5 * shown.viewport().width + 30)) < 1e-6);
    QVERIFY(std::abs(moved.y - (0.5 * shown.viewport().height - 12)) < 1e-6);
    QCOMPARE(shown.view.camera().distance(), before.distance());
    QNativeGestureEvent pinch(Qt::ZoomNativeGesture, &pad, 2, at, at, shown.canvas()->mapToGlobal(at), 0.25,
                              {});
    QApplication::sendEvent(shown.canvas(), &pinch);
    QTRY_VERIFY(shown.view.camera().distance() < 0.85 * before.distance());
  }

  void anEmptyStageSaysWhatToDo() {
    Shown shown(std::make_shared<const MechanismScene>());
    bool said = false;
    for (const QLabel* label : shown.view.findChildren<QLabel*>()) {
      said = said || (label->isVisible() && label->text().contains("place axes"));
    }
    QVERIFY(said);
    QVERIFY(!shown.view.findChild<QSlider*>("view3dScrub")->isVisible());
    shown.selection.select({LinkId("1")});
    QTest::mouseClick(shown.canvas(), Qt::LeftButton, {}, QPoint(100, 100));
    QTRY_VERIFY(shown.selection.selected().empty());
  }

  void aDockThatFloatsKeepsItsPicture() {
    Selection selection;
    QMainWindow window;
    auto* view = new View3D(&selection);
    window.setCentralWidget(view);
    view->setScene(test::toyStage());
    window.resize(640, 420);
    window.show();
    QVERIFY(QTest::qWaitForWindowExposed(&window));
    const QImage before = view->grab().toImage();
    window.takeCentralWidget();
    view->setParent(nullptr);
    view->resize(before.size());
    view->show();
    QVERIFY(QTest::qWaitForWindowExposed(view));
    const QImage after = view->grab().toImage();
    QVERIFY(distance(before.pixelColor(320, 200), after.pixelColor(320, 200)) < 12);
    delete view;
  }
};

int main(int argc, char** argv) {
  View3D::prepareApplication();
  QApplication application(argc, argv);
  View3DTest test;
  return QTest::qExec(&test, argc, argv);
}

#include "test_view3d.moc"

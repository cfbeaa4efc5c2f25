#include <QMouseEvent>
#include <QSignalSpy>
#include <QTest>
#include <QWheelEvent>
#include <cmath>

#include "tests/ui/view3d/toy_stage.h"
#include "ui/view3d/viewer.h"

namespace geargraph {
namespace {

/// A viewer whose canvas answers when the test lets it.
struct LateCanvas {
  Selection selection;
  Viewer viewer{&selection};
  std::vector<Viewer::Answer> open;

  LateCanvas() {
    viewer.setViewport({640, 420}, 1);
    viewer.setScene(test::toyStage());
    viewer.setPick([this](const Frame&, double, double, Viewer::PickFor, Viewer::Answer answer) {
      open.push_back(std::move(answer));
    });
  }
  /// Answers the oldest question with this part's link.
  void answer(const std::optional<std::size_t>& part) {
    const Viewer::Answer oldest = std::move(open.front());
    open.erase(open.begin());
    if (!part) return oldest(std::nullopt);
    const Instance& instance = viewer.stage()->scene.instances[*part];
    oldest(Hit{*part, instance.element, instance.pose.translation() + Eigen::Vector3d(15, 0, 4)});
  }
  void mouse(QEvent::Type type, const QPointF& at, Qt::MouseButton button = Qt::NoButton,
             Qt::KeyboardModifiers keys = {}) {
    const bool isUp = type == QEvent::MouseButtonRelease;
    QMouseEvent event(type, at, at, button, isUp ? Qt::NoButton : button, keys);
    viewer.eventFilter(nullptr, &event);
  }
  void click(const QPointF& at, Qt::MouseButton button = Qt::LeftButton) {
    mouse(QEvent::MouseButtonPress, at, button);
    mouse(QEvent::MouseButtonRelease, at, button);
  }
  void wheel(const QPointF& at) {
    QWheelEvent event(at, at, {}, {0, 120}, Qt::NoButton, {}, Qt::NoScrollPhase, false);
    viewer.eventFilter(nullptr, &event);
  }
};

}  // namespace

class ViewerTest : public QObject {
  Q_OBJECT

 private slots:
  void aStageBringsTheOutlinesItIsFittedBy() {
    Selection selection;
    Viewer viewer(&selection);
    viewer.setViewport({640, 420}, 1);
    auto stage = std::make_shared<MechanismScene>(*test::toyStage());
    SolidOutlines larger = *solidOutlines(stage->scene);
    for (auto& outline : larger) {
      for (Eigen::Vector3d& point : outline) point *= 3;
    }
    viewer.setScene(stage);
    const double fitted = viewer.camera().distance();
    auto known = std::make_shared<MechanismScene>(*stage);
    known->scene.outlines = std::make_shared<const SolidOutlines>(std::move(larger));
    viewer.startAnew(std::nullopt);
    viewer.setScene(known);
    QVERIFY(viewer.camera().distance() > 1.2 * fitted);
  }

  void whatIsPointedAtElsewhereLightsUpAtOnce() {
    Selection selection;
    Viewer viewer(&selection);
    viewer.setScene(test::toyStage());
    QSignalSpy changed(&viewer, &Viewer::viewChanged);
    selection.hover(viewer.stage()->scene.instances.front().element);
    QCOMPARE(changed.count(), 1);
    selection.hover(ElementId(MeshId("nowhere")));
    QCOMPARE(changed.count(), 2);
    selection.hover(ElementId(MeshId("nowhere else")));
    QCOMPARE(changed.count(), 2);  // nothing here was highlighted before or is now
  }

  void tracedPathsSurviveAnEditAndFollowIt() {
    Selection selection;
    Viewer viewer(&selection);
    viewer.setScene(test::toyStage());
    QVERIFY(viewer.trace({0, LinkId("1"), {15, -22, 0}}));
    QVERIFY(viewer.trace({2, LinkId("3"), {0, 0, 30}}));
    const auto length = [&] { return viewer.traces()[0].path.length; };
    QTRY_VERIFY(length() > 0);
    const double before = length();
    viewer.setScene(test::toyStage(8));  // twice the period: twice round
    QCOMPARE(viewer.traces().size(), std::size_t{2});
    QCOMPARE(length(), before);  // until the new one has been computed
    QTRY_VERIFY(std::abs(length() - 2 * before) < 1e-3 * before);

    auto fewer = std::make_shared<MechanismScene>(*test::toyStage());
    fewer->scene.instances[0].element = LinkId("9");  // link 1 has gone
    std::swap(fewer->scene.instances[1].element, fewer->scene.instances[2].element);
    viewer.setScene(fewer);
    QCOMPARE(viewer.traces().size(), std::size_t{1});
    QCOMPARE(viewer.traces()[0].point.instance, std::size_t{1});

    auto still = std::make_shared<MechanismScene>(*fewer);
    still->place = {};
    still->inputSpeeds.clear();
    viewer.setScene(still);
    QTRY_VERIFY(viewer.traces()[0].path.points.empty());
    viewer.setScene(fewer);
    QTRY_VERIFY(!viewer.traces()[0].path.points.empty());
    viewer.startAnew(std::nullopt);
    QVERIFY(viewer.traces().empty());
  }

  void aPathSeenFromALinkGoesWithThatLink() {
    Selection selection;
    Viewer viewer(&selection);
    viewer.setScene(test::toyStage());
    viewer.fixReferenceFrame(ElementId(LinkId("2")));
    QVERIFY(viewer.trace({0, LinkId("1"), {15, -22, 0}}));
    viewer.setScene(test::toyStage());
    QCOMPARE(viewer.traces()[0].point.watcher, std::optional<std::size_t>(1));
    auto without = std::make_shared<MechanismScene>(*test::toyStage());
    without->scene.instances[1].element = LinkId("9");
    viewer.setScene(without);
    QVERIFY(viewer.traces().empty());
  }

  void untilSomebodyMovesTheCameraTheTrainFitsEverySize() {
    Selection selection;
    Viewer viewer(&selection);
    viewer.setScene(test::toyStage());
    const auto isInside = [&](const Viewport& size) {
      for (const Eigen::Vector3d& corner : outlineOf(viewer.stage()->scene)) {
        const ScreenPoint at = viewer.camera().project(corner, size);
        if (at.x < 0 || at.y < 0 || at.x > size.width || at.y > size.height) return false;
      }
      return true;
    };
    const Viewport wide{900, 300}, narrow{200, 500};
    viewer.setViewport(wide, 1);
    QVERIFY(isInside(wide));
    viewer.setViewport(narrow, 1);
    QVERIFY(isInside(narrow));
    QVERIFY(!viewer.isCameraChosen());
    viewer.setCamera(viewer.camera().orbited(0.3, 0.1));
    const Camera chosen = viewer.camera();
    viewer.setViewport(wide, 1);
    QVERIFY(viewer.camera() == chosen);
  }

  void theCameraFollowsGrowthUntilSomebodyTakesIt() {
    Selection selection;
    Viewer viewer(&selection);
    const Viewport size{640, 420};
    viewer.setViewport(size, 1);
    const auto stageOf = [](double scale) {
      MechanismScene stage = *test::toyStage();
      for (Instance& instance : stage.scene.instances) instance.pose.translation() *= scale;
      stage.place = [near = stage.place, scale](std::span<const double> angles, std::span<Pose> poses) {
        near(angles, poses);
        for (Pose& pose : poses) pose.translation() *= scale;
      };
      return std::make_shared<const MechanismScene>(std::move(stage));
    };
    const auto isInside = [&] {
      for (const Instance& instance : viewer.stage()->scene.instances) {
        const ScreenPoint at = viewer.camera().project(instance.pose.translation(), size);
        if (at.x < 0 || at.y < 0 || at.x > size.width || at.y > size.height) return false;
      }
      return true;
    };
    viewer.setScene(stageOf(1));
    const Camera fitted = viewer.camera();
    viewer.setScene(stageOf(1.01));  // still in sight: nothing jumps
    QVERIFY(viewer.camera() == fitted);
    viewer.setScene(stageOf(30));
    QVERIFY(viewer.camera() != fitted);
    QVERIFY(isInside());
    viewer.setCamera(viewer.camera().orbited(20, 5));
    const Camera taken = viewer.camera();
    viewer.setScene(stageOf(900));
    QVERIFY(viewer.camera() == taken);
    QVERIFY(!isInside());
  }

  void aViewThatGetsLowerLeavesATrainInMotionWhereItIs() {
    Selection selection;
    Viewer viewer(&selection);
    viewer.setScene(test::toyStage());
    viewer.setViewport({640, 420}, 1);
    const Camera fitted = viewer.camera();
    viewer.setRunning(true);
    viewer.setTime(0.3);
    viewer.setViewport({640, 380}, 1);
    QVERIFY(viewer.camera() == fitted);
    viewer.setViewport({500, 380}, 1);
    QVERIFY(viewer.camera() != fitted);
    viewer.setRunning(false);
    const Camera narrower = viewer.camera();
    viewer.setViewport({500, 250}, 1);
    QVERIFY(viewer.camera() != narrower);
  }

  void anotherDocumentIsFittedOrSeenFromWhereItSays() {
    Selection selection;
    Viewer viewer(&selection);
    viewer.setViewport({640, 420}, 1);
    viewer.setScene(test::toyStage());
    QVERIFY(!viewer.isCameraChosen());
    const Camera fitted = viewer.camera();
    const Camera own = Camera::from(1, 0.5).placedAt({1, 2, 3}, 77);
    viewer.setCamera(own);
    QVERIFY(viewer.isCameraChosen());
    viewer.setScene(test::toyStage());  // an edit
    QVERIFY(viewer.camera() == own);
    viewer.startAnew(std::nullopt);
    viewer.setScene(std::make_shared<const MechanismScene>());  // nothing to see yet
    viewer.setScene(test::toyStage());
    QVERIFY(viewer.camera() == fitted);
    QVERIFY(!viewer.isCameraChosen());
    viewer.startAnew(own);
    viewer.setScene(test::toyStage());
    QVERIFY(viewer.camera() == own && viewer.isCameraChosen());
  }

  void aClickSelectsWhatWasUnderItHoweverLateTheAnswer() {
    LateCanvas canvas;
    canvas.click({100, 100});
    canvas.mouse(QEvent::MouseMove, {300, 200});
    QVERIFY(canvas.selection.selected().empty());
    canvas.answer(2);
    QCOMPARE(canvas.selection.selected(), std::set<ElementId>{LinkId("3")});
    canvas.answer(0);
    QVERIFY(canvas.selection.isHovered(LinkId("1")));
    QCOMPARE(canvas.selection.selected(), std::set<ElementId>{LinkId("3")});
    QSignalSpy menus(&canvas.viewer, &Viewer::menuWanted);
    canvas.click({50, 60}, Qt::RightButton);
    QVERIFY(menus.empty());
    canvas.answer(1);
    QCOMPARE(menus.size(), qsizetype{1});
    QCOMPARE(menus[0][1].toPointF(), QPointF(50, 60));
  }

  void nothingLightsUpForAPointerThatHasLeft() {
    LateCanvas canvas;
    canvas.mouse(QEvent::MouseMove, {300, 200});
    QEvent leave(QEvent::Leave);
    canvas.viewer.eventFilter(nullptr, &leave);
    canvas.answer(0);
    QVERIFY(canvas.selection.hovered().empty());
  }

  void aPartTurnsByWhatTheHandDidBeforeItWasKnown() {
    std::vector<double> turned;
    for (const int known : {0, 2, 4}) {  // steps of the drag before the answer
      LateCanvas canvas;
      const Camera before = canvas.viewer.camera();
      canvas.mouse(QEvent::MouseButtonPress, {100, 100}, Qt::LeftButton, Qt::ControlModifier);
      for (int step = 0; step < 4; ++step) {
        if (step == known) canvas.answer(0);
        canvas.mouse(QEvent::MouseMove, {100, 110.0 + 10 * step}, Qt::LeftButton, Qt::ControlModifier);
      }
      canvas.mouse(QEvent::MouseButtonRelease, {100, 140}, Qt::LeftButton, Qt::ControlModifier);
      if (known == 4) {
        canvas.click({5, 5});  // another gesture begins
        canvas.answer(0);
      }
      QVERIFY(canvas.viewer.camera() == before);
      QCOMPARE(canvas.viewer.turnedByHand().size(), std::size_t{1});
      turned.push_back(canvas.viewer.turnedByHand().front());
    }
    QVERIFY(turned[0] != 0);
    QCOMPARE(turned[1], turned[0]);
    QCOMPARE(turned[2], turned[0]);
  }

  void theNotchesOfAWheelAreOneQuestion() {
    LateCanvas canvas;
    const double before = canvas.viewer.camera().distance();
    for (int notch = 0; notch < 3; ++notch) canvas.wheel({320, 210});
    QCOMPARE(canvas.open.size(), std::size_t{1});
    canvas.answer(std::nullopt);
    const double factor = before / canvas.viewer.camera().distance();
    QVERIFY2(std::abs(factor - std::pow(1.15, 3)) < 1e-9, qPrintable(QString::number(factor)));
    canvas.wheel({320, 210});
    QCOMPARE(canvas.open.size(), std::size_t{1});
  }

  void answersAboutAStageThatHasGoneFindTheLinkOrNothing() {
    LateCanvas canvas;
    canvas.click({100, 100});
    canvas.click({200, 100});
    const MechanismScenePtr before = canvas.viewer.stage();
    auto fewer = std::make_shared<MechanismScene>(*before);
    fewer->scene.instances[0].element = LinkId("9");
    canvas.viewer.setScene(fewer);
    const std::vector<Viewer::Answer> open = std::exchange(canvas.open, {});
    open[0](Hit{2, LinkId("3"), {0, 0, 30}});
    QCOMPARE(canvas.selection.selected(), std::set<ElementId>{LinkId("3")});
    open[1](Hit{0, LinkId("1"), {0, -22, 0}});
    QVERIFY(canvas.selection.selected().empty());

    canvas.selection.select({LinkId("2")});
    canvas.click({100, 100});
    canvas.wheel({320, 210});
    canvas.mouse(QEvent::MouseButtonPress, {100, 100}, Qt::LeftButton, Qt::ControlModifier);
    canvas.viewer.startAnew(std::nullopt);
    const Camera anew = canvas.viewer.camera();
    while (!canvas.open.empty()) canvas.answer(2);
    QCOMPARE(canvas.selection.selected(), std::set<ElementId>{LinkId("2")});
    QVERIFY(canvas.viewer.camera() == anew);
    canvas.mouse(QEvent::MouseMove, {150, 100}, Qt::LeftButton, Qt::ControlModifier);  // hovers
    canvas.wheel({320, 210});
    QCOMPARE(canvas.open.size(), std::size_t{2});
  }

  void expensivePicturesWaitUntilTheHandRests() {
    Selection selection;
    Viewer viewer(&selection);
    viewer.setScene(test::toyStage());
    viewer.setPictureCost(40);
    QSignalSpy changed(&viewer, &Viewer::viewChanged);
    for (int i = 0; i < 5; ++i) {
      selection.hover(viewer.stage()->scene.instances.front().element);
      selection.unhover();
    }
    selection.hover(viewer.stage()->scene.instances.front().element);
    QCOMPARE(changed.count(), 0);
    QVERIFY(changed.wait());
    QCOMPARE(changed.count(), 1);
  }
};

}  // namespace geargraph

QTEST_MAIN(geargraph::ViewerTest)
#include "test_viewer.moc"

#include <QSignalSpy>
#include <QTest>
#include <cmath>

#include "tests/ui/view3d/toy_stage.h"
#include "ui/view3d/viewer.h"

namespace geargraph {

class ViewerTest : public QObject {
  Q_OBJECT

 private slots:
  void whatIsPointedAtElsewhereLightsUpAtOnce() {
    Selection selection;
    Viewer viewer(&selection);
    viewer.setStage(test::toyStage());
    QSignalSpy changed(&viewer, &Viewer::viewChanged);
    selection.hover(viewer.stage()->scene.instances.front().element);
    QCOMPARE(changed.count(), 1);
    selection.hover(ElementId(MeshId("nowhere")));
    QCOMPARE(changed.count(), 2);
    selection.hover(ElementId(MeshId("nowhere else")));
    QCOMPARE(changed.count(), 2);  // nothing here was lit before or is now
  }

  void tracedPathsSurviveAnEditAndFollowIt() {
    Selection selection;
    Viewer viewer(&selection);
    viewer.setStage(test::toyStage());
    QVERIFY(viewer.trace({0, LinkId("1"), {15, -22, 0}}));
    QVERIFY(viewer.trace({2, LinkId("3"), {0, 0, 30}}));
    const double length = viewer.traces()[0].path.length;
    viewer.setStage(test::toyStage(8));  // twice the period: twice round
    QCOMPARE(viewer.traces().size(), std::size_t{2});
    QVERIFY(std::abs(viewer.traces()[0].path.length - 2 * length) < 1e-3 * length);

    auto fewer = std::make_shared<Stage>(*test::toyStage());
    fewer->scene.instances[0].element = LinkId("9");  // link 1 has gone
    std::swap(fewer->scene.instances[1].element, fewer->scene.instances[2].element);
    viewer.setStage(fewer);
    QCOMPARE(viewer.traces().size(), std::size_t{1});
    QCOMPARE(viewer.traces()[0].point.instance, std::size_t{1});

    auto still = std::make_shared<Stage>(*fewer);
    still->place = {};
    still->inputSpeeds.clear();
    viewer.setStage(still);
    QVERIFY(viewer.traces()[0].path.points.empty());
    viewer.setStage(fewer);
    QVERIFY(!viewer.traces()[0].path.points.empty());
    viewer.startAnew(std::nullopt);
    QVERIFY(viewer.traces().empty());
  }

  void aPathSeenFromALinkGoesWithThatLink() {
    Selection selection;
    Viewer viewer(&selection);
    viewer.setStage(test::toyStage());
    viewer.rideAlong(ElementId(LinkId("2")));
    QVERIFY(viewer.trace({0, LinkId("1"), {15, -22, 0}}));
    viewer.setStage(test::toyStage());
    QCOMPARE(viewer.traces()[0].point.watcher, std::optional<std::size_t>(1));
    auto without = std::make_shared<Stage>(*test::toyStage());
    without->scene.instances[1].element = LinkId("9");
    viewer.setStage(without);
    QVERIFY(viewer.traces().empty());
  }

  void untilSomebodyMovesTheCameraTheTrainFitsEverySize() {
    Selection selection;
    Viewer viewer(&selection);
    viewer.setStage(test::toyStage());
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

  void aViewThatGetsLowerLeavesATrainInMotionWhereItIs() {
    Selection selection;
    Viewer viewer(&selection);
    viewer.setStage(test::toyStage());
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
    viewer.setStage(test::toyStage());
    QVERIFY(!viewer.isCameraChosen());
    const Camera fitted = viewer.camera();
    const Camera own = Camera::from(1, 0.5).placedAt({1, 2, 3}, 77);
    viewer.setCamera(own);
    QVERIFY(viewer.isCameraChosen());
    viewer.setStage(test::toyStage());  // an edit
    QVERIFY(viewer.camera() == own);
    viewer.startAnew(std::nullopt);
    viewer.setStage(std::make_shared<const Stage>());  // nothing to see yet
    viewer.setStage(test::toyStage());
    QVERIFY(viewer.camera() == fitted);
    QVERIFY(!viewer.isCameraChosen());
    viewer.startAnew(own);
    viewer.setStage(test::toyStage());
    QVERIFY(viewer.camera() == own && viewer.isCameraChosen());
  }

  void dearPicturesWaitUntilTheHandRests() {
    Selection selection;
    Viewer viewer(&selection);
    viewer.setStage(test::toyStage());
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

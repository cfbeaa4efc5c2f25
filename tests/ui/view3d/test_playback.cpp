#include <QSignalSpy>
#include <QTest>

#include "tests/ui/view3d/toy_stage.h"
#include "ui/view3d/label_layer.h"
#include "ui/view3d/overlay.h"
#include "ui/view3d/playback.h"

using namespace geargraph;

class PlaybackTest : public QObject {
  Q_OBJECT

 private slots:
  void timeRunsAtTheSpeedAndTurnsRoundAtThePeriod() {
    Playback playback;
    playback.setPeriod(4);
    playback.advance(1.5);
    QCOMPARE(playback.time(), 1.5);
    playback.setSpeed(2);
    playback.advance(1);
    QCOMPARE(playback.time(), 3.5);
    playback.advance(0.5);
    QCOMPARE(playback.time(), 0.5);
    playback.setSpeed(-1);
    playback.advance(1);
    QCOMPARE(playback.time(), 3.5);
  }

  void withoutAPeriodTimeGoesOn() {
    Playback playback;
    playback.advance(1e6);
    QCOMPARE(playback.time(), 1e6);
    playback.setSpeed(-1);
    playback.advance(2e6);
    QCOMPARE(playback.time(), -1e6);
  }

  void atAnEndOfItsRangeTheMotionTurnsRound() {
    Playback playback;
    playback.setPeriod(4);
    playback.setRange(-1, 3);
    QSignalSpy ends(&playback, &Playback::endReached);
    playback.advance(2.5);
    QVERIFY(ends.isEmpty());
    playback.advance(1);
    QCOMPARE(playback.time(), 3.0);
    QCOMPARE(playback.speed(), -1.0);
    QCOMPARE(ends.takeFirst().front().toBool(), true);
    playback.advance(3.5);
    QCOMPARE(playback.time(), -0.5);  // below 0 too: the period does not count
    playback.advance(1);
    QCOMPARE(playback.time(), -1.0);
    QCOMPARE(playback.speed(), 1.0);
    QCOMPARE(ends.takeFirst().front().toBool(), false);
  }

  void timeIsClampedToTheRange() {
    Playback playback;
    playback.setRange(-1, 3);
    playback.setTime(7);
    QCOMPARE(playback.time(), 3.0);
    QSignalSpy ends(&playback, &Playback::endReached);
    playback.step(1);
    QCOMPARE(playback.time(), 3.0);
    QCOMPARE(ends.count(), 1);
    playback.setRange(-1, 2);
    QCOMPARE(playback.time(), 2.0);
    const double open = std::numeric_limits<double>::infinity();
    playback.setRange(-open, open);
    playback.setTime(7);
    QCOMPARE(playback.time(), 7.0);
  }

  void lengthsOfTheScaleBarReadWell() {
    QCOMPARE(niceLength(1, 110), 100.0);
    QCOMPARE(niceLength(0.42, 110), 20.0);
    QCOMPARE(niceLength(0.01, 110), 1.0);
    QCOMPARE(niceLength(0.0071, 110), 0.5);
    QCOMPARE(niceLength(31, 110), 2000.0);
  }

  void nonsenseIsIgnored() {
    Playback playback;
    playback.setTime(std::nan(""));
    playback.setSpeed(std::numeric_limits<double>::infinity());
    playback.setPeriod(-3);
    QCOMPARE(playback.time(), 0.0);
    QCOMPARE(playback.speed(), 1.0);
    QCOMPARE(playback.period(), 0.0);
  }

  void signalsComeOnceAChange() {
    Playback playback;
    QSignalSpy times(&playback, &Playback::timeChanged), plays(&playback, &Playback::playingChanged);
    playback.setTime(2);
    playback.setTime(2);
    playback.setPlaying(true);
    playback.setPlaying(true);
    playback.toggle();
    QCOMPARE(times.count(), 1);
    QCOMPARE(plays.count(), 2);
  }

  void whoPointsAtAPlateMeansItsPart() {
    const MechanismScenePtr stage = test::toyStage();
    std::vector<Pose> poses;
    for (const Instance& instance : stage->scene.instances) poses.push_back(instance.pose);
    LabelLayer layer;
    layer.setBorders(90, 20);  // pushes the box's plate down from its part
    const Viewport viewport{300, 200};
    const Camera camera = Camera::looking(StandardView::right).fitted(cornersOf(stage->scene), viewport);
    QVERIFY(layer.areNew());
    const auto plates = layer.place({*stage, poses, {}, camera, viewport, 1});
    QCOMPARE(plates.size(), stage->labels.size());
    const LabelPlate& box = plates[2];
    QVERIFY(box.hasLine());
    const QPointF plate(box.middle.x(), box.middle.y()), part(box.anchor.x(), box.anchor.y());
    QCOMPARE(layer.meant(plate + QPointF(kLabelRadius - 1, 0)), part);
    QCOMPARE(layer.meant(plate + QPointF(kLabelRadius + 1, 0)), plate + QPointF(kLabelRadius + 1, 0));
  }
};

QTEST_GUILESS_MAIN(PlaybackTest)
#include "test_playback.moc"

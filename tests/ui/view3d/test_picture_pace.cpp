#include <QSignalSpy>
#include <QTest>

#include "tests/ui/view3d/toy_stage.h"
#include "ui/view3d/picture_pace.h"

using namespace geargraph;

namespace {

struct Hand {
  Selection selection;
  Viewer viewer{&selection};
  LabelLayer labels;
  PicturePace pace{&viewer, &labels, nullptr};
  QSignalSpy rested{&pace, &PicturePace::rested};

  explicit Hand(bool isSoftware) { pace.setSoftware(isSoftware); }
};

}  // namespace

class TestPicturePace : public QObject {
  Q_OBJECT

 private slots:
  void whatMovesIsAQuickLookUntilItRests() {
    Hand hand(true);
    QVERIFY(!hand.pace.isQuick());
    emit hand.viewer.moving();
    QVERIFY(hand.pace.isQuick());
    QTRY_COMPARE(hand.rested.count(), 1);
    QVERIFY(!hand.pace.isQuick());
  }

  void anotherSceneIsAQuickLookFirst() {
    Hand hand(true);
    hand.viewer.setStage(test::toyStage());
    QVERIFY(hand.pace.isQuick());
    QTRY_COMPARE(hand.rested.count(), 1);
  }

  void aGraphicsCardKeepsUp() {
    Hand hand(false);
    emit hand.viewer.moving();
    QVERIFY(!hand.pace.isQuick());
  }

  void labelsAreLookedForNowAndThenAndOnceMoreAtRest() {
    Hand hand(true);
    hand.viewer.setStage(test::toyStage());
    const StagePtr& stage = hand.viewer.stage();
    QVERIFY(hand.pace.takeMap());
    const Viewport viewport{64, 64};
    SeenMap seen;
    hand.labels.place({*stage, hand.viewer.poses(), {}, hand.viewer.camera(), viewport, 1, &seen});
    QVERIFY(!hand.pace.takeMap());
    QTRY_COMPARE(hand.rested.count(), 1);
    QVERIFY(hand.pace.takeMap());
    hand.labels.setShown(LabelKind::link, false);
    QVERIFY(!hand.pace.takeMap());
  }
};

QTEST_MAIN(TestPicturePace)
#include "test_picture_pace.moc"

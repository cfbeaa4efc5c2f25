#include <QSignalSpy>
#include <QTest>

#include "tests/ui/view3d/toy_stage.h"
#include "ui/view3d/draft_level.h"
#include "ui/view3d/picture_pace.h"

using namespace geargraph;

namespace {

struct MouseHand {
  Selection selection;
  Viewer viewer{&selection};
  LabelLayer labels;
  PicturePace pace{&viewer, &labels, nullptr};
  QSignalSpy rested{&pace, &PicturePace::rested};

  explicit MouseHand(bool isSoftware) { pace.setSoftware(isSoftware); }
};

}  // namespace

class PicturePaceTest : public QObject {
  Q_OBJECT

 private slots:
  void whatMovesIsADraftUntilItRests() {
    MouseHand hand(true);
    QVERIFY(!hand.pace.isDraft());
    emit hand.viewer.moving();
    QVERIFY(hand.pace.isDraft());
    QTRY_COMPARE(hand.rested.count(), 1);
    QVERIFY(!hand.pace.isDraft());
  }

  void anotherSceneIsADraftFirst() {
    MouseHand hand(true);
    hand.viewer.setScene(test::toyStage());
    QVERIFY(hand.pace.isDraft());
    QTRY_COMPARE(hand.rested.count(), 1);
  }

  void aGraphicsCardKeepsUp() {
    MouseHand hand(false);
    emit hand.viewer.moving();
    QVERIFY(!hand.pace.isDraft());
  }

  void labelsAreLookedForNowAndThenAndOnceMoreAtRest() {
    MouseHand hand(true);
    hand.viewer.setScene(test::toyStage());
    const MechanismScenePtr& stage = hand.viewer.stage();
    QVERIFY(hand.pace.takeMap());
    const Viewport viewport{64, 64};
    VisibilityBuffer seen;
    hand.labels.place({*stage, hand.viewer.poses(), {}, hand.viewer.camera(), viewport, 1, &seen});
    QVERIFY(!hand.pace.takeMap());
    QTRY_COMPARE(hand.rested.count(), 1);
    QVERIFY(hand.pace.takeMap());
    hand.labels.setShown(LabelKind::link, false);
    QVERIFY(!hand.pace.takeMap());
  }

  void slowDraftsGetSimplerStepByStep() {
    DraftLevel draft;
    for (const auto& [milliseconds, level] :
         {std::pair{90, 0}, {21, 0}, {21, 1}, {90, 1}, {21, 1}, {21, 2}, {90, 2}, {90, 2}, {90, 2}}) {
      draft.took(milliseconds, false);
      QCOMPARE(draft.level(), level);
    }
  }

  void oneSlowPictureAloneChangesNothing() {
    DraftLevel draft;
    for (const double milliseconds : {15.0, 90.0, 15.0, 90.0, 15.0}) draft.took(milliseconds, false);
    QCOMPARE(draft.level(), 0);
  }

  void onlySeveralFastOnesMakeThemFinerAgain() {
    DraftLevel draft;
    for (int picture = 0; picture < 3; ++picture) draft.took(30, false);
    QCOMPARE(draft.level(), 1);
    for (int picture = 0; picture < 8; ++picture) {
      QCOMPARE(draft.level(), 1);
      draft.took(5, false);
    }
    QCOMPARE(draft.level(), 1);  // the first of a level does not count
    draft.took(5, false);
    QCOMPARE(draft.level(), 0);
  }

  void whereSolidsAreNewLessTimeIsLeft() {
    DraftLevel steps, turns;
    for (int picture = 0; picture < 3; ++picture) {
      steps.took(12, true);
      turns.took(12, false);
    }
    QCOMPARE(steps.level(), 1);
    QCOMPARE(turns.level(), 0);
    for (int picture = 0; picture < 20; ++picture) steps.took(5, true);
    QCOMPARE(steps.level(), 1);  // with edges it would take the 12 ms again
  }
};

QTEST_MAIN(PicturePaceTest)
#include "test_picture_pace.moc"

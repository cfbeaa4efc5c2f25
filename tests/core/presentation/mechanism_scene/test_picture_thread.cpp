#include <QTest>
#include <future>
#include <mutex>

#include "core/presentation/mechanism_scene/picture_thread.h"
#include "tests/ui/view3d/toy_stage.h"

namespace geargraph {
namespace {

constexpr Viewport kSize{160, 100};

/// The toy as its camera sees it after so many rad of its input.
OwningFramePtr toyAt(const MechanismScenePtr& stage, double angle) {
  std::vector<Pose> poses(stage->scene.instances.size());
  stage->place(std::vector{angle}, poses);
  Frame frame;
  frame.viewport = kSize;
  frame.camera = Camera::home().fitted(outlineOf(stage->scene), kSize, 0.1);
  frame.style = RenderStyle::light();
  frame.poses = poses;
  return std::make_shared<const FrameSnapshot>(stage, frame);
}

/// The painting thread, and what it has delivered.
struct Studio {
  std::mutex mutex;
  std::vector<PaintedPicture> pictures;
  std::unique_ptr<PictureThread> thread;

  Studio() {
    thread = std::move(PictureThread::start([this](PaintedPicture picture) {
               const std::lock_guard lock(mutex);
               pictures.push_back(std::move(picture));
             })).value();
  }

  /// The answer to a question, awaited.
  [[nodiscard]] std::optional<Hit> pick(const OwningFramePtr& frame, double x, double y) {
    std::promise<std::optional<Hit>> answer;
    thread->ask({frame, x, y, false, [&](const std::optional<Hit>& hit) { answer.set_value(hit); }});
    return answer.get_future().get();
  }
};

}  // namespace

class PictureThreadTest : public QObject {
  Q_OBJECT

 private slots:
  void aPictureIsThatOfAHostOnThisThread() {
    const MechanismScenePtr stage = test::toyStage();
    const OwningFramePtr frame = toyAt(stage, 0.7);
    Studio studio;
    studio.thread->order({frame, 1, Viewport{8, 5}});
    studio.thread->finish();
    QCOMPARE(studio.pictures.size(), std::size_t{1});
    const auto host = std::move(EglHost::create()).value();
    host->setScene(stage->scene);
    QVERIFY(studio.pictures[0].image.rgba == host->picture(frame->frame()).rgba);
    QVERIFY(studio.pictures[0].seen->numbers == host->seen(frame->frame(), 8, 5).numbers);
    QCOMPARE(studio.thread->name(), host->name());
  }

  void theNewestOrderWins() {
    const MechanismScenePtr stage = test::toyStage();
    Studio studio;
    OwningFramePtr last;
    constexpr std::size_t kOrders = 60;
    for (std::size_t i = 0; i < kOrders; ++i) {
      last = toyAt(stage, 0.1 * static_cast<double>(i));
      studio.thread->order({last, 1, {}});
    }
    studio.thread->finish();
    QVERIFY(studio.pictures.size() < kOrders);
    QCOMPARE(studio.pictures.back().order.frame, last);
  }

  void aDraftHasFewerPixelsOfTheSameView() {
    const OwningFramePtr frame = toyAt(test::toyStage(), 0);
    Studio studio;
    studio.thread->order({frame, 0.5, kSize});
    studio.thread->finish();
    const Image& image = studio.pictures[0].image;
    QCOMPARE(std::pair(image.width, image.height), std::pair(kSize.width / 2, kSize.height / 2));
    const VisibilityBuffer& seen = *studio.pictures[0].seen;
    QCOMPARE(std::pair(seen.columns, seen.rows), std::pair(kSize.width, kSize.height));
  }

  void aMapMayFollowItsPicture() {
    const MechanismScenePtr stage = test::toyStage();
    const OwningFramePtr frame = toyAt(stage, 0.7);
    Studio studio;
    studio.thread->order({frame, 1, Viewport{8, 5}, true});
    studio.thread->finish();
    QCOMPARE(studio.pictures.size(), std::size_t{2});
    QVERIFY(!studio.pictures[0].isMapAlone && !studio.pictures[0].seen);
    QCOMPARE(studio.pictures[0].image.width, kSize.width);
    const auto host = std::move(EglHost::create()).value();
    host->setScene(stage->scene);
    QVERIFY(studio.pictures[1].isMapAlone && studio.pictures[1].image.rgba.empty());
    QCOMPARE(studio.pictures[1].order.frame, frame);
    QVERIFY(studio.pictures[1].seen->numbers == host->seen(frame->frame(), 8, 5).numbers);
  }

  /// Whoever is ordered while the picture is painted does not wait for the map behind it.
  void aMapThatMayFollowGivesWayToTheNextOrder() {
    const MechanismScenePtr stage = test::toyStage();
    const OwningFramePtr first = toyAt(stage, 0), second = toyAt(stage, 1);
    std::vector<PaintedPicture> pictures;
    std::unique_ptr<PictureThread> thread;
    thread = std::move(PictureThread::start([&](PaintedPicture picture) {
               if (picture.order.frame == first) thread->order({second, 1, {}});
               pictures.push_back(std::move(picture));
             })).value();
    thread->order({first, 1, Viewport{8, 5}, true});
    thread->finish();
    QCOMPARE(pictures.size(), std::size_t{2});
    QCOMPARE(pictures[1].order.frame, second);
    QVERIFY(!pictures[0].seen && !pictures[1].seen);
  }

  void rehearsalsDeliverNothingAndLeaveNoTrace() {
    const MechanismScenePtr stage = test::toyStage();
    const OwningFramePtr frame = toyAt(stage, 0.7), other = toyAt(stage, 2);
    Studio studio;
    studio.thread->order({frame, 1, {}});
    studio.thread->rehearse({{other, 0.1, {}}, {other, 0.5, Viewport{4, 4}}, {other, 1, {}, true}});
    studio.thread->finish();
    const ScreenPoint onBox = frame->frame().camera.project({0, 0, 30}, kSize);
    for (int i = 0; i < 6; ++i) QVERIFY(studio.pick(frame, onBox.x, onBox.y));
    studio.thread->order({frame, 1, {}});
    studio.thread->finish();
    QCOMPARE(studio.pictures.size(), std::size_t{2});
    QVERIFY(studio.pictures[0].image.rgba == studio.pictures[1].image.rgba);
    QVERIFY(!studio.pictures[0].seen && !studio.pictures[1].seen);
  }

  void anotherStageIsTakenUp() {
    const OwningFramePtr nothing =
        std::make_shared<const FrameSnapshot>(nullptr, toyAt(test::toyStage(), 0)->frame());
    const OwningFramePtr toy = toyAt(test::toyStage(), 0);
    Studio studio;
    for (const OwningFramePtr& frame : {toy, nothing, toy}) {
      studio.thread->order({frame, 1, {}});
      studio.thread->finish();
    }
    QVERIFY(studio.pictures[0].image.rgba != studio.pictures[1].image.rgba);
    QVERIFY(studio.pictures[0].image.rgba == studio.pictures[2].image.rgba);
  }

  void aPickIsAnsweredBetweenPictures() {
    const MechanismScenePtr stage = test::toyStage();
    const OwningFramePtr frame = toyAt(stage, 0);
    const ScreenPoint onBox = frame->frame().camera.project({0, 0, 30}, kSize);
    Studio studio;
    for (int i = 0; i < 20; ++i) {
      studio.thread->order({frame, 1, {}});
      const auto hit = studio.pick(frame, onBox.x, onBox.y);
      QVERIFY(hit.has_value());
      QCOMPARE(hit->instance, std::size_t{2});
      QVERIFY(!studio.pick(frame, 1, 50));
    }
  }

  /// The painting thread is kept in an answer meanwhile, so that the others wait for their turn.
  void ofQuestionsThatGiveWayTheNewestIsAnsweredAndOfTheOthersAll() {
    const OwningFramePtr frame = toyAt(test::toyStage(), 0);
    Studio studio;
    std::promise<void> begun, goOn;
    std::vector<int> answered;
    studio.thread->ask({frame, 1, 1, true, [&](const auto&) {
                          begun.set_value();
                          goOn.get_future().wait();
                        }});
    begun.get_future().wait();
    const auto ask = [&](int number, bool givesWay) {
      studio.thread->ask({frame, 1, 1, givesWay, [&, number](const auto&) { answered.push_back(number); }});
    };
    ask(1, true);
    ask(2, false);
    ask(3, true);
    ask(4, false);
    ask(5, true);
    goOn.set_value();
    static_cast<void>(studio.pick(frame, 1, 1));
    QCOMPARE(answered, (std::vector<int>{2, 4, 5}));
  }

  void itGoesInTheMidstOfItsWork() {
    const MechanismScenePtr stage = test::toyStage();
    for (int round = 0; round < 5; ++round) {
      Studio studio;
      for (int i = 0; i < round; ++i) studio.thread->order({toyAt(stage, i), 1, {}});
      studio.thread.reset();
      QVERIFY(studio.pictures.size() <= static_cast<std::size_t>(round));
    }
  }
};

}  // namespace geargraph

QTEST_APPLESS_MAIN(geargraph::PictureThreadTest)
#include "test_picture_thread.moc"

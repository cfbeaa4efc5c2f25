#include "core/presentation/gl_renderer/static_parts.h"

#include <QTest>
#include <functional>

#include "core/presentation/gl_renderer/egl_host.h"
#include "tests/core/presentation/gl_renderer/small_scenes.h"

using namespace geargraph;

namespace {

using Layer = StaticParts::Layer;

StaticParts::View aView() {
  StaticParts::View view;
  view.width = kView.width;
  view.height = kView.height;
  view.style = RenderStyle::light().cheaper();
  return view;
}

std::vector<StaticParts::Part> boxes(int count) {
  std::vector<StaticParts::Part> parts;
  for (int i = 0; i < count; ++i) {
    StaticParts::Part& part = parts.emplace_back();
    part.solid = std::make_shared<const Solid>(boxSolid({-1, -1, -1}, {1, 1, 1}));
    part.pose.translation().x() = 3 * i;
  }
  return parts;
}

void move(StaticParts::Part& part) {
  part.pose.translation().z() += 1;
}

constexpr Visibility kPainted = Visibility::solid, kLeft = Visibility::hidden;
using Shown = std::vector<Visibility>;

/// A shaft with wheels before and behind it, and what a look at it in motion shows.
Scene rowScene() {
  Scene scene;
  add(scene, cylinderSolid(3, -20, 20), {0, 0, 0}, 0x8A9099, "0");
  add(scene, revolvedSolid({{4, -3}, {15, -3}, {15, 3}, {4, 3}}, 64), {0, 0, 5}, kOrange, "2");
  add(scene, boxSolid({-6, -6, -6}, {6, 6, 6}), {12, -12, 0}, kBlue, "1");
  add(scene, boxSolid({-6, -6, -6}, {6, 6, 6}), {-12, 12, -12}, kGreen, "3");
  return scene;
}

}  // namespace

class StaticPartsTest : public QObject {
  Q_OBJECT

 private slots:
  void theFirstPictureKeepsNothing() {
    StaticParts still;
    QCOMPARE(still.next(aView(), boxes(3)), Layer::none);
  }

  void whatStaysIsPaintedOnceAndWhatMovesEachTime() {
    StaticParts still;
    auto parts = boxes(3);
    (void)still.next(aView(), parts);
    move(parts[1]);
    QCOMPARE(still.next(aView(), parts), Layer::anew);
    QCOMPARE(still.added(), (Shown{kPainted, kLeft, kPainted}));
    QCOMPARE(still.rest(), (Shown{kLeft, kPainted, kLeft}));
    move(parts[1]);
    QCOMPARE(still.next(aView(), parts), Layer::cached);
    QVERIFY(!still.hasAdded());
    QCOMPARE(still.rest(), (Shown{kLeft, kPainted, kLeft}));
  }

  void whatHasComeToRestJoinsTheOthers() {
    StaticParts still;
    auto parts = boxes(3);
    (void)still.next(aView(), parts);
    move(parts[1]);
    (void)still.next(aView(), parts);
    QCOMPARE(still.next(aView(), parts), Layer::cached);
    QVERIFY(still.hasAdded());
    QCOMPARE(still.added(), (Shown{kLeft, kPainted, kLeft}));
    QCOMPARE(still.rest(), Shown(3, kLeft));
  }

  void aChangeOfWhatWasCachedBeginsTheLayerAnew() {
    const auto changes = std::vector<std::function<void(StaticParts::Part&)>>{
        move,
        [](StaticParts::Part& part) { part.colour = Rgb::fromHex(kBlue); },
        [](StaticParts::Part& part) { part.emphasis = Highlight::hovered; },
        [](StaticParts::Part& part) { part.visibility = Visibility::hidden; },
        [](StaticParts::Part& part) {
          part.levels.finer.push_back({0.1, nullptr});
        },
        [](StaticParts::Part& part) { part.solid = std::make_shared<const Solid>(*part.solid); }};
    for (const auto& change : changes) {
      StaticParts still;
      auto parts = boxes(3);
      (void)still.next(aView(), parts);
      (void)still.next(aView(), parts);
      change(parts[0]);
      QCOMPARE(still.next(aView(), parts), Layer::anew);
      QCOMPARE(still.added(), (Shown{kLeft, kPainted, kPainted}));
      QCOMPARE(still.rest().front(), parts[0].visibility);
    }
  }

  void partsThatComeAndGoAreNotTakenForOthers() {
    StaticParts still;
    auto parts = boxes(3);
    (void)still.next(aView(), parts);
    (void)still.next(aView(), parts);
    parts.pop_back();
    QCOMPARE(still.next(aView(), parts), Layer::anew);
    QCOMPARE(still.added(), Shown(2, kPainted));
    parts.push_back(boxes(1).front());
    QCOMPARE(still.next(aView(), parts), Layer::cached);
    QCOMPARE(still.rest(), (Shown{kLeft, kLeft, kPainted}));
  }

  void anotherCameraKeepsNothingAndAnotherStyleBeginsAnew() {
    StaticParts still;
    const auto parts = boxes(2);
    StaticParts::View view = aView();
    (void)still.next(view, parts);
    QCOMPARE(still.next(view, parts), Layer::anew);
    view.camera = view.camera.orbited(5, 0);
    QCOMPARE(still.next(view, parts), Layer::none);
    QCOMPARE(still.next(view, parts), Layer::anew);
    QCOMPARE(still.next(view, parts), Layer::cached);
    view.style = RenderStyle::dark().cheaper();
    QCOMPARE(still.next(view, parts), Layer::anew);
    view.width += 1;
    QCOMPARE(still.next(view, parts), Layer::none);
  }

  /// Whatever came before it, a draft frame is the one that somebody sees who looks for the first time.
  void aDraftOverWhatIsCachedIsThatWhichIsPaintedAnew() {
    auto made = EglHost::create();
    QVERIFY(made.has_value());
    EglHost& host = **made;
    Scene scene = rowScene();
    Frame frame = frameOf(scene, RenderStyle::light().cheaper(), StandardView::isometric);
    frame.style.edges = false;
    std::vector<Highlight> emphasis(scene.instances.size(), Highlight::none);
    std::vector<Visibility> visibility(scene.instances.size(), Visibility::solid);
    frame.emphasis = emphasis;
    frame.visibility = visibility;
    const std::vector<std::function<void()>> steps{
        [] {},
        [] {},
        [&] { scene.instances[1].pose.translation().z() = 8; },
        [&] { scene.instances[1].pose.translation().z() = -8; },
        [&] {
          scene.solids[2] = std::make_shared<const Solid>(boxSolid({-6, -6, -6}, {6, 6, 9}));
        },
        [&] { emphasis[3] = Highlight::selected; },
        [&] { visibility[2] = Visibility::hidden; },
        [&] { visibility[2] = Visibility::translucent; },
        [&] { visibility[2] = Visibility::solid; },
        [&] { frame.style = RenderStyle::dark().cheaper(), frame.style.edges = false; },
        [&] { frame.camera = frame.camera.orbited(9, 4); },
        [&] { scene.instances[0].colour = Rgb::fromHex(kGreen); },
        [&] { frame.floor = 0; },  // parts have swung below it
        [&] { frame.section = CutPlane{}; },
        [&] { frame.section.reset(); }};
    for (std::size_t step = 0; step < steps.size(); ++step) {
      steps[step]();
      auto other = EglHost::create();
      QVERIFY(other.has_value());
      for (EglHost* painter : {&host, other->get()}) painter->setScene(scene);
      QVERIFY2(host.picture(frame).rgba == (*other)->picture(frame).rgba, qPrintable(QString::number(step)));
    }
  }
};

QTEST_APPLESS_MAIN(StaticPartsTest)
#include "test_static_parts.moc"

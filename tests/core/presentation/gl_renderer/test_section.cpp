#include <QTest>

#include "core/presentation/gl_renderer/egl_host.h"
#include "tests/core/presentation/gl_renderer/small_scenes.h"

namespace geargraph {
namespace {

/// A tube with a rod in it, both along z, and a box far behind them in y.
Scene tubeScene() {
  Scene scene;
  add(scene, revolvedSolid({{8, -15}, {14, -15}, {14, 15}, {8, 15}}, 48), {0, 0, 0}, kBlue, "1");
  add(scene, cylinderSolid(4, -15, 15), {0, 0, 0}, kOrange, "2");
  add(scene, boxSolid({-35, -2, -20}, {35, 2, 20}), {0, 40, 0}, kGreen, "3");
  return scene;
}

Frame frontOf(const Scene& scene) {
  return frameOf(scene, bare(), StandardView::front);
}

enum class Paint { nothing, blue, orange, green, other };

Paint paintOf(const std::array<std::uint8_t, 4>& pixel) {
  if (pixel[3] < 128) return Paint::nothing;
  if (pixel[2] > pixel[0] + 40 && pixel[2] > pixel[1]) return Paint::blue;
  if (pixel[0] > pixel[2] + 60 && pixel[0] > pixel[1]) return Paint::orange;
  if (pixel[1] > pixel[0] + 40 && pixel[1] > pixel[2]) return Paint::green;
  return Paint::other;
}

}  // namespace

class SectionTest : public QObject {
  Q_OBJECT

 private slots:
  void initTestCase() {
    auto host = EglHost::create();
    QVERIFY2(host.has_value(), host ? "" : host.error().front().message.c_str());
    m_host = std::move(host).value();
  }
  void cleanupTestCase() { m_host.reset(); }

  // What stands before the plane goes; a cut tube shows two bars, the rod between them, and gaps.
  void aCutIsAFaceOfTheSolidAndNothingElse() {
    const Scene scene = tubeScene();
    m_host->setScene(scene);
    Frame frame = frontOf(scene);
    const auto whole = m_host->picture(frame);
    QCOMPARE(paintOf(seenAt(whole, frame, {0, -14, 0})), Paint::blue);  // the tube hides the rod
    frame.section = CutPlane{{0, -1, 0}, 0};
    const auto cut = m_host->picture(frame);
    QCOMPARE(paintOf(seenAt(cut, frame, {11, 0, 3})), Paint::blue);
    QCOMPARE(paintOf(seenAt(cut, frame, {-11, 0, -8})), Paint::blue);
    QCOMPARE(paintOf(seenAt(cut, frame, {1, 0, 4})), Paint::orange);
    QCOMPARE(paintOf(seenAt(cut, frame, {17, 0, 0})), Paint::green);  // beside the tube
    QVERIFY(paintOf(seenAt(cut, frame, {6, 0, 3})) == Paint::blue);   // the bore behind the gap
  }

  // The cap lies in the plane: hatched evenly, whatever is behind it, and it hides what is behind it.
  void theCapLiesInThePlane() {
    const Scene scene = tubeScene();
    m_host->setScene(scene);
    Frame frame = frontOf(scene);
    frame.section = CutPlane{{0, -1, 0}, 0};
    const auto hit = m_host->pick(frame, frame.camera.project({1, 0, 0}, kView).x,
                                  frame.camera.project({1, 0, 0}, kView).y);
    QVERIFY(hit.has_value());
    QCOMPARE(hit->element, ElementId(LinkId("2")));
    frame.section->offset = -40;  // through the box only: tube and rod are gone
    const auto behind = m_host->picture(frame);
    QCOMPARE(paintOf(seenAt(behind, frame, {0, 40, 0})), Paint::green);
    QCOMPARE(paintOf(seenAt(behind, frame, {11, 40, 3})), Paint::green);
  }

  void theOtherHalfIsLeftWhenThePlaneIsTurned() {
    const Scene scene = tubeScene();
    m_host->setScene(scene);
    Frame frame = frontOf(scene);
    frame.section = CutPlane{{1, 0, 0}, 0};
    const auto left = m_host->picture(frame);
    QVERIFY(paintOf(seenAt(left, frame, {11, 0, 0})) != Paint::blue);
    QCOMPARE(paintOf(seenAt(left, frame, {-11, -10, 0})), Paint::blue);
    frame.section = CutPlane{{-1, 0, 0}, 0};
    const auto right = m_host->picture(frame);
    QCOMPARE(paintOf(seenAt(right, frame, {11, -10, 0})), Paint::blue);
    QVERIFY(paintOf(seenAt(right, frame, {-11, 0, 0})) != Paint::blue);
  }

  void aPlaneBesideEverythingChangesNothing() {
    const Scene scene = tubeScene();
    m_host->setScene(scene);
    Frame frame = frontOf(scene);
    const auto whole = m_host->picture(frame);
    frame.section = CutPlane{{0, -1, 0}, 500};
    const auto cut = m_host->picture(frame);
    int differ = 0;
    for (std::size_t k = 0; k < cut.rgba.size(); ++k) differ += std::abs(cut.rgba[k] - whole.rgba[k]) > 12;
    QVERIFY2(differ < 40, qPrintable(QString::number(differ)));
  }

  void translucentPartsLetTheRestBeSeenAndPicked() {
    const Scene scene = tubeScene();
    m_host->setScene(scene);
    Frame frame = frontOf(scene);
    const std::vector<Visibility> visibility = {Visibility::translucent, Visibility::solid,
                                                Visibility::translucent};
    frame.visibility = visibility;
    const auto image = m_host->picture(frame);
    QCOMPARE(paintOf(seenAt(image, frame, {0, 0, 4})), Paint::orange);
    const auto translucent = seenAt(image, frame, {11, 0, 4});
    QVERIFY2(translucent[3] > 20 && translucent[3] < 120, qPrintable(QString::number(translucent[3])));
    const auto at = [&](const Eigen::Vector3d& point) {
      const ScreenPoint place = frame.camera.project(point, kView);
      return m_host->pick(frame, place.x, place.y);
    };
    QCOMPARE(at({0, 0, 4})->element, ElementId(LinkId("2")));
    QCOMPARE(at({11, 0, 4})->element, ElementId(LinkId("1")));
    QVERIFY(std::abs(at({11, 0, 4})->point.head<2>().norm() - 14) < 0.2);
    QVERIFY(at({11, 0, 4})->point.y() < 0);
  }

  void whatIsHiddenIsNeitherSeenNorPicked() {
    const Scene scene = tubeScene();
    m_host->setScene(scene);
    Frame frame = frontOf(scene);
    const std::vector<Visibility> visibility = {Visibility::hidden, Visibility::hidden, Visibility::solid};
    frame.visibility = visibility;
    const auto image = m_host->picture(frame);
    QCOMPARE(paintOf(seenAt(image, frame, {0, -14, 0})), Paint::green);
    QCOMPARE(m_host->pick(frame, 160, 120)->element, ElementId(LinkId("3")));
  }

  void edgesAloneLeaveMostOfThePictureOpen() {
    const Scene scene = tubeScene();
    m_host->setScene(scene);
    Frame frame = frontOf(scene);
    const double full = coverage(m_host->picture(frame));
    frame.style.faces = Faces::wireframe;
    const auto wires = m_host->picture(frame);
    QVERIFY(coverage(wires) > 0.002 && coverage(wires) < 0.2 * full);
    frame.style.faces = Faces::hiddenLine;
    const auto drawing = m_host->picture(frame);
    QVERIFY(std::abs(coverage(drawing) - full) < 0.02);
    const auto paper = seenAt(drawing, frame, {2, -14, 3});
    QVERIFY2(paper[0] > 220 && paper[1] > 220 && paper[2] > 220, qPrintable(QString::number(paper[0])));
  }

  void linesInSpaceAreSeenThroughSolidsOnlyFaintly() {
    const Scene scene = tubeScene();
    m_host->setScene(scene);
    Frame frame = frontOf(scene);
    const std::vector<MarkLine> marks = {
        {{{-30, 60, 12}, {30, 60, 12}}, Rgb{1, 0, 0}, 6, false},     // behind all
        {{{-30, -30, -5}, {30, -30, -5}}, Rgb{1, 0, 0}, 6, false}};  // before all
    const auto before = m_host->picture(frame);
    frame.marks = marks;
    const auto after = m_host->picture(frame);
    const auto redAt = [&](const Eigen::Vector3d& point) { return int(seenAt(after, frame, point)[0]); };
    QVERIFY(redAt({0, -30, -5}) > 240);
    const auto translucent = seenAt(after, frame, {2, 60, 12});
    const auto plain = seenAt(before, frame, {2, 60, 12});
    QVERIFY2(translucent[0] > plain[0] + 20 && translucent[0] < 200,
             qPrintable(QString::number(translucent[0])));
  }

 private:
  std::unique_ptr<EglHost> m_host;
};

}  // namespace geargraph

QTEST_GUILESS_MAIN(geargraph::SectionTest)
#include "test_section.moc"

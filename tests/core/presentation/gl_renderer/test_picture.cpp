#include <QTest>
#include <array>
#include <cmath>
#include <optional>
#include <stop_token>
#include <vector>

#include "core/presentation/gl_renderer/egl_host.h"
#include "core/presentation/gl_renderer/gl_renderer.h"
#include "tests/core/presentation/gl_renderer/small_scenes.h"

using namespace geargraph;

namespace {

Scene cubeScene() {
  Scene scene;
  add(scene, boxSolid({-10, -10, -10}, {10, 10, 10}), {0, 0, 0}, kBlue, "1");
  return scene;
}

/// A shaft, a wheel on it and a box beside it that hides a part of both.
Scene groupScene() {
  Scene scene;
  add(scene, cylinderSolid(3, -20, 20), {0, 0, 0}, 0x8A9099, "0");
  add(scene, revolvedSolid({{4, -3}, {15, -3}, {15, 3}, {4, 3}}, 64), {0, 0, 5}, kOrange, "2");
  add(scene, boxSolid({-6, -6, -6}, {6, 6, 6}), {12, -12, 0}, kBlue, "1");
  return scene;
}

Frame frameOf(const Scene& scene, const RenderStyle& style) {
  return frameOf(scene, style, StandardView::isometric);
}

/// Area of a convex outline's projection, as a part of the picture: the box seen from outside.
double boxCoverage(const Frame& frame, double half) {
  double area = 0;  // front faces only, by their projected quadrangles
  for (int axis = 0; axis < 3; ++axis) {
    for (const int side : {-1, 1}) {
      std::array<ScreenPoint, 4> corners;
      constexpr int kSigns[4][2] = {{-1, -1}, {1, -1}, {1, 1}, {-1, 1}};
      for (std::size_t k = 0; k < 4; ++k) {
        Eigen::Vector3d point;
        point[axis] = side * half;
        point[(axis + 1) % 3] = side * kSigns[k][0] * half;
        point[(axis + 2) % 3] = kSigns[k][1] * half;
        corners[k] = frame.camera.project(point, kView);
      }
      double twice = 0;
      for (std::size_t k = 0; k < 4; ++k) {
        const ScreenPoint &a = corners[k], &b = corners[(k + 1) % 4];
        twice += a.x * b.y - a.y * b.x;
      }
      area += std::max(0.0, -0.5 * twice);  // y runs down, so counter-clockwise is negative
    }
  }
  return area / (kView.width * kView.height);
}

/// Mean distance of two colours, in steps of a byte.
double apart(const std::array<std::uint8_t, 4>& a, const std::array<int, 3>& b) {
  double sum = 0;
  for (std::size_t k = 0; k < 3; ++k) sum += std::abs(int(a[k]) - b[k]);
  return sum / 3;
}

/// The nearest triangle that a ray meets: which instance, and where.
std::optional<Hit> traced(const Scene& scene, const Ray& ray) {
  std::optional<Hit> best;
  double nearest = 1e30;
  for (std::size_t i = 0; i < scene.instances.size(); ++i) {
    const Instance& instance = scene.instances[i];
    const Solid& solid = *scene.solids[instance.solid];
    for (const Triangle& triangle : solid.triangles) {
      Eigen::Matrix3d corners;
      for (int k = 0; k < 3; ++k) {
        const Float3& p = solid.positions[triangle[static_cast<std::size_t>(k)]];
        corners.col(k) = instance.pose * Eigen::Vector3d(p[0], p[1], p[2]);
      }
      Eigen::Matrix3d system;
      system << corners.col(1) - corners.col(0), corners.col(2) - corners.col(0), -ray.direction;
      if (std::abs(system.determinant()) < 1e-12) continue;
      const Eigen::Vector3d at = system.inverse() * (ray.origin - corners.col(0));
      if (at[0] < 0 || at[1] < 0 || at[0] + at[1] > 1 || at[2] <= 0 || at[2] >= nearest) continue;
      nearest = at[2];
      best = Hit{i, instance.element, ray.origin + at[2] * ray.direction};
    }
  }
  return best;
}

}  // namespace

class PictureTest : public QObject {
  Q_OBJECT

 private slots:
  void initTestCase() {
    auto host = EglHost::create();
    QVERIFY2(host.has_value(), host ? "" : host.error().front().message.c_str());
    m_host = std::move(host).value();
    QVERIFY(!m_host->name().empty());
    QCOMPARE(m_host->isSoftware(), m_host->name().find("llvmpipe") != std::string::npos ||
                                       m_host->name().find("softpipe") != std::string::npos);
  }
  void cleanupTestCase() { m_host.reset(); }

  void aLitCubeCoversItsOutlineAndShowsThreeShades() {
    const Scene scene = cubeScene();
    const Frame frame = frameOf(scene, bare());
    m_host->setScene(scene);
    const Image image = m_host->picture(frame);
    QVERIFY(std::abs(coverage(image) - boxCoverage(frame, 10)) < 0.004);
    for (const auto& [face, colour] : kCubeFaces) {
      const auto seen = seenAt(image, frame, face);
      QVERIFY2(apart(seen, colour) < 6,
               qPrintable(QString("%1 %2 %3").arg(seen[0]).arg(seen[1]).arg(seen[2])));
    }
  }

  /// A picture that may be stopped is painted in strips where it is large: they meet without a seam.
  void aLargePictureInStripsIsThatInOnePiece() {
    const Scene scene = groupScene();
    m_host->setScene(scene);
    Frame frame = frameOf(scene, RenderStyle::light());
    frame.viewport = {2400, 1800};
    frame.pixelRatio = 2;
    const std::vector<Highlight> emphasis{Highlight::none, Highlight::selected, Highlight::none};
    frame.emphasis = emphasis;
    const Image whole = m_host->picture(frame);
    std::stop_source source;
    frame.stop = source.get_token();
    const Image strips = m_host->picture(frame);
    QCOMPARE(strips.width, 2400);
    QCOMPARE(strips.rgba.size(), whole.rgba.size());
    std::size_t other = 0;
    for (std::size_t i = 0; i < whole.rgba.size(); ++i) {
      if (std::abs(int(whole.rgba[i]) - int(strips.rgba[i])) > 3) ++other;  // the grain of the ground is 1
    }
    QVERIFY2(other < whole.rgba.size() / 100'000, qPrintable(QString::number(other)));
    source.request_stop();
    QVERIFY(m_host->picture(frame).rgba.empty());
  }

  /// And where the inside of a solid may be seen, it is that by pixel.
  void lightByVertexIsNearlyThatByPixel() {
    Scene scene = groupScene();
    Frame frame = frameOf(scene, bare());
    const auto painted = [&](bool byVertex) {
      m_host->setScene(scene);
      frame.style.litByVertex = byVertex;
      return m_host->picture(frame);
    };
    const Image fine = painted(false), quick = painted(true);
    double apartInAll = 0, most = 0;
    for (std::size_t i = 0; i < fine.rgba.size(); ++i) {
      const double difference = std::abs(int(fine.rgba[i]) - int(quick.rgba[i]));
      apartInAll += difference;
      most = std::max(most, difference);
    }
    QVERIFY(most > 0);
    QVERIFY2(most < 24, qPrintable(QString::number(most)));
    QVERIFY(apartInAll / static_cast<double>(fine.rgba.size()) < 0.5);
    frame.section = CutPlane{};
    QVERIFY(painted(false).rgba == painted(true).rgba);
    frame.section.reset();
    scene.instances.front().isOpen = true;
    QVERIFY(painted(false).rgba == painted(true).rgba);
  }

  void aFlippedNormalIsSeen() {
    Solid cube = boxSolid({-10, -10, -10}, {10, 10, 10});
    for (Float3& normal : cube.normals) {
      for (float& part : normal) part = -part;
    }
    Scene scene;
    add(scene, std::move(cube), {0, 0, 0}, kBlue, "1");
    const Frame frame = frameOf(scene, bare());
    m_host->setScene(scene);
    const Image image = m_host->picture(frame);
    for (const auto& [face, colour] : kCubeFaces) QVERIFY(apart(seenAt(image, frame, face), colour) > 12);
  }

  void aSolidTurnedInsideOutShowsItsBack() {
    Solid cube = boxSolid({-10, -10, -10}, {10, 10, 10});
    for (Triangle& triangle : cube.triangles) std::swap(triangle[1], triangle[2]);
    Scene scene;
    add(scene, std::move(cube), {0, 0, 0}, kBlue, "1");
    const Frame frame = frameOf(scene, bare());
    m_host->setScene(scene);
    const auto hit = m_host->pick(frame, 160, 120);
    QVERIFY(hit.has_value());
    QVERIFY((hit->point - frame.camera.eye()).norm() > frame.camera.distance());
  }

  void aMissingPartIsSeenInTheCoverage() {
    Scene scene = groupScene();
    const Frame frame = frameOf(scene, bare());
    m_host->setScene(scene);
    const double whole = coverage(m_host->picture(frame));
    scene.instances.pop_back();
    m_host->setScene(scene);
    QVERIFY(whole - coverage(m_host->picture(frame)) > 0.02);
  }

  void posesMoveWhatIsSeenAndPicked() {
    const Scene scene = cubeScene();
    Frame frame = frameOf(scene, bare());
    m_host->setScene(scene);
    std::vector<Pose> poses(1, Pose::Identity());
    poses[0].translation() = 1000 * frame.camera.right();
    frame.poses = poses;
    QCOMPARE(coverage(m_host->picture(frame)), 0.0);
    QVERIFY(!m_host->pick(frame, 160, 120));
    poses[0].translation() = 4 * frame.camera.right();
    QVERIFY(m_host->pick(frame, 160, 120).has_value());
    QVERIFY(std::abs(coverage(m_host->picture(frame)) - boxCoverage(frame, 10)) < 0.01);
  }

  void everyPixelPicksWhatARayMeets() {
    const Scene scene = groupScene();
    const Frame frame = frameOf(scene, RenderStyle::light());
    m_host->setScene(scene);
    std::array<int, 4> met{};
    for (int y = 6; y < kView.height; y += 12) {
      for (int x = 6; x < kView.width; x += 12) {
        const auto expected = traced(scene, frame.camera.rayThrough(x + 0.5, y + 0.5, kView));
        bool border = false;  // a pick looks at three by three pixels
        for (const auto& [dx, dy] : {std::pair{-2, 0}, {2, 0}, {0, -2}, {0, 2}}) {
          const auto beside = traced(scene, frame.camera.rayThrough(x + 0.5 + dx, y + 0.5 + dy, kView));
          border = border || beside.has_value() != expected.has_value() ||
                   (expected && beside->instance != expected->instance);
        }
        if (border) continue;
        const auto hit = m_host->pick(frame, x + 0.5, y + 0.5);
        QCOMPARE(hit.has_value(), expected.has_value());
        ++met[hit ? hit->instance : 3];
        if (!hit) continue;
        QCOMPARE(hit->instance, expected->instance);
        QCOMPARE(hit->element, scene.instances[hit->instance].element);
        QVERIFY((hit->point - expected->point).norm() < 0.05);
      }
    }
    for (const int count : met) QVERIFY(count > 3);  // each part and the ground were tried
  }

  void outsideThePictureNothingIsPicked() {
    const Scene scene = cubeScene();
    const Frame frame = frameOf(scene, bare());
    m_host->setScene(scene);
    for (const auto& [x, y] :
         {std::pair{-1.0, 5.0}, {5.0, -0.5}, {320.0, 5.0}, {5.0, 240.0}, {std::nan(""), 1.0}}) {
      QVERIFY(!m_host->pick(frame, x, y));
    }
  }

  void theGroundIsAGradientWithTheTrainsShadowOnIt() {
    const Scene scene = cubeScene();
    RenderStyle style = RenderStyle::light();
    style.triad = false;
    Frame frame = frameOf(scene, style);
    frame.camera = frame.camera.zoomed(0.6, frame.camera.target());
    m_host->setScene(scene);
    const Image withShadow = m_host->picture(frame);
    QVERIFY(apart(withShadow.at(2, 0), {0xEF, 0xF2, 0xF6}) < 3);
    QVERIFY(apart(withShadow.at(2, 239), {0xD3, 0xD9, 0xE1}) < 3);
    frame.style.contactShadow = false;
    const Image without = m_host->picture(frame);
    const Eigen::Vector3d besideTheCube(10.3, 0, -10.3);
    const int darker = seenAt(without, frame, besideTheCube)[1] - seenAt(withShadow, frame, besideTheCube)[1];
    QVERIFY(darker > 8);
  }

  void transparentGroundHasNoColourOfItsOwn() {
    const Scene scene = groupScene();
    RenderStyle style = RenderStyle::light();
    style.transparent = true;
    Frame frame = frameOf(scene, style);
    m_host->setScene(scene);
    const Image image = m_host->picture(frame);
    QCOMPARE(int(image.at(1, 1)[3]), 0);
    QCOMPARE(int(image.at(160, 110)[3]), 255);
  }

  void featureEdgesAreDarkLines() {
    const Scene scene = cubeScene();
    Frame frame = frameOf(scene, bare());
    frame.viewport = {800, 600};  // in a small picture edges fade
    m_host->setScene(scene);
    const Image plain = m_host->picture(frame);
    frame.style.edges = true;
    const Image lined = m_host->picture(frame);
    const ScreenPoint onAnEdge = frame.camera.project({10, -10, 0}, frame.viewport);
    const auto darkest = [&](const Image& image) {
      int blue = 255;
      for (int dx = -1; dx <= 1; ++dx) {
        blue =
            std::min<int>(blue, image.at(static_cast<int>(onAnEdge.x) + dx, static_cast<int>(onAnEdge.y))[2]);
      }
      return blue;
    };
    QVERIFY(darkest(lined) < darkest(plain) - 4);
    QCOMPARE(seenAt(lined, frame, {10, 0, 0}), seenAt(plain, frame, {10, 0, 0}));
  }

  void emphasisIsAHaloRoundTheElementAlone() {
    const Scene scene = groupScene();
    Frame frame = frameOf(scene, bare());
    m_host->setScene(scene);
    const Image plain = m_host->picture(frame);
    const std::vector<Highlight> emphasis = {Highlight::none, Highlight::none, Highlight::selected};
    frame.emphasis = emphasis;
    const Image highlighted = m_host->picture(frame);
    const Eigen::Vector3d onBox(18, -12, 0), onWheel(-10, 0, 8);
    QVERIFY(seenAt(highlighted, frame, onBox) != seenAt(plain, frame, onBox));
    QCOMPARE(seenAt(highlighted, frame, onWheel), seenAt(plain, frame, onWheel));
    QVERIFY(coverage(highlighted) > coverage(plain) + 0.002);
  }

  void antialiasingSoftensTheOutline() {
    const Scene scene = cubeScene();
    Frame frame = frameOf(scene, bare());
    m_host->setScene(scene);
    const auto softPixels = [&] {
      int count = 0;
      const Image image = m_host->picture(frame);
      for (std::size_t i = 3; i < image.rgba.size(); i += 4) count += image.rgba[i] % 255 != 0;
      return count;
    };
    QCOMPARE(softPixels(), 0);
    frame.style.samples = 4;
    QVERIFY(softPixels() > 200);
  }

  void everySizeOfPictureIsGiven() {
    const Scene scene = cubeScene();
    m_host->setScene(scene);
    for (const auto& [width, height] : {std::pair{1, 1}, {7, 500}, {1500, 3}, {1000000, 2}}) {
      Frame frame = frameOf(scene, RenderStyle::dark());
      frame.viewport = {width, height};
      const Image image = m_host->picture(frame);
      QCOMPARE(image.width, std::min(width, m_host->maximumSide()));
      QCOMPARE(image.height, height);
    }
  }

  /// The same place in three details: boxes of three sizes tell which is painted, and which is picked.
  void theDetailIsThatOfTheSizeOnTheScreen() {
    const auto box = [](double half) {
      return std::make_shared<const Solid>(boxSolid({-half, -half, -half}, {half, half, half}));
    };
    Scene scene = cubeScene();
    Frame frame = frameOf(scene, bare());
    const auto finer = [&box](double half) {
      return std::make_shared<const DeferredSolid>([&box, half] { return *box(half); });
    };
    scene.solids = {box(6)};
    DetailLevels levels{1, 0.03, {{0.01, finer(10)}, {0.002, finer(10.5)}}};
    const double pixel = frame.camera.millimetresPerPixel(kView);
    for (const auto& [pixels, half] : {std::pair{2.0, 6.0}, {22.0, 10.0}, {80.0, 10.5}, {2.0, 6.0}}) {
      levels.unit = pixels * pixel;
      scene.levels = {levels};
      m_host->setScene(scene);
      QVERIFY(std::abs(coverage(m_host->picture(frame)) - boxCoverage(frame, half)) < 0.01);
      const auto hit = m_host->pick(frame, 160, 120);
      QVERIFY(hit && std::abs(hit->point.cwiseAbs().maxCoeff() - half) < 0.1);
    }
  }

  void anEmptySceneIsGroundOnly() {
    m_host->setScene(Scene{});
    Frame frame;
    frame.viewport = kView;
    frame.style = bare();
    QCOMPARE(coverage(m_host->picture(frame)), 0.0);
    QVERIFY(!m_host->pick(frame, 10, 10));
  }

  void withoutOpenGlTheReasonIsSaid() {
    const auto renderer = makeGlRenderer([](const char*) -> void* { return nullptr; });
    QVERIFY(!renderer.has_value());
    QCOMPARE(renderer.error().front().code, Code::graphics);
    QVERIFY(renderer.error().front().message.find("glActiveTexture") != std::string::npos);
  }

 private:
  /// Middles of the cube's three visible faces and the colours they have under the light.
  const std::vector<std::pair<Eigen::Vector3d, std::array<int, 3>>> kCubeFaces = {
      {{0, 0, 10}, {81, 159, 202}}, {{10, 0, 0}, {3, 71, 110}}, {{0, -10, 0}, {3, 95, 146}}};
  std::unique_ptr<EglHost> m_host;
};

QTEST_APPLESS_MAIN(PictureTest)
#include "test_picture.moc"

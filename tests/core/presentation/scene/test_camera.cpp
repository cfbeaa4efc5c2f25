#include <QTest>
#include <cmath>
#include <random>

#include "core/presentation/scene/camera.h"
#include "core/presentation/scene/frustum.h"

using namespace geargraph;

namespace {

constexpr Viewport kScreen{640, 400};

bool near(const Eigen::Vector3d& a, const Eigen::Vector3d& b, double tolerance = 1e-9) {
  return (a - b).norm() <= tolerance * (1 + b.norm());
}

bool near(double a, double b, double tolerance = 1e-9) {
  return std::abs(a - b) <= tolerance * (1 + std::abs(b));
}

/// Cameras all over the sphere, and a point before each of them.
template <class Visit>
void eachCamera(Visit visit) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> unit(-1, 1);
  for (int round = 0; round < 200; ++round) {
    const Eigen::Vector3d target(100 * unit(random), 100 * unit(random), 100 * unit(random));
    Camera camera = Camera::from(3.1 * unit(random), 1.5 * unit(random));
    camera = camera.zoomed(std::exp(unit(random)), camera.target() + target);
    const Eigen::Vector3d seen =
        camera.target() +
        60 * (unit(random) * camera.right() + unit(random) * camera.up() + unit(random) * camera.forward());
    visit(camera, seen, 100 * unit(random), 100 * unit(random));
  }
}

}  // namespace

class CameraTest : public QObject {
  Q_OBJECT

 private slots:
  void directionsAreARightHandedFrame() {
    eachCamera([](const Camera& camera, const Eigen::Vector3d&, double, double) {
      QVERIFY(near(camera.right().cross(camera.up()), -camera.forward()));
      QVERIFY(near(camera.right().norm(), 1));
      QVERIFY(near(camera.right().dot(camera.forward()), 0));
      QVERIFY(near(camera.eye() + camera.distance() * camera.forward(), camera.target()));
      QVERIFY(near(camera.view() * camera.eye(), Eigen::Vector3d::Zero(), 1e-6));
    });
  }

  void orbitKeepsTargetDistanceAndHorizon() {
    eachCamera([](const Camera& camera, const Eigen::Vector3d&, double dx, double dy) {
      const Camera turned = camera.orbited(dx, dy);
      QCOMPARE(turned.target(), camera.target());
      QCOMPARE(turned.distance(), camera.distance());
      QVERIFY(near(turned.right().z(), 0));
      QVERIFY(std::abs(turned.pitch()) <= 1.5707963267948967);
    });
  }

  void orbitThereAndBackIsNoTurn() {
    eachCamera([](const Camera& camera, const Eigen::Vector3d&, double dx, double) {
      const Camera back = camera.orbited(dx, 5).orbited(-dx, -5);
      if (std::abs(camera.pitch()) < 1.5) QVERIFY(near(back.forward(), camera.forward()));
    });
  }

  void draggingRightBringsTheLeftSideForward() {
    const Camera camera = Camera::looking(StandardView::front);
    const Eigen::Vector3d nearest = camera.target() - 10 * camera.forward();
    const Camera turned = camera.orbited(20, 0);
    QVERIFY(turned.project(nearest, kScreen).x > camera.project(nearest, kScreen).x);
  }

  void panMovesWhatIsAtTheTargetsDepthWithThePointer() {
    eachCamera([](const Camera& camera, const Eigen::Vector3d&, double dx, double dy) {
      const Eigen::Vector3d held = camera.atTargetDepth(200, 150, kScreen);
      const ScreenPoint after = camera.panned(dx, dy, kScreen).project(held, kScreen);
      QVERIFY(near(after.x, 200 + dx));
      QVERIFY(near(after.y, 150 + dy));
    });
  }

  void zoomKeepsThePointUnderTheCursor() {
    eachCamera([](const Camera& camera, const Eigen::Vector3d& point, double dx, double) {
      const Camera nearer = camera.zoomed(std::exp(dx / 50), point);
      const ScreenPoint before = camera.project(point, kScreen);
      const ScreenPoint after = nearer.project(point, kScreen);
      QVERIFY(near(after.x, before.x, 1e-6));
      QVERIFY(near(after.y, before.y, 1e-6));
      QVERIFY(near(after.depth, before.depth / std::exp(dx / 50), 1e-6));
    });
  }

  void rayAndProjectionAreInverse() {
    eachCamera([](const Camera& camera, const Eigen::Vector3d& point, double, double) {
      const ScreenPoint place = camera.project(point, kScreen);
      const Ray ray = camera.rayThrough(place.x, place.y, kScreen);
      const Eigen::Vector3d along = (point - ray.origin).normalized();
      if (place.depth > 0) QVERIFY(near(along, ray.direction));
    });
  }

  void clipSpaceAgreesWithTheProjectedPixel() {
    eachCamera([](const Camera& camera, const Eigen::Vector3d& point, double, double) {
      const ScreenPoint place = camera.project(point, kScreen);
      if (place.depth <= 0) return;
      const Eigen::Matrix4d clip = camera.projection(kScreen, point, 50) * camera.view().matrix();
      const Eigen::Vector3d device = Eigen::Vector4d(clip * point.homogeneous()).hnormalized();
      QVERIFY(near((device.x() + 1) * 320, place.x, 1e-6));
      QVERIFY(near((1 - device.y()) * 200, place.y, 1e-6));
      QVERIFY(std::abs(device.z()) <= 1);
    });
  }

  void theFrustumKeepsWhatIsInThePictureAndDropsWhatIsFarBesideIt() {
    eachCamera([](const Camera& camera, const Eigen::Vector3d& point, double, double) {
      const ScreenPoint place = camera.project(point, kScreen);
      const Frustum frustum(camera.projection(kScreen, camera.target(), 500) * camera.view().matrix());
      const bool inside = place.depth > 0 && place.x > 0 && place.x < kScreen.width && place.y > 0 &&
                          place.y < kScreen.height;
      if (inside) QVERIFY(frustum.mayShow(point, 1e-6));
      const Eigen::Vector3d beside = camera.atTargetDepth(-5, 200, kScreen);
      const double pixel = camera.millimetresPerPixel(kScreen);
      QVERIFY(!frustum.mayShow(beside, 4 * pixel));
      QVERIFY(frustum.mayShow(beside, 6 * pixel));
    });
  }

  void fitShowsEverythingAndTouchesTheMargin() {
    std::mt19937 random(11);
    std::uniform_real_distribution<double> unit(-1, 1);
    eachCamera([&](const Camera& camera, const Eigen::Vector3d&, double, double) {
      std::vector<Eigen::Vector3d> points;
      for (int i = 0; i < 12; ++i)
        points.emplace_back(90 * unit(random), 30 * unit(random), 50 * unit(random));
      const Camera fitted = camera.fitted(points, kScreen, 0.1);
      QCOMPARE(fitted.yaw(), camera.yaw());
      double left = 1, right = 0, top = 1, bottom = 0;
      for (const Eigen::Vector3d& point : points) {
        const ScreenPoint place = fitted.project(point, kScreen);
        QVERIFY(place.depth > 0);
        left = std::min(left, place.x / kScreen.width);
        right = std::max(right, place.x / kScreen.width);
        top = std::min(top, place.y / kScreen.height);
        bottom = std::max(bottom, place.y / kScreen.height);
      }
      QVERIFY(left >= 0.1 - 1e-9 && right <= 0.9 + 1e-9 && top >= 0.1 - 1e-9 && bottom <= 0.9 + 1e-9);
      const bool touchesSides = near(left, 0.1) && near(right, 0.9);
      const bool touchesTopAndBottom = near(top, 0.1) && near(bottom, 0.9);
      QVERIFY(touchesSides || touchesTopAndBottom);
    });
  }

  void standardViewsLookAlongTheAxes() {
    const auto looks = [](StandardView view, const Eigen::Vector3d& right, const Eigen::Vector3d& up) {
      const Camera camera = Camera::looking(view);
      return near(camera.right(), right) && near(camera.up(), up);
    };
    QVERIFY(looks(StandardView::front, {1, 0, 0}, {0, 0, 1}));
    QVERIFY(looks(StandardView::back, {-1, 0, 0}, {0, 0, 1}));
    QVERIFY(looks(StandardView::right, {0, 1, 0}, {0, 0, 1}));
    QVERIFY(looks(StandardView::left, {0, -1, 0}, {0, 0, 1}));
    QVERIFY(looks(StandardView::top, {1, 0, 0}, {0, 1, 0}));
    QVERIFY(looks(StandardView::bottom, {1, 0, 0}, {0, -1, 0}));
    const Eigen::Matrix3d isometric = Camera::looking(StandardView::isometric).view().linear();
    for (int axis = 0; axis < 3; ++axis)
      QVERIFY(near(isometric.col(axis).head<2>().norm(), std::sqrt(2.0 / 3)));
  }
};

QTEST_APPLESS_MAIN(CameraTest)
#include "test_camera.moc"

#include <Eigen/Geometry>
#include <QTest>
#include <numbers>
#include <random>

#include "core/machine/train/bevel_collision.h"

using namespace geargraph;
using Eigen::Vector3d;

namespace {

TrainWheel bevel(int teeth, double module, double coneAngle, double face) {
  TrainWheel wheel;
  wheel.spec = standardGear(GearKind::bevel, teeth, module, face);
  wheel.spec.coneAngle = coneAngle;
  wheel.workingRadius = teeth * module / 2;
  wheel.axis = Vector3d::UnitZ();
  wheel.origin = Vector3d::Zero();
  return wheel;
}

TrainWheel moved(TrainWheel wheel, const Eigen::Isometry3d& by) {
  wheel.origin = by * wheel.origin;
  wheel.axis = by.linear() * wheel.axis;
  return wheel;
}

Eigen::Isometry3d turned(double angle, const Vector3d& about) {
  return Eigen::Isometry3d(Eigen::AngleAxisd(angle, about.normalized()));
}

}  // namespace

class BevelCollisionTest : public QObject {
  Q_OBJECT
 private slots:
  /// Points of the large wheel are farther from each other than the small one is wide.
  void aSmallWheelIsFoundInTheTeethOfALargeOneWhereverItIs() {
    const TrainWheel large = bevel(40, 400, 0.8, 1500);
    for (int i = 0; i < 360; ++i) {
      TrainWheel small = bevel(20, 2, 0.5, 8);
      const double height = large.workingRadius / std::tan(0.8) - 300;  // within the teeth
      small.axis = Vector3d::UnitX();
      small.origin = Vector3d(height * std::tan(0.8), 0, height);
      const TrainWheel there = moved(small, turned(i * std::numbers::pi / 180, Vector3d::UnitZ()));
      QVERIFY2(bevelsCross(large, there) && bevelsCross(there, large), qPrintable(QString::number(i)));
      QVERIFY(!bevelsCross(large, moved(there, Eigen::Isometry3d(Eigen::Translation3d(0, 0, 4000)))));
    }
  }

  void whetherWheelsCrossDoesNotDependOnWhereTheyAreTurnedTo() {
    std::mt19937_64 random(11);
    const auto number = [&](double from, double to) {
      return std::uniform_real_distribution(from, to)(random);
    };
    const auto direction = [&] { return Vector3d(number(-1, 1), number(-1, 1), number(-1, 1)); };
    int crossing = 0;
    for (int i = 0; i < 400; ++i) {
      const double module = std::pow(10, number(-1, 2.5));
      const int teeth = 12 + static_cast<int>(random() % 40);
      const TrainWheel one = bevel(30, 4, number(0.3, 1.4), 20);
      TrainWheel other = bevel(teeth, module, number(0.3, 1.4), teeth * module / 8);
      other.axis = direction().normalized();
      other.origin = (60 + teeth * module / 2) * direction();
      const bool expected = bevelsCross(one, other);
      crossing += expected ? 1 : 0;
      for (int k = 0; k < 5; ++k) {
        const Eigen::Isometry3d by = turned(number(0, 6), direction());
        QCOMPARE(bevelsCross(moved(one, by), moved(other, by)), expected);
        QCOMPARE(bevelsCross(moved(other, by), moved(one, by)), expected);
      }
    }
    QVERIFY2(crossing > 20 && crossing < 380, qPrintable(QString::number(crossing)));
  }
};

QTEST_APPLESS_MAIN(BevelCollisionTest)
#include "test_bevel_collision.moc"

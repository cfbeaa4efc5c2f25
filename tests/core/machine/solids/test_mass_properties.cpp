#include <QTest>
#include <numbers>
#include <random>

#include "core/machine/solids/gear_solid.h"
#include "core/machine/solids/mass_properties.h"
#include "core/machine/solids/part_solids.h"

namespace geargraph {
namespace {

/// A cuboid with a corner at the origin.
Solid cuboid(float x, float y, float z) {
  Solid solid;
  for (int corner = 0; corner < 8; ++corner) {
    solid.positions.push_back(
        {(corner & 1) != 0 ? x : 0, (corner & 2) != 0 ? y : 0, (corner & 4) != 0 ? z : 0});
  }
  solid.triangles = {{0, 2, 1}, {1, 2, 3}, {4, 5, 6}, {5, 7, 6}, {0, 1, 4}, {1, 5, 4},
                     {2, 6, 3}, {3, 6, 7}, {0, 4, 2}, {2, 4, 6}, {1, 3, 5}, {3, 7, 5}};
  return solid;
}

bool isNear(const Eigen::MatrixXd& a, const Eigen::MatrixXd& b, double relative) {
  return (a - b).norm() <= relative * b.norm();
}

Eigen::Isometry3d somewhere() {
  Eigen::Isometry3d placed = Eigen::Isometry3d::Identity();
  placed.rotate(Eigen::AngleAxisd(0.7, Eigen::Vector3d(1, 2, -2).normalized()));
  placed.pretranslate(Eigen::Vector3d(10, -4, 3));
  return placed;
}

}  // namespace

class MassPropertiesTest : public QObject {
  Q_OBJECT

 private slots:
  void aCuboidHasItsFormulas() {
    const MassProperties body = massProperties(cuboid(2, 3, 5), 7);
    QVERIFY(std::abs(body.mass - 7 * 30) < 1e-9);
    QVERIFY(isNear(body.center, Eigen::Vector3d(1, 1.5, 2.5), 1e-12));
    const Eigen::Vector3d moments(3 * 3 + 5 * 5, 2 * 2 + 5 * 5, 2 * 2 + 3 * 3);
    QVERIFY(isNear(body.inertia, Eigen::Matrix3d((body.mass / 12 * moments).asDiagonal()), 1e-12));
  }

  void aRingHasItsFormulas() {
    const double outer = 6;
    const double inner = 4;
    const double width = 3;
    const MassProperties body = massProperties(tube(outer, inner, 0, width, 1e-4), 2);
    const double mass = 2 * std::numbers::pi * (outer * outer - inner * inner) * width;
    QVERIFY(std::abs(body.mass / mass - 1) < 0.02);  // its edges have chamfers
    QVERIFY(std::abs(body.inertia(2, 2) / (body.mass * (outer * outer + inner * inner) / 2) - 1) < 0.01);
  }

  void aGearLiesBetweenItsRootAndTipCylinders() {
    GearSpec spec;
    spec.teeth = 30;
    spec.module = 2;
    spec.faceWidth = 10;
    const auto solid = gearSolid(spec, kScreenTolerance);
    QVERIFY(solid.has_value());
    const MassProperties body = massProperties(*solid, 1);
    QVERIFY(std::abs(body.mass - signedVolume(*solid)) < 1e-9 * body.mass);
    const auto disc = [&](double radius) {
      return std::numbers::pi * std::pow(radius, 4) * spec.faceWidth / 2;
    };
    QVERIFY(body.inertia(2, 2) > disc(30 - 2.5));
    QVERIFY(body.inertia(2, 2) < disc(30 + 2));
    QVERIFY(std::abs(body.inertia(0, 1)) < 1e-6 * body.inertia(2, 2));  // 30-fold symmetry
    QVERIFY(std::abs(body.inertia(0, 0) / body.inertia(1, 1) - 1) < 1e-6);
  }

  void aMovedSolidHasTheMovedProperties() {
    const Solid solid = cuboid(2, 3, 5);
    const MassProperties there = massProperties(moved(solid, somewhere()), 1);
    const MassProperties expected = moved(massProperties(solid, 1), somewhere());
    QVERIFY(std::abs(there.mass - expected.mass) < 1e-4);  // positions of a solid are floats
    QVERIFY(isNear(there.center, expected.center, 1e-6));
    QVERIFY(isNear(there.inertia, expected.inertia, 1e-5));
  }

  void twoHalvesAreTheWhole() {
    Eigen::Isometry3d besides = Eigen::Isometry3d::Identity();
    besides.translation() = Eigen::Vector3d(1, 0, 0);
    const MassProperties half = massProperties(cuboid(1, 3, 5), 1);
    const MassProperties whole = joined(half, moved(half, besides));
    const MassProperties expected = massProperties(cuboid(2, 3, 5), 1);
    QVERIFY(isNear(whole.center, expected.center, 1e-12));
    QVERIFY(isNear(whole.inertia, expected.inertia, 1e-12));
  }

  void aFarSolidKeepsItsDigits() {
    Eigen::Isometry3d far = Eigen::Isometry3d::Identity();
    far.translation() = Eigen::Vector3d(65536, 0, 0);  // floats still have 1/128 there
    const MassProperties body = massProperties(moved(cuboid(2, 3, 5), far), 1);
    QVERIFY(std::abs(body.mass - 30) < 1e-9);
    QVERIFY(isNear(body.inertia, massProperties(cuboid(2, 3, 5), 1).inertia, 1e-9));
  }

  void anotherUnitOfLengthKeepsTheMass() {
    const MassProperties body = rescaled(massProperties(cuboid(2, 3, 5), 1), 0.001);
    QCOMPARE(body.mass, 30.0);
    QVERIFY(isNear(body.center, Eigen::Vector3d(0.001, 0.0015, 0.0025), 1e-12));
    QVERIFY(std::abs(body.inertia(2, 2) - 30 * 13 / 12. * 1e-6) < 1e-15);
  }

  void anEmptySolidHasNoMass() { QCOMPARE(massProperties(Solid{}, 1).mass, 0.0); }
};

}  // namespace geargraph

QTEST_APPLESS_MAIN(geargraph::MassPropertiesTest)
#include "test_mass_properties.moc"

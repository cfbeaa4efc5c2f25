#include <QTest>
#include <cmath>
#include <numbers>

#include "core/machine/solids/part_solids.h"
#include "tests/core/machine/solids/topology.h"

using namespace geargraph;
using std::numbers::pi;

namespace {

void compareShell(const Solid& solid, int genus) {
  const test::Topology topology = test::topologyOf(solid);
  QVERIFY(topology.closed);
  QVERIFY(topology.manifold);
  QCOMPARE(topology.degenerate, 0);
  QCOMPARE(topology.pieces, 1);
  QCOMPARE(topology.genus, genus);
  QVERIFY(test::worstNormalDegrees(solid, 1e-4) < 20);
}

}  // namespace

class PartSolidsTest : public QObject {
  Q_OBJECT
 private slots:
  void shaftsAndTubesAreClosed() {
    compareShell(tube(3, 0, -5, 12, 0.01), 0);
    compareShell(tube(4, 2.5, 0, 3, 0.01), 1);
  }

  void barsOfCagesAreClosed() {
    const Solid bar = tubeSector(10, 9, -2, 5, 0.3, 0.01);
    compareShell(bar, 0);
    QVERIFY(std::abs(signedVolume(bar) / (0.3 * (100 - 81) * 7) - 1) < 0.01);
  }

  /// Hull of two equal discs and of a square of discs, one of them inside.
  void platesAreClosedAndHaveTheirVolume() {
    const Boss near{{0, 0}, 3, 0}, far{{20, 0}, 3, 0};
    const Solid bar = plate(std::vector{near, far}, -1, 2, 1e-3);
    compareShell(bar, 0);
    QVERIFY(std::abs(signedVolume(bar) / (3 * (9 * pi + 120)) - 1) < 0.01);
    const Solid square = plate(
        std::vector<Boss>{{{0, 0}, 2, 0}, {{10, 0}, 2, 0}, {{0, 10}, 2, 0}, {{5, 5}, 1, 0}, {{10, 10}, 2, 0}},
        0, 1, 1e-3);
    compareShell(square, 0);
    QVERIFY(std::abs(signedVolume(square) / (100 + 4 * 20 + 4 * pi) - 1) < 0.01);
    compareShell(plate(std::vector{near}, 0, 1, 0.01), 0);
  }

  void tubesHaveTheirVolume() {
    const double plain = pi * (16 - 6.25) * 30;
    QVERIFY(std::abs(signedVolume(tube(4, 2.5, 0, 30, 1e-4)) / plain - 1) < 0.01);  // but for the chamfers
  }

  void armsAreClosedWithAndWithoutHoles_data() {
    QTest::addColumn<double>("holeA");
    QTest::addColumn<double>("holeB");
    QTest::addColumn<int>("genus");
    QTest::newRow("two holes") << 2.0 << 1.0 << 2;
    QTest::newRow("one hole") << 0.0 << 1.0 << 1;
    QTest::newRow("no hole") << 0.0 << 0.0 << 0;
  }
  void armsAreClosedWithAndWithoutHoles() {
    QFETCH(double, holeA);
    QFETCH(double, holeB);
    QFETCH(int, genus);
    for (const double distance : {6.0, 25.0}) {
      for (const double angle : {0.0, 1.0, 2.5, -2.0}) {
        const Eigen::Vector2d end(distance * std::cos(angle), distance * std::sin(angle));
        const Solid part = arm({{0, 0}, 3, holeA}, {end, 2, holeB}, -1, 2, 0.01);
        compareShell(part, genus);
        // Hull of two circles: two sectors and the trapezium between the tangents.
        const double tangent = std::acos(1 / distance);
        const double hull = 9 * (pi - tangent) + 4 * tangent + 5 * std::sqrt(distance * distance - 1);
        const double area = hull - pi * (holeA * holeA + holeB * holeB);
        QVERIFY(std::abs(signedVolume(part) / (3 * area) - 1) < 0.01);
      }
    }
  }

  /// A hub with several bars in one piece, as wide as they find room; area by hand for three of them.
  void spidersAreOneClosedPiece() {
    for (const int n : {2, 3, 4, 5, 6}) {
      for (const double turn : {0.0, 0.4}) {
        std::vector<Boss> ends;
        for (int i = 0; i < n; ++i) {
          const double angle = turn + 2 * pi * i / n;
          ends.push_back({25 * Eigen::Vector2d(std::cos(angle), std::sin(angle)), 2, 1});
        }
        compareShell(spider({{0, 0}, 4, 2}, ends, -1, 2, 0.01), n + 1);
      }
    }
    const Boss end{{20, 0}, 1, 0};
    const Boss other{{-20, 0}, 1, 0};
    const Solid bar = spider({{0, 0}, 3, 0}, std::vector{end, other}, 0, 1, 1e-4);
    const double cap = 9 * std::asin(1.0 / 3) - std::sqrt(8.0);  // of the hub, inside a bar
    const double area = 9 * pi - 2 * cap + 2 * (2 * (20 - std::sqrt(8.0)) + pi / 2);
    QVERIFY2(std::abs(signedVolume(bar) / area - 1) < 1e-3,
             qPrintable(QString::number(signedVolume(bar) / area)));
  }

  /// Arms with no room for bars side by side still have no vertex in common.
  void crowdedSpidersAreClosedPieces() {
    const Solid part = spider(
        {{0, 0}, 4, 2}, std::vector<Boss>{{{20, 0}, 2, 1}, {{19, 3}, 2, 1}, {{5, 0}, 3, 1}}, 0, 3, 0.01);
    const test::Topology topology = test::topologyOf(part);
    QVERIFY(topology.closed && topology.manifold);
    QCOMPARE(topology.degenerate, 0);
    QCOMPARE(topology.pieces, 3);
  }

  /// Bosses in the hub, around it, and touching it from within.
  void bossesWithoutRoomForAnArmAreLeftOut() {
    const Boss hub{{0, 0}, 4, 2};
    const std::vector<Boss> without{
        {{0, 0}, 1, 0}, {{2, 0}, 2, 1}, {{0, 1}, 5, 1}, {{0, 0}, 4, 2}, {{1, 0}, 4.95, 0}};
    const Solid disc = tube(4, 2, 0, 3, 0.01);
    QCOMPARE(spider(hub, without, 0, 3, 0.01), disc);
    for (const Boss& one : without) QCOMPARE(spider(hub, std::vector{one}, 0, 3, 0.01), disc);
    std::vector<Boss> all = without;
    all.push_back({{19, 0}, 2, 1});
    QCOMPARE(spider(hub, all, 0, 3, 0.01), arm(hub, all.back(), 0, 3, 0.01));
    all.push_back({{18, 3}, 2, 1});  // too close to the other for a bar
    QCOMPARE(test::topologyOf(spider(hub, all, 0, 3, 0.01)).pieces, 2);
  }

  void framesAreRightHandedWithZAlongTheAxis() {
    for (const Eigen::Vector3d& axis : {Eigen::Vector3d(1, 0, 0), Eigen::Vector3d(0, 0, -1),
                                        Eigen::Vector3d(1, 2, 3).normalized().eval()}) {
      const Eigen::Isometry3d frame = frameAlong({1, 2, 3}, axis);
      QVERIFY((frame.linear().col(2) - axis).norm() < 1e-12);
      QVERIFY(std::abs(frame.linear().determinant() - 1) < 1e-12);
      QVERIFY((frame.linear() * frame.linear().transpose() - Eigen::Matrix3d::Identity()).norm() < 1e-12);
    }
  }
};

QTEST_APPLESS_MAIN(PartSolidsTest)
#include "test_part_solids.moc"

#include <QtTest>
#include <numbers>

#include "core/placement/disc_hull.h"

using namespace geargraph;

namespace {

const Vector3 kX{1, 0, 0}, kY{0, 1, 0}, kZ{0, 0, 1};

DiscHull cylinder(const Vector3& from, const Vector3& axis, double length, double radius) {
  return {{from, axis, radius}, {from + length * axis, axis, radius}};
}

}  // namespace

class TestDiscHull : public QObject {
  Q_OBJECT
 private slots:
  /// A long cylinder along z at the origin, and one along x at a height: their distance is known.
  void crossedCylindersAreNearFromTheSumOfTheirRadii() {
    const DiscHull upright = cylinder({0, 0, -100}, kZ, 200, 3);
    const auto across = [](double y) { return cylinder({-70, y, 5}, kX, 140, 2); };
    QVERIFY(areNear(upright, across(4.9)));
    QVERIFY(!areNear(upright, across(5.1)));
    QVERIFY(areNear(upright, across(-5.1), 0.2));
    QVERIFY(!areNear(upright, across(5.3), 0.2));
  }

  void anEndThatStopsShortIsClear() {
    const DiscHull upright = cylinder({0, 0, -100}, kZ, 200, 3);
    QVERIFY(!areNear(upright, cylinder({3.1, 0, 0}, kX, 140, 2)));
    QVERIFY(areNear(upright, cylinder({2.9, 0, 0}, kX, 140, 2)));
  }

  /// The frustum reaches 4 wide at z = 10 and 1 at z = 0.
  void aFrustumIsAsWideAsItIsThere() {
    const DiscHull frustum{{{0, 0, 0}, kZ, 1}, {{0, 0, 10}, kZ, 4}};
    const auto ball = [](const Vector3& at) { return DiscHull{{at, kZ, 0}}; };
    QVERIFY(areNear(frustum, ball({2.4, 0, 5})));
    QVERIFY(!areNear(frustum, ball({2.6, 0, 5})));
    QVERIFY(areNear(frustum, ball({0, 0, 9})));  // deep within
    QVERIFY(!areNear(frustum, ball({0, 0, 10.1})));
  }

  void aTurnedHullIsWhereTheTurnTakesIt() {
    const DiscHull hull = turned(cylinder({10, 0, 0}, kX, 5, 1), {10, 0, 0}, kZ, std::numbers::pi / 2);
    QVERIFY(length(hull[1].centre - Vector3{10, 5, 0}) < 1e-12);
    QVERIFY(length(hull[1].axis - kY) < 1e-12);
  }
};

QTEST_APPLESS_MAIN(TestDiscHull)
#include "test_disc_hull.moc"

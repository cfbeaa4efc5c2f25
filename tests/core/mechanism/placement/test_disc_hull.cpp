#include <QTest>
#include <cmath>
#include <numbers>
#include <random>

#include "core/mechanism/placement/disc_hull.h"

using namespace geargraph;

namespace {

const Vector3 kX{1, 0, 0}, kY{0, 1, 0}, kZ{0, 0, 1};

DiscHull cylinder(const Vector3& from, const Vector3& axis, double length, double radius) {
  return {{from, axis, radius}, {from + length * axis, axis, radius}};
}

}  // namespace

class DiscHullTest : public QObject {
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

  /// Large discs beside small ones, on one axis and beside each other, at known distances: flat simplices,
  /// in which rounding would find anything.
  void smallHullsBesideLargeOnesAreNearOnlyWhereTheyAreWhereverTurnedTo() {
    std::mt19937_64 random(5);
    const auto number = [&](double from, double to) {
      return std::uniform_real_distribution(from, to)(random);
    };
    for (int i = 0; i < 500; ++i) {
      const double large = std::pow(10, number(0, 4)), thick = large * number(0.1, 1);
      const DiscHull plate = cylinder({0, 0, 0}, kZ, thick, large);
      const double inside = i % 2 == 0 ? 0 : number(0, large);  // on the plate's axis, or beside it
      const double gap = large * std::pow(10, number(-5, 1));
      const DiscHull above{{{inside, 0, thick + gap}, kZ, 2},
                           {{inside, 0, thick + gap + 3}, kZ, number(0, 2)}};
      const DiscHull within{{{inside, 0, thick - gap}, kZ, 2}, {{inside, 0, thick + 3}, kZ, 1}};
      const DiscHull touching{{{inside, 0, thick}, kZ, 2}, {{inside, 0, thick + 3}, kZ, 1}};
      for (int k = 0; k < 20; ++k) {
        const Vector3 some{number(-1, 1), number(-1, 1), number(-1, 1)};
        const Vector3 axis = (1 / length(some)) * some;
        const Vector3 point{number(-large, large), number(-large, large), number(-large, large)};
        const double angle = k == 0 ? 0 : number(-3, 3);
        const auto turn = [&](const DiscHull& hull) { return turned(hull, point, axis, angle); };
        QVERIFY2(!areNear(turn(plate), turn(above)), qPrintable(QString("%1 %2").arg(i).arg(k)));
        QVERIFY2(areNear(turn(within), turn(plate)), qPrintable(QString("%1 %2").arg(i).arg(k)));
        QVERIFY2(areNear(turn(plate), turn(touching)), qPrintable(QString("%1 %2").arg(i).arg(k)));
      }
    }
  }

  void aTurnedHullIsWhereTheTurnTakesIt() {
    const DiscHull hull = turned(cylinder({10, 0, 0}, kX, 5, 1), {10, 0, 0}, kZ, std::numbers::pi / 2);
    QVERIFY(length(hull[1].centre - Vector3{10, 5, 0}) < 1e-12);
    QVERIFY(length(hull[1].axis - kY) < 1e-12);
  }
};

QTEST_APPLESS_MAIN(DiscHullTest)
#include "test_disc_hull.moc"

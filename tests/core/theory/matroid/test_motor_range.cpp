#include <QTest>
#include <algorithm>
#include <random>

#include "core/theory/matroid/joint_coupling.h"
#include "core/theory/matroid/motor_range.h"
#include "tests/core/support/example_files.h"
#include "tests/core/support/matroid_fixture.h"

using namespace geargraph;
using namespace geargraph::test;

namespace {

struct RangeCase {
  explicit RangeCase(Mechanism mechanism) : worked(std::move(mechanism)) {}
  Worked worked;
  ExactSolution exact = *solveExact(worked.model, worked.analysis.choice.joints, worked.analysis.speeds);

  [[nodiscard]] MotorRange rangeOf(std::size_t x, std::size_t y) const {
    return *motorRange(worked.mechanism, exact, JointOrdinal(exact.inputs[x]), JointOrdinal(exact.inputs[y]));
  }
};

void limit(Mechanism& mechanism, int joint, std::optional<Number> low, std::optional<Number> high) {
  mechanism.turningJoints[JointOrdinal(joint)].limits = {std::move(low), std::move(high)};
}

Mechanism withoutLimits(const std::string& name) {
  Mechanism mechanism = example(name);
  for (TurningJoint& joint : mechanism.turningJoints) joint.limits = {};
  return mechanism;
}

/// On the left of all sides, by cross products: no step of the calculation.
bool isInPolygon(const MotorRange& range, const Rational& x, const Rational& y) {
  for (std::size_t i = 0; i < range.corners.size(); ++i) {
    const MotorCorner& a = range.corners[i];
    const MotorCorner& b = range.corners[(i + 1) % range.corners.size()];
    if (((b.x - a.x) * (y - a.y) - (b.y - a.y) * (x - a.x)).sign() < 0) return false;
  }
  return true;
}

}  // namespace

class MotorRangeTest : public QObject {
  Q_OBJECT

 private slots:
  /// The differential drive of a wrist: joint = (x + y)/2 and (x - y)/2 bound a square on its corner.
  void limitsOfADifferentialAreASlantedSquare() {
    Mechanism wrist = withoutLimits("bevel-wrist");
    // Joint 9 turns by 2/3 (motor 8 - motor 7), motor 7 by itself.
    limit(wrist, 2, Number(-100), Number(50));
    limit(wrist, 0, Number(-90), Number(90));
    const MotorRange range = RangeCase(wrist).rangeOf(0, 1);
    QVERIFY(range.isClosed());
    QCOMPARE(range.corners.size(), std::size_t{4});
    std::vector<std::pair<Rational, Rational>> found;
    for (const MotorCorner& corner : range.corners) found.emplace_back(corner.x, corner.y);
    for (const auto& [x, y] :
         std::vector<std::pair<Rational, Rational>>{{-90, -240}, {90, -60}, {90, 165}, {-90, -15}}) {
      QVERIFY2(std::find(found.begin(), found.end(), std::pair(x, y)) != found.end(),
               qPrintable(QString::fromStdString(x.toString() + ", " + y.toString())));
    }
  }

  void aPointIsInThePolygonJustWhenAllJointsAreWithinTheirLimits() {
    std::mt19937 random(7);
    int inside = 0, outside = 0, closed = 0;
    for (const char* name : {"robot", "bevel-wrist", "three-roll-wrist", "bevel-differential"}) {
      for (int round = 0; round < 12; ++round) {
        Mechanism mechanism = withoutLimits(name);
        for (int joint = 0; joint < mechanism.t(); ++joint) {
          if (random() % 3 == 0) continue;
          const auto end = [&](int sign) -> std::optional<Number> {
            if (random() % 4 == 0) return std::nullopt;
            return Number(
                Rational(sign * static_cast<int>(random() % 200), 1 + static_cast<int>(random() % 3)));
          };
          limit(mechanism, joint, end(-1), end(1));
        }
        const RangeCase with(mechanism);
        const MotorRange range = with.rangeOf(0, 1);
        closed += range.isClosed() ? 1 : 0;
        if (range.corners.size() < 3) continue;  // a line or a point: below
        Rational reach;
        for (const MotorCorner& corner : range.corners)
          reach = std::max({reach, corner.x.abs(), corner.y.abs()});
        for (int sample = 0; sample < 200; ++sample) {
          const auto at = [&] { return reach * Rational(static_cast<int>(random() % 201) - 100, 100); };
          const Rational x = at(), y = at();
          bool isAllowed = true;
          for (const JointOrdinal joint : mechanism.turningJoints.ordinals()) {
            const std::vector<Rational> gains = gainsOf(with.exact, joint);
            const Rational angle = gains[0] * x + gains[1] * y;
            const JointLimits& own = mechanism.turningJoints[joint].limits;
            if (own.low && angle < own.low->exact()) isAllowed = false;
            if (own.high && angle > own.high->exact()) isAllowed = false;
          }
          QCOMPARE(isInPolygon(range, x, y), isAllowed);
          (isAllowed ? inside : outside) += 1;
        }
      }
    }
    QVERIFY(inside > 500);
    QVERIFY(outside > 500);
    QVERIFY(closed > 3);
  }

  void everySideIsOnTheLimitThatItNames() {
    Mechanism robot = withoutLimits("robot");
    for (int joint = 0; joint < robot.t(); ++joint)
      limit(robot, joint, Number(-60), Number(Rational(100, 3)));
    const MotorRange range = RangeCase(robot).rangeOf(0, 2);
    QVERIFY(range.isClosed());
    for (std::size_t i = 0; i < range.corners.size(); ++i) {
      const MotorCorner& a = range.corners[i];
      const MotorCorner& b = range.corners[(i + 1) % range.corners.size()];
      const MotorLimit& side = range.limits[*a.side];
      for (const MotorCorner& end : {a, b})
        QCOMPARE(side.gains[0] * end.x + side.gains[1] * end.y, side.bound);
    }
  }

  void withoutLimitsTheRangeIsOpen() {
    const MotorRange range = RangeCase(withoutLimits("bevel-wrist")).rangeOf(0, 1);
    QVERIFY(range.limits.empty());
    QVERIFY(!range.isClosed());
    QCOMPARE(range.corners.size(), std::size_t{4});
    QCOMPARE(range.corners[2].x, Rational(270));
  }

  void motorsThatMayNotTurnLeaveALineOrAPoint() {
    Mechanism wrist = withoutLimits("bevel-wrist");
    limit(wrist, 0, Number(0), Number(0));
    limit(wrist, 1, Number(-30), Number(40));
    const MotorRange line = RangeCase(wrist).rangeOf(0, 1);
    QCOMPARE(line.corners.size(), std::size_t{2});
    for (const MotorCorner& corner : line.corners) QVERIFY(corner.x.isZero());
    QCOMPARE((line.corners[0].y - line.corners[1].y).abs(), Rational(70));
    limit(wrist, 1, Number(0), Number(0));
    const MotorRange point = RangeCase(wrist).rangeOf(0, 1);
    QCOMPARE(point.corners.size(), std::size_t{1});
    QVERIFY(point.corners[0].x.isZero() && point.corners[0].y.isZero());
  }
};

QTEST_APPLESS_MAIN(MotorRangeTest)
#include "test_motor_range.moc"

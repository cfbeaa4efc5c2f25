#include <QTest>
#include <cmath>
#include <numbers>

#include "core/mechanism/model/edits.h"
#include "core/theory/pose/joint_limits.h"
#include "tests/core/support/mechanisms.h"

namespace geargraph {
namespace {

constexpr double kDegree = std::numbers::pi / 180;
constexpr double kOpen = std::numeric_limits<double>::infinity();

}  // namespace

class JointLimitsTest : public QObject {
  Q_OBJECT

 private slots:
  void degreesOfTheDocumentAreRadians() {
    const JointLimits half{std::nullopt, Number(90)};
    const Mechanism robot = withJointLimits(test::robotTopology(), JointId("9"), half).value();
    const std::vector<AngleLimits> limits = angleLimits(robot);
    QCOMPARE(limits.size(), std::size_t{7});
    QCOMPARE(limits[0].low, -kOpen);
    QCOMPARE(limits[0].high, kOpen);
    QCOMPARE(limits[1].low, -kOpen);
    QCOMPARE(limits[1].high, 90 * kDegree);
  }

  void theJointThatIsAtItsLimitFirstEndsTheMotion() {
    const std::vector<AngleLimits> limits = {{-1, 2}, {-3, 3}, {}, {-0.1, 0.1}};
    const std::vector<double> start(4, 0);
    const std::vector<double> rates = {0.5, -2, 7, 0};
    const MotionRange range = motionRange(limits, start, rates);
    QCOMPARE(range.to, 1.5);  // joint 1 turns to -3
    QCOMPARE(range.toJoint, 1);
    QCOMPARE(range.from, -1.5);
    QCOMPARE(range.fromJoint, 1);
    QVERIFY(range.isLimited());
  }

  void anOpenEndLimitsOneDirectionOnly() {
    const std::vector<AngleLimits> limits = {{-1, kOpen}};
    const std::vector<double> start = {0.5};
    const std::vector<double> rates = {2};
    const MotionRange range = motionRange(limits, start, rates);
    QCOMPARE(range.from, -0.75);
    QCOMPARE(range.to, kOpen);
    QCOMPARE(range.toJoint, -1);
    const std::vector<double> atRest = {0};
    QVERIFY(!motionRange(limits, start, atRest).isLimited());
  }

  void jointsBeyondTheirLimitsAreNamed() {
    const std::vector<AngleLimits> limits = {{-1, 2}, {-3, 3}, {}};
    QCOMPARE(jointsBeyondLimits(limits, std::vector<double>{2, 3.1, 1e6}), std::vector<int>{1});
    QCOMPARE(jointsBeyondLimits(limits, std::vector<double>{-1.5, -3, 0}), std::vector<int>{0});
    QVERIFY(jointsBeyondLimits(limits, std::vector<double>{0, 0, 0}).empty());
  }
};

}  // namespace geargraph

QTEST_APPLESS_MAIN(geargraph::JointLimitsTest)
#include "test_joint_limits.moc"

#include <QTest>
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <random>

#include "core/design/collision/collision_pair.h"
#include "core/design/collision/motion_collisions.h"
#include "core/design/collision/motion_diagnostics.h"
#include "core/machine/solids/part_solids.h"
#include "core/theory/pose/turning_lines.h"
#include "tests/core/support/deep_train.h"
#include "tests/core/support/example_files.h"
#include "tests/core/support/mechanisms.h"
#include "tests/core/support/train_sketch.h"

namespace geargraph {
namespace {

using Eigen::Vector3d;

constexpr double kTurn = 2 * std::numbers::pi;

/// A box with edges along the axes.
Solid box(const Vector3d& low, const Vector3d& high) {
  Solid solid;
  for (int corner = 0; corner < 8; ++corner) {
    const auto at = [&](int axis) {
      return static_cast<float>(((corner >> axis) & 1) != 0 ? high[axis] : low[axis]);
    };
    solid.positions.push_back({at(0), at(1), at(2)});
    solid.normals.push_back({0, 0, 1});
  }
  solid.triangles = {{0, 2, 1}, {1, 2, 3}, {4, 5, 6}, {5, 7, 6}, {0, 1, 4}, {1, 5, 4},
                     {2, 6, 3}, {3, 6, 7}, {0, 4, 2}, {2, 4, 6}, {1, 3, 5}, {3, 7, 5}};
  return solid;
}

/// Links on the ground, each turning about a line of its own.
struct Arms {
  Mechanism mechanism;
  Digraph graph;
  SpanningTree tree;
  JointRates motion;
  std::vector<CollisionPart> parts;

  explicit Arms(const std::vector<std::pair<TurningLine, double>>& joints)
      : mechanism(made(joints.size())),
        graph(mechanism),
        tree(SpanningTree::of(graph).value()),
        motion{tree, {}, {}, {}} {
    for (const auto& [line, rate] : joints) {
      motion.lines.push_back(line);
      motion.rates.push_back(rate);
    }
  }

  static Mechanism made(std::size_t joints) {
    Mechanism mechanism = emptyMechanism();
    mechanism.axes.push_back({AxisId("a"), {}, {}, {}});
    for (std::size_t i = 1; i <= joints; ++i) {
      const std::string id = std::to_string(i);
      Link link;
      link.id = LinkId(id);
      mechanism.links.push_back(link);
      TurningJoint joint;
      joint.id = JointId("j" + id);
      joint.tail = LinkId("0");
      joint.head = link.id;
      joint.axis = AxisId("a");
      mechanism.turningJoints.push_back(joint);
    }
    return mechanism;
  }

  void add(int link, const Vector3d& low, const Vector3d& high) {
    parts.push_back(collisionPart(link, box(low, high), 1));
  }
  [[nodiscard]] MotionCheck check(const MotionRange& range = {}, const MotionCheckOptions& options = {},
                                  const std::stop_token& stop = {}) const {
    return motionCollisions(parts, motion, range, stop, options);
  }
};

const TurningLine kZ{Vector3d::Zero(), Vector3d::UnitZ()};

/// A bar from the z axis to x = 10, 2 wide and high, that turns at 1 rad/s.
Arms sweepingBar() {
  Arms arms({{kZ, 1}});
  arms.add(1, {0, -1, -1}, {10, 1, 1});
  return arms;
}

SnapshotPtr analyzed(Mechanism mechanism) {
  return analyzeLive(std::make_shared<const Mechanism>(std::move(mechanism)));
}

Mechanism withoutLimits(Mechanism mechanism) {
  for (TurningJoint& joint : mechanism.turningJoints) joint.limits = {};
  return mechanism;
}

}  // namespace

class MotionCollisionsTest : public QObject {
  Q_OBJECT

 private slots:
  /// The side of the bar reaches the corner (0.5, 8) where 8 cos t - 0.5 sin t = 1.
  void barMeetsPostAtTheAngleOfTheFormula() {
    Arms arms = sweepingBar();
    arms.add(0, {-0.5, 8, -1}, {0.5, 12, 1});
    const double expected = std::acos(1 / std::hypot(8, 0.5)) - std::atan2(0.5, 8);
    const MotionCheck check = arms.check();
    QCOMPARE(check.collisions.size(), std::size_t{1});
    QCOMPARE(check.collisions[0].one, 0);
    QCOMPARE(check.collisions[0].other, 1);
    QVERIFY(std::abs(check.collisions[0].time - expected) < 1e-3);
    QVERIFY(check.coversAll && check.isComplete);
    QVERIFY(std::abs(check.to - kTurn) < 1e-9);
  }

  void barPassesWhatIsBeyondItsTipBesideItOrNextToItsPath() {
    const std::vector<std::pair<Vector3d, Vector3d>> clear = {
        {{-0.5, 10.1, -1}, {0.5, 12, 1}},  // beyond the tip's circle of radius 10.05
        {{-0.5, 8, 1.01}, {0.5, 12, 3}},   // above
        {{7.2, 7.2, -1}, {12, 12, 1}},     // its corner is at 10.18
    };
    for (const auto& [low, high] : clear) {
      Arms arms = sweepingBar();
      arms.add(0, low, high);
      const MotionCheck check = arms.check();
      QVERIFY(check.collisions.empty());
      QVERIFY(check.coversAll && check.isComplete);
    }
  }

  /// Mirror images about x = 7.5 meet where a corner reaches that plane: 10 sin t + cos t = 7.5.
  void armsOnParallelShaftsMeetInTheMiddle() {
    const TurningLine right{{15, 0, 0}, Vector3d::UnitZ()};
    Arms arms({{kZ, -1}, {right, 1}});
    arms.add(1, {-1, 0, -1}, {1, 10, 1});
    arms.add(2, {14, 0, -1}, {16, 10, 1});
    const double expected = std::asin(7.5 / std::hypot(10, 1)) - std::atan2(1, 10);
    const MotionCheck check = arms.check();
    QCOMPARE(check.collisions.size(), std::size_t{1});
    QVERIFY(std::abs(check.collisions[0].time - expected) < 1e-3);
    QVERIFY(!check.coversAll);  // without exact rates the period of two turns is unknown
  }

  void limitsEndTheSearchAndOpenTheWayBack() {
    Arms arms = sweepingBar();
    arms.add(0, {-0.5, 8, -1}, {0.5, 12, 1});
    const double contact = arms.check().collisions.at(0).time;
    MotionRange range{-1, contact - 0.01, 0, 0};
    QVERIFY(arms.check(range).collisions.empty());
    QCOMPARE(arms.check(range).from, -1.0);
    QVERIFY(arms.check(range).coversAll);
    range.to = contact + 0.01;
    QCOMPARE(arms.check(range).collisions.size(), std::size_t{1});

    Arms back({{kZ, -1}});  // the same contact, backwards in time
    back.add(1, {0, -1, -1}, {10, 1, 1});
    back.add(0, {-0.5, 8, -1}, {0.5, 12, 1});
    const MotionCheck check = back.check({-2, 1, 0, 0});
    QCOMPARE(check.collisions.size(), std::size_t{1});
    QVERIFY(std::abs(check.collisions[0].time + contact) < 1e-3);
  }

  /// The slow pair is followed for longer than the fast one, which does not repeat: only what both cover
  /// counts.
  void coverageIsThatOfThePairThatIsFollowedForTheShortestTime() {
    const TurningLine right{{15, 0, 0}, Vector3d::UnitZ()};
    const TurningLine above{{15, 3, 0}, Vector3d::UnitZ()};
    Arms arms({{kZ, -1}, {right, 8}, {above, 0.1}});
    arms.add(1, {-1, 0, -1}, {1, 9, 1});
    arms.add(2, {14, 0, -1}, {16, 9, 0});
    arms.add(3, {14, 3, 0.5}, {16, 11, 1});
    MotionCheckOptions options;
    options.mostTurns = 2;
    const MotionCheck check = arms.check({}, options);
    QVERIFY(!check.coversAll);
    const RelativeMotion fast(arms.motion, arms.parts[0], arms.parts[1]);
    const RelativeMotion slow(arms.motion, arms.parts[0], arms.parts[2]);
    QVERIFY(!pairBounds(slow, arms.parts[0], arms.parts[2]).isClear);
    QVERIFY(slow.fastestRate() < fast.fastestRate());
    QVERIFY(std::abs(check.to - 2 * kTurn / fast.fastestRate()) < 1e-9);
    const MotionRange beyond{-1000, 1000, 0, 0};
    QVERIFY(std::abs(arms.check(beyond, options).to - check.to) < 1e-9);
    QVERIFY(std::abs(arms.check(beyond, options).from + check.to) < 1e-9);
  }

  void overlapInTheReferencePoseIsAtTimeZero() {
    Arms arms = sweepingBar();
    arms.add(0, {8, -0.5, -0.5}, {12, 0.5, 0.5});
    QCOMPARE(arms.check().collisions.at(0).time, 0.0);
  }

  void meshingWheelsAndShaftsInBearingsHaveNoTurnsLeft() {
    const TurningLine right{{15, 0, 0}, Vector3d::UnitZ()};
    const Arms arms({{kZ, 1}, {right, -2}});
    const CollisionPart wheel = collisionPart(1, tube(7.6, 2, -1, 1, 0.05), 1, kZ);
    Solid moved = tube(7.6, 2, -1, 1, 0.05);
    for (Float3& p : moved.positions) p[0] += 15;
    const CollisionPart other = collisionPart(2, moved, 1, right);
    const CollisionPart frame = collisionPart(0, box({-9, -9, -3}, {9, 9, -2}), 1);
    QVERIFY(!RelativeMotion(arms.motion, wheel, other).isMoving());
    QVERIFY(!RelativeMotion(arms.motion, frame, wheel).isMoving());
    QCOMPARE(RelativeMotion(arms.motion, collisionPart(1, moved, 1), other).turns().size(), std::size_t{1});
  }

  /// As the poses of the whole mechanism say, for any two links of random trees.
  void relativeMotionIsThatOfTheForwardKinematics() {
    int compared = 0;
    for (std::uint64_t seed = 0; seed < 60; ++seed) {
      const Mechanism mechanism = test::randomTree(seed, 2 + static_cast<int>(seed % 12), 0);
      const Digraph graph(mechanism);
      const SpanningTree tree = SpanningTree::of(graph).value();
      std::mt19937_64 random(seed);
      std::uniform_real_distribution<double> unit(-1, 1);
      JointRates motion{tree, {}, {}, {}};
      for (int joint = 0; joint < graph.t(); ++joint) {
        const Vector3d direction(unit(random), unit(random), unit(random));
        motion.lines.push_back(
            {20 * Vector3d(unit(random), unit(random), unit(random)), direction.normalized()});
        motion.rates.push_back(joint % 5 == 4 ? 0 : 3 * unit(random));
      }
      const int links = mechanism.n() + 1;
      const CollisionPart p = collisionPart(static_cast<int>(seed) % links, box({0, 0, 0}, {1, 2, 3}), 1);
      const CollisionPart q = collisionPart(static_cast<int>(seed / 3) % links, box({2, 2, 2}, {4, 3, 9}), 1);
      const RelativeMotion relative(motion, p, q);
      const ForwardKinematics kinematics(tree, motion.lines);
      const Eigen::AlignedBox3d swept = sweptBox(motion, q);
      const double speed = relative.isMoving() ? pairBounds(relative, p, q).speed : 0;
      const std::array<Vector3d, 2> ofP = {Vector3d(0, 0, 0), Vector3d(1, 2, 3)};
      const std::array<Vector3d, 3> ofQ = {Vector3d(2, 2, 2), Vector3d(4, 3, 9), Vector3d(2, 3, 9)};
      Eigen::Isometry3d before = Eigen::Isometry3d::Identity();
      for (int i = 0; i <= 400; ++i) {
        const double time = 0.01 * i;
        std::vector<double> angles;
        for (const double rate : motion.rates) angles.push_back(rate * time);
        const auto poses = kinematics.poses(angles);
        const auto& poseOfP = poses[static_cast<std::size_t>(p.link)];
        const auto& poseOfQ = poses[static_cast<std::size_t>(q.link)];
        const Eigen::Isometry3d now = relative.displacement(time);
        QVERIFY((now.matrix() - (poseOfP.inverse() * poseOfQ).matrix()).norm() < 1e-9);
        for (const Vector3d& b : ofQ) {
          QVERIFY(swept.contains(poseOfQ * b));
          for (const Vector3d& a : ofP) {
            const double change = (now * b - a).norm() - (before * b - a).norm();
            QVERIFY(std::abs(change) <= 0.01 * speed + 1e-9);
            ++compared;
          }
        }
        before = now;
      }
    }
    QVERIFY(compared > 50'000);
  }

  void stopsWhenCancelledAndAtTheBudget() {
    Arms arms = sweepingBar();
    arms.add(0, {-0.5, 8, -1}, {0.5, 12, 1});
    std::stop_source stop;
    stop.request_stop();
    const MotionCheck cancelled = arms.check({}, {}, stop.get_token());
    QVERIFY(!cancelled.isComplete && cancelled.collisions.empty());
    MotionCheckOptions few;
    few.mostTests = 20;
    QVERIFY(!arms.check({}, few).isComplete);
    const RelativeMotion relative(arms.motion, arms.parts[1], arms.parts[0]);
    std::int64_t budget = 1000;
    const CollisionPair pair(arms.parts[1], arms.parts[0], relative, 12);
    QVERIFY(!pair.firstContact(kTurn, budget, stop.get_token()));
    QCOMPARE(budget, std::int64_t{1000});  // the token is polled before the first distance
    QVERIFY(!checkMotion(*analyzed(test::example("robot")), stop.get_token()));
  }

  /// Three of the examples collide beyond the limits of their joints.
  void examplesDoNotCollide() {
    int checked = 0;
    for (const std::string& name : test::exampleNames()) {
      const auto report = checkMotion(*analyzed(test::example(name)));
      if (!report) continue;
      QVERIFY2(report->diagnostics.empty(), name.c_str());
      QVERIFY2(report->check.collisions.empty() && report->check.isComplete && report->check.coversAll,
               name.c_str());
      ++checked;
    }
    QCOMPARE(checked, 27);  // all but the locked train and the one with errors
  }

  /// Arms, flanges and pillars of carriers pass suns, rings, planets and the frame.
  void planetarySetsDoNotCollide() {
    for (const int sun : {15, 24, 40}) {
      for (const int planet : {12, 18, 30}) {
        for (const int planets : {1, 2, 3}) {
          Mechanism set = test::planetary(sun, planet, planets);
          set.inputs = {{set.turningJoints[0].id, 1, {}}, {set.turningJoints[1].id, 0, {}}};
          const auto report = checkMotion(*analyzed(std::move(set)));
          const std::string name =
              std::to_string(sun) + ' ' + std::to_string(planet) + ' ' + std::to_string(planets);
          QVERIFY2(report.has_value() && report->check.isComplete, name.c_str());
          QVERIFY2(report->check.collisions.empty(), name.c_str());
        }
      }
    }
  }

  void withoutLimitsRobotsCollide_data() {
    QTest::addColumn<QString>("name");
    QTest::addColumn<QList<int>>("first");
    QTest::addColumn<double>("time");
    QTest::newRow("robot") << "robot" << QList<int>{5, 7} << 2.999;
    QTest::newRow("bevel wrist") << "bevel-wrist" << QList<int>{2, 6} << 2.999;
    QTest::newRow("three-roll wrist") << "three-roll-wrist" << QList<int>{2, 4} << 3.148;
  }
  void withoutLimitsRobotsCollide() {
    QFETCH(QString, name);
    QFETCH(QList<int>, first);
    QFETCH(double, time);
    const SnapshotPtr snapshot = analyzed(withoutLimits(test::example(name.toStdString())));
    const auto report = checkMotion(*snapshot);
    QVERIFY(report.has_value());
    const MotionCollision& collision = report->check.collisions.at(0);
    QCOMPARE((QList<int>{collision.one, collision.other}), first);
    QVERIFY(std::abs(collision.time - time) < 0.002);
    const Diagnostic& found = report->diagnostics.at(0);
    QCOMPARE(found.code, Code::interference);
    QCOMPARE(found.severity(), Severity::warning);
    QCOMPARE(found.time, std::optional(collision.time));
    const auto& links = snapshot->mechanism->links;
    QCOMPARE(found.elements, (std::vector<ElementId>{links[static_cast<std::size_t>(first[0])].id,
                                                     links[static_cast<std::size_t>(first[1])].id}));
  }

  void whatWasNotCheckedIsToldInOneSentence() {
    const SnapshotPtr robot = analyzed(withoutLimits(test::example("robot")));
    const auto whole = checkMotion(*robot);
    QVERIFY(whole && whole->check.isComplete && whole->check.coversAll);
    QCOMPARE(motionNote(*robot, &*whole), std::string());
    QCOMPARE(motionNote(*robot, nullptr), std::string());

    MotionCheckOptions few;
    few.mostTests = 50'000;
    const auto part = checkMotion(*robot, {}, few);
    QVERIFY(part && !part->check.isComplete);
    QCOMPARE(motionNote(*robot, &*part), std::string("Only part of the motion was checked for collisions: "
                                                     "too many parts come close to each other."));

    MotionReport sampled;
    sampled.check.to = 125.66;
    sampled.check.coversAll = false;
    QCOMPARE(motionNote(*robot, &sampled), std::string("The motion was checked for collisions for its first "
                                                       "125.7 s: it does not repeat sooner."));
    const SnapshotPtr large = analyzed(test::deepTrain(1, kMaxCheckedLinks + 1));
    QVERIFY(!checkMotion(*large));
    QCOMPARE(motionNote(*large, nullptr),
             std::string("The motion of more than 300 links is not checked for collisions."));
    QCOMPARE(secondsText(4.46), std::string("4.5 s"));
    QCOMPARE(secondsText(0.01234), std::string("0.012 s"));
    QCOMPARE(secondsText(-0.0), std::string("0.0 s"));
  }

  /// Arm 2, the end-effector 3 and the planets 7 are within gear 1 or its carrier at 4.5 s.
  void linksOfTheRobotPenetrateItsFootWithinFourAndAHalfSeconds() {
    const auto report = checkMotion(*analyzed(withoutLimits(test::example("robot"))));
    QVERIFY(report.has_value());
    for (const int link : {2, 3, 7}) {
      const auto& all = report->check.collisions;
      const auto found = std::find_if(all.begin(), all.end(), [&](const MotionCollision& collision) {
        return collision.one == 1 && collision.other == link;
      });
      QVERIFY(found != all.end());
      QVERIFY(found->time > 3 && found->time < 4.5);
    }
  }
};

}  // namespace geargraph

QTEST_APPLESS_MAIN(geargraph::MotionCollisionsTest)
#include "test_motion_collisions.moc"

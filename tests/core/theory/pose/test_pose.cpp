#include <QTest>
#include <numbers>
#include <random>

#include "core/theory/pose/forward_kinematics.h"
#include "core/theory/pose/link_twists.h"
#include "core/theory/pose/period.h"
#include "tests/core/support/mechanisms.h"

namespace geargraph {
namespace {

constexpr std::uint64_t kMechanisms = 100;
constexpr double kTurn = 2 * std::numbers::pi;

/// A random tree with random lines and angles.
struct Case {
  Mechanism mechanism;
  Digraph graph;
  SpanningTree tree;
  std::vector<TurningLine> lines;
  std::vector<double> angles;

  explicit Case(std::uint64_t seed)
      : mechanism(test::randomTree(seed, 1 + static_cast<int>(seed % 40), 0)),
        graph(mechanism),
        tree(SpanningTree::of(graph).value()) {
    std::mt19937_64 random(seed);
    std::uniform_real_distribution<double> unit(-1, 1);
    for (int joint = 0; joint < graph.t(); ++joint) {
      const Eigen::Vector3d direction(unit(random), unit(random), unit(random));
      lines.push_back(
          {50 * Eigen::Vector3d(unit(random), unit(random), unit(random)), direction.normalized()});
      angles.push_back(9 * unit(random));
    }
  }
  [[nodiscard]] ForwardKinematics kinematics() const { return {tree, lines}; }
};

bool same(const Eigen::Isometry3d& a, const Eigen::Isometry3d& b, double tolerance = 1e-9) {
  return (a.matrix() - b.matrix()).norm() < tolerance;
}

/// The displacement of the head against the tail, written out without the tree.
Eigen::Isometry3d turn(const TurningLine& line, double angle) {
  return Eigen::Translation3d(line.point) * Eigen::AngleAxisd(angle, line.direction) *
         Eigen::Translation3d(-line.point);
}

}  // namespace

class PoseTest : public QObject {
  Q_OBJECT

 private slots:
  void noAnglesAreTheReferencePose() {
    for (std::uint64_t seed = 0; seed < kMechanisms; ++seed) {
      const Case c(seed);
      const std::vector<double> zero(c.angles.size(), 0);
      for (const auto& pose : c.kinematics().poses(zero)) QVERIFY(same(pose, Eigen::Isometry3d::Identity()));
    }
  }

  void everyHeadTurnsAgainstItsTailAsItsAngleSays() {
    for (std::uint64_t seed = 0; seed < kMechanisms; ++seed) {
      const Case c(seed);
      const auto poses = c.kinematics().poses(c.angles);
      QVERIFY(same(poses[0], Eigen::Isometry3d::Identity()));
      for (int joint = 0; joint < c.graph.t(); ++joint) {
        const auto& [tail, head] = c.graph.turningEdge(joint);
        const auto at = static_cast<std::size_t>(joint);
        QVERIFY(same(poses[static_cast<std::size_t>(head)],
                     poses[static_cast<std::size_t>(tail)] * turn(c.lines[at], c.angles[at])));
      }
    }
  }

  void twistsAreTheDerivativesOfPoses() {
    for (std::uint64_t seed = 0; seed < kMechanisms; ++seed) {
      const Case c(seed);
      const ForwardKinematics kinematics = c.kinematics();
      std::vector<double> rates, before = c.angles, after = c.angles;
      constexpr double kStep = 1e-5;
      for (std::size_t joint = 0; joint < c.angles.size(); ++joint) {
        rates.push_back(0.3 + 0.17 * static_cast<double>((joint * 7) % 5) - 0.5 * (joint % 2));
        before[joint] -= kStep * rates[joint];
        after[joint] += kStep * rates[joint];
      }
      const auto poses = kinematics.poses(c.angles), then = kinematics.poses(before),
                 now = kinematics.poses(after);
      const auto twists = linkTwists(c.tree, kinematics, poses, rates);
      const Eigen::Vector3d inLink(3, -2, 5);
      for (std::size_t link = 0; link < poses.size(); ++link) {
        const Eigen::Vector3d velocity = (now[link] * inLink - then[link] * inLink) / (2 * kStep);
        const double size = 1 + velocity.norm();
        QVERIFY((twists[link].at(poses[link] * inLink) - velocity).norm() < 1e-4 * size);
      }
    }
  }

  void posesAreRigidMotions() {
    for (std::uint64_t seed = 0; seed < kMechanisms; ++seed) {
      const Case c(seed);
      for (const auto& pose : c.kinematics().poses(c.angles)) {
        QVERIFY((pose.linear() * pose.linear().transpose()).isIdentity(1e-9));
        QVERIFY(pose.linear().determinant() > 0);
      }
    }
  }

  void flippingAnArrowAndItsAngleChangesNothing() {
    for (std::uint64_t seed = 0; seed < kMechanisms; ++seed) {
      Case c(seed);
      const auto before = c.kinematics().poses(c.angles);
      const std::size_t flipped = seed % c.angles.size();
      std::swap(c.mechanism.turningJoints[flipped].tail, c.mechanism.turningJoints[flipped].head);
      c.graph = Digraph(c.mechanism);
      c.tree = SpanningTree::of(c.graph).value();
      c.angles[flipped] = -c.angles[flipped];
      const auto after = c.kinematics().poses(c.angles);
      for (std::size_t link = 0; link < before.size(); ++link) QVERIFY(same(before[link], after[link]));
    }
  }

  void aMillionTurnsLaterEverythingIsWhereItWas() {
    for (std::uint64_t seed = 0; seed < kMechanisms; ++seed) {
      Case c(seed);
      const auto before = c.kinematics().poses(c.angles);
      for (double& angle : c.angles) angle += 1e6 * kTurn;
      const auto after = c.kinematics().poses(c.angles);
      for (std::size_t link = 0; link < before.size(); ++link) QVERIFY(same(before[link], after[link], 1e-5));
    }
  }

  void theRobotsAxesMeetTheirLinesAgain() {
    const Mechanism robot = test::robotTopology();
    const Digraph graph(robot);
    const SpanningTree tree = SpanningTree::of(graph).value();
    const Eigen::Vector3d y = Eigen::Vector3d::UnitY(), z = Eigen::Vector3d::UnitZ();
    std::vector<TurningLine> lines = {{{0, -54, 0}, z}, {{0, 0, 0}, z},  {{0, 0, 0}, z},  {{0, 0, 50}, y},
                                      {{0, 0, 50}, y},  {{0, 0, 50}, z}, {{0, 0, 100}, y}};
    const double quarter = kTurn / 4;
    // joint 10 a quarter: the carrier turns y to -x; joint 12 a quarter: then z to x in the carrier
    const auto poses =
        ForwardKinematics(tree, lines).poses(std::vector<double>{0, 0, quarter, 0, quarter, 0, 0});
    QVERIFY((poses[1].linear() * y - Eigen::Vector3d(-1, 0, 0)).norm() < 1e-12);
    QVERIFY((poses[2] * Eigen::Vector3d(0, 0, 60) - Eigen::Vector3d(0, 10, 50)).norm() < 1e-12);
    QVERIFY((poses[3].linear() * y - Eigen::Vector3d(-1, 0, 0)).norm() <
            1e-12);  // e rides on 2, parallel to c
  }

  void thePeriodIsTheFirstReturn() {
    const auto period = [](std::initializer_list<Rational> rates) {
      const auto found = commonPeriod(std::vector<Rational>(rates));
      return found ? found->toString() : std::string("none");
    };
    QCOMPARE(period({Rational(1), Rational(-1, 2), Rational(-2, 3)}), "6");
    QCOMPARE(period({Rational(4), Rational(6)}), "1/2");
    QCOMPARE(period({Rational(3, 4), Rational(0), Rational(9, 10)}), "20/3");
    QCOMPARE(period({Rational(0)}), "none");
    QCOMPARE(period({}), "none");
  }

  void thePeriodIsWholeForEveryRateAndNoPartOfItIs() {
    std::mt19937_64 random(3);
    int periods = 0;
    for (int round = 0; round < 200; ++round) {
      std::vector<Rational> rates;
      for (int i = 0; i < 5; ++i) {
        rates.emplace_back(static_cast<std::int64_t>(random() % 41) - 20,
                           static_cast<std::int64_t>(random() % 30) + 1);
      }
      const auto period = commonPeriod(rates);
      if (!period) continue;
      ++periods;
      for (const Rational& rate : rates) QVERIFY((rate * *period).isInteger());
      for (const int part : {2, 3, 5, 7}) {
        const Rational sooner = *period / Rational(part);
        const auto whole = [&](const Rational& rate) { return (rate * sooner).isInteger(); };
        QVERIFY(!std::all_of(rates.begin(), rates.end(), whole));
      }
    }
    QVERIFY2(periods > 190, qPrintable(QString::number(periods)));
  }
};

}  // namespace geargraph

QTEST_APPLESS_MAIN(geargraph::PoseTest)
#include "test_pose.moc"

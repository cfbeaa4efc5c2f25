#include <QTest>
#include <random>

#include "core/theory/analysis/analysis.h"
#include "core/theory/pose/jacobian.h"
#include "tests/core/support/trains.h"

namespace geargraph {
namespace {

using test::TrainBuilder;

/// A solved mechanism, with what the Jacobian asks for in doubles and exact.
struct Solved {
  SnapshotPtr snapshot;
  std::vector<ExactLine> exactLines;
  std::vector<TurningLine> lines;
  Eigen::MatrixXd gains;

  explicit Solved(Mechanism mechanism)
      : snapshot(analyze(std::make_shared<const Mechanism>(std::move(mechanism)))) {
    const Mechanism& m = *snapshot->mechanism;
    for (const TurningJoint& joint : m.turningJoints) {
      for (std::size_t axis = 0; axis < m.axes.size(); ++axis) {
        if (m.axes[axis].id != joint.axis) continue;
        const Placement& placement = snapshot->kinematics->placement();
        const AxisLine& line = placement.axes[axis];
        exactLines.push_back(exactLine(m, placement, static_cast<int>(axis)));
        lines.push_back({{line.point[0], line.point[1], line.point[2]},
                         {line.direction[0], line.direction[1], line.direction[2]}});
      }
    }
    gains = Eigen::MatrixXd::Zero(m.t(), inputs());
    for (int joint = 0; joint < m.t(); ++joint) {
      for (int input = 0; input < inputs(); ++input) gains(joint, input) = gain(joint, input).toDouble();
    }
  }
  [[nodiscard]] const ExactSolution& exact() const { return *snapshot->solved->exact; }
  [[nodiscard]] int inputs() const { return static_cast<int>(exact().inputs.size()); }
  [[nodiscard]] Rational gain(int joint, int input) const {
    const auto width = static_cast<std::size_t>(inputs());
    for (std::size_t i = 0; i < exact().inputs.size(); ++i) {
      if (exact().inputs[i] == joint) return Rational(static_cast<int>(i) == input ? 1 : 0);
    }
    for (std::size_t row = 0; row < exact().outputs.size(); ++row) {
      if (exact().outputs[row] == joint) return exact().matrix[row * width + static_cast<std::size_t>(input)];
    }
    return {};
  }
  [[nodiscard]] ExactMotion motion() const {
    return {*snapshot->tree, exactLines, [this](int joint, int input) { return gain(joint, input); },
            inputs()};
  }
  [[nodiscard]] JacobianRank reference(int link, const ExactVector3& point) const {
    return referenceJacobianRank(motion(), link, point).value();
  }
  [[nodiscard]] JacobianRank generic(int link, const ExactVector3& point) const {
    return genericJacobianRank(motion(), link, point).value();
  }
};

/// A wrist of three axes through the origin, each driven directly: z, then one at right angles, then `third`.
Mechanism wrist(const test::ExactTriple& third) {
  TrainBuilder train("wrist");
  const int roll = train.link(0, train.axis({0, 0, 0}, {0, 0, 1}));
  const int pitch = train.link(roll, train.axis({0, 0, 0}, {0, 1, 0}));
  train.link(pitch, train.axis({0, 0, 0}, third));
  return train.mechanism();
}

}  // namespace

class JacobianTest : public QObject {
  Q_OBJECT

 private slots:
  // Erratum 10: axes c and e are parallel, so the end-effector has two freedoms of orientation, not three.
  void robotHasTwoFreedomsOfOrientation() {
    const Solved robot(test::robot());
    const ExactVector3 tool{10, 40, 140};
    QCOMPARE(robot.reference(3, tool), (JacobianRank{2, 3}));
    QCOMPARE(robot.generic(3, tool), (JacobianRank{2, 3}));
    QCOMPARE(robot.generic(1, tool), (JacobianRank{1, 1}));
    QCOMPARE(robot.generic(0, tool), (JacobianRank{0, 0}));
  }

  void wristIsSingularWhereItsOuterAxesCoincide() {
    const ExactVector3 centre{0, 0, 0};
    const Solved rollPitchRoll(wrist({0, 0, 1}));
    QCOMPARE(rollPitchRoll.reference(3, centre), (JacobianRank{2, 2}));
    QCOMPARE(rollPitchRoll.generic(3, centre), (JacobianRank{3, 3}));
    const Solved rollPitchYaw(wrist({1, 0, 0}));
    QCOMPARE(rollPitchYaw.reference(3, centre), (JacobianRank{3, 3}));
  }

  void directionsOfIrrationalLengthHaveExactRanks() {
    Mechanism oblique = wrist({0, 0, 1});
    oblique.axes[2].direction = NumberTriple{Number(1), Number(1), Number(0)};
    oblique.axes[1].direction = NumberTriple{Number(0), Number(1), Number(2)};
    const Solved solved(oblique);
    QCOMPARE(solved.reference(3, {0, 0, 0}), (JacobianRank{3, 3}));
    oblique.axes[2].direction =
        NumberTriple{Number(0), Number(3), Number(7)};  // in the plane of the other two
    QCOMPARE(Solved(oblique).reference(3, {0, 0, 0}), (JacobianRank{2, 2}));
  }

  void columnsAreTheDerivativesOfThePoses() {
    const Solved robot(test::robot());
    const ForwardKinematics kinematics(*robot.snapshot->tree, robot.lines);
    std::mt19937_64 random(5);
    std::uniform_real_distribution<double> angle(-3, 3);
    const Eigen::Vector3d point(10, 40, 140);
    for (int round = 0; round < 20; ++round) {
      const Eigen::VectorXd inputs =
          Eigen::VectorXd::NullaryExpr(robot.inputs(), [&] { return angle(random); });
      const auto posesAt = [&](const Eigen::VectorXd& at) {
        const Eigen::VectorXd joints = robot.gains * at;
        return kinematics.poses({joints.data(), static_cast<std::size_t>(joints.size())});
      };
      const auto here = posesAt(inputs);
      const Jacobian jacobian = pointJacobian(*robot.snapshot->tree, kinematics, here, robot.gains, 3, point);
      for (Eigen::Index input = 0; input < inputs.size(); ++input) {
        constexpr double step = 1e-6;
        Eigen::VectorXd ahead = inputs;
        Eigen::VectorXd behind = inputs;
        ahead[input] += step;
        behind[input] -= step;
        const auto a = posesAt(ahead);
        const auto b = posesAt(behind);
        const Eigen::Vector3d velocity = (a[3] * point - b[3] * point) / (2 * step);
        const Eigen::Matrix3d spin =
            (a[3].linear() - b[3].linear()) / (2 * step) * here[3].linear().transpose();
        const Eigen::Vector3d omega(spin(2, 1), spin(0, 2), spin(1, 0));
        QVERIFY((jacobian.col(input).head<3>() - omega).norm() < 1e-8);
        QVERIFY((jacobian.col(input).tail<3>() - velocity).norm() < 1e-6);
      }
    }
  }

  void genericRankIsThatOfRandomPoses() {
    for (const Mechanism& mechanism : {test::robot(), wrist({0, 0, 1}), wrist({1, 0, 0})}) {
      const Solved solved(mechanism);
      const ForwardKinematics kinematics(*solved.snapshot->tree, solved.lines);
      const Eigen::VectorXd inputs = Eigen::VectorXd::LinSpaced(solved.inputs(), 0.7, 1.9);
      const Eigen::VectorXd joints = solved.gains * inputs;
      const auto poses = kinematics.poses({joints.data(), static_cast<std::size_t>(joints.size())});
      for (int link = 0; link < mechanism.n() + 1; ++link) {
        const Jacobian jacobian = pointJacobian(*solved.snapshot->tree, kinematics, poses, solved.gains, link,
                                                Eigen::Vector3d(3, 5, 7));
        const JacobianRank rank = solved.generic(link, {3, 5, 7});
        QCOMPARE(rank.full, static_cast<int>(jacobian.fullPivLu().rank()));
        QCOMPARE(rank.angular, static_cast<int>(jacobian.topRows<3>().fullPivLu().rank()));
      }
    }
  }
};

}  // namespace geargraph

QTEST_APPLESS_MAIN(geargraph::JacobianTest)
#include "test_jacobian.moc"

#include <QTest>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/machine/teeth/half_tooth.h"
#include "core/machine/teeth/wheel_kind.h"
#include "core/machine/train/toothed_train.h"
#include "core/presentation/result_json/lost_motion_report.h"
#include "core/theory/lost_motion/lost_motion.h"
#include "core/theory/matroid/joint_coupling.h"
#include "tests/core/support/example_files.h"
#include "tests/core/support/statics_case.h"
#include "tests/core/support/train_sketch.h"

using namespace geargraph;
using namespace geargraph::test;

namespace {

LostMotions lostMotionOf(const Worked& worked) {
  return *lostMotions(worked.mechanism, worked.model, worked.analysis.choice.joints);
}

const LostMotion& outputOf(const LostMotions& motions, JointOrdinal joint) {
  return *std::find_if(motions.outputs.begin(), motions.outputs.end(),
                       [&](const LostMotion& each) { return int{each.joint} == int{joint}; });
}

/// A wheel in its plane, as material or not: read off its generated tooth, by no step of the calculation.
class PlaneWheel {
 public:
  explicit PlaneWheel(const TrainGear& gear)
      : m_spec(gear.spec),
        m_tooth(toothOf(gear.spec, 1e-5)),
        m_isRing(m_tooth.tipRad < m_tooth.rootRad),
        m_center(gear.pose.translation().head<2>()),
        m_turned(std::atan2(gear.pose.linear()(1, 0), gear.pose.linear()(0, 0))) {}

  [[nodiscard]] const Eigen::Vector2d& center() const { return m_center; }

  /// Is the point inside of a tooth or of the body, with the wheel turned by `angle` and its centre at `at`?
  [[nodiscard]] bool covers(const Eigen::Vector2d& point, const Eigen::Vector2d& at, double angle) const {
    const Eigen::Vector2d from = (point - at) / m_spec.module;
    const double rad = from.norm();
    if (m_isRing ? rad >= m_tooth.rootRad : rad <= m_tooth.rootRad) return true;
    if (m_isRing ? rad < m_tooth.tipRad : rad > m_tooth.tipRad) return false;
    const double pitch = 2 * std::numbers::pi / m_spec.teeth;
    const double about = std::remainder(std::atan2(from.y(), from.x()) - m_turned - angle, pitch);
    return std::abs(about) < halfAngleAt(rad);
  }

  /// The outline of the teeth that look at `towards`.
  [[nodiscard]] std::vector<Eigen::Vector2d> outline(const Eigen::Vector2d& at, double angle,
                                                     const Eigen::Vector2d& towards) const {
    std::vector<Eigen::Vector2d> points;
    const double pitch = 2 * std::numbers::pi / m_spec.teeth;
    const Eigen::Vector2d look = towards - at;
    const double middle =
        std::round((std::atan2(look.y(), look.x()) - m_turned - angle) / pitch) * pitch + m_turned + angle;
    for (int tooth = -3; tooth <= 3; ++tooth) {
      for (const ProfilePoint& each : m_tooth.points) {
        for (const int side : {-1, 1}) {
          const double direction = middle + tooth * pitch + side * each.gam;
          points.push_back(at + m_spec.module * each.rad *
                                    Eigen::Vector2d(std::cos(direction), std::sin(direction)));
        }
      }
    }
    return points;
  }

 private:
  [[nodiscard]] double halfAngleAt(double rad) const {
    for (std::size_t i = 1; i < m_tooth.points.size(); ++i) {
      const ProfilePoint& a = m_tooth.points[i - 1];
      const ProfilePoint& b = m_tooth.points[i];
      if ((a.rad - rad) * (b.rad - rad) > 0 || a.rad == b.rad) continue;
      return a.gam + (b.gam - a.gam) * (rad - a.rad) / (b.rad - a.rad);
    }
    return 0;
  }

  GearSpec m_spec;
  HalfTooth m_tooth;
  bool m_isRing;
  Eigen::Vector2d m_center;
  double m_turned;
};

/// Where a wheel is: its centre and how far it is turned.
struct WheelPlace {
  Eigen::Vector2d at;
  double angle = 0;
};

bool wheelsOverlap(const PlaneWheel& a, const WheelPlace& placeA, const PlaneWheel& b,
                   const WheelPlace& placeB, const Eigen::Vector2d& mesh) {
  const auto touches = [&](const PlaneWheel& one, const WheelPlace& placeOne, const PlaneWheel& other,
                           const WheelPlace& placeOther) {
    const auto points = one.outline(placeOne.at, placeOne.angle, mesh);
    return std::any_of(points.begin(), points.end(), [&](const Eigen::Vector2d& point) {
      return other.covers(point, placeOther.at, placeOther.angle);
    });
  };
  return touches(a, placeA, b, placeB) || touches(b, placeB, a, placeA);
}

/// How far from 0, which is free, `isBlocked` lets one turn in the direction of `most`.
template <class IsBlocked>
double stopBefore(double most, const IsBlocked& isBlocked) {
  double free = 0;
  double blocked = most;
  for (int step = 0; step < 30; ++step) {
    const double between = (free + blocked) / 2;
    (isBlocked(between) ? blocked : free) = between;
  }
  return free;
}

/// How one wheel turns from stop to stop in another that is held, rad.
double measuredPlay(const Mechanism& mechanism, bool tailTurns) {
  const Placement placement = placementOf(mechanism);
  const GearTrain train = toothedTrain(mechanism, shapedWheels(mechanism, placement));
  const TrainMesh& mesh = train.meshes.front();
  const PlaneWheel tail(train.gears[mesh.tailGear]);
  const PlaneWheel head(train.gears[mesh.headGear]);
  const Eigen::Vector2d at = mesh.pitchPoint.head<2>();
  const auto isBlocked = [&](double angle) {
    return wheelsOverlap(tail, {tail.center(), tailTurns ? angle : 0}, head,
                         {head.center(), tailTurns ? 0 : angle}, at);
  };
  return stopBefore(0.05, isBlocked) - stopBefore(-0.05, isBlocked);
}

}  // namespace

class LostMotionTest : public QObject {
  Q_OBJECT

 private slots:
  void twoWheelsTurnByTheirBacklashOverTheirTeeth() {
    Mechanism pair = example("spur-pair");
    const Worked worked(pair);
    const LostMotions motions = lostMotionOf(worked);
    QVERIFY(!motions.isShared);
    const GearMesh& mesh = pair.gearMeshes.front();
    // Without a word of the document each wheel has 0.04 modules.
    QCOMPARE(motions.plays[MeshOrdinal(0)], Rational(2, 25));
    const LostMotion& output = motions.outputs.front();
    const bool isHead = pair.turningJoints[output.joint].head == mesh.head;
    const int teeth = isHead ? mesh.headTeeth : mesh.tailTeeth;
    QCOMPARE(*output.worst, Rational(2, 25) / Rational(teeth));
    QVERIFY(std::abs(*output.rootOfSquares - output.worst->toDouble()) < 1e-15);
    QCOMPARE(int{*output.mostOf()}, 0);
    // The generated teeth agree.
    const double measured = measuredPlay(pair, !isHead);
    QVERIFY2(std::abs(measured / output.worst->toDouble() - 1) < 0.01, qPrintable(QString::number(measured)));
  }

  void statedBacklashOfWheelsCounts() {
    Mechanism pair = example("spur-pair");
    pair.gearDefaults.emplace();
    pair.gearDefaults->backlash = Number(Rational(1, 10));
    Wheel wheel;
    wheel.id = WheelId("w");
    wheel.link = pair.gearMeshes.front().tail;
    wheel.backlash = Number(Rational(1, 4));
    pair.wheels.push_back(wheel);
    pair.gearMeshes.front().tailWheel = wheel.id;
    const LostMotions motions = lostMotionOf(Worked(pair));
    QCOMPARE(motions.plays[MeshOrdinal(0)], Rational(7, 20));
    const double measured = measuredPlay(pair, true);
    const double expected = 0.35 / pair.gearMeshes.front().tailTeeth;
    QVERIFY2(std::abs(measured / expected - 1) < 0.01, qPrintable(QString::number(measured / expected)));
    // A negative one is no play.
    pair.wheels.front().backlash = Number(Rational(-1));
    QVERIFY(lostMotionOf(Worked(pair)).plays[MeshOrdinal(0)].isZero());
  }

  /// The carrier of a planetary set with real teeth, sun and ring held: turned until no angle of the planet
  /// is left that touches neither.
  void planetarySetAgreesWithItsTeethInPoses() {
    const Mechanism mechanism = example("planetary-ring-held");
    const Worked worked(mechanism);
    const LostMotions motions = lostMotionOf(worked);
    const LostMotion& carrier = outputOf(motions, JointOrdinal(1));
    // The sum of both mesh equations with sun and ring at rest: (24 + 60) phi_c = e_7 + e_8.
    QCOMPARE(*carrier.worst, Rational(4, 25) / Rational(84));

    const Placement placement = placementOf(mechanism);
    const GearTrain train = toothedTrain(mechanism, shapedWheels(mechanism, placement));
    const auto gearOf = [&](int link) {
      return PlaneWheel(*std::find_if(train.gears.begin(), train.gears.end(),
                                      [&](const TrainGear& gear) { return int{gear.link} == link; }));
    };
    const PlaneWheel sun = gearOf(1);
    const PlaneWheel planet = gearOf(3);
    const PlaneWheel ring = gearOf(0);
    const double arm = (planet.center() - sun.center()).norm();
    // The angles of the planet that are free at an angle of the carrier, from the one that rolls on the sun.
    const auto isFree = [&](double carrierAngle) {
      const Eigen::Vector2d out(std::cos(carrierAngle), std::sin(carrierAngle));
      const Eigen::Vector2d center = sun.center() + arm * out;
      const double rolling = carrierAngle * (1 + 24.0 / 18);
      const auto hitsSun = [&](double angle) {
        return wheelsOverlap(planet, {center, rolling + angle}, sun, {sun.center(), 0},
                             sun.center() + 24 * out);
      };
      const auto hitsRing = [&](double angle) {
        return wheelsOverlap(planet, {center, rolling + angle}, ring, {ring.center(), 0},
                             sun.center() + 60 * out);
      };
      const double low = stopBefore(-0.02, hitsSun);
      const double high = stopBefore(0.02, hitsSun);
      for (int part = 0; part <= 60; ++part) {
        if (!hitsRing(low + (high - low) * part / 60)) return true;
      }
      return false;
    };
    QVERIFY(isFree(0));
    const double measured = stopBefore(0.004, [&](double angle) { return !isFree(angle); }) -
                            stopBefore(-0.004, [&](double angle) { return !isFree(angle); });
    QVERIFY2(std::abs(measured / carrier.worst->toDouble() - 1) < 0.02,
             qPrintable(QString::number(measured / carrier.worst->toDouble())));
  }

  void weightsAreTheTorquesOfTheTeeth() {
    int compared = 0;
    for (const char* name :
         {"robot", "planetary-ring-held", "reverted-train", "humpage-reduction", "ferguson-paradox"}) {
      const StaticsCase worked(example(name));
      const LostMotions motions = lostMotionOf(worked);
      QVERIFY(!motions.isShared);
      for (const LostMotion& output : motions.outputs) {
        StaticsProblem problem = StaticsCase::balancedIn(worked.analysis.choice.joints);
        problem.torques.push_back({StaticsCase::at(int{output.joint}), Rational(1)});
        const StaticsSolution solution = worked.solve(problem);
        for (const MeshOrdinal mesh : motions.plays.ordinals()) {
          const Real& torque = solution.values[static_cast<std::size_t>(int{mesh})];
          QCOMPARE(torque.fraction()->abs(), output.weights[mesh].abs());
          ++compared;
        }
      }
    }
    QVERIFY(compared > 30);
  }

  void equalPlanetsShareTheirPlay() {
    Mechanism three = planetary(20, 20, 3);
    three.inputs = {{three.turningJoints[JointOrdinal(0)].id, Number(1), {}},
                    {three.turningJoints[JointOrdinal(1)].id, Number(1), {}}};
    const LostMotions motions = lostMotionOf(Worked(three));
    QVERIFY(motions.isShared);
    Mechanism one = planetary(20, 20, 1);
    one.inputs = {{one.turningJoints[JointOrdinal(0)].id, Number(1), {}},
                  {one.turningJoints[JointOrdinal(1)].id, Number(1), {}}};
    const LostMotions alone = lostMotionOf(Worked(one));
    const Rational worst = *outputOf(alone, JointOrdinal(2)).worst;
    QCOMPARE(*outputOf(motions, JointOrdinal(2)).worst, worst);
    QVERIFY(!outputOf(motions, JointOrdinal(2)).rootOfSquares);
    // One planet with half of the play decides alone.
    Wheel tight;
    tight.id = WheelId("tight");
    tight.link = three.links[LinkOrdinal(5)].id;
    tight.backlash = Number(Rational(-1, 25));
    three.wheels.push_back(tight);
    three.gearMeshes[MeshOrdinal(2)].headWheel = tight.id;
    three.gearMeshes[MeshOrdinal(3)].tailWheel = tight.id;
    const LostMotions tightened = lostMotionOf(Worked(three));
    QVERIFY(outputOf(tightened, JointOrdinal(2)).worst->isZero());
  }

  void inputsGiveBackWhatOutputsLose() {
    const SnapshotPtr snapshot = analyzeLive(std::make_shared<const Mechanism>(example("robot")));
    const auto found = lostMotionCase(*snapshot);
    QVERIFY(found && found->motions);
    const LostMotions& motions = *found->motions;
    QCOMPARE(motions.held.size(), std::size_t{3});
    int moved = 0;
    for (std::size_t output = 0; output < motions.outputs.size(); ++output) {
      for (std::size_t input = 0; input < motions.held.size(); ++input) {
        const auto back = found->atInput(output, input);
        if (!back) continue;
        // Held at the output instead: the other inputs stay, and the same train turns this one.
        std::vector<int> others;
        for (std::size_t each = 0; each < motions.held.size(); ++each)
          others.push_back(each == input ? int{motions.outputs[output].joint} : int{motions.held[each]});
        const auto exchanged = lostMotions(*snapshot->mechanism, *snapshot->kinematics->model, others);
        QCOMPARE(*outputOf(*exchanged, motions.held[input]).worst, *back);
        ++moved;
      }
    }
    QVERIFY(moved > 3);
  }
};

QTEST_APPLESS_MAIN(LostMotionTest)
#include "test_lost_motion.moc"

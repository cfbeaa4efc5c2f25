#include <QTest>
#include <numbers>

#include "core/presentation/scene3d/animation.h"
#include "core/presentation/scene3d/exploded.h"
#include "core/presentation/scene3d/scene_lines.h"
#include "core/presentation/scene3d/traced_path.h"
#include "tests/ui/view3d/toy_stage.h"

namespace geargraph {
namespace {

constexpr double kTurn = 2 * std::numbers::pi;

/// Two equal wheels beside each other and a larger one in their plane, all on axes along z, and a fixed box.
std::shared_ptr<MechanismScene> rowStage() {
  auto stage = std::make_shared<MechanismScene>();
  const auto wheel = [](double radius) {
    return std::make_shared<const Solid>(revolvedSolid({{2, -3}, {radius, -3}, {radius, 3}, {2, 3}}, 24));
  };
  stage->scene.solids = {wheel(10), wheel(25),
                         std::make_shared<const Solid>(boxSolid({-5, -5, -5}, {5, 5, 5}))};
  const auto add = [&](std::size_t solid, const Eigen::Vector3d& at, const char* link, bool turns) {
    Instance instance;
    instance.solid = solid;
    instance.pose.translation() = at;
    instance.element = LinkId(link);
    stage->scene.instances.push_back(instance);
    SceneHandle handle;
    handle.direction = link[0] == '2' ? Eigen::Vector3d(0, 0, -1) : Eigen::Vector3d(0, 0, 1);
    if (turns) handle.gains = {1};
    stage->handles.push_back(handle);
  };
  add(0, {-30, 0, 0}, "1", true);
  add(0, {30, 0, 0}, "2", true);
  add(1, {0, 0, 0}, "3", true);
  add(2, {0, 60, 0}, "0", false);
  return stage;
}

}  // namespace

class StageMotionTest : public QObject {
  Q_OBJECT

 private slots:
  void partsInOnePlaneComeApartByTheirSizeAndEqualOnesStayTogether() {
    const auto stage = rowStage();
    const auto apart = explosionOffsets(*stage);
    QCOMPARE(apart[0], apart[1]);
    QCOMPARE(apart[3], Eigen::Vector3d(0, 0, 0));
    QVERIFY(apart[2].z() - apart[0].z() > 6);  // the thickness of both
    QVERIFY(std::abs(apart[2].z() + apart[0].z()) < 1e-9);
    QCOMPARE(apart[2].head<2>().norm(), 0.0);
  }

  void pullingApartBeginsWithNothingAndTurnsWithTheParts() {
    const auto stage = rowStage();
    const auto apart = explosionOffsets(*stage);
    std::vector<Pose> poses;
    for (const Instance& instance : stage->scene.instances) poses.push_back(instance.pose);
    const std::vector<Pose> before = poses;
    explode(stage->scene, apart, 0, poses);
    for (std::size_t i = 0; i < poses.size(); ++i) QVERIFY(poses[i].isApprox(before[i], 0));
    const Pose over(Eigen::AngleAxisd(kTurn / 4, Eigen::Vector3d::UnitX()));
    poses[2] = over * poses[2];
    explode(stage->scene, apart, 0.5, poses);
    const Eigen::Vector3d moved = poses[2].translation() - over * before[2].translation();
    QVERIFY((moved - 0.5 * (over * apart[2])).norm() < 1e-12);
  }

  void aStageThatStandsStillIsNotExploded() {
    MechanismScene still = *rowStage();
    still.handles.clear();
    for (const Eigen::Vector3d& move : explosionOffsets(still)) QCOMPARE(move, Eigen::Vector3d(0, 0, 0));
  }

  // The wheel turns by 1.5 rad/s: in 4 s a point 15 mm out travels 15 * 6 mm.
  void aTracedPathIsAsLongAsItsArc() {
    const MechanismScenePtr stage = test::toyStage();
    const std::vector<double> start{0};
    const TracedPath path = tracedPath(*stage, {0, {15, 0, 0}, std::nullopt}, start, 4);
    QVERIFY2(std::abs(path.length - 90) < 0.01, qPrintable(QString::number(path.length)));
    QCOMPARE(path.times.back(), 4.0);
    QCOMPARE(path.points.size(), path.times.size());
    for (const Eigen::Vector3d& point : path.points) {
      QVERIFY(std::abs((point - Eigen::Vector3d(0, -22, 0)).norm() - 15) < 1e-9);
    }
  }

  void seenFromItsOwnPartAPointStandsStill() {
    const MechanismScenePtr stage = test::toyStage();
    const std::vector<double> start{0.3};
    const TracedPath path = tracedPath(*stage, {0, {15, 0, 0}, std::size_t{0}}, start, 4);
    QVERIFY(path.length < 1e-9);
    QVERIFY((path.points.front() - Eigen::Vector3d(15, -22, 0)).norm() < 1e-9);
  }

  void aPathAsCsvHasALineAPoint() {
    const MechanismScenePtr stage = test::toyStage();
    const std::vector<double> start{0};
    const TracedPath path = tracedPath(*stage, {0, {15, 0, 0}, std::nullopt}, start, 4);
    const std::string csv = pathCsv(path, "mm");
    QVERIFY(csv.starts_with("time s,x mm,y mm,z mm\r\n0,15,-22,0\r\n"));
    QCOMPARE(static_cast<std::size_t>(std::count(csv.begin(), csv.end(), '\n')), path.points.size() + 1);
  }

  void aTrajectoryIsItsSamplesAndCubicBetweenThem() {
    const auto cubic = [](double t) { return InputTrajectory::Sample{t, {t * t * t - t}, {3 * t * t - 1}}; };
    const InputTrajectory trajectory({cubic(0), cubic(1), cubic(3)});
    for (const double time : {0.0, 0.25, 1.0, 1.5, 2.9, 3.0}) {
      const InputTrajectory::Sample at = trajectory.at(time);
      QVERIFY(std::abs(at.angles[0] - cubic(time).angles[0]) < 1e-12);
      QVERIFY(std::abs(at.speeds[0] - cubic(time).speeds[0]) < 1e-12);
    }
    QCOMPARE(trajectory.at(-1).angles[0], 0.0);
    QCOMPARE(trajectory.at(7).angles[0], 24.0);
  }

  void aTrajectoryMovesTheInputsOfAViewInsteadOfTheirSpeeds() {
    const auto stage = test::toyStage();
    using Sample = InputTrajectory::Sample;
    SceneView view;
    view.time = 1;
    view.turned = {0.5};
    // Half a turn in 2 s, from rest.
    view.trajectory = std::make_shared<const InputTrajectory>(
        std::vector<Sample>{{0, {0}, {0}}, {2, {kTurn / 2}, {kTurn / 2}}});
    QVERIFY(std::abs(inputAngles(*stage, view)[0] - (kTurn / 8 + 0.5)) < 1e-12);
    QVERIFY(std::abs(inputSpeeds(*stage, view)[0] - kTurn / 4) < 1e-12);
    const std::vector<double> start{0};
    const TracedPath path =
        tracedPath(*stage, {0, {15, 0, 0}, std::nullopt}, start, 2, view.trajectory.get());
    QVERIFY(std::abs(path.length - 15 * kTurn / 2) < 1e-3);
    // The animation runs along it and begins again.
    const Animation animation{AnimationKind::motion, 4, 24, 0};
    for (int picture = 0; picture < 4; ++picture)
      QCOMPARE(animationView(*stage, view, animation, picture).time,
               std::vector<double>({1, 1.5, 0, 0.5})[picture]);
    // One of two inputs is not this stage's.
    view.trajectory = std::make_shared<const InputTrajectory>(std::vector<Sample>{{0, {0, 0}, {0, 0}}});
    QCOMPARE(trajectoryOf(*stage, view), nullptr);
    QCOMPARE(inputAngles(*stage, view)[0], stage->inputSpeeds[0] + 0.5);
  }
};

}  // namespace geargraph

QTEST_GUILESS_MAIN(geargraph::StageMotionTest)
#include "test_stage_motion.moc"

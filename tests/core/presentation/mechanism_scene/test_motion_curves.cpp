#include <QTest>
#include <algorithm>
#include <cmath>

#include "core/presentation/mechanism_scene/mechanism_scene.h"
#include "core/presentation/scene3d/motion_curves.h"
#include "tests/core/support/example_files.h"

namespace geargraph {
namespace {

SnapshotPtr example(const char* name) {
  return analyzeLive(std::make_shared<const Mechanism>(test::example(name)));
}

const MotionCurve* curve(const std::vector<CurveSheet>& sheets, const std::string& name) {
  for (const CurveSheet& sheet : sheets) {
    for (const MotionCurve& each : sheet.curves) {
      if (each.name == name) return &each;
    }
  }
  return nullptr;
}

double spread(const MotionCurve& each) {
  const auto [low, high] = std::minmax_element(each.values.begin(), each.values.end());
  return *high - *low;
}

}  // namespace

class MotionCurvesTest : public QObject {
  Q_OBJECT

 private slots:
  void jointsTurnAsTheSolutionSays() {
    const SnapshotPtr robot = example("robot");
    GearCache cache;
    const MechanismScenePtr stage = mechanismScene(*robot, cache);
    const auto sheets = motionCurves(*stage, {}, {{}, false, stage->period});
    QCOMPARE(sheets.size(), std::size_t{1});
    QCOMPARE(sheets[0].unit, std::string("rad/s"));
    QCOMPARE(sheets[0].curves.size(), robot->mechanism->turningJoints.size());
    const LiveSolution& solution = *robot->matroid()->solution;
    for (std::size_t i = 0; i < sheets[0].curves.size(); ++i) {
      const MotionCurve& each = sheets[0].curves[i];
      QCOMPARE(each.name, "joint " + std::to_string(robot->mechanism->jointLabel(static_cast<int>(i))));
      QVERIFY(std::abs(each.values.front() - solution.rates[i]) < 1e-12);
      QCOMPARE(spread(each), 0.0);
    }
  }

  void alongATrajectorySpeedsAreItsOwn() {
    const SnapshotPtr pair = example("spur-pair");
    GearCache cache;
    const MechanismScenePtr stage = mechanismScene(*pair, cache);
    SceneView view;
    view.trajectory = std::make_shared<const InputTrajectory>(
        std::vector<InputTrajectory::Sample>{{0, {0}, {0}}, {2, {4}, {4}}});
    const auto sheets = motionCurves(*stage, view, {{}, false, 2});
    const auto gain = [&](std::size_t joint) { return stage->joints[joint].gains[0]; };
    QVERIFY(gain(1) != gain(0));
    for (std::size_t joint = 0; joint < 2; ++joint) {
      const MotionCurve& each = sheets[0].curves[joint];
      for (std::size_t i = 0; i < each.values.size(); ++i)
        QVERIFY(std::abs(each.values[i] - gain(joint) * 2 * sheets[0].times[i]) < 1e-9);
    }
  }

  void linksOfAPlaneTrainTurnSteadilyAndThoseOfTheRobotDoNot() {
    GearCache cache;
    const MechanismScenePtr planar = mechanismScene(*example("planetary-ring-held"), cache);
    std::set<ElementId> links;
    for (const Instance& part : planar->scene.instances) links.insert(part.element);
    for (const CurveSheet& sheet : motionCurves(*planar, {}, {links, true, planar->period})) {
      QVERIFY(!sheet.curves.empty());
      for (const MotionCurve& each : sheet.curves) {
        QVERIFY(spread(each) < 1e-9 && !each.isComponent);
        QVERIFY(each.name.starts_with("link "));
      }
    }
    const MechanismScenePtr robot = mechanismScene(*example("robot"), cache);
    const auto sheets = motionCurves(*robot, {}, {{LinkId("3")}, true, robot->period});
    const MotionCurve* whole = curve(sheets, "link 3");
    QVERIFY(whole != nullptr && sheets[0].curves.size() == 4);
    for (std::size_t i = 0; i < whole->values.size(); ++i) {
      double square = 0;
      for (const char* axis : {"x", "y", "z"}) {
        const double part = curve(sheets, std::string("link 3, ") + axis)->values[i];
        square += part * part;
      }
      QVERIFY(std::abs(std::sqrt(square) - whole->values[i]) < 1e-9);
    }
    QVERIFY(spread(*curve(sheets, "link 3, x")) > 0.1);
  }

  // The speed of a traced point, summed up, is the length of its path, which is measured by chords.
  void theSpeedOfAPointAddsUpToItsPath() {
    GearCache cache;
    const MechanismScenePtr stage = mechanismScene(*example("planetary-ring-held"), cache);
    const auto arm = std::find_if(stage->handles.begin(), stage->handles.end(),
                                  [](const SceneHandle& handle) { return !handle.gains.empty(); });
    const auto instance = static_cast<std::size_t>(arm - stage->handles.begin());
    const std::vector<double> start(stage->inputSpeeds.size(), 0);
    for (const std::optional<std::size_t> watcher : {std::optional<std::size_t>(), std::optional(instance)}) {
      SceneView view;
      for (std::size_t i = 0; i < stage->scene.instances.size(); ++i) {
        const TracedPoint point{i, {7, 3, 1}, watcher};
        view.traces.push_back(
            {stage->scene.instances[i].element, point, tracedPath(*stage, point, start, stage->period)});
      }
      const auto sheets = motionCurves(*stage, view, {{}, false, stage->period});
      const CurveSheet& points = sheets.back();
      QCOMPARE(points.unit, std::string("mm/s"));
      QCOMPARE(points.curves.size(), view.traces.size());
      for (std::size_t k = 0; k < view.traces.size(); ++k) {
        const std::vector<double>& speed = points.curves[k].values;
        double length = 0;
        for (std::size_t i = 1; i < speed.size(); ++i)
          length += 0.5 * (speed[i] + speed[i - 1]) * (points.times[i] - points.times[i - 1]);
        QVERIFY2(std::abs(length - view.traces[k].path.length) < 2e-3 * (1 + length),
                 qPrintable(QString("%1 %2").arg(length).arg(view.traces[k].path.length)));
      }
    }
  }

  void aSheetAsCsvHasAColumnACurve() {
    GearCache cache;
    const MechanismScenePtr stage = mechanismScene(*example("spur-pair"), cache);
    const auto sheets = motionCurves(*stage, {}, {{}, false, stage->period});
    const std::string csv = curvesCsv(sheets.front());
    QVERIFY(csv.starts_with("time s,\"joint 3 rad/s\",\"joint 4 rad/s\"\r\n0,"));
    QCOMPARE(static_cast<std::size_t>(std::count(csv.begin(), csv.end(), '\n')),
             sheets.front().times.size() + 1);
    MechanismScene still = *stage;
    still.place = {};
    QVERIFY(motionCurves(still, {}, {{}, false, 1}).empty());
  }
};

}  // namespace geargraph

QTEST_GUILESS_MAIN(geargraph::MotionCurvesTest)
#include "test_motion_curves.moc"

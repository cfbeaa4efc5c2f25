#include <pthread.h>

#include <QTemporaryDir>
#include <QtTest>
#include <algorithm>
#include <any>
#include <atomic>
#include <chrono>
#include <ctime>
#include <functional>
#include <future>
#include <thread>

#include "core/foundations/base/contract.h"
#include "core/machine/bodies/complete_train.h"
#include "core/machine/bodies/derived_geometry.h"
#include "core/presentation/meshfile/mesh_writer.h"
#include "core/presentation/painting/egl_host.h"
#include "core/presentation/schematic/schematic.h"
#include "core/presentation/simulators/simulator_model.h"
#include "core/presentation/train_stage/stage_picture.h"
#include "core/presentation/train_stage/train_stage.h"
#include "core/theory/dynamics/dynamics_report.h"
#include "core/theory/matroid/input_sets.h"
#include "core/theory/statics/efficiency_curve.h"
#include "tests/core/support/deep_train.h"
#include "tests/core/support/example_files.h"
#include "tests/core/support/extreme_documents.h"

namespace geargraph {
namespace {

using Seconds = std::chrono::duration<double>;
/// What it comes to is kept until it has ended, so that what it made is not given back in its time.
using Work = std::function<std::any(const std::stop_token&)>;

Seconds timeOn(clockid_t clock) {
  timespec time{};
  clock_gettime(clock, &time);
  return Seconds(static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec));
}

/// Processor time that work goes on for when it is asked to stop after `after` of it, so that it does not
/// matter what else the machine does. Below 0: it was done before.
Seconds overtime(const Work& work, Seconds after) {
  std::atomic<double> end = 0;
  std::promise<clockid_t> begun;
  std::promise<void> done;
  auto clock = begun.get_future();
  auto finished = done.get_future();
  std::jthread thread([&](const std::stop_token& stop) {
    clockid_t own{};
    pthread_getcpuclockid(pthread_self(), &own);
    begun.set_value(own);
    const std::any made = work(stop);
    end = timeOn(CLOCK_THREAD_CPUTIME_ID).count();
    done.set_value();
  });
  const clockid_t its = clock.get();
  const auto isDone = [&] {
    return finished.wait_for(std::chrono::milliseconds(1)) == std::future_status::ready;
  };
  while (!isDone()) {
    if (timeOn(its) < after) continue;
    const Seconds asked = timeOn(its);
    thread.request_stop();
    finished.wait();
    return Seconds(end.load()) - asked;
  }
  return Seconds(-1);
}

MechanismPtr shared(Mechanism mechanism) {
  return std::make_shared<const Mechanism>(std::move(mechanism));
}

}  // namespace

/// Each kind of long work, on the worst documents known, ends soon after it is cancelled.
class StoppingTest : public QObject {
  Q_OBJECT

  void exportsOf(const char* name, const Mechanism& mechanism) {
    GearCache gears;
    const StagePtr stage = trainStage(*analyzeLive(shared(mechanism)), gears, nullptr, nullptr);
    QTest::addRow("solids, %s", name) << Work([stage](const std::stop_token& stop) {
      MeshWriteOptions how;
      how.stop = stop;
      return std::any(encodedMesh(sceneOf(*stage, {}, stop), MeshFormat::glb, "train", how));
    });
  }

  /// A picture and an animation as the window exports them: of a stage that it has made ready, into a folder.
  void picturesOf(const char* name, const Mechanism& mechanism) {
    GearCache gears;
    const auto memory = std::make_shared<StageMemory>();
    StageRendering rendering;
    rendering.stage = trainStage(*analyzeLive(shared(mechanism)), gears, nullptr, memory.get());
    rendering.view.explosion = 0.5;
    const auto add = [&](const char* form) {
      QTest::addRow("%s, %s", form, name) << Work([this, rendering](const std::stop_token& stop) {
        RenderingRun run;
        run.stop = stop;
        return std::any(writePicture(rendering, m_folder.filePath("picture.png").toStdString(), run));
      });
    };
    add("picture");
    rendering.animation = Animation{AnimationKind::motion, 72, 24, 0};
    add("film");
    rendering.animation.reset();
    rendering.size = {3840, 2160};
    rendering.fits = false;
    add("large picture");
  }

  void worksOn(const char* name, const Mechanism& mechanism) {
    const MechanismPtr document = shared(mechanism);
    const SnapshotPtr live = analyzeLive(document);
    const auto add = [name](const char* work, const Work& run) {
      QTest::addRow("%s, %s", work, name) << run;
    };
    add("live", [document](const std::stop_token& stop) { return std::any(analyzeLive(document, 0, stop)); });
    // Each time of a geometry of which nothing but the placement is there.
    const auto underived = [live] {
      auto fresh = std::make_shared<AnalysisSnapshot>(*live);
      fresh->geometry = std::make_shared<const DerivedGeometry>(live->geometry->placed());
      return fresh;
    };
    add("exact and symbolic",
        [underived](const std::stop_token& stop) { return std::any(analyzeFully(underived(), {}, stop)); });
    add("stage", [underived](const std::stop_token& stop) {
      GearCache cache;
      return std::any(trainStage(*underived(), cache, nullptr, nullptr, stop));
    });
    add("train", [live](const std::stop_token& stop) {
      return std::any(trainOf(*live->mechanism, live->kinematics->placement(), stop));
    });
    add("schematic",
        [document](const std::stop_token& stop) { return std::any(schematicGeometry(*document, stop)); });
    add("inputs", [live](const std::stop_token& stop) {
      const MatroidAnalysis* matroid = live->matroid();
      if (matroid == nullptr) return std::any();
      const auto sets = InputSets::of(*live->kinematics->model, FusedField(), matroid->choice.joints, stop);
      if (!sets) return std::any();
      return std::any(std::pair(sets->count(stop), sets->list(1'000'000, stop)));
    });
  }

  /// Masses, the equation of motion, a motion that goes on for long, and models for simulators.
  void dynamicsOn(const char* name, const Mechanism& mechanism) {
    const SnapshotPtr live = analyzeLive(shared(mechanism));
    GEARGRAPH_REQUIRE(live->matroid() != nullptr && live->matroid()->solution);
    const Placement& placement = live->kinematics->placement();
    const auto train = std::make_shared<const GearTrain>(trainOf(*live->mechanism, placement));
    const auto prepared = [live, train](const std::stop_token& stop) {
      return dynamicsOf(*live->mechanism, *live->kinematics->model, live->kinematics->placement(),
                        *live->matroid(), *train, stop);
    };
    QTest::addRow("dynamics, %s", name)
        << Work([prepared](const std::stop_token& stop) { return std::any(prepared(stop).has_value()); });
    QTest::addRow("simulator model, %s", name) << Work([live, train](const std::stop_token& stop) {
      return std::any(simulatorModel(*live, *train, {}, stop));
    });
    const auto ready = std::make_shared<MechanismDynamics>(std::move(prepared({})->value()));
    QTest::addRow("motion, %s", name) << Work([ready](const std::stop_token& stop) {
      TrainDynamics dynamics(ready->train);
      SimulationOptions options;
      const auto inputs = static_cast<Eigen::Index>(ready->inputs.size());
      options.motors.assign(ready->inputs.size(), Motor{1, 1e-3});
      options.angles = options.speeds = Eigen::VectorXd::Zero(inputs);
      options.seconds = 1e4;
      options.interval = 0.1;
      return std::any(simulate(dynamics, options, stop));
    });
  }

  /// Torques under a load on the last joint, and the efficiency over that of the meshes.
  void staticsOn(const char* name, Mechanism mechanism) {
    mechanism.loads = {{{}, JointTorque{mechanism.turningJoints.back().id, Number(10)}}};
    const SnapshotPtr live = analyzeLive(shared(std::move(mechanism)));
    StaticsOptions options;
    options.losses = true;
    options.efficiency = Rational(49, 50);
    const auto solve = [live, options](const std::stop_token& stop) {
      return analyzeStatics(*live->mechanism, *live->kinematics->model, live->kinematics->placement(),
                            *live->kinematics->ttGraph, *live->matroid(), options, stop);
    };
    QTest::addRow("statics, %s", name)
        << Work([solve](const std::stop_token& stop) { return std::any(solve(stop)); });
    StaticsOptions plain = options;
    plain.symbolic = false;
    const auto report = std::make_shared<const StaticsReport>(
        *analyzeStatics(*live->mechanism, *live->kinematics->model, live->kinematics->placement(),
                        *live->kinematics->ttGraph, *live->matroid(), plain));
    QTest::addRow("efficiency curve, %s", name) << Work([live, report, plain](const std::stop_token& stop) {
      return std::any(efficiencyCurve(
          *live->mechanism, *live->kinematics->model, live->kinematics->placement(), *live->matroid(),
          *report, plain, CurveAxis::meshEfficiency, usualRange(CurveAxis::meshEfficiency), stop));
    });
  }

  QTemporaryDir m_folder;

 private slots:
  /// The system loads the driver once a process, which nothing stops.
  void initTestCase() { QVERIFY(EglHost::create().has_value()); }

  void workEndsWithinATenthOfASecond_data() {
    QTest::addColumn<Work>("work");
    worksOn("1,000 links", test::deepTrain(1, 1000));
    worksOn("180 links", test::deepTrain(2, 180));
    worksOn("many teeth", test::robotOfManyTeeth());
    worksOn("robot, far offsets", test::farOffsets("robot"));
    worksOn("gearbox, far offsets", test::farOffsets("eight-speed-gearbox"));
    exportsOf("180 links", test::deepTrain(2, 180));
    exportsOf("gearbox", test::example("eight-speed-gearbox"));
    picturesOf("1,000 links", test::deepTrain(1, 1000));
    picturesOf("gearbox", test::example("eight-speed-gearbox"));
    dynamicsOn("robot", test::example("robot"));
    dynamicsOn("180 links", test::deepTrain(2, 180));
    staticsOn("180 links", test::deepTrain(2, 180));
    staticsOn("1,000 links", test::deepTrain(1, 1000));
  }
  /// Where it takes longer it may be the machine: what cannot be stopped takes longer each time.
  void workEndsWithinATenthOfASecond() {
    QFETCH(Work, work);
    constexpr int kTries = 3;
    for (const double after : {0.002, 0.1, 0.8}) {
      Seconds more = overtime(work, Seconds(after));
      for (int again = 1; again < kTries && more >= Seconds(0.1); ++again)
        more = std::min(more, overtime(work, Seconds(after)));
      if (more < Seconds(0)) return;
      QVERIFY2(more < Seconds(0.1),
               qPrintable(QStringLiteral("%1 s more after %2 s").arg(more.count()).arg(after)));
    }
  }
};

}  // namespace geargraph

QTEST_GUILESS_MAIN(geargraph::StoppingTest)
#include "test_stopping.moc"

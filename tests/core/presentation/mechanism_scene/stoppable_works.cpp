#include "tests/core/presentation/mechanism_scene/stoppable_works.h"

#include "core/foundations/base/contract.h"
#include "core/machine/body_layout/complete_train.h"
#include "core/machine/body_layout/derived_geometry.h"
#include "core/presentation/gl_renderer/egl_host.h"
#include "core/presentation/mechanism_scene/mechanism_scene.h"
#include "core/presentation/mechanism_scene/scene_picture.h"
#include "core/presentation/meshfile/mesh_writer.h"
#include "core/presentation/schematic/schematic.h"
#include "core/presentation/simulators/simulator_model.h"
#include "core/theory/dynamics/dynamics_report.h"
#include "core/theory/matroid/input_sets.h"
#include "core/theory/statics/efficiency_curve.h"
#include "tests/core/support/deep_train.h"
#include "tests/core/support/example_files.h"
#include "tests/core/support/extreme_documents.h"

namespace geargraph::test {
namespace {

MechanismPtr shared(Mechanism mechanism) {
  return std::make_shared<const Mechanism>(std::move(mechanism));
}

class WorkList {
 public:
  explicit WorkList(std::filesystem::path folder) : m_folder(std::move(folder)) {
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

  [[nodiscard]] std::vector<NamedWork> take() { return std::move(m_works); }

 private:
  void add(const std::string& kind, const char* document, StoppableWork work) {
    m_works.push_back({kind + ", " + document, std::move(work)});
  }

  void exportsOf(const char* name, const Mechanism& mechanism) {
    GearCache gears;
    const MechanismScenePtr stage = mechanismScene(*analyzeLive(shared(mechanism)), gears, nullptr, nullptr);
    this->add("solids", name, [stage](const std::stop_token& stop) {
      MeshWriteOptions how;
      how.stop = stop;
      return std::any(encodedMesh(sceneOf(*stage, {}, stop), MeshFormat::glb, "train", how));
    });
  }

  /// A picture and an animation as the window exports them: of a stage that it has made ready, into a folder.
  void picturesOf(const char* name, const Mechanism& mechanism) {
    GearCache gears;
    const auto memory = std::make_shared<SceneMemory>();
    SceneRendering rendering;
    rendering.stage = mechanismScene(*analyzeLive(shared(mechanism)), gears, nullptr, memory.get());
    rendering.view.explosion = 0.5;
    const auto addAs = [&](const char* form) {
      this->add(form, name, [folder = m_folder, rendering](const std::stop_token& stop) {
        RenderingRun run;
        run.stop = stop;
        return std::any(writePicture(rendering, folder / "picture.png", run));
      });
    };
    addAs("picture");
    rendering.animation = Animation{AnimationKind::motion, 72, 24, 0};
    addAs("film");
    rendering.animation.reset();
    rendering.size = {3840, 2160};
    rendering.fits = false;
    addAs("large picture");
  }

  void worksOn(const char* name, const Mechanism& mechanism) {
    const MechanismPtr document = shared(mechanism);
    const SnapshotPtr live = analyzeLive(document);
    const auto add = [this, name](const char* work, const StoppableWork& run) { this->add(work, name, run); };
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
      return std::any(mechanismScene(*underived(), cache, nullptr, nullptr, stop));
    });
    add("train", [live](const std::stop_token& stop) {
      return std::any(trainOf(*live->mechanism, live->kinematics->placement(), stop));
    });
    add("schematic",
        [document](const std::stop_token& stop) { return std::any(schematicGeometry(*document, stop)); });
    add("inputs", [live](const std::stop_token& stop) {
      const MatroidAnalysis* matroid = live->matroid();
      if (matroid == nullptr) return std::any();
      const auto sets =
          InputSets::of(*live->kinematics->model, ModularDoubleField(), matroid->choice.joints, stop);
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
    this->add("dynamics", name,
              [prepared](const std::stop_token& stop) { return std::any(prepared(stop).has_value()); });
    this->add("simulator model", name, [live, train](const std::stop_token& stop) {
      return std::any(simulatorModel(*live, *train, {}, stop));
    });
    const auto ready = std::make_shared<MechanismDynamics>(std::move(prepared({})->value()));
    this->add("motion", name, [ready](const std::stop_token& stop) {
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
    this->add("statics", name, [solve](const std::stop_token& stop) { return std::any(solve(stop)); });
    StaticsOptions plain = options;
    plain.symbolic = false;
    const auto report = std::make_shared<const StaticsReport>(
        *analyzeStatics(*live->mechanism, *live->kinematics->model, live->kinematics->placement(),
                        *live->kinematics->ttGraph, *live->matroid(), plain));
    this->add("efficiency curve", name, [live, report, plain](const std::stop_token& stop) {
      return std::any(efficiencyCurve(
          *live->mechanism, *live->kinematics->model, live->kinematics->placement(), *live->matroid(),
          *report, plain, CurveAxis::meshEfficiency, usualRange(CurveAxis::meshEfficiency), stop));
    });
  }

  std::filesystem::path m_folder;
  std::vector<NamedWork> m_works;
};

}  // namespace

std::vector<NamedWork> stoppableWorks(const std::filesystem::path& folder) {
  GEARGRAPH_REQUIRE(EglHost::create().has_value());
  return WorkList(folder).take();
}

}  // namespace geargraph::test

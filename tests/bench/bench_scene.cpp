// The solids and the schematic of a train while a tooth count is dragged, each on the thread that makes it:
// all that a step of the drag asks of it. Every count is new, so that no answer is in a cache. And the draft
// frame of the solids.

#include <benchmark/benchmark.h>

#include <algorithm>

#include "core/design/collision/motion_diagnostics.h"
#include "core/foundations/base/contract.h"
#include "core/machine/body_layout/derived_geometry.h"
#include "core/mechanism/geometry_edits/fitted_edits.h"
#include "core/presentation/gl_renderer/egl_host.h"
#include "core/presentation/mechanism_scene/mechanism_scene.h"
#include "core/presentation/schematic/schematic.h"
#include "tests/core/support/deep_train.h"
#include "tests/core/support/example_files.h"

namespace geargraph {
namespace {

constexpr int kSteps = 70;

/// The snapshot before anything but the placement has been derived of it.
SnapshotPtr underived(const SnapshotPtr& snapshot) {
  auto fresh = std::make_shared<AnalysisSnapshot>(*snapshot);
  fresh->geometry = std::make_shared<const DerivedGeometry>(snapshot->geometry->placed());
  return fresh;
}

/// Live snapshots of a drag of the head's teeth of a mesh, `least` and on.
std::vector<SnapshotPtr> dragOf(const char* name, const MeshId& mesh, int least, int steps) {
  std::vector<SnapshotPtr> snapshots;
  Mechanism mechanism = test::example(name);
  for (int step = 0; step < steps; ++step) {
    auto fitted = withTeethFitted(mechanism, mesh, mechanism.find(mesh)->tailTeeth, least + step);
    GEARGRAPH_REQUIRE(fitted);
    mechanism = *std::move(fitted);
    snapshots.push_back(analyzeLive(std::make_shared<const Mechanism>(mechanism)));
  }
  return snapshots;
}

void stageOfADrag(benchmark::State& state, const char* name, const char* mesh, int least) {
  std::vector<SnapshotPtr> drag = dragOf(name, MeshId(mesh), least, kSteps);
  std::size_t step = drag.size();
  std::optional<GearCache> cache;
  std::optional<SceneMemory> memory;
  for (auto _ : state) {
    if (step == drag.size()) {
      state.PauseTiming();
      cache.emplace(1024);
      memory.emplace();
      std::transform(drag.begin(), drag.end(), drag.begin(), underived);
      benchmark::DoNotOptimize(mechanismScene(*drag.front(), *cache, nullptr, &*memory));
      step = 1;
      state.ResumeTiming();
    }
    benchmark::DoNotOptimize(mechanismScene(*drag[step++], *cache, nullptr, &*memory));
  }
}

/// The first stage of a train in space, every solid new; `links` beyond the bound of routed bodies, too.
/// Accept: 10 times the links at most 16 times the time.
void stageOfADeepTrain(benchmark::State& state) {
  SnapshotPtr snapshot =
      analyzeLive(std::make_shared<const Mechanism>(test::deepTrain(1, static_cast<int>(state.range(0)))));
  for (auto _ : state) {
    state.PauseTiming();
    snapshot = underived(snapshot);
    state.ResumeTiming();
    GearCache cache(1024);
    SceneMemory memory;
    benchmark::DoNotOptimize(mechanismScene(*snapshot, cache, nullptr, &memory));
  }
}

void schematicOfADrag(benchmark::State& state, const char* name, const char* mesh, int least) {
  const std::vector<SnapshotPtr> drag = dragOf(name, MeshId(mesh), least, kSteps);
  std::size_t step = 0;
  for (auto _ : state) {
    const SchematicGeometry geometry = schematicGeometry(*drag[step++ % drag.size()]->mechanism);
    benchmark::DoNotOptimize(schematicDrawing(geometry, {}));
  }
}

/// The draft frame at the new solids of a step, in the size that the 3D view has in a window of 1366x768:
/// upload, paint, read back. `simpler`: as where the processor is slow.
void draftFrameOfADrag(benchmark::State& state, const char* name, const char* mesh, int least, bool simpler) {
  auto host = EglHost::create();
  if (!host) return state.SkipWithError("no OpenGL");
  GearCache cache(1024);
  SceneMemory memory;
  std::vector<MechanismScenePtr> stages;
  for (const SnapshotPtr& snapshot : dragOf(name, MeshId(mesh), least, kSteps))
    stages.push_back(mechanismScene(*snapshot, cache, nullptr, &memory));
  Frame frame;
  frame.viewport = {560, 307};
  frame.style = RenderStyle::light().cheaper();
  frame.style.edges = !simpler;
  frame.style.litByVertex = simpler;
  frame.camera = Camera::home().fitted(outlineOf(stages.front()->scene), frame.viewport, 0.13);
  std::size_t step = 0;
  const auto renderFrame = [&] {
    (*host)->setScene(stages[step++ % stages.size()]->scene);
    benchmark::DoNotOptimize((*host)->picture(frame));
  };
  renderFrame();
  for (auto _ : state) renderFrame();
}

/// The check of a motion for collisions, from a snapshot on whose train nothing has asked for yet.
void motionCheck(benchmark::State& state, const char* name) {
  SnapshotPtr snapshot = analyzeLive(std::make_shared<const Mechanism>(test::example(name)));
  for (auto _ : state) {
    state.PauseTiming();
    snapshot = underived(snapshot);
    state.ResumeTiming();
    const auto report = checkMotion(*snapshot);
    GEARGRAPH_REQUIRE(report && report->check.isComplete);
    benchmark::DoNotOptimize(report);
  }
}

/// The same of random trains that are deep in space, where the budget may end it (then `complete` is 0).
void motionCheckOfADeepTrain(benchmark::State& state) {
  const auto links = static_cast<int>(state.range(0));
  SnapshotPtr snapshot = analyzeLive(std::make_shared<const Mechanism>(test::deepTrain(1, links)));
  for (auto _ : state) {
    state.PauseTiming();
    snapshot = underived(snapshot);
    state.ResumeTiming();
    const auto report = checkMotion(*snapshot);
    GEARGRAPH_REQUIRE(report);
    state.counters["complete"] = report->check.isComplete ? 1 : 0;
    state.counters["collisions"] = static_cast<double>(report->check.collisions.size());
  }
}

BENCHMARK(motionCheckOfADeepTrain)->Arg(30)->Arg(80)->Arg(300)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(motionCheck, robot, "robot")->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(motionCheck, eight_speed_gearbox, "eight-speed-gearbox")->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(stageOfADrag, robot, "robot", "15", 18)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(stageOfADrag, eight_speed_gearbox, "eight-speed-gearbox", "25", 20)
    ->Unit(benchmark::kMillisecond);
BENCHMARK(stageOfADeepTrain)
    ->Arg(100)
    ->Arg(200)
    ->Arg(300)
    ->Arg(1'000)
    ->Arg(3'000)
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(schematicOfADrag, robot, "robot", "15", 18)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(schematicOfADrag, eight_speed_gearbox, "eight-speed-gearbox", "25", 20)
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(draftFrameOfADrag, robot, "robot", "15", 18, false)
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime()
    ->MeasureProcessCPUTime();
BENCHMARK_CAPTURE(draftFrameOfADrag, robot_simpler, "robot", "15", 18, true)
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime()
    ->MeasureProcessCPUTime();
BENCHMARK_CAPTURE(draftFrameOfADrag, eight_speed_gearbox, "eight-speed-gearbox", "25", 20, false)
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime()
    ->MeasureProcessCPUTime();
BENCHMARK_CAPTURE(draftFrameOfADrag, eight_speed_gearbox_simpler, "eight-speed-gearbox", "25", 20, true)
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime()
    ->MeasureProcessCPUTime();

}  // namespace
}  // namespace geargraph

BENCHMARK_MAIN();

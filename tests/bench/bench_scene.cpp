// The solids and the schematic of a train while a tooth count is dragged, each on the thread that makes it:
// all that a step of the drag asks of it. Every count is new, so that no answer is in a cache.

#include <benchmark/benchmark.h>

#include "core/base/contract.h"
#include "core/fitting/fitted_edits.h"
#include "core/scene/train_stage.h"
#include "core/schematic/schematic.h"
#include "tests/core/support/example_files.h"

namespace geargraph {
namespace {

constexpr int kSteps = 70;  // more than ways are kept for (meridian_router.h)

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
  const std::vector<SnapshotPtr> drag = dragOf(name, MeshId(mesh), least, kSteps);
  std::size_t step = drag.size();
  std::optional<GearCache> cache;
  std::optional<StageMemory> memory;
  for (auto _ : state) {
    if (step == drag.size()) {
      state.PauseTiming();
      cache.emplace(1024);
      memory.emplace();
      benchmark::DoNotOptimize(trainStage(*drag.front(), *cache, nullptr, &*memory));
      step = 1;
      state.ResumeTiming();
    }
    benchmark::DoNotOptimize(trainStage(*drag[step++], *cache, nullptr, &*memory));
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

BENCHMARK_CAPTURE(stageOfADrag, robot, "robot", "15", 18)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(stageOfADrag, eight_speed_gearbox, "eight-speed-gearbox", "25", 20)
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(schematicOfADrag, robot, "robot", "15", 18)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(schematicOfADrag, eight_speed_gearbox, "eight-speed-gearbox", "25", 20)
    ->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace geargraph

BENCHMARK_MAIN();

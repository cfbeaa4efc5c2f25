// Gears of 40 teeth a second on one core, at the export tolerance of 0.002 modules, nothing cached.
//
// accept  5,000 spur or ring gears and 2,000 bevel gears a second; aim three times that
// accept  20 worms or worm wheels a second
//
// And what the teeth of the paper's robot have to say, its tooth counts times 1 to 2,500.
//
// accept  at 90,000 teeth at most 20 times the time of 36

#include <benchmark/benchmark.h>

#include "core/foundations/base/contract.h"
#include "core/machine/body_layout/complete_train.h"
#include "core/machine/solids/gear_solid.h"
#include "core/machine/teeth/worm.h"
#include "tests/core/support/trains.h"

namespace geargraph {
namespace {

GearSpec spec(GearKind kind, int teeth) {
  GearSpec gear = standardGear(kind, teeth, 2, 16);
  if (kind != GearKind::internal) gear.bore = teeth / 2.0;
  if (kind == GearKind::bevel) {
    gear.coneAngle = 1.1;
    gear.faceWidth = coneDistance(gear) / 3;
    gear.bore = teeth / 4.0;
  }
  return gear;
}

void solidsOf(benchmark::State& state, const GearSpec& gear, double tolerance) {
  GEARGRAPH_REQUIRE(gearSolid(gear, tolerance).has_value());
  std::size_t triangles = 0;
  for (auto _ : state) {
    const Expected<Solid> solid = gearSolid(gear, tolerance);
    triangles = solid->triangles.size();
    benchmark::DoNotOptimize(solid->positions.data());
  }
  state.SetItemsProcessed(state.iterations());
  state.counters["triangles"] = static_cast<double>(triangles);
}

void gearsASecond(benchmark::State& state, GearKind kind, double tolerance) {
  solidsOf(state, spec(kind, static_cast<int>(state.range(0))), tolerance);
}

/// A worm of these starts for a wheel of 40 teeth.
void wormsASecond(benchmark::State& state) {
  GearSpec wheel = wormWheelSpec(40, static_cast<int>(state.range(0)), 2, 10, 1, 0.35, 1);
  wheel.faceWidth = usualWheelFace(wheel);
  solidsOf(state, wormSpec(wheel.mateTeeth, 2, 10, 1, 0.35, usualWormLength(wheel)), kExportTolerance);
}

void wormWheelsASecond(benchmark::State& state) {
  GearSpec wheel = wormWheelSpec(40, static_cast<int>(state.range(0)), 2, 10, 1, 0.35, 1);
  wheel.faceWidth = usualWheelFace(wheel);
  solidsOf(state, wheel, kExportTolerance);
}

void cachedGear(benchmark::State& state) {
  GearCache cache;
  const GearSpec gear = spec(GearKind::external, 40);
  for (auto _ : state) benchmark::DoNotOptimize(cache.solid(gear, kExportTolerance));
}

void findings(benchmark::State& state) {
  Mechanism robot = test::robot();
  for (GearMesh& mesh : robot.gearMeshes) {
    mesh.tailTeeth *= static_cast<int>(state.range(0));
    mesh.headTeeth *= static_cast<int>(state.range(0));
  }
  const Placement placement = placementOf(robot);
  for (auto _ : state) benchmark::DoNotOptimize(trainDiagnostics(robot, placement));
}

BENCHMARK(findings)->Arg(1)->Arg(10)->Arg(100)->Arg(1000)->Arg(2500);
BENCHMARK_CAPTURE(gearsASecond, spur, GearKind::external, kExportTolerance)->Arg(8)->Arg(40)->Arg(100);
BENCHMARK_CAPTURE(gearsASecond, ring, GearKind::internal, kExportTolerance)->Arg(40)->Arg(100);
BENCHMARK_CAPTURE(gearsASecond, bevel, GearKind::bevel, kExportTolerance)->Arg(20)->Arg(40);
BENCHMARK_CAPTURE(gearsASecond, spurOnScreen, GearKind::external, kScreenTolerance)->Arg(40);
BENCHMARK_CAPTURE(gearsASecond, bevelOnScreen, GearKind::bevel, kScreenTolerance)->Arg(40);
BENCHMARK(wormsASecond)->Arg(1)->Arg(4);
BENCHMARK(wormWheelsASecond)->Arg(1)->Arg(4);
BENCHMARK(cachedGear);

}  // namespace
}  // namespace geargraph

BENCHMARK_MAIN();

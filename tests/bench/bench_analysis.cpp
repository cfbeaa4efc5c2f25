// The engine: live analysis, exact and symbolic solutions, forward kinematics. Peers in C++ are in
// bench_peers.cpp.

#include <benchmark/benchmark.h>

#include "core/foundations/base/contract.h"
#include "core/theory/analysis/analysis.h"
#include "core/theory/pose/forward_kinematics.h"
#include "core/theory/statics/circulation.h"
#include "core/theory/statics/live_statics.h"
#include "tests/bench/families.h"
#include "tests/core/support/trains.h"

namespace geargraph {
namespace {

using Family = Mechanism (*)(int links);

MechanismPtr shared(Mechanism mechanism) {
  return std::make_shared<const Mechanism>(std::move(mechanism));
}

void live(benchmark::State& state, Family family) {
  const MechanismPtr mechanism = shared(family(static_cast<int>(state.range(0))));
  for (auto _ : state) {
    const SnapshotPtr snapshot = analyzeLive(mechanism);
    GEARGRAPH_REQUIRE(snapshot->matroid() != nullptr && snapshot->matroid()->solution);
    benchmark::DoNotOptimize(snapshot);
  }
  state.SetComplexityN(state.range(0));
}
BENCHMARK_CAPTURE(live, tree, bench::drivenTree)->Arg(7)->RangeMultiplier(10)->Range(100, 10'000);
BENCHMARK_CAPTURE(live, coupled, bench::coupledTree)->RangeMultiplier(10)->Range(1'000, 10'000);
BENCHMARK_CAPTURE(live, undriven, bench::epicyclicTree)->RangeMultiplier(10)->Range(1'000, 10'000);
BENCHMARK_CAPTURE(live, nested, bench::nestedCarriers)->RangeMultiplier(10)->Range(100, 10'000);
BENCHMARK_CAPTURE(live, stacks, bench::coaxialStacks)->RangeMultiplier(10)->Range(100, 1'000);

void liveRobot(benchmark::State& state) {
  const MechanismPtr mechanism = shared(test::robot());
  for (auto _ : state) benchmark::DoNotOptimize(analyzeLive(mechanism));
}
BENCHMARK(liveRobot);

/// What the live analysis of a mechanism is made of, from its model on: rank, freedom, inputs, speeds.
void matroidOf(benchmark::State& state, const MechanismPtr& mechanism) {
  const SnapshotPtr snapshot = analyzeLive(mechanism);
  const LiveKinematics& kinematics = *snapshot->kinematics;
  for (auto _ : state) {
    benchmark::DoNotOptimize(analyzeMatroid(*mechanism, *kinematics.model, kinematics.placement()));
  }
}
void matroidOnly(benchmark::State& state, Family family) {
  matroidOf(state, shared(family(static_cast<int>(state.range(0)))));
}
BENCHMARK_CAPTURE(matroidOnly, tree, bench::drivenTree)->Arg(1'000)->Arg(10'000);
BENCHMARK_CAPTURE(matroidOnly, coupled, bench::coupledTree)->Arg(1'000)->Arg(10'000);

void matroidRobot(benchmark::State& state) {
  matroidOf(state, shared(test::robot()));
}
BENCHMARK(matroidRobot);

/// Torques beside the live analysis of the same train: a load on its last joint, held by the inputs.
void liveStatics(benchmark::State& state, Family family) {
  const MechanismPtr mechanism = shared(family(static_cast<int>(state.range(0))));
  const SnapshotPtr snapshot = analyzeLive(mechanism);
  const LiveKinematics& kinematics = *snapshot->kinematics;
  StaticsProblem problem;
  for (const int joint : snapshot->matroid()->choice.joints) problem.balances.push_back(TorquePlace{joint});
  problem.torques = {{TorquePlace{mechanism->t() - 1}, Rational(10)}};
  const ModularDoubleField field;
  for (auto _ : state) {
    const LoadPower power = LoadPower::of(*mechanism, *kinematics.model, kinematics.placement(), problem);
    const auto held = heldParts(*mechanism, *kinematics.model, kinematics.placement(), problem);
    const auto torques = solveStaticsLive(*kinematics.model, field, held, power.byLink);
    GEARGRAPH_REQUIRE(torques && torques->isBalanced);
    benchmark::DoNotOptimize(torques);
  }
}
BENCHMARK_CAPTURE(liveStatics, tree, bench::drivenTree)->Arg(1'000)->Arg(10'000);
BENCHMARK_CAPTURE(liveStatics, coupled, bench::coupledTree)->Arg(1'000)->Arg(10'000);

/// Where the power of that load goes, and what of it circulates, beside the live analysis of the same train.
void flowOfPower(benchmark::State& state, Family family) {
  const MechanismPtr mechanism = shared(family(static_cast<int>(state.range(0))));
  const SnapshotPtr snapshot = analyzeLive(mechanism);
  const KinematicModel& model = *snapshot->kinematics->model;
  const Placement& placement = snapshot->kinematics->placement();
  const MatroidAnalysis& matroid = *snapshot->matroid();
  StaticsProblem problem;
  for (const int joint : matroid.choice.joints) problem.balances.push_back(TorquePlace{joint});
  problem.torques = {{TorquePlace{mechanism->t() - 1}, Rational(10)}};
  const LoadPower power = LoadPower::of(*mechanism, model, placement, problem);
  const auto torques = solveStatics(model, heldParts(*mechanism, model, placement, problem), power.byLink);
  const auto motion = solveExact(model, matroid.choice.joints, matroid.speeds);
  GEARGRAPH_REQUIRE(torques && torques->isBalanced() && motion);
  for (auto _ : state) {
    const PowerFlow flow = powerFlow(*mechanism, model, placement, problem, *torques, {}, motion->rates);
    benchmark::DoNotOptimize(circulationsOf(*mechanism, model, placement, problem, *torques, flow));
  }
}
BENCHMARK_CAPTURE(flowOfPower, tree, bench::drivenTree)->Arg(1'000);
BENCHMARK_CAPTURE(flowOfPower, coupled, bench::coupledTree)->Arg(1'000);

void exact(benchmark::State& state, Family family) {
  const MechanismPtr mechanism = shared(family(static_cast<int>(state.range(0))));
  const SnapshotPtr snapshot = analyzeLive(mechanism);
  const MatroidAnalysis& matroid = *snapshot->matroid();
  const KinematicModel& model = *snapshot->kinematics->model;
  for (auto _ : state) {
    benchmark::DoNotOptimize(solveExact(model, matroid.choice.joints, matroid.speeds));
  }
}
BENCHMARK_CAPTURE(exact, tree, bench::drivenTree)->Arg(1'000);
BENCHMARK_CAPTURE(exact, coupled, bench::coupledTree)->Arg(1'000);

void symbolic(benchmark::State& state, Family family) {
  const MechanismPtr mechanism = shared(family(static_cast<int>(state.range(0))));
  const SnapshotPtr snapshot = analyzeLive(mechanism);
  const LiveKinematics& kinematics = *snapshot->kinematics;
  const MatroidAnalysis& matroid = *snapshot->matroid();
  const CoefficientMatrix coefficients(*mechanism, *kinematics.model, kinematics.placement());
  for (auto _ : state) {
    benchmark::DoNotOptimize(solveSymbolic(*mechanism, *kinematics.model, coefficients,
                                           matroid.independentMeshes, matroid.choice.joints));
  }
}
BENCHMARK_CAPTURE(symbolic, tree, bench::drivenTree)->Arg(7)->Arg(20)->Arg(80);
BENCHMARK_CAPTURE(symbolic, coupled, bench::coupledTree)->Arg(7)->Arg(20)->Arg(80);

void forwardKinematics(benchmark::State& state) {
  const MechanismPtr mechanism = shared(bench::epicyclicTree(static_cast<int>(state.range(0))));
  const SnapshotPtr snapshot = analyzeLive(mechanism);
  std::vector<TurningLine> lines(static_cast<std::size_t>(mechanism->t()));
  for (std::size_t i = 0; i < lines.size(); ++i) lines[i].point.x() = static_cast<double>(i);
  const ForwardKinematics kinematics(*snapshot->tree, lines);
  std::vector<double> angles(lines.size(), 0.25);
  std::vector<Eigen::Isometry3d> poses(mechanism->links.size());
  for (auto _ : state) {
    kinematics.place(angles, poses);
    benchmark::DoNotOptimize(poses.data());
  }
}
BENCHMARK(forwardKinematics)->Arg(1'000);

}  // namespace
}  // namespace geargraph

BENCHMARK_MAIN();

#include <benchmark/benchmark.h>

#include "core/theory/matroid/exact_solution.h"
#include "core/theory/matroid/input_sets.h"
#include "core/theory/matroid/symbolic_solution.h"
#include "tests/bench/families.h"
#include "tests/core/support/matroid_fixture.h"
#include "tests/core/support/trains.h"

// The matroid method alone, stage by stage; the whole analysis has its own benchmark. The argument is the
// number of links; a family a function.

using namespace geargraph;
using namespace geargraph::bench;
using geargraph::test::Worked;

namespace {

using Family = Mechanism (*)(int);

void placement(benchmark::State& state, Family family) {
  const Mechanism train = family(static_cast<int>(state.range(0)));
  for (auto _ : state) benchmark::DoNotOptimize(placementOf(train));
}

void live(benchmark::State& state, Family family) {
  Mechanism train = family(static_cast<int>(state.range(0)));
  const Worked first(train);
  train.inputs.emplace();
  for (const int joint : first.analysis.choice.joints) {
    train.inputs->push_back({train.turningJoints[joint].id, Number(1), {}});
  }
  const Worked worked(std::move(train));
  for (auto _ : state) {
    const auto model = KinematicModel::of(worked.graph, worked.tree, worked.placement);
    benchmark::DoNotOptimize(analyzeMatroid(worked.mechanism, *model, worked.placement));
  }
  state.counters["E"] = worked.analysis.dof;
  state.counters["rank"] = worked.analysis.rank;
}

void choosing(benchmark::State& state, Family family) {
  const Worked worked(family(static_cast<int>(state.range(0))));
  for (auto _ : state)
    benchmark::DoNotOptimize(analyzeMatroid(worked.mechanism, worked.model, worked.placement));
}

void exact(benchmark::State& state, Family family) {
  const Worked worked(family(static_cast<int>(state.range(0))));
  for (auto _ : state) {
    benchmark::DoNotOptimize(solveExact(worked.model, worked.analysis.choice.joints, worked.analysis.speeds));
  }
}

void symbolic(benchmark::State& state, Family family) {
  const Worked worked(family(static_cast<int>(state.range(0))));
  const CoefficientMatrix matrix(worked.mechanism, worked.model, worked.placement);
  int skipped = 0;
  for (auto _ : state) {
    const auto solution = solveSymbolic(worked.mechanism, worked.model, matrix,
                                        worked.analysis.independentMeshes, worked.analysis.choice.joints);
    skipped = solution ? solution->skipped : -1;
  }
  state.counters["skipped"] = skipped;
}

void countSets(benchmark::State& state, Family family) {
  const Worked worked(family(static_cast<int>(state.range(0))));
  const ModularDoubleField field;
  std::optional<Rational> count;
  for (auto _ : state) {
    count = InputSets::of(worked.model, field, worked.analysis.choice.joints)->count();
  }
  state.counters["counted"] = count ? count->toDouble() : -1;
}

BENCHMARK_CAPTURE(placement, tree, epicyclicTree)->Arg(1000)->Arg(10000)->Unit(benchmark::kMicrosecond);
Mechanism paper(int) {
  return test::robot();
}

BENCHMARK_CAPTURE(placement, robot, paper)->Arg(7)->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(live, robot, paper)->Arg(7)->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(live, tree, epicyclicTree)->Arg(100)->Arg(1000)->Arg(10000)->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(live, nested, nestedCarriers)->Arg(1000)->Arg(10000)->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(live, stacks, coaxialStacks)->Arg(1000)->Arg(10000)->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(choosing, tree, epicyclicTree)->Arg(1000)->Arg(10000)->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(choosing, stacks, coaxialStacks)->Arg(1000)->Arg(10000)->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(exact, tree, epicyclicTree)->Arg(1000)->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(exact, stacks, coaxialStacks)->Arg(1000)->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(symbolic, tree, epicyclicTree)->Arg(7)->Arg(20)->Arg(80)->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(symbolic, planetary, planetaryChain)->Arg(40)->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(countSets, tree, epicyclicTree)->Arg(1000)->Arg(10000)->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(countSets, nested, nestedCarriers)->Arg(1000)->Unit(benchmark::kMicrosecond);

}  // namespace

BENCHMARK_MAIN();

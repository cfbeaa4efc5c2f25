// Teeth for a ratio against four plain loops over the same teeth in the same run, whose formula is written
// for this train: Sandgren's gear train, 12 to 60 teeth. And the two-ring reducer of ratio 64.
//
// accept  a complete search of the gear train, with its counts and best choices, at most twice the time of
// the
//         loops, which only count what is within the tolerance

#include <benchmark/benchmark.h>

#include <chrono>
#include <cstdint>

#include "core/design/synthesis/set_sketch.h"
#include "core/design/teeth_search/teeth_search.h"
#include "core/foundations/base/contract.h"

namespace geargraph {
namespace {

Mechanism twoPairs() {
  SetSketch set("two pairs");
  const int input = set.link(0, "a", "input");
  const int counter = set.link(0, "b", "countershaft");
  const int output = set.link(0, "c", "output");
  set.mesh(input, counter, 20, 50, MeshKind::external);
  set.mesh(counter, output, 21, 60, MeshKind::external);
  return std::move(set).build();
}

Mechanism twoRings() {
  SetSketch set("two rings");
  const int sun = set.link(0, "a", "sun");
  const int ring = set.link(0, "a", "ring");
  const int other = set.link(0, "a", "other ring");
  const LinkOrdinal carrier = set.link(0, "a", "carrier");
  const int planet = set.link(carrier, "b", "planet");
  const WheelId one = set.wheel("p", planet);
  const WheelId second = set.wheel("q", planet);
  set.mesh(sun, planet, 24, 30, MeshKind::external).headWheel = one;
  set.mesh(planet, ring, 30, 84, MeshKind::internal).tailWheel = one;
  set.mesh(planet, other, 26, 80, MeshKind::internal).tailWheel = second;
  set.brake("A", ring);
  set.state("1", {"A"}, sun, other);
  return std::move(set).build();
}

constexpr const char* kSandgrenWish =
    R"({"ratios": [{"drive": "3", "driven": "1", "ratio": "1000/6931", "tolerance": "1/1000"}], "fewest": 12, "most": 60})";

TeethProblem problemOf(const Mechanism& train, const char* json) {
  const auto wish = readTeethWish(json, train);
  GEARGRAPH_REQUIRE(wish.has_value());
  auto problem = teethProblemOf(train, *wish);
  GEARGRAPH_REQUIRE(problem.has_value());
  return *std::move(problem);
}

/// Those within 1/1000 of 1000/6931.
std::int64_t plainLoops() {
  std::int64_t within = 0;
  for (std::int64_t a = 12; a <= 60; ++a) {
    for (std::int64_t b = 12; b <= 60; ++b) {
      for (std::int64_t c = 12; c <= 60; ++c) {
        for (std::int64_t d = 12; d <= 60; ++d) {
          const std::int64_t apart = 6931 * a * b - 1000 * c * d;
          if (apart <= c * d && -apart <= c * d) ++within;
        }
      }
    }
  }
  return within;
}

double secondsOf(const auto& work) {
  const auto start = std::chrono::steady_clock::now();
  work();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

void gearTrain(benchmark::State& state) {
  const TeethProblem problem = problemOf(twoPairs(), kSandgrenWish);
  double search = 0, loops = 0;
  for (auto _ : state) {
    TeethFound found;
    std::int64_t within = 0;
    search += secondsOf([&] { found = searchTeeth(problem); });
    loops += secondsOf([&] { benchmark::DoNotOptimize(within = plainLoops()); });
    GEARGRAPH_REQUIRE(found.counts.accepted == within);
  }
  state.counters["over loops"] = search / loops;
}
BENCHMARK(gearTrain)->Unit(benchmark::kMillisecond);

/// The search alone, beside the same choices in numpy (peers.py).
void sandgrenTeeth(benchmark::State& state) {
  const TeethProblem problem = problemOf(twoPairs(), kSandgrenWish);
  TeethSearchOptions options;
  options.most = 20;
  std::int64_t within = 0;
  for (auto _ : state) within = searchTeeth(problem, options).counts.accepted;
  state.counters["within"] = static_cast<double>(within);
}
BENCHMARK(sandgrenTeeth)->Unit(benchmark::kMillisecond);

void twoRingReducer(benchmark::State& state) {
  const TeethProblem problem = problemOf(
      twoRings(),
      R"({"ratios": [{"state": "1", "ratio": "64", "tolerance": "1/200"}], "most": 60, "mostRing": 120, "planets": 3})");
  for (auto _ : state) benchmark::DoNotOptimize(searchTeeth(problem).counts.accepted);
}
BENCHMARK(twoRingReducer)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace geargraph

BENCHMARK_MAIN();

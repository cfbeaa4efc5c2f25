#include <benchmark/benchmark.h>

#include <chrono>

#include "core/design/gearboxes/gearbox_run.h"
#include "core/design/gearboxes/hub_search.h"

// The search for gearboxes: what bounds in cells of the grid save, and what a layout of four sets costs.

using namespace geargraph;

namespace {

GearboxWish wishOf(const char* json) {
  return readGearboxWish(json).value();
}

const char* const kSixSpeed = R"({"forward": ["4.171", "2.340", "1.521", "1.143", "0.867", "0.691"],
  "reverse": "3.403", "tolerance": 0.01, "sets": ["simple", "ravigneaux"], "links": 6, "held": 1, "elements": 5})";
const char* const kEightSpeed =
    R"({"forward": ["4.696", "3.130", "2.104", "1.667", "1.285", "1", "0.839", "0.667"],
  "reverse": "3.297", "tolerance": 0.01, "sets": ["simple", "simple", "simple", "simple"], "links": 8,
  "freeInput": false, "elements": 5, "k": [1.5, 4.2]})";

/// Every `step`-th layout, with or without bounds; returns the seconds.
double secondsOf(SearchProblem problem, const std::vector<GearLayout>& layouts, std::size_t step,
                 bool prunes) {
  problem.prunes = prunes;
  SearchCounts counts;
  const auto start = std::chrono::steady_clock::now();
  for (std::size_t i = 0; i < layouts.size(); i += step)
    benchmark::DoNotOptimize(searchLayout(problem, layouts[i], counts));
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

/// `part`: the time of the search over that of the same search without bounds.
void pruning(benchmark::State& state) {
  const SearchProblem problem = searchProblem(wishOf(kSixSpeed));
  const auto layouts = gearLayouts(problem.limits).value();
  double bounded = 0;
  double unbounded = 0;
  for (auto _ : state) {
    bounded += secondsOf(problem, layouts, 40, true);
    unbounded += secondsOf(problem, layouts, 40, false);
  }
  state.counters["part"] = bounded / unbounded;
}

void sixSpeed(benchmark::State& state) {
  const GearboxWish wish = wishOf(kSixSpeed);
  for (auto _ : state) benchmark::DoNotOptimize(findGearboxes(wish));
}

void layoutOfFourSets(benchmark::State& state) {
  const SearchProblem problem = searchProblem(wishOf(kEightSpeed));
  const auto layouts = gearLayouts(problem.limits).value();
  SearchCounts counts;
  std::size_t next = 0;
  for (auto _ : state) {
    benchmark::DoNotOptimize(searchLayout(problem, layouts[next % layouts.size()], counts));
    next += 997;  // through the list, so that the mean is of all
  }
}

void sevenSpeedHub(benchmark::State& state) {
  const HubWish wish =
      readHubWish(R"({"ratios": ["0.632", "0.741", "0.843", "0.989", "1.145", "1.335", "1.545"],
    "sets": 2, "slack": 3})")
          .value();
  for (auto _ : state) benchmark::DoNotOptimize(findHubs(wish));
}

BENCHMARK(pruning)->Unit(benchmark::kMillisecond);
BENCHMARK(sixSpeed)->Unit(benchmark::kMillisecond);
BENCHMARK(layoutOfFourSets)->Unit(benchmark::kMicrosecond);
BENCHMARK(sevenSpeedHub)->Unit(benchmark::kMillisecond);

}  // namespace

BENCHMARK_MAIN();

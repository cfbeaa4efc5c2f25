// Exercise sheets: questions and their grading. Arguments of make: 0 the robot, 1 the eight-speed gearbox.

#include <benchmark/benchmark.h>

#include "core/presentation/exercise_sheets/sheet_report.h"
#include "core/presentation/page_layout/report_pdf.h"
#include "core/teaching/exercises/exercise_sheet.h"
#include "core/teaching/grading/grade.h"
#include "tests/core/support/example_files.h"

namespace geargraph {
namespace {

Mechanism mechanismOf(const benchmark::State& state) {
  return test::example(state.range(0) == 0 ? "robot" : "eight-speed-gearbox");
}

/// What is derived of the mechanism, once a sheet.
void source(benchmark::State& state) {
  const Mechanism mechanism = mechanismOf(state);
  for (auto _ : state) benchmark::DoNotOptimize(ExerciseSource(mechanism));
}

/// One variant with a question of every kind.
void variant(benchmark::State& state) {
  const ExerciseSource source(mechanismOf(state));
  const SheetPlan plan{"Sheet", offeredKinds(source), 2026, 1'000};
  int number = 0;
  for (auto _ : state) benchmark::DoNotOptimize(makeVariant(source, plan, 1 + number++ % 1'000));
  state.counters["questions"] = static_cast<double>(plan.kinds.size());
}

/// Wrong answers to all questions of a variant: every mistake is tried.
void grading(benchmark::State& state) {
  const ExerciseSource source(mechanismOf(state));
  const SheetVariant sheet = makeVariant(source, {"Sheet", offeredKinds(source), 2026, 1}, 1);
  std::vector<std::vector<std::string>> answers;
  for (const Question& question : sheet.questions) {
    answers.push_back(question.solution);
    answers.back().back() = "17";
  }
  for (auto _ : state) {
    for (std::size_t i = 0; i < answers.size(); ++i)
      benchmark::DoNotOptimize(grade(sheet.questions[i], answers[i]));
  }
  state.counters["questions"] = static_cast<double>(answers.size());
}

/// Its sheet as PDF, without drawings.
void pages(benchmark::State& state) {
  const ExerciseSource source(mechanismOf(state));
  const SheetPlan plan{"Sheet", offeredKinds(source), 2026, 1};
  const SheetVariant sheet = makeVariant(source, plan, 1);
  for (auto _ : state)
    benchmark::DoNotOptimize(reportPdf(sheetReport(source, plan, sheet, "", SheetForm::questions), {}));
}

BENCHMARK(source)->Arg(0)->Arg(1)->Unit(benchmark::kMillisecond);
BENCHMARK(variant)->Arg(0)->Arg(1)->Unit(benchmark::kMillisecond);
BENCHMARK(grading)->Arg(0)->Arg(1)->Unit(benchmark::kMillisecond);
BENCHMARK(pages)->Arg(0)->Arg(1)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace geargraph

BENCHMARK_MAIN();

// The renderer without a display: a picture of so many gears of 60 teeth, plain, smoothed, with its shadow,
// and a pick. Bars (quiet machine): four samples at most 2.8, with the shadow 4.5 times a plain picture; a
// pick 0.15 times.

#include <benchmark/benchmark.h>

#include "core/presentation/gl_renderer/egl_host.h"
#include "tests/bench/gear_field.h"

namespace geargraph {
namespace {

constexpr Viewport kView{1280, 720};

struct Field {
  std::unique_ptr<EglHost> host;
  Scene scene;
  Frame frame;

  Field(int count, int samples, bool shadow) : scene(bench::gearField(count)) {
    auto made = EglHost::create();
    if (!made) return;
    host = std::move(made).value();
    host->setScene(scene);
    frame.viewport = kView;
    frame.style = RenderStyle::light();
    frame.style.samples = samples;
    frame.style.contactShadow = shadow;
    frame.camera = Camera::from(-0.5, 0.6).fitted(cornersOf(scene), kView);
  }
};

void picture(benchmark::State& state, int samples, bool shadow) {
  Field field(static_cast<int>(state.range(0)), samples, shadow);
  if (field.host == nullptr) return state.SkipWithError("no OpenGL");
  benchmark::DoNotOptimize(field.host->picture(field.frame));  // shaders are compiled at first use
  double turn = 0.1;  // to and fro: a picture that stays is copied from the one before it
  for (auto _ : state) {
    field.frame.camera = field.frame.camera.orbited(turn = -turn, 0);
    benchmark::DoNotOptimize(field.host->picture(field.frame));
  }
}

/// What moves: other poses each time, nothing else.
void film(benchmark::State& state) {
  Field field(static_cast<int>(state.range(0)), 1, false);
  if (field.host == nullptr) return state.SkipWithError("no OpenGL");
  std::vector<Pose> poses;
  for (const Instance& instance : field.scene.instances) poses.push_back(instance.pose);
  field.frame.poses = poses;
  benchmark::DoNotOptimize(field.host->picture(field.frame));
  for (auto _ : state) {
    for (Pose& pose : poses) pose.rotate(Eigen::AngleAxisd(0.02, Eigen::Vector3d::UnitZ()));
    benchmark::DoNotOptimize(field.host->picture(field.frame));
  }
}

void pick(benchmark::State& state) {
  Field field(static_cast<int>(state.range(0)), 1, false);
  if (field.host == nullptr) return state.SkipWithError("no OpenGL");
  benchmark::DoNotOptimize(field.host->pick(field.frame, 640, 360));
  for (auto _ : state) benchmark::DoNotOptimize(field.host->pick(field.frame, 640, 360));
}

/// From nothing to a picture: context, shaders, upload, paint.
void firstPicture(benchmark::State& state) {
  for (auto _ : state) {
    Field field(static_cast<int>(state.range(0)), 4, true);
    if (field.host == nullptr) return state.SkipWithError("no OpenGL");
    benchmark::DoNotOptimize(field.host->picture(field.frame));
  }
}

BENCHMARK_CAPTURE(picture, plain, 1, false)->Arg(30)->Arg(300)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK_CAPTURE(picture, samples4, 4, false)
    ->Arg(30)
    ->Arg(300)
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();
BENCHMARK_CAPTURE(picture, samples4_shadow, 4, true)
    ->Arg(30)
    ->Arg(300)
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();
BENCHMARK(film)->Arg(30)->Arg(300)->Unit(benchmark::kMillisecond)->UseRealTime()->MeasureProcessCPUTime();
BENCHMARK(pick)->Arg(30)->Arg(300)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK(firstPicture)->Arg(30)->Unit(benchmark::kMillisecond)->UseRealTime();

}  // namespace
}  // namespace geargraph

BENCHMARK_MAIN();

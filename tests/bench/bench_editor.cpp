// From a mouse event to all views repainted, in a window on a document of 1,000 links. A frame is 16 ms.
// And how long the window does not answer while a document of 10,000 links comes up.
#include <benchmark/benchmark.h>
#include <unistd.h>

#include <QApplication>
#include <QElapsedTimer>
#include <QMenu>
#include <QSettings>
#include <QTemporaryDir>
#include <QTest>
#include <ctime>
#include <filesystem>
#include <fstream>
#include <map>
#include <random>

#include "core/foundations/base/contract.h"
#include "core/foundations/files/file.h"
#include "core/mechanism/document_format/mechanism_file.h"
#include "core/mechanism/geometry_edits/fitted_edits.h"
#include "core/mechanism/model/edits.h"
#include "core/theory/analysis/analysis.h"
#include "tests/bench/families.h"
#include "tests/core/support/deep_train.h"
#include "ui/canvas/digraph_view.h"
#include "ui/canvas/schematic_view.h"
#include "ui/mainwindow/document_files.h"
#include "ui/mainwindow/main_window.h"
#include "ui/panels/matrices_panel.h"
#include "ui/theme/application_theme.h"
#include "ui/view3d/view3d.h"

namespace geargraph {
namespace {

/// A train of n links, drawn row by row, to and fro, so that what is joined stands side by side.
Mechanism sheetOf(int n) {
  Mechanism mechanism = bench::nestedCarriers(n);
  const int side = static_cast<int>(std::ceil(std::sqrt(n + 1)));
  int place = 0;
  for (const Link& link : mechanism.links) {
    const int row = place / side;
    const int column = row % 2 == 0 ? place % side : side - 1 - place % side;
    mechanism.view.nodes[link.id] = {110.0 * column, 130.0 * row + (column % 2 == 0 ? 0 : 45)};
    ++place;
  }
  return mechanism;
}

/// The time that the processor has spent on this thread, in ms: what other programs take does not count.
double threadTime() {
  timespec time{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
  return 1e3 * static_cast<double>(time.tv_sec) + static_cast<double>(time.tv_nsec) / 1e6;
}

/// The time of the processor that threads have had, in ms: this one, those that stand for a graphics card,
/// and the busiest of the others. On a machine with enough cores the others work at the same time.
struct ThreadTimes {
  double window = 0;
  double painters = 0;
  std::map<std::string, double> others;

  static ThreadTimes now() {
    ThreadTimes times;
    times.window = threadTime();
    const std::string self = std::to_string(gettid());
    for (const auto& task : std::filesystem::directory_iterator("/proc/self/task")) {
      const std::string id = task.path().filename();
      std::string name;
      double nanoseconds = 0;
      std::getline(std::ifstream(task.path() / "comm"), name);
      std::ifstream(task.path() / "schedstat") >> nanoseconds;
      if (name.starts_with("llvmpipe")) {
        times.painters += nanoseconds / 1e6;
      } else if (id != self) {
        times.others[id] = nanoseconds / 1e6;
      }
    }
    return times;
  }
  [[nodiscard]] double busiestSince(const ThreadTimes& before) const {
    double most = 0;
    for (const auto& [id, time] : others) {
      const auto known = before.others.find(id);
      most = std::max(most, time - (known == before.others.end() ? 0 : known->second));
    }
    return most;
  }
};

/// An application that knows its longest event: as long as it takes, the window does not answer.
class WatchedApplication final : public QApplication {
 public:
  using QApplication::QApplication;

  bool notify(QObject* receiver, QEvent* event) override {
    if (m_inside) return QApplication::notify(receiver, event);
    m_inside = true;
    const std::string name = receiver->metaObject()->className();
    const int type = event->type();
    const double start = threadTime();
    const bool handled = QApplication::notify(receiver, event);
    const double taken = threadTime() - start;
    m_inside = false;
    if (taken > m_longest) {
      m_longest = taken;
      m_longestName = name + ", event " + std::to_string(type);
    }
    return handled;
  }

  void forget() { m_longest = 0; }
  [[nodiscard]] double longest() const { return m_longest; }  ///< ms
  [[nodiscard]] const std::string& longestName() const { return m_longestName; }

 private:
  bool m_inside = false;
  double m_longest = 0;
  std::string m_longestName;
};

/// The window, once for all benchmarks of a size.
class Stand {
 public:
  explicit Stand(const Mechanism& mechanism) {
    m_window.resize(1366, 768);
    m_window.document().replace(mechanism, {});
    m_window.show();
    settle();
    for (int i = 0; i < 12; ++i) m_window.digraph().zoomIn();
    settle();
  }

  [[nodiscard]] MainWindow& window() { return m_window; }
  [[nodiscard]] QWidget* sheet() { return m_window.digraph().viewport(); }

  void settle() {
    while (!m_window.isSettled()) QCoreApplication::processEvents(QEventLoop::WaitForMoreEvents);
    paint();
  }
  /// Until the live part of the newest analysis is in the views.
  void awaitLive() {
    while (!m_window.analysis().isUpToDate()) QCoreApplication::processEvents(QEventLoop::WaitForMoreEvents);
  }
  /// All that events have asked to be laid out and painted.
  static void paint() {
    QCoreApplication::sendPostedEvents();
    QCoreApplication::processEvents();
  }

  /// Two links that are in the view.
  [[nodiscard]] std::vector<QPoint> visibleLinks() {
    std::vector<QPoint> places;
    const QRect inside = sheet()->rect().adjusted(40, 40, -40, -40);
    for (const Outline& outline : m_window.digraph().displayList().outlines) {
      const auto* disc = std::get_if<Circle>(&outline.shape);
      if (disc == nullptr || outline.element.kind != ElementKind::link) continue;
      const QPoint at = m_window.digraph().mapFromScene(QPointF(disc->center.x, disc->center.y));
      if (inside.contains(at)) places.push_back(at);
    }
    return places;
  }

 private:
  MainWindow m_window;
};

std::map<int, std::unique_ptr<Stand>>& stands() {
  static std::map<int, std::unique_ptr<Stand>> all;
  return all;
}

Stand& standOf(int links) {
  auto& stand = stands()[links];
  if (!stand) stand = std::make_unique<Stand>(sheetOf(links));
  return *stand;
}

void hoverALink(benchmark::State& state) {
  Stand& stand = standOf(static_cast<int>(state.range(0)));
  const std::vector<QPoint> links = stand.visibleLinks();
  std::size_t next = 0;
  for (auto _ : state) {
    QTest::mouseMove(stand.sheet(), links[next++ % links.size()]);
    Stand::paint();
  }
}

/// One step of a drag: the edit, the live analysis of the whole document, all views painted.
void dragALink(benchmark::State& state) {
  Stand& stand = standOf(static_cast<int>(state.range(0)));
  const QPoint from = stand.visibleLinks().front();
  QTest::mouseMove(stand.sheet(), from);
  QTest::mousePress(stand.sheet(), Qt::LeftButton, {}, from);
  QTest::mouseMove(stand.sheet(), from + QPoint(5, 5));
  stand.settle();
  int step = 0;
  double edit = 0;
  double analysis = 0;
  double paint = 0;
  QElapsedTimer clock;
  const auto lap = [&clock] { return static_cast<double>(clock.nsecsElapsed()) / 1e6; };
  for (auto _ : state) {
    clock.start();
    QTest::mouseMove(stand.sheet(), from + QPoint(10 + step % 20, 10 + step / 20 % 20));
    ++step;
    edit += lap();
    clock.start();
    stand.awaitLive();
    analysis += lap();
    clock.start();
    Stand::paint();
    paint += lap();
  }
  using benchmark::Counter;
  state.counters["edit_ms"] = Counter(edit, Counter::kAvgIterations);
  state.counters["analysis_ms"] = Counter(analysis, Counter::kAvgIterations);
  state.counters["paint_ms"] = Counter(paint, Counter::kAvgIterations);
  QTest::mouseRelease(stand.sheet(), Qt::LeftButton, {}, from);
  stand.window().document().undoStack().undo();
  stand.settle();
}

/// One step of drawing a mesh: over a link the matrices show the column it would make.
void drawAMesh(benchmark::State& state) {
  Stand& stand = standOf(static_cast<int>(state.range(0)));
  const std::vector<QPoint> links = stand.visibleLinks();
  stand.window().digraph().setTool(ToolKind::gearMesh);
  QTest::mousePress(stand.sheet(), Qt::LeftButton, {}, links.front());
  std::size_t next = 1;
  for (auto _ : state) {
    QTest::mouseMove(stand.sheet(), links[1 + next++ % (links.size() - 1)]);
    Stand::paint();
  }
  QTest::keyClick(&stand.window().digraph(), Qt::Key_Escape);
  QTest::mouseRelease(stand.sheet(), Qt::LeftButton, {}, links.front());
  stand.window().digraph().setTool(ToolKind::select);
}

/// One step of a tooth count that is dragged: all that fits follows, and the matrices, the solution, the
/// schematic and the solids in the 3D view with it. Every count is new, so that nothing is in the cache.
void dragTeeth(benchmark::State& state, const QString& path, const MeshId& mesh, int least) {
  MainWindow window;
  window.resize(1366, 768);
  window.openDocument(path);
  window.show();
  const auto until = [](const auto& isThere) {
    while (!isThere()) QCoreApplication::processEvents(QEventLoop::WaitForMoreEvents);
  };
  until([&] { return window.isSettled(); });
  Stand::paint();
  until([&] { return window.view3d().isUpToDate(); });
  window.showDrawing(QStringLiteral("schematic"));  // behind another tab it would wait
  until([&] { return window.isSettled(); });
  std::map<std::string, double> parts;
  QElapsedTimer clock;
  const auto lap = [&](const char* part) {
    parts[part] += static_cast<double>(clock.nsecsElapsed()) / 1e6;
    clock.start();
  };
  int step = 0;
  const auto* schematic = window.findChild<SchematicView*>();
  const auto drag = [&] {
    const MechanismScenePtr before = window.view3d().stage();
    const int teeth = least + ++step % 40;
    QElapsedTimer seen;
    seen.start();
    clock.start();
    window.document().apply({QStringLiteral("Change teeth"),
                             [&](const PlacedMechanism& placed) {
                               const int other = placed.mechanism().find(mesh)->tailTeeth;
                               return withTeethFitted(placed, mesh, other, teeth);
                             },
                             0});
    lap("edit_ms");
    until([&] { return window.analysis().isUpToDate(); });
    lap("live_ms");
    until([&] { return window.view3d().stage() != before && schematic->isUpToDate(); });
    lap("stage_ms");
    Stand::paint();
    lap("paint_ms");
    until([&] { return window.view3d().isUpToDate(); });
    lap("picture_ms");
    parts["seen_ms"] += static_cast<double>(seen.nsecsElapsed()) / 1e6;  // all that moves has moved
    until([&] { return window.isSettled(); });
    lap("settled_ms");  // symbols, agreement and tooth diagnostics, for which nothing waits
  };
  // The first steps are no part of the measure: caches fill, and the view finds out how fine a draft frame
  // may be. So does everybody's first second of dragging.
  constexpr int kWarmUp = 8;
  while (step < kWarmUp) drag();
  parts.clear();
  const ThreadTimes start = ThreadTimes::now();
  for (auto _ : state) drag();
  const ThreadTimes end = ThreadTimes::now();
  parts["cpu_window_ms"] = end.window - start.window;
  parts["cpu_busiest_ms"] = end.busiestSince(start);
  parts["cpu_painters_ms"] = end.painters - start.painters;
  // Of the window's time, what painting the 3D view alone takes: with a graphics card hardly anything.
  QWidget* const canvas = window.view3d().findChild<QWidget*>("view3dCanvas");
  const double before = threadTime();
  for (int again = kWarmUp; again < step; ++again) {
    canvas->update();
    Stand::paint();
  }
  parts["cpu_repaint_ms"] = threadTime() - before;
  for (const auto& [part, taken] : parts) {
    state.counters[part] = benchmark::Counter(taken, benchmark::Counter::kAvgIterations);
  }
}

void analysisAlone(benchmark::State& state) {
  const auto mechanism = std::make_shared<const Mechanism>(sheetOf(static_cast<int>(state.range(0))));
  for (auto _ : state) benchmark::DoNotOptimize(analyzeLive(mechanism));
}

/// Digraph and matrices painted as a whole, which a drag never needs.
void paintingAlone(benchmark::State& state) {
  Stand& stand = standOf(static_cast<int>(state.range(0)));
  for (auto _ : state) {
    stand.sheet()->repaint();
    stand.window().matrices().repaint();
  }
}

/// A link is added to a drawing whose arrows run criss-cross: all else stays where it is.
void addALink(benchmark::State& state) {
  const int links = static_cast<int>(state.range(0));
  Mechanism tangled = sheetOf(links);
  std::mt19937 random(3);
  for (auto& [link, place] : tangled.view.nodes) {
    std::swap(place, tangled.view.nodes[tangled.links[random() % tangled.links.size()].id]);
  }
  Stand stand(tangled);
  Document& document = stand.window().document();
  double x = 0;
  for (auto _ : state) {
    document.apply({"Add a link", [x](const Mechanism& m) { return withLink(m, {-500, x}); }, 0});
    x += 100;
    state.PauseTiming();
    stand.settle();
    state.ResumeTiming();
  }
}

Mechanism deepTrain(int links) {
  return test::deepTrain(1, links);
}

/// From the file to a window that has all its views: the whole time, and the longest that it does not answer.
void openALargeDocument(benchmark::State& state, Mechanism (*trainOf)(int)) {
  const QTemporaryDir folder;
  const QString path = folder.filePath("large.geargraph");
  const Mechanism train = trainOf(static_cast<int>(state.range(0)));
  GEARGRAPH_REQUIRE(!writeFile(path.toStdString(), writeMechanism(train)));
  auto* const application = static_cast<WatchedApplication*>(QCoreApplication::instance());
  double longest = 0;
  std::string name;
  for (auto _ : state) {
    MainWindow window;
    window.resize(1366, 768);
    window.show();
    while (!window.isSettled()) QCoreApplication::processEvents(QEventLoop::WaitForMoreEvents);
    application->forget();
    // As from the menu: opening is itself one event.
    QMetaObject::invokeMethod(
        &window, [&] { window.openDocument(path); }, Qt::QueuedConnection);
    QCoreApplication::processEvents();
    while (!window.isSettled()) QCoreApplication::processEvents(QEventLoop::WaitForMoreEvents);
    Stand::paint();
    if (application->longest() > longest) {
      longest = application->longest();
      name = application->longestName();
    }
  }
  state.counters["stall_ms"] = longest;
  state.SetLabel(name);
}

/// How long the window does not answer, at most, in what one gesture brings about in a document of many
/// links, until all has come to rest.
void stallOf(benchmark::State& state, const std::function<void(MainWindow&, int)>& gesture) {
  auto& stand = stands()[10'000];
  if (!stand) stand = std::make_unique<Stand>(bench::drivenTree(10'000));
  MainWindow& window = stand->window();
  window.drawing().fit();
  stand->settle();
  auto* const application = static_cast<WatchedApplication*>(QCoreApplication::instance());
  double longest = 0;
  std::string name;
  int step = 0;
  for (auto _ : state) {
    application->forget();
    QMetaObject::invokeMethod(
        &window, [&] { gesture(window, step); }, Qt::QueuedConnection);
    QCoreApplication::processEvents();
    stand->settle();
    ++step;
    if (application->longest() > longest) {
      longest = application->longest();
      name = application->longestName();
    }
  }
  state.counters["stall_ms"] = longest;
  state.SetLabel(name);
}

void selectOrUnselectAll(MainWindow& window, int step) {
  step % 2 == 0 ? window.drawing().selectAll()
                : static_cast<void>(QTest::keyClick(&window.drawing(), Qt::Key_Escape));
}

void moveEverything(MainWindow& window, int step) {
  if (step == 0) window.drawing().selectAll();
  QTest::keyClick(&window.drawing(), step % 2 == 0 ? Qt::Key_Right : Qt::Key_Left);
}

void openAMenu(MainWindow& window, int step) {
  const auto& meshes = window.document().mechanism()->gearMeshes;
  const MeshId mesh = meshes[static_cast<std::size_t>(step) * 7 % meshes.size()].id;
  delete window.drawing().contextMenuFor(ElementId(mesh), {});
}

void changeTheme(MainWindow& window, int step) {
  window.setTheme(step % 2 == 0 ? Theme::dark : Theme::light);
}

BENCHMARK(addALink)->Arg(1000)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK_CAPTURE(openALargeDocument, tree, bench::drivenTree)
    ->Arg(1'000)
    ->Arg(3'000)
    ->Arg(10'000)
    ->Arg(30'000)
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime()
    ->Iterations(1);
BENCHMARK_CAPTURE(openALargeDocument, deep, deepTrain)
    ->Arg(1'000)
    ->Arg(3'000)
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime()
    ->Iterations(1);
BENCHMARK_CAPTURE(stallOf, select_or_unselect_all, selectOrUnselectAll)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(stallOf, move_everything, moveEverything)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(stallOf, open_a_menu, openAMenu)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(stallOf, change_theme, changeTheme)->Unit(benchmark::kMillisecond);
BENCHMARK(hoverALink)->Arg(1000)->Unit(benchmark::kMillisecond);
BENCHMARK(dragALink)->Arg(1000)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK(drawAMesh)->Arg(1000)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(dragTeeth, robot, robotExamplePath(), MeshId("15"), 18)
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();
BENCHMARK_CAPTURE(dragTeeth, eight_speed_gearbox, QStringLiteral(":/examples/eight-speed-gearbox.geargraph"),
                  MeshId("25"), 20)
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();
BENCHMARK(analysisAlone)->Arg(1000)->Unit(benchmark::kMillisecond);
BENCHMARK(paintingAlone)->Arg(1000)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace geargraph

int main(int argc, char** argv) {
  benchmark::Initialize(&argc, argv);
  geargraph::WatchedApplication application(argc, argv);
  const QTemporaryDir settings;
  QSettings::setPath(QSettings::NativeFormat, QSettings::UserScope, settings.path());
  geargraph::applyTheme(application, geargraph::Theme::light);
  benchmark::RunSpecifiedBenchmarks();
  geargraph::stands().clear();  // windows go before the application
  return 0;
}

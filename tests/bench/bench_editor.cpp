// From a mouse event to all views repainted, in a window on a document of 1,000 links. A frame is 16 ms.
#include <benchmark/benchmark.h>

#include <QApplication>
#include <QElapsedTimer>
#include <QSettings>
#include <QTemporaryDir>
#include <QTest>

#include "core/analysis/analysis.h"
#include "tests/bench/families.h"
#include "ui/canvas/digraph_view.h"
#include "ui/mainwindow/main_window.h"
#include "ui/panels/matrices_panel.h"
#include "ui/theme/application_theme.h"

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

/// The window, once for all benchmarks of a size.
class Stand {
 public:
  explicit Stand(int links) {
    m_window.resize(1366, 768);
    m_window.document().replace(sheetOf(links), {});
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
  if (!stand) stand = std::make_unique<Stand>(links);
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

BENCHMARK(hoverALink)->Arg(1000)->Unit(benchmark::kMillisecond);
BENCHMARK(dragALink)->Arg(1000)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK(drawAMesh)->Arg(1000)->Unit(benchmark::kMillisecond);
BENCHMARK(analysisAlone)->Arg(1000)->Unit(benchmark::kMillisecond);
BENCHMARK(paintingAlone)->Arg(1000)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace geargraph

int main(int argc, char** argv) {
  benchmark::Initialize(&argc, argv);
  QApplication application(argc, argv);
  const QTemporaryDir settings;
  QSettings::setPath(QSettings::NativeFormat, QSettings::UserScope, settings.path());
  geargraph::applyTheme(application, geargraph::Theme::light);
  benchmark::RunSpecifiedBenchmarks();
  geargraph::stands().clear();  // windows go before the application
  return 0;
}

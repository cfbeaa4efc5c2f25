#include <ctime>

#include "tests/ui/canvas/view_driver.h"

using namespace geargraph;

namespace {

/// The processor's time that an action takes, in ms: a busy machine does not count.
template <class Action>
double cost(Action action) {
  const std::clock_t start = std::clock();
  action();
  return 1000.0 * static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
}

double median(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  return values[values.size() / 2];
}

/// 1,000 links on a lawn, each carried by one near it, with 500 meshes between neighbours.
Mechanism largeMechanism() {
  Mechanism mechanism = test::randomTree(21, 999, 500);
  mechanism.view.nodes = layoutOf(mechanism);
  return mechanism;
}

}  // namespace

/// Frames of a drawing of 1,000 links, 1,499 arrows.
class TestCanvasFrames : public QObject {
  Q_OBJECT
 private slots:
  void initTestCase() { m_driver = std::make_unique<ViewDriver>(largeMechanism()); }

  void aDragFitsIntoAFrame() {
    ViewDriver& d = *m_driver;
    d.view.fit();
    const SheetPoint start = d.center(500);
    d.press(start);
    std::vector<double> frames;
    for (int i = 1; i <= 40; ++i) {
      frames.push_back(cost([&] {
        d.move(start + SheetPoint{300.0 * i, 100.0 * i});
        QCoreApplication::processEvents();
      }));
    }
    d.release(start);
    QCOMPARE(d.steps(), 1);
    report("drag", frames);
  }

  void aRepaintOfTheWholeFitsIntoAFrame() {
    ViewDriver& d = *m_driver;
    std::vector<double> frames;
    d.view.fit();
    for (int i = 0; i < 20; ++i) frames.push_back(cost([&] { d.view.viewport()->repaint(); }));
    report("whole drawing", frames);
    d.view.resetZoom();
    frames.clear();
    for (int i = 0; i < 20; ++i) frames.push_back(cost([&] { d.view.viewport()->repaint(); }));
    report("at its own size", frames);
  }

  void hoveringFitsIntoAFrame() {
    ViewDriver& d = *m_driver;
    d.view.fit();
    std::vector<double> frames;
    for (int i = 0; i < 40; ++i) {
      frames.push_back(cost([&] {
        d.hover(d.center(20 * i));
        QCoreApplication::processEvents();
      }));
    }
    report("hover", frames);
  }

  void cleanupTestCase() { m_driver.reset(); }

 private:
  static void report(const char* what, const std::vector<double>& frames) {
    const double middle = median(frames);
    qInfo("%s: median %.2f ms, %.0f %% of a frame", what, middle, middle / 0.16);
    QVERIFY2(middle < 16, what);
  }

  std::unique_ptr<ViewDriver> m_driver;
};

QTEST_MAIN(TestCanvasFrames)
#include "test_canvas_frames.moc"

#include "core/presentation/gl_renderer/egl_host.h"

#include <QTest>
#include <atomic>
#include <thread>

#include "tests/core/presentation/gl_renderer/small_scenes.h"

using namespace geargraph;

namespace {

/// A row of wheels: enough that the pictures of two threads overlap in time.
Scene wheels(int count, unsigned colour) {
  Scene scene;
  for (int i = 0; i < count; ++i)
    add(scene, revolvedSolid({{4, -3}, {15, -3}, {15, 3}, {4, 3}}, 64 + i), {0, 0, 5.0 * i}, colour, "2");
  return scene;
}

}  // namespace

class EglHostTest : public QObject {
  Q_OBJECT

 private slots:
  /// As two windows do, or a window and its export. A driver in software may not bear it (Mesa 22.3 crashed).
  void hostsPaintOnThreadsAtOnce() {
    constexpr int kRounds = 8;
    constexpr int kPictures = 4;
    const std::stop_source never;  // pictures that may be stopped take turns
    std::atomic<int> different = 0;
    const auto work = [&](int wheelsInRow, unsigned colour) {
      const Scene scene = wheels(wheelsInRow, colour);
      Frame frame = frameOf(scene, RenderStyle::light(), StandardView::isometric);
      frame.stop = never.get_token();
      std::vector<std::uint8_t> first;
      for (int round = 0; round < kRounds; ++round) {
        auto host = EglHost::create();
        if (!host) {
          ++different;
          return;
        }
        (*host)->setScene(scene);
        for (int i = 0; i < kPictures; ++i) {
          const VisibilityBuffer map = (*host)->seen(frame, 40, 30);
          if (map.columns != 40) ++different;
          const Image image = (*host)->picture(frame);
          if (first.empty()) first = image.rgba;
          if (image.rgba != first) ++different;
        }
      }
    };
    {
      const std::jthread one([&] { work(4, kOrange); });
      const std::jthread two([&] { work(9, kBlue); });
      const std::jthread three([&] { work(2, kGreen); });
    }
    QCOMPARE(different.load(), 0);
  }
};

QTEST_APPLESS_MAIN(EglHostTest)
#include "test_egl_host.moc"

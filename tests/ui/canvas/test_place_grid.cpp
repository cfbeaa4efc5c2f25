#include <QTest>
#include <algorithm>
#include <array>
#include <cmath>
#include <random>
#include <vector>

#include "ui/canvas/place_grid.h"

namespace geargraph {

class PlaceGridTest : public QObject {
  Q_OBJECT

 private slots:
  void theMiddleComesFirst() {
    PlaceGrid grid(3);
    QCOMPARE(grid.nearestFree(), std::optional(PlaceGrid::Place{0, 0}));
    grid.take({0, 0}, {0, 0});
    QCOMPARE(grid.nearestFree(), std::optional(PlaceGrid::Place{-1, -1}));
    grid.take({-9, 9}, {-1, 0});
    QCOMPARE(grid.nearestFree(), std::optional(PlaceGrid::Place{-1, 1}));
    grid.take({5, 9}, {-9, 9});    // outside
    grid.take({2, 1}, {-9, 9});    // between two places
    grid.take({NAN, 1}, {-9, 9});  // nowhere
    QCOMPARE(grid.nearestFree(), std::optional(PlaceGrid::Place{-1, 1}));
    grid.take({-INFINITY, INFINITY}, {-1e300, 1e300});
    QVERIFY(!grid.nearestFree());
  }

  void itFindsWhatLookingAtEveryRectangleFinds() {
    std::mt19937 random(5);
    constexpr int kRings = 6;
    int free = 0, full = 0;
    for (int round = 0; round < 400; ++round) {
      PlaceGrid grid(kRings);
      std::vector<std::array<int, 4>> rectangles;
      for (int i = 0; i < round; ++i) {
        const auto any = [&] { return static_cast<int>(random() % 19) - 9; };
        const int left = any(), top = any();
        const std::array<int, 4> box{left, left + static_cast<int>(random() % 9), top,
                                     top + static_cast<int>(random() % 9)};
        grid.take({double(box[0]), double(box[1])}, {double(box[2]), double(box[3])});
        rectangles.push_back(box);
      }
      const auto isFree = [&](int across, int down) {
        return std::none_of(rectangles.begin(), rectangles.end(), [&](const auto& box) {
          return across >= box[0] && across <= box[1] && down >= box[2] && down <= box[3];
        });
      };
      const auto found = grid.nearestFree();
      int nearest = kRings + 1;
      for (int across = -kRings; across <= kRings; ++across)
        for (int down = -kRings; down <= kRings; ++down)
          if (isFree(across, down)) nearest = std::min(nearest, std::max(std::abs(across), std::abs(down)));
      QCOMPARE(found.has_value(), nearest <= kRings);
      if (found) {
        QVERIFY(isFree(found->across, found->down));
        QCOMPARE(std::max(std::abs(found->across), std::abs(found->down)), nearest);
      }
      ++(found ? free : full);
    }
    QVERIFY(free > 0 && full > 0);
  }
};

}  // namespace geargraph

QTEST_APPLESS_MAIN(geargraph::PlaceGridTest)
#include "test_place_grid.moc"

#include <QTest>
#include <algorithm>
#include <numeric>
#include <random>

#include "core/machine/train/stack_order.h"

using namespace geargraph;

namespace {

/// Planes of thickness 10 with a gap of 2, all of which meet.
StackPlanes planes(std::size_t count) {
  StackPlanes stack;
  stack.thickness.assign(count, 10);
  stack.gap = 2;
  for (std::size_t p = 0; p < count; ++p) {
    stack.meets.emplace_back(count, true);
    stack.meets.back()[p] = false;
  }
  return stack;
}

/// Links 1..n + 1 in a row, link k in the planes k - 2 and k - 1, on two axes in turn.
StackPlanes chain(std::size_t count, const std::vector<int>& drawnAs) {
  StackPlanes stack = planes(count);
  for (int link = 1; link <= static_cast<int>(count) + 1; ++link) {
    for (const int plane : {link - 2, link - 1}) {
      if (plane >= 0 && plane < static_cast<int>(count))
        stack.wheels.push_back({drawnAs[static_cast<std::size_t>(plane)], link, link % 2, 0});
    }
  }
  return stack;
}

}  // namespace

class StackOrderTest : public QObject {
  Q_OBJECT

 private slots:
  void aWheelBetweenTwoOfAnotherLinkIsEnclosed() {
    StackPlanes stack = planes(3);
    stack.wheels = {{0, 1, 0, 0}, {1, 2, 0, 0}, {2, 1, 0, 0}};
    QCOMPARE(enclosedCount(stack, {0, 12, 24}), 1);
    QCOMPARE(enclosedCount(stack, {0, 24, 12}), 0);
    stack.wheels[1].axisGroup = 1;  // beside
    QCOMPARE(enclosedCount(stack, {0, 12, 24}), 0);
    stack.covers = {{1, 0, 0}};  // but so large that the axis passes through it
    QCOMPARE(enclosedCount(stack, {0, 12, 24}), 1);
    QCOMPARE(enclosedCount(stack, {0, 24, 12}), 0);
  }

  /// A carrier with a wheel below has its arm below what it carries.
  void armsAreWhereTheyEncloseLess() {
    StackPlanes stack = planes(2);
    stack.wheels = {{0, 3, 0, 0}, {1, 1, 0, 0}, {1, 4, 1, 0}};
    stack.carriers = {{3, 0, {1}}};
    QCOMPARE(enclosedCount(stack, {0, 12}), 0);
    QCOMPARE(enclosedCount(stack, {12, 0}), 0);
    stack.wheels.push_back({1, 3, 0, 30});  // another of its wheels above: now the sun is between
    QCOMPARE(enclosedCount(stack, {0, 12}), 1);
  }

  /// In whatever order a chain of links is drawn, it is stacked link by link: by a look at every order, and
  /// plane by plane where there are many.
  void chainsComeInTheirOrder() {
    std::mt19937 random(1);
    for (const std::size_t count : {2U, 3U, 4U, 5U, 6U, 7U, 8U}) {
      std::vector<int> drawnAs(count);
      std::iota(drawnAs.begin(), drawnAs.end(), 0);
      for (int again = 0; again < 10; ++again) {
        std::shuffle(drawnAs.begin(), drawnAs.end(), random);
        const StackPlanes stack = chain(count, drawnAs);
        const std::vector<double> heights = stackedHeights(stack);
        QCOMPARE(enclosedCount(stack, heights), 0);
        const auto [low, high] = std::minmax_element(heights.begin(), heights.end());
        QCOMPARE(*high - *low, 12.0 * static_cast<double>(count - 1));
      }
    }
  }

  /// Planes that do not meet share a level.
  void theLowestStackIsTaken() {
    StackPlanes stack = planes(3);
    stack.meets[0][2] = stack.meets[2][0] = false;
    stack.wheels = {{0, 1, 0, 0}, {1, 2, 0, 0}, {2, 3, 1, 0}};
    const std::vector<double> heights = stackedHeights(stack);
    QCOMPARE(heights[0], heights[2]);
    QCOMPARE(std::abs(heights[1] - heights[0]), 12.0);
  }
};

QTEST_APPLESS_MAIN(StackOrderTest)
#include "test_stack_order.moc"

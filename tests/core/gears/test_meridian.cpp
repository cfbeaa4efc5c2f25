#include <QtTest>

#include "core/gears/meridian_outline.h"
#include "core/gears/meridian_router.h"

using namespace geargraph;

namespace {

/// Columns by rows, all free; rows count from the axis.
MeridianGrid freeGrid(int columns, int rows) {
  MeridianGrid grid;
  grid.columns = columns;
  grid.rows = rows;
  grid.owner.assign(static_cast<std::size_t>(columns * rows), MeridianGrid::kFree);
  grid.plates.assign(static_cast<std::size_t>(columns), true);
  grid.width.assign(static_cast<std::size_t>(columns), 1);
  grid.rowCost.assign(static_cast<std::size_t>(rows), 1);
  return grid;
}

MeridianNet joining(std::vector<int> cells) {
  MeridianNet net;
  for (const int c : cells) net.groups.push_back({MeridianLanding{{c}, {}, 0}});
  return net;
}

bool apart(const std::vector<MeridianRoute>& routes) {
  std::vector<int> all;
  for (const MeridianRoute& route : routes) {
    std::vector<int> own = route.cells;
    std::sort(own.begin(), own.end());
    own.erase(std::unique(own.begin(), own.end()), own.end());
    all.insert(all.end(), own.begin(), own.end());
  }
  std::sort(all.begin(), all.end());
  return std::adjacent_find(all.begin(), all.end()) == all.end();
}

}  // namespace

class TestMeridian : public QObject {
  Q_OBJECT
 private slots:
  /// The first net's shortest way would shut the second in; it gives way.
  void netsGoRoundEachOther() {
    const MeridianGrid grid = freeGrid(5, 3);
    const std::vector<MeridianNet> nets{joining({grid.cell(0, 1), grid.cell(4, 1)}),
                                        joining({grid.cell(2, 0), grid.cell(2, 2)})};
    const auto routes = routeMeridian(grid, nets);
    QVERIFY(!routes.has_value());  // one of them has to cross the other: a plane has no bridges
    const std::vector<MeridianNet> passing{joining({grid.cell(0, 1), grid.cell(4, 1)}),
                                           joining({grid.cell(2, 0), grid.cell(2, 1)})};
    const auto found = routeMeridian(grid, passing);
    QVERIFY(found.has_value());
    QVERIFY(apart(*found));
    QCOMPARE(found->at(0).cells.size(), std::size_t{7});  // over the second, by the outmost row
  }

  void whatIsBlockedIsNotEntered() {
    MeridianGrid grid = freeGrid(3, 3);
    for (int r = 0; r < 2; ++r)
      grid.owner[static_cast<std::size_t>(grid.cell(1, r))] = MeridianGrid::kBlocked;
    const auto routes = routeMeridian(grid, {joining({grid.cell(0, 0), grid.cell(2, 0)})});
    QVERIFY(routes.has_value());
    for (const int c : routes->front().cells) QVERIFY(grid.columnOf(c) != 1 || grid.rowOf(c) == 2);
  }

  /// Through a column too narrow for a disc a way runs along the axis only.
  void narrowColumnsHaveNoDiscs() {
    MeridianGrid grid = freeGrid(2, 2);
    grid.plates.assign(2, false);
    QVERIFY(!routeMeridian(grid, {joining({grid.cell(0, 0), grid.cell(1, 1)})}).has_value());
    grid.plates[1] = true;
    QVERIFY(routeMeridian(grid, {joining({grid.cell(0, 0), grid.cell(1, 1)})}).has_value());
  }

  /// What a landing keeps free stays free, of its own net, too.
  void landingsKeepTheirRoom() {
    const MeridianGrid grid = freeGrid(3, 3);
    MeridianNet net = joining({grid.cell(0, 2)});
    net.needsSupport = true;
    net.supports = {{{grid.cell(0, 0)}, {grid.cell(0, 1)}, 0}, {{grid.cell(2, 0)}, {grid.cell(2, 1)}, 0}};
    const auto routes = routeMeridian(grid, {net});
    QVERIFY(routes.has_value());
    const auto& cells = routes->front().cells;
    const int kept = routes->front().support == 0 ? grid.cell(0, 1) : grid.cell(2, 1);
    QVERIFY(std::find(cells.begin(), cells.end(), kept) == cells.end());
  }

  /// An L of cells: six corners, material on the left, the area of its cells.
  void outlinesAreClosedAndCounterClockwise() {
    const MeridianGrid grid = freeGrid(3, 3);
    std::vector<bool> inside(9, false);
    for (const int c : {grid.cell(0, 0), grid.cell(0, 1), grid.cell(1, 0)})
      inside[static_cast<std::size_t>(c)] = true;
    const OutlinePlaces places{
        [&](int cell, int side) { return grid.columnOf(cell) + (side > 0 ? 1.0 : 0.0); },
        [&](int cell, int side) { return grid.rowOf(cell) + (side > 0 ? 1.0 : 0.0); }};
    const auto outlines = outlinesOf(grid, inside, places);
    QCOMPARE(outlines.size(), std::size_t{1});
    QCOMPARE(outlines.front().size(), std::size_t{6});
    double twice = 0;
    for (std::size_t i = 0; i < outlines.front().size(); ++i) {
      const Circle& a = outlines.front()[i];
      const Circle& b = outlines.front()[(i + 1) % outlines.front().size()];
      twice += a.radius * b.height - b.radius * a.height;
    }
    QCOMPARE(twice / 2, 3.0);
  }

  /// A cell whose edge reaches farther than its neighbour's makes a step within its own bounds.
  void edgesStepWhereTheirPlacesChange() {
    const MeridianGrid grid = freeGrid(1, 2);
    const OutlinePlaces places{
        [&](int cell, int side) { return side > 0 ? (grid.rowOf(cell) == 1 ? 1.5 : 0.8) : 0.2; },
        [&](int cell, int side) { return grid.rowOf(cell) + (side > 0 ? 0.9 : 0.1); }};
    const auto outlines = outlinesOf(grid, {true, true}, places);
    QCOMPARE(outlines.size(), std::size_t{1});
    QCOMPARE(outlines.front().size(), std::size_t{6});
    for (const Circle& c : outlines.front()) QVERIFY(c.height < 1 || c.radius > 1.05);
  }
};

QTEST_APPLESS_MAIN(TestMeridian)
#include "test_meridian.moc"

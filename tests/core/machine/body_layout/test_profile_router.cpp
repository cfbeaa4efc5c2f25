#include <QTest>
#include <numeric>
#include <random>
#include <thread>

#include "core/machine/body_layout/profile_outline.h"
#include "core/machine/body_layout/profile_router.h"
#include "core/machine/body_layout/profile_search.h"

using namespace geargraph;

namespace {

/// Columns by rows, all free; rows count from the axis.
ProfileGrid freeGrid(int columns, int rows) {
  ProfileGrid grid;
  grid.columns = columns;
  grid.rows = rows;
  grid.owner.assign(static_cast<std::size_t>(columns * rows), ProfileGrid::kFree);
  grid.plates.assign(static_cast<std::size_t>(columns), true);
  grid.width.assign(static_cast<std::size_t>(columns), 1);
  grid.rowCost.assign(static_cast<std::size_t>(rows), 1);
  return grid;
}

ProfileNet joining(std::vector<CellOrdinal> cells) {
  ProfileNet net;
  for (const CellOrdinal c : cells) net.groups.push_back({RouteTerminal{{c}, {}, 0}});
  return net;
}

/// Some cells blocked, columns of three widths, some too narrow for a disc, sleeves' rows cheap.
ProfileGrid randomGrid(std::mt19937& random) {
  ProfileGrid grid = freeGrid(12, 9);
  for (NetOrdinal& owner : grid.owner) {
    if (random() % 4 == 0) owner = ProfileGrid::kBlocked;
  }
  for (std::size_t c = 0; c < 12; ++c) {
    grid.width[c] = std::array{0.5, 1.0, 3.0}.at(random() % 3);
    grid.plates[c] = random() % 5 > 0;
  }
  for (std::size_t r = 0; r < 3; ++r) grid.rowCost[r] = 0.2;
  return grid;
}

constexpr double kUnreached = 1e300;

/// What a step costs; nothing: it cannot be made.
std::optional<double> stepPrice(const ProfileGrid& grid, const ByCell<double>& extra, int from, int to) {
  const int c = grid.columnOf(from), r = grid.rowOf(from);
  const int along = std::abs(c - grid.columnOf(to)), across = std::abs(r - grid.rowOf(to));
  const auto row = static_cast<std::size_t>(r), column = static_cast<std::size_t>(c);
  if (grid.owner[static_cast<std::size_t>(to)] != ProfileGrid::kFree || along + across != 1) return {};
  const double there = extra[static_cast<std::size_t>(to)];
  if (along == 1) return grid.width[column] * (1 + grid.rowCost[row]) + there;
  return grid.plates[column] ? std::optional(grid.rowCost[row] + there) : std::nullopt;
}

/// All costs by steps until nothing gets cheaper.
std::vector<double> costsOf(const ProfileGrid& grid, const ByCell<double>& extra,
                            const ProfileSearch::Places& sources) {
  std::vector<double> costs(grid.owner.size(), kUnreached);
  for (const auto& [cell, cost] : sources) {
    double& known = costs[static_cast<std::size_t>(cell)];
    known = std::min(known, cost);
  }
  for (bool changed = true; changed;) {
    changed = false;
    for (std::size_t a = 0; a < costs.size(); ++a) {
      for (std::size_t b = 0; b < costs.size() && costs[a] < kUnreached; ++b) {
        const auto price = stepPrice(grid, extra, static_cast<int>(a), static_cast<int>(b));
        if (!price || costs[a] + *price >= costs[b]) continue;
        costs[b] = costs[a] + *price;
        changed = true;
      }
    }
  }
  return costs;
}

bool apart(const ByNet<ProfileRoute>& routes) {
  std::vector<CellOrdinal> all;
  for (const ProfileRoute& route : routes) {
    std::vector<CellOrdinal> own = route.cells;
    std::sort(own.begin(), own.end());
    own.erase(std::unique(own.begin(), own.end()), own.end());
    all.insert(all.end(), own.begin(), own.end());
  }
  std::sort(all.begin(), all.end());
  return std::adjacent_find(all.begin(), all.end()) == all.end();
}

}  // namespace

class ProfileRouterTest : public QObject {
  Q_OBJECT
 private slots:
  /// The first net's shortest way would shut the second in; it gives way.
  void netsGoRoundEachOther() {
    const ProfileGrid grid = freeGrid(5, 3);
    const ByNet<ProfileNet> nets{joining({grid.cell(0, 1), grid.cell(4, 1)}),
                                 joining({grid.cell(2, 0), grid.cell(2, 2)})};
    const auto routes = routeProfiles(grid, nets);
    QVERIFY(!routes.has_value());  // one of them has to cross the other: a plane has no bridges
    const ByNet<ProfileNet> passing{joining({grid.cell(0, 1), grid.cell(4, 1)}),
                                    joining({grid.cell(2, 0), grid.cell(2, 1)})};
    const auto found = routeProfiles(grid, passing);
    QVERIFY(found.has_value());
    QVERIFY(apart(*found));
    QCOMPARE(found->at(0).cells.size(), std::size_t{7});  // over the second, by the outmost row
  }

  /// The long net comes first, and its cheapest way leads over the only cells where the short one can land:
  /// it leaves them free in the first round already.
  void netsLeaveFreeWhereOthersLand() {
    const ProfileGrid grid = freeGrid(9, 6);
    const ByNet<ProfileNet> nets{joining({grid.cell(0, 0), grid.cell(8, 0)}),
                                 joining({grid.cell(4, 0), grid.cell(4, 1)})};
    const auto routes = routeProfiles(grid, nets, 1);
    QVERIFY(routes.has_value());
    QVERIFY(apart(*routes));
    QCOMPARE(routes->at(0).cells.size(), std::size_t{13});  // by the third row
    QCOMPARE(routes->at(1).cells.size(), std::size_t{2});
  }

  /// Four nets that lie about one another by chance: most find their ways, which nothing but what stood in
  /// the way of others in the rounds before can show them.
  void netsGiveWay() {
    std::mt19937 random(11);
    int solved = 0;
    for (int problem = 0; problem < 200; ++problem) {
      const ProfileGrid grid = freeGrid(12, 9);
      std::vector<int> cells(grid.owner.size());
      std::iota(cells.begin(), cells.end(), 0);
      std::shuffle(cells.begin(), cells.end(), random);
      ByNet<ProfileNet> nets;
      for (std::size_t n = 0; n < 4; ++n)
        nets.push_back(joining({cells[3 * n], cells[3 * n + 1], cells[3 * n + 2]}));
      const auto routes = routeProfiles(grid, nets);
      if (!routes) continue;
      ++solved;
      QVERIFY(apart(*routes));
      for (std::size_t n = 0; n < 12; ++n) {
        const auto& own = routes->at(n / 3).cells;
        QVERIFY(std::find(own.begin(), own.end(), cells[n]) != own.end());
      }
    }
    QVERIFY2(solved >= 80, qPrintable(QString::number(solved)));
  }

  /// The analysis and the 3D view ask at once; one works, the other waits.
  void threadsThatAskTogetherHearTheSame() {
    const ProfileGrid grid = freeGrid(7, 5);
    const ByNet<ProfileNet> nets{joining({grid.cell(0, 1), grid.cell(6, 1)}),
                                 joining({grid.cell(2, 0), grid.cell(2, 1)})};
    std::vector<std::size_t> cells(4, 0);
    {
      std::vector<std::jthread> threads;
      for (std::size_t& count : cells) {
        threads.emplace_back([&grid, &nets, &count] {
          const auto found = routeProfiles(grid, nets);
          if (found && apart(*found)) count = found->at(0).cells.size();
        });
      }
    }
    QVERIFY(cells.front() > 0);
    QCOMPARE(cells, std::vector<std::size_t>(4, cells.front()));
  }

  /// Beside steps until nothing gets cheaper: the same costs to the last bit, and of equal ways the one over
  /// the cheaper cell, then the first.
  void theSearchFindsTheCheapestWays() {
    std::mt19937 random(4);
    int found = 0;
    for (int round = 0; round < 60; ++round) {
      const ProfileGrid grid = randomGrid(random);
      ByCell<double> extra(108, 0);
      for (double& cost : extra) cost = round % 2 == 0 ? 0 : static_cast<double>(random() % 1000) / 250;
      const auto place = [&] { return static_cast<int>(random() % 108); };
      ProfileSearch::Places sources, ends;
      while (sources.size() < 2) {
        const int cell = place();
        if (grid.owner[static_cast<std::size_t>(cell)] == ProfileGrid::kFree)
          sources.emplace_back(cell, static_cast<double>(sources.size()) / 2);
      }
      for (int e = 0; e < 4; ++e) ends.emplace_back(place(), static_cast<double>(random() % 40) / 4);
      const std::vector<double> costs = costsOf(grid, extra, sources);
      const auto total = [&](const auto& end) {
        return costs[static_cast<std::size_t>(end.first)] + end.second;
      };
      const auto nearest = *std::min_element(
          ends.begin(), ends.end(), [&](const auto& a, const auto& b) { return total(a) < total(b); });
      ProfileSearch search(grid);
      const ProfileBits bits(grid);
      const bool isReached = std::any_of(ends.begin(), ends.end(), [&](const auto& end) {
        return costs[static_cast<std::size_t>(end.first)] < kUnreached;
      });
      QCOMPARE(search.begin(ProfileOwners(grid, bits), {}, extra, sources, ends), isReached);
      if (!isReached) continue;
      while (!search.isDone() && !search.isBeyond(total(nearest))) (void)search.settleBucket();
      if (costs[static_cast<std::size_t>(nearest.first)] == kUnreached) continue;
      ++found;
      for (int c = nearest.first; c >= 0; c = search.from(c)) {
        QCOMPARE(search.cost(c), costs[static_cast<std::size_t>(c)]);
        std::pair<double, CellOrdinal> best{kUnreached, -1};
        for (int b = 0; b < 108 && search.from(c) >= 0; ++b) {
          const auto price = stepPrice(grid, extra, b, c);
          const double cost = costs[static_cast<std::size_t>(b)];
          if (price && cost + *price == search.cost(c)) best = std::min(best, {cost, CellOrdinal(b)});
        }
        QCOMPARE(search.from(c), best.second);
      }
    }
    QVERIFY(found > 30);
  }

  /// Columns of several words of bits: a way is known of ahead where steps lead from the source to the end.
  void whetherAWayLeadsThereIsKnownAhead() {
    std::mt19937 random(7);
    int reached = 0;
    for (int round = 0; round < 300; ++round) {
      ProfileGrid grid = freeGrid(4, 150);
      for (NetOrdinal& owner : grid.owner) {
        if (random() % 20 == 0) owner = ProfileGrid::kBlocked;
      }
      for (std::size_t c = 0; c < 4; ++c) grid.plates[c] = random() % 3 > 0;
      const int source = static_cast<int>(random() % 600), end = static_cast<int>(random() % 600);
      const std::vector<CellOrdinal> own{source};
      std::vector<bool> seen(600, false);
      std::vector<int> waiting{source};
      while (!waiting.empty()) {
        const int cell = waiting.back();
        waiting.pop_back();
        if (seen[static_cast<std::size_t>(cell)]) continue;
        seen[static_cast<std::size_t>(cell)] = true;
        for (const int next : {cell - 1, cell + 1, cell - 150, cell + 150}) {
          if (next >= 0 && next < 600 && stepPrice(grid, ByCell<double>(600, 0), cell, next))
            waiting.push_back(next);
        }
      }
      const ProfileBits bits(grid);
      ProfileSearch search(grid);
      const bool found =
          search.begin(ProfileOwners(grid, bits), {own}, ByCell<double>(600, 0), {{source, 0}}, {{end, 0}});
      QCOMPARE(found, seen[static_cast<std::size_t>(end)]);
      reached += found ? 1 : 0;
    }
    QVERIFY(reached > 50 && reached < 250);
  }

  void freeRunsAreLookedAtWordByWord() {
    ProfileGrid grid = freeGrid(2, 150);
    grid.owner[static_cast<std::size_t>(grid.cell(1, 128))] = 0;
    const ProfileBits bits(grid);
    ProfileOwners owners(grid, bits);
    QVERIFY(owners.isFree(grid.above(0, 0)));
    QVERIFY(!owners.isFree(grid.above(1, 5)) && !owners.isFree(grid.above(1, 128)));
    QVERIFY(owners.isFree(grid.above(1, 129)));
    QVERIFY(owners.isFree({grid.cell(1, 3), grid.cell(1, 128)}));
    QVERIFY(owners.isFree({grid.cell(1, 128), grid.cell(1, 128)}));  // nothing
    owners.block({grid.cell(0, 60), grid.cell(0, 70)});
    QVERIFY(!owners.isFree({grid.cell(0, 69), grid.cell(0, 72)}) && owners.isFree(grid.above(0, 70)));
    owners.give(grid.cell(0, 100), 3);
    QVERIFY(owners.isOpen(grid.cell(0, 100), 3) && !owners.isOpen(grid.cell(0, 100), 2));
    QVERIFY(!owners.isFree(grid.above(0, 70)));
  }

  void whatIsBlockedIsNotEntered() {
    ProfileGrid grid = freeGrid(3, 3);
    for (int r = 0; r < 2; ++r) grid.owner[static_cast<std::size_t>(grid.cell(1, r))] = ProfileGrid::kBlocked;
    const auto routes = routeProfiles(grid, {joining({grid.cell(0, 0), grid.cell(2, 0)})});
    QVERIFY(routes.has_value());
    for (const int c : routes->front().cells) QVERIFY(grid.columnOf(c) != 1 || grid.rowOf(c) == 2);
  }

  /// Through a column too narrow for a disc a way runs along the axis only.
  void narrowColumnsHaveNoDiscs() {
    ProfileGrid grid = freeGrid(2, 2);
    grid.plates.assign(2, false);
    QVERIFY(!routeProfiles(grid, {joining({grid.cell(0, 0), grid.cell(1, 1)})}).has_value());
    grid.plates[1] = true;
    QVERIFY(routeProfiles(grid, {joining({grid.cell(0, 0), grid.cell(1, 1)})}).has_value());
  }

  /// What a terminal keeps free stays free, of its own net, too.
  void terminalsKeepTheirCells() {
    const ProfileGrid grid = freeGrid(3, 3);
    ProfileNet net = joining({grid.cell(0, 2)});
    net.needsSupport = true;
    net.supports = {{{grid.cell(0, 0)}, {grid.cell(0, 1), grid.cell(0, 2)}, 0},
                    {{grid.cell(2, 0)}, {grid.cell(2, 1), grid.cell(2, 2)}, 0}};
    const auto routes = routeProfiles(grid, {net});
    QVERIFY(routes.has_value());
    const auto& cells = routes->front().cells;
    const int kept = routes->front().support == 0 ? grid.cell(0, 1) : grid.cell(2, 1);
    QVERIFY(std::find(cells.begin(), cells.end(), kept) == cells.end());
  }

  /// An L of cells: six corners, material on the left, the area of its cells.
  void outlinesAreClosedAndCounterClockwise() {
    const ProfileGrid grid = freeGrid(3, 3);
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
      const ProfileVertex& a = outlines.front()[i];
      const ProfileVertex& b = outlines.front()[(i + 1) % outlines.front().size()];
      twice += a.radius * b.height - b.radius * a.height;
    }
    QCOMPARE(twice / 2, 3.0);
  }

  /// A cell whose edge reaches farther than its neighbour's makes a step within its own bounds.
  void edgesStepWhereTheirPlacesChange() {
    const ProfileGrid grid = freeGrid(1, 2);
    const OutlinePlaces places{
        [&](int cell, int side) { return side > 0 ? (grid.rowOf(cell) == 1 ? 1.5 : 0.8) : 0.2; },
        [&](int cell, int side) { return grid.rowOf(cell) + (side > 0 ? 0.9 : 0.1); }};
    const auto outlines = outlinesOf(grid, {true, true}, places);
    QCOMPARE(outlines.size(), std::size_t{1});
    QCOMPARE(outlines.front().size(), std::size_t{6});
    for (const ProfileVertex& c : outlines.front()) QVERIFY(c.height < 1 || c.radius > 1.05);
  }
};

QTEST_APPLESS_MAIN(ProfileRouterTest)
#include "test_profile_router.moc"

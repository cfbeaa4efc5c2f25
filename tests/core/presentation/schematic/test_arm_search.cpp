#include <QTest>
#include <queue>
#include <random>

#include "core/presentation/schematic/arm_router.h"
#include "core/presentation/schematic/arm_search.h"

using namespace geargraph;

namespace {

struct End {
  std::size_t node = 0;
  double price = 0;
};

/// The textbook's search: settles states one by one, the cheapest first, then the first. A state is a node
/// and how it was reached; behind them come the targets that have a price.
std::optional<ArmSearch::Way> dijkstra(const ArmGrid& grid, const ArmEdgeWeights& weights,
                                       const std::vector<End>& starts, const std::vector<End>& ends) {
  const std::size_t columns = grid.columns(), states = 2 * grid.nodes();
  std::vector<double> best(states + ends.size(), std::numeric_limits<double>::infinity());
  std::vector<std::optional<std::size_t>> from(best.size());
  using Front = std::pair<double, std::size_t>;
  std::priority_queue<Front, std::vector<Front>, std::greater<>> queue;
  const auto reach = [&](std::size_t state, double cost, std::optional<std::size_t> via) {
    if (cost >= best[state]) return;
    best[state] = cost;
    from[state] = via;
    queue.emplace(cost, state);
  };
  for (const End& start : starts) {
    reach(2 * start.node, start.price, std::nullopt);
    reach(2 * start.node + 1, start.price, std::nullopt);
  }
  const auto wayTo = [&](std::optional<std::size_t> state, std::size_t target) {
    ArmSearch::Way way{{}, target};
    for (; state; state = from[*state]) way.nodes.insert(way.nodes.begin(), *state / 2);
    return way;
  };
  while (!queue.empty()) {
    const auto [cost, state] = queue.top();
    queue.pop();
    if (cost > best[state]) continue;
    if (state >= states) return wayTo(from[state], state - states);
    const std::size_t node = state / 2, column = node % columns, row = node / columns;
    for (std::size_t t = 0; t < ends.size(); ++t) {
      if (ends[t].node != node) continue;
      if (ends[t].price == 0) return wayTo(state, t);
      reach(states + t, cost + ends[t].price, state);
    }
    const auto step = [&, cost = cost, state = state](std::size_t next, std::size_t way, double length,
                                                      double weight) {
      reach(2 * next + way, cost + length + (way == state % 2 ? 0 : 30) + weight, state);
    };
    if (column + 1 < columns) step(node + 1, 0, grid.xs[column + 1] - grid.xs[column], weights.level[node]);
    if (column > 0) step(node - 1, 0, grid.xs[column] - grid.xs[column - 1], weights.level[node - 1]);
    if (row + 1 < grid.rows())
      step(node + columns, 1, grid.ys[row + 1] - grid.ys[row], weights.upright[node]);
    if (row > 0) step(node - columns, 1, grid.ys[row] - grid.ys[row - 1], weights.upright[node - columns]);
  }
  return std::nullopt;
}

ArmEdgeWeights weightsOf(const ArmGrid& grid, const std::vector<LinkLine>& lines, int link) {
  ArmEdgeWeights weights;
  weights.add(grid, lines, link);
  return weights;
}

/// Lines of some links, most of them level or upright; on whole places many ways cost the same.
std::vector<LinkLine> randomLines(std::mt19937& random, bool whole) {
  const auto number = [&](double most) {
    const double v = std::uniform_real_distribution<double>(0, most)(random);
    return whole ? std::round(v / 10) * 10 : v;
  };
  std::vector<LinkLine> lines;
  const int count = 5 + static_cast<int>(random() % 25);
  for (int i = 0; i < count; ++i) {
    const CanvasPoint from{number(400), number(250)};
    const unsigned way = static_cast<unsigned>(random() % 7);
    const CanvasPoint to{way < 3 ? from.x : number(400), way > 0 && way < 5 ? number(250) : from.y};
    const double penalty = std::array<double, 3>{0, 60, -1}[random() % 3];
    lines.push_back({from, to, static_cast<int>(random() % 4) - 1, penalty});
  }
  return lines;
}

/// A grid, what its edges cost, where ways may begin and end.
struct Roads {
  ArmGrid grid;
  ArmEdgeWeights weights;
  std::vector<End> starts;
  std::vector<End> ends;

  explicit Roads(std::mt19937& random) {
    if (random() % 10 == 0) {
      const std::vector<LinkLine> lines = randomLines(random, random() % 2 == 0);
      ArmLanes lanes;
      lanes.follow(lines);
      grid = lanes.gridWith({});
      weights = weightsOf(grid, lines, 1);
    } else {
      const bool whole = random() % 2 == 0;
      for (auto* lanes : {&grid.xs, &grid.ys}) {
        double at = 0;
        const int count = 2 + static_cast<int>(random() % 9);
        for (int i = 0; i < count; ++i) {
          lanes->push_back(at);
          at += whole ? 5.0 * (1 + static_cast<int>(random() % 4)) : 1e-9 * static_cast<double>(random());
        }
      }
      const std::vector<double> prices{0, 0, 0, whole ? 20 : 17.3, whole ? 10 : 9.7, 400};
      for (auto* edges : {&weights.level, &weights.upright}) {
        for (std::size_t i = 0; i < grid.nodes(); ++i) edges->push_back(prices[random() % prices.size()]);
      }
    }
    starts = some(random, 1 + random() % 5, {0, 60});
    ends = some(random, random() % 6, {0, 9, 25});
  }

 private:
  [[nodiscard]] std::vector<End> some(std::mt19937& random, std::size_t count,
                                      const std::vector<double>& prices) const {
    std::vector<End> chosen;
    for (std::size_t i = 0; i < count; ++i) {
      chosen.push_back({random() % grid.nodes(), prices[random() % prices.size()]});
    }
    return chosen;
  }
};

}  // namespace

/// Where arms may run, what that costs them, and the cheapest way.
class ArmSearchTest : public QObject {
  Q_OBJECT
 private slots:
  void lanesComeOneByOneAsAllAtOnce() {
    std::mt19937 random(5);
    for (int trial = 0; trial < 20; ++trial) {
      const std::vector<LinkLine> lines = randomLines(random, trial % 2 == 0);
      ArmLanes atOnce;
      atOnce.follow(lines);
      ArmLanes oneByOne;
      for (std::size_t i = 0; i <= lines.size(); ++i)
        oneByOne.follow({lines.begin(), lines.begin() + static_cast<std::ptrdiff_t>(i)});
      const ArmGrid grid = atOnce.gridWith({{7, 9}});
      QCOMPARE(oneByOne.gridWith({{7, 9}}).xs, grid.xs);
      QCOMPARE(oneByOne.gridWith({{7, 9}}).ys, grid.ys);
      QVERIFY(grid.nodeAt({7, 9}).has_value());
      QVERIFY(std::is_sorted(grid.xs.begin(), grid.xs.end()));
    }
  }

  void anArmPaysForCrossingAndForRunningBesideOthers() {
    const ArmGrid grid{{0, 50, 100}, {0, 8, 30}};
    const std::vector<LinkLine> lines{{{-20, 0}, {120, 0}, 1, 0}, {{75, 20}, {75, 60}, 2, 0}};
    const ArmEdgeWeights others = weightsOf(grid, lines, 1);
    QCOMPARE(others.level, (std::vector<double>{0, 0, 0, 0, 0, 0, 0, 400, 0}));  // across the second
    const ArmEdgeWeights both = weightsOf(grid, lines, 3);
    QCOMPARE(both.level[0], 400 + 40 * 50.0);  // on the first line
    QCOMPARE(both.level[3], 20 + 4 * 50.0);    // 8 px beside it
    QCOMPARE(both.level[6], 0.0);
    QCOMPARE(both.upright[0], 400.0);  // from it
    QCOMPARE(both.upright[3], 20.0);
  }

  /// A line that slants by next to nothing costs what a straight one does.
  void weightsOfStraightAndOfSlantingLinesAreOfOneKind() {
    std::mt19937 random(9);
    for (int trial = 0; trial < 30; ++trial) {
      std::vector<LinkLine> lines = randomLines(random, false);
      std::erase_if(lines, [](const LinkLine& l) { return l.from.x != l.to.x && l.from.y != l.to.y; });
      ArmLanes lanes;
      lanes.follow(lines);
      const ArmGrid grid = lanes.gridWith({});
      std::vector<LinkLine> turned = lines;
      for (LinkLine& line : turned) {
        line.to.x += 1e-11;
        line.to.y += 1e-11;
      }
      const ArmEdgeWeights straight = weightsOf(grid, lines, 0), slanting = weightsOf(grid, turned, 0);
      for (std::size_t node = 0; node < grid.nodes(); ++node) {
        QVERIFY(std::abs(straight.level[node] - slanting.level[node]) < 1e-6);
        QVERIFY(std::abs(straight.upright[node] - slanting.upright[node]) < 1e-6);
      }
    }
  }

  void theWayIsTheOneThatDijkstraFinds() {
    std::mt19937 random(3);
    int found = 0;
    ArmSearch search;  // for all of them, so that nothing of one may stay for the next
    for (int trial = 0; trial < 4000; ++trial) {
      const Roads roads(random);
      search.begin(roads.grid, roads.weights);
      for (const End& start : roads.starts) search.addStart(start.node, start.price);
      for (std::size_t t = 0; t < roads.ends.size(); ++t)
        search.addTarget(roads.ends[t].node, roads.ends[t].price, t);
      const auto expected = dijkstra(roads.grid, roads.weights, roads.starts, roads.ends);
      const auto way = search.cheapest();
      QCOMPARE(way.has_value(), expected.has_value());
      if (!way) continue;
      ++found;
      QCOMPARE(way->target, expected->target);
      QCOMPARE(way->nodes, expected->nodes);
    }
    QVERIFY(found > 3000);
  }

  void ofWaysThatCostTheSameItIsTheFirst() {
    const ArmGrid grid{{0, 10, 20}, {0}};
    const ArmEdgeWeights weights{{0, 0, 0}, {0, 0, 0}};
    ArmSearch search;
    search.begin(grid, weights);
    search.addStart(2, 0);
    search.addStart(0, 0);
    search.addTarget(1, 0, 0);
    QCOMPARE(search.cheapest()->nodes, (std::vector<std::size_t>{0, 1}));
  }
};

QTEST_APPLESS_MAIN(ArmSearchTest)
#include "test_arm_search.moc"

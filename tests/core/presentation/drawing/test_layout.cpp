#include <QTest>
#include <algorithm>
#include <map>
#include <numeric>
#include <set>
#include <thread>

#include "core/mechanism/graph/spanning_tree.h"
#include "core/presentation/drawing/layout.h"
#include "core/presentation/drawing/tidy_tree.h"
#include "tests/core/support/mechanisms.h"

using namespace geargraph;

namespace {

/// The two nearest nodes' distance.
double closest(const NodePositions& positions) {
  double least = 1e9;
  for (const auto& [a, p] : positions) {
    for (const auto& [b, q] : positions) {
      if (a < b) least = std::min(least, distance(p, q));
    }
  }
  return least;
}

}  // namespace

class LayoutTest : public QObject {
  Q_OBJECT
 private slots:
  void groundAloneStandsAtTheOrigin() {
    const Mechanism empty = emptyMechanism();
    QCOMPARE(layoutOf(empty), (NodePositions{{empty.links.front().id, CanvasPoint{0, 0}}}));
  }

  void everyLinkStandsRightOfTheOneThatCarriesIt() {
    const Mechanism robot = test::robotTopology();
    const NodePositions positions = layoutOf(robot);
    for (const TurningJoint& joint : robot.turningJoints) {
      QVERIFY(positions.at(joint.head).x > positions.at(joint.tail).x + 2 * kNodeRadius);
    }
  }

  void nodesKeepApart_data() {
    QTest::addColumn<int>("links");
    QTest::addColumn<int>("meshes");
    QTest::newRow("8") << 7 << 4;
    QTest::newRow("20") << 19 << 15;
    QTest::newRow("150") << 149 << 80;
    QTest::newRow("400, as a tree") << 399 << 250;
    QTest::newRow("no joints but a tree") << 30 << 0;
  }
  void nodesKeepApart() {
    QFETCH(int, links);
    QFETCH(int, meshes);
    for (std::uint64_t seed = 1; seed <= 10; ++seed) {
      const Mechanism mechanism = test::randomTree(seed, links, meshes);
      const NodePositions positions = layoutOf(mechanism);
      QCOMPARE(positions.size(), mechanism.links.size());
      QVERIFY(closest(positions) >= 75);
    }
  }

  void looseLinksArePlacedToo() {
    Mechanism mechanism = test::randomTree(3, 12, 0);
    mechanism.turningJoints.clear();
    const NodePositions positions = layoutOf(mechanism);
    QCOMPARE(positions.size(), std::size_t{13});
    QVERIFY(closest(positions) >= 75);
  }

  void theSameDocumentGetsTheSameLayoutFromAnyThread() {
    const Mechanism mechanism = test::randomTree(7, 60, 40);
    const NodePositions expected = layoutOf(mechanism);
    std::vector<NodePositions> results(4);
    {
      std::vector<std::jthread> threads;
      for (NodePositions& result : results) threads.emplace_back([&] { result = layoutOf(mechanism); });
    }
    for (const NodePositions& result : results) QVERIFY(result == expected);
  }

  void placedNodesStayAndTheOthersKeepClear() {
    const Mechanism whole = test::randomTree(5, 40, 20);
    Mechanism mechanism = whole;
    NodePositions kept;
    for (std::size_t i = 0; i < mechanism.links.size(); i += 3) {
      kept[mechanism.links[i].id] = {static_cast<double>(100 * (i % 7)), static_cast<double>(37 * i)};
    }
    mechanism.view.nodes = kept;
    const NodePositions positions = completedPositions(mechanism);
    QCOMPARE(positions.size(), mechanism.links.size());
    QVERIFY(!kept.empty() && kept.size() < mechanism.links.size());
    for (const auto& [link, place] : kept) QVERIFY(positions.at(link) == place);
    for (const auto& [link, place] : positions) {
      if (kept.contains(link)) continue;
      for (const auto& [other, at] : positions) QVERIFY(other == link || distance(place, at) >= 75);
    }
  }

  void completeDocumentsAreLeftAlone() {
    Mechanism mechanism = test::robotTopology();
    mechanism.view.nodes = layoutOf(mechanism);
    mechanism.view.nodes[LinkId("4")] = {12.5, -7};
    QVERIFY(completedPositions(mechanism) == mechanism.view.nodes);
  }

  void placesBeyondTheSheetDoNoHarm() {
    Mechanism mechanism = test::robotTopology();
    mechanism.view.nodes = {{LinkId("0"), {1e300, 1e300}}, {LinkId("1"), {-1e300, 0}}};
    const NodePositions positions = completedPositions(mechanism);
    QCOMPARE(positions.size(), std::size_t{8});
    for (const auto& [link, place] : positions) QVERIFY(std::isfinite(place.x) && std::isfinite(place.y));
  }

  void documentsWithoutPositionsAreLaidOut() {
    Mechanism mechanism = test::robotTopology();
    mechanism.view.nodes.clear();
    QVERIFY(completedPositions(mechanism) == layoutOf(mechanism));
  }

  void largeDrawingsShowTheLevelsOfTheTree() {
    const Mechanism mechanism = test::randomTree(11, 999, 500);
    const NodePositions positions = layoutOf(mechanism);
    const Digraph graph(mechanism);
    const SpanningTree tree = SpanningTree::of(graph).value();
    std::map<int, std::set<double>> columns;  // by depth
    for (int node = 0; node < graph.nodeCount(); ++node) {
      columns[tree.depth(node)].insert(positions.at(graph.nodeId(node)).x);
    }
    double last = -1000;
    for (const auto& [depth, places] : columns) {
      QCOMPARE(places.size(), std::size_t{1});
      QVERIFY(*places.begin() > last + 2 * kNodeRadius);
      last = *places.begin();
    }
  }

  void theTreeKeepsEverySubtreeTogether() {
    //  0 - 1 - 3       Reingold and Tilford's law: 1 stands by its child's row, 0 in the middle of 1 and 2,
    //    \   \ 4       and 5 below 2 is pushed away by 4 only as far as needed.
    //     2 - 5
    const std::vector<int> parent{-1, 0, 0, 1, 1, 2};
    const std::vector<int> order{0, 1, 2, 3, 4, 5};
    std::vector<double> rows;
    std::vector<int> columns;
    for (const TidyPlace& place : tidyForest(parent, order)) {
      rows.push_back(place.row);
      columns.push_back(place.column);
    }
    QCOMPARE(rows, (std::vector<double>{0, -0.75, 0.75, -1.25, -0.25, 0.75}));
    QCOMPARE(columns, (std::vector<int>{0, 1, 1, 2, 2, 2}));
  }

  void equalSubtreesLookAlikeAndAChainIsALine() {
    std::vector<int> parent{-1};
    for (int i = 0; i < 100'000; ++i) parent.push_back(i);
    std::vector<int> order(parent.size());
    std::iota(order.begin(), order.end(), 0);
    const std::vector<TidyPlace> chain = tidyForest(parent, order);
    QCOMPARE(chain.back().column, 100'000);
    QVERIFY(std::all_of(chain.begin(), chain.end(), [](const TidyPlace& p) { return p.row == 0; }));

    const std::vector<int> twins{-1, -1, 0, 0, 1, 1};
    const std::vector<int> inOrder{0, 1, 2, 3, 4, 5};
    const std::vector<TidyPlace> both = tidyForest(twins, inOrder);
    QCOMPARE(both[2].row - both[0].row, both[4].row - both[1].row);
    QCOMPARE(both[4].row - both[3].row, 1.0);
  }
};

QTEST_GUILESS_MAIN(LayoutTest)
#include "test_layout.moc"

#include <QTest>
#include <vector>

#include "core/foundations/base/disjoint_sets.h"

namespace geargraph {

class DisjointSetsTest : public QObject {
  Q_OBJECT

 private slots:
  void eachNumberIsFirstAlone() {
    const DisjointSets sets(4);
    for (int i = 0; i < 4; ++i) QCOMPARE(sets.root(i), i);
    QVERIFY(!sets.areJoined(0, 3));
  }

  /// Whatever the order of joins: the name is the smallest number.
  void aSetIsNamedByItsSmallestNumber() {
    const std::vector<std::vector<std::pair<int, int>>> orders = {
        {{5, 4}, {4, 2}, {7, 5}}, {{2, 4}, {7, 5}, {5, 2}}, {{7, 2}, {5, 7}, {4, 7}}};
    for (const auto& order : orders) {
      DisjointSets sets(8);
      for (const auto& [one, other] : order) sets.join(one, other);
      for (const int member : {2, 4, 5, 7}) QCOMPARE(sets.root(member), 2);
      for (const int other : {0, 1, 3, 6}) QCOMPARE(sets.root(other), other);
    }
  }

  void aNumberMayBeAdded() {
    DisjointSets sets(2);
    sets.add();
    QCOMPARE(sets.root(2), 2);
    sets.join(2, 1);
    QVERIFY(sets.areJoined(1, 2) && !sets.areJoined(0, 2));
    sets.join(2, 0);
    QCOMPARE(sets.root(1), 0);
  }
};

}  // namespace geargraph

QTEST_GUILESS_MAIN(geargraph::DisjointSetsTest)
#include "test_disjoint_sets.moc"

#include <QTest>
#include <algorithm>
#include <numeric>
#include <random>

#include "core/mechanism/graph/matrices.h"
#include "core/mechanism/model/edits.h"
#include "tests/core/support/mechanisms.h"

namespace geargraph {
namespace {

using test::Dense;

constexpr std::uint64_t kMechanisms = 300;

Dense zeros(int rows, int columns) {
  return Dense(static_cast<std::size_t>(rows), std::vector<int>(static_cast<std::size_t>(columns), 0));
}

Dense minusIdentity(int size) {
  Dense result = zeros(size, size);
  for (int i = 0; i < size; ++i) result[static_cast<std::size_t>(i)][static_cast<std::size_t>(i)] = -1;
  return result;
}

/// All matrices of one mechanism, dense.
struct Matrices {
  DigraphPtr graph;
  SpanningTreePtr tree;
  Dense Gamma0, Gamma, Z, T, C, Q;

  explicit Matrices(const Mechanism& mechanism) : graph(std::make_shared<const Digraph>(mechanism)) {
    tree = std::make_shared<const SpanningTree>(SpanningTree::of(*graph).value());
    Gamma0 = test::dense(*incidenceMatrix(graph));
    Gamma = test::dense(*reducedIncidenceMatrix(graph));
    Z = test::dense(*pathMatrix(graph, tree));
    T = test::dense(*spanningTreeMatrix(graph, tree));
    C = test::dense(*cycleBasisMatrix(graph, tree));
    Q = test::dense(*cutsetMatrix(graph, tree));
  }
  [[nodiscard]] Dense G() const { return test::columnsOf(Gamma, 0, graph->t()); }
  [[nodiscard]] Dense Gstar() const { return test::columnsOf(Gamma, graph->t(), graph->edgeCount()); }
};

Mechanism randomMechanism(std::uint64_t seed) {
  return test::randomTree(seed, 1 + static_cast<int>(seed % 23), static_cast<int>(seed % 11));
}

}  // namespace

class MatrixLawsTest : public QObject {
  Q_OBJECT

 private slots:
  void incidenceColumnsSumToZero() {
    for (std::uint64_t seed = 0; seed < kMechanisms; ++seed) {
      const Matrices m(randomMechanism(seed));
      for (int j = 0; j < m.graph->edgeCount(); ++j) {
        int sum = 0;
        int size = 0;
        for (const auto& row : m.Gamma0) {
          sum += row[static_cast<std::size_t>(j)];
          size += std::abs(row[static_cast<std::size_t>(j)]);
        }
        QCOMPARE(sum, 0);
        QCOMPARE(size, 2);
      }
    }
  }

  void turningBlockTimesPathMatrixIsMinusIdentity() {
    for (std::uint64_t seed = 0; seed < kMechanisms; ++seed) {
      const Matrices m(randomMechanism(seed));
      QCOMPARE(test::product(m.G(), m.Z), minusIdentity(m.graph->n()));
    }
  }

  void cyclesAreOrthogonalToIncidence() {
    std::uint64_t checked = 0;
    for (std::uint64_t seed = 0; seed < kMechanisms; ++seed) {
      const Matrices m(randomMechanism(seed));
      if (m.graph->c() == 0) continue;
      ++checked;
      QCOMPARE(test::product(m.Gamma, test::transposed(m.C)), zeros(m.graph->n(), m.graph->c()));
    }
    QVERIFY(checked > kMechanisms / 2);
  }

  void treeBlockIsGstarTransposedTimesZTransposed() {
    std::uint64_t checked = 0;
    for (std::uint64_t seed = 0; seed < kMechanisms; ++seed) {
      const Matrices m(randomMechanism(seed));
      if (m.graph->c() == 0) continue;
      ++checked;
      QCOMPARE(m.T, test::product(test::transposed(m.Gstar()), test::transposed(m.Z)));
      QCOMPARE(test::columnsOf(m.C, 0, m.graph->t()), m.T);
    }
    QVERIFY(checked > kMechanisms / 2);
  }

  void cutsetsAreOrthogonalToCycles() {
    std::uint64_t checked = 0;
    for (std::uint64_t seed = 0; seed < kMechanisms; ++seed) {
      const Matrices m(randomMechanism(seed));
      if (m.graph->c() == 0) continue;
      ++checked;
      QCOMPARE(test::product(m.C, test::transposed(m.Q)), zeros(m.graph->c(), m.graph->t()));
    }
    QVERIFY(checked > kMechanisms / 2);
  }

  void rowsOfNonZerosAreSortedAndAgreeWithEntries() {
    for (std::uint64_t seed = 0; seed < kMechanisms; ++seed) {
      const Matrices m(randomMechanism(seed));
      for (const MatrixKind kind : allMatrixKinds()) {
        const IntegerMatrixPtr matrix = matrixOf(kind, m.graph, m.tree);
        QCOMPARE(test::denseFromRows(*matrix), test::dense(*matrix));
        std::vector<MatrixEntry> entries;
        for (int i = 0; i < matrix->rows(); ++i) {
          matrix->rowEntries(i, entries);
          QVERIFY(std::is_sorted(entries.begin(), entries.end(),
                                 [](const auto& a, const auto& b) { return a.column < b.column; }));
        }
      }
    }
  }

  void flippingAnEdgeFlipsItsColumn() {
    for (std::uint64_t seed = 0; seed < kMechanisms; ++seed) {
      const Mechanism mechanism = randomMechanism(seed);
      const Matrices before(mechanism);
      const int edge = static_cast<int>(seed) % before.graph->edgeCount();
      const Matrices after(withFlipped(mechanism, before.graph->edgeId(edge)).value());
      Dense expected = before.Gamma0;
      for (auto& row : expected) row[static_cast<std::size_t>(edge)] *= -1;
      QCOMPARE(after.Gamma0, expected);

      // In C a flipped joint flips its column; a flipped mesh turns its cycle round, and stands for +1 again.
      expected = before.C;
      for (std::size_t i = 0; i < expected.size(); ++i) {
        for (int j = 0; j < before.graph->t(); ++j) {
          const bool flips =
              edge < before.graph->t() ? j == edge : static_cast<int>(i) == edge - before.graph->t();
          if (flips) expected[i][static_cast<std::size_t>(j)] *= -1;
        }
      }
      QCOMPARE(after.C, expected);
    }
  }

  void relabellingPermutesRowsAndColumns() {
    for (std::uint64_t seed = 0; seed < kMechanisms; ++seed) {
      const Mechanism mechanism = randomMechanism(seed);
      Mechanism relabelled = mechanism;
      std::mt19937_64 random(seed + 1000);
      const auto shuffle = [&random](auto begin, auto end) {
        for (auto size = end - begin; size > 1; --size) {
          std::iter_swap(begin + size - 1,
                         begin + static_cast<std::ptrdiff_t>(random() % std::uint64_t(size)));
        }
      };
      shuffle(relabelled.links.begin() + 1, relabelled.links.end());
      shuffle(relabelled.turningJoints.begin(), relabelled.turningJoints.end());
      shuffle(relabelled.gearMeshes.begin(), relabelled.gearMeshes.end());
      const Matrices before(mechanism);
      const Matrices after(relabelled);
      for (const MatrixKind kind : allMatrixKinds()) {
        const IntegerMatrixPtr old = matrixOf(kind, before.graph, before.tree);
        const IntegerMatrixPtr renewed = matrixOf(kind, after.graph, after.tree);
        std::map<ElementId, int> row;
        std::map<ElementId, int> column;
        for (int i = 0; i < renewed->rows(); ++i) row[renewed->rowHeading(i).element] = i;
        for (int j = 0; j < renewed->columns(); ++j) column[renewed->columnHeading(j).element] = j;
        for (int i = 0; i < old->rows(); ++i) {
          for (int j = 0; j < old->columns(); ++j) {
            QCOMPARE(
                renewed->entry(row.at(old->rowHeading(i).element), column.at(old->columnHeading(j).element)),
                old->entry(i, j));
          }
        }
      }
    }
  }

  void noTreeWithoutSpanning() {
    Mechanism mechanism = test::robotTopology();
    mechanism.turningJoints.pop_back();
    QVERIFY(!SpanningTree::of(Digraph(mechanism)));
    mechanism = test::robotTopology();
    mechanism.turningJoints[6].head = LinkId("7");  // 2 -> 7 twice: a loop, and 3 loose
    QVERIFY(!SpanningTree::of(Digraph(mechanism)));
  }

  void treePathFollowsTheCycle() {
    const Digraph graph(test::robotTopology());
    const SpanningTree tree = SpanningTree::of(graph).value();
    const std::vector<PathStep> path = treePath(tree, 5, 2);  // 5 -9- 0 -10- 1 -12- 2
    QCOMPARE(path.size(), std::size_t(3));
    QCOMPARE(graph.edgeLabel(path[0].joint), 9);
    QCOMPARE(path[0].direction, -1);
    QCOMPARE(graph.edgeLabel(path[1].joint), 10);
    QCOMPARE(path[1].direction, 1);
    QCOMPARE(graph.edgeLabel(path[2].joint), 12);
    QCOMPARE(path[2].direction, 1);
  }

  void chainsOfAHundredThousandLinksHaveATree() {
    Mechanism mechanism = emptyMechanism();
    mechanism.axes.push_back({AxisId("a"), {}, {}, {}});
    constexpr int n = 99'999;
    for (int i = 1; i <= n; ++i) {
      mechanism.links.push_back({LinkId(std::to_string(i)), {}, {}});
      mechanism.turningJoints.push_back({JointId(std::to_string(n + i)),
                                         LinkId(std::to_string(i - 1)),
                                         LinkId(std::to_string(i)),
                                         AxisId("a"),
                                         Number(0),
                                         {}});
    }
    const auto graph = std::make_shared<const Digraph>(mechanism);
    const auto tree = std::make_shared<const SpanningTree>(SpanningTree::of(*graph).value());
    const IntegerMatrixPtr Z = pathMatrix(graph, tree);
    QCOMPARE(Z->entry(0, n - 1), -1);
    QCOMPARE(Z->entry(n - 1, 0), 0);
    QCOMPARE(tree->depth(n), n);
  }
};

}  // namespace geargraph

QTEST_APPLESS_MAIN(geargraph::MatrixLawsTest)
#include "test_matrix_laws.moc"

#include <QTest>
#include <memory>

#include "core/mechanism/graph/matrices.h"
#include "tests/core/support/mechanisms.h"

namespace geargraph {

/// Rows of Z as sets of columns: small and large subtrees, links numbered along the tree and not.
class UniformRowsTest : public QObject {
  Q_OBJECT

 private slots:
  void rowsAreTheirEntries() {
    for (const int n : {1, 2, 63, 64, 65, 200, 500}) {
      for (std::uint64_t seed = 0; seed < 6; ++seed) {
        check(test::randomTree(seed, n, 0));
        check(chain(n, seed % 2 == 0));
      }
    }
  }

  void otherMatricesHaveNone() {
    const auto graph = std::make_shared<const Digraph>(test::robotTopology());
    UniformRow uniform;
    QVERIFY(!incidenceMatrix(graph)->uniformRow(0, uniform));
  }

 private:
  /// Each link on the one before it, numbered along the tree or against it.
  static Mechanism chain(int n, bool along) {
    Mechanism mechanism;
    mechanism.axes.emplace_back().id = AxisId("a");
    const auto link = [&](int i) { return LinkId(std::to_string(i == 0 || along ? i : n + 1 - i)); };
    for (int i = 0; i <= n; ++i) mechanism.links.push_back({LinkId(std::to_string(i)), {}, {}});
    for (int i = 1; i <= n; ++i) {
      mechanism.turningJoints.push_back(
          {JointId(std::to_string(i)), link(i - 1), link(i), AxisId("a"), Number(0), {}});
    }
    return mechanism;
  }

  static void check(const Mechanism& mechanism) {
    const auto graph = std::make_shared<const Digraph>(mechanism);
    const IntegerMatrixPtr path =
        pathMatrix(graph, std::make_shared<const SpanningTree>(SpanningTree::of(*graph).value()));
    UniformRow uniform;  // one for all rows, as writers use it
    for (int row = 0; row < path->rows(); ++row) {
      QVERIFY(path->uniformRow(row, uniform));
      QCOMPARE(uniform.columns.size(), static_cast<std::size_t>(path->columns() + 63) / 64);
      for (std::size_t column = 0; column < uniform.columns.size() * 64; ++column) {
        const bool isSet = (uniform.columns[column / 64] >> (column % 64) & 1U) != 0;
        const bool isInside = column < static_cast<std::size_t>(path->columns());
        QCOMPARE(isSet ? uniform.value : 0, isInside ? path->entry(row, static_cast<int>(column)) : 0);
      }
    }
    QCOMPARE(test::denseFromRows(*path), test::dense(*path));
  }
};

}  // namespace geargraph

QTEST_APPLESS_MAIN(geargraph::UniformRowsTest)
#include "test_uniform_rows.moc"

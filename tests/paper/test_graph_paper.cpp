#include <QTest>

#include "core/mechanism/graph/matrices.h"
#include "tests/core/support/mechanisms.h"

namespace geargraph {
namespace {

using test::Dense;

std::vector<int> rowLabels(const IntegerMatrix& matrix) {
  std::vector<int> labels;
  for (int i = 0; i < matrix.rows(); ++i) labels.push_back(matrix.rowHeading(i).label);
  return labels;
}

std::vector<int> columnLabels(const IntegerMatrix& matrix) {
  std::vector<int> labels;
  for (int j = 0; j < matrix.columns(); ++j) labels.push_back(matrix.columnHeading(j).label);
  return labels;
}

const std::vector<int> kEdges{8, 9, 10, 11, 12, 13, 14, 15, 16, 17, 18};
const std::vector<int> kJoints{8, 9, 10, 11, 12, 13, 14};
const std::vector<int> kMovingLinks{1, 2, 3, 4, 5, 6, 7};
const std::vector<int> kMeshes{15, 16, 17, 18};

}  // namespace

/// Eqs. (1)-(5) of the paper, entry by entry, tolerance zero.
class GraphPaperTest : public QObject {
  Q_OBJECT

 private:
  DigraphPtr graph = std::make_shared<const Digraph>(test::robotTopology());
  SpanningTreePtr tree = std::make_shared<const SpanningTree>(SpanningTree::of(*graph).value());

 private slots:
  // clang-format off
  void eq01_incidenceMatrix() {
    const Dense expected = {
      //  8   9  10  11  12  13  14  15  16  17  18
      { -1, -1, -1,  0,  0,  0,  0,  0,  0,  0,  0},  // 0
      {  0,  0,  1, -1, -1,  0,  0,  1,  0,  0,  0},  // 1
      {  0,  0,  0,  0,  1, -1, -1,  0,  1,  0,  0},  // 2
      {  0,  0,  0,  0,  0,  0,  1,  0,  0,  0,  1},  // 3
      {  1,  0,  0,  0,  0,  0,  0, -1,  0,  0,  0},  // 4
      {  0,  1,  0,  0,  0,  0,  0,  0, -1,  0,  0},  // 5
      {  0,  0,  0,  1,  0,  0,  0,  0,  0, -1,  0},  // 6
      {  0,  0,  0,  0,  0,  1,  0,  0,  0,  1, -1},  // 7
    };
    const IntegerMatrixPtr Gamma0 = incidenceMatrix(graph);
    QCOMPARE(test::dense(*Gamma0), expected);
    QCOMPARE(rowLabels(*Gamma0), (std::vector<int>{0, 1, 2, 3, 4, 5, 6, 7}));
    QCOMPARE(columnLabels(*Gamma0), kEdges);
    QVERIFY(!Gamma0->partition());
  }

  void eq02_reducedIncidenceMatrix() {
    const Dense expected = {
      //  8   9  10  11  12  13  14 | 15  16  17  18
      {  0,  0,  1, -1, -1,  0,  0,    1,  0,  0,  0},  // 1
      {  0,  0,  0,  0,  1, -1, -1,    0,  1,  0,  0},  // 2
      {  0,  0,  0,  0,  0,  0,  1,    0,  0,  0,  1},  // 3
      {  1,  0,  0,  0,  0,  0,  0,   -1,  0,  0,  0},  // 4
      {  0,  1,  0,  0,  0,  0,  0,    0, -1,  0,  0},  // 5
      {  0,  0,  0,  1,  0,  0,  0,    0,  0, -1,  0},  // 6
      {  0,  0,  0,  0,  0,  1,  0,    0,  0,  1, -1},  // 7
    };
    const IntegerMatrixPtr Gamma = reducedIncidenceMatrix(graph);
    QCOMPARE(test::dense(*Gamma), expected);
    QCOMPARE(rowLabels(*Gamma), kMovingLinks);
    QCOMPARE(columnLabels(*Gamma), kEdges);
    QCOMPARE(Gamma->partition().value(), 7);
  }

  void eq03_pathMatrix() {
    const Dense expected = {
      //  1   2   3   4   5   6   7
      {  0,  0,  0, -1,  0,  0,  0},  // 8
      {  0,  0,  0,  0, -1,  0,  0},  // 9
      { -1, -1, -1,  0,  0, -1, -1},  // 10
      {  0,  0,  0,  0,  0, -1,  0},  // 11
      {  0, -1, -1,  0,  0,  0, -1},  // 12
      {  0,  0,  0,  0,  0,  0, -1},  // 13
      {  0,  0, -1,  0,  0,  0,  0},  // 14
    };
    const IntegerMatrixPtr Z = pathMatrix(graph, tree);
    QCOMPARE(test::dense(*Z), expected);
    QCOMPARE(rowLabels(*Z), kJoints);
    QCOMPARE(columnLabels(*Z), kMovingLinks);
  }

  // Eq. (4) is printed as a formula only; its values are the left block of (5).
  void eq04_spanningTreeMatrix() {
    const Dense expected = {
      //  8   9  10  11  12  13  14
      {  1,  0, -1,  0,  0,  0,  0},  // C15
      {  0,  1, -1,  0, -1,  0,  0},  // C16
      {  0,  0,  0,  1, -1, -1,  0},  // C17
      {  0,  0,  0,  0,  0,  1, -1},  // C18
    };
    const IntegerMatrixPtr T = spanningTreeMatrix(graph, tree);
    QCOMPARE(test::dense(*T), expected);
    QCOMPARE(columnLabels(*T), kJoints);
    const Dense Gstar = test::columnsOf(test::dense(*reducedIncidenceMatrix(graph)), 7, 11);
    const Dense Z = test::dense(*pathMatrix(graph, tree));
    QCOMPARE(test::product(test::transposed(Gstar), test::transposed(Z)), expected);
  }

  void eq05_cycleBasisMatrix() {
    const Dense expected = {
      //  8   9  10  11  12  13  14 | 15  16  17  18
      {  1,  0, -1,  0,  0,  0,  0,    1,  0,  0,  0},  // C15
      {  0,  1, -1,  0, -1,  0,  0,    0,  1,  0,  0},  // C16
      {  0,  0,  0,  1, -1, -1,  0,    0,  0,  1,  0},  // C17
      {  0,  0,  0,  0,  0,  1, -1,    0,  0,  0,  1},  // C18
    };
    const IntegerMatrixPtr C = cycleBasisMatrix(graph, tree);
    QCOMPARE(test::dense(*C), expected);
    QCOMPARE(rowLabels(*C), kMeshes);
    QCOMPARE(columnLabels(*C), kEdges);
    QCOMPARE(QString::fromStdString(C->rowHeading(1).text), QStringLiteral("C16"));
    QCOMPARE(C->partition().value(), 7);
  }
  // clang-format on
};

}  // namespace geargraph

QTEST_APPLESS_MAIN(geargraph::GraphPaperTest)
#include "test_graph_paper.moc"

#include <QTest>
#include <memory>
#include <set>

#include "core/mechanism/graph/matrices.h"
#include "core/teaching/derivation/cell_explanation.h"
#include "core/teaching/derivation/glossary.h"
#include "core/teaching/derivation/named_results.h"
#include "core/teaching/derivation/result_text.h"
#include "tests/core/support/mechanisms.h"

namespace geargraph {

class DerivationTest : public QObject {
  Q_OBJECT

  const DigraphPtr graph = std::make_shared<const Digraph>(test::robotTopology());
  const SpanningTreePtr tree = std::make_shared<const SpanningTree>(*SpanningTree::of(*graph));

  [[nodiscard]] QString explained(MatrixKind kind, int row, int column) const {
    const CellExplanation cell = explainCell(kind, *graph, tree.get(), row, column);
    return QString::fromStdString(cell.title + " | " + cell.text);
  }
  [[nodiscard]] static std::set<ElementId> joints(std::initializer_list<const char*> turning,
                                                  std::initializer_list<const char*> meshes) {
    std::set<ElementId> elements;
    for (const char* id : turning) elements.insert(JointId(id));
    for (const char* id : meshes) elements.insert(MeshId(id));
    return elements;
  }

  [[nodiscard]] static std::string textOf(MatrixKind kind, const DigraphPtr& of, const SpanningTreePtr& with,
                                          TableFormat format) {
    const auto snapshot = std::make_shared<AnalysisSnapshot>();
    snapshot->graph = of;
    snapshot->tree = with;
    for (const MatrixKind each : allMatrixKinds()) snapshot->matrices.push_back(matrixOf(each, of, with));
    return resultText(*exactTable(resultOf(kind), {snapshot}), format);
  }

 private slots:
  void cellsOfCycleBasisTellTheWalk() {
    QCOMPARE(explained(MatrixKind::cycleBasis, 1, 2),
             QStringLiteral("C16, joint 10: −1 | Walking C16 along mesh 16, the path from 2 back to 5 runs "
                            "against joint 10 (from 1 to 0). Eq. (5)"));
    QCOMPARE(explained(MatrixKind::cycleBasis, 1, 1),
             QStringLiteral("C16, joint 9: 1 | Walking C16 along mesh 16, the path from 2 back to 5 runs "
                            "along joint 9 (from 0 to 5). Eq. (5)"));
    QCOMPARE(explained(MatrixKind::cycleBasis, 1, 8),
             QStringLiteral("C16, mesh 16: 1 | C16 is the cycle that mesh 16 closes, walked along its arrow "
                            "(from 5 to 2). Eq. (5)"));
    QVERIFY(explained(MatrixKind::cycleBasis, 1, 7).contains("holds mesh 16, not mesh 15"));
    QVERIFY(explained(MatrixKind::spanningTree, 1, 0).contains("does not use joint 8. Eq. (4)"));
  }

  void cellsOfIncidenceTellTheArrow() {
    QCOMPARE(explained(MatrixKind::incidence, 4, 0),
             QStringLiteral("Link 4, joint 8: 1 | Joint 8 points to link 4: its arrow ends there. Eq. (1)"));
    QCOMPARE(
        explained(MatrixKind::reducedIncidence, 0, 3),
        QStringLiteral("Link 1, joint 11: −1 | Joint 11 leaves link 1: its arrow begins there. Eq. (2)"));
    QVERIFY(explained(MatrixKind::incidence, 3, 7).contains("Mesh 15 goes from link 4 to link 1"));
  }

  void cellsOfPathTellTheWalkToGround() {
    QCOMPARE(explained(MatrixKind::path, 2, 1),
             QStringLiteral("Joint 10, link 2: −1 | The walk from link 2 to the ground runs against joint 10 "
                            "(from 1 to 0). Eq. (3)"));
  }

  void cellsOfCutsetTellTheHalves() {
    QVERIFY(explained(MatrixKind::cutset, 2, 7).contains("crosses over in the direction of joint 10"));
    QVERIFY(explained(MatrixKind::cutset, 2, 2).startsWith("Cutset of joint 10, joint 10: 1"));
    QVERIFY(explained(MatrixKind::cutset, 5, 7).contains("stays in one of them. Not in the paper."));
  }

  /// The title ends with the entry, whatever matrix and mechanism.
  void titlesAgreeWithEntries() {
    for (std::uint64_t seed = 1; seed <= 20; ++seed) {
      const auto g = std::make_shared<const Digraph>(test::randomTree(seed, 8, 6));
      const auto s = std::make_shared<const SpanningTree>(*SpanningTree::of(*g));
      for (const MatrixKind kind : allMatrixKinds()) {
        const IntegerMatrixPtr matrix = matrixOf(kind, g, s);
        for (int i = 0; i < matrix->rows(); ++i) {
          for (int j = 0; j < matrix->columns(); ++j) {
            const std::string title = explainCell(kind, *g, s.get(), i, j).title;
            QVERIFY(title.ends_with(": " + printedEntry(matrix->entry(i, j))));
          }
        }
      }
    }
  }

  void rowOfCycleIsTheWholeCycle() {
    QCOMPARE(elementsOfRow(MatrixKind::cycleBasis, *graph, tree.get(), 1), joints({"9", "10", "12"}, {"16"}));
    QCOMPARE(elementsOfRow(MatrixKind::cutset, *graph, tree.get(), 2), joints({"10"}, {"15", "16"}));
    QCOMPARE(elementsOfRow(MatrixKind::reducedIncidence, *graph, nullptr, 3),
             std::set<ElementId>{LinkId("4")});
    QCOMPARE(elementsOfRow(MatrixKind::path, *graph, tree.get(), 0), joints({"8"}, {}));
  }

  void tableForSpreadsheetsHasLabels() {
    const QStringList lines =
        QString::fromStdString(textOf(MatrixKind::spanningTree, graph, tree, TableFormat::tsv)).split('\n');
    QCOMPARE(lines.at(0), QStringLiteral("T\t8\t9\t10\t11\t12\t13\t14"));
    QCOMPARE(lines.at(2), QStringLiteral("C16\t0\t1\t-1\t0\t-1\t0\t0"));
    QCOMPARE(lines.size(), 6);  // header, 4 rows, what follows the last line end
    QVERIFY(textOf(MatrixKind::spanningTree, graph, tree, TableFormat::csv)
                .starts_with("T,8,9,10,11,12,13,14\nC15,1,0,-1"));
  }

  void latexShowsThePartition() {
    const QString text =
        QString::fromStdString(textOf(MatrixKind::cycleBasis, graph, tree, TableFormat::latex));
    QVERIFY(text.startsWith("\\begin{array}{c|rrrrrrr|rrrr}\n & 8 & 9"));
    QVERIFY(text.contains("C_{16} & 0 & 1 & -1 & 0 & -1 & 0 & 0 & 0 & 1 & 0 & 0 \\\\\n"));
    QVERIFY(text.endsWith("1\n\\end{array}\n"));
  }

  void assignmentsForMatlabAndPython() {
    QCOMPARE(QString::fromStdString(textOf(MatrixKind::spanningTree, graph, tree, TableFormat::matlab)),
             QStringLiteral("% Spanning-tree matrix; rows C15 C16 C17 C18; columns 8 9 10 11 12 13 14\n"
                            "T = [\n  1 0 -1 0 0 0 0\n  0 1 -1 0 -1 0 0\n  0 0 0 1 -1 -1 0\n"
                            "  0 0 0 0 0 1 -1\n];\n"));
    QVERIFY(QString::fromStdString(textOf(MatrixKind::spanningTree, graph, tree, TableFormat::numpy))
                .endsWith("T = np.array([\n    [1, 0, -1, 0, 0, 0, 0],\n    [0, 1, -1, 0, -1, 0, 0],\n"
                          "    [0, 0, 0, 1, -1, -1, 0],\n    [0, 0, 0, 0, 0, 1, -1],\n])\n"));
  }

  void emptyMatricesAreTextToo() {
    const auto g = std::make_shared<const Digraph>(emptyMechanism());
    const auto s = std::make_shared<const SpanningTree>(*SpanningTree::of(*g));
    QCOMPARE(textOf(MatrixKind::cycleBasis, g, s, TableFormat::tsv), std::string("C = [T | U]\n"));
    QCOMPARE(textOf(MatrixKind::incidence, g, s, TableFormat::tsv), std::string("Γ⁰\n0\n"));
  }

  void everyTermIsDefinedOnce() {
    QCOMPARE(static_cast<int>(glossary().size()), static_cast<int>(Term::ttCutsetMatrix) + 1);
    std::set<std::string_view> names;
    for (std::size_t i = 0; i < glossary().size(); ++i) {
      const Definition& definition = glossary()[i];
      QCOMPARE(static_cast<std::size_t>(definition.term), i);
      QVERIFY2(names.insert(definition.name).second, std::string(definition.name).c_str());
      QVERIFY2(definition.text.size() > 30 && definition.text.ends_with('.'),
               std::string(definition.name).c_str());
    }
  }

  void everyMatrixHasItsTerm() {
    for (const MatrixKind kind : allMatrixKinds()) {
      const Definition& definition = definitionOf(*resultOf(kind).term);
      QCOMPARE(definition.symbol, matrixSymbol(kind));
      QCOMPARE(definition.name, matrixTitle(kind));
      QCOMPARE(definition.equation, matrixEquation(kind));
    }
  }
};

}  // namespace geargraph

QTEST_APPLESS_MAIN(geargraph::DerivationTest)
#include "test_derivation.moc"

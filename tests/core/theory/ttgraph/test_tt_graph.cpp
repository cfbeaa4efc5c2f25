#include <QTest>

#include "core/theory/ttgraph/mesh_sign.h"
#include "core/theory/ttgraph/notation.h"
#include "core/theory/ttgraph/tt_graph.h"
#include "tests/core/support/mechanisms.h"
#include "tests/core/support/trains.h"

namespace geargraph {
namespace {

TtGraph ttGraphOf(const Mechanism& mechanism) {
  auto graph = std::make_shared<const Digraph>(mechanism);
  auto tree = std::make_shared<const SpanningTree>(SpanningTree::of(*graph).value());
  return {mechanism, graph, tree, ReferenceLines(placementOf(mechanism))};
}

std::string circuitText(const TtGraph& graph, std::span<const CircuitTerm> circuit) {
  std::string text;
  for (const CircuitTerm& term : circuit) {
    text += (term.coefficient > 0 ? "+" : "-") + branchName(graph.graph(), term.joint).toText();
  }
  return text;
}

std::vector<int> signsOf(const TtGraph& graph) {
  std::vector<int> signs;
  for (int mesh = 0; mesh < graph.graph().c(); ++mesh) signs.push_back(graph.terminal(mesh).value().sign);
  return signs;
}

AxisLine line(const Vector3& point, const Vector3& direction) {
  AxisLine line;
  line.point = point;
  line.direction = direction;
  return line;
}

}  // namespace

/// Signs from the drawn pose, terminal pairs and circuits.
class TtGraphTest : public QObject {
  Q_OBJECT

 private slots:
  void theRobotsSignsFollowFromItsPose() {
    QCOMPARE(signsOf(ttGraphOf(test::robot())), (std::vector<int>{-1, -1, -1, 1}));
  }

  void kindDecidesForParallelAxesAndThePitchPointWhereThereIsNone() {
    const AxisLine here = line({0, 0, 0}, {0, 0, 1});
    const AxisLine there = line({10, 0, 7}, {0, 0, 1});
    const AxisLine turned = line({10, 0, 7}, {0, 0, -1});
    QCOMPARE(meshSign({&here, &there, {}, MeshKind::external}), std::optional(-1));
    QCOMPARE(meshSign({&here, &there, {}, MeshKind::internal}), std::optional(1));
    QCOMPARE(meshSign({&here, &turned, {}, MeshKind::external}), std::optional(1));
    const Vector3 between{4, 0, 3};
    const Vector3 before{-4, 0, 3};
    const Vector3 behind{14, 0, 3};
    QCOMPARE(meshSign({&here, &there, &between, {}}), std::optional(-1));
    QCOMPARE(meshSign({&here, &there, &before, {}}), std::optional(1));
    QCOMPARE(meshSign({&here, &there, &behind, {}}), std::optional(1));
    QCOMPARE(meshSign({&here, &turned, &behind, {}}), std::optional(-1));
    QCOMPARE(meshSign({&here, &there, {}, {}}), std::optional<int>());
  }

  void bevelGearsTurnAgainstEachOtherIfTheyTouchBetweenTheirAxes() {
    const AxisLine tail = line({0, 0, 3}, {0, 0, 1});
    const AxisLine head = line({0, 5, 0}, {0, 0.6, 0.8});
    const auto sign = [&](const Vector3& point) { return meshSign({&tail, &head, &point, MeshKind::bevel}); };
    const Vector3 apex{0, 0, 5.0 - 5.0 - 5.0 * 0.8 / 0.6};
    const auto at = [&](double tailShare, double headShare) {
      return Vector3{0, apex[1] + 0.6 * headShare, apex[2] + tailShare + 0.8 * headShare};
    };
    QCOMPARE(sign(at(2, 3)), std::optional(-1));
    QCOMPARE(sign(at(-2, -3)), std::optional(-1));
    QCOMPARE(sign(at(2, -3)), std::optional(1));
    QCOMPARE(sign(at(-2, 3)), std::optional(1));
    QCOMPARE(meshSign({&tail, &head, {}, MeshKind::bevel}), std::optional<int>());
  }

  void skewAxesHaveNoSign() {
    const AxisLine tail = line({0, 0, 0}, {0, 0, 1});
    const AxisLine head = line({1, 0, 0}, {0, 1, 0});
    const Vector3 point{0.5, 0, 0};
    QCOMPARE(meshSign({&tail, &head, &point, {}}), std::optional<int>());
  }

  void withoutPlacesTheKindDecides() {
    Mechanism robot = test::robotTopology();
    robot.gearMeshes[0].kind = MeshKind::external;
    const auto digraph = std::make_shared<const Digraph>(robot);
    const auto tree = std::make_shared<const SpanningTree>(SpanningTree::of(*digraph).value());
    const TtGraph graph(robot, digraph, tree, ReferenceLines());
    QCOMPARE(graph.terminal(0).value().sign, -1);
    QCOMPARE(graph.unsignedMeshes(), (std::vector<int>{1, 2, 3}));
    QVERIFY(!graph.isComplete());
  }

  void anAxisTurnedOverTurnsTheSignsOfItsMeshes() {
    for (int axis = 0; axis < 5; ++axis) {
      const TtGraph plain = ttGraphOf(test::robot());
      const TtGraph flipped = ttGraphOf(test::withAxisFlipped(test::robot(), axis));
      for (int mesh = 0; mesh < 4; ++mesh) {
        const auto& vertex = plain.transferVertices().ofMesh[static_cast<std::size_t>(mesh)];
        const bool touched = vertex->tailLevel == axis || vertex->headLevel == axis;
        QCOMPARE(flipped.terminal(mesh)->sign,
                 touched ? -plain.terminal(mesh)->sign : plain.terminal(mesh)->sign);
      }
    }
  }

  void signsDoNotDependOnWhereTheMechanismStands() {
    const std::vector<int> expected{-1, -1, -1, 1};
    for (const auto& turn :
         {test::rotation(1, 2, 3, 4), test::rotation(3, -1, 0, 2), test::rotation(0, 1, 5, -2)}) {
      const Mechanism elsewhere = test::moved(test::robot(), turn, {17, Rational(-5, 3), 200});
      QCOMPARE(signsOf(ttGraphOf(elsewhere)), expected);
      QCOMPARE(signsOf(ttGraphOf(test::withDirectionsScaled(elsewhere, {3, Rational(1, 7), 12}))), expected);
    }
  }

  void terminalPairsNameTheirGearsCarrierAndPrimes() {
    const TtGraph graph = ttGraphOf(test::robot());
    std::vector<std::string> chords;
    for (int mesh = 0; mesh < 4; ++mesh) {
      chords.push_back(tailChordName(*graph.terminal(mesh)).toText());
      chords.push_back(headChordName(*graph.terminal(mesh)).toText());
    }
    QCOMPARE(chords, (std::vector<std::string>{"w40'", "w10'", "w51''", "w21''", "w62'''", "w72'''",
                                               "w72''''", "w32''''"}));
    QCOMPARE(graph.terminal(2)->tailTeeth, 24);
    QCOMPARE(graph.terminal(2)->headTeeth, 18);
  }

  void aBranchAgainstTheWalkCountsWithTheOtherSign() {
    Mechanism robot = test::robot();
    std::swap(robot.turningJoints[2].tail, robot.turningJoints[2].head);  // joint 10: now from 1 to 0
    const TtGraph graph = ttGraphOf(robot);
    QCOMPARE(circuitText(graph, graph.tailCircuit(1)), std::string("+w50+w01"));
    QCOMPARE(circuitText(graph, graph.headCircuit(0)), std::string("-w01"));
  }

  void labelsOfTwoDigitsAreKeptApart() {
    QCOMPARE((VelocityName{12, 3, 1}.toText()), std::string("w12_3'"));
    QCOMPARE((VelocityName{12, 3, 1}.toLatex()), std::string("\\omega_{12,3}'"));
    QCOMPARE((VelocityName{1, 23, 0}.toLatex()), std::string("\\omega_{1,23}"));
  }

  void aSecondMeshOfTheSameLinksHasItsOwnName() {
    test::TrainBuilder train("double pair");
    const int a = train.axis({0, 0, 0}, {0, 0, 1});
    const int b = train.axis({5, 0, 0}, {0, 0, 1});
    const int first = train.link(0, a);
    const int second = train.link(0, b);
    train.external(first, a, 20, second, b, 30);
    train.external(second, b, 30, first, a, 20);
    const auto names = ratioNames(Digraph(train.mechanism()));
    QCOMPARE(names[0].ttGraph, std::string("n12"));
    QCOMPARE(names[1].ttGraph, std::string("n21'"));
    QCOMPARE(names[1].inverse, std::string("n12'"));
    QCOMPARE(names[1].matroid, std::string("i6"));
  }
};

}  // namespace geargraph

QTEST_APPLESS_MAIN(geargraph::TtGraphTest)
#include "test_tt_graph.moc"

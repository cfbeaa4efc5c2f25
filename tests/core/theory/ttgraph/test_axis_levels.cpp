#include <QTest>

#include "core/theory/ttgraph/axis_levels.h"
#include "core/theory/ttgraph/transfer_vertices.h"
#include "tests/core/support/mechanisms.h"
#include "tests/core/support/trains.h"

namespace geargraph {
namespace {

using test::TrainBuilder;

AxisLevels levelsOf(const Mechanism& mechanism) {
  return axisLevels(mechanism, Digraph(mechanism), ReferenceLines(placementOf(mechanism)));
}

std::string levelWord(const AxisLevels& levels) {
  std::string word;
  for (std::size_t j = 0; j < levels.ofJoint.size(); ++j) {
    word += (j > 0 ? " " : "") + levels.levelOf(static_cast<int>(j));
  }
  return word;
}

TransferVertices verticesOf(const Mechanism& mechanism) {
  const Digraph graph(mechanism);
  return transferVertices(graph, SpanningTree::of(graph).value(), levelsOf(mechanism));
}

/// Roll, bend, roll: in the drawn pose the last axis lies on the first.
TrainBuilder wrist() {
  TrainBuilder train("wrist");
  const int a = train.axis({0, 0, 0}, {0, 0, 1});
  const int b = train.axis({0, 0, 0}, {0, 1, 0});
  const int c = train.axis({0, 0, 5}, {0, 0, 2});
  const int housing = train.link(0, a);
  const int bend = train.link(housing, b);
  train.link(bend, c);
  return train;
}

}  // namespace

/// Which joints are coaxial, and which link carries a mesh.
class AxisLevelsTest : public QObject {
  Q_OBJECT

 private slots:
  void theRobotHasTheLevelsOfFigure5() {
    for (const Mechanism& robot : {test::robot(), test::robotTopology()}) {
      const AxisLevels levels = levelsOf(robot);
      QCOMPARE(levelWord(levels), std::string("a b b c c d e"));
      QVERIFY(levels.reversed.empty());
      QVERIFY(levels.diagnostics.empty());
    }
  }

  void axesThatCoincideInTheDrawnPoseOnlyAreDifferent() {
    const AxisLevels levels = levelsOf(wrist().mechanism());
    QCOMPARE(levelWord(levels), std::string("a b c"));
    QVERIFY(levels.diagnostics.empty());
  }

  void anAxisNamedAcrossTheBendIsSplitAndSaid() {
    Mechanism mechanism = wrist().mechanism();
    mechanism.turningJoints[2].axis = AxisId("a");
    const AxisLevels levels = levelsOf(mechanism);
    QCOMPARE(levelWord(levels), std::string("a b a'"));
    QCOMPARE(levels.diagnostics.size(), std::size_t(1));
    const Diagnostic& diagnostic = levels.diagnostics.front();
    QCOMPARE(diagnostic.code, Code::splitAxis);
    QCOMPARE(diagnostic.elements, (std::vector<ElementId>{AxisId("a"), JointId("j0"), JointId("j2")}));
  }

  void oneLineUnderTwoNamesIsOneAxisAndItsDirectionIsMinded() {
    TrainBuilder train("two names");
    const int a = train.axis({1, 2, 3}, {2, 1, 2});
    const int b = train.axis({5, 4, 7}, {-4, -2, -4});
    const int c = train.axis({2, 2, 3}, {2, 1, 2});
    train.link(0, a);
    train.link(0, b);
    train.link(0, c);
    const AxisLevels levels = levelsOf(train.mechanism());
    QCOMPARE(levelWord(levels), std::string("a a c"));
    QCOMPARE(levels.reversed, std::set<int>{1});
    QCOMPARE(levels.diagnostics.size(), std::size_t(1));
    QCOMPARE(levels.diagnostics.front().code, Code::mergedAxes);
  }

  void collinearJointsHangTogetherThroughOthers() {
    TrainBuilder train("stack");
    const int a = train.axis({0, 0, 0}, {0, 0, 1});
    const int b = train.axis({0, 0, 4}, {0, 0, 1});
    const int c = train.axis({0, 0, 8}, {0, 0, -1});
    const int first = train.link(0, a);
    const int second = train.link(first, b);
    train.link(second, c);
    const AxisLevels levels = levelsOf(train.mechanism());
    QCOMPARE(levelWord(levels), std::string("a a a"));
    QCOMPARE(levels.reversed, std::set<int>{2});
  }

  void manyLinesAtOneLinkAreToldApart() {
    TrainBuilder train("pins");
    std::vector<int> expected;
    for (int i = 0; i < 300; ++i) {
      const int line = i % 100;
      const test::ExactTriple point{Rational(line % 10), Rational(line / 10), Rational(i)};
      train.link(0, train.axis(point, {0, 0, i % 2 == 0 ? 1 : -3}));
      expected.push_back(line);
    }
    QCOMPARE(levelsOf(train.mechanism()).ofJoint, expected);
  }

  void theRobotsCarriersAreThoseOfThePaper() {
    const TransferVertices vertices = verticesOf(test::robot());
    QVERIFY(vertices.diagnostics.empty());
    std::vector<int> carriers;
    for (const auto& vertex : vertices.ofMesh) carriers.push_back(vertex.value().carrier);
    QCOMPARE(carriers, (std::vector<int>{0, 1, 2, 2}));
  }

  void gearsOnOneAxisHaveNoCarrier() {
    Mechanism robot = test::robot();
    robot.gearMeshes[0].tail = LinkId("5");
    const TransferVertices vertices = verticesOf(robot);
    QVERIFY(!vertices.ofMesh[0]);
    QVERIFY(vertices.ofMesh[1].has_value());
    QCOMPARE(vertices.diagnostics.size(), std::size_t(1));
    QCOMPARE(vertices.diagnostics.front().code, Code::coaxialMesh);
    QCOMPARE(vertices.diagnostics.front().elements,
             (std::vector<ElementId>{MeshId("15"), LinkId("5"), LinkId("1")}));
  }

  void gearsOnManyAxesHaveNoCarrierAndTheWordIsPrinted() {
    TrainBuilder train("three axes");
    const int a = train.axis({9, 0, 0}, {0, 0, 1});
    const int b = train.axis({0, 0, 0}, {0, 0, 1});
    const int c = train.axis({0, 0, 0}, {0, 1, 0});
    const int gear = train.link(0, a);
    const int first = train.link(0, b);
    const int second = train.link(first, c);
    const int other = train.link(second, c);
    train.external(gear, a, 20, other, a, 20);
    const TransferVertices vertices = verticesOf(train.mechanism());
    QCOMPARE(vertices.diagnostics.size(), std::size_t(1));
    QCOMPARE(vertices.diagnostics.front().code, Code::noTransferVertex);
    QVERIFY(vertices.diagnostics.front().message.find("(a, b, c)") != std::string::npos);
    QCOMPARE(vertices.diagnostics.front().elements.front(),
             ElementId(train.mechanism().gearMeshes.front().id));
  }

  void aWristNamedGloballyWouldHaveTwoCarriersAndHasOne() {
    TrainBuilder train = wrist();
    const int gear = train.link(1, 1);
    train.bevel(gear, 1, 20, 3, 2, 25, -1);
    const TransferVertices vertices = verticesOf(train.mechanism());
    QCOMPARE(vertices.ofMesh[0].value().carrier, 2);
  }
};

}  // namespace geargraph

QTEST_APPLESS_MAIN(geargraph::AxisLevelsTest)
#include "test_axis_levels.moc"

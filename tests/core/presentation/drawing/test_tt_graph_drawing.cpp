#include <QTest>

#include "core/mechanism/model/edits.h"
#include "core/presentation/drawing/hit_test.h"
#include "core/presentation/drawing/tt_graph_drawing.h"
#include "core/presentation/drawing/tt_graph_layout.h"
#include "core/theory/analysis/analysis.h"
#include "tests/core/presentation/drawing/drawing_checks.h"
#include "tests/core/support/example_files.h"
#include "tests/core/support/mechanisms.h"
#include "tests/core/support/textbook_trains.h"
#include "tests/core/support/train_sketch.h"

using namespace geargraph;

namespace {

/// A mechanism with its T-T graph, drawn where the layout puts it.
struct Drawn {
  Mechanism mechanism;
  SnapshotPtr snapshot;
  TtGraphGeometry geometry;

  explicit Drawn(Mechanism drawn) : mechanism(std::move(drawn)) {
    snapshot = analyzeLive(std::make_shared<const Mechanism>(mechanism));
    geometry = ttGraphGeometry(mechanism, graph(),
                               ttPositions(ttLayout(mechanism, graph()), mechanism.view.ttNodes));
  }
  [[nodiscard]] const TtGraph* graph() const {
    return snapshot->kinematics ? snapshot->kinematics->ttGraph.get() : nullptr;
  }
  [[nodiscard]] DisplayList list(const Emphases& emphases = {}) const {
    return ttGraphDrawing(geometry, emphases);
  }
  /// "4-0 15′", every line of this kind.
  [[nodiscard]] QString lines(TtLine kind) const {
    QStringList texts;
    for (const TtLinePlace& line : geometry.lines) {
      if (line.kind != kind) continue;
      texts << QString("%1-%2 %3").arg(line.from).arg(line.to).arg(QString::fromStdString(line.label));
    }
    return texts.join(", ");
  }
  [[nodiscard]] QString collisions() const { return test::collisionsIn(list(test::withNames(mechanism))); }
};

void addExamples() {
  QTest::addColumn<QString>("name");
  for (const std::string& name : test::exampleNames()) {
    QTest::newRow(name.c_str()) << QString::fromStdString(name);
  }
}

}  // namespace

class TtGraphDrawingTest : public QObject {
  Q_OBJECT
 private slots:
  void branchesOfTheRobotAreThoseOfFigure5() {
    const Drawn robot(test::example("robot"));
    QCOMPARE(robot.lines(TtLine::branch), QString("4-0 a, 5-0 b, 1-0 b, 6-1 c, 2-1 c, 7-2 d, 3-2 e"));
  }

  void chordsOfTheRobotAreThoseOfFigure6() {
    const Drawn robot(test::example("robot"));
    QCOMPARE(robot.lines(TtLine::tailChord), QString("4-0 15′, 5-1 16′′, 6-2 17′′′, 7-2 18′′′′"));
    QCOMPARE(robot.lines(TtLine::headChord), QString("1-0 15′, 2-1 16′′, 7-2 17′′′, 3-2 18′′′′"));
    QCOMPARE(robot.lines(TtLine::open), QString());
    QStringList transfer;
    for (std::size_t i = 0; i < robot.geometry.nodes.size(); ++i) {
      if (robot.geometry.isTransfer[i]) transfer << QString::number(robot.geometry.nodes[i].label);
    }
    QCOMPARE(transfer.join(" "), QString("0 1 2"));
  }

  void examplesAreDrawnAsInTheGoldenTexts_data() { addExamples(); }
  void examplesAreDrawnAsInTheGoldenTexts() {
    QFETCH(QString, name);
    const std::string drawn = textOf(Drawn(test::example(name.toStdString())).list());
    const QString folder =
        QString::fromStdString(test::sourcePath("tests/core/presentation/drawing/ttgraph/"));
    test::compareWithGolden(folder + name + ".txt", drawn);
  }

  void nothingTouchesAnythingInTheExamples_data() { addExamples(); }
  void nothingTouchesAnythingInTheExamples() {
    QFETCH(QString, name);
    QCOMPARE(Drawn(test::example(name.toStdString())).collisions(), QString());
  }

  void nothingTouchesAnythingInTextbookTrains() {
    for (const test::TextbookTrain& train : test::textbookTrains()) {
      const QString found = Drawn(train.mechanism).collisions();
      QVERIFY2(found.isEmpty(), qPrintable(QString::fromStdString(train.mechanism.name) + ": " + found));
    }
  }

  void nothingTouchesAnythingInRandomTrains_data() {
    QTest::addColumn<int>("links");
    QTest::addColumn<int>("meshes");
    QTest::newRow("6") << 6 << 4;
    QTest::newRow("12") << 12 << 9;
    QTest::newRow("30") << 30 << 20;
  }
  void nothingTouchesAnythingInRandomTrains() {
    QFETCH(int, links);
    QFETCH(int, meshes);
    for (std::uint64_t seed = 1; seed <= 25; ++seed) {
      const QString found = Drawn(test::randomTrain(seed, links, meshes)).collisions();
      QVERIFY2(found.isEmpty(), qPrintable(QString("seed %1: %2").arg(seed).arg(found)));
    }
  }

  void rootIsOnTopAndEveryRankHangsBelowTheLast() {
    const Drawn robot(test::example("robot"));
    const NodePositions places = ttLayout(robot.mechanism, robot.graph());
    const auto y = [&](const char* link) { return places.at(LinkId(link)).y; };
    QCOMPARE(places.at(LinkId("0")), (CanvasPoint{0, 0}));
    QVERIFY(y("0") < y("1") && y("1") < y("2") && y("2") < y("3"));
    for (const char* link : {"4", "5", "1"}) QCOMPARE(y(link), y("1"));
    for (const char* link : {"7", "3"}) QCOMPARE(y(link), y("3"));
  }

  void gearsThatTheGraphTiesStandSideBySide() {
    // Ground 0 carries 1, 2, 3; a mesh ties 1 and 3, by way of 3 as the carrier of 4.
    const Drawn robot(test::example("robot"));
    const NodePositions places = ttLayout(robot.mechanism, robot.graph());
    const double apart = std::abs(places.at(LinkId("5")).x - places.at(LinkId("1")).x);
    const double across = std::abs(places.at(LinkId("4")).x - places.at(LinkId("1")).x);
    QVERIFY(apart < across);
  }

  void draggedNodesStayAndTheOthersMakeRoom() {
    Mechanism mechanism = test::example("robot");
    const Drawn before(mechanism);
    const NodePositions laidOut = ttLayout(mechanism, before.graph());
    mechanism.view.ttNodes[LinkId("3")] = laidOut.at(LinkId("4"));
    const Drawn after(mechanism);
    const NodePositions places = ttPositions(ttLayout(mechanism, after.graph()), mechanism.view.ttNodes);
    QCOMPARE(places.at(LinkId("3")), laidOut.at(LinkId("4")));
    QVERIFY(distance(places.at(LinkId("3")), places.at(LinkId("4"))) >= 75);
    QCOMPARE(places.at(LinkId("7")), laidOut.at(LinkId("7")));
  }

  void withoutATreeWhatThereIsIsDrawn() {
    Mechanism mechanism = test::example("robot");
    const std::array<ElementId, 1> joint{JointId("12")};
    mechanism = withoutElements(mechanism, joint).value();
    const Drawn drawn(mechanism);
    QVERIFY(drawn.graph() == nullptr);
    QCOMPARE(drawn.geometry.nodes.size(), std::size_t{8});
    QCOMPARE(drawn.lines(TtLine::branch), QString("4-0 a, 5-0 b, 1-0 b, 6-1 c, 7-2 d, 3-2 e"));
    QCOMPARE(drawn.lines(TtLine::open), QString("4-1 14, 5-2 15, 6-7 16, 7-3 17"));
    QCOMPARE(drawn.collisions(), QString());
  }

  void meshWithoutTransferVertexIsOpen() {
    Mechanism mechanism = test::example("robot");
    mechanism = withGearMesh(mechanism, LinkId("4"), LinkId("3")).value();  // over axes a, b, c, e
    const Drawn drawn(mechanism);
    QCOMPARE(drawn.lines(TtLine::open), QString("4-3 19"));
    QCOMPARE(drawn.collisions(), QString());
  }

  void chordsOfOneMeshAreHitAsThatMesh() {
    const Drawn robot(test::example("robot"));
    const DisplayList list = robot.list();
    int lines = 0;
    for (const TtLinePlace& line : robot.geometry.lines) {
      if (line.element != ElementId(MeshId("16"))) continue;
      ++lines;
      QVERIFY(elementAt(list.outlines, line.curve.at(0.3)) == ElementId(MeshId("16")));
      QVERIFY(elementAt(list.outlines, line.labelCenter) == ElementId(MeshId("16")));
    }
    QCOMPARE(lines, 2);
  }

  void bothCircuitsOfAMeshHaveTheirColour() {
    const Drawn robot(test::example("robot"));
    Emphases emphases;
    emphases[MeshId("16")].walk = 1;
    emphases[JointId("9")].walk = 1;
    emphases[JointId("12")] = {.walk = 1, .second = true};
    QStringList walks;
    for (const Mark& mark : robot.list(emphases).marks) {
      if (mark.role != MarkRole::walk) continue;
      walks << QString::fromStdString(mark.element.id.text() + " " + nameOf(std::get<Fill>(mark.what).tint));
    }
    QCOMPARE(walks.join(", "), QString("9 accent, 12 negative-ink, 16 accent, 16 negative-ink"));
  }

  void thousandLinksAreLaidOutAndPlacedWithoutNodesOnNodes() {
    const Mechanism mechanism = test::randomTrain(3, 999, 400);
    const Drawn drawn(mechanism);
    QCOMPARE(drawn.geometry.nodes.size(), std::size_t{1000});
    std::map<std::pair<double, double>, int> places;
    for (const NodePlace& node : drawn.geometry.nodes) ++places[{node.center.x, node.center.y}];
    QCOMPARE(places.size(), std::size_t{1000});
  }
};

QTEST_GUILESS_MAIN(TtGraphDrawingTest)
#include "test_tt_graph_drawing.moc"

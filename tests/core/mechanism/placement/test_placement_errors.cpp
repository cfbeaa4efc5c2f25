#include <QTest>

#include "core/mechanism/placement/placement.h"
#include "tests/core/support/train_sketch.h"

using namespace geargraph;
using namespace geargraph::test;

namespace {

/// A pair of wheels 20:40 on parallel axes 60 apart, or at right angles.
Mechanism pair(std::optional<MeshKind> kind, const std::vector<std::string>& pitchPoint,
               const std::vector<std::string>& direction = {"0", "0", "1"},
               const std::vector<std::string>& point = {"0", "60", "0"}) {
  return TrainSketch(2)
      .axis("a", {"0", "0", "0"})
      .axis("b", point, direction)
      .joint(0, 1, "a")
      .joint(0, 2, "b")
      .mesh(1, 2, 20, 40, kind, pitchPoint)
      .build();
}

/// The one diagnostic of the placement, with its code.
Diagnostic only(const Mechanism& mechanism) {
  const Placement placement = placementOf(mechanism);
  return placement.diagnostics.size() == 1 ? placement.diagnostics.front() : Diagnostic{};
}

/// Does the diagnostic state this value?
bool states(const Diagnostic& diagnostic, const char* value) {
  return diagnostic.message.find(value) != std::string::npos;
}

/// All diagnostics about a mesh name it and its two links.
const std::vector<ElementId> kMesh{MeshId("5"), LinkId("1"), LinkId("2")};

}  // namespace

class PlacementErrorsTest : public QObject {
  Q_OBJECT
 private slots:
  void aFittingPairHasNoDiagnostics() {
    QVERIFY(placementOf(pair(MeshKind::external, {"0", "20", "5"})).diagnostics.empty());
    QVERIFY(placementOf(pair(MeshKind::internal, {"0", "-60", "0"})).diagnostics.empty());
    QVERIFY(placementOf(pair({}, {})).diagnostics.empty());
  }

  void aPitchPointOnAnAxisIsRejected() {
    const Diagnostic diagnostic = only(pair({}, {"0", "60", "3"}));
    QCOMPARE(diagnostic.code, Code::pitchPointOnAxis);
    QCOMPARE(diagnostic.elements, kMesh);
    QVERIFY(states(diagnostic, "(0, 60, 3)"));
    QCOMPARE(only(pair({}, {"0", "0", "3"})).code, Code::pitchPointOnAxis);
  }

  void aPitchPointOffThePlaneOfTheAxesIsRejectedWithTheDistanceAndThePointThatFits() {
    const Diagnostic diagnostic = only(pair(MeshKind::external, {"1/2", "20", "0"}));
    QCOMPARE(diagnostic.detail, Detail::pitchPointOffPlane);
    QCOMPARE(diagnostic.code, Code::pitchGeometry);
    QCOMPARE(diagnostic.elements, kMesh);
    QVERIFY(states(diagnostic, " 0.5 "));
    QVERIFY(states(diagnostic, "(0, 20, 0)"));
  }

  void skewAxesAreRejectedWithTheirDistance() {
    for (const auto& point : {std::vector<std::string>{}, std::vector<std::string>{"0", "20", "0"}}) {
      const Diagnostic diagnostic = only(pair({}, point, {"1", "0", "0"}));
      QCOMPARE(diagnostic.detail, Detail::skewAxes);
      QCOMPARE(diagnostic.code, Code::pitchGeometry);
      QVERIFY(states(diagnostic, " 60 "));
    }
  }

  void aKindThatTheAxesContradictIsRejected() {
    const Diagnostic bevel = only(pair(MeshKind::bevel, {}));
    QCOMPARE(bevel.detail, Detail::kindAgainstAxes);
    QCOMPARE(bevel.code, Code::pitchGeometry);
    const Diagnostic external = only(pair(MeshKind::external, {}, {"0", "1", "0"}));
    QCOMPARE(external.detail, Detail::kindAgainstAxes);
    QVERIFY(states(external, "bevel"));
  }

  void teethThatContradictTheRadiiAreRejectedWithBothAndWhatFits() {
    const Diagnostic diagnostic = only(pair(MeshKind::external, {"0", "24", "0"}));
    QCOMPARE(diagnostic.detail, Detail::teethAgainstRadii);
    QCOMPARE(diagnostic.code, Code::teethGeometry);
    QCOMPARE(diagnostic.elements, kMesh);
    for (const char* value : {"24", "36", "20", "40", " 30 ", "(0, 20, 0)"})
      QVERIFY(states(diagnostic, value));
  }

  void aKindThatTheSignContradictsIsRejected() {
    const Diagnostic internal = only(pair(MeshKind::internal, {"0", "20", "0"}));
    QCOMPARE(internal.detail, Detail::kindAgainstSides);
    QCOMPARE(internal.code, Code::teethGeometry);
    QVERIFY(states(internal, "(0, -60, 0)"));
    QCOMPARE(only(pair(MeshKind::external, {"0", "-60", "0"})).detail, Detail::kindAgainstSides);
  }

  void anInternalPairOfEqualTeethIsRejected() {
    Mechanism near = pair(MeshKind::internal, {});
    near.axes[1].point = NumberTriple{*Number::fromText("1e-3"), 0, 0};
    near.gearMeshes[0].headTeeth = 20;
    near.gearMeshes[0].pitchPoint = NumberTriple{100, 0, 0};
    QCOMPARE(only(near).detail, Detail::equalInternalTeeth);
    Mechanism equal = pair(MeshKind::internal, {});
    equal.gearMeshes[0].headTeeth = 20;
    QCOMPARE(only(equal).code, Code::teethGeometry);
    QCOMPARE(only(equal).detail, Detail::equalInternalTeeth);
  }

  void coaxialGearsAreRejected() {
    const Diagnostic diagnostic =
        only(TrainSketch(2).joint(0, 1, "a").joint(1, 2, "a").mesh(1, 2, 20, 20).build());
    QCOMPARE(diagnostic.code, Code::coaxialMesh);
    QCOMPARE(diagnostic.elements.front(), ElementId(MeshId("5")));
    QCOMPARE(only(TrainSketch(1).joint(0, 1, "a").mesh(0, 1, 20, 20).build()).code, Code::coaxialMesh);
  }

  void aPathOverThreeAxesIsRejectedWithItsWord() {
    const Diagnostic diagnostic =
        only(TrainSketch(3).joint(0, 1, "a").joint(1, 2, "b").joint(2, 3, "c").mesh(0, 3, 20, 20).build());
    QCOMPARE(diagnostic.code, Code::noTransferVertex);
    QVERIFY(states(diagnostic, "a|b|c"));
  }

  void oneAxisNameOnTwoAxesIsReported() {
    const Diagnostic diagnostic =
        only(TrainSketch(3).joint(0, 1, "a").joint(1, 2, "b").joint(2, 3, "a").build());
    QCOMPARE(diagnostic.code, Code::splitAxis);
    QVERIFY(std::find(diagnostic.elements.begin(), diagnostic.elements.end(), ElementId(AxisId("a"))) !=
            diagnostic.elements.end());
  }

  void coincidingAxesAtACommonLinkAreOneAndTheirSensesAreMinded() {
    const Mechanism train = TrainSketch(3)
                                .axis("a", {"0", "0", "0"})
                                .axis("a2", {"0", "0", "9"}, {"0", "0", "-2"})
                                .axis("b", {"0", "60", "0"})
                                .joint(0, 1, "a")
                                .joint(0, 2, "a2")
                                .joint(0, 3, "b")
                                .mesh(1, 3, 20, 40)
                                .mesh(2, 3, 20, 40)
                                .build();
    const Placement placement = placementOf(train);
    QCOMPARE(placement.diagnostics.size(), std::size_t{1});
    QCOMPARE(placement.diagnostics.front().code, Code::mergedAxes);
    QCOMPARE(placement.classes->classOf[0], placement.classes->classOf[1]);
    QCOMPARE(placement.classes->orientationSign[1], -1);
    QCOMPARE(placement.meshes[1]->sign, -1);
  }

  void axesThatCoincideWithoutACommonLinkStayTwo() {
    const Mechanism wrist = TrainSketch(3)
                                .axis("a", {"0", "0", "0"})
                                .axis("b", {"0", "0", "0"}, {"0", "1", "0"})
                                .axis("c", {"0", "0", "0"})
                                .joint(0, 1, "a")
                                .joint(1, 2, "b")
                                .joint(2, 3, "c")
                                .build();
    const Placement placement = placementOf(wrist);
    QVERIFY(placement.diagnostics.empty());
    QCOMPARE(placement.classes->classes.size(), std::size_t{3});
  }

  void withoutATreeAxesAreStillPlaced() {
    const Mechanism loose = TrainSketch(2).joint(0, 1, "a").mesh(1, 2, 20, 20).build();
    const Placement placement = placementOf(loose);
    QVERIFY(!placement.tree);
    QCOMPARE(placement.axes.size(), std::size_t{1});
    QVERIFY(!placement.meshes[0]);
  }
};

QTEST_APPLESS_MAIN(PlacementErrorsTest)
#include "test_placement_errors.moc"

#include <QtTest>

#include "core/placement/placement.h"
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

/// The one finding of the placement, with its code.
Diagnostic only(const Mechanism& mechanism) {
  const Placement placement = placementOf(mechanism);
  return placement.diagnostics.size() == 1 ? placement.diagnostics.front() : Diagnostic{};
}

bool says(const Diagnostic& finding, const char* part) {
  return finding.message.find(part) != std::string::npos;
}

}  // namespace

class TestPlacementErrors : public QObject {
  Q_OBJECT
 private slots:
  void aFittingPairHasNoFindings() {
    QVERIFY(placementOf(pair(MeshKind::external, {"0", "20", "5"})).diagnostics.empty());
    QVERIFY(placementOf(pair(MeshKind::internal, {"0", "-60", "0"})).diagnostics.empty());
    QVERIFY(placementOf(pair({}, {})).diagnostics.empty());
  }

  void aPitchPointOnAnAxisIsRefused() {
    const Diagnostic finding = only(pair({}, {"0", "60", "3"}));
    QCOMPARE(finding.code, Code::pitchPointOnAxis);
    QVERIFY(says(finding, "axis of the head gear"));
    QCOMPARE(only(pair({}, {"0", "0", "3"})).code, Code::pitchPointOnAxis);
  }

  void aPitchPointOffThePlaneOfTheAxesIsRefusedWithTheDistanceAndThePointThatFits() {
    const Diagnostic finding = only(pair(MeshKind::external, {"1/2", "20", "0"}));
    QCOMPARE(finding.code, Code::pitchGeometry);
    QVERIFY(says(finding, "lies 0.5 off the plane"));
    QVERIFY(says(finding, "(0, 20, 0)"));
  }

  void skewAxesAreRefusedWithTheirDistance() {
    for (const auto& point : {std::vector<std::string>{}, std::vector<std::string>{"0", "20", "0"}}) {
      const Diagnostic finding = only(pair({}, point, {"1", "0", "0"}));
      QCOMPARE(finding.code, Code::pitchGeometry);
      QVERIFY(says(finding, "skew, 60 apart"));
    }
  }

  void aKindThatTheAxesContradictIsRefused() {
    const Diagnostic bevel = only(pair(MeshKind::bevel, {}));
    QCOMPARE(bevel.code, Code::pitchGeometry);
    QVERIFY(says(bevel, "says bevel, but its axes are parallel"));
    const Diagnostic external = only(pair(MeshKind::external, {}, {"0", "1", "0"}));
    QCOMPARE(external.code, Code::pitchGeometry);
    QVERIFY(says(external, "What fits: bevel"));
  }

  void teethThatContradictTheRadiiAreRefusedWithBothAndWhatFits() {
    const Diagnostic finding = only(pair(MeshKind::external, {"0", "24", "0"}));
    QCOMPARE(finding.code, Code::teethGeometry);
    QVERIFY(says(finding, "24 and 36"));
    QVERIFY(says(finding, "20 and 40"));
    QVERIFY(says(finding, "30 teeth on the head"));
    QVERIFY(says(finding, "(0, 20, 0)"));
  }

  void aKindThatTheSignContradictsIsRefused() {
    const Diagnostic internal = only(pair(MeshKind::internal, {"0", "20", "0"}));
    QCOMPARE(internal.code, Code::teethGeometry);
    QVERIFY(says(internal, "between the axes"));
    QVERIFY(says(internal, "(0, -60, 0)"));
    QCOMPARE(only(pair(MeshKind::external, {"0", "-60", "0"})).code, Code::teethGeometry);
  }

  void anInternalPairOfEqualTeethIsRefused() {
    Mechanism equal = pair(MeshKind::internal, {});
    equal.gearMeshes[0].headTeeth = 20;
    QCOMPARE(only(equal).code, Code::teethGeometry);
  }

  void coaxialGearsAreRefused() {
    const Diagnostic finding =
        only(TrainSketch(2).joint(0, 1, "a").joint(1, 2, "a").mesh(1, 2, 20, 20).build());
    QCOMPARE(finding.code, Code::coaxialMesh);
    QCOMPARE(finding.elements.front(), ElementId(MeshId("5")));
    QCOMPARE(only(TrainSketch(1).joint(0, 1, "a").mesh(0, 1, 20, 20).build()).code, Code::coaxialMesh);
  }

  void aPathOverThreeAxesIsRefusedWithItsWord() {
    const Diagnostic finding =
        only(TrainSketch(3).joint(0, 1, "a").joint(1, 2, "b").joint(2, 3, "c").mesh(0, 3, 20, 20).build());
    QCOMPARE(finding.code, Code::noTransferVertex);
    QVERIFY(says(finding, "a|b|c"));
  }

  void oneAxisNameOnTwoAxesIsReported() {
    const Diagnostic finding =
        only(TrainSketch(3).joint(0, 1, "a").joint(1, 2, "b").joint(2, 3, "a").build());
    QCOMPARE(finding.code, Code::splitAxis);
    QVERIFY(says(finding, "Axis a"));
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
    QCOMPARE(placement.classes->sense[1], -1);
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

QTEST_APPLESS_MAIN(TestPlacementErrors)
#include "test_placement_errors.moc"

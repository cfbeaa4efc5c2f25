#include <QTest>

#include "core/mechanism/placement/placement.h"
#include "tests/core/support/train_sketch.h"
#include "tests/core/support/trains.h"

using namespace geargraph;
using namespace geargraph::test;

namespace {

double distance(const Placement& placement, int a, int b) {
  const Vector3 between = placement.axes[b].point - placement.axes[a].point;
  return length(cross(placement.axes[a].direction, between));
}

}  // namespace

class AxisPlacerTest : public QObject {
  Q_OBJECT
 private slots:
  void parallelAxesStandAsFarApartAsTheTeethAsk() {
    const Placement placement = placementOf(TrainSketch(3)
                                                .joint(0, 1, "a")
                                                .joint(0, 2, "b")
                                                .joint(0, 3, "c")
                                                .mesh(1, 2, 20, 30)
                                                .mesh(2, 3, 30, 50)
                                                .build());
    QVERIFY(placement.diagnostics.empty());
    QCOMPARE(distance(placement, 0, 1), 50.0);  // module 2
    QCOMPARE(distance(placement, 1, 2), 80.0);
    QVERIFY(placement.axes[0].automatic);
  }

  void theModuleIsThatOfTheAxesThatAreGiven() {
    const Placement placement = placementOf(TrainSketch(3)
                                                .axis("a", {"0", "0", "0"})
                                                .axis("b", {"30", "40", "0"})
                                                .joint(0, 1, "a")
                                                .joint(0, 2, "b")
                                                .joint(0, 3, "c")
                                                .mesh(1, 2, 20, 20)
                                                .mesh(2, 3, 20, 28)
                                                .build());
    QCOMPARE(placement.module, Rational(5, 2));
    QCOMPARE(distance(placement, 1, 2), 60.0);
  }

  void planetsAreSpreadEvenlyAtTheDistanceOfSunAndRing() {
    const Placement placement = placementOf(planetary(18, 12, 3));
    QVERIFY(placement.diagnostics.empty());
    for (int planet = 1; planet <= 3; ++planet)
      QVERIFY(std::abs(distance(placement, 0, planet) - 30) < 1e-12);
    for (int planet = 1; planet <= 3; ++planet) {
      const double apart = distance(placement, planet, planet % 3 + 1);
      QVERIFY(std::abs(apart - 30 * std::sqrt(3.0)) < 1e-7);
    }
    for (int mesh = 0; mesh < 6; ++mesh) {
      const double radius = std::abs(placement.meshes[mesh]->tailRadius);
      QVERIFY(std::abs(radius - (mesh % 2 == 0 ? 18 : 12)) < 1e-9);
    }
  }

  void anIdlerBetweenTwoPlacedAxesMeetsBothDistances() {
    const Placement placement = placementOf(TrainSketch(3)
                                                .axis("a", {"0", "0", "0"})
                                                .axis("b", {"0", "60", "0"})
                                                .joint(0, 1, "a")
                                                .joint(0, 2, "b")
                                                .joint(0, 3, "c")
                                                .mesh(1, 3, 20, 20)
                                                .mesh(3, 2, 20, 30)
                                                .mesh(1, 2, 24, 36)
                                                .build());
    QVERIFY(placement.diagnostics.empty());
    QVERIFY(std::abs(distance(placement, 0, 2) - 40) < 1e-9);
    QVERIFY(std::abs(distance(placement, 1, 2) - 50) < 1e-9);
  }

  void aBevelPartnerStandsAtRightAnglesAndMeetsItsNeighbour() {
    Mechanism open = robot();
    for (Axis& axis : open.axes) axis.point = axis.direction = std::nullopt;
    for (GearMesh& mesh : open.gearMeshes) mesh.pitchPoint.reset();
    const Placement placement = placementOf(open);
    QVERIFY(placement.diagnostics.empty());
    QVERIFY(placement.axes[0].direction == (Vector3{0, 0, 1}));
    QVERIFY(placement.axes[1].direction == (Vector3{0, 0, 1}));
    QVERIFY(placement.axes[2].direction == (Vector3{0, 1, 0}));
    for (const auto& mesh : placement.meshes) QVERIFY(mesh.has_value());
    QCOMPARE(distance(placement, 0, 1), 54.0);
  }

  void theBevelsOfABareRobotHaveApexesOfTheirOwn() {
    Mechanism open = robot();
    for (Axis& axis : open.axes) axis.point = axis.direction = std::nullopt;
    for (TurningJoint& joint : open.turningJoints) joint.offset = Number(0);
    for (GearMesh& mesh : open.gearMeshes) mesh.pitchPoint.reset();
    const Placement placement = placementOf(open);
    const auto lies = [&](int axis) { return placement.axes[static_cast<std::size_t>(axis)].point; };
    QVERIFY(length(lies(3) - lies(2)) > 30);  // d meets c beside b, clear of the pair of b and c
    QVERIFY(lies(4)[2] - lies(3)[2] > 30);    // e meets d above that
  }

  void theTwoPinionsOfADifferentialShareTheirApex() {
    TrainSketch train(5);
    train.joint(0, 1, "a").joint(0, 2, "a").joint(0, 3, "a").joint(1, 4, "b").joint(1, 5, "c");
    for (const int pinion : {4, 5}) {
      train.mesh(2, pinion, 24, 16, MeshKind::bevel).mesh(3, pinion, 24, 16, MeshKind::bevel);
    }
    const Placement placement = placementOf(train.build());
    QVERIFY(placement.diagnostics.empty());
    QVERIFY(placement.axes[1].point == placement.axes[0].point);
    QVERIFY(placement.axes[2].point == placement.axes[0].point);
  }

  /// Two shafts to two wheels about one apex, as in a wrist: both come from one side, one pair within the
  /// other.
  void pairsOfAWristLieOneWithinTheOther() {
    TrainSketch train(5);
    train.joint(0, 1, "a").joint(0, 2, "a").joint(0, 3, "a").joint(1, 4, "b").joint(1, 5, "b");
    train.mesh(2, 4, 20, 24, MeshKind::bevel).mesh(3, 5, 20, 24, MeshKind::bevel);
    const Placement placement = placementOf(train.build());
    const Vector3 inner = placement.meshes[0]->pitchPoint, outer = placement.meshes[1]->pitchPoint;
    QVERIFY(inner[2] < 0);
    QVERIFY(outer[2] < 0);
    QVERIFY(length(outer) > 1.4 * length(inner));
  }

  void trainsThatNothingTiesTogetherStandBesideEachOther() {
    const Placement placement = placementOf(TrainSketch(4)
                                                .joint(0, 1, "a")
                                                .joint(0, 2, "b")
                                                .joint(0, 3, "c")
                                                .joint(0, 4, "d")
                                                .mesh(1, 2, 20, 30)
                                                .mesh(3, 4, 20, 30)
                                                .build());
    QVERIFY(placement.diagnostics.empty());
    QVERIFY(distance(placement, 1, 2) > 50);
  }

  void aGivenDirectionOrPointIsKept() {
    Mechanism half = TrainSketch(2).joint(0, 1, "a").joint(0, 2, "b").mesh(1, 2, 20, 30).build();
    half.axes[0].direction = NumberTriple{1, 0, 0};
    half.axes[1].point = NumberTriple{3, 0, 70};
    const Placement placement = placementOf(half);
    QVERIFY(placement.axes[1].point == (Vector3{3, 0, 70}));
    QVERIFY(placement.axes[1].direction == (Vector3{1, 0, 0}));
  }
};

QTEST_APPLESS_MAIN(AxisPlacerTest)
#include "test_axis_placer.moc"

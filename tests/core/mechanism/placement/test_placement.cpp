#include <QTest>

#include "core/mechanism/placement/placement.h"
#include "tests/core/support/train_sketch.h"
#include "tests/core/support/trains.h"

using namespace geargraph;
using namespace geargraph::test;

namespace {

bool near(const Vector3& a, const Vector3& b, double size = 1) {
  return length(a - b) <= 1e-9 * size;
}

/// Velocity of the point P of a wheel that turns at `speed` about a line.
Vector3 velocityAt(const AxisLine& line, double speed, const Vector3& point) {
  return speed * cross(line.direction, point - line.point);
}

}  // namespace

class PlacementTest : public QObject {
  Q_OBJECT
 private slots:
  void theRobotsCarriersAreThoseOfThePaper() {
    const Placement placement = placementOf(robot());
    QVERIFY(placement.diagnostics.empty());
    const std::vector<int> carriers{0, 1, 2, 2};  // (4,1)(0), (5,2)(1), (6,7)(2), (7,3)(2)
    for (int i = 0; i < 4; ++i) QCOMPARE(placement.meshes[i]->carrier, carriers[i]);
  }

  void theRobotsSignsFollowFromItsGeometry() {
    const Placement placement = placementOf(robot());
    const std::vector<int> signs{-1, -1, -1, 1};  // of (27), (28), (29) and (30)
    for (int i = 0; i < 4; ++i) QCOMPARE(placement.meshes[i]->sign, signs[i]);
  }

  void theRobotsRadiiAreHalfTheDiametersOfTable1() {
    const Placement placement = placementOf(robot());
    const std::vector<std::pair<double, double>> radii{{-18, 36}, {20, -30}, {24, -18}, {-16, -24}};
    for (int i = 0; i < 4; ++i) {
      QCOMPARE(placement.meshes[i]->tailRadius, radii[i].first);
      QCOMPARE(placement.meshes[i]->headRadius, radii[i].second);
      QCOMPARE(placement.meshes[i]->normal[0], 1.0);  // the paper's x direction
    }
  }

  void aParallelPitchPointFollowsFromAxesAndTeeth() {
    Mechanism open = robot();
    open.gearMeshes[0].pitchPoint.reset();
    const Placement placement = placementOf(open);
    QVERIFY(placement.meshes[0]->derived);
    QVERIFY(near(placement.meshes[0]->pitchPoint, {0, -36, 0}));
    QVERIFY(*exactPitchPoint(open, placement, 0) == (ExactVector3{0, -36, 0}));
  }

  void aBevelPitchPointFollowsFromOffsetsAndModule() {
    Mechanism open = robot();
    open.gearMeshes[1].pitchPoint.reset();
    open.turningJoints[1].offset = Number(20);   // wheel 5 below the apex at z = 60,
    open.turningJoints[4].offset = Number(-40);  // wheel 2 left of it
    const Placement placement = placementOf(open);
    QVERIFY(near(placement.meshes[1]->pitchPoint, {0, -20, 30}));  // module 2, as drawn
    QVERIFY(*exactPitchPoint(open, placement, 1) == (ExactVector3{0, -20, 30}));
  }

  void aDifferentialsSideGearsLieOnBothSidesOfThePlanet() {
    const Mechanism differential = TrainSketch(4)
                                       .joint(0, 1, "a")
                                       .joint(0, 2, "a")
                                       .joint(0, 3, "a")
                                       .joint(3, 4, "b")
                                       .mesh(1, 4, 20, 15, MeshKind::bevel)
                                       .mesh(4, 2, 15, 20, MeshKind::bevel)
                                       .build();
    const Placement placement = placementOf(differential);
    QVERIFY(placement.diagnostics.empty());
    QCOMPARE(placement.meshes[0]->sign * placement.meshes[1]->sign, -1);
    QVERIFY(near(placement.meshes[0]->pitchPoint, {0, 20, -15}));
    QVERIFY(near(placement.meshes[1]->pitchPoint, {0, 20, 15}));
  }

  void bothWheelsMoveAlikeAtEveryPitchPoint() {
    for (std::uint64_t seed = 1; seed <= 60; ++seed) {
      const Mechanism train = randomTrain(seed, 20, 14);
      const Placement placement = placementOf(train);
      QVERIFY(!hasErrors(placement.diagnostics));
      for (int i = 0; i < train.c(); ++i) {
        const MeshGeometry& mesh = *placement.meshes[i];
        const GearMesh& teeth = train.gearMeshes[i];
        const Vector3 tail = velocityAt(placement.lineOfClass(mesh.tailClass), 1, mesh.pitchPoint);
        const double headSpeed = static_cast<double>(mesh.sign * teeth.tailTeeth) / teeth.headTeeth;
        const Vector3 head = velocityAt(placement.lineOfClass(mesh.headClass), headSpeed, mesh.pitchPoint);
        QVERIFY(near(tail, head, 1e5));
        QVERIFY(mesh.kind == *teeth.kind);
      }
    }
  }

  void theWholeMayLieAnywhere() {
    for (std::uint64_t seed = 1; seed <= 20; ++seed) {
      const Mechanism train = randomTrain(seed, 15, 10);
      const Placement here = placementOf(train);
      const Placement there = placementOf(moved(train, rotation(1, 2, -1, 3), {5, -7, 11}));
      QVERIFY(!hasErrors(there.diagnostics));
      for (int i = 0; i < train.c(); ++i) {
        QCOMPARE(there.meshes[i]->sign, here.meshes[i]->sign);
        QVERIFY(std::abs(std::abs(there.meshes[i]->tailRadius) - std::abs(here.meshes[i]->tailRadius)) <
                1e-6);
      }
    }
  }

  void anAxisTurnedRoundTurnsTheSign() {
    Mechanism turned = robot();
    turned.axes[4].direction = NumberTriple{0, -7, 0};
    const Placement placement = placementOf(turned);
    QCOMPARE(placement.meshes[3]->sign, -1);
    QCOMPARE(placement.meshes[2]->sign, -1);
  }

  void anInternalPairIsRecognisedFromItsPitchPoint() {
    const Mechanism ring = TrainSketch(2)
                               .axis("a", {"0", "0", "0"})
                               .axis("b", {"0", "20", "0"})
                               .joint(0, 1, "a")
                               .joint(0, 2, "b")
                               .mesh(1, 2, 60, 20, {}, {"0", "30", "4"})
                               .build();
    const Placement placement = placementOf(ring);
    QVERIFY(placement.meshes[0]->kind == MeshKind::internal);
    QCOMPARE(placement.meshes[0]->sign, 1);
    QCOMPARE(placement.meshes[0]->tailRadius, -30.0);
    QCOMPARE(placement.meshes[0]->headRadius, -10.0);
  }

  void pitchPointsStayFractionsWhereTheyAre() {
    for (std::uint64_t seed = 1; seed <= 20; ++seed) {
      const Mechanism train = randomTrain(seed, 15, 10);
      const Placement placement = placementOf(train);
      for (int i = 0; i < train.c(); ++i) {
        const auto exact = exactPitchPoint(train, placement, i);
        QVERIFY(exact.has_value());
        QVERIFY(near(toDoubles(*exact), placement.meshes[i]->pitchPoint, 1e6));
      }
    }
  }

  void longCoaxialStacksCostNothingExtra() {
    constexpr int kLinks = 20'000;
    TrainSketch stack(kLinks + 1);
    for (int v = 1; v <= kLinks; ++v) stack.joint(v - 1, v, "a");
    stack.joint(0, kLinks + 1, "b");
    for (int i = 0; i < 200; ++i) stack.mesh(kLinks - i, kLinks + 1, 20, 30);
    const Placement placement = placementOf(stack.build());
    QVERIFY(placement.diagnostics.empty());
    QCOMPARE(placement.meshes[199]->carrier, 0);
  }
};

QTEST_APPLESS_MAIN(PlacementTest)
#include "test_placement.moc"

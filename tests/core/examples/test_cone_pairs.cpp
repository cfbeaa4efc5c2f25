#include <QTest>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include "core/machine/body_layout/complete_train.h"
#include "core/machine/teeth/wheel_kind.h"
#include "core/machine/train/mesh_contact.h"
#include "core/machine/train/train_diagnostics.h"
#include "core/mechanism/document_format/file_version.h"
#include "core/mechanism/document_format/mechanism_file.h"
#include "core/mechanism/model/edits.h"
#include "core/mechanism/model/validate.h"
#include "core/theory/statics/losses.h"
#include "core/theory/statics/statics_report.h"
#include "tests/core/support/snapshot_of.h"
#include "tests/core/support/statics_case.h"
#include "tests/core/support/train_sketch.h"

using namespace geargraph;
using test::snapshotOf;
using test::TrainSketch;

namespace {

constexpr double kConeDegree = std::numbers::pi / 180;

MeshKind coneKind(const char* name) {
  return *meshKindFrom(name);
}

/// The rate of the joint behind the input of 1, after both methods agreed.
Rational turnedOn(const Mechanism& mechanism) {
  const SnapshotPtr snapshot = snapshotOf(mechanism);
  if (hasErrors(snapshot->diagnostics)) throw std::runtime_error(snapshot->diagnostics.front().message);
  const SolvedKinematics& solved = *snapshot->solved;
  if (!solved.ttExact || !solved.agreement || !solved.agreement->equal || solved.agreement->compared == 0)
    throw std::runtime_error("the methods disagree");
  return solved.exact->rates[1];
}

/// Gear 1 on an axis along z through the origin, gear 2 on an axis through (offset along y).
Mechanism conePair(int tail, int head, const char* kind, const std::string& offset = "0",
                   const std::vector<std::string>& direction = {"1", "0", "0"}) {
  return TrainSketch(2)
      .axis("a", {"0", "0", "0"})
      .axis("b", {"0", offset, "0"}, direction)
      .joint(0, 1, "a", "10")
      .joint(0, 2, "b", "10")
      .mesh(1, 2, tail, head, coneKind(kind))
      .inputs({{3, "1"}})
      .build();
}

MeshGeometry placedCones(const Mechanism& mechanism) {
  const Placement placement = placementOf(mechanism);
  if (!placement.meshes[0]) throw std::runtime_error(placement.diagnostics.front().message);
  return *placement.meshes[0];
}

Detail coneDetail(const Mechanism& mechanism) {
  const Placement placement = placementOf(mechanism);
  return placement.diagnostics.empty() ? Detail::none : placement.diagnostics.front().detail;
}

/// n . (v_i - v_j) = 0 in the pitch point, from the twists of the links alone.
double slipAlongNormal(const Mechanism& mechanism, const Rational& rate) {
  const Placement placement = placementOf(mechanism);
  const MeshGeometry& mesh = *placement.meshes[0];
  const AxisLine &a = placement.lineOfClass(mesh.tailClass), &b = placement.lineOfClass(mesh.headClass);
  const Vector3 slip = cross(a.direction, mesh.pitchPoint - a.point) -
                       rate.toDouble() * cross(b.direction, mesh.pitchPoint - b.point);
  return dot(mesh.normal, slip) / (std::abs(mesh.tailRadius) + std::abs(mesh.headRadius));
}

Mechanism withHeadLoad(Mechanism pair, int torque) {
  pair.loads.push_back({{}, JointTorque{JointId("4"), Number(torque)}, {}});
  return pair;
}

}  // namespace

/// Spiral bevels, face gears and hypoids: truth values, and laws on random pairs.
class ConePairsTest : public QObject {
  Q_OBJECT

 private slots:
  /// A face gear pair 3 : 4 turns as a bevel pair 3 : 4, whatever the half axes.
  void aFaceGearTurnsAsABevel() {
    for (const char* direction : {"1", "-1"}) {
      const std::vector<std::string> axis{direction, "0", "0"};
      const Rational face = turnedOn(conePair(18, 24, "faceGear", "0", axis));
      QCOMPARE(face, turnedOn(conePair(18, 24, "bevel", "0", axis)));
      QCOMPARE(face.abs(), Rational(3, 4));
      QCOMPARE(turnedOn(conePair(24, 18, "faceGear", "0", axis)), face.inverse());
    }
    QCOMPARE(placedCones(conePair(18, 24, "faceGear")).pitchPoint,
             placedCones(conePair(18, 24, "bevel")).pitchPoint);
  }

  /// An axle of 10 : 41.
  void aHypoidTurnsByItsTeeth() {
    Mechanism axle = conePair(10, 41, "hypoid", "20");
    axle.gearMeshes[0].module = Number(4);
    QCOMPARE(turnedOn(axle).inverse().abs(), Rational(41, 10));
    Mechanism met = conePair(10, 41, "bevel");
    QCOMPARE(turnedOn(axle), turnedOn(met));
  }

  /// E/R 0.39: the half axes make spiral angles far from running round.
  void theHalfAxesOfAHypoidTakeTheFlatterSpiral() {
    Mechanism axle = conePair(10, 41, "hypoid", "31.98");
    axle.gearMeshes[0].module = Number(4);
    const MeshGeometry mesh = placedCones(axle);
    // The gear is the one of the bevel pair: radius 82, and the pitch point at 82 * 10/41 = 20 along its
    // axis.
    QVERIFY(std::abs(length(cross(Vector3{1, 0, 0}, mesh.tailToPitch - mesh.tailToHead)) - 82) < 1e-9);
    QVERIFY(std::abs(std::abs(mesh.tailToPitch[0]) - 20) < 1e-9);
    QVERIFY(std::abs(mesh.tailHelix / kConeDegree + 11.672) < 1e-3);  // with the other sign 78.937
    QVERIFY(std::abs(mesh.headHelix / kConeDegree + 10.499) < 1e-3);
    QVERIFY(std::abs(std::abs(mesh.tailRadius) / std::abs(mesh.headRadius) - 10.0 / 41) < 1e-12);
  }

  /// Pairs at random places, axes either way, of either order: the methods agree, n is a line of action, and
  /// reversing an axis or exchanging tail and head only changes what it says.
  void randomPairsTurnByTheirTeeth() {
    std::mt19937_64 random(11);
    const auto below = [&](int most) { return static_cast<int>(random() % static_cast<unsigned>(most)); };
    int tried = 0;
    for (int round = 0; round < 240; ++round) {
      const char* kinds[] = {"bevel", "faceGear", "hypoid"};
      const char* kind = kinds[round % 3];
      const int pinion = 8 + below(20), gear = pinion + 1 + below(50);
      const bool isTailGear = below(2) == 0;
      const std::string offset = round % 3 == 2 ? std::to_string(1 + below(18)) : "0";
      const std::string way = below(2) == 0 ? "1" : "-1";
      const auto build = [&](bool swapped, bool reversed) {
        const bool gearFirst = isTailGear != swapped;
        TrainSketch sketch(2);
        sketch.axis("a", {"3", "-2", "7"}, {"0", "0", reversed ? "-1" : "1"})
            .axis("b", {"3", std::to_string(-2 + std::stoi(offset)), "7"}, {way, "0", "0"})
            .joint(0, 1, "a", reversed ? "-10" : "10")
            .joint(0, 2, "b", "10")
            .mesh(swapped ? 2 : 1, swapped ? 1 : 2, gearFirst ? gear : pinion, gearFirst ? pinion : gear,
                  coneKind(kind))
            .inputs({{3, "1"}});
        Mechanism pair = sketch.build();
        pair.gearMeshes[0].module = Number(2);
        if (round % 3 == 0) pair.gearMeshes[0].helixAngle = Number(35);
        return pair;
      };
      const Mechanism pair = build(false, false);
      if (!placementOf(pair).meshes[0]) continue;  // the offset is too large for the gear
      ++tried;
      const Rational rate = turnedOn(pair);
      QCOMPARE(rate.abs(), isTailGear ? Rational(gear, pinion) : Rational(pinion, gear));
      QVERIFY(std::abs(slipAlongNormal(pair, rate)) < 1e-9);
      QCOMPARE(turnedOn(build(true, false)), rate);
      // The joint's offset went along, so that the gear stays where it is, and its axis points the other way.
      QCOMPARE(turnedOn(build(false, true)), -rate);
    }
    QVERIFY(tried > 190);
  }

  /// The ratio does not depend on a spiral; mates have opposite hands, and exchanging tail and head keeps
  /// them.
  void spiralBevelsHaveOppositeHands() {
    Mechanism pair = conePair(17, 31, "bevel");
    const Rational straight = turnedOn(pair);
    pair.gearMeshes[0].helixAngle = Number(35);
    QCOMPARE(turnedOn(pair), straight);
    QCOMPARE(fileVersionOf(pair), 2);
    const MeshGeometry mesh = placedCones(pair);
    QVERIFY(std::abs(mesh.tailHelix - 35 * kConeDegree) < 1e-12);
    QCOMPARE(mesh.headHelix, -mesh.tailHelix);
    const GearTrain train = trainOf(pair, placementOf(pair));
    QVERIFY(std::abs(normalPressureAngle(train.gears[0].spec) - 20 * kConeDegree) < 1e-12);
    const auto swapped = withFlipped(pair, ElementId(pair.gearMeshes[0].id));
    QVERIFY(swapped.has_value());
    const MeshGeometry other = placedCones(*swapped);
    QCOMPARE(other.tailHelix, mesh.headHelix);
    QCOMPARE(other.headHelix, mesh.tailHelix);
  }

  /// n_0 = -sin(psi) l + cos(psi) e: on each gear the tangential force F, F tan(psi) along the line where the
  /// cones touch, and F tan(alpha_t) apart; all shafts are in equilibrium.
  void spiralTeethPushAlongTheirCones() {
    for (const bool isLeft : {false, true}) {
      Mechanism pair = conePair(20, 40, "bevel");
      GearMesh& drawn = pair.gearMeshes[0];
      drawn.module = Number(2);
      drawn.helixAngle = Number(35);
      if (isLeft) drawn.hand = Hand::left;
      pair = withHeadLoad(pair, 10);
      const test::StaticsCase worked(pair);
      const StaticsReport report = test::reportOf(worked);
      QVERIFY(report.isAnswered() && report.agreement && report.agreement->equal);
      const ToothForce& force = report.forces.meshes[0];
      const double around = 10 / 0.040;
      QVERIFY(std::abs(std::abs(force.tangential) - around) < 1e-9);
      QVERIFY(std::abs(force.axial - around * std::tan(35 * kConeDegree)) < 1e-9);
      const double transverse = std::tan(20 * kConeDegree) / std::cos(35 * kConeDegree);
      QVERIFY(std::abs(force.separating - around * transverse) < 1e-9);
      // Across the teeth: no part along their trace, cos(psi) l + sin(psi) k x u on the tail's gear.
      const MeshGeometry mesh = placedCones(pair);
      const Vector3 line = unit(mesh.pitchPoint);
      const Vector3 around1 = unit(cross(Vector3{0, 0, 1}, mesh.pitchPoint));
      const double angle = (isLeft ? -35 : 35) * kConeDegree;
      const double side = mesh.pitchPoint[2] < 0 ? -1 : 1;
      const Vector3 trace = std::cos(angle) * line + (side * std::sin(angle)) * around1;
      QVERIFY(std::abs(dot(force.force, trace)) < 1e-9 * around);
      for (const BearingReaction& bearing : report.forces.bearings)
        QVERIFY(std::abs(length(bearing.force) - length(force.force)) < 1e-9);
    }
  }

  void aFaceGearPushesItsPinionAlongItsRadius() {
    const test::StaticsCase worked(withHeadLoad(conePair(20, 60, "faceGear"), 10));
    const StaticsReport report = test::reportOf(worked);
    QVERIFY(report.isAnswered() && report.agreement && report.agreement->equal);
    const ToothForce& force = report.forces.meshes[0];
    QVERIFY(std::abs(force.separating - std::abs(force.tangential) * std::tan(20 * kConeDegree)) < 1e-9);
    // The pinion's axis is z: nothing along it.
    QVERIFY(std::abs(force.force[2]) < 1e-9);
    QCOMPARE(force.axial, 0.0);
  }

  /// The force is along the contact normal: across the trace of the teeth, and its moments about both axes
  /// are in the ratio of the teeth.
  void aHypoidPushesAcrossItsTeeth() {
    Mechanism axle = conePair(10, 41, "hypoid", "20");
    axle.gearMeshes[0].module = Number(4);
    axle = withHeadLoad(axle, 100);
    const test::StaticsCase worked(axle);
    const StaticsReport report = test::reportOf(worked);
    QVERIFY(report.isAnswered() && report.agreement && report.agreement->equal);
    const ToothForce& force = report.forces.meshes[0];
    const MeshGeometry mesh = placedCones(axle);
    const Vector3 r1 = cross(Vector3{0, 0, 1}, mesh.tailToPitch);
    const Vector3 r2 = cross(Vector3{1, 0, 0}, mesh.tailToPitch - mesh.tailToHead);
    const Rational rate = turnedOn(axle);
    const Vector3 slip = r1 - rate.toDouble() * r2;
    QVERIFY(std::abs(dot(force.force, slip)) < 1e-7 * length(force.force) * length(slip));
    QVERIFY(std::abs(std::abs(dot(force.force, r2)) / 1000 - 100) < 1e-6);
    QVERIFY(std::abs(std::abs(dot(force.force, r1)) / 1000 - 1000.0 / 41) < 1e-6);
    QVERIFY(std::abs(force.separating -
                     std::hypot(force.tangential, force.axial) * std::tan(20 * kConeDegree)) < 1e-6);
  }

  /// Power lost by sliding along the teeth: mu N |slip|, of a force N across them.
  void aHypoidLosesWhatItsTeethRub() {
    Mechanism axle = conePair(10, 41, "hypoid", "20");
    axle.gearMeshes[0].module = Number(4);
    axle.gearMeshes[0].friction = Number::fromText("0.05");
    const Placement placement = placementOf(axle);
    const auto both = efficienciesOf(axle, placement, meshContacts(axle, placement));
    const MeshGeometry& mesh = *placement.meshes[0];
    const Vector3 r1 = cross(Vector3{0, 0, 1}, mesh.tailToPitch);
    const Vector3 r2 = cross(Vector3{1, 0, 0}, mesh.tailToPitch - mesh.tailToHead);
    const double rate = turnedOn(axle).toDouble();
    const Vector3 slip = r1 - rate * r2;
    // Pinion drives at speed 1: the gear's torque follows from N and mu N against the sliding of the driver.
    const Vector3 trace = unit(slip);
    const double share = 0.05 / std::cos(20 * kConeDegree);
    const Vector3 normal = dot(mesh.normal, r1) > 0 ? mesh.normal : -1.0 * mesh.normal;
    const Vector3 onDriven = normal + share * trace;
    const double efficiency = rate * dot(onDriven, r2) / dot(onDriven, r1);
    QVERIFY2(std::abs(both[0].value.toDouble() - efficiency) < 1e-9,
             qPrintable(QString("%1 %2").arg(both[0].value.toDouble()).arg(efficiency)));
    QVERIFY(efficiency < 1 && efficiency > 0.9);
  }

  void whatDoesNotFitIsSaid() {
    QCOMPARE(coneDetail(conePair(18, 40, "faceGear", "0", {"1", "0", "1"})), Detail::kindAgainstAxes);
    QCOMPARE(coneDetail(conePair(18, 40, "faceGear", "30")), Detail::skewAxes);
    QCOMPARE(coneDetail(conePair(20, 20, "faceGear")), Detail::teethAgainstRadii);
    QCOMPARE(coneDetail(conePair(10, 41, "hypoid", "0")), Detail::kindAgainstAxes);
    QCOMPARE(coneDetail(conePair(10, 41, "hypoid", "20", {"1", "0", "1"})), Detail::kindAgainstAxes);
    Mechanism far = conePair(10, 41, "hypoid", "90");
    far.gearMeshes[0].module = Number(4);
    QCOMPARE(coneDetail(far), Detail::teethAgainstRadii);
    far.gearMeshes[0].pitchPoint = NumberTriple{Number(0), Number(50), Number(0)};
    QCOMPARE(coneDetail(far), Detail::pitchPointOffPerpendicular);
    Mechanism steep = conePair(10, 41, "hypoid", "10");
    steep.gearMeshes[0].pitchPoint = NumberTriple{Number(200), Number(5), Number(200)};
    QCOMPARE(coneDetail(steep), Detail::helixAgainstTeeth);
    Mechanism bevel = conePair(18, 40, "bevel");
    bevel.gearMeshes[0].helixAngle = Number(20);
    bevel.gearMeshes[0].herringbone = true;
    QCOMPARE(coneDetail(bevel), Detail::helixAgainstTeeth);
    for (const char* kind : {"faceGear", "hypoid"}) {
      Mechanism pair = conePair(18, 40, kind, kind[0] == 'h' ? "10" : "0");
      pair.gearMeshes[0].helixAngle = Number(10);
      QVERIFY(hasErrors(wellFormedDiagnostics(pair)));
      const auto bare = withMeshKind(std::move(pair), MeshId("5"), coneKind(kind));
      QVERIFY(bare.has_value() && !hasErrors(wellFormedDiagnostics(*bare)));
    }
  }

  /// A hypoid at an angle of its own, by its pitch point.
  void aPitchPointAllowsAnyAngle() {
    Mechanism pair = conePair(10, 41, "hypoid", "20", {"4", "0", "3"});
    pair.gearMeshes[0].pitchPoint = NumberTriple{Number(12), Number(8), Number(80)};
    const Rational rate = turnedOn(pair);
    QCOMPARE(rate.abs(), Rational(10, 41));
    QVERIFY(std::abs(slipAlongNormal(pair, rate)) < 1e-9);
  }

  void documentsSayVersionTwoAndComeBack() {
    for (const char* kind : {"faceGear", "hypoid"}) {
      const Mechanism pair = conePair(18, 40, kind, kind[0] == 'h' ? "10" : "0");
      QCOMPARE(fileVersionOf(pair), 2);
      const auto read = readMechanism(writeMechanism(pair));
      QVERIFY(read.has_value());
      QVERIFY(*read == pair);
    }
  }

  /// The cones of a hypoid touch in the pitch point, their common tangent plane is the pitch plane, and each
  /// says that it stands in for teeth.
  void aHypoidIsDrawnAsItsCones() {
    Mechanism axle = conePair(10, 41, "hypoid", "20");
    axle.gearMeshes[0].module = Number(4);
    const Placement placement = placementOf(axle);
    const GearTrain train = trainOf(axle, placement);
    QCOMPARE(train.gears.size(), std::size_t{2});
    const MeshGeometry& mesh = *placement.meshes[0];
    const Vector3 r1 = cross(Vector3{0, 0, 1}, mesh.tailToPitch);
    const Vector3 r2 = cross(Vector3{1, 0, 0}, mesh.tailToPitch - mesh.tailToHead);
    const Vector3 across = unit(cross(r1, r2));
    const Eigen::Vector3d plane(across[0], across[1], across[2]);
    const Eigen::Vector3d point(mesh.pitchPoint[0], mesh.pitchPoint[1], mesh.pitchPoint[2]);
    for (const TrainGear& gear : train.gears) {
      QVERIFY(!isToothed(gear.spec));
      const Eigen::Vector3d line = point - gear.pose.translation();
      const Eigen::Vector3d axis = gear.pose.linear().col(2);
      QVERIFY(std::abs(std::acos(line.normalized().dot(axis)) - gear.spec.coneAngle) < 1e-6);
      QVERIFY(std::abs(line.dot(plane)) < 1e-9 * line.norm());
      QVERIFY(std::abs(line.cross(axis).norm() - pitchRadius(gear.spec)) < 1e-3);
      // The outward normal of the cone where they touch is that of the plane.
      const Eigen::Vector3d out = (line - line.dot(axis) * axis).normalized();
      const Eigen::Vector3d normal =
          std::cos(gear.spec.coneAngle) * out - std::sin(gear.spec.coneAngle) * axis;
      QVERIFY(normal.cross(plane).norm() < 1e-5);
    }
    const Diagnostics found = toothDiagnostics(axle, train);
    QCOMPARE(std::count_if(found.begin(), found.end(),
                           [](const Diagnostic& each) {
                             return each.code == Code::standIn && each.severity() == Severity::info;
                           }),
             2);
  }
};

QTEST_APPLESS_MAIN(ConePairsTest)
#include "test_cone_pairs.moc"

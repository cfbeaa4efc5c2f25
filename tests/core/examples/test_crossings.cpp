#include <QTest>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include "core/mechanism/document_format/file_version.h"
#include "core/mechanism/document_format/mechanism_file.h"
#include "core/mechanism/geometry_edits/module_fit.h"
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

constexpr double kDegree = std::numbers::pi / 180;

MeshKind crossing(const char* name) {
  return *meshKindFrom(name);
}

/// The rate of the joint behind the input of 1, after both methods agreed.
Rational passedOn(const Mechanism& mechanism) {
  const SnapshotPtr snapshot = snapshotOf(mechanism);
  if (hasErrors(snapshot->diagnostics)) throw std::runtime_error(snapshot->diagnostics.front().message);
  const SolvedKinematics& solved = *snapshot->solved;
  if (!solved.ttExact || !solved.agreement || !solved.agreement->equal || solved.agreement->compared == 0)
    throw std::runtime_error("the methods disagree");
  return solved.exact->rates[1];
}

/// Gears 1 and 2 on axes of the ground: the second one `apart` above the first, its direction as given.
Mechanism crossedPair(int tail, int head, const char* kind,
                      const std::vector<std::string>& direction = {"0", "1", "0"},
                      const std::string& apart = "100") {
  return TrainSketch(2)
      .axis("a", {"0", "0", "0"}, {"1", "0", "0"})
      .axis("b", {"0", "0", apart}, direction)
      .joint(0, 1, "a")
      .joint(0, 2, "b")
      .mesh(1, 2, tail, head, crossing(kind))
      .inputs({{3, "1"}})
      .build();
}

MeshGeometry placedPair(const Mechanism& mechanism) {
  const Placement placement = placementOf(mechanism);
  if (!placement.meshes[0]) throw std::runtime_error(placement.diagnostics.front().message);
  return *placement.meshes[0];
}

Detail detailOf(const Mechanism& mechanism) {
  const Placement placement = placementOf(mechanism);
  return placement.diagnostics.empty() ? Detail::none : placement.diagnostics.front().detail;
}

}  // namespace

/// Worms and crossed helical gears: numbers of books and closed forms, and laws on random pairs.
class CrossingsTest : public QObject {
  Q_OBJECT

 private slots:
  /// The worm along x below its wheel, whose axis is along y: a right-hand worm turns it against +y.
  void aWormTurnsItsWheelByItsHand() {
    Mechanism right = crossedPair(1, 40, "worm");
    QCOMPARE(passedOn(right), Rational(1, 40));
    right.gearMeshes[0].hand = Hand::left;
    QCOMPARE(passedOn(right), Rational(-1, 40));
    QCOMPARE(passedOn(crossedPair(1, 40, "worm", {"0", "-1", "0"})), Rational(-1, 40));
    QCOMPARE(passedOn(crossedPair(40, 2, "worm")), Rational(20));
  }

  /// A hoist: worm 1 - 40, and a planetary set 18 - 27 - 72 with the ring held on the wheel's shaft.
  void aWormWithAPlanetarySet() {
    for (const bool isLeft : {false, true}) {
      Mechanism hoist = TrainSketch(4)
                            .axis("w", {"0", "0", "0"})
                            .axis("s", {"50", "0", "0"}, {"0", "-1", "0"})
                            .axis("p", {"50", "0", "45"}, {"0", "-1", "0"})
                            .joint(0, 1, "w")
                            .joint(0, 2, "s")
                            .joint(0, 3, "s")
                            .joint(3, 4, "p")
                            .mesh(1, 2, 1, 40, crossing("worm"))
                            .mesh(2, 4, 18, 27, crossing("external"), {"50", "-60", "18"})
                            .mesh(4, 0, 27, 72, crossing("internal"), {"50", "-60", "72"})
                            .inputs({{5, "1"}})
                            .build();
      if (isLeft) hoist.gearMeshes[0].hand = Hand::left;
      const SnapshotPtr snapshot = snapshotOf(hoist);
      QVERIFY(snapshot->solved && snapshot->solved->agreement && snapshot->solved->agreement->equal);
      QCOMPARE(snapshot->solved->exact->rates[2], Rational(isLeft ? -1 : 1, 200));
    }
  }

  /// z 2/30, m 3, d_1 44: lead angle 7.7651660184 degrees, a = 67 (Machine elements, worm gears).
  void theWormOfTheBook() {
    Mechanism pair = crossedPair(2, 30, "worm", {"0", "1", "0"}, "67");
    pair.gearMeshes[0].module = Number(3);
    const MeshGeometry mesh = placedPair(pair);
    QVERIFY(std::abs(mesh.tailPitchRadius() - 22) < 1e-9);
    QVERIFY(std::abs(mesh.headPitchRadius() - 45) < 1e-9);
    QVERIFY(std::abs(mesh.headHelix / kDegree - 7.7651660184) < 1e-9);
    QVERIFY(std::abs(mesh.tailHelix / kDegree - (90 - 7.7651660184)) < 1e-9);
    QVERIFY(std::abs(2 * std::abs(mesh.tailRadius) / 2 - 2.97249050413) < 1e-9);  // m_n
    QVERIFY(mesh.derived);
  }

  /// 18 and 24 teeth with cos(beta) 3/5 and 4/5: equal radii of 30, and a ratio of 4/3.
  void theRatioIsNotThatOfTheRadii() {
    Mechanism pair = crossedPair(18, 24, "crossedHelical", {"0", "1", "0"}, "60");
    pair.gearMeshes[0].helixAngle = Number::fromDouble(std::acos(0.6) / kDegree);
    const MeshGeometry mesh = placedPair(pair);
    QVERIFY(std::abs(mesh.tailPitchRadius() - 30) < 1e-9);
    QVERIFY(std::abs(mesh.headPitchRadius() - 30) < 1e-9);
    QCOMPARE(passedOn(pair).abs(), Rational(3, 4));
  }

  /// Two right-hand gears at +90 degrees turn alike, at -90 degrees against each other.
  void twoRightHandGearsByTheWayTheirAxesCross() {
    for (const bool isPlus : {true, false}) {
      Mechanism pair = crossedPair(20, 20, "crossedHelical", {"0", isPlus ? "1" : "-1", "0"});
      const MeshGeometry mesh = placedPair(pair);
      QVERIFY(std::abs(mesh.tailHelix - 45 * kDegree) < 1e-12);
      QVERIFY(std::abs(mesh.headHelix - 45 * kDegree) < 1e-12);
      // x across y about z is +90 degrees.
      QCOMPARE(passedOn(pair), Rational(isPlus ? 1 : -1));
    }
  }

  /// n . (v_i - v_j) = 0 in the pitch point from the twists of the links alone, which is on the common
  /// perpendicular; the traces coincide; and the ratio is that of the teeth.
  void theToothNormalIsALineOfAction() {
    std::mt19937_64 random(7);
    const auto below = [&](int most) { return static_cast<int>(random() % static_cast<unsigned>(most)); };
    int tried = 0;
    for (int round = 0; round < 600; ++round) {
      const auto number = [&](int most) { return std::to_string(below(2 * most) - most); };
      const bool isWorm = round % 3 == 0;
      std::vector<std::string> second{number(9), number(9), number(9)};
      if (isWorm) second = {"0", number(9), "4"};
      TrainSketch sketch(2);
      sketch.axis("a", {number(50), number(50), number(50)}, {round % 2 == 0 ? "1" : "-1", "0", "0"})
          .axis("b", {number(50), number(50), std::to_string(90 + below(90))}, second)
          .joint(0, 1, "a")
          .joint(0, 2, "b")
          .mesh(1, 2, isWorm ? 1 + below(8) : 12 + below(30), 12 + below(40),
                crossing(isWorm ? "worm" : "crossedHelical"))
          .inputs({{3, "1"}});
      if (second == std::vector<std::string>{"0", "0", "0"}) continue;
      Mechanism pair = sketch.build();
      GearMesh& drawn = pair.gearMeshes[0];
      if (below(2) == 0) drawn.hand = below(2) == 0 ? Hand::right : Hand::left;
      if (!isWorm && below(2) == 0) drawn.helixAngle = Number(below(80));
      const Placement placement = placementOf(pair);
      if (!placement.meshes[0]) continue;  // parallel, meeting, or an angle at which teeth run round
      ++tried;
      const MeshGeometry& mesh = *placement.meshes[0];
      const AxisLine& a = placement.lineOfClass(mesh.tailClass);
      const AxisLine& b = placement.lineOfClass(mesh.headClass);
      const Rational rate = passedOn(pair);
      QCOMPARE(rate.abs(), Rational(drawn.tailTeeth, drawn.headTeeth));
      const Vector3 armA = mesh.pitchPoint - a.point, armB = mesh.pitchPoint - b.point;
      const Vector3 slip = cross(a.direction, armA) - rate.toDouble() * cross(b.direction, armB);
      QVERIFY(std::abs(dot(mesh.normal, slip)) < 1e-7);
      const Vector3 between = unit(cross(a.direction, b.direction));
      QVERIFY(std::abs(dot(mesh.normal, between)) < 1e-9);
      const Vector3 radial = armA - dot(armA, a.direction) * a.direction;
      QVERIFY(std::abs(length(radial) - mesh.tailPitchRadius()) < 1e-7);
      QVERIFY(length(cross(radial, between)) < 1e-7);
      QVERIFY(std::abs(std::abs(dot(mesh.normal, a.direction)) - std::abs(std::sin(mesh.tailHelix))) < 1e-9);
      QVERIFY(std::abs(std::abs(dot(mesh.normal, b.direction)) - std::abs(std::sin(mesh.headHelix))) < 1e-9);
    }
    QVERIFY(tried > 300);
  }

  /// A whole train turned, axes reversed, or tail and head exchanged: the same motion.
  void theSignDependsOnNoChoice() {
    for (const char* kind : {"worm", "crossedHelical"}) {
      const int teeth = std::string_view(kind) == "worm" ? 2 : 17;
      const Rational ratio = passedOn(crossedPair(teeth, 40, kind));
      QCOMPARE(passedOn(crossedPair(teeth, 40, kind, {"0", "-1", "0"})), -ratio);
      QCOMPARE(passedOn(crossedPair(teeth, 40, kind, {"0", "1", "0"}, "-100")),
               -ratio);  // a mirror image, same hands
      QCOMPARE(passedOn(crossedPair(40, teeth, kind, {"0", "1", "0"})), ratio.inverse());
    }
  }

  void aPitchPointGivesTheRadii() {
    Mechanism pair = crossedPair(20, 30, "crossedHelical");
    pair.gearMeshes[0].pitchPoint = NumberTriple{Number(0), Number(0), Number(45)};
    const MeshGeometry mesh = placedPair(pair);
    QVERIFY(std::abs(mesh.tailPitchRadius() - 45) < 1e-9);
    QVERIFY(std::abs(mesh.headPitchRadius() - 55) < 1e-9);
    QVERIFY(std::abs(45 * std::cos(mesh.tailHelix) / (55 * std::cos(mesh.headHelix)) - 20.0 / 30) < 1e-9);
    Mechanism worm = crossedPair(1, 40, "worm");
    worm.gearMeshes[0].pitchPoint = NumberTriple{Number(0), Number(0), Number(20)};
    QVERIFY(std::abs(placedPair(worm).headPitchRadius() - 80) < 1e-9);
  }

  void whatDoesNotFitIsSaid() {
    QCOMPARE(detailOf(crossedPair(1, 40, "worm", {"1", "0", "0"})), Detail::kindAgainstAxes);
    QCOMPARE(detailOf(crossedPair(1, 40, "worm", {"0", "1", "0"}, "0")), Detail::kindAgainstAxes);
    QCOMPARE(detailOf(crossedPair(1, 40, "worm", {"1", "1", "0"})), Detail::kindAgainstAxes);
    QCOMPARE(detailOf(crossedPair(20, 20, "worm")), Detail::wormTeeth);
    QCOMPARE(detailOf(crossedPair(9, 40, "worm")), Detail::wormTeeth);
    Mechanism pair = crossedPair(1, 40, "worm");
    pair.gearMeshes[0].module = Number(5);
    QCOMPARE(detailOf(pair), Detail::teethAgainstRadii);  // the wheel is as large as the distance
    pair = crossedPair(20, 20, "crossedHelical");
    pair.gearMeshes[0].helixAngle = Number::fromText("89.5");
    QCOMPARE(detailOf(pair), Detail::helixAgainstTeeth);
    pair.gearMeshes[0].helixAngle = Number(45);
    pair.gearMeshes[0].module = Number(2);
    QCOMPARE(detailOf(pair), Detail::teethAgainstRadii);
    pair.gearMeshes[0].module.reset();
    pair.gearMeshes[0].pitchPoint = NumberTriple{Number(1), Number(0), Number(50)};
    QCOMPARE(detailOf(pair), Detail::pitchPointOffPerpendicular);
    pair.gearMeshes[0].pitchPoint = NumberTriple{Number(0), Number(0), Number(120)};
    QCOMPARE(detailOf(pair), Detail::pitchPointOffPerpendicular);
    // A mesh without a kind never becomes one of these.
    Mechanism open = crossedPair(20, 20, "crossedHelical");
    open.gearMeshes[0].kind.reset();
    QCOMPARE(detailOf(open), Detail::skewAxes);
    Mechanism worm = crossedPair(1, 40, "worm");
    worm.gearMeshes[0].helixAngle = Number(10);
    QVERIFY(hasErrors(wellFormedDiagnostics(worm)));
    worm.gearMeshes[0].helixAngle.reset();
    worm.gearMeshes[0].herringbone = true;
    QVERIFY(hasErrors(wellFormedDiagnostics(worm)));
  }

  /// Axes that the document leaves open cross at right angles, at the distance of the usual worm.
  void openAxesArePlaced() {
    for (const char* kind : {"worm", "crossedHelical"}) {
      const int teeth = std::string_view(kind) == "worm" ? 1 : 20;
      const Mechanism open = TrainSketch(2)
                                 .joint(0, 1, "a")
                                 .joint(0, 2, "b")
                                 .mesh(1, 2, teeth, 40, crossing(kind))
                                 .inputs({{3, "1"}})
                                 .build();
      const MeshGeometry mesh = placedPair(open);
      QVERIFY(mesh.derived);
      QCOMPARE(passedOn(open).abs(), Rational(teeth, 40));
    }
  }

  void theModuleIsThatOfTheCatalogue() {
    Mechanism pair = crossedPair(2, 30, "worm", {"0", "1", "0"}, "67");
    pair.gearMeshes[0].module = Number(3);
    QVERIFY(std::abs(*moduleOf(pair, placementOf(pair), 0) - 3) < 1e-12);
    pair.gearMeshes[0].module.reset();
    QVERIFY(std::abs(*moduleOf(pair, placementOf(pair), 0) - 134.0 / 40) < 1e-9);  // q = 10
  }

  void documentsSayVersionTwoAndComeBack() {
    const Mechanism pair = crossedPair(1, 40, "worm");
    QCOMPARE(fileVersionOf(pair), 2);
    const auto read = readMechanism(writeMechanism(pair));
    QVERIFY(read.has_value());
    QVERIFY(*read == pair);
  }

  /// The wheel's load of 10 N m: the worm bears it along its axis, the wheel across its own, and both are
  /// pushed apart by F_n tan(alpha_n). Both shafts are in equilibrium in all six components.
  void theWormBearsAlongItsAxisWhatTheWheelBearsAcross() {
    Mechanism pair = crossedPair(2, 30, "worm", {"0", "1", "0"}, "67");
    pair.gearMeshes[0].module = Number(3);
    pair.loads.push_back({{}, JointTorque{JointId("4"), Number(10)}, {}});
    const test::StaticsCase worked(pair);
    const StaticsReport report = test::reportOf(worked);
    QVERIFY(report.isAnswered() && report.agreement && report.agreement->equal);
    const ToothForce& force = report.forces.meshes[0];
    const double lead = 7.7651660184 * kDegree;
    const double alongWorm = 10 / 0.045;
    QVERIFY(std::abs(force.axial - alongWorm) < 1e-6);
    QVERIFY(std::abs(std::abs(force.force[0]) - alongWorm) < 1e-6);
    QVERIFY(std::abs(std::abs(force.tangential) - alongWorm * std::tan(lead)) < 1e-6);
    QVERIFY(std::abs(std::abs(force.force[1]) - alongWorm * std::tan(lead)) < 1e-6);
    QVERIFY(std::abs(force.force[2] - alongWorm / std::cos(lead) * std::tan(20 * kDegree)) < 1e-6);  // apart
    const auto values = numbersOf(report.solution());
    QVERIFY(std::abs(std::abs(values.back()) - 10.0 * 2 / 30) < 1e-12);
    for (const BearingReaction& bearing : report.forces.bearings)
      QVERIFY(std::abs(length(bearing.force) - length(force.force)) < 1e-9);
  }

  void aWheelCannotDriveASelfLockingWorm() {
    for (const bool isLocking : {true, false}) {
      Mechanism pair = crossedPair(1, 40, "worm");
      pair.gearMeshes[0].efficiency = Number::fromText(isLocking ? "0.45" : "0.9");
      pair.inputs = std::vector<Input>{{JointId("4"), Number(1), {}}};  // the wheel drives
      pair.loads.push_back({{}, JointTorque{JointId("3"), Number(-1)}, {}});
      const test::StaticsCase worked(pair);
      StaticsOptions options;
      options.losses = true;
      const StaticsReport report = test::reportOf(worked, options);
      QVERIFY(report.lossy.has_value());
      QCOMPARE(report.lossy->outcome == LossySolution::Outcome::selfLocking, isLocking);
      const bool isTold = std::any_of(report.diagnostics.begin(), report.diagnostics.end(),
                                      [](const Diagnostic& each) { return each.code == Code::selfLocking; });
      QCOMPARE(isTold, isLocking);
    }
  }

  /// z 1/40, q 10, eta 1/2: mu' 5/51, back 2/103; it locks below eta = (1 - tan^2 g) / 2 = 99/200.
  void aWormLocksBackwardExactlyWhereItsLeadIsFlat() {
    Mechanism pair = crossedPair(1, 40, "worm");
    const auto passes = [&](const Rational& stated) {
      pair.gearMeshes[0].efficiency = Number(stated);
      const auto both = efficienciesOf(pair, placementOf(pair));
      return std::pair(both[0].value, *both[0].backward);
    };
    QCOMPARE(passes(Rational(1, 2)), std::pair(Rational(1, 2), Rational(2, 103)));
    QCOMPARE(passes(Rational(99, 200)), std::pair(Rational(99, 200), Rational(0)));
    QVERIFY(passes(Rational(49, 100)).second.sign() < 0);
    QVERIFY(passes(Rational(1)).second == Rational(1));
    // 45/45: (1 - mu') / (1 + mu') both ways.
    Mechanism helical = crossedPair(20, 20, "crossedHelical");
    helical.gearMeshes[0].efficiency = Number::fromText("0.9");
    const auto both = efficienciesOf(helical, placementOf(helical));
    QVERIFY(std::abs(both[0].value.toDouble() - 0.9) < 1e-12);
    QVERIFY(std::abs(both[0].backward->toDouble() - 0.9) < 1e-12);
  }
};

QTEST_GUILESS_MAIN(CrossingsTest)
#include "test_crossings.moc"

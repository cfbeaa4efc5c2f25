#include <QTest>
#include <cmath>
#include <random>

#include "core/machine/body_layout/derived_geometry.h"
#include "core/machine/solids/solid.h"
#include "core/machine/train/train.h"
#include "core/mechanism/document_format/file_version.h"
#include "core/mechanism/document_format/mechanism_file.h"
#include "core/mechanism/document_format/mechanism_table.h"
#include "core/mechanism/geometry_edits/fitted_edits.h"
#include "core/mechanism/model/edits.h"
#include "core/mechanism/model/shift_edits.h"
#include "core/mechanism/model/validate.h"
#include "core/presentation/schematic/schematic.h"
#include "core/theory/states/state_edits.h"
#include "core/theory/states/state_solution.h"
#include "tests/core/support/gearboxes.h"
#include "tests/core/support/snapshot_of.h"
#include "tests/core/support/statics_case.h"
#include "tests/core/support/train_sketch.h"

using namespace geargraph;
using test::snapshotOf;
using test::TrainSketch;

namespace {

MeshKind kindNamed(const char* name) {
  return *meshKindFrom(name);
}

/// The rate of a joint by its label, after both methods agreed on all of them.
Rational rateOf(const Mechanism& mechanism, int label) {
  const SnapshotPtr snapshot = snapshotOf(mechanism);
  if (hasErrors(snapshot->diagnostics)) throw std::runtime_error(snapshot->diagnostics.front().message);
  const SolvedKinematics& solved = *snapshot->solved;
  if (!solved.ttExact || !solved.agreement || !solved.agreement->equal || solved.agreement->compared == 0)
    throw std::runtime_error("the methods disagree");
  return solved.exact->rates[label - mechanism.n() - 1];
}

/// Pulleys 1 and 2 of 20 and 40 teeth on two axes of the ground, 120 apart.
TrainSketch twoPulleys(const std::vector<std::string>& headDirection = {"0", "0", "1"}) {
  TrainSketch train(2);
  train.axis("a", {"0", "0", "0"}).axis("b", {"120", "0", "0"}, headDirection);
  return train.joint(0, 1, "a").joint(0, 2, "b").mesh(1, 2, 20, 40, kindNamed("belt")).inputs({{3, "1"}});
}

Mechanism crossed(Mechanism mechanism) {
  for (GearMesh& mesh : mechanism.gearMeshes) mesh.crossed = true;
  return mechanism;
}

/// A wave generator or crank 1 on the main axis, the disc 2 on its eccentric, the output 3 on the main axis;
/// the ring is the ground's.
Mechanism eccentricDrive(const std::string& eccentricity, int disc, int ring) {
  return TrainSketch(3)
      .axis("a", {"0", "0", "0"})
      .axis("x", {eccentricity, "0", "0"})
      .joint(0, 1, "a")
      .joint(1, 2, "x")
      .joint(0, 3, "a")
      .mesh(2, 0, disc, ring, MeshKind::internal)
      .mesh(2, 3, 1, 1, kindNamed("pins"))
      .inputs({{4, "1"}})
      .build();
}

/// RV: sun 1 and output 2 on the main axis, planet 3 on the output, the disc's eccentric 4 (virtual: it turns
/// with the planet), disc 5; 39 on 40 pins of the ground.
Mechanism rvReducer(int sun, int planet, int pins) {
  return TrainSketch(5)
      .axis("a", {"0", "0", "0"})
      .axis("p", {"24", "0", "0"})
      .axis("x", {"3/2", "0", "0"})
      .joint(0, 1, "a")
      .joint(0, 2, "a")
      .joint(2, 3, "p")
      .joint(2, 4, "a")
      .joint(4, 5, "x")
      .mesh(1, 3, sun, planet, MeshKind::external)
      .mesh(3, 4, 1, 1, kindNamed("pins"))
      .mesh(5, 0, pins - 1, pins, MeshKind::internal)
      .mesh(5, 2, 1, 1, kindNamed("pins"))
      .inputs({{6, "1"}})
      .build();
}

/// Sturmey-Archer AW: sprocket on the carrier 3, hub on the ring 2, sun 1 braked (B) or free; freewheel F
/// lets the hub run ahead of the carrier.
Mechanism overdrive() {
  Mechanism hub = test::planetary(20, 20);
  test::addBrake(hub, "B", 1);
  hub = *withFreewheel(std::move(hub), LinkId("3"), LinkId("2"), "F");
  test::addState(hub, "direct", {}, 3, 2);
  test::addState(hub, "high", {"B"}, 3, 2);
  return hub;
}

/// Nexus-7: sprocket with the first ring 1, carrier 2, suns 3..6 of 42, 36, 30 and 36 teeth, stepped planets
/// 7 (14, 20) and 8 (14, 19), hub with the second ring 9. Brakes on the suns, clutch K (1, 2), freewheel F.
/// http://konstantin.shemyak.com/cycling/nexus7.html, 2009.
Mechanism sevenSpeedHub() {
  TrainSketch train(9);
  train.axis("a", {"0", "0", "0"}).axis("p", {"56", "0", "0"}).axis("q", {"-56", "0", "0"});
  for (const int link : {1, 2, 3, 4, 5, 6}) train.joint(0, link, "a");
  train.joint(2, 7, "p").joint(2, 8, "q").joint(0, 9, "a");
  train.mesh(3, 7, 42, 14, MeshKind::external)
      .mesh(7, 1, 14, 72, MeshKind::internal)
      .mesh(4, 7, 36, 20, MeshKind::external)
      .mesh(6, 8, 36, 14, MeshKind::external)
      .mesh(8, 9, 14, 66, MeshKind::internal)
      .mesh(5, 8, 30, 19, MeshKind::external);
  Mechanism hub = train.build();
  for (const auto& [brake, sun] : {std::pair("S1", 3), {"S2", 4}, {"S3", 5}, {"S4", 6}})
    test::addBrake(hub, brake, sun);
  test::addClutch(hub, "K", 1, 2);
  hub = *withFreewheel(std::move(hub), LinkId("2"), LinkId("9"), "F");
  test::addState(hub, "1", {"S1"}, 1, 9);
  test::addState(hub, "2", {"S2"}, 1, 9);
  test::addState(hub, "3", {"S1", "S3"}, 1, 9);
  test::addState(hub, "4", {"S2", "S3"}, 1, 9);
  test::addState(hub, "5", {"S2", "S4"}, 1, 9);
  test::addState(hub, "6", {"K", "S3"}, 1, 9);
  test::addState(hub, "7", {"K", "S4"}, 1, 9);
  return hub;
}

std::vector<StateSolution> statesOf(const Mechanism& mechanism) {
  const SnapshotPtr snapshot = snapshotOf(mechanism);
  if (!snapshot->states) throw std::runtime_error("no states");
  return *snapshot->states;
}

std::vector<std::string> codeNamesOf(const Diagnostics& diagnostics) {
  std::vector<std::string> codes;
  for (const Diagnostic& each : diagnostics) {
    const std::string_view detail = detailName(each.detail);
    codes.emplace_back(detail.empty() ? codeName(each.code) : detail);
  }
  return codes;
}

bool hasCode(const Diagnostics& diagnostics, const char* code) {
  const auto codes = codeNamesOf(diagnostics);
  return std::find(codes.begin(), codes.end(), code) != codes.end();
}

}  // namespace

/// Belts, pins and what is built from them; freewheels. The numbers are those of the makers and of
/// transmissions by others, or closed forms.
class TransmissionsTest : public QObject {
  Q_OBJECT

 private slots:
  // --- belts ---

  void pulleysTurnAlikeAndAgainstEachOtherWhereTheBeltCrosses() {
    QCOMPARE(rateOf(twoPulleys().build(), 4), Rational(1, 2));
    QCOMPARE(rateOf(crossed(twoPulleys().build()), 4), Rational(-1, 2));
    QCOMPARE(rateOf(twoPulleys({"0", "0", "-1"}).build(), 4), Rational(-1, 2));
    QCOMPARE(rateOf(crossed(twoPulleys({"0", "0", "-1"}).build()), 4), Rational(1, 2));
  }

  void runningDiametersGiveTheRatioExactly() {
    Mechanism train = twoPulleys().build();
    GearMesh& belt = train.gearMeshes[0];
    belt.tailDiameter = Number::fromText("28.5");
    belt.headDiameter = Number::fromText("100/3");
    settleWeights(belt);
    QCOMPARE(rateOf(train, 4), Rational(171, 200));
  }

  /// n . (v_i(P) - v_j(P)) = 0, from the twists of the links alone; the radii are those of the pulleys.
  void theStrandIsALineOfAction() {
    std::mt19937_64 random(4);
    for (int round = 0; round < 200; ++round) {
      const auto number = [&](int most) {
        return std::to_string(static_cast<int>(random() % unsigned(most)));
      };
      const bool turned = random() % 2 == 0;
      TrainSketch sketch(2);
      sketch.axis("a", {number(50), number(50), number(50)}, {"1", "2", "2"})
          .axis("b", {"300", number(50), number(50)},
                turned ? std::vector<std::string>{"-2", "-4", "-4"} : std::vector<std::string>{"1", "2", "2"})
          .joint(0, 1, "a")
          .joint(0, 2, "b")
          .mesh(1, 2, 10 + static_cast<int>(random() % 40), 10 + static_cast<int>(random() % 40),
                kindNamed("belt"))
          .inputs({{3, "1"}});
      Mechanism train = sketch.build();
      if (random() % 2 == 0) train = crossed(train);
      train.gearMeshes[0].pitch = *Number::fromText("5");
      const double rate = rateOf(train, 4).toDouble();
      const Placement placement = placementOf(train);
      const MeshGeometry& mesh = *placement.meshes[0];
      const AxisLine& a = placement.lineOfClass(mesh.tailClass);
      const AxisLine& b = placement.lineOfClass(mesh.headClass);
      const Vector3 slip = cross(a.direction, mesh.pitchPoint - a.point) -
                           rate * cross(b.direction, mesh.pitchPoint - b.point);
      QVERIFY(std::abs(dot(mesh.normal, slip)) < 1e-9);
      QVERIFY(std::abs(dot(mesh.normal, a.direction)) < 1e-12);
      const double perTooth = 5 / (2 * std::numbers::pi);
      QVERIFY(std::abs(std::abs(mesh.tailRadius) - perTooth * mesh.tailTeeth) < 1e-9);
      QVERIFY(std::abs(std::abs(mesh.headRadius) - perTooth * mesh.headTeeth) < 1e-9);
    }
  }

  /// The sun pulley held: w_j = w_k (1 - N_i / N_j); equal pulleys keep the outer one's direction.
  void aBeltInsideACarrierIsAPlanetaryTrain_data() {
    QTest::addColumn<int>("outer");
    QTest::addColumn<QString>("rate");
    QTest::newRow("half") << 40 << "-1/2";  // against the arm
    QTest::newRow("equal") << 20 << "-1";
    QTest::newRow("twice") << 10 << "-2";
  }
  void aBeltInsideACarrierIsAPlanetaryTrain() {
    QFETCH(int, outer);
    QFETCH(QString, rate);
    const Mechanism train = TrainSketch(2)
                                .axis("a", {"0", "0", "0"})
                                .axis("b", {"90", "0", "0"})
                                .joint(0, 1, "a")
                                .joint(1, 2, "b")
                                .mesh(0, 2, 20, outer, kindNamed("belt"))
                                .inputs({{3, "1"}})
                                .build();
    QCOMPARE(QString::fromStdString(rateOf(train, 4).toString()), rate);
  }

  /// ros2_control's FourBarLinkageTransmission: q1 = a1/4, q2 = a2/4 - a1/4.
  void aScaraWithMotorsAtItsBase() {
    const Mechanism scara = TrainSketch(5)
                                .axis("a", {"0", "0", "0"})
                                .axis("m", {"-120", "0", "0"})
                                .axis("k", {"0", "-120", "0"})
                                .axis("e", {"200", "0", "0"})
                                .joint(0, 1, "a")  // 6: the arm
                                .joint(0, 2, "m")  // 7: motor 1
                                .joint(0, 3, "k")  // 8: motor 2
                                .joint(0, 4, "a")  // 9: the pulley that passes on
                                .joint(1, 5, "e")  // 10: the forearm
                                .mesh(2, 1, 20, 80, kindNamed("belt"))
                                .mesh(3, 4, 20, 80, kindNamed("belt"))
                                .mesh(4, 5, 40, 40, kindNamed("belt"))
                                .inputs({{7, "3"}, {8, "5"}})
                                .build();
    QCOMPARE(rateOf(scara, 6), Rational(3, 4));
    QCOMPARE(rateOf(scara, 10), Rational(5 - 3, 4));
  }

  /// F = M / r along the strand that pulls; the bearings bear it, the shafts' torques are 1 : 2.
  void theTightStrandBearsTheLoad() {
    for (const bool isReversed : {false, true}) {
      Mechanism train = twoPulleys().build();
      train.gearMeshes[0].tailDiameter = Number(40);
      train.gearMeshes[0].headDiameter = Number(80);
      settleWeights(train.gearMeshes[0]);
      train.loads.push_back({{}, JointTorque{JointId("4"), Number(isReversed ? -10 : 10)}, {}});
      const test::StaticsCase worked(train);
      const StaticsReport report = test::reportOf(worked);
      QVERIFY(report.isAnswered() && report.agreement && report.agreement->equal);
      const ToothForce& force = report.forces.meshes[0];
      QVERIFY(std::abs(length(force.force) - 250) < 1e-9);
      QCOMPARE(force.separating, 0.0);
      QVERIFY(force.force[0] < 0);  // towards the tail's axis: a belt pulls
      const Vector3 moment = cross(force.point - Vector3{120, 0, 0}, force.force);
      QVERIFY(std::abs(std::abs(moment[2]) - 10'000) < 1e-6);
      QVERIFY(std::abs(length(report.forces.bearings[1].force) - 250) < 1e-9);
      const auto values = numbersOf(report.solution());
      QVERIFY(std::abs(std::abs(values.back()) - 5) < 1e-12);
    }
  }

  void anImpossibleBeltIsNamed() {
    Mechanism wide = twoPulleys().build();
    wide.gearMeshes[0].pitch = Number(50);
    QVERIFY(hasCode(snapshotOf(wide)->diagnostics, "teeth-geometry/belt"));
    const Mechanism across = twoPulleys({"0", "1", "0"}).build();
    QVERIFY(hasCode(snapshotOf(across)->diagnostics, "pitch-geometry/kind"));
    const Mechanism skew = twoPulleys({"0", "1", "1"}).build();
    QVERIFY(hasCode(snapshotOf(skew)->diagnostics, "pitch-geometry/kind"));
  }

  void aBeltHasPulleysAndAStrandIn3D() {
    for (const bool isCrossed : {false, true}) {
      Mechanism train = twoPulleys().build();
      if (isCrossed) train = crossed(train);
      const DerivedGeometry geometry(std::make_shared<const Mechanism>(train));
      const GearTrain& wheels = *geometry.train();
      QCOMPARE(wheels.gears.size(), std::size_t{2});
      QCOMPARE(wheels.strands.size(), std::size_t{1});
      QVERIFY(wheels.meshes.empty());
      for (const LinkBody& body : wheels.bodies) QVERIFY(signedVolume(body.solid()) > 0);
      QVERIFY(geometry.diagnostics()->empty());
      bool isDrawn = false;
      for (const Mark& mark : schematicDrawing(schematicGeometry(train), {}).marks)
        isDrawn = isDrawn || mark.element == ElementId(train.gearMeshes[0].id);
      QVERIFY(isDrawn);
    }
  }

  // --- pins, and the sets made with them ---

  void setsWithPinsHaveTheRatiosOfTheirMakers() {
    QCOMPARE(rateOf(eccentricDrive("1", 200, 202), 6), Rational(-1, 100));  // strain wave
    QCOMPARE(rateOf(eccentricDrive("1", 68, 70), 6), Rational(-1, 34));     // OS-ARM
    QCOMPARE(rateOf(eccentricDrive("1", 15, 16), 6), Rational(-1, 15));     // cycloidal, 16 pins
    QCOMPARE(rateOf(eccentricDrive("2", 38, 40), 6), Rational(-1, 19));     // KHV
    // Disc against crank: -16/15.
    QCOMPARE(rateOf(eccentricDrive("1", 15, 16), 5), Rational(-16, 15));
    // Nabtesco: R = 1 + z2/z1 z4.
    QCOMPARE(rateOf(rvReducer(12, 36, 40), 7), Rational(1, 121));
    QCOMPARE(rateOf(rvReducer(16, 32, 40), 7), Rational(1, 81));
    QCOMPARE(rateOf(rvReducer(10, 26, 40), 7), Rational(1, 105));
    // The planet turns by -40/121 against the output, the eccentric with it.
    QCOMPARE(rateOf(rvReducer(12, 36, 40), 8), Rational(-40, 121));
    QCOMPARE(rateOf(rvReducer(12, 36, 40), 9), Rational(-40, 121));
  }

  void aCompoundCycloidTurnsTheOtherWay() {
    const Mechanism drive = TrainSketch(3)
                                .axis("a", {"0", "0", "0"})
                                .axis("x", {"1", "0", "0"})
                                .joint(0, 1, "a")
                                .joint(1, 2, "x")
                                .joint(0, 3, "a")
                                .mesh(2, 0, 8, 9, MeshKind::internal)
                                .mesh(2, 3, 7, 8, MeshKind::internal)
                                .inputs({{4, "1"}})
                                .build();
    QCOMPARE(rateOf(drive, 6), Rational(1, 64));
  }

  /// Held ring and held output differ by one.
  void theRingOfACycloidTurnsWhereItsDiscIsHeld() {
    const Mechanism drive = TrainSketch(3)
                                .axis("a", {"0", "0", "0"})
                                .axis("x", {"1", "0", "0"})
                                .joint(0, 1, "a")
                                .joint(1, 2, "x")
                                .joint(0, 3, "a")
                                .mesh(2, 3, 200, 202, MeshKind::internal)
                                .mesh(2, 0, 1, 1, kindNamed("pins"))
                                .inputs({{4, "1"}})
                                .build();
    QCOMPARE(rateOf(drive, 6), Rational(1, 101));
  }

  // --- documents ---

  void onlyNewMembersMakeANewVersion() {
    Mechanism old = TrainSketch(2).joint(0, 1, "a").joint(0, 2, "b").mesh(1, 2, 20, 40).build();
    QCOMPARE(fileVersionOf(old), 1);
    QCOMPARE(fileVersionOf(twoPulleys().build()), 2);
    QCOMPARE(fileVersionOf(eccentricDrive("1", 15, 16)), 2);
    QCOMPARE(fileVersionOf(overdrive()), 2);
    test::addState(old, "1", {}, 1, 2);
    QCOMPARE(fileVersionOf(old), 1);
    old.states[0].direction = Number(-1);
    QCOMPARE(fileVersionOf(old), 2);
  }

  void newKindsSurviveFileAndTable() {
    Mechanism belt = crossed(twoPulleys().build());
    belt.gearMeshes[0].pitch = Number(5);
    Mechanism smooth = twoPulleys().build();
    smooth.gearMeshes[0].tailDiameter = *Number::fromText("28.5");
    smooth.gearMeshes[0].headDiameter = *Number::fromText("100/3");
    settleWeights(smooth.gearMeshes[0]);
    Mechanism reversed = overdrive();
    reversed.states[0].direction = Number(-1);
    for (const Mechanism& each : {belt, smooth, eccentricDrive("1", 15, 16), reversed}) {
      const std::string text = writeMechanism(each);
      const auto read = readMechanism(text);
      QVERIFY2(read, read ? "" : read.error().front().message.c_str());
      QVERIFY(*read == each);
      QCOMPARE(text.find("tailTeeth") == std::string::npos,
               !statesTeeth(each.gearMeshes.back()) && each.gearMeshes.size() == 1);
    }
  }

  void contradictionsOfABeltAreSaid_data() {
    QTest::addColumn<QString>("mesh");
    QTest::newRow("crossed gears") << R"("tailTeeth": 20, "headTeeth": 40, "crossed": true)";
    QTest::newRow("pitch of gears") << R"("tailTeeth": 20, "headTeeth": 40, "pitch": 5)";
    QTest::newRow("one diameter") << R"("kind": "belt", "tailDiameter": 20, "headTeeth": 40)";
    QTest::newRow("both")
        << R"("kind": "belt", "tailDiameter": 20, "headDiameter": 30, "tailTeeth": 5, "headTeeth": 7)";
    QTest::newRow("no teeth") << R"("kind": "belt")";
    QTest::newRow("negative") << R"("kind": "belt", "tailDiameter": -20, "headDiameter": 30)";
    QTest::newRow("long ratio") << R"("kind": "belt", "tailDiameter": 20.000001, "headDiameter": 30)";
    QTest::newRow("friction") << R"("kind": "belt", "tailTeeth": 20, "headTeeth": 40, "friction": 0.1)";
    QTest::newRow("pitch point")
        << R"("kind": "belt", "tailTeeth": 20, "headTeeth": 40, "pitchPoint": [1, 0, 0])";
    QTest::newRow("pins with teeth") << R"("kind": "pins", "tailTeeth": 20, "headTeeth": 40)";
  }
  void contradictionsOfABeltAreSaid() {
    QFETCH(QString, mesh);
    const std::string text =
        R"({"format": "geargraph", "version": 2, "links": [{"id": 0}, {"id": 1}, {"id": 2}],
      "axes": [{"id": "a"}, {"id": "b"}],
      "turningJoints": [{"id": 3, "tail": 0, "head": 1, "axis": "a"}, {"id": 4, "tail": 0, "head": 2, "axis": "b"}],
      "gearMeshes": [{"id": 5, "tail": 1, "head": 2, )" +
        mesh.toStdString() + "}]}";
    const auto read = readMechanism(text);
    QVERIFY(!read);
    for (const Diagnostic& each : read.error()) QCOMPARE(codeName(each.code), "schema");
  }

  void aGearPairBecomesABeltAndGearsAgain() {
    const PlacedMechanism gears =
        TrainSketch(2).joint(0, 1, "a").joint(0, 2, "b").mesh(1, 2, 20, 40).inputs({{3, "1"}}).build();
    const MeshId mesh = gears.mechanism().gearMeshes[0].id;
    const auto belt = withKindFitted(gears, mesh, kindNamed("belt"));
    QVERIFY(belt);
    QCOMPARE(rateOf(belt->mechanism(), 4), Rational(1, 2));
    const auto back = withKindFitted(*belt, mesh, MeshKind::external);
    QVERIFY(back);
    QVERIFY(back->mechanism() == *withMeshKind(gears, mesh, MeshKind::external));
    const auto pins = withKindFitted(*belt, mesh, kindNamed("pins"));
    QVERIFY(pins && wellFormedDiagnostics(*pins).empty());
    QCOMPARE(rateOf(pins->mechanism(), 4), Rational(1));
    const auto teeth = withKindFitted(*pins, mesh, MeshKind::external);
    QVERIFY(teeth && teeth->mechanism().gearMeshes[0].tailTeeth == 20);
  }

  // --- freewheels ---

  void anOverdriveHubLocksAndOverruns() {
    const auto states = statesOf(overdrive());
    QCOMPARE(*states[0].ratio, Rational(1));
    QVERIFY(states[0].freewheels.at(0).isLocked);
    QCOMPARE(*states[1].ratio, Rational(3, 4));
    QVERIFY(!states[1].freewheels.at(0).isLocked);
    for (const StateSolution& each : states) QVERIFY(each.diagnostics.empty());
  }

  /// Pedalled backwards the carrier overruns in direct drive, and the braked sun locks it in high.
  void aHubDrivenBackwards() {
    Mechanism hub = overdrive();
    for (ShiftState& state : hub.states) state.direction = Number(-1);
    const auto states = statesOf(hub);
    QVERIFY(hasCode(states[0].diagnostics, "state-free"));
    QVERIFY(!states[1].ratio && hasCode(states[1].diagnostics, "state-locked"));
  }

  void aSevenSpeedHubHasItsSevenRatios() {
    const Mechanism hub = sevenSpeedHub();
    const auto states = statesOf(hub);
    const Rational first(12, 19), second(20, 27), third(279, 209), fourth(17, 11);
    const std::vector<Rational> hubPerSprocket{first,           second, first * third, second * third,
                                               second * fourth, third,  fourth};
    QCOMPARE(states.size(), hubPerSprocket.size());
    for (std::size_t i = 0; i < states.size(); ++i) {
      QVERIFY2(states[i].ratio, hub.states[i].name.c_str());
      QCOMPARE(states[i].ratio->inverse(), hubPerSprocket[i]);
      QCOMPARE(states[i].freewheels.at(0).isLocked, i < 2);
    }
  }

  /// The state engaged: what locks is engaged too, and both methods give its ratio.
  void aStateIsEngagedWithItsFreewheels() {
    const auto direct = withStateEngaged(overdrive(), 0);
    QVERIFY(direct);
    QVERIFY(direct->engaged == std::vector{ShiftElementId("F")});
    const SnapshotPtr snapshot = snapshotOf(*direct);
    QVERIFY(!hasErrors(snapshot->diagnostics) && snapshot->solved->agreement->equal);
    QCOMPARE(snapshot->solved->exact->rates[1], snapshot->solved->exact->rates[2]);
    const auto high = withStateEngaged(overdrive(), 1);
    QVERIFY(high && high->engaged == std::vector{ShiftElementId("B")});
    QVERIFY(!hasCode(snapshotOf(*high)->diagnostics, "freewheel-direction"));
  }

  void speedsAgainstAFreewheelAreAnError() {
    Mechanism hub = *withStateEngaged(overdrive(), 1);
    for (Input& input : *hub.inputs) input.speed = Number(-1);
    QVERIFY(hasCode(snapshotOf(hub)->diagnostics, "freewheel-direction"));
    Mechanism listed = overdrive();
    listed.states[0].engaged.push_back(ShiftElementId("F"));
    QVERIFY(!wellFormedDiagnostics(listed).empty());
  }
};

QTEST_GUILESS_MAIN(TransmissionsTest)
#include "test_transmissions.moc"

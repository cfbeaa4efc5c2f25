#include <QTest>
#include <random>

#include "core/mechanism/model/batch_edits.h"
#include "core/mechanism/model/edits.h"
#include "core/mechanism/model/fresh_ids.h"
#include "core/mechanism/model/load_edits.h"
#include "core/mechanism/model/validate.h"
#include "tests/core/support/diagnostic_codes.h"
#include "tests/core/support/mechanisms.h"

namespace geargraph {
namespace {

using test::codesOf;
using test::robotTopology;

template <class Value>
Code rejectionOf(const Expected<Value>& result) {
  return result.error().front().code;
}

ElementId link(const char* id) {
  return LinkId(id);
}

}  // namespace

class MechanismTest : public QObject {
  Q_OBJECT

 private slots:
  void limitsOfJointsTurnOverWithTheJoint() {
    const JointLimits limits{Number(-10), Number::fromText("170.5")};
    const Mechanism limited = withJointLimits(robotTopology(), JointId("8"), limits).value();
    QCOMPARE(limited.find(JointId("8"))->limits, limits);
    const Mechanism flipped = withFlipped(limited, JointId("8")).value();
    const JointLimits expected{Number::fromText("-170.5"), Number(10)};
    QCOMPARE(flipped.find(JointId("8"))->limits, expected);
    QVERIFY(withFlipped(flipped, JointId("8")).value() == limited);
    const JointLimits open{std::nullopt, Number(90)};
    QCOMPARE(opposite(open), (JointLimits{Number(-90), std::nullopt}));
    QVERIFY(withJointLimits(limited, JointId("8"), {}).value() == robotTopology());
  }

  void limitsHoldTheReferencePose() {
    const auto rejected = [](const JointLimits& limits) {
      return !withJointLimits(robotTopology(), JointId("8"), limits);
    };
    QVERIFY(rejected({Number(1), Number(170)}));
    QVERIFY(rejected({Number(-170), Number(-1)}));
    QVERIFY(rejected({Number(0), Number(0)}));
    QVERIFY(rejected({Number(1), std::nullopt}));
    QVERIFY(!rejected({Number(0), std::nullopt}));
    QVERIFY(!rejected({Number(-720), Number(720)}));
    QCOMPARE(rejectionOf(withJointLimits(robotTopology(), JointId("8"), {Number(1), Number(2)})),
             Code::schema);
    QCOMPARE(rejectionOf(withJointLimits(robotTopology(), JointId("99"), {})), Code::unknownId);
  }

  void numbersKeepTheirSpelling() {
    for (const char* text : {"22/7", "0.10", "1e-3", "-5", "0"}) {
      QCOMPARE(Number::fromText(text).value().text(), std::string(text));
    }
    QCOMPARE(Number(Rational(1, 8)).text(), std::string("0.125"));
    QCOMPARE(Number(Rational(-1, 3)).text(), std::string("-1/3"));
    QCOMPARE(Number(Rational(-1, 20)).text(), std::string("-0.05"));
    QVERIFY(Number::fromDouble(0.1).exact() == Rational(1, 10));
    QVERIFY(!Number::fromText("1e400").has_value());  // exact, but beyond every double
  }

  void numbersAreExactHoweverTheyAreWritten() {
    // Those that a double holds alone, with their text, and those that it does not.
    for (const char* text :
         {"0", "-0", "12.5", "-0.1", "1e-3", "0.001", "1e+22", "10000000000000000000000", "9007199254740993",
          "0.1000000000000000055", "22/7", "4/2", "1e-400", "3.14159"}) {
      const Number number = Number::fromText(text).value();
      const Rational exact = Rational::fromText(text).value();
      QCOMPARE(number.exact(), exact);
      QCOMPARE(number.value(), exact.toDouble());
      QCOMPARE(number.text(), std::string(text));
      QCOMPARE(number.isZero(), exact.isZero());
      const Number copy = number;  // NOLINT(performance-unnecessary-copy-initialization)
      QCOMPARE(copy, number);
      QCOMPARE(copy.text(), std::string(text));
    }
    QVERIFY(Number::fromText("22/7")->isFractionText() && !Number::fromText("0.50")->isFractionText());
  }

  void numbersOfOneValueAndTwoSpellingsDiffer() {
    for (const auto& [a, b] : {std::pair{"0.5", "0.50"}, {"0.50", "0.5"}, {"1/2", "2/4"}, {"0", "-0"}}) {
      QVERIFY(Number::fromText(a) != Number::fromText(b));
    }
    QVERIFY(Number::fromText("0.50") == Number::fromText("0.50"));
    QVERIFY(Number(2) == Number::fromText("2") && Number(2) != Number(3) && Number() == Number(0));
  }

  void numbersAreSmall() { QVERIFY(sizeof(Number) <= 2 * sizeof(double)); }

  void labelsFollowTheOrderOfTheDocument() {
    const Mechanism robot = robotTopology();
    QCOMPARE(labelOf(robot, LinkId("4")).value(), std::string("4"));
    QCOMPARE(labelOf(robot, JointId("14")).value(), std::string("14"));
    QCOMPARE(labelOf(robot, MeshId("18")).value(), std::string("18"));
    QCOMPARE(labelOf(robot, AxisId("c")).value(), std::string("c"));
    QVERIFY(!labelOf(robot, MeshId("99")).has_value());
    const Mechanism shorter = withoutElements(robot, std::array{link("3")}).value();
    QCOMPARE(labelOf(shorter, MeshId("17")).value(),
             std::string("15"));  // 6 links and 6 joints before, then the third mesh
  }

  void editsBuildAPlanetarySet() {
    Mechanism set = emptyMechanism();
    for (int i = 0; i < 3; ++i) set = withLink(set, {double(i), 0}).value();
    set = withTurningJoint(set, LinkId("0"), LinkId("1")).value();
    const AxisId sunAxis = set.turningJoints.back().axis;
    set = withTurningJoint(set, LinkId("0"), LinkId("2"), sunAxis).value();
    set = withTurningJoint(set, LinkId("2"), LinkId("3")).value();
    set = withGearMesh(set, LinkId("1"), LinkId("3"), 24, 18).value();
    QVERIFY(wellFormedDiagnostics(set).empty());
    QVERIFY(treeDiagnostics(set).empty());
    QCOMPARE(set.axes.size(), std::size_t(2));
    QCOMPARE(set.n() + set.t() + set.c(), 7);
  }

  void newIdsNeverLookAlike() {
    Mechanism mechanism = robotTopology();
    mechanism = withLink(mechanism, {}).value();
    QCOMPARE(mechanism.links.back().id.text(), std::string("19"));
  }

  void newIdsAreTheSmallestNumbersThatAreFree() {
    Mechanism odd = emptyMechanism();
    for (const char* id : {"2", "03", "+4", "5x", "99999999999999999999", "-1", "7"})
      odd.links.push_back({LinkId(id), {}, {}});
    const std::vector<std::string> wanted{"1", "3", "4", "5", "6", "8"};
    QCOMPARE(freshIds(odd, 6), wanted);
  }

  void aJointThatClosesALoopIsRejected() {
    const Mechanism robot = robotTopology();
    const auto rejected = withTurningJoint(robot, LinkId("3"), LinkId("0"));
    QCOMPARE(rejectionOf(rejected), Code::turningLoop);
    QVERIFY(rejected.error().front().detail == Detail::turningCycle);
  }

  void edgesNeedTwoKnownLinks() {
    const Mechanism robot = robotTopology();
    QCOMPARE(rejectionOf(withGearMesh(robot, LinkId("3"), LinkId("3"))), Code::selfJoint);
    QCOMPARE(rejectionOf(withTurningJoint(robot, LinkId("3"), LinkId("3"))), Code::selfJoint);
    QCOMPARE(rejectionOf(withGearMesh(robot, LinkId("3"), LinkId("x"))), Code::unknownId);
    QCOMPARE(rejectionOf(withGearMesh(robot, LinkId("3"), LinkId("4"), 0, 12)), Code::schema);
    QCOMPARE(rejectionOf(withGearMesh(robot, LinkId("3"), LinkId("4"), 12, 100'001)), Code::schema);
  }

  void deletingALinkTakesWhatNeedsItAlong() {
    Mechanism robot = robotTopology();
    robot.inputs = std::vector<Input>{{JointId("8"), Number(1), {}}, {JointId("9"), Number(1), {}}};
    robot.couplings = {{ShiftElementId("A"), ShiftElementKind::brake, {LinkId("4")}, {}}};
    robot.states = {{"1", {ShiftElementId("A")}, LinkId("4"), LinkId("3"), {}}};
    robot.wheels = {{WheelId("w"), LinkId("4"), {}, {}, {}, {}}};
    robot.view.nodes[LinkId("4")] = {1, 2};
    const Mechanism without = withoutElements(robot, std::array{link("4")}).value();
    QVERIFY(wellFormedDiagnostics(without).empty());
    QCOMPARE(without.links.size(), std::size_t(7));
    QVERIFY(without.find(JointId("8")) == nullptr);
    QVERIFY(without.find(MeshId("15")) == nullptr);
    QVERIFY(without.find(AxisId("a")) == nullptr);  // nobody else turned about it
    QVERIFY(without.find(AxisId("b")) != nullptr);
    QCOMPARE(without.inputs->size(), std::size_t(1));
    QVERIFY(without.couplings.empty() && without.wheels.empty() && without.view.nodes.empty());
    QVERIFY(without.states[0].engaged.empty() && !without.states[0].drive);
  }

  void theGroundStays() {
    QCOMPARE(rejectionOf(withoutElements(robotTopology(), std::array{link("0")})), Code::schema);
    const Mechanism turned = withGround(robotTopology(), LinkId("1")).value();
    QCOMPARE(turned.links.front().id, LinkId("1"));
    QVERIFY(treeDiagnostics(turned).empty());
  }

  void flippingAMeshTakesItsTeethAlong() {
    const Mechanism flipped = withFlipped(robotTopology(), MeshId("15")).value();
    const GearMesh& mesh = *flipped.find(MeshId("15"));
    QCOMPARE(mesh.tail, LinkId("1"));
    QCOMPARE(mesh.tailTeeth, 36);
    QCOMPARE(mesh.headTeeth, 18);
    QVERIFY(withFlipped(flipped, MeshId("15")).value() == robotTopology());
    QCOMPARE(rejectionOf(withFlipped(flipped, LinkId("1"))), Code::unknownId);
  }

  void manyArrowsAreFlippedAsOneByOne() {
    const Mechanism robot =
        withLoad(withLoad(robotTopology(), {.action = JointTorque{JointId("13"), Number(5)}}).value(),
                 {.action = JointTorque{JointId("8"), Number(5)}})
            .value();
    const std::array<ElementId, 3> arrows{JointId("9"), MeshId("15"), JointId("13")};
    Mechanism one = robot;
    for (const ElementId& arrow : arrows) one = withFlipped(one, arrow).value();
    const Mechanism flipped = withAllFlipped(robot, arrows).value();
    QVERIFY(flipped == one);
    QCOMPARE(std::get<JointTorque>(flipped.loads[0].action).torque, Number(-5));
    QCOMPARE(std::get<JointTorque>(flipped.loads[1].action).torque, Number(5));  // on a joint left as it was
    const std::array<ElementId, 2> unknown{JointId("9"), MeshId("99")};
    QCOMPARE(rejectionOf(withAllFlipped(robot, unknown)), Code::unknownId);
  }

  void axesAreRenamedWithTheirJoints() {
    const Mechanism renamed = withName(robotTopology(), AxisId("b"), "main").value();
    QCOMPARE(renamed.find(JointId("9"))->axis, AxisId("main"));
    QVERIFY(wellFormedDiagnostics(renamed).empty());
    QCOMPARE(rejectionOf(withName(robotTopology(), AxisId("b"), "c")), Code::duplicateId);
    QCOMPARE(rejectionOf(withName(robotTopology(), AxisId("b"), "")), Code::schema);
    QCOMPARE(rejectionOf(withName(robotTopology(), JointId("8"), "x")), Code::schema);
  }

  void anAxisHasADirection() {
    const NumberTriple zero{};
    QCOMPARE(rejectionOf(withAxisPlaced(robotTopology(), AxisId("a"), {}, zero)), Code::schema);
  }

  void inputsAreDistinctJoints() {
    const std::vector<Input> twice{{JointId("8"), Number(1), {}}, {JointId("8"), Number(2), {}}};
    QCOMPARE(rejectionOf(withInputs(robotTopology(), twice)), Code::duplicateId);
    const std::vector<Input> nowhere{{JointId("15"), Number(1), {}}};
    QCOMPARE(rejectionOf(withInputs(robotTopology(), nowhere)), Code::unknownId);
  }

  void looseLinksAreAllNamed() {
    Mechanism robot = robotTopology();
    robot.turningJoints.erase(robot.turningJoints.begin() + 4);  // 1 -> 2: then 2, 3 and 7 hang nowhere
    const Diagnostics diagnostics = treeDiagnostics(robot);
    QCOMPARE(codesOf(diagnostics), std::vector<Code>{Code::disconnected});
    QCOMPARE(diagnostics[0].elements, (std::vector<ElementId>{link("2"), link("3"), link("7")}));
  }

  void aRedundantBearingIsNamed() {
    Mechanism robot = robotTopology();
    robot.turningJoints.push_back({JointId("x"), LinkId("5"), LinkId("1"), AxisId("b"), Number(0), {}});
    const Diagnostics diagnostics = treeDiagnostics(robot);
    QCOMPARE(codesOf(diagnostics), std::vector<Code>{Code::turningLoop});
    QCOMPARE(diagnostics[0].elements, (std::vector<ElementId>{JointId("x"), JointId("9"), JointId("10")}));
    QVERIFY(diagnostics[0].detail == Detail::redundantBearing);
  }

  void everyLoopAndEveryLooseLinkIsReportedTogether() {
    Mechanism robot = robotTopology();
    robot.links.push_back({LinkId("lost"), "", {}});
    robot.turningJoints.push_back({JointId("x"), LinkId("5"), LinkId("3"), AxisId("e"), Number(0), {}});
    robot.turningJoints.push_back({JointId("y"), LinkId("4"), LinkId("6"), AxisId("e"), Number(0), {}});
    QCOMPARE(codesOf(treeDiagnostics(robot)),
             (std::vector<Code>{Code::disconnected, Code::turningLoop, Code::turningLoop}));
  }

  void everyFaultOfAMechanismIsFound() {
    Mechanism wrong = robotTopology();
    wrong.links.push_back({LinkId("7"), "", {}});
    wrong.turningJoints[0].axis = AxisId("nowhere");
    wrong.gearMeshes[0].head = wrong.gearMeshes[0].tail;
    wrong.gearMeshes[1].tailTeeth = 0;
    wrong.gearMeshes[2].headWheel = WheelId("none");
    wrong.axes[0].direction = NumberTriple{};
    wrong.inputs = std::vector<Input>{{JointId("99"), Number(1), {}}};
    wrong.couplings = {{ShiftElementId("C"), ShiftElementKind::clutch, {LinkId("1")}, {}}};
    wrong.states = {{"1", {ShiftElementId("Z")}, {}, {}, {}}};
    QCOMPARE(
        codesOf(wellFormedDiagnostics(wrong)),
        (std::vector<Code>{Code::duplicateId, Code::schema, Code::unknownId, Code::selfJoint, Code::schema,
                           Code::unknownId, Code::unknownId, Code::schema, Code::unknownId}));
    QVERIFY(wellFormedDiagnostics(robotTopology()).empty());
  }

  void randomEditsKeepTheMechanismWellFormed() {
    for (std::uint64_t seed = 0; seed < 50; ++seed) {
      std::mt19937_64 random(seed);
      Mechanism mechanism = emptyMechanism();
      const auto anyLink = [&] { return mechanism.links[random() % mechanism.links.size()].id; };
      for (int step = 0; step < 120; ++step) {
        const auto next = [&]() -> Expected<Mechanism> {
          switch (random() % 7) {
            case 0:
              return withTurningJoint(mechanism, anyLink(), anyLink());
            case 1:
              return withGearMesh(mechanism, anyLink(), anyLink(), 20, 30);
            case 2:
              return withoutElements(mechanism, std::array{ElementId(anyLink())});
            case 3:
              return withGround(mechanism, anyLink());
            case 4:
              if (mechanism.gearMeshes.empty()) return mechanism;
              return withFlipped(mechanism, mechanism.gearMeshes[random() % mechanism.gearMeshes.size()].id);
            default:
              return withLink(mechanism, {double(step), 0});
          }
        }();
        if (next) mechanism = *next;
        QVERIFY(wellFormedDiagnostics(mechanism).empty());
        for (const Diagnostic& diagnostic : treeDiagnostics(mechanism)) {
          QCOMPARE(diagnostic.code, Code::disconnected);  // no edit closes a loop
        }
      }
      QVERIFY(mechanism.links.size() > 1);
    }
  }
};

}  // namespace geargraph

QTEST_APPLESS_MAIN(geargraph::MechanismTest)
#include "test_mechanism.moc"

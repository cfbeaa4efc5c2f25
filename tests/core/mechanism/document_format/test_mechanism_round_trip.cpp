#include <QTest>

#include "core/mechanism/document_format/file_version.h"
#include "core/mechanism/model/edits.h"
#include "tests/core/mechanism/document_format/support.h"
#include "tests/core/support/example_files.h"

using namespace geargraph;
using namespace geargraph::test;

class MechanismRoundTripTest : public QObject {
  Q_OBJECT

 private slots:
  void everyMemberIsRead();
  void theVersionIsTheOldestThatIsNeeded();
  void writingAndReading_isTheIdentity();
  void numbersKeepTheirSpelling_data();
  void numbersKeepTheirSpelling();
  void unknownMembersOfEveryLevelSurvive();
  void placesOfTheTtGraphSurvive();
  void textsSurvive();
  void theRobotsFile_isCanonical();
  void theRobotsPitchPoints_lieOnBothPitchSurfaces();
};

namespace {

Mechanism readText(const std::string& text) {
  auto mechanism = readMechanism(text);
  if (!mechanism) qFatal("%s", summary(mechanism.error()).c_str());
  return *mechanism;
}

using NodePlaces = std::map<LinkId, CanvasPoint>;

}  // namespace

void MechanismRoundTripTest::everyMemberIsRead() {
  const Mechanism m = readText(kEverything);
  QCOMPARE(m.name, std::string("stage"));
  QCOMPARE(m.notes, std::string("free\ntext"));
  QCOMPARE(m.unit, std::string("in"));
  QCOMPARE(m.n(), 3);
  QCOMPARE(m.links[0].name, std::string("ground"));
  QVERIFY(m.axes[0].point->at(1).exact() == Rational(22, 7));
  QVERIFY(m.axes[0].direction->at(2).exact() == Rational(1, 1000));
  QVERIFY(!m.axes[1].point && !m.axes[1].direction);
  QVERIFY(m.turningJoints[0].offset.exact() == Rational(-3, 2));
  QVERIFY(!m.turningJoints[0].limits.any());
  QCOMPARE(m.turningJoints[1].limits.low->text(), std::string("-170.0"));
  QVERIFY(!m.turningJoints[1].limits.high);
  QVERIFY(m.turningJoints[1].tail == LinkId("0") && m.turningJoints[1].head == LinkId("arm"));
  QVERIFY(m.turningJoints[2].axis == AxisId("p") && slides(m.turningJoints[2]) &&
          !slides(m.turningJoints[0]));
  QCOMPARE(m.gearMeshes[4].lead->text(), std::string("2.50"));
  const GearMesh& mesh = m.gearMeshes[0];
  QVERIFY(mesh.tailTeeth == 20 && mesh.headTeeth == 31 && mesh.kind == MeshKind::external);
  QVERIFY(mesh.tailWheel == WheelId("w") && !mesh.headWheel && mesh.faceWidth->exact() == Rational(3, 8));
  QVERIFY(m.wheels[0].link == LinkId("sun") && m.wheels[0].bore->value() == 8);
  QVERIFY(m.gearDefaults->pressureAngle->value() == 20 && m.gearDefaults->faceWidth->value() == 10);
  QVERIFY(m.inputs->at(0).joint == JointId("4") && m.inputs->at(0).speed.exact() == Rational(1, 3));
  QVERIFY(m.couplings[0].kind == ShiftElementKind::brake && m.couplings[1].links.size() == 2);
  QVERIFY(m.states[0].engaged.size() == 2 && m.states[0].driven == LinkId("arm"));
  QCOMPARE(m.engaged, std::vector{ShiftElementId("C")});
  QVERIFY((m.view.nodes.at(LinkId("sun")) == CanvasPoint{-3, 4}));
  QVERIFY((m.view.ttNodes.at(LinkId("0")) == CanvasPoint{-5, 6}));
  QVERIFY((m.view.camera == ViewCamera{{0, 1, 2.5}, -26, 20, 400}));
  QCOMPARE(m.view.colors, (std::map<LinkId, int>{{LinkId("arm"), 5}, {LinkId("planet"), 2}}));
  QCOMPARE(m.view.unknown, (UnknownMembers{{"grid", "{\"zoom\": 1.50}"}}));
  QVERIFY(m.links[2].pinned && m.axes[0].pinned && m.gearMeshes[0].pinned);
  QVERIFY(!m.links[1].pinned && !m.axes[1].pinned);
  const LinkShape& shape = m.links[2].shapes.at(0);
  QCOMPARE(shape.file, std::string("parts/arm.stl"));
  QVERIFY(shape.position->at(2).exact() == Rational(1, 2) && shape.orientation->at(0).value() == 90);
  QVERIFY(mesh.efficiency->exact() == Rational(49, 50) && !mesh.friction);
  QVERIFY(mesh.helixAngle->text() == "22.250" && mesh.hand == Hand::left && mesh.herringbone);
  QVERIFY(mesh.module->exact() == Rational(7, 3) && mesh.pressureAngle->exact() == Rational(35, 2));
  QVERIFY(m.gearDefaults->friction->exact() == Rational(3, 50) && !m.gearDefaults->efficiency);
  QCOMPARE(m.loads.size(), std::size_t{4});
  QVERIFY(m.loads[0].id == LoadId("pull") && m.loads[1].id.empty());
  QVERIFY(
      (std::get<JointTorque>(m.loads[0].action) == JointTorque{JointId("6"), *Number::fromText("-12.50")}));
  QVERIFY((std::get<LinkTorque>(m.loads[1].action) ==
           LinkTorque{LinkId("planet"), AxisId("p"), *Number::fromText("5/2")}));
  QVERIFY((std::get<LinkTorque>(m.loads[2].action) == LinkTorque{LinkId("arm"), {}, Number(3)}));
  const auto& force = std::get<LinkForce>(m.loads[3].action);
  QVERIFY(force.link == LinkId("sun") && force.force[2].exact() == Rational(-20, 3));
  QVERIFY(force.point[1].value() == 40);
  QCOMPARE(m.balances->size(), std::size_t{3});
  QVERIFY(std::get<JointId>(m.balances->at(0).at) == JointId("4"));
  QVERIFY((std::get<HoldingTorque::OnLink>(m.balances->at(1).at) ==
           HoldingTorque::OnLink{LinkId("arm"), AxisId("a")}));
  QVERIFY(!std::get<HoldingTorque::OnLink>(m.balances->at(2).at).axis);
  QVERIFY(shape.scale->exact() == Rational(1, 4) && m.links[1].shapes.empty());
  QVERIFY(m.links[3].mass && !m.links[2].mass);
  QVERIFY(m.links[3].mass->mass.text() == "0.80" && m.links[3].mass->center->at(1).exact() == Rational(1, 3));
  QVERIFY(m.links[3].mass->inertia->at(1).exact() == Rational(1, 500));
  QVERIFY(m.sharing == LoadSharing::stiffness && m.driveTorque->exact() == Rational(25, 2));
  QVERIFY(m.density->value() == 2700 && m.gravity->at(1).exact() == Rational(-981, 100));
}

void MechanismRoundTripTest::writingAndReading_isTheIdentity() {
  const Mechanism mechanism = readText(kEverything);
  const std::string written = writeMechanism(mechanism);
  QVERIFY(readText(written) == mechanism);
  QCOMPARE(writeMechanism(readText(written)), written);
  QVERIFY(readText(writeMechanism(emptyMechanism())) == emptyMechanism());
}

/// Without what came with version 2 the document is one of version 1, whatever the file said.
void MechanismRoundTripTest::theVersionIsTheOldestThatIsNeeded() {
  Mechanism mechanism = readText(kEverything);
  QCOMPARE(fileVersionOf(mechanism), 2);
  mechanism.gearMeshes.resize(1);
  mechanism.turningJoints[2].kind = JointKind::turning;
  mechanism.couplings.pop_back();
  mechanism.states.front().direction.reset();
  GearMesh& mesh = mechanism.gearMeshes.front();
  const GearMesh full = mesh;
  mesh.helixAngle = mesh.module = mesh.pressureAngle = std::nullopt;
  mesh.hand = std::nullopt;
  mesh.herringbone = false;
  QCOMPARE(fileVersionOf(mechanism), 1);
  const std::string written = writeMechanism(mechanism);
  QVERIFY2(written.find("\"version\": 1,") != std::string::npos, written.c_str());
  QVERIFY(readText(written) == mechanism);
  const GearMesh old = mesh;
  const auto with = [&](auto member) {
    mesh = old;
    mesh.*member = full.*member;
    return fileVersionOf(mechanism);
  };
  QCOMPARE(with(&GearMesh::helixAngle), 2);
  QCOMPARE(with(&GearMesh::hand), 2);
  QCOMPARE(with(&GearMesh::herringbone), 2);
  QCOMPARE(with(&GearMesh::module), 2);
  QCOMPARE(with(&GearMesh::pressureAngle), 2);
  QCOMPARE(with(&GearMesh::efficiency), 1);
}

void MechanismRoundTripTest::numbersKeepTheirSpelling_data() {
  QTest::addColumn<QString>("number");
  for (const char* number :
       {"0.10", "1e-3", "1E+02", "-0", "-0.0", "\"22/7\"", "\"-1/3\"", "\"+5\"", "\"007\"", "0",
        "0.123456789012345678901234567890", "-987654321098765.43210987654321050", "1e15", "5e-4000"}) {
    QTest::newRow(number) << number;
  }
}

void MechanismRoundTripTest::numbersKeepTheirSpelling() {
  QFETCH(QString, number);
  const std::string written = writeMechanism(readText(with(kEverything, "-1.50", number.toStdString())));
  QVERIFY2(written.find("\"offset\": " + number.toStdString() + "}") != std::string::npos, written.c_str());
  const std::string unknown =
      writeMechanism(readText(with(kEverything, "1.50}}", number.toStdString() + "}}")));
  QVERIFY2(unknown.find("{\"zoom\": " + number.toStdString() + "}") != std::string::npos, unknown.c_str());
}

void MechanismRoundTripTest::unknownMembersOfEveryLevelSurvive() {
  std::string text = kEverything;
  int count = 0;
  for (std::size_t at = text.find('{'); at != std::string::npos; at = text.find('{', at + 1)) {
    if (text.substr(at).starts_with("{\"0\": [")) continue;    // nodes: all of their members are links
    if (text.substr(at).starts_with("{\"arm\": 5")) continue;  // so are those of colours
    const std::string member = "\"new " + std::to_string(count++) + "\": [1e-3, {\"\\u00e9\": null}, \"x\"],";
    text.insert(at + 1, member);
    at += member.size();
  }
  const std::string written = writeMechanism(readText(text));
  for (int i = 0; i < count; ++i) {
    const std::string member = "\"new " + std::to_string(i) + "\": [1e-3, {\"\\u00e9\": null}, \"x\"]";
    QVERIFY2(written.find(member) != std::string::npos, member.c_str());
  }
  QCOMPARE(count, 34);  // every object but those by link
  QVERIFY(readText(written) == readText(text));
}

void MechanismRoundTripTest::placesOfTheTtGraphSurvive() {
  const Mechanism before = example("robot");
  const std::vector<std::pair<LinkId, CanvasPoint>> places{{LinkId("4"), {130.5, -0.1}},
                                                           {LinkId("7"), {1.0 / 3, 2e5}}};
  const Mechanism placed = withTtNodesMoved(before, places).value();
  const Mechanism again = readMechanism(writeMechanism(placed)).value();
  QCOMPARE(again, placed);
  QCOMPARE(again.view.ttNodes, NodePlaces(places.begin(), places.end()));
  QCOMPARE(again.view.nodes, before.view.nodes);  // the digraph's own places are another matter
  // The place of a deleted link goes with it, the others stay.
  const std::vector<ElementId> gone{LinkId("7")};
  QCOMPARE(withoutElements(again, gone).value().view.ttNodes, (NodePlaces{places.front()}));
  const std::vector<std::pair<LinkId, CanvasPoint>> none{{LinkId("none"), {0, 0}}};
  QCOMPARE(withTtNodesMoved(before, none).error()[0].code, Code::unknownId);
}

void MechanismRoundTripTest::textsSurvive() {
  Mechanism mechanism = emptyMechanism();
  mechanism.name = "Γ \"quoted\" \\ / \b\f\n\r\t\x01 \xF0\x9F\x98\x80";
  mechanism.notes = std::string("a\0b", 3);
  mechanism.links[0].name = "=1+2";
  QVERIFY(readText(writeMechanism(mechanism)) == mechanism);
  const std::string escaped = with(kEverything, "\"stage\"", R"("\u0393\ud83d\ude00\/\b")");
  QCOMPARE(readText(escaped).name, std::string("Γ\xF0\x9F\x98\x80/\b"));
}

void MechanismRoundTripTest::theRobotsFile_isCanonical() {
  const std::string file = exampleText("robot");
  QCOMPARE(QString::fromStdString(writeMechanism(example("robot"))), QString::fromStdString(file));
}

/// Table 1: each pitch point is d/2 from the axis of each of its two gears, d = 2 N.
void MechanismRoundTripTest::theRobotsPitchPoints_lieOnBothPitchSurfaces() {
  const Mechanism m = example("robot");
  const auto distanceFromAxis = [&](const NumberTriple& point, const char* id) {
    const Axis& axis = *m.find(AxisId(id));
    Rational squared;
    for (std::size_t i = 0; i < 3; ++i) {
      if (!axis.direction->at(i).exact().isZero()) continue;  // axes of the robot are parallel to y or z
      const Rational difference = point.at(i).exact() - axis.point->at(i).exact();
      squared += difference * difference;
    }
    return squared.squareRoot().value();
  };
  const struct {
    const char* mesh;
    const char* tailAxis;
    const char* headAxis;
  } rows[] = {{"15", "a", "b"}, {"16", "b", "c"}, {"17", "c", "d"}, {"18", "d", "e"}};
  for (const auto& row : rows) {
    const GearMesh& mesh = *m.find(MeshId(row.mesh));
    QVERIFY2(distanceFromAxis(*mesh.pitchPoint, row.tailAxis) == Rational(mesh.tailTeeth), row.mesh);
    QVERIFY2(distanceFromAxis(*mesh.pitchPoint, row.headAxis) == Rational(mesh.headTeeth), row.mesh);
  }
}

QTEST_APPLESS_MAIN(MechanismRoundTripTest)
#include "test_mechanism_round_trip.moc"

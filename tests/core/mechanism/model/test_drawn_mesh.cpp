#include <QTest>

#include "core/mechanism/model/axis_letters.h"
#include "core/mechanism/model/drawn_mesh.h"
#include "core/mechanism/model/edits.h"

namespace geargraph {
namespace {

/// So many links besides the ground, and turning joints between these, each about an axis of its own.
Mechanism drawn(int links, const std::vector<std::pair<int, int>>& joints) {
  Mechanism mechanism = emptyMechanism();
  for (int i = 0; i < links; ++i) mechanism = withLink(mechanism, {100.0 * i, 0}).value();
  for (const auto& [tail, head] : joints) {
    mechanism = withTurningJoint(mechanism, mechanism.links[static_cast<std::size_t>(tail)].id,
                                 mechanism.links[static_cast<std::size_t>(head)].id)
                    .value();
  }
  return mechanism;
}

Mechanism meshed(const Mechanism& mechanism, int tail, int head) {
  return withDrawnMesh(mechanism, mechanism.links[static_cast<std::size_t>(tail)].id,
                       mechanism.links[static_cast<std::size_t>(head)].id)
      .value();
}

/// The letter of each joint's axis: "aab".
QString axesOf(const Mechanism& mechanism) {
  QString letters;
  std::vector<AxisId> seen;
  for (const TurningJoint& joint : mechanism.turningJoints) {
    const auto found = std::find(seen.begin(), seen.end(), joint.axis);
    letters += QChar('a' + static_cast<int>(found - seen.begin()));
    if (found == seen.end()) seen.push_back(joint.axis);
  }
  return letters;
}

QString teethOf(const GearMesh& mesh) {
  const std::string_view kind = mesh.kind ? meshKindName(*mesh.kind) : "open";
  return QStringLiteral("%1:%2 %3")
      .arg(mesh.tailTeeth)
      .arg(mesh.headTeeth)
      .arg(QString::fromUtf8(kind.data(), qsizetype(kind.size())));
}

// Sun 1 and carrier 2 on the ground, planets 3 and 4 on the carrier.
const std::vector<std::pair<int, int>> kPlanetary{{0, 1}, {0, 2}, {2, 3}, {2, 4}};

}  // namespace

class DrawnMeshTest : public QObject {
  Q_OBJECT

 private slots:
  void sunAndCarrierTurnAboutOneAxis() {
    const Mechanism before = drawn(4, kPlanetary);
    QCOMPARE(axesOf(before), QStringLiteral("abcd"));
    const Mechanism after = meshed(before, 1, 3);
    QCOMPARE(axesOf(after), QStringLiteral("aabc"));
    QCOMPARE(after.axes.size(), std::size_t{3});  // nobody uses the fourth
    QCOMPARE(teethOf(after.gearMeshes[0]), QStringLiteral("20:20 open"));
  }

  void thePapersRobotGetsItsFiveAxes() {
    Mechanism robot = drawn(7, {{0, 4}, {0, 5}, {0, 1}, {1, 6}, {1, 2}, {2, 7}, {2, 3}});
    for (const auto& [tail, head] : {std::pair{4, 1}, {5, 2}, {6, 7}, {7, 3}})
      robot = meshed(robot, tail, head);
    QCOMPARE(axesOf(robot), QStringLiteral("abbccde"));  // [AU, Fig. 3]
    QVERIFY(doAxisLettersRun(robot));
    QCOMPARE(robot.turningJoints.back().axis, AxisId("e"));
    QCOMPARE(robot.axes.size(), std::size_t(5));
  }

  void lettersThatSomebodyChoseStay() {
    Mechanism named = drawn(4, kPlanetary);
    named = withName(named, AxisId("c"), "planet").value();
    QVERIFY(!doAxisLettersRun(named));
    named = meshed(named, 1, 3);
    QCOMPARE(named.turningJoints[2].axis, AxisId("planet"));
    QCOMPARE(named.turningJoints[3].axis, AxisId("d"));
  }

  void wheelsOnTheGroundKeepTheirAxes() {
    const Mechanism pair = meshed(drawn(2, {{0, 1}, {0, 2}}), 1, 2);
    QCOMPARE(axesOf(pair), QStringLiteral("ab"));
  }

  void axesThatArePlacedStay() {
    Mechanism before = drawn(4, kPlanetary);
    const NumberTriple origin{Number(0), Number(0), Number(0)};
    const NumberTriple aside{Number(9), Number(0), Number(0)};
    before = withAxisPlaced(before, before.axes[1].id, origin, std::nullopt).value();
    QCOMPARE(axesOf(meshed(before, 1, 3)), QStringLiteral("aabc"));  // to the one that is placed
    QVERIFY(meshed(before, 1, 3).find(before.axes[1].id) != nullptr);
    before = withAxisPlaced(before, before.axes[0].id, aside, std::nullopt).value();
    QCOMPARE(axesOf(meshed(before, 1, 3)), QStringLiteral("abcd"));
  }

  void whatNoOneChangeMendsIsLeftAlone() {
    // 1 - 0 - 2 - 3 - 4: a chain of four axes.
    const Mechanism before = drawn(4, {{0, 1}, {0, 2}, {2, 3}, {3, 4}});
    QCOMPARE(axesOf(meshed(before, 1, 4)), QStringLiteral("abcd"));
    const Mechanism loose = drawn(2, {{0, 1}});
    QCOMPARE(meshed(loose, 1, 2).c(), 1);  // nothing leads there yet
  }

  void theSecondGearRoundAPlanetIsTheRing() {
    Mechanism train = meshed(drawn(4, kPlanetary), 1, 3);
    train = withTeeth(train, train.gearMeshes[0].id, 24, 18).value();
    const Mechanism forth = meshed(train, 3, 0);
    QCOMPARE(teethOf(forth.gearMeshes[1]), QStringLiteral("18:60 internal"));
    const Mechanism back = meshed(train, 0, 3);
    QCOMPARE(teethOf(back.gearMeshes[1]), QStringLiteral("60:18 internal"));
  }

  void aSecondPlanetIsIdenticalToTheFirst() {
    Mechanism train = meshed(drawn(4, kPlanetary), 1, 3);
    train = withTeeth(train, train.gearMeshes[0].id, 24, 18).value();
    train = meshed(train, 3, 0);
    train = meshed(train, 1, 4);
    train = meshed(train, 4, 0);
    QCOMPARE(teethOf(train.gearMeshes[2]), QStringLiteral("24:18 open"));
    QCOMPARE(teethOf(train.gearMeshes[3]), QStringLiteral("18:60 internal"));
  }

  void theSecondGearOfABevelPlanetIsABevelGear() {
    Mechanism train = meshed(drawn(4, {{0, 1}, {0, 2}, {2, 3}, {0, 4}}), 1, 3);
    train = withMeshKind(train, train.gearMeshes[0].id, MeshKind::bevel).value();
    train = withTeeth(train, train.gearMeshes[0].id, 24, 16).value();
    train = withJointAxis(train, train.turningJoints[3].id, train.turningJoints[0].axis).value();
    QCOMPARE(teethOf(meshed(train, 3, 4).gearMeshes[1]), QStringLiteral("16:24 bevel"));
  }

  void aRejectedJointBearsNoLabelOfSomethingElse() {
    const Mechanism train = meshed(drawn(3, {{0, 1}, {0, 2}, {2, 3}}), 1, 3);
    QCOMPARE(labelOf(train, train.gearMeshes.front().id), std::optional<std::string>("7"));
    const auto rejected = withTurningJoint(train, train.links[3].id, train.links[1].id);  // would be 7, too
    QVERIFY(!rejected.has_value());
    QCOMPARE(
        rejected.error().front().message,
        std::string("A turning joint from link 3 to link 1 would close a loop with joints 4, 5 and 6. The "
                    "turning joints have to be a tree: draw a gear mesh instead."));
  }

  void whatIsRejectedIsRejectedStill() {
    const Mechanism before = drawn(1, {});
    const LinkId link = before.links[1].id;
    QCOMPARE(withDrawnMesh(before, link, link).error().front().code, Code::selfJoint);
    QCOMPARE(withDrawnMesh(before, link, LinkId("none")).error().front().code, Code::unknownId);
  }
};

}  // namespace geargraph

QTEST_APPLESS_MAIN(geargraph::DrawnMeshTest)
#include "test_drawn_mesh.moc"

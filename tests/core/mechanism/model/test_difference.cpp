#include <QTest>

#include "core/mechanism/model/difference.h"
#include "core/mechanism/model/edits.h"
#include "core/mechanism/model/patch.h"
#include "core/mechanism/model/shift_edits.h"
#include "tests/core/support/gearboxes.h"
#include "tests/core/support/mechanisms.h"

namespace geargraph {

class DifferenceTest : public QObject {
  Q_OBJECT

  const Mechanism robot = test::robotTopology();

  [[nodiscard]] QString textTo(const Mechanism& after) const {
    return QString::fromStdString(differenceText(differenceOf(robot, after)));
  }

 private slots:
  void aDocumentDiffersFromItselfInNothing() {
    QCOMPARE(differenceOf(robot, robot), Difference());
    QCOMPARE(textTo(robot), QStringLiteral("nothing"));
  }

  void elementsAreCountedByKind() {
    Mechanism after = withLink(robot, {10, 10}).value();
    after = withLink(after, {90, 10}).value();
    after = withTurningJoint(after, after.links[0].id, after.links.back().id).value();
    const Difference difference = differenceOf(robot, after);
    QCOMPARE(difference.links.added, 2);
    QCOMPARE(difference.joints.added, 1);
    QCOMPARE(textTo(after), QStringLiteral("2 links and 1 turning joint added"));
    const Difference back = differenceOf(after, robot);
    QCOMPARE(back.links.removed, 2);
    QCOMPARE(back.joints.removed, 1);
    QCOMPARE(QString::fromStdString(differenceText(back)),
             QStringLiteral("2 links and 1 turning joint removed"));
  }

  void whatChangedIsNamed() {
    Mechanism after = withTeeth(robot, robot.gearMeshes[0].id, 17, 51).value();
    after = withName(after, robot.links[2].id, "arm").value();
    QCOMPARE(textTo(after), QStringLiteral("1 link and 1 gear mesh changed"));

    after = withInputs(robot, std::vector<Input>{{robot.turningJoints[0].id, Number(7), {}}}).value();
    QCOMPARE(textTo(after), QStringLiteral("inputs changed"));

    const std::pair<LinkId, CanvasPoint> moved[] = {{robot.links[1].id, CanvasPoint{7, 7}}};
    QCOMPARE(textTo(withNodesMoved(robot, moved).value()), QStringLiteral("links moved in the drawing"));

    after = robot;
    after.notes = "another word";
    QCOMPARE(textTo(after), QStringLiteral("other properties changed"));
    QCOMPARE(textTo(withGround(robot, robot.links[3].id).value()),
             QStringLiteral("other properties changed"));  // another order of the links
  }

  void whatIsEngagedIsOfTheTrain() {
    const Mechanism box = test::eightSpeed();
    const Mechanism engaged = withEngagement(box, {ShiftElementId("A")}).value();
    QVERIFY(!isSameTrain(box, engaged) && !isSameDigraph(box, engaged) && !isSameButForView(box, engaged));
    QVERIFY(differenceOf(box, engaged).other);
    QVERIFY(isSameTrain(engaged, withState(engaged).value()));
    const MechanismPatch patch(box, engaged);
    QVERIFY(patch.forward(box) == engaged && patch.back(engaged) == box);
  }

  void teethAndSpeedsAreNotInTheDigraph() {
    const JointId joint = robot.turningJoints[0].id;
    const auto driving = [&](JointId one, int speed) {
      return withInputs(robot, std::vector<Input>{{one, Number(speed), {}}}).value();
    };
    QVERIFY(isSameDigraph(robot, withTeeth(robot, robot.gearMeshes[0].id, 17, 51).value()));
    QVERIFY(isSameDigraph(driving(joint, 7), driving(joint, 8)));
    QVERIFY(!isSameDigraph(driving(joint, 7), driving(robot.turningJoints[1].id, 7)));
    QVERIFY(!isSameDigraph(robot, withName(robot, robot.links[2].id, "arm").value()));
    QVERIFY(!isSameDigraph(robot, withGround(robot, robot.links[3].id).value()));
    QVERIFY(!isSameDigraph(robot, withFlipped(robot, robot.gearMeshes[0].id).value()));
  }

  void onlyPlacesInDrawingsAreAView() {
    const std::pair<LinkId, CanvasPoint> moved[] = {{robot.links[1].id, CanvasPoint{7, 7}}};
    QVERIFY(isSameButForView(robot, withNodesMoved(robot, moved).value()));

    QVERIFY(!isSameButForView(robot, withTeeth(robot, robot.gearMeshes[0].id, 17, 51).value()));
    QVERIFY(!isSameButForView(robot, withName(robot, robot.links[2].id, "arm").value()));
    QVERIFY(!isSameButForView(robot, withGround(robot, robot.links[3].id).value()));
    QVERIFY(!isSameButForView(robot, withLink(robot, {10, 10}).value()));
  }
};

}  // namespace geargraph

QTEST_APPLESS_MAIN(geargraph::DifferenceTest)
#include "test_difference.moc"

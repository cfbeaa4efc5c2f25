#include <QTest>
#include <array>

#include "core/mechanism/model/edits.h"
#include "core/mechanism/model/renumbering.h"
#include "tests/core/support/mechanisms.h"

namespace geargraph {

class RenumberingTest : public QObject {
  Q_OBJECT

  using Moves = std::vector<std::string>;

  static Moves movesOf(const Mechanism& before, const Mechanism& after) {
    Moves moves;
    for (const Renumbered& each : renumberedByRemoval(before, after))
      moves.push_back(std::to_string(each.before) + " is now " + std::to_string(each.after));
    return moves;
  }

 private slots:
  // Link 7 of the robot takes its joints 13 and 14 and its meshes 17 and 18 along.
  void deletingALinkMovesTheLabelsOfAllThatComesAfter() {
    const Mechanism robot = test::robotTopology();
    const std::array<ElementId, 1> removed{LinkId("7")};
    const Mechanism after = withoutElements(robot, removed).value();
    QCOMPARE(after.links.size(), robot.links.size() - 1);
    Moves expected;
    for (std::size_t i = 0; i < after.turningJoints.size(); ++i) {
      const TurningJoint& joint = after.turningJoints[i];
      const std::string before = labelOf(robot, joint.id).value();
      const std::string now = labelOf(after, joint.id).value();
      if (before != now) expected.push_back(before + " is now " + now);
    }
    for (const GearMesh& mesh : after.gearMeshes)
      expected.push_back(labelOf(robot, mesh.id).value() + " is now " + labelOf(after, mesh.id).value());
    QVERIFY(expected.size() > 2);
    QCOMPARE(movesOf(robot, after), expected);
  }

  void drawingSomethingIsNoNews() {
    const Mechanism robot = test::robotTopology();
    Mechanism more = robot;
    more.links.push_back(Link{LinkId("extra"), {}});
    QVERIFY(more.jointLabel(0) != robot.jointLabel(0));
    QCOMPARE(movesOf(robot, more), Moves());
    QCOMPARE(movesOf(robot, robot), Moves());
  }

  void theLastOneLeavesAllLabels() {
    const Mechanism robot = test::robotTopology();
    const std::array<ElementId, 1> removed{robot.gearMeshes.back().id};
    QCOMPARE(movesOf(robot, withoutElements(robot, removed).value()), Moves());
  }
};

}  // namespace geargraph

QTEST_APPLESS_MAIN(geargraph::RenumberingTest)
#include "test_renumbering.moc"

#include <QTest>
#include <random>

#include "core/mechanism/document_format/mechanism_file.h"
#include "core/mechanism/model/edits.h"
#include "core/mechanism/model/patch.h"
#include "tests/core/support/example_files.h"
#include "tests/core/support/mechanisms.h"

namespace geargraph {

class PatchTest : public QObject {
  Q_OBJECT

  const Mechanism robot = test::example("robot");

  /// Either document gives the other, byte by byte; returns the bytes that the patch holds.
  static std::size_t checked(const Mechanism& before, const Mechanism& after) {
    const MechanismPatch patch(before, after);
    [&] {
      QCOMPARE(writeMechanism(patch.forward(before)), writeMechanism(after));
      QCOMPARE(writeMechanism(patch.back(after)), writeMechanism(before));
      QCOMPARE(patch.isEmpty(), before == after);
    }();
    return patch.bytes();
  }

 private slots:
  void equalDocumentsDifferInNothing() {
    QVERIFY(MechanismPatch(robot, robot).isEmpty());
    checked(robot, robot);
  }

  void eitherDocumentGivesTheOther() {
    const std::vector<std::string> names = test::exampleNames();
    for (const std::string& name : names) {
      checked(robot, test::example(name));
      QVERIFY(!MechanismPatch(emptyMechanism(), test::example(name)).isEmpty());
      checked(emptyMechanism(), test::example(name));
    }
  }

  void listsThatAreReorderedComeBack() {
    std::mt19937_64 random(3);
    const Mechanism before = test::randomTree(3, 40, 30);
    for (int round = 0; round < 50; ++round) {
      Mechanism after = before;
      std::shuffle(after.links.begin() + 1, after.links.end(), random);
      std::shuffle(after.gearMeshes.begin(), after.gearMeshes.begin() + 10, random);
      after.turningJoints.erase(after.turningJoints.begin() + round % 30);
      after.turningJoints.push_back(before.turningJoints[static_cast<std::size_t>(round % 30)]);
      checked(before, after);
    }
  }

  void membersOfOtherProgramsComeBack() {
    Mechanism after = robot;
    after.view.unknown.emplace_back("ttNodes", "{\"1\": [1, 2], \"2\": [3, 4]}");
    checked(robot, after);
    Mechanism moved = after;
    moved.view.unknown.back().second = "{\"1\": [1, 2], \"2\": [3, 5]}";
    checked(after, moved);
    moved.unknown = {{"a", "1"}, {"b", "[]"}};
    checked(after, moved);
  }

  void aZeroKeepsItsSign() {
    Mechanism after = robot;
    after.view.nodes.begin()->second = {0.0, -0.0};
    checked(robot, after);
    Mechanism positive = after;
    positive.view.nodes.begin()->second = {0.0, 0.0};
    positive.turningJoints.front().offset = *Number::fromText("-0");
    checked(after, positive);
  }

  void anEditOfOneElementCostsTheSameInAnyDocument() {
    const auto costIn = [](int links) {
      const Mechanism train = test::randomTree(1, links, links / 2);
      return checked(train, *withTeeth(train, train.gearMeshes[3].id, 17, 51));
    };
    QVERIFY(costIn(3000) < 4000);
    QCOMPARE(costIn(3000), costIn(30));
  }
};

}  // namespace geargraph

QTEST_GUILESS_MAIN(geargraph::PatchTest)
#include "test_patch.moc"

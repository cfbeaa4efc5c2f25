#include <QTest>
#include <algorithm>
#include <set>

#include "core/design/atlas/chain_choices.h"
#include "core/design/atlas/chain_document.h"
#include "core/design/atlas/identify.h"
#include "tests/core/support/example_files.h"
#include "tests/core/support/train_sketch.h"

using namespace geargraph;
using namespace geargraph::test;

namespace {

TrainIdentity identityOf(const Mechanism& mechanism) {
  const Placement placement = placementOf(mechanism);
  const auto drawn = drawnChain(mechanism, placement);
  return *identifyTrain(mechanism, placement, *drawn, Atlas::shipped());
}

/// "4-1.1.1 3-1.1.1": the parts.
QString partsText(const TrainIdentity& identity) {
  QStringList parts;
  for (const IdentifiedChain& part : identity.parts)
    parts += part.displacement ? QString::fromStdString(part.displacement->toString()) : "?";
  return parts.join(' ');
}

/// "0 no-mesh, 5 copy".
QString removedText(const TrainIdentity& identity) {
  QStringList links;
  for (const RemovedLink& removed : identity.removed)
    links +=
        QString::number(removed.link) + ' ' + QString::fromStdString(std::string(removalName(removed.why)));
  return links.join(", ");
}

}  // namespace

class IdentifyTest : public QObject {
  Q_OBJECT

 private slots:
  void examplesAreTheseChains_data() {
    QTest::addColumn<QString>("removed");
    QTest::addColumn<QString>("parts");
    QTest::newRow("spur-pair") << ""
                               << "3-1.1.1";
    QTest::newRow("planetary-ring-held") << ""
                                         << "4-1.1.1";
    QTest::newRow("three-planets") << "4 copy, 5 copy"
                                   << "4-1.1.1";
    QTest::newRow("redundant-planetary") << "0 no-mesh, 5 copy, 6 copy, 7 copy, 8 copy"
                                         << "4-1.1.1";
    QTest::newRow("reverted-train") << ""
                                    << "4-1.1.1";
    QTest::newRow("bevel-differential") << "0 no-mesh, 5 copy"
                                        << "4-1.1.1";
    QTest::newRow("humpage-reduction") << ""
                                       << "5-1.1.1";
    QTest::newRow("ferguson-paradox") << ""
                                      << "6-1.1.1";
    QTest::newRow("simpson") << "0 no-mesh"
                             << "6-1.12.1";
    QTest::newRow("ravigneaux") << "0 no-mesh"
                                << "6-1.2.2";
    QTest::newRow("robot") << ""
                           << "3-1.1.1 3-1.1.1 4-1.1.2";
    QTest::newRow("bevel-wrist") << "0 no-mesh"
                                 << "6-2.9.1";
    QTest::newRow("three-roll-wrist") << "0 no-mesh"
                                      << "6-2.9.1";
    QTest::newRow("locked-train") << ""
                                  << "4-0.1.1";
    QTest::newRow("eight-speed-gearbox") << "0 no-mesh"
                                         << "?";
  }
  void examplesAreTheseChains() {
    QFETCH(const QString, removed);
    QFETCH(const QString, parts);
    const std::string name = QTest::currentDataTag();
    const TrainIdentity identity = identityOf(example(name));
    QCOMPARE(removedText(identity), removed);
    QCOMPARE(partsText(identity), parts);
    for (const IdentifiedChain& part : identity.parts) {
      QCOMPARE(part.isLocked, name == "locked-train");
      QVERIFY(!part.turnsByTeeth);
      QCOMPARE(part.dof, name == "eight-speed-gearbox" ? 3 : part.displacement->dof);
    }
  }

  /// The chain that the paper's robot is made of keeps the document's links and meshes.
  void partsNameLinksAndMeshes() {
    const TrainIdentity robot = identityOf(example("robot"));
    std::vector<int> meshes;
    for (const IdentifiedChain& part : robot.parts)
      meshes.insert(meshes.end(), part.meshes.begin(), part.meshes.end());
    std::sort(meshes.begin(), meshes.end());
    QCOMPARE(meshes, std::vector<int>({0, 1, 2, 3}));
    QCOMPARE(robot.chain.meshes.size(), std::size_t{4});
    QCOMPARE(robot.chain.links, 8);
  }

  /// What turns by its tooth counts only: a planet on two rings and two suns whose equations are the same.
  void equalEquationsTurnByTheirTeeth() {
    Mechanism train = planetary(24, 12);
    train.links.push_back({LinkId("x"), {}, {}});
    train.turningJoints.push_back(
        {JointId("jx"), train.links[3].id, LinkId("x"), train.turningJoints.back().axis, Number(0), {}});
    GearMesh first = train.gearMeshes[0];
    GearMesh second = train.gearMeshes[1];
    first.id = MeshId("again");
    first.head = LinkId("x");
    second.id = MeshId("once more");
    second.tail = LinkId("x");
    train.gearMeshes.push_back(first);
    train.gearMeshes.push_back(second);
    const TrainIdentity copied = identityOf(train);
    QCOMPARE(partsText(copied), QString("4-1.1.1"));
    train.gearMeshes[2].tailTeeth = 48;
    train.gearMeshes[2].headTeeth = 24;  // the same ratio by other teeth: no copy, and dependent
    const TrainIdentity dependent = identityOf(train);
    QCOMPARE(partsText(dependent), QString("5-0.1.1"));
    QVERIFY(dependent.parts.front().turnsByTeeth && !dependent.parts.front().isLocked);
    QCOMPARE(dependent.parts.front().dof, 1);
    train.gearMeshes[2].headTeeth = 25;
    const TrainIdentity locked = identityOf(train);
    QCOMPARE(partsText(locked), QString("5-0.1.1"));
    QVERIFY(locked.parts.front().isLocked && !locked.parts.front().turnsByTeeth);
    QCOMPARE(locked.parts.front().dof, 0);
  }

  void pinionsThatOnlyFollowAreNoCopies() {
    const Mechanism train = TrainSketch(3)
                                .axis("a", {"0", "0", "0"})
                                .axis("b", {"50", "0", "0"})
                                .axis("c", {"-50", "0", "0"})
                                .joint(0, 1, "a")
                                .joint(0, 2, "b")
                                .joint(0, 3, "c")
                                .mesh(1, 2, 30, 20)
                                .mesh(1, 3, 30, 20)
                                .build();
    const TrainIdentity identity = identityOf(train);
    QVERIFY(identity.removed.empty());
    QCOMPARE(partsText(identity), QString("4-1.1.2"));
  }

  void brokenTrainsSayWhy() {
    const Mechanism loop = example("robot-to-mend");
    const auto drawn = drawnChain(loop, placementOf(loop));
    QVERIFY(!drawn);
    QCOMPARE(drawn.error().front().code, Code::turningLoop);
    Mechanism coaxial = example("planetary-ring-held");
    coaxial.gearMeshes[0].head = coaxial.links[0].id;
    const auto none = drawnChain(coaxial, placementOf(coaxial));
    QVERIFY(!none);
    QCOMPARE(none.error().front().code, Code::coaxialMesh);
  }

  /// Two documents of one chain, drawn from other frames: every mesh of one is a mesh of the other between
  /// the links that the map gives.
  void matchMapsLinksAndMeshes() {
    int pairs = 0;
    for (const AtlasChain& chain : Atlas::shipped().chains(5, 1)) {
      for (int frame = 0; frame < 5; ++frame) {
        const Mechanism a = chainDocument(chain.chain, "");
        const Mechanism b = chainDocument(chain.chain, "", {frame, {}});
        const auto match = matchOf(identityOf(a), identityOf(b));
        QVERIFY(match && match->likeness == ChainLikeness::displacement);
        QCOMPARE(match->links.size(), std::size_t{5});
        QCOMPARE(match->meshes.size(), std::size_t{3});
        for (const auto& [own, other] : match->meshes) {
          const auto imageOf = [&](LinkId id) {
            for (const auto& [from, to] : match->links)
              if (a.links[from].id == id) return b.links[to].id;
            return LinkId();
          };
          const std::set<LinkId> image{imageOf(a.gearMeshes[own].tail), imageOf(a.gearMeshes[own].head)};
          QCOMPARE(image, (std::set<LinkId>{b.gearMeshes[other].tail, b.gearMeshes[other].head}));
          ++pairs;
        }
      }
    }
    QCOMPARE(pairs, 13 * 5 * 3);
  }

  void trainsOfOtherShaftsHaveTheSameEquations() {
    const TrainIdentity planetarySet = identityOf(example("planetary-ring-held"));
    const TrainIdentity follower = identityOf(chainDocument(Atlas::shipped().find({4, 1, 1, 2})->chain, ""));
    const auto match = matchOf(planetarySet, follower);
    QVERIFY(match && match->likeness == ChainLikeness::rotation);
    QVERIFY(!matchOf(planetarySet, identityOf(example("simpson"))));
    // Copies of planets do not count.
    QVERIFY(matchOf(planetarySet, identityOf(example("three-planets"))));
  }

  /// Of the sets of pairs those that the paper's robot draws as joints are its 21 valid sets of inputs, which
  /// the matroid method counts by itself.
  void inputsOfDrawnJointsAreThoseOfTheMatroid() {
    const Mechanism robot = example("robot");
    const Placement placement = placementOf(robot);
    const auto drawn = drawnChain(robot, placement);
    const auto choices = choicesOf(drawn->chain, drawn->teeth, 100'000);
    std::set<TurningPair> joints;
    for (const DigraphEdge& joint : placement.tree->joints)
      joints.insert(std::minmax<int>(joint.tail, joint.head));
    QCOMPARE(joints.size(), std::size_t{7});
    const auto areDrawn = [&](const std::vector<TurningPair>& pairs) {
      return std::all_of(pairs.begin(), pairs.end(),
                         [&](const TurningPair& p) { return joints.contains(p); });
    };
    QCOMPARE(static_cast<std::int64_t>(choices->inputSets.size()), choices->inputSetCount);
    QCOMPARE(std::count_if(choices->inputSets.begin(), choices->inputSets.end(), areDrawn), 21);
    QVERIFY(
        std::any_of(choices->trees.begin(), choices->trees.end(), [&](const std::vector<TurningPair>& tree) {
          return std::set<TurningPair>(tree.begin(), tree.end()) == joints;
        }));
  }

  void stopsWhereItIsAsked() {
    std::stop_source source;
    source.request_stop();
    const Mechanism robot = example("robot");
    const Placement placement = placementOf(robot);
    QVERIFY(!identifyTrain(robot, placement, *drawnChain(robot, placement), Atlas::shipped(),
                           source.get_token()));
  }
};

QTEST_APPLESS_MAIN(IdentifyTest)
#include "test_identify.moc"

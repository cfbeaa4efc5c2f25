#include <QTest>
#include <algorithm>
#include <array>

#include "core/design/fixes/fixes.h"
#include "core/machine/body_layout/complete_train.h"
#include "core/mechanism/geometry_edits/fitted_edits.h"
#include "core/mechanism/model/edits.h"
#include "core/mechanism/model/shift_edits.h"
#include "core/mechanism/model/validate.h"
#include "tests/core/support/example_files.h"
#include "tests/core/support/train_sketch.h"

namespace geargraph {
namespace {

NumberTriple triple(int x, int y, int z) {
  return {Number(x), Number(y), Number(z)};
}

GearMesh& meshOf(Mechanism& mechanism, const char* id) {
  return *std::find_if(mechanism.gearMeshes.begin(), mechanism.gearMeshes.end(),
                       [id](const GearMesh& mesh) { return mesh.id == MeshId(id); });
}

/// Four wheels on the corners of a square, each meshing with the next: one mesh is redundant.
Mechanism squareOfWheels() {
  test::TrainSketch sketch(4);
  sketch.axis("a", {"0", "0", "0"}).axis("b", {"40", "0", "0"}).axis("c", {"40", "40", "0"});
  sketch.axis("d", {"0", "40", "0"});
  sketch.joint(0, 1, "a").joint(0, 2, "b").joint(0, 3, "c").joint(0, 4, "d");
  sketch.mesh(1, 2, 20, 20).mesh(2, 3, 20, 20).mesh(3, 4, 20, 20).mesh(4, 1, 20, 20);
  return sketch.build();
}

/// What the editor lists: the snapshot's diagnostics and those of the teeth.
Diagnostics listedDiagnostics(const AnalysisSnapshot& snapshot) {
  Diagnostics all = snapshot.diagnostics;
  if (!snapshot.tree) return all;
  const Diagnostics teeth = trainDiagnostics(*snapshot.mechanism, placementOf(*snapshot.mechanism));
  all.insert(all.end(), teeth.begin(), teeth.end());
  return all;
}

}  // namespace

/// Every fix: the diagnostic is provoked, its fix is named, and after it the diagnostic is gone.
class FixesTest : public QObject {
  Q_OBJECT

  SnapshotPtr snapshot;

  [[nodiscard]] std::optional<Diagnostic> diagnosticWith(Code code) const {
    for (const Diagnostic& found : listedDiagnostics(*snapshot)) {
      if (found.code == code) return found;
    }
    return std::nullopt;
  }
  void provoke(const Mechanism& mechanism) {
    snapshot = analyzeLive(std::make_shared<const Mechanism>(mechanism));
  }
  [[nodiscard]] QStringList offered(Code code) const {
    QStringList texts;
    if (const auto found = diagnosticWith(code)) {
      for (const Fix& fix : fixesFor(*found, *snapshot)) texts << QString::fromStdString(fix.text);
    }
    return texts;
  }
  /// Each fix repairs it; the mechanism after the first of them is the snapshot's then.
  void eachFixRepairs(Code code) {
    const auto found = diagnosticWith(code);
    QVERIFY(found);
    const SnapshotPtr broken = snapshot;
    SnapshotPtr afterFirst;
    for (const Fix& fix : fixesFor(*found, *broken)) {
      const Expected<Mechanism> repaired = fix.edit(*broken->mechanism);
      QVERIFY2(repaired, fix.text.c_str());
      QVERIFY2(wellFormedDiagnostics(*repaired).empty(), fix.text.c_str());
      provoke(*repaired);
      const auto same = diagnosticWith(code);
      QVERIFY2(!same || same->elements != found->elements, fix.text.c_str());
      if (!afterFirst) afterFirst = snapshot;
    }
    snapshot = afterFirst;
  }

 private slots:
  void aLooseLinkIsTiedToTheGround() {
    provoke(*withLink(test::example("robot"), {0, 0}));
    QCOMPARE(offered(Code::disconnected), (QStringList{"Tie link 8 to the ground", "Delete link 8"}));
    eachFixRepairs(Code::disconnected);
    QCOMPARE(snapshot->mechanism->t(), 8);
    QVERIFY(snapshot->tree != nullptr);
  }

  void loosePartsAreTiedOnceEach() {
    Mechanism robot = test::example("robot");
    for (int i = 0; i < 3; ++i) robot = *withLink(std::move(robot), {0, 0});
    robot = *withTurningJoint(robot, robot.links[8].id, robot.links[9].id);
    provoke(robot);
    QCOMPARE(offered(Code::disconnected).first(), QString("Tie links 8, 10 to the ground"));
    eachFixRepairs(Code::disconnected);
    QCOMPARE(snapshot->mechanism->t(), 10);
  }

  void aSecondBearingIsDropped() {
    Mechanism robot = test::example("robot");
    robot.turningJoints.push_back({JointId("x"), LinkId("0"), LinkId("1"), AxisId("b"), Number(90), {}});
    provoke(robot);
    QCOMPARE(offered(Code::turningLoop), (QStringList{"Delete joint 15, a second bearing on axis b",
                                                      "Delete joint 10, a second bearing on axis b"}));
    eachFixRepairs(Code::turningLoop);
    QVERIFY(*snapshot->mechanism == test::example("robot"));
  }

  void aLoopOfSeveralAxesLosesOneOfItsJoints() {
    Mechanism robot = test::example("robot");
    robot.turningJoints.push_back({JointId("x"), LinkId("3"), LinkId("6"), AxisId("a"), Number(0), {}});
    provoke(robot);
    QCOMPARE(offered(Code::turningLoop).first(), QString("Delete joint 15"));
    eachFixRepairs(Code::turningLoop);
  }

  void teethThatFitThePitchPoint() {
    provoke(*withTeeth(test::example("robot"), MeshId("15"), 18, 30));
    QCOMPARE(offered(Code::teethGeometry), (QStringList{"Use 36 teeth on gear 1", "Use 15 teeth on gear 4",
                                                        "Let the pitch point follow from axes and teeth"}));
    eachFixRepairs(Code::teethGeometry);
    QVERIFY(*snapshot->mechanism == test::example("robot"));
  }

  void aWrongKindIsFlipped() {
    provoke(*withMeshKind(test::example("robot"), MeshId("15"), MeshKind::internal));
    QCOMPARE(offered(Code::teethGeometry).first(), QString("Make mesh 15 external"));
    eachFixRepairs(Code::teethGeometry);
    provoke(*withMeshKind(test::example("robot"), MeshId("16"), MeshKind::external));
    QCOMPARE(offered(Code::pitchGeometry).first(), QString("Make mesh 16 bevel"));
    eachFixRepairs(Code::pitchGeometry);
    QVERIFY(*snapshot->mechanism == test::example("robot"));
  }

  void aPitchPointElsewhereIsDerived() {
    provoke(*withPitchPoint(test::example("robot"), MeshId("15"), triple(20, -36, 0)));
    QCOMPARE(offered(Code::pitchGeometry).first(), QString("Let the pitch point follow from axes and teeth"));
    eachFixRepairs(Code::pitchGeometry);
    provoke(*withPitchPoint(test::example("robot"), MeshId("15"), triple(0, 0, 5)));
    QCOMPARE(offered(Code::pitchPointOnAxis).first(),
             QString("Let the pitch point follow from axes and teeth"));
    eachFixRepairs(Code::pitchPointOnAxis);
  }

  void anInternalPairOfEqualWheelsIsCalledExternal() {
    Mechanism robot = test::example("robot");
    GearMesh& mesh = meshOf(robot, "15");
    mesh.headTeeth = mesh.tailTeeth;
    mesh.kind = MeshKind::internal;
    mesh.pitchPoint.reset();
    provoke(robot);
    QCOMPARE(offered(Code::teethGeometry).first(), QString("Make mesh 15 external"));
    eachFixRepairs(Code::teethGeometry);
  }

  void aMeshThatCannotBeIsDropped() {
    provoke(*withGearMesh(test::example("robot"), LinkId("5"), LinkId("1")));
    QCOMPARE(offered(Code::coaxialMesh), QStringList{"Delete mesh 19"});
    eachFixRepairs(Code::coaxialMesh);
    provoke(*withGearMesh(test::example("robot"), LinkId("4"), LinkId("3")));
    QCOMPARE(offered(Code::noTransferVertex), QStringList{"Delete mesh 19"});
    eachFixRepairs(Code::noTransferVertex);
  }

  void equalPlanetsAreNotDeleted() {
    for (const char* example : {"redundant-planetary", "three-planets", "cannot-be-assembled"}) {
      provoke(test::example(example));
      QVERIFY(diagnosticWith(Code::redundantMesh));
      QVERIFY(offered(Code::redundantMesh).empty());
    }
  }

  void aRedundantMeshMayGo() {
    provoke(squareOfWheels());
    const int rank = snapshot->matroid()->rank;
    const auto redundant = snapshot->matroid()->redundancies.size();
    QVERIFY(offered(Code::redundantMesh).first().startsWith("Delete mesh "));
    eachFixRepairs(Code::redundantMesh);
    QCOMPARE(snapshot->matroid()->rank, rank);
    QCOMPARE(snapshot->matroid()->redundancies.size(), redundant - 1);
  }

  void inputsAreExchangedCompletedAndLeft() {
    const auto driven = [](std::initializer_list<const char*> joints) {
      std::vector<Input> inputs;
      for (const char* joint : joints) inputs.push_back({JointId(joint), Number(3), {}});
      return *withInputs(test::example("robot"), std::move(inputs));
    };
    const auto speeds = [this] {
      QStringList texts;
      for (const Input& input : *snapshot->mechanism->inputs) {
        texts << QString::fromStdString(input.joint.text() + "=" + input.speed.text());
      }
      return texts.join(' ');
    };
    provoke(driven({"8", "10", "11"}));
    QCOMPARE(offered(Code::invalidInputs),
             (QStringList{"Exchange input 10 for 9", "Choose the inputs for me"}));
    eachFixRepairs(Code::invalidInputs);
    QCOMPARE(speeds(), QString("8=3 9=3 11=3"));
    provoke(driven({"8", "11"}));
    QCOMPARE(offered(Code::invalidInputs).first(), QString("Drive 9 too"));
    eachFixRepairs(Code::invalidInputs);
    QCOMPARE(speeds(), QString("8=3 11=3 9=1"));
    provoke(driven({"8", "9", "10", "11"}));
    QCOMPARE(offered(Code::invalidInputs).first(), QString("Stop driving 10"));
    eachFixRepairs(Code::invalidInputs);
    QCOMPARE(speeds(), QString("8=3 9=3 11=3"));
  }

  void anAxisNamedTwiceIsSplit() {
    Mechanism robot = *withJointAxis(test::example("robot"), JointId("13"), AxisId("a"));
    provoke(robot);
    QCOMPARE(offered(Code::splitAxis), QStringList{"Give each its own axis"});
    eachFixRepairs(Code::splitAxis);
    QVERIFY(snapshot->mechanism->find(JointId("13"))->axis != AxisId("a"));
  }

  void planetsThatDoNotFitGetOtherTeeth() {
    provoke(test::example("cannot-be-assembled"));
    QVERIFY(diagnosticWith(Code::assembly));
    const QStringList texts = offered(Code::assembly);
    QVERIFY2(!texts.isEmpty() && texts.first().contains("on the planets"), qPrintable(texts.join(" | ")));
    const auto found = diagnosticWith(Code::assembly);
    const SnapshotPtr broken = snapshot;
    for (const Fix& fix : fixesFor(*found, *broken)) {
      provoke(*fix.edit(*broken->mechanism));
      QVERIFY2(!diagnosticWith(Code::assembly), fix.text.c_str());
      QVERIFY2(!hasErrors(snapshot->diagnostics), fix.text.c_str());
    }
  }

  /// Sun 20, planets 26 and 15 on one body, ring 61: other teeth, or another number of planets.
  void steppedPlanetsBecomeEqual() {
    test::TrainSketch sketch(6);
    sketch.joint(0, 1, "a").joint(0, 2, "a").joint(0, 3, "a");
    for (const int planet : {4, 5, 6}) {
      sketch.joint(3, planet, "b" + std::to_string(planet));
      sketch.mesh(1, planet, 20, 26, MeshKind::external).mesh(planet, 2, 15, 61, MeshKind::internal);
    }
    provoke(sketch.build());
    const QStringList texts = offered(Code::assembly);
    QVERIFY2(texts.contains(QStringLiteral("Use 2 equally spaced planets")), qPrintable(texts.join(" | ")));
    QVERIFY2(texts.size() == 3 && texts.first().contains("teeth"), qPrintable(texts.join(" | ")));
    const auto found = diagnosticWith(Code::assembly);
    const SnapshotPtr broken = snapshot;
    for (const Fix& fix : fixesFor(*found, *broken)) {
      provoke(*fix.edit(*broken->mechanism));
      QVERIFY2(!diagnosticWith(Code::assembly), fix.text.c_str());
      QVERIFY2(!hasErrors(snapshot->diagnostics), fix.text.c_str());
      QCOMPARE(snapshot->matroid()->dof, broken->matroid()->dof);
    }
  }

  void theNumberOfPlanetsIsAFixToo() {
    provoke(test::planetary(20, 20, 3));  // 80 / 3
    const QStringList texts = offered(Code::assembly);
    QVERIFY2(texts.contains(QStringLiteral("Use 4 equally spaced planets")), qPrintable(texts.join(" | ")));
    eachFixRepairs(Code::assembly);
  }

  void aClutchBetweenDifferentAxesIsDropped() {
    const Mechanism set = test::planetary(18, 27);
    provoke(withClutch(set, set.links[2].id, set.links[4].id).value());
    QCOMPARE(offered(Code::turningLoop), QStringList(QStringLiteral("Delete clutch A")));
    eachFixRepairs(Code::turningLoop);
    QVERIFY(*snapshot->mechanism == set);
  }

  void undercutGoesWithMoreTeethOfTheSameRatio() {
    Mechanism pair = test::example("spur-pair");
    pair.gearMeshes.front().pitchPoint.reset();
    pair = *withTeeth(pair, pair.gearMeshes.front().id, 9, 18);
    provoke(pair);
    QVERIFY(diagnosticWith(Code::undercut));
    QVERIFY2(offered(Code::undercut).first().endsWith("the teeth everywhere"),
             qPrintable(offered(Code::undercut).join(" | ")));
    eachFixRepairs(Code::undercut);
    const GearMesh& mesh = snapshot->mechanism->gearMeshes.front();
    QCOMPARE(mesh.headTeeth, 2 * mesh.tailTeeth);
  }

  void aLockedTrainIsFreed() {
    provoke(test::example("locked-train"));
    const Code code = diagnosticWith(Code::locked) ? Code::locked : Code::deadJoint;
    QVERIFY(!offered(code).isEmpty());
    eachFixRepairs(code);
    QVERIFY(snapshot->matroid()->dof > 0);
  }

  /// What couplings lock, releasing one of them frees; what holds nothing is released.
  void engagedCouplingsAreReleased() {
    const Mechanism box = test::example("eight-speed-gearbox");
    const std::vector<ShiftElementId> most{ShiftElementId("A"), ShiftElementId("B"), ShiftElementId("C"),
                                           ShiftElementId("D")};
    provoke(*withEngagement(box, most));
    QCOMPARE(offered(Code::locked).first(), QStringLiteral("Release brake A"));
    eachFixRepairs(Code::locked);
    QCOMPARE(snapshot->matroid()->dof, 1);
    provoke(*withEngagement(*withBrake(*withEngagement(box, {}), LinkId("2"), "A2"),
                            {ShiftElementId("A"), ShiftElementId("A2")}));
    QCOMPARE(offered(Code::redundantCoupling), QStringList(QStringLiteral("Release brake A2")));
    eachFixRepairs(Code::redundantCoupling);
    QCOMPARE(snapshot->mechanism->engaged, std::vector{ShiftElementId("A")});
  }

  void ratiosRoundALoopAreMadeToAgree() {
    // Two parallel paths from shaft 1 to shaft 2 with ratios 1/2 and 20/41.
    Mechanism train = emptyMechanism();
    train = *withLink(std::move(train), {0, 0});
    train = *withLink(std::move(train), {1, 0});
    const LinkId ground = train.links[0].id;
    const LinkId one = train.links[1].id;
    const LinkId two = train.links[2].id;
    train = *withTurningJoint(std::move(train), ground, one);
    train = *withTurningJoint(std::move(train), ground, two);
    train = *withGearMesh(std::move(train), one, two, 20, 40);
    train = *withGearMesh(std::move(train), one, two, 20, 41);
    provoke(train);
    QVERIFY(diagnosticWith(Code::locked));
    QVERIFY2(offered(Code::locked).first().startsWith("Use "), qPrintable(offered(Code::locked).join(" | ")));
    eachFixRepairs(Code::locked);
  }

  /// A coupling closes this loop, not a turning joint: the coupling can be dropped.
  void aCouplingThatClosesALinkageIsDropped() {
    Mechanism arm = emptyMechanism();
    const std::array<NumberTriple, 4> directions{triple(0, 0, 1), triple(1, 0, 0), triple(0, 1, 1),
                                                 triple(1, 1, 0)};
    for (const NumberTriple& direction : directions) {
      arm = *withLink(std::move(arm), {0, 0});
      const LinkId tail = arm.links[arm.links.size() - 2].id;
      arm = *withTurningJoint(arm, tail, LinkId(arm.links.back().id));
      arm.axes.back().point = triple(0, 0, 0);
      arm.axes.back().direction = direction;
    }
    arm.couplings.push_back({ShiftElementId("B"), ShiftElementKind::brake, {arm.links.back().id}, {}});
    arm.states.push_back({"s", {ShiftElementId("B")}, arm.links[1].id, arm.links[2].id, {}});
    snapshot = analyze(std::make_shared<const Mechanism>(arm));
    const auto found = diagnosticWith(Code::turningLoop);
    QVERIFY(found && found->detail == Detail::couplingLinkage);
    const std::vector<Fix> fixes = fixesFor(*found, *snapshot);
    QCOMPARE(fixes.size(), std::size_t{1});
    QCOMPARE(QString::fromStdString(fixes.front().text), QString("Delete brake B"));
    snapshot = analyze(std::make_shared<const Mechanism>(fixes.front().edit(arm).value()));
    QVERIFY(!diagnosticWith(Code::turningLoop));
  }

  /// Bevels of the robot on the other side of their apex: links cross each other's way.
  void overlapsAreClearedAlongAnAxis() {
    Mechanism robot = test::example("robot");
    int provoked = 0;
    for (std::size_t first = 0; first < robot.gearMeshes.size(); ++first) {
      for (const bool ofTail : {true, false}) {
        const Expected<PlacedMechanism> flipped =
            withBevelSideFlipped(robot, robot.gearMeshes[first].id, ofTail);
        if (!flipped) continue;
        provoke(flipped->mechanism());
        const auto found = diagnosticWith(Code::interference);
        if (!found) continue;
        const std::vector<Fix> fixes = fixesFor(*found, *snapshot);
        if (fixes.empty()) continue;
        const QString text = QString::fromStdString(fixes.front().text);
        QVERIFY2(text.startsWith(QStringLiteral("Move joint ")) && text.endsWith(QStringLiteral(" mm")),
                 qPrintable(text));
        ++provoked;
        const Mechanism repaired = fixes.front().edit(*snapshot->mechanism).value();
        for (const Diagnostic& left : trainDiagnostics(repaired, placementOf(repaired)))
          QVERIFY(left.elements != found->elements || left.detail != found->detail);
      }
    }
    QVERIFY(provoked > 0);
  }

  void whatOnlyAPersonCanTellHasNoFix() {
    provoke(emptyMechanism());
    QVERIFY(fixesFor({Code::noMeshes, "", {}, {}, 0, 0}, *snapshot).empty());
    QVERIFY(fixesFor({Code::symbolicSkipped, "", {}, {}, 0, 0}, *snapshot).empty());
    // A diagnostic about elements that are gone meanwhile.
    QVERIFY(fixesFor({Code::teethGeometry, "", {MeshId("gone")}, {}, 0, 0}, *snapshot).empty());
  }
};

}  // namespace geargraph

QTEST_GUILESS_MAIN(geargraph::FixesTest)
#include "test_fixes.moc"

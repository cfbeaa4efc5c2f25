#include <QTest>

#include "core/mechanism/model/edits.h"
#include "core/mechanism/model/link_edits.h"
#include "core/mechanism/model/load_edits.h"
#include "core/mechanism/model/mass_edits.h"
#include "core/mechanism/model/shapes.h"
#include "core/mechanism/model/shift_edits.h"
#include "core/mechanism/model/validate.h"
#include "tests/core/support/mechanisms.h"

namespace geargraph {
namespace {

Code rejectionOf(const Expected<Mechanism>& result) {
  return result.error().front().code;
}

/// Two gear pairs on the ground: links 1 and 2 on axes a and b, 3 and 4 on c and d; meshes 1-2 and 3-4.
Mechanism twoPairs() {
  Mechanism pairs = emptyMechanism();
  for (int i = 0; i < 4; ++i) pairs = withLink(pairs, {100.0 * i, 0}).value();
  const LinkId ground = pairs.links.front().id;
  for (const char* link : {"1", "2", "3", "4"}) pairs = withTurningJoint(pairs, ground, LinkId(link)).value();
  pairs = withGearMesh(pairs, LinkId("1"), LinkId("2"), 20, 40).value();
  return withGearMesh(pairs, LinkId("3"), LinkId("4"), 18, 54).value();
}

JointId carrying(const Mechanism& mechanism, const char* link) {
  for (const TurningJoint& joint : mechanism.turningJoints) {
    if (joint.head == LinkId(link)) return joint.id;
  }
  return {};
}

AxisId axisOf(const Mechanism& mechanism, const char* link) {
  return mechanism.find(carrying(mechanism, link))->axis;
}

Mechanism placed(Mechanism mechanism, const char* link, int x, int y, int z, NumberTriple direction) {
  const AxisId axis = axisOf(mechanism, link);
  return withAxisPlaced(mechanism, axis, NumberTriple{Number(x), Number(y), Number(z)}, direction).value();
}
const NumberTriple kZ{Number(0), Number(0), Number(1)};
const NumberTriple kX{Number(1), Number(0), Number(0)};

LinkId lastOf(const Mechanism& mechanism) {
  return mechanism.links.back().id;
}

/// Sun 1, ring 2 and carrier 3 on one axis, a planet, the last link, on the carrier; 3 also drives 4.
Mechanism planetary() {
  Mechanism set = twoPairs();
  for (const char* link : {"2", "3"}) set = withJointAxis(set, carrying(set, link), axisOf(set, "1")).value();
  set = withoutElements(set, std::vector<ElementId>{set.gearMeshes[0].id}).value();
  set = withLink(set, {}).value();
  set = withTurningJoint(set, LinkId("3"), lastOf(set)).value();
  set = withGearMesh(set, LinkId("1"), lastOf(set), 20, 20).value();
  return withGearMesh(set, lastOf(set), LinkId("2"), 20, 60).value();
}

Mechanism welded(const Mechanism& mechanism, const char* kept, const char* other) {
  return withLinksMerged(mechanism, LinkId(kept), LinkId(other)).value();
}

}  // namespace

/// Welds and splits of links.
class LinkEditsTest : public QObject {
  Q_OBJECT

 private slots:
  void aWeldTakesOneLinkOneJointAndOneAxis() {
    const Mechanism before = twoPairs();
    const Mechanism after = welded(before, "2", "3");
    QVERIFY(wellFormedDiagnostics(after).empty());
    QVERIFY(treeDiagnostics(after).empty());
    QCOMPARE(after.n(), 3);
    QCOMPARE(after.t(), 3);
    QCOMPARE(after.c(), 2);
    QCOMPARE(after.axes.size(), std::size_t{3});
    QVERIFY(after.find(LinkId("3")) == nullptr);
    QCOMPARE(after.gearMeshes[1].tail, LinkId("2"));
    QVERIFY(!after.view.nodes.contains(LinkId("3")));
    // Colours stay with the links.
    QCOMPARE(after.colorNumber(1), before.colorNumber(1));
    QCOMPARE(after.colorNumber(3), before.colorNumber(4));
  }

  void theFirstLinkIsKeptWhateverItIsCalled() {
    Mechanism named = withName(twoPairs(), LinkId("3"), "pinion").value();
    QCOMPARE(welded(named, "2", "3").find(LinkId("2"))->name, std::string("pinion"));
    named = withName(named, LinkId("2"), "wheel").value();
    QCOMPARE(welded(named, "2", "3").find(LinkId("2"))->name, std::string("wheel"));
    QCOMPARE(welded(named, "3", "2").find(LinkId("3"))->name, std::string("pinion"));
  }

  void theGroundIsKept() {
    Mechanism before = withBrake(planetary(), LinkId("2"), "B").value();
    before = withClutch(before, LinkId("2"), LinkId("1"), "C").value();
    before.engaged = {ShiftElementId("B")};
    const Mechanism after = withLinksMerged(before, LinkId("2"), before.links.front().id).value();
    QVERIFY(wellFormedDiagnostics(after).empty());
    QCOMPARE(after.links.front().id, before.links.front().id);
    QCOMPARE(after.gearMeshes.back().head, after.links.front().id);
    // Its brake has nothing to hold any more; a clutch to the frame is a brake.
    QCOMPARE(after.couplings.size(), std::size_t{1});
    QCOMPARE(after.couplings[0].kind, ShiftElementKind::brake);
    QCOMPARE(after.couplings[0].links, std::vector<LinkId>{LinkId("1")});
    QVERIFY(after.engaged.empty());
  }

  void whatDoesNotFitIsRejectedWithItsCulprits() {
    const Mechanism before = twoPairs();
    QCOMPARE(rejectionOf(withLinksMerged(before, LinkId("2"), LinkId("99"))), Code::unknownId);
    QCOMPARE(rejectionOf(withLinksMerged(before, LinkId("2"), LinkId("2"))), Code::selfJoint);
    const auto meshing = withLinksMerged(before, LinkId("1"), LinkId("2"));
    QCOMPARE(rejectionOf(meshing), Code::selfJoint);
    QCOMPARE(meshing.error().front().elements.front(), ElementId(before.gearMeshes[0].id));
    Mechanism heavy = withLinkMass(before, LinkId("3"), LinkMass{Number(1), {}, {}}).value();
    QCOMPARE(rejectionOf(withLinksMerged(heavy, LinkId("2"), LinkId("3"))), Code::schema);
    const Mechanism loaded = withLoad(before, {{}, LinkTorque{LinkId("3"), {}, Number(5)}}).value();
    QCOMPARE(rejectionOf(withLinksMerged(loaded, before.links.front().id, LinkId("3"))), Code::schema);
  }

  void aLinkCannotTurnAboutTwoAxes() {
    // 1 and 4 would lie on one axis and leave 2, which turns on 1 by way of the ground, on two.
    Mechanism planets = withLink(twoPairs(), {}).value();
    planets = withTurningJoint(planets, LinkId("1"), lastOf(planets)).value();
    const auto rejected = withLinksMerged(planets, lastOf(planets), LinkId("4"));
    QCOMPARE(rejectionOf(rejected), Code::turningLoop);
    QCOMPARE(rejected.error().front().detail, Detail::turningCycle);
    // A planet welded to its carrier: both wheels of its mesh with the sun would turn about one axis.
    const Mechanism set = planetary();
    const auto coaxial = withLinksMerged(set, LinkId("3"), lastOf(set));
    QCOMPARE(rejectionOf(coaxial), Code::turningLoop);
    QCOMPARE(coaxial.error().front().elements.back().kind, ElementKind::gearMesh);
  }

  void aPlaceIsTakenOrKept() {
    const Mechanism open = twoPairs();
    const auto pointOf = [](const Mechanism& mechanism, const char* link) {
      return mechanism.find(axisOf(mechanism, link))->point;
    };
    // Only the one that goes has a place.
    const Mechanism taken = welded(placed(open, "3", 0, 60, 0, kZ), "2", "3");
    QCOMPARE(pointOf(taken, "2"), (NumberTriple{Number(0), Number(60), Number(0)}));
    // Both have: all that hangs on the other one comes along.
    Mechanism both = placed(placed(placed(open, "2", 30, 0, 0, kZ), "3", 0, 60, 7, kZ), "4", 0, 96, 7, kZ);
    both =
        withPitchPoint(both, both.gearMeshes[1].id, NumberTriple{Number(0), Number(69), Number(7)}).value();
    const Mechanism moved = welded(both, "2", "3");
    QCOMPARE(pointOf(moved, "2"), (NumberTriple{Number(30), Number(0), Number(0)}));
    QCOMPARE(pointOf(moved, "4"), (NumberTriple{Number(30), Number(36), Number(7)}));
    QCOMPARE(*moved.gearMeshes[1].pitchPoint, (NumberTriple{Number(30), Number(9), Number(7)}));
    QCOMPARE(pointOf(moved, "1"), std::nullopt);
    // Across: no line is both.
    const auto across =
        withLinksMerged(placed(placed(open, "2", 0, 0, 0, kZ), "3", 0, 60, 0, kX), LinkId("2"), LinkId("3"));
    QCOMPARE(rejectionOf(across), Code::turningLoop);
    QCOMPARE(across.error().front().elements.front().kind, ElementKind::axis);
  }

  void bearingsStayWhereTheyAreAlongTheLine() {
    Mechanism both =
        placed(placed(twoPairs(), "2", 0, 0, 0, kZ), "3", 0, 60, 10, {Number(0), Number(0), Number(2)});
    // On axis c, 4 mm above its point; link 4 turns on it, too.
    both = withJointAxis(both, carrying(both, "4"), axisOf(both, "3")).value();
    both = withoutElements(both, std::vector<ElementId>{both.gearMeshes[1].id}).value();
    both = withOffset(both, carrying(both, "4"), Number(4)).value();
    const Mechanism after = welded(both, "2", "3");
    QCOMPARE(after.find(carrying(after, "4"))->axis, axisOf(after, "2"));
    QCOMPARE(after.find(carrying(after, "4"))->offset, Number(14));
  }

  void inputsLimitsAndLoadsGoToTheJointThatStays() {
    Mechanism before = twoPairs();
    const JointId goes = carrying(before, "3");
    const JointId stays = carrying(before, "2");
    before = withFlipped(before, goes).value();
    before = withInputs(before, std::vector<Input>{{goes, Number(7), {}}}).value();
    before = withJointLimits(before, goes, {Number(-10), Number(20)}).value();
    before = withJointLimits(before, stays, {Number(-90), Number(5)}).value();
    before = withLoad(before, {{}, JointTorque{goes, Number(3)}}).value();
    const Mechanism after = welded(before, "2", "3");
    QVERIFY(wellFormedDiagnostics(after).empty());
    // Tail and head were the other way round.
    QCOMPARE(after.inputs->front().joint, stays);
    QCOMPARE(after.inputs->front().speed, Number(-7));
    QCOMPARE(after.find(stays)->limits, (JointLimits{Number(-20), Number(5)}));
    const auto& torque = std::get<JointTorque>(after.loads.front().action);
    QCOMPARE(torque.joint, stays);
    QCOMPARE(torque.torque, Number(-3));
  }

  void aJointBetweenTheTwoGoesAndItsLoadIsAskedFor() {
    Mechanism before = withLink(twoPairs(), {}).value();
    before = withTurningJoint(before, LinkId("1"), lastOf(before)).value();
    QCOMPARE(withLinksMerged(before, LinkId("1"), lastOf(before)).value().t(), 4);
    const JointId joint = before.turningJoints.back().id;
    const Mechanism loaded = withLoad(before, {{}, JointTorque{joint, Number(3)}}).value();
    QCOMPARE(rejectionOf(withLinksMerged(loaded, LinkId("1"), lastOf(before))), Code::schema);
  }

  void equalMeshesBecomeOneAndClutchesBetweenGo() {
    Mechanism before = withClutch(twoPairs(), LinkId("2"), LinkId("3"), "K").value();
    before.engaged = {ShiftElementId("K")};
    // Another wheel like 2 on the same pinion, drawn from its other end.
    before = withLink(before, {}).value();
    before = withTurningJoint(before, before.links.front().id, lastOf(before)).value();
    before = withGearMesh(before, lastOf(before), LinkId("1"), 40, 20).value();
    QCOMPARE(withLinksMerged(before, LinkId("2"), lastOf(before)).value().c(), 2);
    before.gearMeshes.back().tailTeeth = 41;
    QCOMPARE(withLinksMerged(before, LinkId("2"), lastOf(before)).value().c(), 3);
    const Mechanism after = welded(before, "2", "3");
    QVERIFY(after.couplings.empty());
    QVERIFY(after.engaged.empty());
  }

  void aSplitUndoesAWeld() {
    const Mechanism whole = welded(twoPairs(), "2", "3");
    const std::vector<ElementId> side = lastSideOf(whole, LinkId("2"));
    QCOMPARE(side, std::vector<ElementId>{whole.gearMeshes[1].id});
    const Mechanism parts = withLinkSplit(whole, LinkId("2"), side, CanvasPoint{5, 6}).value();
    QVERIFY(wellFormedDiagnostics(parts).empty());
    QVERIFY(treeDiagnostics(parts).empty());
    QCOMPARE(parts.n(), 4);
    QCOMPARE(parts.t(), 4);
    const LinkId part = parts.links.back().id;
    QCOMPARE(parts.gearMeshes[1].tail, part);
    QCOMPARE(parts.gearMeshes[0].head, LinkId("2"));
    QCOMPARE(parts.turningJoints.back().axis, axisOf(parts, "2"));
    QCOMPARE(parts.view.nodes.at(part), (CanvasPoint{5, 6}));
    QVERIFY(withLinksMerged(parts, LinkId("2"), part).value() == whole);
  }

  void theCarryingJointMayGoToTheNewLink() {
    const Mechanism whole = welded(twoPairs(), "2", "3");
    const JointId joint = carrying(whole, "2");
    const Mechanism parts =
        withLinkSplit(whole, LinkId("2"), std::vector<ElementId>{joint, whole.gearMeshes[1].id}).value();
    QVERIFY(treeDiagnostics(parts).empty());
    QCOMPARE(parts.find(joint)->head, parts.links.back().id);
    QCOMPARE(parts.turningJoints.back().head, LinkId("2"));
  }

  void wheelsGoWithTheirMeshesOrAreCopied() {
    Mechanism whole = welded(twoPairs(), "2", "3");
    whole.wheels.push_back({WheelId("w"), LinkId("2"), Number(0), {}, {}, {}});
    whole.gearMeshes[1].tailWheel = WheelId("w");
    const std::vector<ElementId> side{whole.gearMeshes[1].id};
    const Mechanism moved = withLinkSplit(whole, LinkId("2"), side).value();
    QCOMPARE(moved.wheels.size(), std::size_t{1});
    QCOMPARE(moved.wheels[0].link, moved.links.back().id);
    whole.gearMeshes[0].headWheel = WheelId("w");
    const Mechanism copied = withLinkSplit(whole, LinkId("2"), side).value();
    QVERIFY(wellFormedDiagnostics(copied).empty());
    QCOMPARE(copied.wheels.size(), std::size_t{2});
    QCOMPARE(copied.wheels[0].link, LinkId("2"));
  }

  void splitsThatMakeNoSenseAreRejected() {
    const Mechanism pairs = twoPairs();
    const auto split = [&](const char* link, std::vector<ElementId> moving) {
      return rejectionOf(withLinkSplit(pairs, LinkId(link), moving));
    };
    const ElementId mesh = pairs.gearMeshes[0].id;
    QCOMPARE(split("99", {mesh}), Code::unknownId);
    QCOMPARE(split("2", {MeshId("99")}), Code::unknownId);
    QCOMPARE(split("2", {pairs.gearMeshes[1].id}), Code::schema);  // of another link
    QCOMPARE(split("2", {LinkId("2")}), Code::schema);
    QCOMPARE(split("2", {}), Code::schema);      // nothing goes
    QCOMPARE(split("2", {mesh}), Code::schema);  // nothing stays
    QCOMPARE(rejectionOf(withLinkSplit(pairs, pairs.links.front().id, std::vector<ElementId>{})),
             Code::schema);
    const Mechanism loose = withLink(pairs, {}).value();
    QCOMPARE(rejectionOf(withLinkSplit(loose, loose.links.back().id, std::vector<ElementId>{})),
             Code::schema);
    QVERIFY(lastSideOf(pairs, LinkId("2")).empty());
    QVERIFY(lastSideOf(pairs, pairs.links.front().id).empty());
  }

  void whateverIsWeldedStaysWellFormed() {
    int made = 0;
    for (std::uint64_t seed = 0; seed < 60; ++seed) {
      const Mechanism tree = test::randomTree(seed, 8, 5);
      for (int a = 0; a <= tree.n(); ++a) {
        for (int b = 0; b <= tree.n(); ++b) {
          const LinkId kept = tree.links[static_cast<std::size_t>(a)].id;
          const auto after = withLinksMerged(tree, kept, tree.links[static_cast<std::size_t>(b)].id);
          if (!after) continue;
          ++made;
          QVERIFY(wellFormedDiagnostics(*after).empty());
          QVERIFY(treeDiagnostics(*after).empty());
          QCOMPARE(after->n(), tree.n() - 1);
          QCOMPARE(after->t(), tree.t() - 1);
        }
      }
    }
    QVERIFY(made > 500);
  }
};

}  // namespace geargraph

QTEST_APPLESS_MAIN(geargraph::LinkEditsTest)

#include "test_link_edits.moc"

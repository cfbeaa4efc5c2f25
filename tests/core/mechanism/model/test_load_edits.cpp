#include <QTest>

#include "core/mechanism/model/difference.h"
#include "core/mechanism/model/edits.h"
#include "core/mechanism/model/fragment.h"
#include "core/mechanism/model/load_edits.h"
#include "core/mechanism/model/mass_edits.h"
#include "core/mechanism/model/patch.h"
#include "core/mechanism/model/validate.h"
#include "tests/core/support/trains.h"

using namespace geargraph;
using namespace geargraph::test;

namespace {

Load inJoint(const char* joint, std::int64_t torque) {
  return {{}, JointTorque{JointId(joint), Number(torque)}};
}
Load onLink(const char* link, std::optional<AxisId> axis, std::int64_t torque) {
  return {{}, LinkTorque{LinkId(link), axis, Number(torque)}};
}
Load force(const char* link) {
  return {{},
          LinkForce{LinkId(link), {Number(0), Number(0), Number(-20)}, {Number(0), Number(40), Number(132)}}};
}

/// The robot with a torque in joint 14, one on link 3 about axis e, a force on link 7, and balances in joint
/// 8 and on link 1.
Mechanism loaded() {
  Mechanism robot = *withLoad(test::robot(), inJoint("14", 10));
  robot = *withLoad(robot, onLink("3", AxisId("e"), 5));
  robot = *withLoad(robot, force("7"));
  return *withBalances(
      robot, std::vector<HoldingTorque>{{JointId("8")}, {HoldingTorque::OnLink{LinkId("1"), AxisId("b")}}});
}

Mechanism without(const Mechanism& mechanism, const ElementId& element) {
  const std::vector<ElementId> gone{element};
  return *withoutElements(mechanism, gone);
}

}  // namespace

class LoadEditsTest : public QObject {
  Q_OBJECT

 private slots:
  void newLoadsAreNamedInOrder() {
    const Mechanism robot = loaded();
    QVERIFY(wellFormedDiagnostics(robot).empty());
    QCOMPARE(robot.loads[0].id, LoadId("L1"));
    QCOMPARE(robot.loads[2].id, LoadId("L3"));
    QCOMPARE(withLoad(*withoutLoad(robot, 0), inJoint("13", 1))->loads[2].id, LoadId("L1"));
  }

  void loadsThatCannotBeAreRejected() {
    const Mechanism robot = loaded();
    QCOMPARE(withLoad(robot, inJoint("77", 1)).error()[0].code, Code::unknownId);
    QCOMPARE(withLoad(robot, onLink("0", {}, 1)).error()[0].code, Code::schema);
    QCOMPARE(withLoad(robot, onLink("3", AxisId("none"), 1)).error()[0].code, Code::unknownId);
    QCOMPARE(withLoad(robot, {LoadId("L1"), inJoint("8", 1).action}).error()[0].code, Code::duplicateId);
    QCOMPARE(withLoad(robot, {{}, JointTorque{JointId("8"), *Number::fromText("1e16")}}).error()[0].code,
             Code::schema);
    QCOMPARE(withBalances(robot, std::vector<HoldingTorque>{{JointId("8")}, {JointId("8")}}).error()[0].code,
             Code::duplicateId);
    QCOMPARE(withBalances(robot, std::vector<HoldingTorque>{{HoldingTorque::OnLink{LinkId("0"), {}}}})
                 .error()[0]
                 .code,
             Code::schema);
  }

  void anActionChangesInItsPlace() {
    const Mechanism robot = loaded();
    const Mechanism other = *withLoadAction(robot, 1, inJoint("13", -4).action);
    QCOMPARE(other.loads[1].id, robot.loads[1].id);
    QCOMPARE(jointOf(other.loads[1]), std::optional(JointId("13")));
    QVERIFY(differenceOf(robot, other).other && !isSameButForView(robot, other));
    QCOMPARE(withLoadAction(robot, 1, onLink("0", {}, 1).action).error()[0].code, Code::schema);
  }

  void lossesHaveTheirRange() {
    const Mechanism robot = test::robot();
    const MeshId mesh("15");
    const auto number = [](const char* text) { return Number::fromText(text); };
    QCOMPARE(withMeshLosses(robot, mesh, number("0.98"), {})->gearMeshes[0].efficiency->text(),
             std::string("0.98"));
    QVERIFY(withMeshLosses(robot, mesh, number("1"), {}) && withMeshLosses(robot, mesh, {}, number("0")));
    for (const char* bad : {"0", "-0.5", "1.01"})
      QCOMPARE(withMeshLosses(robot, mesh, number(bad), {}).error()[0].code, Code::schema);
    for (const char* bad : {"-0.01", "1.01"})
      QCOMPARE(withDefaultLosses(robot, {}, number(bad)).error()[0].code, Code::schema);
    QCOMPARE(withMeshLosses(robot, mesh, number("1"), number("0")).error()[0].code, Code::schema);
    QCOMPARE(withMeshLosses(robot, MeshId("8"), {}, {}).error()[0].code, Code::unknownId);
    QVERIFY(withDefaultLosses(robot, number("0.97"), {})->gearDefaults->efficiency);
    QVERIFY(*withDefaultLosses(robot, {}, {}) == robot);
  }

  void loadsGoWithWhatBearsThem() {
    const Mechanism robot = loaded();
    QCOMPARE(without(robot, LoadId("L2")).loads.size(), std::size_t{2});
    const Mechanism noJoint = without(robot, JointId("14"));
    QVERIFY(std::none_of(noJoint.loads.begin(), noJoint.loads.end(),
                         [](const Load& load) { return jointOf(load).has_value(); }));
    const Mechanism noLink = without(robot, LinkId("3"));
    for (const Load& load : noLink.loads) QVERIFY(linkOf(load) != LinkId("3"));
    QCOMPARE(without(robot, JointId("8")).balances->size(), std::size_t{1});
    QVERIFY(!without(without(robot, JointId("8")), LinkId("1")).balances);
    for (const Mechanism& next : {noJoint, noLink, without(robot, AxisId("e")), without(robot, LinkId("1"))})
      QVERIFY(wellFormedDiagnostics(next).empty());
  }

  void anAxisThatALoadNamesStays() {
    // Link 3 turns about axis e alone: with its joint gone, nothing but the load names the axis.
    const Mechanism next = without(loaded(), JointId("14"));
    QVERIFY(next.find(AxisId("e")) != nullptr);
    QVERIFY(wellFormedDiagnostics(next).empty());
    const Mechanism renamed = *withName(loaded(), AxisId("e"), "wrist");
    QCOMPARE(std::get<LinkTorque>(renamed.loads[1].action).axis, std::optional(AxisId("wrist")));
    QVERIFY(wellFormedDiagnostics(*withName(loaded(), AxisId("b"), "base")).empty());
  }

  void aJointTurnedRoundKeepsTheActionOnItsLinks() {
    const Mechanism turned = *withFlipped(loaded(), JointId("14"));
    QVERIFY(std::get<JointTorque>(turned.loads[0].action).torque.exact() == Rational(-10));
    QVERIFY(*withFlipped(turned, JointId("14")) == loaded());
  }

  void aLoadedLinkIsNoGround() {
    QCOMPARE(withGround(loaded(), LinkId("3")).error()[0].code, Code::schema);
    QCOMPARE(withGround(loaded(), LinkId("1")).error()[0].code, Code::schema);
    QVERIFY(withGround(loaded(), LinkId("4")).has_value());
  }

  void loadsAreCopiedWithTheirLinks() {
    const Mechanism robot = loaded();
    std::set<ElementId> all;
    for (const Link& link : robot.links) all.insert(link.id);
    const Mechanism twice = *withFragment(robot, fragmentOf(robot, all));
    QCOMPARE(twice.loads.size(), std::size_t{6});
    QVERIFY(wellFormedDiagnostics(twice).empty());
    QVERIFY(*linkOf(twice.loads[4]) != LinkId("3"));
    QCOMPARE(fragmentOf(robot, {LinkId("7")}).loads.size(), std::size_t{1});
  }

  void historyGivesEitherDocument() {
    const Mechanism before = loaded();
    Mechanism after = *withLoadAction(*withoutLoad(before, 0), 1, inJoint("12", 7).action);
    after = *withMeshLosses(*withBalances(after, {}), MeshId("16"), Number(1), {});
    const MechanismPatch patch(before, after);
    QVERIFY(patch.forward(before) == after && patch.back(after) == before && !patch.isEmpty());
    QVERIFY(patch.bytes() > sizeof(MechanismPatch));
  }

  void historyGivesEitherMass() {
    const Mechanism before = loaded();
    const InertiaNumbers inertia{*Number::fromText("1/3"), 1, 1, 0, 0, 0};
    Mechanism after = *withLinkMass(before, LinkId("3"), LinkMass{Number(2), NumberTriple{1, 2, 3}, inertia});
    const MechanismPatch oneMass(before, after);
    QVERIFY(oneMass.forward(before) == after && oneMass.back(after) == before);
    after = *withGravity(*withDensity(after, Number(2700)), NumberTriple{0, 0, -10});
    const MechanismPatch patch(before, after);
    QVERIFY(patch.forward(before) == after && patch.back(after) == before);
    QVERIFY(patch.bytes() > MechanismPatch(before, before).bytes() + sizeof(LinkMass));
    QVERIFY(!isSameButForView(before, after) && differenceOf(before, after).other);
    QVERIFY(isSameTrain(before, after));  // masses move no wheel
  }
};

QTEST_APPLESS_MAIN(LoadEditsTest)
#include "test_load_edits.moc"

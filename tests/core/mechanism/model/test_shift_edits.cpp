#include <QTest>

#include "core/mechanism/model/edits.h"
#include "core/mechanism/model/shift_edits.h"
#include "core/mechanism/model/validate.h"
#include "tests/core/support/gearboxes.h"

using namespace geargraph;
using namespace geargraph::test;

class ShiftEditsTest : public QObject {
  Q_OBJECT

 private slots:
  void newCouplingsTakeTheFirstFreeLetter() {
    const Mechanism more = *withClutch(*withBrake(eightSpeed(), LinkId("6")), LinkId("1"), LinkId("3"));
    QCOMPARE(more.couplings[5].id, ShiftElementId("F"));
    QCOMPARE(more.couplings[6].id, ShiftElementId("G"));
    QCOMPARE(more.couplings[6].links, (std::vector{LinkId("1"), LinkId("3")}));
    QVERIFY(wellFormedDiagnostics(more).empty());
  }

  void couplingsThatMakeNoSenseAreRejected() {
    QCOMPARE(withBrake(eightSpeed(), LinkId("0")).error()[0].code, Code::schema);
    QCOMPARE(withBrake(eightSpeed(), LinkId("77")).error()[0].code, Code::unknownId);
    QCOMPARE(withBrake(eightSpeed(), LinkId("1"), "A").error()[0].code, Code::duplicateId);
    QCOMPARE(withClutch(eightSpeed(), LinkId("1"), LinkId("1")).error()[0].code, Code::selfJoint);
  }

  void statesFollowTheNameOfACoupling() {
    const Mechanism renamed = *withCouplingRenamed(eightSpeed(), ShiftElementId("A"), "B1");
    QCOMPARE(renamed.states[0].engaged[0], ShiftElementId("B1"));
    QVERIFY(wellFormedDiagnostics(renamed).empty());
    QCOMPARE(withCouplingRenamed(eightSpeed(), ShiftElementId("A"), "B").error()[0].code, Code::duplicateId);
    QCOMPARE(withCouplingRenamed(eightSpeed(), ShiftElementId("A"), "").error()[0].code, Code::schema);
  }

  void aNewStateHasTheLinksOfTheLast() {
    const Mechanism more = *withState(eightSpeed());
    QCOMPARE(more.states.back().name, std::string("9"));
    QCOMPARE(*more.states.back().drive, LinkId("1"));
    QVERIFY(wellFormedDiagnostics(more).empty());
    QCOMPARE(withStateRenamed(more, 9, "1").error()[0].code, Code::duplicateId);
    QCOMPARE(withStateRenamed(more, 9, "P")->states[9].name, std::string("P"));
    QCOMPARE(withoutState(more, 9)->states, eightSpeed().states);
  }

  void dotsKeepTheOrderOfTheCouplings() {
    Mechanism gearbox = *withEngaged(eightSpeed(), 0, ShiftElementId("B"), false);
    QCOMPARE(gearbox.states[0].engaged, (std::vector{ShiftElementId("A"), ShiftElementId("C")}));
    gearbox = *withEngaged(gearbox, 0, ShiftElementId("B"), true);
    QCOMPARE(gearbox.states[0].engaged, eightSpeed().states[0].engaged);
  }

  void couplingsAreEngagedInTheirOrder() {
    const Mechanism gearbox = *withEngagement(eightSpeed(), {ShiftElementId("E"), ShiftElementId("A")});
    QCOMPARE(gearbox.engaged, (std::vector{ShiftElementId("A"), ShiftElementId("E")}));
    QVERIFY(wellFormedDiagnostics(gearbox).empty());
    QVERIFY(withEngagement(gearbox, {})->engaged.empty());
    QCOMPARE(withEngagement(gearbox, {ShiftElementId("X")}).error()[0].code, Code::unknownId);
    QCOMPARE(withEngagement(gearbox, {ShiftElementId("B"), ShiftElementId("B")}).error()[0].code,
             Code::duplicateId);
  }

  /// Whatever edit takes a coupling away or renames it, the engagement names couplings that exist.
  void theEngagementFollowsItsCouplings() {
    const Mechanism engaged = *withEngagement(eightSpeed(), {ShiftElementId("A"), ShiftElementId("E")});
    QCOMPARE(withCouplingRenamed(engaged, ShiftElementId("A"), "B1")->engaged,
             (std::vector{ShiftElementId("B1"), ShiftElementId("E")}));
    const std::vector<ElementId> coupling{ShiftElementId("A")};
    QCOMPARE(withoutElements(engaged, coupling)->engaged, std::vector{ShiftElementId("E")});
    const std::vector<ElementId> link{LinkId("5")};  // clutch E is on it
    const Mechanism without = *withoutElements(engaged, link);
    QCOMPARE(without.engaged, std::vector{ShiftElementId("A")});
    QVERIFY(wellFormedDiagnostics(without).empty());
  }

  void theStateThatIsEngagedIsFound() {
    const Mechanism now = *withEngagement(eightSpeed(), eightSpeed().states[2].engaged);
    QVERIFY(isEngaged(now, 2) && !isEngaged(now, 0) && !isEngaged(eightSpeed(), 2));
    QCOMPARE(engagedState(now), 2);
    QCOMPARE(engagedState(eightSpeed()), -1);
    QVERIFY(!isEngaged(*withState(eightSpeed()), 9));  // a state without couplings
    QCOMPARE(engagedState(*withEngaged(now, 2, ShiftElementId("A"), true)), -1);
  }

  void driveAndDrivenOfOneStateOrOfAll() {
    QCOMPARE(*withDrive(eightSpeed(), 2, LinkId("3"))->states[2].drive, LinkId("3"));
    const Mechanism all = *withDriven(eightSpeed(), -1, LinkId("6"));
    for (const ShiftState& state : all.states) QCOMPARE(*state.driven, LinkId("6"));
  }
};

QTEST_APPLESS_MAIN(ShiftEditsTest)
#include "test_shift_edits.moc"

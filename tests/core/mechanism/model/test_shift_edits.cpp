#include <QtTest>

#include "core/mechanism/model/edits.h"
#include "core/mechanism/model/shift_edits.h"
#include "core/mechanism/model/validate.h"
#include "tests/core/support/gearboxes.h"

using namespace geargraph;
using namespace geargraph::test;

class TestShiftEdits : public QObject {
  Q_OBJECT

 private slots:
  void newCouplingsTakeTheFirstFreeLetter() {
    const Mechanism more = *withClutch(*withBrake(eightSpeed(), LinkId("6")), LinkId("1"), LinkId("3"));
    QCOMPARE(more.couplings[5].id, CouplingId("F"));
    QCOMPARE(more.couplings[6].id, CouplingId("G"));
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
    const Mechanism renamed = *withCouplingRenamed(eightSpeed(), CouplingId("A"), "B1");
    QCOMPARE(renamed.states[0].engaged[0], CouplingId("B1"));
    QVERIFY(wellFormedDiagnostics(renamed).empty());
    QCOMPARE(withCouplingRenamed(eightSpeed(), CouplingId("A"), "B").error()[0].code, Code::duplicateId);
    QCOMPARE(withCouplingRenamed(eightSpeed(), CouplingId("A"), "").error()[0].code, Code::schema);
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
    Mechanism gearbox = *withEngaged(eightSpeed(), 0, CouplingId("B"), false);
    QCOMPARE(gearbox.states[0].engaged, (std::vector{CouplingId("A"), CouplingId("C")}));
    gearbox = *withEngaged(gearbox, 0, CouplingId("B"), true);
    QCOMPARE(gearbox.states[0].engaged, eightSpeed().states[0].engaged);
  }

  void couplingsAreEngagedInTheirOrder() {
    const Mechanism gearbox = *withEngagement(eightSpeed(), {CouplingId("E"), CouplingId("A")});
    QCOMPARE(gearbox.engaged, (std::vector{CouplingId("A"), CouplingId("E")}));
    QVERIFY(wellFormedDiagnostics(gearbox).empty());
    QVERIFY(withEngagement(gearbox, {})->engaged.empty());
    QCOMPARE(withEngagement(gearbox, {CouplingId("X")}).error()[0].code, Code::unknownId);
    QCOMPARE(withEngagement(gearbox, {CouplingId("B"), CouplingId("B")}).error()[0].code, Code::duplicateId);
  }

  /// Whatever edit takes a coupling away or renames it, the engagement names couplings that exist.
  void theEngagementFollowsItsCouplings() {
    const Mechanism engaged = *withEngagement(eightSpeed(), {CouplingId("A"), CouplingId("E")});
    QCOMPARE(withCouplingRenamed(engaged, CouplingId("A"), "B1")->engaged,
             (std::vector{CouplingId("B1"), CouplingId("E")}));
    const std::vector<ElementId> coupling{CouplingId("A")};
    QCOMPARE(withoutElements(engaged, coupling)->engaged, std::vector{CouplingId("E")});
    const std::vector<ElementId> link{LinkId("5")};  // clutch E is on it
    const Mechanism without = *withoutElements(engaged, link);
    QCOMPARE(without.engaged, std::vector{CouplingId("A")});
    QVERIFY(wellFormedDiagnostics(without).empty());
  }

  void theStateThatIsEngagedIsFound() {
    const Mechanism now = *withEngagement(eightSpeed(), eightSpeed().states[2].engaged);
    QVERIFY(isEngaged(now, 2) && !isEngaged(now, 0) && !isEngaged(eightSpeed(), 2));
    QCOMPARE(engagedState(now), 2);
    QCOMPARE(engagedState(eightSpeed()), -1);
    QVERIFY(!isEngaged(*withState(eightSpeed()), 9));  // a state without couplings
    QCOMPARE(engagedState(*withEngaged(now, 2, CouplingId("A"), true)), -1);
  }

  void driveAndDrivenOfOneStateOrOfAll() {
    QCOMPARE(*withDrive(eightSpeed(), 2, LinkId("3"))->states[2].drive, LinkId("3"));
    const Mechanism all = *withDriven(eightSpeed(), -1, LinkId("6"));
    for (const ShiftState& state : all.states) QCOMPARE(*state.driven, LinkId("6"));
  }
};

QTEST_APPLESS_MAIN(TestShiftEdits)
#include "test_shift_edits.moc"

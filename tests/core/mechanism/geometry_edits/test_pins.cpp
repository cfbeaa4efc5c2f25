#include <QTest>

#include "core/mechanism/document_format/mechanism_file.h"
#include "core/mechanism/geometry_edits/axis_drag.h"
#include "core/mechanism/geometry_edits/mesh_snap.h"
#include "core/mechanism/model/edits.h"
#include "tests/core/mechanism/geometry_edits/fitted_trains.h"

using namespace geargraph;
using namespace geargraph::test;

namespace {

/// Two pairs of gears at module 2, every place stated: 20 with 30, 40 with 25; the second pair stands off.
Mechanism twoPairs() {
  TrainBuilder train("two pairs");
  const int a = train.axis({0, 0, 0}, {0, 0, 1});
  const int b = train.axis({50, 0, 0}, {0, 0, 1});
  const int c = train.axis({170, 0, 0}, {0, 0, 1});
  const int d = train.axis({170, 65, 0}, {0, 0, 1});
  const int first = train.link(0, a), second = train.link(0, b), third = train.link(0, c),
            fourth = train.link(0, d);
  train.external(first, a, 20, second, b, 30);
  train.external(third, c, 40, fourth, d, 25);
  return train.mechanism();
}

/// Links 2 and 3 of those are set into mesh.
Expected<PlacedMechanism> snapped(const Mechanism& pairs) {
  const Mechanism drawn = withGearMesh(pairs, pairs.links[2].id, pairs.links[3].id, 30, 40).value();
  return withMeshSnapped(drawn, drawn.gearMeshes.back().id);
}

ExactVector3 placeOf(const Mechanism& mechanism, std::size_t axis) {
  const NumberTriple& point = *mechanism.axes[axis].point;
  return {point[0].exact(), point[1].exact(), point[2].exact()};
}

}  // namespace

/// What stays where it is: what somebody has pinned, and what no new mesh reaches.
class PinsTest : public QObject {
  Q_OBJECT

 private slots:
  void gearsSetIntoMeshComeTogetherWithAllThatHangsOnThem() {
    const Mechanism pairs = twoPairs();
    const auto together = snapped(pairs);
    QVERIFY(together);
    QCOMPARE(placeOf(*together, 1), (ExactVector3{50, 0, 0}));
    QCOMPARE(placeOf(*together, 2), (ExactVector3{120, 0, 0}));  // 2 * (30 + 40) / 2 from the second
    QCOMPARE(placeOf(*together, 3), (ExactVector3{120, 65, 0}));
    QVERIFY(misfit(*together) < 1e-9);
    for (int m = 0; m < together->mechanism().c(); ++m) {
      const MeshGeometry geometry = *placementOf(*together).meshes[static_cast<std::size_t>(m)];
      QVERIFY(std::abs(2 * std::abs(geometry.tailRadius) / mesh(*together, m).tailTeeth - 2) < 1e-9);
    }
  }

  void whatIsPinnedStaysWhenGearsAreSetIntoMesh() {
    Mechanism pairs = twoPairs();
    pairs = withPinMark(pairs, pairs.axes[2].id, true).value();
    const auto together = snapped(pairs);
    QVERIFY(together);
    QCOMPARE(placeOf(*together, 2), (ExactVector3{170, 0, 0}));
    QCOMPARE(placeOf(*together, 1), (ExactVector3{100, 0, 0}));
    QCOMPARE(placeOf(*together, 0), (ExactVector3{50, 0, 0}));
    const AxisId second = pairs.axes[1].id;
    const auto rejected = snapped(withPinMark(pairs, second, true).value());
    QVERIFY(!rejected);
    QCOMPARE(rejected.error().front().code, Code::teethGeometry);
    const auto& culprits = rejected.error().front().elements;
    QVERIFY(std::find(culprits.begin(), culprits.end(), ElementId(second)) != culprits.end());
  }

  void gearsWithoutAModuleOrWithTwoStayWhereTheyAre() {
    Mechanism pairs = twoPairs();
    const Mechanism free = withGearMesh(pairs, pairs.links[2].id, pairs.links[3].id, 17, 19).value();
    QCOMPARE(withMeshSnapped(free, free.gearMeshes.back().id).value(), free);  // two new wheels
    pairs.axes[3].point = NumberTriple{Number(170), Number(130), Number(0)};   // the second pair at module 4
    pairs.gearMeshes[1].pitchPoint.reset();
    const auto both = snapped(pairs);
    QVERIFY(both);
    QCOMPARE(placeOf(*both, 2), (ExactVector3{170, 0, 0}));
  }

  void aPinStandsInTheFileAndIsKept() {
    const Mechanism before = statedPlanetary(1);
    const Mechanism pinned = pin(pin(before, before.axes[1].id), before.links[1].id);
    QVERIFY(isPinned(pinned.axes[1]) && isPinned(pinned.links[1]));
    QVERIFY(!isPinned(pinned.axes[0]) && !isPinned(pinned.links[2]));
    const std::string text = writeMechanism(pinned);
    QVERIFY(text.find("\"pinned\": true") != std::string::npos);
    QCOMPARE(*readMechanism(text), pinned);
    QCOMPARE(*withPinned(*withPinned(pinned, before.axes[1].id, false), before.links[1].id, false), before);
    QCOMPARE(withPinned(before, MeshId("none"), true).error()[0].code, Code::unknownId);
  }

  void anAxisThatTheProgramPlacedIsStatedWhenItIsPinned() {
    const Mechanism before = planetary(24, 18, 1);
    const Mechanism pinned = pin(before, before.axes[1].id);
    QVERIFY(pinned.axes[1].point && pinned.axes[1].direction);
    QCOMPARE(distanceOfAxis(pinned, 1), 42.0);
  }

  void aPinnedGearKeepsItsTeethAndTheOthersFollow() {
    const Mechanism before = statedPlanetary(3);
    const Mechanism ring = pin(before, before.links[2].id);
    // 24 + 18 + 18 = 60; with 30 teeth on the sun the planets have to have 15.
    const Mechanism after = *withTeethFitted(ring, mesh(before, 0).id, 30, 18);
    for (int planet = 0; planet < 3; ++planet) {
      QCOMPARE(mesh(after, 2 * planet).headTeeth, 15);
      QCOMPARE(mesh(after, 2 * planet + 1).headTeeth, 60);
      QCOMPARE(distanceOfAxis(after, 1 + planet), 45.0);
    }
    QVERIFY(misfit(after) < 1e-9);
    const auto odd = withTeethFitted(ring, mesh(before, 0).id, 25, 18);  // 17.5 teeth nobody cuts
    QVERIFY(!odd);
    QVERIFY(blames(odd.error()[0], before.links[2].id));
    const auto own = withTeethFitted(ring, mesh(before, 1).id, 18, 66);
    QVERIFY(!own && blames(own.error()[0], before.links[2].id));
  }

  void aPinnedPlanetHoldsIdenticalOnes() {
    const Mechanism before = statedPlanetary(3);
    const Mechanism pinned = pin(before, before.links[6].id);  // the third planet
    const auto rejected = withTeethFitted(pinned, mesh(before, 0).id, 24, 20);
    QVERIFY(!rejected && blames(rejected.error()[0], before.links[6].id));
    QVERIFY(withTeethFitted(pinned, mesh(before, 0).id, 30, 18).has_value());
  }

  void aPinnedAxisStaysAndTheOtherGoes() {
    TrainBuilder train("pair");
    const int a = train.axis({0, 0, 0}, {0, 0, 1});
    const int b = train.axis({40, 0, 0}, {0, 0, 1});
    const int one = train.link(0, a);
    train.external(one, a, 20, train.link(0, b), b, 20);
    const Mechanism before = train.mechanism();
    const Mechanism after = *withTeethFitted(pin(before, before.axes[1].id), mesh(before, 0).id, 20, 30);
    QCOMPARE(after.axes[1].point, before.axes[1].point);
    QCOMPARE((*after.axes[0].point)[0].exact(), Rational(-10));
    QVERIFY(misfit(after) < 1e-9);
    const auto rejected = withAxisMoved(pin(before, before.axes[1].id), before.axes[1].id, at(50, 0, 0));
    QVERIFY(!rejected && blames(rejected.error()[0], before.axes[1].id));
  }

  void betweenTwoPinnedAxesThePartnerFollows() {
    const Mechanism before = statedPlanetary(1);
    const Mechanism held = pin(pin(before, before.axes[0].id), before.axes[1].id);
    const Mechanism after = *withTeethFitted(held, mesh(before, 0).id, 22, 18);
    QCOMPARE(after.axes[1].point, before.axes[1].point);
    QCOMPARE(mesh(after, 0).headTeeth, 20);
    QCOMPARE(mesh(after, 1).headTeeth, 62);
    QVERIFY(misfit(after) < 1e-9);
    const auto rejected = withTeethFitted(pin(held, before.links[4].id), mesh(before, 0).id, 22, 18);
    QVERIFY(!rejected);
    for (const ElementId& culprit :
         {ElementId(before.axes[0].id), ElementId(before.axes[1].id), ElementId(before.links[4].id)})
      QVERIFY(blames(rejected.error()[0], culprit));
    // A third axis cannot be dragged away from two that are pinned.
    const Mechanism three = statedPlanetary(2);
    const auto drag =
        withAxisMoved(pin(pin(three, three.axes[0].id), three.axes[2].id), three.axes[1].id, at(63, 0, 0));
    QVERIFY(!drag && blames(drag.error()[0], three.axes[2].id));
  }
};

QTEST_APPLESS_MAIN(PinsTest)
#include "test_pins.moc"

#include <QTest>

#include "core/machine/body_layout/derived_geometry.h"
#include "core/presentation/schematic/arm_router.h"
#include "core/presentation/schematic/drawn_part.h"
#include "core/presentation/schematic/drawn_train.h"
#include "core/presentation/schematic/radial_system.h"
#include "core/presentation/schematic/shaft_plan.h"
#include "core/presentation/schematic/sheet_spacing.h"
#include "tests/core/support/example_files.h"
#include "tests/core/support/train_sketch.h"

using namespace geargraph;

namespace {

struct Laid {
  DerivedGeometry document;
  DrawnPart part;
  DrawnTrain train;
  SheetLayout layout;

  explicit Laid(const Mechanism& mechanism)
      : document(mechanism),
        part(drawnPart(document.placed())),
        train(*drawnTrain(part, document)),
        layout(sheetLayout(part, train.placement, train.wheels)) {}
};

SheetSlot slotAt(double place, double half, std::vector<int> axes = {0}) {
  SheetSlot slot;
  slot.place = slot.wanted = place;
  slot.spans = {{half, half, 0, 10}};
  slot.axes = std::move(axes);
  return slot;
}

double touchError(const RadialSystem& system, std::size_t contact) {
  const auto& c = system.contacts[contact];
  const auto& a = system.wheels[static_cast<std::size_t>(c.tail)];
  const auto& b = system.wheels[static_cast<std::size_t>(c.head)];
  const double apart = std::abs(system.heights[static_cast<std::size_t>(a.axis)] -
                                system.heights[static_cast<std::size_t>(b.axis)]);
  return apart - (c.internal ? std::abs(a.radius - b.radius) : a.radius + b.radius);
}

/// A box of link 1's lines, open on the left if asked for.
std::vector<LinkLine> box(bool open) {
  std::vector<LinkLine> lines{
      {{40, -40}, {40, 40}, 1, 0}, {{-40, -40}, {40, -40}, 1, 0}, {{-40, 40}, {40, 40}, 1, 0}};
  if (!open) lines.push_back({{-40, -40}, {-40, 40}, 1, 0});
  lines.push_back({{-5, 0}, {5, 0}, 2, 0});
  return lines;
}

}  // namespace

/// The steps of the drawing one by one.
class SchematicPartsTest : public QObject {
  Q_OBJECT
 private slots:
  void radiiThatFitStayAsTheyAre() {
    RadialSystem system;
    system.heights = {0, 50};
    system.wheels = {{0, 20}, {1, 30}};
    system.contacts = {{0, 1, false, true}};
    system.settle();
    QVERIFY(!system.changed);
    QCOMPARE(system.wheels[1].radius, 30.0);
  }

  void radiiGiveWaySoThatWheelsTouch() {  // Ravigneaux: suns, short and long planet, ring
    RadialSystem system;
    system.heights = {0, 50, 54};
    system.wheels = {{0, 30}, {1, 20}, {2, 18}, {0, 36}, {0, 72}};
    system.contacts = {{0, 1, false, true}, {1, 2, false, true}, {3, 2, false, true}, {2, 4, true, true}};
    system.settle();
    QVERIFY(system.changed);
    for (std::size_t c = 0; c < system.contacts.size(); ++c) {
      QVERIFY(system.contacts[c].kept);
      QVERIFY(std::abs(touchError(system, c)) < 1e-6);
    }
    QVERIFY(system.heights[0] < system.heights[1] && system.heights[1] < system.heights[2]);
  }

  void aRingOfWheelsIsCutOpen() {
    RadialSystem system;
    system.heights = {0, 42, -42};
    system.wheels = {{0, 21}, {1, 21}, {2, 21}};
    system.contacts = {{0, 1, false, true}, {1, 2, false, true}, {2, 0, false, true}};
    system.settle();
    QVERIFY(!system.changed);
    QVERIFY(system.contacts[0].kept && system.contacts[2].kept && !system.contacts[1].kept);
  }

  void armsGoRoundOtherLinks() {
    ArmRouter router(box(true), {{100, 0}});
    const auto course = router.route(2, {}, {{100, 0}});
    QVERIFY(course.has_value());
    QCOMPARE(course->crossings, 0);
    QVERIFY(course->points.size() > 2);
    QCOMPARE(course->points.back(), (CanvasPoint{100, 0}));
  }

  void armsCrossOnlyWhereThereIsNoWayRound() {
    ArmRouter router(box(false), {{100, 0}});
    const auto course = router.route(2, {}, {{100, 0}});
    QVERIFY(course.has_value());
    QCOMPARE(course->crossings, 1);
  }

  void armsBeginWhereTheyAreGivenAPlace() {
    const std::vector<LinkLine> lines{{{0, 0}, {40, 0}, 3, 0}};
    ArmRouter router(lines, {{100, 20}, {10, 6}});
    const auto course = router.route(3, {{{10, 6}, {10, 6}, 3, 0}}, {{100, 20}});
    QVERIFY(course.has_value());
    QCOMPARE(course->points.front(), (CanvasPoint{10, 6}));
    QCOMPARE(router.route(3, {}, {{100, 20}})->length, 0.0);  // from the course before
  }

  void armsDoNotBeginWhereNothingHolds() {
    std::vector<LinkLine> lines{{{0, 0}, {10, 0}, 3, -1}};
    ArmRouter router(lines, {{50, 0}});
    QVERIFY(!router.route(3, {}, {{50, 0}}).has_value());
  }

  void armsEndWhereWayAndPriceTogetherAreLeast() {
    const std::vector<LinkLine> lines{{{0, 0}, {10, 0}, 3, 0}};
    const std::vector<CanvasPoint> ends{{200, 0}, {100, 0}};
    const auto ended = [&](const std::vector<double>& prices) {
      return ArmRouter(lines, ends).route(3, {}, ends, prices)->target;
    };
    QCOMPARE(ended({}), std::size_t{1});
    QCOMPARE(ended({5, 50}), std::size_t{1});
    QCOMPARE(ended({5, 150}), std::size_t{0});  // 195 against 240
  }

  void axesInOnePlaneLieAsInSpace() {
    const Laid laid(test::example("robot"));
    QVERIFY(!laid.layout.parallel);
    for (const SheetAxis& axis : laid.layout.axes) {
      QVERIFY(!axis.turned);
      // y to the right, z up: the paper's Figs. 1 and 3.
      QVERIFY(std::abs(axis.along.x - axis.direction[1]) < 1e-9);
      QVERIFY(std::abs(axis.along.y + axis.direction[2]) < 1e-9);
    }
    for (const SheetPair& pair : laid.layout.pairs) QVERIFY(!pair.apart);
  }

  void aPlanetaryTrainIsCutInHalf() {
    const Laid laid(test::example("planetary-ring-held"));
    QVERIFY(laid.layout.parallel && laid.layout.axes[0].half && !laid.layout.axes[1].half);
    QVERIFY(laid.layout.axes[1].origin.y < laid.layout.axes[0].origin.y);
    const Laid pair(test::example("spur-pair"));
    QVERIFY(!pair.layout.axes[0].half && !pair.layout.axes[1].half);
  }

  void slotsArePackedInTheirOrder() {
    std::vector<SheetSlot> row{slotAt(-500, 9), slotAt(0, 9), slotAt(0.1, 9)};
    packSlots(row);
    QCOMPARE(row[1].at - row[0].at, 29.0);
    QCOMPARE(row[2].at - row[1].at, 29.0);
    row = {slotAt(0, 9), slotAt(1, 9), slotAt(2, 9)};
    row[1].spans = {{9, 9, 100, 110}};  // passes above
    packSlots(row);
    QVERIFY(row[0].at < row[1].at && row[1].at < row[2].at);
    QCOMPARE(row[2].at - row[0].at, 29.0);
  }

  void slotsMakeRoomBesideFixedOnes() {
    std::vector<SheetSlot> row{slotAt(-3, 9), slotAt(0, 2), slotAt(5, 9), slotAt(200, 9)};
    row[1].fixed = 0;
    spreadSlots(row);
    QCOMPARE(row[0].at, -22.0);
    QCOMPARE(row[1].at, 0.0);
    QCOMPARE(row[2].at, 22.0);
    QCOMPARE(row[3].at, 200.0);
  }

  void slotsStayInOrderWhereFixedOnesLeaveNoRoom() {
    std::vector<SheetSlot> row{slotAt(0, 2), slotAt(1, 9), slotAt(2, 9), slotAt(3, 2)};
    row[0].fixed = 0;
    row[3].fixed = 3;
    spreadSlots(row);
    for (std::size_t i = 1; i < row.size(); ++i) QVERIFY(row[i - 1].at < row[i].at);
    QCOMPARE(row[3].at, 3.0);
  }

  void drumsJoinWhatTheProfileRouterJoins() {
    Laid laid(test::example("simpson"));
    const ShaftPlan plan = shaftPlan(laid.part, laid.train, laid.layout);
    QCOMPARE(plan.shaft(0, 3, 0), nullptr);  // the first set's carrier and the second's ring: a drum
    double low = 1e300, high = -1e300;
    for (const SheetWall& wall : plan.walls) {
      if (wall.link != 3) continue;
      low = std::min(low, wall.from.x);
      high = std::max(high, wall.to.x);
    }
    const SheetBearing& bearing = plan.bearings[2];
    QCOMPARE(bearing.child, 3);
    QVERIFY(low < bearing.at && bearing.at < high && bearing.height > 0);
    const auto ring = std::find_if(laid.layout.wheels.begin(), laid.layout.wheels.end(),
                                   [](const SheetWheel& wheel) { return wheel.link == 3; });
    QCOMPARE(high, ring->at);
    const auto atRim = std::find_if(plan.walls.begin(), plan.walls.end(), [&](const SheetWall& wall) {
      return wall.link == 3 && wall.to == CanvasPoint{ring->at, ring->radius + kRimHeight};
    });
    QVERIFY(atRim != plan.walls.end());
    const SheetBearing& planet = plan.bearings[4];
    QVERIFY(planet.onPin && planet.parent == 3);
    QVERIFY(plan.shaft(planet.axis, 3, planet.at)->lane <
            plan.shaft(planet.axis, planet.child, planet.at)->lane);
  }

  void shaftsOnOneAxisAreNested() {
    Laid laid(test::example("ferguson-paradox"));
    const ShaftPlan plan = shaftPlan(laid.part, laid.train, laid.layout);
    const auto lane = [&](int link) { return plan.shaft(0, link, 0)->lane; };
    QCOMPARE(lane(5), 0);
    QCOMPARE(lane(4), 1);
    QCOMPARE(lane(3), 2);
    QCOMPARE(lane(0), 3);
  }

  void armsInOnePlaneDoNotCoverBearings() {
    Laid laid(test::example("ravigneaux"));  // one carrier, planets on two axes
    const ShaftPlan plan = shaftPlan(laid.part, laid.train, laid.layout);
    QCOMPARE(plan.arms.size(), std::size_t{2});
    const SheetShaft* nearer = plan.shaft(plan.bearings[4].axis, plan.bearings[4].child, plan.bearings[4].at);
    QVERIFY(plan.bearings[5].at > nearer->high);
  }

  void equalPlanetsNeedTheSameWheelsAndCarrier() {
    QCOMPARE(drawnPart(test::example("redundant-planetary")).planets.at(0).count, 5);
    QVERIFY(drawnPart(test::example("ravigneaux")).planets.empty());
    QVERIFY(drawnPart(test::example("simpson")).planets.empty());
    Mechanism mechanism = test::example("three-planets");
    mechanism.gearMeshes[2].headTeeth = 17;
    QCOMPARE(drawnPart(mechanism).planets.at(0).count, 2);
  }

  void labelsAreThoseOfTheWholeMechanism() {
    const DrawnPart part = drawnPart(test::example("three-planets"));
    QCOMPARE(part.linkLabels, (std::vector<int>{0, 1, 2, 3}));
    QCOMPARE(part.jointLabels, (std::vector<int>{6, 7, 8}));
    QCOMPARE(part.meshLabels, (std::vector<int>{11, 12}));
    QCOMPARE(part.mechanism.axes.size(), std::size_t{2});
  }
};

QTEST_APPLESS_MAIN(SchematicPartsTest)
#include "test_schematic_parts.moc"

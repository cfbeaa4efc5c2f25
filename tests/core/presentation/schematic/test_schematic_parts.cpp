#include <QtTest>

#include "core/machine/bodies/derived_geometry.h"
#include "core/presentation/schematic/arm_router.h"
#include "core/presentation/schematic/drawn_part.h"
#include "core/presentation/schematic/radial_system.h"
#include "core/presentation/schematic/stacker.h"
#include "tests/core/support/example_files.h"
#include "tests/core/support/train_sketch.h"

using namespace geargraph;

namespace {

struct Laid {
  DrawnPart part;
  DerivedGeometry geometry;
  const Placement& placement;
  SheetLayout layout;

  explicit Laid(const Mechanism& mechanism)
      : part(drawnPart(mechanism)),
        geometry(part.mechanism),
        placement(geometry.placement()),
        layout(sheetLayout(part, placement, *geometry.wheels())) {}
};

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
class TestSchematicParts : public QObject {
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
    const auto course = router.route(2, {{100, 0}});
    QVERIFY(course.has_value());
    QCOMPARE(course->crossings, 0);
    QVERIFY(course->points.size() > 2);
    QCOMPARE(course->points.back(), (SheetPoint{100, 0}));
  }

  void armsCrossOnlyWhereThereIsNoWayRound() {
    ArmRouter router(box(false), {{100, 0}});
    const auto course = router.route(2, {{100, 0}});
    QVERIFY(course.has_value());
    QCOMPARE(course->crossings, 1);
  }

  void armsDoNotBeginWhereNothingHolds() {
    std::vector<LinkLine> lines{{{0, 0}, {10, 0}, 3, -1}};
    ArmRouter router(lines, {{50, 0}});
    QVERIFY(!router.route(3, {{50, 0}}).has_value());
  }

  void armsEndWhereWayAndPriceTogetherAreLeast() {
    const std::vector<LinkLine> lines{{{0, 0}, {10, 0}, 3, 0}};
    const std::vector<SheetPoint> ends{{200, 0}, {100, 0}};
    const auto ended = [&](const std::vector<double>& prices) {
      return ArmRouter(lines, ends).route(3, ends, prices)->target;
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

  void shaftsOnOneAxisAreNested() {
    Laid laid(test::example("simpson"));
    Stacker stacker(laid.part, laid.placement, laid.layout);
    stacker.search();
    stacker.squeeze();
    const ShaftPlan plan = stacker.plan();
    const SheetShaft* suns = plan.shaft(0, 1);
    const SheetShaft* ring = plan.shaft(0, 2);
    const SheetShaft* output = plan.shaft(0, 3);
    QVERIFY(suns != nullptr && ring != nullptr && output != nullptr);
    QCOMPARE(suns->lane, 0);
    QCOMPARE(ring->lane, 1);
    QCOMPARE(output->lane, 1);
    QVERIFY(suns->low < ring->low && output->high < suns->high);
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

QTEST_APPLESS_MAIN(TestSchematicParts)
#include "test_schematic_parts.moc"

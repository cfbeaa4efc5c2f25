#include <QTest>

#include "core/mechanism/geometry_edits/axis_drag.h"
#include "core/mechanism/geometry_edits/fitted_edits.h"
#include "core/mechanism/geometry_edits/module_fit.h"
#include "core/mechanism/model/pins.h"
#include "tests/core/mechanism/geometry_edits/fitted_trains.h"
#include "tests/core/support/example_files.h"
#include "tests/core/support/mechanisms.h"

using namespace geargraph;
using namespace geargraph::test;

namespace {

/// Only the graph and the teeth.
Mechanism withoutPlaces(Mechanism mechanism) {
  for (Axis& axis : mechanism.axes) axis.point.reset();
  for (GearMesh& mesh : mechanism.gearMeshes) mesh.pitchPoint.reset();
  return mechanism;
}

std::vector<double> modulesOf(const Mechanism& mechanism) {
  std::vector<double> modules;
  for (int m = 0; m < mechanism.c(); ++m) modules.push_back(test::moduleOf(mechanism, m));
  return modules;
}

bool areAll(const std::vector<double>& values, double wanted) {
  return std::all_of(values.begin(), values.end(),
                     [wanted](double value) { return std::abs(value - wanted) < 1e-9 * wanted; });
}

std::vector<std::pair<int, int>> teethOf(const Mechanism& mechanism) {
  std::vector<std::pair<int, int>> teeth;
  for (const GearMesh& mesh : mechanism.gearMeshes) teeth.emplace_back(mesh.tailTeeth, mesh.headTeeth);
  return teeth;
}

/// A shaft with 20 that drives a countershaft's 40, whose 25 drives 35 on the shaft's axis: both at module 2.
Mechanism reverted() {
  TrainBuilder train("reverted");
  const int a = train.axis({0, 0, 0}, {0, 0, 1});
  const int b = train.axis({60, 0, 0}, {0, 0, 1});
  const int in = train.link(0, a), counter = train.link(0, b), out = train.link(0, a);
  train.external(in, a, 20, counter, b, 40);
  train.external(counter, b, 25, out, a, 35);
  return train.mechanism();
}

}  // namespace

/// Modules that are typed, and modules that are pinned.
class ModuleTest : public QObject {
  Q_OBJECT

 private slots:
  void aTypedModuleMovesTheAxesOfAllThatMeshWithIt() {
    const Mechanism before = statedPlanetary(3);
    const Mechanism after = *withModule(before, mesh(before, 3).id, Rational(5, 2));
    QVERIFY(areAll(modulesOf(after), 2.5));
    QVERIFY(misfit(after) < 1e-9);
    QCOMPARE(teethOf(after), teethOf(before));
    for (int planet = 0; planet < 3; ++planet) QCOMPARE(distanceOfAxis(after, 1 + planet), 52.5);
  }

  void aTrainThatTheProgramPlacedTakesAModule() {
    for (const Mechanism& before : {planetary(24, 18, 3), withoutPlaces(reverted())}) {
      const Mechanism after = *withModule(before, mesh(before, 0).id, 3);
      QVERIFY(areAll(modulesOf(after), 3));
      QVERIFY(misfit(after) < 1e-9);
    }
  }

  void bothPairsOfOneDistanceFollow() {
    const Mechanism after = *withModule(reverted(), mesh(reverted(), 1).id, 3);
    QVERIFY(areAll(modulesOf(after), 3));
    QCOMPARE(distanceOfAxis(after, 1), 90.0);
  }

  void bevelsGrowAboutTheirApex() {
    const Mechanism before = example("bevel-differential");
    const Mechanism after = *withModule(before, mesh(before, 0).id, 4);
    QVERIFY(after.c() > 1 && !areAll(modulesOf(before), 4));
    QVERIFY(misfit(after) < 1e-9);
    QVERIFY(std::abs(test::moduleOf(after, 0) - 4) < 1e-9);
    QCOMPARE(after.axes, before.axes);
    QCOMPARE(teethOf(after), teethOf(before));
  }

  void wheelsOfAnotherPairKeepTheirs() {
    TrainBuilder train("two modules");
    const int a = train.axis({0, 0, 0}, {0, 0, 1});
    const int b = train.axis({60, 0, 0}, {0, 0, 1});
    const int c = train.axis({60, 100, 0}, {0, 0, 1});
    const int in = train.link(0, a), counter = train.link(0, b);
    train.external(in, a, 20, counter, b, 40);
    train.external(counter, b, 15, train.link(0, c), c, 35);
    const Mechanism after = *withModule(train.mechanism(), mesh(train.mechanism(), 0).id, 3);
    QCOMPARE(modulesOf(after), (std::vector<double>{3, 4}));
    QVERIFY(misfit(after) < 1e-9);
  }

  void aPinnedModuleRejectsWhatWouldChangeIt() {
    const Mechanism before = statedPlanetary(3);
    const ElementId pinned = mesh(before, 0).id;
    const Mechanism held = pin(before, pinned);
    QVERIFY(isPinned(mesh(held, 0)) && !isPinned(mesh(held, 1)));
    for (const auto& rejected :
         {withAxisMoved(held, held.axes[1].id, at(50, 0, 0)), withModule(held, mesh(held, 1).id, 3)}) {
      QVERIFY(!rejected);
      QCOMPARE(rejected.error()[0].code, Code::teethGeometry);
      QVERIFY(blames(rejected.error()[0], pinned));
    }
    QVERIFY(withAxisMoved(before, held.axes[1].id, at(50, 0, 0)));
    QVERIFY(withModule(held, mesh(held, 1).id, 2));  // as it is
    const auto offers = teethNear(held, held.axes[1].id, 44);
    QVERIFY(!offers.empty());  // what can be had with this module
    QCOMPARE(*withPinned(held, pinned, false), before);
  }

  void manyArePinnedAsOneByOne() {
    const Mechanism open = test::robotTopology();  // whose axes the program places
    std::vector<ElementId> parts;
    for (const GearMesh& each : open.gearMeshes) parts.emplace_back(each.id);
    for (const Link& each : open.links) parts.emplace_back(each.id);
    Mechanism one = open;
    for (const ElementId& part : parts) one = *withPinned(one, part, true);
    const auto all = withAllPinned(open, parts, true);
    QVERIFY(all && *all == one);
    QVERIFY(std::all_of(one.axes.begin(), one.axes.end(),
                        [](const Axis& axis) { return axis.point.has_value(); }));
    parts.emplace_back(MeshId("none"));
    QVERIFY(!withAllPinned(open, parts, true));
  }

  void teethAreChosenSoThatAPinnedModuleStays() {
    const Mechanism before = reverted();
    for (const int other : {0, 1}) {
      const Mechanism held = pin(before, mesh(before, 1 - other).id);
      const Mechanism after = *withTeethFitted(held, mesh(before, other).id, 24, 41);
      QVERIFY(std::abs(test::moduleOf(after, 1 - other) - 2) < 1e-9);
      QVERIFY(misfit(after) < 1e-9);
    }
  }

  void thePinnedModuleOfSeveralSaysTheDistance() {
    // Three of four meshes of one pair of axes have modules of their own (Ferguson's paradox).
    const Mechanism before = example("ferguson-paradox");
    for (int m = 0; m < before.c(); ++m) {
      const double was = test::moduleOf(before, m);
      const auto after = withTeethFitted(pin(before, mesh(before, m).id), mesh(before, m).id,
                                         mesh(before, m).tailTeeth + 3, mesh(before, m).headTeeth);
      QVERIFY(after);
      QVERIFY(std::abs(test::moduleOf(*after, m) - was) < 1e-6 * was);  // the file has eight digits
    }
  }

  void pinningAMeshStatesWhereItsAxesLie() {
    const Mechanism before = planetary(24, 18, 1);
    const Mechanism held = pin(before, mesh(before, 0).id);
    QVERIFY(held.axes[0].point && held.axes[1].point);
    QCOMPARE(distanceOfAxis(held, 1), 42.0);
  }

  void aTrainWithoutGeometrySaysWhyItTakesNoModule() {
    Mechanism looped = reverted();
    looped.turningJoints.push_back(looped.turningJoints.back());
    looped.turningJoints.back().id = JointId("again");
    const auto rejected = withModule(looped, mesh(looped, 0).id, 2);
    QVERIFY(!rejected);
    QCOMPARE(rejected.error()[0].code, Code::teethGeometry);
    QCOMPARE(withModule(reverted(), mesh(looped, 0).id, 0).error()[0].code, Code::teethGeometry);
    QCOMPARE(withModule(looped, MeshId("none"), 2).error()[0].code, Code::unknownId);
  }
};

QTEST_APPLESS_MAIN(ModuleTest)
#include "test_module.moc"

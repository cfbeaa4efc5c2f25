#include <QTest>

#include "core/machine/body_layout/body_recipe.h"
#include "core/machine/body_layout/complete_train.h"
#include "core/machine/body_layout/derived_geometry.h"
#include "core/machine/train/train_wheels.h"
#include "tests/core/support/example_files.h"
#include "tests/core/support/train_sketch.h"
#include "tests/core/support/trains.h"

namespace geargraph {

class DerivedGeometryTest : public QObject {
  Q_OBJECT

 private slots:
  void partsAreComputedOnDemandAndKept() {
    for (const std::string& name : test::exampleNames()) {
      const DerivedGeometry geometry(test::example(name));
      const auto train = geometry.train();
      const auto diagnostics = geometry.diagnostics();
      QCOMPARE(geometry.train(), train);
      QCOMPARE(geometry.diagnostics(), diagnostics);
      QCOMPARE(geometry.wheels(), geometry.wheels());
      QCOMPARE(&geometry.placement(), &geometry.placed().placement());
      const GearTrain alone = trainOf(geometry.mechanism(), geometry.placement());
      QCOMPARE(train->gears.size(), alone.gears.size());
      QCOMPARE(geometry.wheels()->wheels.size(), alone.gears.size());
      for (std::size_t g = 0; g < alone.gears.size(); ++g) {
        QCOMPARE(train->gears[g].spec, alone.gears[g].spec);
        QVERIFY(train->gears[g].pose.matrix() == alone.gears[g].pose.matrix());
      }
      QCOMPARE(train->bodies.size(), alone.bodies.size());
      for (std::size_t b = 0; b < alone.bodies.size(); ++b)
        QVERIFY(*train->bodies[b].recipe == *alone.bodies[b].recipe);
      QVERIFY(*diagnostics == trainDiagnostics(geometry.mechanism(), geometry.placement()));
    }
  }

  void cancelledRequestLeavesNothingHalfComputed() {
    std::stop_source stop;
    stop.request_stop();
    const DerivedGeometry geometry(test::example("eight-speed-gearbox"));
    QVERIFY(geometry.diagnostics(stop.get_token()) == nullptr);
    QVERIFY(geometry.train(stop.get_token()) == nullptr);
    QVERIFY(geometry.wheels(stop.get_token()) == nullptr);
    const GearTrain whole = trainOf(geometry.mechanism(), geometry.placement());
    QCOMPARE(geometry.train()->bodies.size(), whole.bodies.size());
    QVERIFY(geometry.train(stop.get_token()) != nullptr);  // what is there needs no time
  }

  void mechanismWithoutATreeHasNoTrain() {
    test::TrainSketch sketch(2);
    sketch.joint(0, 1, "a").mesh(1, 2, 20, 40);
    const DerivedGeometry geometry(sketch.build());
    QVERIFY(geometry.train()->gears.empty());
    QVERIFY(geometry.wheels()->wheels.empty());
    QVERIFY(geometry.diagnostics()->empty());
  }

  /// Far from the document's origin, where doubles lose the digits of teeth, the train is that of the same
  /// mechanism near it: in its specs, its diagnostics and, but for where it is, its poses and bodies.
  void placeOfATrainChangesNothingElse() {
    int trains = 0;
    for (const char* name : {"robot", "three-planets", "cannot-be-assembled", "eight-speed-gearbox"}) {
      const Mechanism mechanism = test::example(name);
      const DerivedGeometry near(mechanism);
      const DerivedGeometry far(
          test::moved(mechanism, test::rotation(1, 0, 0, 0), {Rational(1'000'000'000'000), 0, 0}));
      QCOMPARE(far.train()->gears.size(), near.train()->gears.size());
      const Eigen::Vector3d by =
          far.train()->gears[0].pose.translation() - near.train()->gears[0].pose.translation();
      QVERIFY(std::abs(by.x() / 1e12 - 1) < 1e-9);
      for (std::size_t g = 0; g < near.train()->gears.size(); ++g) {
        const TrainGear& one = near.train()->gears[g];
        const TrainGear& other = far.train()->gears[g];
        QCOMPARE(other.name, one.name);
        QVERIFY(std::abs(other.spec.faceWidth - one.spec.faceWidth) < 1e-9);
        QVERIFY(std::abs(other.spec.profileShift - one.spec.profileShift) < 1e-9);
        QVERIFY(std::abs(other.spec.bore - one.spec.bore) < 1e-6);
        QVERIFY((other.pose.linear() - one.pose.linear()).norm() < 1e-9);
        QVERIFY((other.pose.translation() - one.pose.translation() - by).norm() < 1e-3);
      }
      QCOMPARE(far.train()->bodies.size(), near.train()->bodies.size());
      QCOMPARE(far.diagnostics()->size(), near.diagnostics()->size());
      for (std::size_t d = 0; d < near.diagnostics()->size(); ++d) {
        QCOMPARE((*far.diagnostics())[d].detail, (*near.diagnostics())[d].detail);
        QVERIFY((*far.diagnostics())[d].elements == (*near.diagnostics())[d].elements);
      }
      ++trains;
    }
    QCOMPARE(trains, 4);
  }
};

}  // namespace geargraph

QTEST_APPLESS_MAIN(geargraph::DerivedGeometryTest)
#include "test_derived_geometry.moc"

#include <QTest>
#include <array>
#include <atomic>
#include <barrier>
#include <thread>

#include "core/machine/body_layout/arrangement.h"
#include "core/machine/body_layout/derived_geometry.h"
#include "core/machine/train/train_wheels.h"
#include "core/mechanism/geometry_edits/axis_drag.h"
#include "core/mechanism/geometry_edits/fitted_edits.h"
#include "tests/core/support/example_files.h"

// The linker redirects the calls of these functions to this file (--wrap, see CMakeLists.txt): they are
// counted without a hook in the program. Their names are those of the Itanium C++ ABI.

namespace geargraph {
namespace {

std::atomic<int> placements, shapings, plans;

}  // namespace

Placement countedPlacement(const Mechanism& mechanism) asm(
    "__wrap__ZN9geargraph11placementOfERKNS_9MechanismE");
Placement realPlacement(const Mechanism& mechanism) asm("__real__ZN9geargraph11placementOfERKNS_9MechanismE");
Placement countedPlacement(const Mechanism& mechanism) {
  ++placements;
  return realPlacement(mechanism);
}

Placement countedPlacement(const Mechanism& mechanism, std::optional<JointTree> tree) asm(
    "__wrap__ZN9geargraph11placementOfERKNS_9MechanismESt8optionalINS_9JointTreeEE");
Placement realPlacement(const Mechanism& mechanism, std::optional<JointTree> tree) asm(
    "__real__ZN9geargraph11placementOfERKNS_9MechanismESt8optionalINS_9JointTreeEE");
Placement countedPlacement(const Mechanism& mechanism, std::optional<JointTree> tree) {
  ++placements;
  return realPlacement(mechanism, std::move(tree));
}

void countedShaping(const Mechanism& mechanism, TrainWheels& train, const std::stop_token& stop) asm(
    "__wrap__ZN9geargraph11shapeWheelsERKNS_9MechanismERNS_11TrainWheelsERKSt10stop_token");
void realShaping(const Mechanism& mechanism, TrainWheels& train, const std::stop_token& stop) asm(
    "__real__ZN9geargraph11shapeWheelsERKNS_9MechanismERNS_11TrainWheelsERKSt10stop_token");
void countedShaping(const Mechanism& mechanism, TrainWheels& train, const std::stop_token& stop) {
  ++shapings;
  realShaping(mechanism, train, stop);
}

Arrangement
countedPlan(const Mechanism& mechanism, const Placement& placement, const GearTrain& train, const std::stop_token& stop) asm(
    "__wrap__ZN9geargraph13arrangementOfERKNS_9MechanismERKNS_9PlacementERKNS_9GearTrainERKSt10stop_token");
Arrangement
realPlan(const Mechanism& mechanism, const Placement& placement, const GearTrain& train, const std::stop_token& stop) asm(
    "__real__ZN9geargraph13arrangementOfERKNS_9MechanismERKNS_9PlacementERKNS_9GearTrainERKSt10stop_token");
Arrangement countedPlan(const Mechanism& mechanism, const Placement& placement, const GearTrain& train,
                        const std::stop_token& stop) {
  ++plans;
  return realPlan(mechanism, placement, train, stop);
}

/// How often the geometry of a document is computed for an edit and for all that reads the result.
class GeometryCountsTest : public QObject {
  Q_OBJECT

  using Counts = std::array<int, 3>;  ///< placements, shapings of wheels, plans of bodies

  /// What analysis, 3D view, motion check, schematic and forms ask for, at the same time.
  static void readAll(const PlacedMechanism& document) {
    const DerivedGeometry geometry(document);
    constexpr int kReaders = 5;
    std::barrier together(kReaders);
    const auto run = [&](const auto& read) {
      return std::jthread([&, read] {
        together.arrive_and_wait();
        read();
      });
    };
    const std::jthread view3d = run([&] { static_cast<void>(geometry.train()); });
    const std::jthread diagnostics = run([&] { static_cast<void>(geometry.diagnostics()); });
    const std::jthread motion = run([&] { static_cast<void>(geometry.train()->bodies.size()); });
    const std::jthread schematic = run([&] { static_cast<void>(geometry.wheels()); });
    const std::jthread form = run([&] { static_cast<void>(document.placement()); });
  }
  template <class Work>
  static Counts countsOf(const Work& work) {
    placements = shapings = plans = 0;
    work();
    return {placements, shapings, plans};
  }

 private slots:
  void everyEditComputesGeometryOnce_data() {
    QTest::addColumn<QString>("example");
    for (const char* name : {"robot", "eight-speed-gearbox", "simpson", "three-planets"})
      QTest::newRow(name) << name;
  }
  void everyEditComputesGeometryOnce() {
    QFETCH(const QString, example);
    PlacedMechanism document = test::example(example.toStdString());
    const MeshId mesh = document.mechanism().gearMeshes.front().id;
    readAll(document);
    for (int step = 0; step < 3; ++step) {
      const Counts counts = countsOf([&] {
        const GearMesh& now = *document.mechanism().find(mesh);
        const auto edited = withTeethFitted(document, mesh, now.tailTeeth, now.headTeeth + 1);
        QVERIFY(edited);
        document = *edited;
        readAll(document);
      });
      QCOMPARE(counts, (Counts{1, 1, 1}));
    }
  }

  /// The place of an axis is read three times a step beside the edit.
  void stepOfAnAxisDragPlacesTheDocumentOnce() {
    const PlacedMechanism before = test::example("spur-pair");
    const AxisId axis = before.mechanism().axes[1].id;
    QVERIFY(axisReach(before, axis));
    for (int step = 1; step <= 5; ++step) {
      const Counts counts = countsOf([&] {
        const auto moved = withAxisReach(before, axis, Rational(20 + step, 20));
        QVERIFY(moved);
        QVERIFY(axisReach(*moved, axis)->distance > axisReach(before, axis)->distance);
        QVERIFY(moved->placement().diagnostics.empty());
      });
      QCOMPARE(counts, (Counts{1, 0, 0}));
    }
  }
};

}  // namespace geargraph

QTEST_GUILESS_MAIN(geargraph::GeometryCountsTest)
#include "test_geometry_counts.moc"

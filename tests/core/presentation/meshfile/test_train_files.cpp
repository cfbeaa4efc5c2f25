#include <QTest>
#include <numbers>

#include "core/machine/body_layout/complete_train.h"
#include "core/mechanism/document_format/mechanism_file.h"
#include "core/presentation/mechanism_scene/mechanism_scene.h"
#include "core/presentation/meshfile/train_files.h"
#include "core/theory/matroid/exact_solution.h"
#include "core/theory/matroid/matroid_analysis.h"
#include "tests/core/presentation/meshfile/assembly_check.h"
#include "tests/core/presentation/meshfile/cogs.h"
#include "tests/core/support/example_files.h"

using namespace geargraph;
using namespace geargraph::test;

namespace {

MechanismScenePtr stageOf(const Mechanism& mechanism, GearCache& cache) {
  return mechanismScene(*analyzeLive(std::make_shared<const Mechanism>(mechanism)), cache);
}

/// An example of the program with its gears and the rates of its joints.
struct Example {
  Mechanism mechanism;
  DigraphPtr graph;
  SpanningTreePtr tree;
  Placement placement;
  GearTrain train;
  std::vector<Rational> rates;                 ///< at the document's speeds
  std::vector<std::vector<Rational>> motions;  ///< these, and others that move more meshes

  explicit Example(const std::string& name) : Example(test::example(name)) {}
  explicit Example(Mechanism document) : mechanism(std::move(document)) {
    graph = std::make_shared<const Digraph>(mechanism);
    tree = std::make_shared<const SpanningTree>(SpanningTree::of(*graph).value());
    placement = placementOf(mechanism);
    train = trainOf(mechanism, placement);
    const auto model = KinematicModel::of(graph, tree, placement);
    const auto analysis = analyzeMatroid(mechanism, *model, placement);
    rates = solveExact(*model, analysis->choice.joints, analysis->speeds)->rates;
    const auto generic = genericSpeeds(analysis->choice.joints.size());
    motions = {rates, solveExact(*model, analysis->choice.joints, generic)->rates};
  }

  [[nodiscard]] PlacedTrain placed() const { return {mechanism, *tree, placement, train}; }
  [[nodiscard]] Assembly assembly(const std::vector<Rational>& motion) const {
    return assembly(std::span(&motion, 1));
  }
  [[nodiscard]] Assembly assembly(std::span<const std::vector<Rational>> choice) const {
    GearCache cache;
    return assemblyOf(placed(), cache, kExportTolerance, choice, kMinFrames).value();
  }
};

/// Two wheels on the ground that mesh. `second` is the second axis: automatic where it is empty.
Mechanism pairOf(int tailTeeth, int headTeeth, const std::string& kind, const std::string& second) {
  const std::string text =
      R"({"format": "geargraph", "version": 1, "links": [{"id": "0"}, {"id": "1"}, {"id": "2"}],
    "axes": [{"id": "a", "point": [0, 0, 0], "direction": [0, 0, 1]}, {"id": "b")" +
      second + R"(}],
    "turningJoints": [{"id": "3", "tail": "0", "head": "1", "axis": "a"}, {"id": "4", "tail": "0", "head": "2",
    "axis": "b"}], "inputs": [{"joint": "3", "speed": 1}],
    "gearMeshes": [{"id": "5", "tail": "1", "head": "2", "kind": ")" +
      kind + "\", \"tailTeeth\": " + std::to_string(tailTeeth) +
      ", \"headTeeth\": " + std::to_string(headTeeth) + "}]}";
  return readMechanism(text).value();
}

AssemblyMeasurements measured(const Assembly& assembly, const QString& turned = {}, double pitches = 0) {
  const QTemporaryDir folder;
  if (const auto error = writeAssembly(assembly, folder.path().toStdString(), false)) {
    qFatal("%s", error->message.c_str());
  }
  return checkedAssembly(folder.path(), turned, pitches);
}

}  // namespace

class TrainFilesTest : public QObject {
  Q_OBJECT
 private slots:
  void teethMeshInTheFramesOfTheMotion_data() {
    QTest::addColumn<QString>("name");
    for (const char* name :
         {"robot", "spur-pair", "three-planets", "planetary-ring-held", "bevel-differential", "bevel-wrist",
          "humpage-reduction", "ferguson-paradox", "ravigneaux", "simpson", "redundant-planetary"}) {
      QTest::newRow(name) << name;
    }
  }
  void teethMeshInTheFramesOfTheMotion() {
    QFETCH(QString, name);
    const Example example(name.toStdString());
    const AssemblyMeasurements found = measured(example.assembly(example.motions));
    QCOMPARE(found.problem, QString());
    QCOMPARE(found.pairs, example.mechanism.c());
    QCOMPARE(found.gears, int(example.train.gears.size()));
    QVERIFY(found.frames >= 12 && found.closed);
    QVERIFY2(found.leastTravel > 1, qPrintable(QString::number(found.leastTravel)));
    QVERIFY2(found.phaseError < 0.005, qPrintable(QString::number(found.phaseError)));
    QVERIFY2(found.penetration < 0.004, qPrintable(QString::number(found.penetration)));
  }

  void teethOfDifficultPairsMesh_data() {
    QTest::addColumn<int>("tail");
    QTest::addColumn<int>("head");
    QTest::addColumn<QString>("kind");
    QTest::addColumn<QString>("second");
    QTest::newRow("8-tooth pinion") << 8 << 40 << "external"
                                    << "";
    QTest::newRow("shifted apart: 18 and 36 teeth, 55.5 for 54")
        << 18 << 36 << "external"
        << R"(, "point": [55.5, 0, 0], "direction": [0, 0, 1])";
    QTest::newRow("ring 60, pinion 20") << 20 << 60 << "internal"
                                        << "";
    QTest::newRow("ring 60, pinion 52") << 52 << 60 << "internal"
                                        << "";
    const QString meeting = R"(, "point": [0, 0, 0], "direction": [%1, 0, %2])";
    QTest::newRow("bevels, 90 degrees") << 17 << 29 << "bevel" << meeting.arg(1).arg(0);
    QTest::newRow("bevels, 60 degrees")
        << 16 << 31 << "bevel" << meeting.arg(std::sqrt(3) / 2, 0, 'g', 17).arg(0.5);
    QTest::newRow("bevels, 120 degrees")
        << 16 << 31 << "bevel" << meeting.arg(std::sqrt(3) / 2, 0, 'g', 17).arg(-0.5);
  }
  void teethOfDifficultPairsMesh() {
    QFETCH(int, tail);
    QFETCH(int, head);
    QFETCH(QString, kind);
    QFETCH(QString, second);
    const Example example(pairOf(tail, head, kind.toStdString(), second.toStdString()));
    const AssemblyMeasurements found = measured(example.assembly(example.motions));
    QCOMPARE(found.pairs, 1);
    QVERIFY(found.closed && found.leastTravel > 1);
    QVERIFY2(found.phaseError < 0.005, qPrintable(QString::number(found.phaseError)));
    QVERIFY2(found.penetration < 0.004, qPrintable(QString::number(found.penetration)));
  }

  void aLoopThatCannotBeAssembledMissesByWhatTheTrainSays() {
    const Example misfit(test::example("cannot-be-assembled"));  // three planets on 20, 20 and 60 teeth
    const AssemblyMeasurements found = measured(misfit.assembly(misfit.rates));
    double residual = 0;
    for (const TrainMesh& mesh : misfit.train.meshes) residual = std::max(residual, std::abs(mesh.residual));
    QVERIFY(residual > 0.1 && std::abs(found.phaseError - residual) < 1e-6);
  }

  void aTenthOfAPitchOrAWrongRateWouldBeSeen() {
    const Example robot("robot");
    const Assembly assembly = robot.assembly(robot.rates);
    QVERIFY(measured(assembly, QString::fromStdString(assembly.gears[3].name), 0.1).penetration > 0.05);
    std::vector<Rational> wrong = robot.rates;
    for (Rational& rate : wrong) {
      if (rate != robot.rates[0]) rate = -rate;
    }
    QVERIFY(measured(robot.assembly(wrong)).phaseError > 0.05);
  }

  void pitchesOfBothGearsOfAMeshPassAlike() {
    for (const char* name : {"robot", "three-planets", "humpage-reduction"}) {
      const Example example(name);
      const PlacedTrain placed = example.placed();
      GearTrain swapped = example.train;
      for (TrainMesh& mesh : swapped.meshes) std::swap(mesh.tailGear, mesh.headGear);
      const PlacedTrain other(example.mechanism, *example.tree, example.placement, swapped);
      const auto tails = pitchRates(placed, example.rates);
      const auto heads = pitchRates(other, example.rates);
      for (std::size_t i = 0; i < tails.size(); ++i) {
        QVERIFY(tails[i] != 0 && std::abs(std::abs(tails[i]) - std::abs(heads[i])) < 1e-12);
      }
    }
  }

  void theMotionThatMovesMostMeshesIsTaken() {
    const Example robot("robot");
    const std::vector<Rational> still(robot.rates.size());
    GearCache cache;
    const std::vector<std::vector<Rational>> motions{still, robot.rates, still};
    const auto assembly = assemblyOf(robot.placed(), cache, kExportTolerance, motions, kMinFrames);
    QVERIFY(assembly->frames.back()[0].isApprox(robot.assembly(robot.rates).frames.back()[0], 1e-12));
    const auto resting =
        assemblyOf(robot.placed(), cache, kExportTolerance, std::span(&still, 1), kMinFrames);
    QCOMPARE(resting->frames.size(), kMinFrames);
    QVERIFY(resting->frames.back()[0].isApprox(assembly->gears[0].pose, 1e-12));
  }

  void partsStandWhereTheTrainHasThem() {
    const Example robot("robot");
    GearCache cache;
    const TrainParts made = trainParts(robot.mechanism, robot.train, cache, kScreenTolerance);
    QVERIFY(made.diagnostics.empty());
    QCOMPARE(made.parts.size(), robot.train.gears.size() + robot.train.bodies.size());
    for (std::size_t i = 0; i < robot.train.gears.size(); ++i) {
      QCOMPARE(made.parts[i].name, robot.train.gears[i].name);
      QCOMPARE(made.parts[i].link, robot.train.gears[i].link);
      QVERIFY(made.parts[i].pose.isApprox(robot.train.gears[i].pose, 0));
    }
    for (const LinkPart& part : made.parts) {
      QVERIFY(signedVolume(*part.solid) > 0);
      const bool isGear = &part - made.parts.data() < std::ptrdiff_t(robot.train.gears.size());
      QVERIFY(isGear ? isClosed(welded(*part.solid)) : isBalanced(welded(*part.solid)));
    }
  }

  void framesAreThoseOfTheWindow() {
    const Example robot("robot");
    GearCache cache;
    const MechanismScenePtr stage = stageOf(robot.mechanism, cache);
    const Assembly assembly = robot.assembly(robot.rates);
    const auto times = frameTimes(pitchRates(robot.placed(), robot.rates), kMinFrames);
    for (std::size_t frame = 0; frame < times.size(); ++frame) {
      std::vector<double> angles;
      for (const double speed : stage->inputSpeeds) angles.push_back(speed * times[frame]);
      std::vector<Pose> poses(stage->scene.instances.size());
      stage->place(angles, poses);
      for (std::size_t gear = 0; gear < assembly.gears.size(); ++gear) {
        QVERIFY(stage->scene.instances[gear].pose.isApprox(assembly.gears[gear].pose, 1e-12));
        QVERIFY(poses[gear].isApprox(assembly.frames[frame][gear], 1e-12));
      }
    }
  }

  void theNumberOfTrianglesIsForeseen() {
    for (const char* name : {"robot", "three-planets", "humpage-reduction"}) {
      const Example example(name);
      for (const double tolerance : {0.0005, 0.002, 0.01}) {
        GearCache cache;
        double triangles = 0;
        for (const TrainGear& gear : example.train.gears) {
          triangles += double((*cache.solid(gear.spec, tolerance))->triangles.size());
        }
        const double part = expectedTriangles(example.train, tolerance) / triangles;
        QVERIFY2(part > 1.0 / 3 && part < 3, qPrintable(QString::number(part)));
      }
    }
  }

  void theAnimatedSceneMovesAsTheFramesDo() {
    // Two ways to the same poses: keys of joints below each other, and forward kinematics.
    const Example robot("robot");
    const PlacedTrain placed = robot.placed();
    GearCache cache;
    const TrainParts made = trainParts(placed.mechanism, placed.train, cache, kFarTolerance);
    const LinkSceneSource source{robot.mechanism, *robot.tree, placed.kinematics, made.parts, [](int) {
                                   return Float3{0.5F, 0.5F, 0.5F};
                                 }};
    const auto scene = linkScene(source, UniformMotion{robot.rates, std::nullopt});
    const Assembly assembly = robot.assembly(robot.rates);
    const auto times = frameTimes(pitchRates(placed, robot.rates), kMinFrames);
    const MeshScene& train = std::get<MeshScene>(scene);
    const std::size_t first = train.nodes.size() - made.parts.size();
    for (std::size_t frame = 0; frame < times.size(); ++frame) {
      const auto world = worldPosesAt(train, times[frame]);
      for (std::size_t gear = 0; gear < assembly.gears.size(); ++gear) {
        QVERIFY(world[first + gear].isApprox(assembly.frames[frame][gear], 1e-9));
      }
    }
  }
};

QTEST_APPLESS_MAIN(TrainFilesTest)
#include "test_train_files.moc"

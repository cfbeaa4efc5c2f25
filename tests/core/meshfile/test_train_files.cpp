#include <QtTest>
#include <numbers>

#include "core/io/file.h"
#include "core/io/mechanism_file.h"
#include "core/matroid/exact_solution.h"
#include "core/matroid/matroid_analysis.h"
#include "core/meshfile/train_files.h"
#include "tests/core/meshfile/assembly_check.h"
#include "tests/core/meshfile/cogs.h"

using namespace geargraph;
using namespace geargraph::test;

namespace {

/// An example of the program with its gears and the rates of its joints.
struct Example {
  Mechanism mechanism;
  DigraphPtr graph;
  SpanningTreePtr tree;
  Placement placement;
  GearTrain train;
  std::vector<Rational> rates;                 ///< at the document's speeds
  std::vector<std::vector<Rational>> motions;  ///< these, and others that move more meshes

  explicit Example(const std::string& name) : mechanism(read(name)) {
    graph = std::make_shared<const Digraph>(mechanism);
    tree = std::make_shared<const SpanningTree>(SpanningTree::of(*graph).value());
    placement = placementOf(mechanism);
    train = trainOf(mechanism, placement);
    const auto model = KinematicModel::of(mechanism, graph, tree, placement);
    const auto analysis = analyzeMatroid(mechanism, *model, placement);
    rates = solveExact(*model, analysis->choice.joints, analysis->speeds)->rates;
    const auto restless = restlessSpeeds(analysis->choice.joints.size());
    motions = {rates, solveExact(*model, analysis->choice.joints, restless)->rates};
  }

  static Mechanism read(const std::string& name) {
    const auto bytes = readFile(GEARGRAPH_SOURCE_DIR "/resources/examples/" + name + ".geargraph", 1 << 20);
    return readMechanism(std::get<std::string>(bytes)).value();
  }

  [[nodiscard]] PlacedTrain placed() const { return {mechanism, *tree, placement, train}; }
  [[nodiscard]] Assembly assembly(const std::vector<Rational>& motion) const {
    return assembly(std::span(&motion, 1));
  }
  [[nodiscard]] Assembly assembly(std::span<const std::vector<Rational>> choice) const {
    GearCache cache;
    return assemblyOf(placed(), cache, kExportTolerance, choice, kFewestFrames).value();
  }
};

AssemblyFindings findings(const Assembly& assembly, const QString& turned = {}, double pitches = 0) {
  const QTemporaryDir folder;
  if (const auto error = writeAssembly(assembly, folder.path().toStdString(), false)) {
    qFatal("%s", error->message.c_str());
  }
  return checkedAssembly(folder.path(), turned, pitches);
}

}  // namespace

class TestTrainFiles : public QObject {
  Q_OBJECT
 private slots:
  void teethMeshInTheFramesOfTheMotion_data() {
    QTest::addColumn<QString>("name");
    for (const char* name : {"robot", "spur-pair", "three-planets", "planetary-ring-held",
                             "bevel-differential", "bevel-wrist", "humpage-reduction"}) {
      QTest::newRow(name) << name;
    }
  }
  void teethMeshInTheFramesOfTheMotion() {
    QFETCH(QString, name);
    const Example example(name.toStdString());
    const AssemblyFindings found = findings(example.assembly(example.motions));
    QCOMPARE(found.problem, QString());
    QCOMPARE(found.pairs, example.mechanism.c());
    QCOMPARE(found.gears, int(example.train.gears.size()));
    QVERIFY(found.frames >= 12 && found.closed);
    QVERIFY2(found.leastTravel >= 0.99, qPrintable(QString::number(found.leastTravel)));
    QVERIFY2(found.phaseError < 0.005, qPrintable(QString::number(found.phaseError)));
    QVERIFY2(found.penetration < 0.004, qPrintable(QString::number(found.penetration)));
  }

  void aTenthOfAPitchOrAWrongRateWouldBeSeen() {
    const Example robot("robot");
    const Assembly assembly = robot.assembly(robot.rates);
    QVERIFY(findings(assembly, QString::fromStdString(assembly.gears[3].name), 0.1).penetration > 0.05);
    std::vector<Rational> wrong = robot.rates;
    for (Rational& rate : wrong) {
      if (rate != robot.rates[0]) rate = -rate;
    }
    QVERIFY(findings(robot.assembly(wrong)).phaseError > 0.05);
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
    const auto assembly = assemblyOf(robot.placed(), cache, kExportTolerance, motions, kFewestFrames);
    QVERIFY(assembly->frames.back()[0].isApprox(robot.assembly(robot.rates).frames.back()[0], 1e-12));
    const auto resting =
        assemblyOf(robot.placed(), cache, kExportTolerance, std::span(&still, 1), kFewestFrames);
    QCOMPARE(resting->frames.size(), kFewestFrames);
    QVERIFY(resting->frames.back()[0].isApprox(assembly->gears[0].pose, 1e-12));
  }

  void partsStandWhereTheTrainHasThem() {
    const Example robot("robot");
    GearCache cache;
    const TrainParts made = trainParts(robot.placed(), cache, kScreenTolerance);
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
    const TrainParts made = trainParts(placed, cache, kFarTolerance);
    const LinkSceneSource source{robot.mechanism, *robot.tree, placed.kinematics, made.parts, [](int) {
                                   return Float3{0.5F, 0.5F, 0.5F};
                                 }};
    const auto scene = linkScene(source, UniformMotion{robot.rates, std::nullopt});
    const Assembly assembly = robot.assembly(robot.rates);
    const auto times = frameTimes(pitchRates(placed, robot.rates), kFewestFrames);
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

QTEST_APPLESS_MAIN(TestTrainFiles)
#include "test_train_files.moc"

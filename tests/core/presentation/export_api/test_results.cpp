#include <QTest>
#include <numbers>

#include "core/presentation/export_api/graph_files.h"
#include "core/presentation/export_api/input_pose.h"
#include "core/presentation/export_api/named_drawings.h"
#include "core/presentation/export_api/rendering_names.h"
#include "core/presentation/export_api/train_export.h"
#include "core/presentation/result_json/analysis_json.h"
#include "tests/core/support/trains.h"

using namespace geargraph;
using namespace geargraph::test;

namespace {

SnapshotPtr analysed(Mechanism mechanism) {
  return analyzeLive(std::make_shared<const Mechanism>(std::move(mechanism)));
}

std::stop_token stopped() {
  std::stop_source source;
  source.request_stop();
  return source.get_token();
}

/// A link that nothing ties to the ground.
Mechanism loose() {
  Mechanism mechanism = emptyMechanism();
  mechanism.links.push_back({LinkId("1"), {}});
  return mechanism;
}

ExportTrain trainOf(Mechanism mechanism) {
  return std::get<ExportTrain>(exportTrain(analysed(std::move(mechanism))));
}

}  // namespace

class ResultsTest : public QObject {
  Q_OBJECT

 private slots:
  void posesFollowTheExactRates() {
    Mechanism limited = robot();
    limited.turningJoints[2].limits = {Number(-170), Number(170)};
    const SnapshotPtr snapshot = analysed(limited);
    InputAngles angles = restingInputs(*snapshot);
    angles.degrees[0] = 36'000'000'030;  // 100 million turns and 30 degrees
    const auto pose = poseOfInputs(*snapshot, angles);
    QVERIFY(pose);
    // Joints keep their turns, links lose them without loss.
    const double turns = 2 * std::numbers::pi * 1e8;
    QVERIFY(std::abs(pose->angles[0] - (turns + std::numbers::pi / 6)) < 1e-6);
    QVERIFY(std::abs(pose->angles[2] + (turns + std::numbers::pi / 6) / 2) < 1e-6);  // joint 10: -i15 = -1/2
    const Eigen::Matrix3d link4 = pose->links[4].linear();
    QVERIFY(std::abs(link4(0, 0) - std::sqrt(3) / 2) < 1e-15 && std::abs(link4(1, 0) - 0.5) < 1e-15);
    QCOMPARE(pose->links.size(), std::size_t{8});
    QCOMPARE(pose->beyondLimits, std::vector<int>{2});
    QVERIFY(!poseOfInputs(*snapshot, angles, stopped()));
  }

  void gearsAreExportedOrTheReasonIsGiven() {
    using Kind = ExportFailure::Kind;
    const auto kindOf = [](const auto& made) { return std::get<ExportFailure>(made).kind; };
    QCOMPARE(kindOf(exportTrain(analysed(loose()))), Kind::mechanism);
    QCOMPARE(kindOf(exportTrain(analysed(robot()), stopped())), Kind::stopped);
    const ExportTrain train = trainOf(robot());
    QCOMPARE(train.motions.size(), std::size_t{2});
    QVERIFY(gearNamed(train, "15:tail") != nullptr && gearNamed(train, "15:tail")->spec.teeth == 18);
    QVERIFY(gearNamed(train, "15:middle") == nullptr);
    QCOMPARE(kindOf(gearScene(train, "99:tail", 0.1)), Kind::choice);
    QCOMPARE(kindOf(trainSolids(train, {.tolerance = 0.1, .link = "99"})), Kind::choice);
    QCOMPARE(kindOf(trainSolids(train, {.tolerance = 0.1}, stopped())), Kind::stopped);
    QCOMPARE(kindOf(trainAssembly(train, 0.1, kMinFrames, stopped())), Kind::stopped);
    const auto solids = std::get<TrainSolids>(trainSolids(train, {.tolerance = 0.1, .moves = true}));
    QCOMPARE(solids.tolerance, 0.1);
    QVERIFY(durationOf(solids.scene) > 0 && solids.shows.empty() && solids.left.empty());
  }

  /// The file moves within the limits of joints, there and back.
  void aMotionInAFileStaysWithinLimits() {
    Mechanism limited = robot();
    limited.turningJoints[0].limits = {Number(-170), Number(100)};
    const ExportTrain train = trainOf(limited);
    const auto solids = std::get<TrainSolids>(trainSolids(train, {.tolerance = 0.2, .moves = true}));
    QVERIFY2(solids.shows.find("joint 8 at -170° and joint 8 at 100°") != std::string::npos,
             solids.shows.c_str());
    const double rate = std::abs(train.motions.front().front().toDouble());
    QVERIFY(std::abs(durationOf(solids.scene) - 2 * 270 * std::numbers::pi / 180 / rate) < 1e-9);
    const auto timed =
        std::get<TrainSolids>(trainSolids(train, {.tolerance = 0.2, .moves = true, .seconds = 5}));
    QVERIFY(std::abs(durationOf(timed.scene) - 5) < 1e-12);
    // A joint that is open at one end turns back in the reference pose; one that cannot turn stays at rest.
    limited.turningJoints[0].limits = {{}, Number(100)};
    const auto open = std::get<TrainSolids>(trainSolids(trainOf(limited), {.tolerance = 0.2, .moves = true}));
    QVERIFY(std::abs(durationOf(open.scene) - 2 * 100 * std::numbers::pi / 180 / rate) < 1e-9);
    limited.turningJoints[0].limits = {Number(0), Number(0)};
    const auto still =
        std::get<TrainSolids>(trainSolids(trainOf(limited), {.tolerance = 0.2, .moves = true}));
    QCOMPARE(durationOf(still.scene), 0.0);
  }

  /// Limits so wide that all turns between them have too many keys: nearer ones, not the motion beyond.
  void wideLimitsAreNarrowedForAFile() {
    Mechanism limited = robot();
    limited.turningJoints[0].limits = {Number(-1000000000), Number(1000000000)};
    const auto solids =
        std::get<TrainSolids>(trainSolids(trainOf(limited), {.tolerance = 0.2, .moves = true}));
    QVERIFY(durationOf(solids.scene) > 0 && durationOf(solids.scene) <= 2 * kStretch + 1e-9);
  }

  /// As in a long train, whose gears make each other faster and faster.
  void aMotionTooFastForAFileLeavesTheTrainAtRest() {
    ExportTrain train = trainOf(robot());
    train.motions.front().front() = Rational(100'000'000'000'000'000);
    const auto solids = std::get<TrainSolids>(trainSolids(train, {.tolerance = 0.1, .moves = true}));
    QCOMPARE(durationOf(solids.scene), 0.0);
    QVERIFY(solids.shows.find("too fast") != std::string::npos);
    QVERIFY(solids.shows.ends_with("Nothing in the file moves."));
    const auto asked = trainSolids(train, {.tolerance = 0.1, .moves = true, .seconds = 5});
    QCOMPARE(std::get<ExportFailure>(asked).kind, ExportFailure::Kind::limit);
  }

  void graphsNeedWhatTheyShow() {
    for (const char* name : {"dot", "graphml", "node-link"}) {
      const GraphForm form = *graphFormFromName(name);
      QVERIFY(!digraphFile(loose(), form).empty());
      QVERIFY(!ttGraphFile(*analysed(loose()), form));
      QVERIFY(ttGraphFile(*analysed(robot()), form));
    }
    QVERIFY(!graphFormFromName("gexf"));
  }

  void theAnalysisIsWrittenWithoutItsMatrices() {
    TextSink all, without;
    const SnapshotPtr snapshot = analysed(robot());
    writeAnalysisJson(all, snapshot, {});
    writeAnalysisJson(without, snapshot, {}, {.matrices = false});
    QVERIFY(all.text().find("\"cycleBasis\"") != std::string::npos);
    QVERIFY(without.text().find("\"matrices\"") == std::string::npos);
    QVERIFY(without.text().find("\"cycles\"") == std::string::npos);
    QVERIFY(without.text().find("\"transferVertices\"") != std::string::npos);
  }

  void namesThatAreNoneAreRejected() {
    MarkChoice marks;
    OverlayChoice overlay;
    QVERIFY(showMark(marks, "axes") && marks.axes && !showMark(marks, "labels"));
    QVERIFY(showOverlay(overlay, "labels") && overlay.links && !showOverlay(overlay, "axes"));
    QVERIFY(facesNamed("lines") == Faces::hiddenLine && !facesNamed("dots"));
    QVERIFY(standardViewNamed("iso") == StandardView::isometric && !standardViewNamed("behind"));
    QVERIFY(drawingNamed("ttgraph") != nullptr && drawingNamed("3d") == nullptr);
  }
};

QTEST_GUILESS_MAIN(ResultsTest)
#include "test_results.moc"

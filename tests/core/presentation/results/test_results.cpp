#include <QtTest>
#include <numbers>

#include "core/presentation/results/analysis_json.h"
#include "core/presentation/results/graph_files.h"
#include "core/presentation/results/input_pose.h"
#include "core/presentation/results/named_drawings.h"
#include "core/presentation/results/rendering_names.h"
#include "core/presentation/results/train_export.h"
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

class TestResults : public QObject {
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
    QVERIFY(std::abs(pose->angles[0] - std::numbers::pi / 6) < 1e-15);
    QVERIFY(std::abs(pose->angles[2] + std::numbers::pi / 12) < 1e-15);  // joint 10: -i15 = -1/2
    QVERIFY(pose->wholeAngles[0] > 6e8);
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
    QCOMPARE(kindOf(trainAssembly(train, 0.1, kFewestFrames, stopped())), Kind::stopped);
    const auto solids = std::get<TrainSolids>(trainSolids(train, {.tolerance = 0.1, .moves = true}));
    QCOMPARE(solids.tolerance, 0.1);
    QVERIFY(durationOf(solids.scene) > 0 && solids.shows.empty() && solids.left.empty());
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
    writeAnalysisJson(all, snapshot.get(), {});
    writeAnalysisJson(without, snapshot.get(), {}, {.matrices = false});
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

QTEST_GUILESS_MAIN(TestResults)
#include "test_results.moc"

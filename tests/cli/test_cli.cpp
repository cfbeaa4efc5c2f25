#include <QDir>
#include <QTemporaryDir>
#include <QTest>
#include <cmath>
#include <nlohmann/json.hpp>
#include <numbers>

#include "core/foundations/files/file.h"
#include "core/mechanism/document_format/mechanism_file.h"
#include "core/mechanism/model/shift_edits.h"
#include "core/theory/analysis/analysis.h"
#include "tests/cli/cli_run.h"
#include "tests/core/support/deep_train.h"
#include "tests/core/support/example_files.h"
#include "tests/core/support/gearboxes.h"
#include "tests/core/support/mechanisms.h"
#include "tests/core/support/train_sketch.h"
#include "tests/support/pdf_streams.h"

using namespace geargraph;
using nlohmann::json;
using test::kRobot;
using test::Run;
using test::run;

namespace {

/// Rows of fields of plain CSV, without quotes.
std::vector<std::vector<std::string>> table(const std::string& csv) {
  std::vector<std::vector<std::string>> rows;
  for (const QString& line : QString::fromStdString(csv).split('\n', Qt::SkipEmptyParts)) {
    rows.emplace_back();
    for (const QString& field : line.split(',')) rows.back().push_back(field.toStdString());
  }
  return rows;
}

test::Dense matrixOfJson(const json& matrix) {
  test::Dense dense(matrix["rows"].size(), std::vector<int>(matrix["columns"].size(), 0));
  std::map<int, std::size_t> row;
  std::map<int, std::size_t> column;
  for (std::size_t i = 0; i < matrix["rows"].size(); ++i) row[matrix["rows"][i]] = i;
  for (std::size_t i = 0; i < matrix["columns"].size(); ++i) column[matrix["columns"][i]] = i;
  if (matrix.contains("entries")) return matrix["entries"].get<test::Dense>();
  for (const json& entry : matrix["triplets"]) dense[row.at(entry[0])][column.at(entry[1])] = entry[2];
  return dense;
}

}  // namespace

class CliTest : public QObject {
  Q_OBJECT

 private slots:
  void init() { m_folder = std::make_unique<QTemporaryDir>(); }

  // Without a view the derivation, with one a drawing.
  void pdf_isTheDerivationOrADrawing() {
    const Run pages = run({"export", kRobot, "--to", "pdf", "--inputs", "8,9,13", "-o", "-"});
    QCOMPARE(pages.status, 0);
    QVERIFY(pages.output.starts_with("%PDF-"));
    QVERIFY(test::pdfText(QByteArray::fromStdString(pages.output)).contains("/Title (Matroid method)"));
    const Run drawing = run({"export", kRobot, "--to", "pdf", "--view", "digraph", "-o", "-"});
    QVERIFY(drawing.output.starts_with("%PDF-"));
    QVERIFY(!test::pdfText(QByteArray::fromStdString(drawing.output)).contains("/Title (Matroid method)"));
    QCOMPARE(run({"export", kRobot, "--to", "pdf", "--inputs", "99", "-o", "-"}).status, 2);
  }

  void csv_readsBackAsTheMatrix() {
    const Mechanism mechanism = test::randomTree(5, 40, 30);
    save(mechanism);
    const SnapshotPtr snapshot = analyze(std::make_shared<const Mechanism>(mechanism));
    // Its meshes are no gears, so status 1; its matrices are there all the same.
    QCOMPARE(run({"export", path("m"), "--to", "csv", "--all", "-o", path("out")}).status, 1);
    for (const IntegerMatrixPtr& matrix : snapshot->matrices) {
      const QString name = QString::fromUtf8(matrixCommandName(matrix->kind()).data());
      const auto csv = table(contents("out/" + name + ".csv"));
      QCOMPARE(csv.size(), static_cast<std::size_t>(matrix->rows()) + 1);
      for (int column = 0; column < matrix->columns(); ++column) {
        QCOMPARE(csv[0].at(static_cast<std::size_t>(column) + 1), matrix->columnHeading(column).text);
      }
      for (int row = 0; row < matrix->rows(); ++row) {
        const auto& fields = csv[static_cast<std::size_t>(row) + 1];
        QCOMPARE(fields.at(0), matrix->rowHeading(row).text);
        QCOMPARE(fields.size(), static_cast<std::size_t>(matrix->columns()) + 1);
        for (int column = 0; column < matrix->columns(); ++column) {
          QCOMPARE(std::stoi(fields[static_cast<std::size_t>(column) + 1]), matrix->entry(row, column));
        }
      }
    }
  }

  void states_giveTheShiftTableOfTheEightSpeedGearbox() {
    save(test::eightSpeed());
    const Run result = run({"states", path("m"), "--json"});
    QCOMPARE(result.status, 0);
    QCOMPARE(result.errors, std::string());
    const json table = json::parse(result.output);
    QCOMPARE(table["format"].get<std::string>(), std::string("geargraph-states"));
    QCOMPARE(table["version"].get<int>(), 1);
    QCOMPARE(table["states"].size(), std::size_t(9));
    const json& first = table["states"][0];
    QCOMPARE(first["name"].get<std::string>(), std::string("1"));
    QCOMPARE(first["engaged"], json({"A", "B", "C"}));
    QCOMPARE(first["dof"].get<int>(), 1);
    QCOMPARE(first["ratio"].get<std::string>(), std::string("108/23"));
    QVERIFY(std::abs(first["ratioNumeric"].get<double>() - 4.6957) < 5e-5);
    QCOMPARE(first["jointSpeeds"].size(), std::size_t(12));
    QCOMPARE(first["jointSpeeds"]["13"].get<std::string>(), std::string("1"));       // the input shaft
    QCOMPARE(first["jointSpeeds"]["14"].get<std::string>(), std::string("23/108"));  // the output shaft
    QVERIFY(first["diagnostics"].empty());
  }

  void states_thatLockOrAreFreeWarnAndAreNoError() {
    Mechanism gearbox = test::eightSpeed();
    gearbox.states.clear();
    test::addState(gearbox, "N", {"A"}, 1, 2);
    test::addState(gearbox, "X", {"A", "B", "C", "D"}, 1, 2);
    save(gearbox);
    const Run result = run({"states", path("m"), "--json"});
    QCOMPARE(result.status, 0);
    const json table = json::parse(result.output);
    for (const auto& [position, dof, code] :
         {std::tuple(0, 3, "state-free"), std::tuple(1, 0, "state-locked")}) {
      const json& state = table["states"][static_cast<std::size_t>(position)];
      QCOMPARE(state["dof"].get<int>(), dof);
      QVERIFY(state["ratio"].is_null() && state["ratioNumeric"].is_null() && state["jointSpeeds"].is_null());
      QCOMPARE(state["diagnostics"][0]["code"].get<std::string>(), std::string(code));
      QCOMPARE(state["diagnostics"][0]["severity"].get<std::string>(), std::string("warning"));
    }
    const Run text = run({"states", path("m")});
    QVERIFY(text.errors.find("[state-free]") != std::string::npos);
    QVERIFY(run({"validate", path("m")}).output.find("[state-locked]") != std::string::npos);
  }

  /// A second sun that nothing holds idles: the state has its ratio, and the links are named.
  void states_withLinksThatIdleHaveARatio() {
    Mechanism train = test::TrainSketch(5)
                          .joint(0, 1, "a")
                          .joint(0, 2, "a")
                          .joint(2, 3, "b")
                          .joint(0, 4, "a")
                          .joint(2, 5, "c")
                          .mesh(1, 3, 24, 18, MeshKind::external)
                          .mesh(3, 0, 18, 60, MeshKind::internal)
                          .mesh(4, 5, 20, 22, MeshKind::external)
                          .build();
    test::addBrake(train, "B", 4);
    test::addState(train, "1", {}, 1, 2);
    save(train);
    const Run call = run({"states", path("m"), "--eta", "0.95", "--json"});
    QCOMPARE(call.status, 0);
    const json state = json::parse(call.output)["states"][0];
    QCOMPARE(state["dof"].get<int>(), 2);
    QCOMPARE(state["ratio"].get<std::string>(), std::string("7/2"));
    QCOMPARE(state["ratioSymbolic"].is_string(), true);
    QCOMPARE(state["torques"]["driven"].get<std::string>(), std::string("-521/160"));
    QVERIFY(state["efficiency"].is_string());
    QVERIFY(state["jointSpeeds"]["6"].is_string());
    QVERIFY(state["jointSpeeds"]["9"].is_null() && state["jointSpeeds"]["10"].is_null());
    QCOMPARE(state["diagnostics"][0]["code"].get<std::string>(), std::string("state-idle"));
    QCOMPARE(state["diagnostics"][0]["elements"]["links"], json({"4", "5"}));
  }

  /// Everything is of the train as engaged: a state's speeds are those of its row of the shift table.
  void state_engagesItsCouplings() {
    for (const char* name : {"eight-speed-gearbox", "simpson", "ravigneaux"}) {
      const QString file = QString::fromStdString(test::examplePath(name));
      const json bare = json::parse(run({"analyze", file, "--json"}).output);
      QVERIFY(!bare.contains("engaged") && !bare.contains("state") && !bare.contains("couplingRows"));
      for (const json& state : json::parse(run({"states", file, "--json"}).output)["states"]) {
        const QString called = QString::fromStdString(state["name"]);
        const Run result = run({"analyze", file, "--state", called, "--json"});
        QCOMPARE(result.status, 0);
        const json analysis = json::parse(result.output);
        QVERIFY(analysis["state"] == state["name"]);
        QVERIFY(analysis["engaged"] == state["engaged"]);
        QVERIFY(analysis["counts"]["dof"] == 1);
        QVERIFY(analysis["jointSpeeds"] == state["jointSpeeds"]);
        QVERIFY(analysis["agreement"]["equal"] == true);
        QVERIFY(analysis["couplingRows"]["rows"] == state["engaged"]);
        QCOMPARE(analysis["couplingRows"]["entries"].size(), state["engaged"].size());
        QVERIFY(analysis["matrices"] == bare["matrices"]);
        const int held = analysis["counts"]["rank"].get<int>() - bare["counts"]["rank"].get<int>();
        QCOMPARE(static_cast<std::size_t>(held), state["engaged"].size());
        QCOMPARE(run({"validate", file, "--state", called}).status, 0);
      }
    }
  }

  void engage_takesCouplingsByName() {
    const QString file = QString::fromStdString(test::examplePath("eight-speed-gearbox"));
    const json by = json::parse(run({"analyze", file, "--engage", "C,A,B", "--json"}).output);
    QVERIFY(by["engaged"] == json({"A", "B", "C"}) && by["state"] == "1");
    const json two = json::parse(run({"analyze", file, "--engage", "A,E", "--json"}).output);
    QVERIFY(two["counts"]["dof"] == 2 && two["state"].is_null());
    save(*withEngagement(test::example("simpson"), {ShiftElementId("C")}));
    QVERIFY(json::parse(run({"analyze", path("m"), "--json"}).output)["engaged"] == json({"C"}));
    QVERIFY(
        !json::parse(run({"analyze", path("m"), "--engage", "none", "--json"}).output).contains("engaged"));

    const Run unknown = run({"analyze", file, "--state", "9"});
    QCOMPARE(unknown.status, 2);
    QVERIFY(unknown.errors.find("There is no state \"9\". States: 1, 2, 3, 4, 5, 6, 7, 8 and R.") !=
            std::string::npos);
    QCOMPARE(run({"export", file, "--to", "csv", "--matrix", "p", "--engage", "X", "-o", "-"}).status, 2);
    QCOMPARE(run({"pose", file, "--state", "1", "--engage", "A"}).status, 2);
    QCOMPARE(run({"inputs", file, "--engage", "A,A"}).status, 2);
  }

  void whatIsEngaged_reachesEveryCommand() {
    const QString file = QString::fromStdString(test::examplePath("eight-speed-gearbox"));
    // In state 1 link 2 (joint 14) is at rest, and link 8 (joint 20) turns 23/108 as far as the input.
    const json pose =
        json::parse(run({"pose", file, "--state", "1", "--angle", "13=108deg", "--json"}).output);
    const auto angle = [&](const char* joint) { return pose["jointAngles"][joint].get<double>(); };
    QVERIFY(angle("14") == 0 && std::abs(angle("20") - 23 * std::numbers::pi / 180) < 1e-9);
    const json inputs = json::parse(run({"inputs", file, "--state", "1", "--json"}).output);
    for (const json& set : inputs["sets"]) QCOMPARE(set.size(), std::size_t{1});
    const auto solution =
        table(run({"export", file, "--to", "csv", "--matrix", "solution", "--state", "1", "-o", "-"}).output);
    QCOMPARE(solution[0].size(), std::size_t{2});  // labels, and the one input
    const std::string derivation = run({"export", file, "--to", "md", "--state", "1", "-o", "-"}).output;
    QVERIFY(derivation.find("Engaged couplings") != std::string::npos);
    QVERIFY(derivation.find("brake A") != std::string::npos);
    save(*withEngagement(test::example("eight-speed-gearbox"), {ShiftElementId("A")}));
    const json statics = json::parse(run({"statics", path("m"), "--json"}).output);
    QVERIFY(statics["engaged"] == json({"A"}) && statics["state"].is_null());
    QVERIFY(json::parse(run({"statics", path("m"), "--state", "1", "--json"}).output)["engaged"] ==
            json({"A", "B", "C"}));
  }

  void json_isReadByAnotherReader_andHoldsTheMatrices() {
    const Mechanism mechanism = test::randomTree(6, 30, 20);
    save(mechanism);
    const SnapshotPtr snapshot = analyze(std::make_shared<const Mechanism>(mechanism));
    const json analysis = json::parse(run({"analyze", path("m"), "--json"}).output);
    QCOMPARE(analysis["format"].get<std::string>(), std::string("geargraph-analysis"));
    QCOMPARE(analysis["counts"]["links"].get<int>(), 30);
    for (const IntegerMatrixPtr& matrix : snapshot->matrices) {
      const json& part = analysis["matrices"][std::string(matrixJsonName(matrix->kind()))];
      QVERIFY(matrixOfJson(part) == test::dense(*matrix));
    }
    const IntegerMatrix& tree = *snapshot->matrix(MatrixKind::spanningTree);
    for (int row = 0; row < tree.rows(); ++row) {
      const json& cycle = analysis["cycles"][static_cast<std::size_t>(row)];
      std::vector<MatrixEntry> entries;
      tree.rowEntries(row, entries);
      QCOMPARE(cycle["mesh"].get<int>(), tree.rowHeading(row).label);
      QCOMPARE(cycle["joints"].size(), entries.size());
      QCOMPARE(cycle["signs"].size(), entries.size());
    }
  }

  void largeMatrices_areTriplets_unlessDenseIsSaid() {
    const Mechanism mechanism = test::randomTree(7, 501, 10);  // Z has 251,001 entries
    save(mechanism);
    const json sparse = json::parse(run({"analyze", path("m"), "--json"}).output)["matrices"];
    const json dense = json::parse(run({"analyze", path("m"), "--json", "--dense"}).output)["matrices"];
    QVERIFY(sparse["path"].contains("triplets") && !sparse["path"].contains("entries"));
    QVERIFY(dense["path"].contains("entries") && !dense["path"].contains("triplets"));
    QVERIFY(sparse["spanningTree"].contains("entries"));
    QVERIFY(matrixOfJson(sparse["path"]) == matrixOfJson(dense["path"]));
  }

  /// The numbers of the page: the solution of Eq. (25) times the inputs' speeds, by both methods.
  void theRobotsSolution_isEq25() {
    const json analysis = json::parse(run({"analyze", kRobot, "--json"}).output);
    QCOMPARE(analysis["counts"]["rank"].get<int>(), 4);
    QCOMPARE(analysis["counts"]["dof"].get<int>(), 3);
    for (const char* method : {"solution", "ttSolution"}) {
      const json& solution = analysis[method];
      QVERIFY(solution["inputs"] == json({8, 9, 11}) && solution["outputs"] == json({10, 12, 13, 14}));
      QVERIFY(solution["exact"][3] == json({"-8/27", "-16/27", "-8/9"}));
      QVERIFY(solution["symbolic"][3] == json({"-i18*i17*i16*i15", "-i18*i17*i16", "-i18*i17"}));
    }
    QVERIFY(analysis["agreement"]["equal"].get<bool>());
    QCOMPARE(analysis["jointSpeeds"]["14"].get<std::string>(), std::string("-16/27"));
    QVERIFY(analysis["matrices"]["p"]["entries"][1] == json({0, 20, -20, 0, 30, 0, 0}));
    QVERIFY(analysis["transferVertices"][1]["path"] == json({5, 0, 1, 2}));
  }

  void inputsOfTheCommandLine_replaceThoseOfTheFile() {
    const json analysis = json::parse(
        run({"analyze", kRobot, "--json", "--inputs=14,9,13", "--speed", "14=2", "--no-symbolic"}).output);
    QVERIFY(analysis["solution"].is_null());  // q14 = i18 q13: they are dependent
    const json valid = json::parse(
        run({"analyze", kRobot, "--json", "--inputs=14,9,8", "--speed=14=-16/27", "--no-symbolic"}).output);
    QVERIFY(valid["solution"]["inputs"] == json({14, 9, 8}));
    QVERIFY(valid["solution"]["symbolic"].is_null() && valid["ttSolution"]["symbolic"].is_null());
    QCOMPARE(valid["jointSpeeds"]["11"].get<std::string>(), std::string("0"));
    QCOMPARE(valid["jointSpeeds"]["9"].get<std::string>(), std::string("1/2"));  // kept from the file
  }

  /// Link 1 turns by -i15 times the motor's angle about axis b, and carries axis c along.
  void pose_followsTheInputs() {
    const json pose = json::parse(run({"pose", kRobot, "--json", "--angle", "8=180deg"}).output);
    const auto isNear = [](const json& value, double wanted) {
      return std::abs(value.get<double>() - wanted) < 1e-12;
    };
    QVERIFY(isNear(pose["jointAngles"]["8"], M_PI) && isNear(pose["jointAngles"]["10"], -M_PI / 2));
    const json& turned = pose["links"]["1"]["rotation"];  // by -90 degrees about z
    QVERIFY(isNear(turned[0][1], 1) && isNear(turned[1][0], -1) && isNear(turned[2][2], 1));
    QVERIFY(isNear(pose["links"]["4"]["point"][1], -108));  // half a turn about axis a, 54 from the origin
    // A million turns of the input and back to the start: exact angles know it, doubles would not.
    const json far = json::parse(run({"pose", kRobot, "--json", "--angle=8=9720000000deg"}).output);
    for (const auto& [link, where] : far["links"].items())
      QVERIFY2(isNear(where["rotation"][0][0], 1), link.c_str());
    // 1e300 = 280 (mod 360), and joint 10 turns by half of it the other way: 1e300/2 = 320 (mod 360).
    const json huge = json::parse(run({"pose", kRobot, "--json", "--angle=8=1e300deg"}).output);
    QVERIFY(isNear(huge["links"]["4"]["rotation"][1][0], std::sin(-80 * M_PI / 180)));
    QVERIFY(isNear(huge["links"]["1"]["rotation"][1][0], std::sin(40 * M_PI / 180)));
    const json radians = json::parse(run({"pose", kRobot, "--json", "--angle=8=1e22rad"}).output);
    QVERIFY(isNear(radians["links"]["4"]["rotation"][1][0], -0.8522008497671888));
    for (const char* angle : {"--angle=8=1e400rad", "--angle=8=-1e400deg"}) {
      const auto rejected = run({"pose", kRobot, "--json", angle});
      QCOMPARE(rejected.status, 2);
      QVERIFY(rejected.output.empty());
      QVERIFY(rejected.errors.find("too large") != std::string::npos);
    }
    QCOMPARE(run({"pose", kRobot, "--json", "--angle=8=0.5rad", "--inputs=8,9"}).status, 1);
  }

  /// Joints keep their turns, also those that follow; links are turned by what is left of them.
  void pose_keepsTheTurnsOfJoints() {
    const QString pair = QString::fromStdString(test::examplePath("spur-pair"));
    const json pose = json::parse(run({"pose", pair, "--json", "--angle", "3=3600deg"}).output);
    QCOMPARE(pose["jointAngles"]["3"].get<double>(), 20 * M_PI);
    QVERIFY(std::abs(pose["jointAngles"]["4"].get<double>() + 20 * M_PI * 20 / 30) < 1e-12);
    QVERIFY(std::abs(pose["links"]["1"]["rotation"][0][0].get<double>() - 1) < 1e-15);
    const std::string text = run({"pose", pair, "--angle", "3=3600deg"}).output;
    QVERIFY2(text.find("  3 turned by 3600.0000 deg\n") != std::string::npos, text.c_str());
    // Turned and reported as what its limits are compared with.
    const auto beyond = run({"pose", kRobot, "--angle", "8=400deg"});
    QVERIFY(beyond.output.find("  10 turned by -200.0000 deg\n") != std::string::npos);
    QVERIFY(beyond.errors.find("joint 10 at -200 deg is beyond its limits") != std::string::npos);
  }

  void pose_needsTheUnitOfAnAngle() {
    const auto rejected = run({"pose", kRobot, "--angle", "8=30"});
    QCOMPARE(rejected.status, 2);
    QVERIFY2(
        rejected.errors.find("--angle needs the unit of its angle: 8=30deg or 8=30rad.") != std::string::npos,
        rejected.errors.c_str());
    QCOMPARE(run({"dynamics", kRobot, "--angle", "8=30"}).status, 2);
    const auto angle = [](const char* text) {
      const Run posed = run({"pose", kRobot, "--json", "--angle", QString("8=") + text});
      return posed.status == 0 ? json::parse(posed.output)["jointAngles"]["8"].get<double>() : -1;
    };
    QCOMPARE(angle("0"), 0.0);
    QCOMPARE(angle("2*15deg"), M_PI / 6);
    QCOMPARE(angle("1/12 turns"), M_PI / 6);
    QCOMPARE(angle("1/4+1/4 rad"), 0.5);
  }

  void quantities_haveTheUnitsOfPeople() {
    const auto speeds = [](const QStringList& words) {
      return json::parse(run(QStringList{"analyze", kRobot, "--json"} + words).output)["jointSpeeds"];
    };
    QCOMPARE(speeds({"--speed", "8=1/3+1/5"})["8"].get<std::string>(), std::string("8/15"));
    QCOMPARE(speeds({"--speed", "8=100/22"})["8"].get<std::string>(), std::string("50/11"));
    QCOMPARE(speeds({"--speed", "8=600deg/s"}), speeds({"--speed", "8=100rpm"}));
    // 10 = -8/2 and 11 added to what it drives: zero stays zero with angles of pi.
    const json balanced = speeds({"--speed", "8=300rpm", "--speed", "9=0", "--speed", "11=0 1/min"});
    QCOMPARE(Rational::fromText(balanced["10"].get<std::string>())->toDouble(), -5 * M_PI);
    const auto torque = [](const char* load) {
      const Run solved = run({"statics", kRobot, "--json", "--load", QString("joint:14=") + load});
      return json::parse(solved.output)["loads"][0]["torque"].get<std::string>();
    };
    QCOMPARE(torque("1000 N cm"), std::string("10"));
    QCOMPARE(torque("1lbf ft"), std::string("3389544870828501/2500000000000000"));
    QCOMPARE(torque("100W@50rad/s"), std::string("2"));
    const Run force = run({"statics", kRobot, "--json", "--load", "link:3=0,0,-2*10N@30,-60,1in"});
    const Run same = run({"statics", kRobot, "--json", "--load", "link:3=0,0,-20N@30,-60,25.4"});
    QCOMPARE(force.status, 0);
    QCOMPARE(force.output, same.output);
    QCOMPARE(run({"statics", kRobot, "--json", "--load", "joint:14=10Nm", "--eta", "98%"}).output,
             run({"statics", kRobot, "--json", "--load", "joint:14=10Nm", "--eta", "0.98"}).output);
  }

  void validate_warnsOfMissing3dFiles() {
    Mechanism dressed = test::example("robot");
    dressed.links[2].shapes = {LinkShape{"arm.stl"}, LinkShape{"parts/none.stl"}};
    save(dressed);
    const auto problems = [&] {
      const Run checked = run({"validate", path("m"), "--json"});
      std::string text = std::to_string(checked.status);
      const json answer = json::parse(checked.output);
      for (const json& each : answer["diagnostics"]) {
        const std::string code = each["code"];
        if (code == "missing-file") text += ' ' + each["pointer"].get<std::string>();
        if (code == "shown-only") text += ' ' + code + each["elements"]["links"].dump();
      }
      return text;
    };
    QCOMPARE(problems(), std::string("0 shown-only[\"2\"] /links/2/shapes/0/file /links/2/shapes/1/file"));
    QFile arm(QFileInfo(path("m")).dir().filePath("arm.stl"));
    QVERIFY(arm.open(QIODevice::WriteOnly));
    QCOMPARE(problems(), std::string("0 shown-only[\"2\"] /links/2/shapes/1/file"));
  }

  /// A second of work or more each, of which far less is allowed.
  void everyCommand_endsAtItsTimeLimit_andLeavesNothing() {
    save(test::deepTrain(1, 4000));
    const QString file = path("m");
    const std::vector<QStringList> commands = {
        {"validate", file},
        {"analyze", file, "--json"},
        {"inputs", file, "--json"},
        {"states", file, "--json"},
        {"pose", file, "--angle", "4001=30deg"},
        {"export", file, "--to", "csv", "--matrix", "p", "-o", path("out.csv")},
        {"export", file, "--to", "csv", "--all", "-o", path("out")},
        {"export", file, "--to", "glb", "-o", path("out.glb")},
        {"export", file, "--to", "assembly", "-o", path("out")},
        {"export", file, "--to", "svg", "--view", "digraph", "-o", path("out.svg")},
        {"export", file, "--to", "png", "--view", "3d", "-o", path("out.png")},
    };
    for (QStringList words : commands) {
      const QByteArray name = words.join(' ').toUtf8();
      const Run stopped = run(words << "--limit-seconds"
                                    << "0.001");
      QVERIFY2(stopped.status == 3, name + ": " + QByteArray::number(stopped.status));
      QVERIFY2(stopped.output.empty(), name);
      QVERIFY2(stopped.errors.find("The limit of 0.001 s was over before ") != std::string::npos, name);
    }
    const QStringList left = QDir(m_folder->path()).entryList(QDir::Files | QDir::Hidden);
    QCOMPARE(left, (QStringList{QFileInfo(file).fileName()}));
    QVERIFY(QDir(path("out")).entryList(QDir::Files | QDir::Hidden).isEmpty());
  }

  void aTimeLimitThatSuffices_changesNothing() {
    const Run free = run({"analyze", kRobot, "--json"});
    const Run limited = run({"analyze", kRobot, "--json", "--limit-seconds=100"});
    QCOMPARE(limited.status, 0);
    QCOMPARE(limited.output, free.output);
    for (const char* wrong : {"0", "-1", "soon", "inf", "1e300"})
      QCOMPARE(run({"validate", kRobot, "--limit-seconds", wrong}).status, 2);
    for (const char* command : {"validate", "analyze", "inputs", "states", "export", "pose"})
      QVERIFY(run({command, "--help"}).output.find("--limit-seconds S") != std::string::npos);
  }

  void folders_areNotOverwrittenUnlessForced() {
    const QStringList words = {"export", kRobot, "--to", "csv", "--all", "-o", path("out")};
    QCOMPARE(run(words).status, 0);
    QCOMPARE(QDir(path("out")).entryList(QDir::Files | QDir::Hidden).size(), 13);
    QVERIFY(!writeFile(path("out/path.csv").toStdString(), "mine"));
    QDir(path("out")).remove("incidence.csv");
    const Run rejected = run(words);
    QCOMPARE(rejected.status, 2);
    QVERIFY(rejected.errors.find("--force") != std::string::npos);
    QCOMPARE(contents("out/path.csv"), std::string("mine"));
    QVERIFY(!QFile::exists(path("out/incidence.csv")));  // all or nothing
    QCOMPARE(run(words + QStringList{"--force"}).status, 0);
    QCOMPARE(table(contents("out/path.csv")).size(), std::size_t{8});
  }

  /// What such a call would write is not what was asked for.
  void optionsWithoutMeaning_areRejected_data() {
    QTest::addColumn<QString>("words");
    QTest::addColumn<QString>("option");
    for (const char* words : {"csv --matrix p --fps 12",
                              "csv --matrix p --dark",
                              "csv --all --view digraph",
                              "html --matrix p",
                              "pdf --all",
                              "pdf --tolerance 0.1",
                              "md --view schematic",
                              "svg --view digraph --inputs 8,9,11",
                              "pdf --view ttgraph --ride 1",
                              "png --view digraph --turntable",
                              "png --view 3d --bom",
                              "png --view 3d --fps 12",
                              "png --view 3d --motion --gear 15:tail",
                              "glb --view 3d --motion",
                              "glb --view 3d --section y:0.5",
                              "glb --view 3d --animate 4",
                              "glb --hide 1",
                              "stl --view 3d",
                              "stl --frames 12",
                              "obj --force",
                              "assembly --gear 15:tail",
                              "assembly --all"}) {
      const QString text = QLatin1String(words);
      const qsizetype last = text.lastIndexOf(QLatin1String(" --")) + 1;
      QTest::addRow("%s", words) << text << text.mid(last).section(QLatin1Char(' '), 0, 0);
    }
  }
  void optionsWithoutMeaning_areRejected() {
    QFETCH(QString, words);
    QFETCH(QString, option);
    const QString out = path("out");
    const Run rejected = run(QStringList{"export", kRobot, "-o", out, "--to"} + words.split(' '));
    QCOMPARE(rejected.status, 2);
    QVERIFY(rejected.output.empty());
    QVERIFY2(rejected.errors.find(option.toStdString() + " has no meaning with --to ") != std::string::npos,
             rejected.errors.c_str());
    QVERIFY(!QFile::exists(out));
  }

  void standardInputAndOutput() {
    const std::string robot = contentsOf(kRobot);
    const Run piped =
        run({"export", "-", "--to", "csv", "--matrix", "path", "-o", "-"}, QByteArray::fromStdString(robot));
    QCOMPARE(piped.status, 0);
    QCOMPARE(run({"export", kRobot, "--to", "csv", "--matrix", "path", "-o", path("Z.csv")}).status, 0);
    QCOMPARE(contents("Z.csv"), piped.output);
    QVERIFY(piped.errors.empty());
  }

  void outputThatCannotBeWritten_isStatus2() {
    for (const QString& where : {QStringLiteral("/dev/full"), path("no/folder/Z.csv"), path("")}) {
      const Run failed = run({"export", kRobot, "--to", "csv", "--matrix", "path", "-o", where});
      QCOMPARE(failed.status, 2);
      QVERIFY(failed.errors.find("could not be written") != std::string::npos);
    }
    QProcess process;
    process.setStandardOutputFile("/dev/full");
    process.start(QStringLiteral(GEARGRAPH_CLI), {"analyze", kRobot, "--json"});
    process.waitForFinished(60'000);
    QCOMPARE(process.exitCode(), 2);
  }

  void filesThatAreNoDocuments_neverCrashIt() {
    for (const char* bytes : {"", "\0", "[[[[", "{\"format\": \"geargraph\"", "\xFF\xFE", "3"}) {
      QVERIFY(!writeFile(path("m").toStdString(), bytes));
      for (const char* command : {"analyze", "validate"}) {
        const Run broken = run({command, path("m"), "--json"});
        QCOMPARE(broken.status, 1);
        QCOMPARE(json::parse(broken.output)["diagnostics"].size(), std::size_t{1});
      }
    }
    QCOMPARE(run({"analyze", m_folder->path()}).status, 2);
  }

 private:
  [[nodiscard]] QString path(const QString& name) const { return m_folder->filePath(name); }
  void save(const Mechanism& mechanism) {
    QVERIFY(!writeFile(path("m").toStdString(), writeMechanism(mechanism)));
  }
  static std::string contentsOf(const QString& file) {
    return std::get<std::string>(readFile(file.toStdString(), kLargestFile));
  }
  [[nodiscard]] std::string contents(const QString& name) const { return contentsOf(path(name)); }

  std::unique_ptr<QTemporaryDir> m_folder;
};

QTEST_GUILESS_MAIN(CliTest)
#include "test_cli.moc"

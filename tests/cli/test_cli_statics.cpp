#include <QTemporaryDir>
#include <QTest>
#include <nlohmann/json.hpp>
#include <set>
#include <string>

#include "core/mechanism/document_format/mechanism_file.h"
#include "core/mechanism/model/load_edits.h"
#include "tests/cli/cli_run.h"
#include "tests/core/support/example_files.h"
#include "tests/core/support/gearboxes.h"
#include "tests/core/support/train_sketch.h"

using namespace geargraph;
using nlohmann::json;
using test::kRobot;
using test::parsed;
using test::Run;
using test::run;

namespace {

std::set<std::string> codesOf(const json& report) {
  std::set<std::string> codes;
  for (const json& diagnostic : report["diagnostics"]) codes.insert(diagnostic["code"].get<std::string>());
  return codes;
}

}  // namespace

class CliStaticsTest : public QObject {
  Q_OBJECT

 private slots:
  void aLoadOnTheRobotsHand() {
    const Run call = run({"statics", kRobot, "--load", "joint:14=10Nm", "--json"});
    QCOMPARE(call.status, 0);
    const json report = parsed(call);
    QCOMPARE(report["format"], "geargraph-statics");
    QVERIFY(report["state"].is_null());
    QCOMPARE(report["counts"],
             json::parse(R"({"unknowns": 7, "equations": 7, "rank": 7, "indeterminate": 0})"));
    QCOMPARE(report["balances"][0]["joint"], 8);
    QCOMPARE(report["balances"][0]["torque"], "80/27");
    QCOMPARE(report["balances"][1]["torque"], "160/27");
    QCOMPARE(report["balances"][2]["torque"], "80/9");
    QCOMPARE(report["jointTorques"],
             json::parse(R"({"8": "80/27", "9": "160/27", "11": "80/9", "14": "10"})"));
    QCOMPARE(report["solution"]["balanced"], json({8, 9, 11}));
    QCOMPARE(report["solution"]["loaded"], json({10, 12, 13, 14}));
    QCOMPARE(report["solution"]["symbolic"][0], json({"i15", "i16*i15", "i17*i16*i15", "i18*i17*i16*i15"}));
    QCOMPARE(report["solution"]["exact"][2], json({"0", "0", "4/3", "8/9"}));
    QCOMPARE(report["ttSolution"]["balanced"], report["solution"]["balanced"]);
    QCOMPARE(report["ttSolution"]["exact"], report["solution"]["exact"]);
    QCOMPARE(report["agreement"]["equal"], true);
    QCOMPARE(report["meshes"].size(), std::size_t{4});
    QCOMPARE(report["meshes"][3]["headTorque"], "-10");
    QCOMPARE(report["bearings"].size(), std::size_t{7});
    QCOMPARE(report["power"]["loss"], "0");
    QCOMPARE(report["power"]["input"], report["power"]["output"]);
    QVERIFY(report["efficiency"].is_null());
    QVERIFY(codesOf(report).empty());
  }

  void loadsOfTheDocumentAndOfTheCall() {
    Mechanism robot = test::example("robot");
    robot = *withLoad(robot, {LoadId("hand"), JointTorque{JointId("14"), Number(10)}});
    const QString file = saved(robot);
    QCOMPARE(parsed(run({"statics", file, "--json"}))["balances"][0]["torque"], "80/27");
    // The same in other units, from other places; loads add up.
    const json twice = parsed(run({"statics", file, "--load", "joint:14=10000Nmm", "--json"}));
    QCOMPARE(twice["balances"][0]["torque"], "160/27");
    QCOMPARE(twice["loads"].size(), std::size_t{2});
    const json other = parsed(run({"statics", file, "--no-loads", "--load", "link:3@e=1/100kNm", "--json"}));
    QCOMPARE(other["loads"].size(), std::size_t{1});
    QCOMPARE(other["loads"][0]["axis"], "e");
    QCOMPARE(other["loads"][0]["torque"], "10");
    const json force =
        parsed(run({"statics", file, "--no-loads", "--load", "link:3=10,-20,-50N@30,-60,130", "--json"}));
    QCOMPARE(force["loads"][0]["force"], json({"10", "-20", "-50"}));
    QVERIFY(force["balances"][0]["torque"].is_string());
    const json none = parsed(run({"statics", file, "--no-loads", "--json"}));
    QVERIFY(codesOf(none).contains("no-load"));
    QCOMPARE(none["balances"][0]["torque"], "0");
  }

  void loadsThatNothingHolds() {
    const Run call = run({"statics", kRobot, "--load", "joint:14=10Nm", "--balance", "joint:8", "--balance",
                          "joint:9", "--json"});
    QCOMPARE(call.status, 1);
    const json report = parsed(call);
    QCOMPARE(codesOf(report), std::set<std::string>{"unbalanced"});
    QVERIFY(report["balances"].is_null() && report["meshes"].is_null());
    QCOMPARE(report["agreement"]["equal"], true);
    QVERIFY(call.errors.find("joints 11, 13 and 14 turn freely under the load on joint 14. Add a balance at "
                             "joint 11 or 13.") != std::string::npos);
  }

  void everyStateOfATrainWithoutAny_isSaid() {
    Mechanism robot = test::example("robot");
    const Run call = run({"statics", saved(robot), "--all-states"});
    QCOMPARE(call.status, 0);
    QCOMPARE(call.output, std::string("Geared robotic mechanism: no states\n"));
    for (Axis& axis : robot.axes) axis.point = robot.axes.front().point;
    const Run wrong = run({"statics", saved(robot), "--all-states"});
    QCOMPARE(wrong.status, 1);
    QVERIFY(wrong.errors.find("error: ") != std::string::npos);
  }

  void everyStateOfAGearbox() {
    const QString file = saved(test::eightSpeed());
    const Run call = run({"statics", file, "--all-states", "--eta", "0.98", "--json"});
    QCOMPARE(call.status, 0);
    const json report = parsed(call);
    QCOMPARE(report["states"].size(), std::size_t{9});
    const json& first = report["states"][0];
    QCOMPARE(first["state"], "1");
    QCOMPARE(first["engaged"], json({"A", "B", "C"}));
    QVERIFY(codesOf(first).contains("unit-load"));
    QCOMPARE(first["couplings"].size(), std::size_t{3});
    QCOMPARE(first["couplings"]["C"]["kind"], "clutch");
    for (const json& state : report["states"]) {
      QVERIFY(state["agreement"]["equal"] == true);
      QVERIFY(state["efficiency"]["numeric"].get<double>() <= 1);
      QCOMPARE(state["efficiency"]["selfLocking"], false);
    }
    QCOMPARE(report["states"][5]["efficiency"]["value"], "1");  // direct drive
    const json lossless = parsed(run({"statics", file, "--state", "1", "--json"}));
    QCOMPARE(lossless["balances"][0]["torque"], "-108/23");
    QVERIFY(lossless["efficiency"].is_null());
  }

  void sharesOfPlanets() {
    const QString file = saved(test::planetary(24, 18, 3));
    const QStringList call{"statics", file, "--inputs", "9,8", "--load", "joint:7=1Nm", "--json"};
    const json open = parsed(run(call));
    QVERIFY(codesOf(open).contains("statically-indeterminate"));
    QCOMPARE(open["counts"]["indeterminate"], 2);
    QVERIFY(open["meshes"][0]["tailTorque"].is_null());
    QCOMPARE(open["selfStresses"].size(), std::size_t{2});
    QCOMPARE(open["balances"][0]["determinate"], true);
    const json shared = parsed(run(call + QStringList{"--share", "stiffness"}));
    QCOMPARE(shared["share"], "stiffness");
    QCOMPARE(shared["meshes"][0]["tailTorque"], shared["meshes"][2]["tailTorque"]);
  }

  void aSelfLockingTrain() {
    Mechanism train = test::TrainSketch(3)
                          .joint(0, 1, "a")
                          .joint(0, 2, "a")
                          .joint(1, 3, "b")
                          .mesh(0, 3, 99, 101, MeshKind::external)
                          .mesh(3, 2, 100, 100, MeshKind::external)
                          .inputs({{4, "1"}})
                          .build();
    const QString file = saved(train);
    const Run forward = run({"statics", file, "--load", "joint:5=-1Nm", "--eta", "0.98", "--json"});
    QCOMPARE(forward.status, 0);
    const json report = parsed(forward);
    QVERIFY(std::abs(report["efficiency"]["numeric"].get<double>() - 0.3380) < 1e-3);
    QCOMPARE(report["efficiency"]["backward"]["selfLocking"], true);
    const Run backward =
        run({"statics", file, "--load", "joint:4=-1Nm", "--balance", "joint:5", "--eta", "0.98"});
    QCOMPARE(backward.status, 1);
    QVERIFY(backward.errors.find("it begins below eta = 0.99)") != std::string::npos);
    QVERIFY(backward.errors.find("[self-locking]") != std::string::npos);
  }

  void whereThePowerGoes() {
    Mechanism set = test::planetary(24, 18);
    set.inputs = std::vector<Input>{{set.turningJoints[0].id, Number(100), {}},
                                    {set.turningJoints[1].id, Number(0), {}}};
    const json report = parsed(run({"statics", saved(set), "--load", "joint:5=10Nm", "--balance", "joint:6",
                                    "--balance", "joint:7", "--eta", "0.98", "--json"}));
    QCOMPARE(report["power"]["latentRatio"], "99/70");
    QCOMPARE(report["power"]["circulations"], json::array());
    QCOMPARE(report["efficiency"]["value"], "3401/3500");
    QCOMPARE(report["efficiency"]["symbolic"], "(i10*i9 + eta10*eta9)/(i10*i9 + 1)");
    QVERIFY(report["efficiency"]["backward"]["symbolic"].is_string());
    QCOMPARE(report["meshes"][0]["groundPower"]["tail"], "-1000");
    QCOMPARE(report["jointPowers"]["5"],
             json::parse(R"({"fed": "1000", "groundPower": {"tail": "0", "head": "1000"}})"));
    QCOMPARE(report["jointPowers"]["7"]["fed"], "-6802/7");
    // Of a wrist the loops are no property of the train.
    const json wrist = parsed(run({"statics", kRobot, "--load", "joint:14=10Nm", "--json"}));
    QVERIFY(wrist["power"]["circulations"].is_null());
    QVERIFY(wrist["meshes"][3]["groundPower"]["carrier"].is_string());
  }

  void tablesAsCsv() {
    Mechanism robot = test::example("robot");
    robot = *withLoad(robot, {LoadId("hand"), JointTorque{JointId("14"), Number(10)}});
    const QString file = saved(robot);
    const auto table = [&](const char* name) {
      const Run call = run({"export", file, "--to", "csv", "--matrix", name, "-o", "-"});
      if (call.status != 0) qFatal("%s: %s", name, call.errors.c_str());
      return call.output;
    };
    // The solution matrix of the kinematics, transposed and negated: (25*), its columns 10, 12, 13 and 14.
    QCOMPARE(table("statics").substr(0, table("statics").find('\n', 20)),
             std::string(",10,12,13,14\n8,0.5,0.3333333333333333,0.4444444444444444,0.2962962962962963"));
    // The columns of P: row 14 has the mesh 18 alone.
    const std::string cutsets = table("cutset-equations");
    QVERIFY(cutsets.starts_with(",15,16,17,18\n8,"));
    QVERIFY(cutsets.find("\n14,0,0,0,") != std::string::npos);
    QVERIFY(table("joint-torques").find("\n14,") != std::string::npos);
    QVERIFY(table("mesh-forces")
                .starts_with("mesh,tail,head,carrier,on tail [N m],on head [N m],tangential [N]"));
    QVERIFY(table("bearings").find("x [mm]") != std::string::npos);
    QVERIFY(table("powers").find("joint 14") != std::string::npos);
    const QString folder = m_folder.filePath("tables");
    QCOMPARE(run({"export", file, "--to", "csv", "--all", "-o", folder}).status, 0);
    for (const char* name : {"statics", "cutset-equations", "joint-torques", "coupling-torques",
                             "mesh-forces", "bearings", "powers", "circulations"})
      QVERIFY2(QFile::exists(folder + "/" + name + ".csv"), name);
    // Without a load there is nothing to hold.
    const Run none = run({"export", kRobot, "--to", "csv", "--matrix", "bearings", "-o", "-"});
    QVERIFY(none.status != 0 && none.output.empty());
    QVERIFY(none.errors.find("needs loads, and balances that hold them") != std::string::npos);
  }

  /// The shift table, and tables of one state.
  void tablesOfAGearbox() {
    Mechanism gearbox = test::eightSpeed();
    const QString file = saved(gearbox);
    const auto table = [&](QStringList words) {
      const Run call = run(QStringList{"export", file, "--to", "csv", "-o", "-", "--matrix"} + words);
      if (call.status != 0) qFatal("%s", call.errors.c_str());
      return call.output;
    };
    const std::string shift = table({"shift-torques"});
    QVERIFY2(shift.starts_with("state,A [N m],B [N m],C [N m],D [N m],E [N m],ratio,found [N m],efficiency,"
                               "backward,latent,circulating\n1,1.231884057971014"),
             shift.c_str());
    QCOMPARE(std::count(shift.begin(), shift.end(), '\n'), 10);
    // As `statics --state`: 1 N m at the drive.
    const std::string couplings = table({"coupling-torques", "--state", "1"});
    QVERIFY2(couplings.find("brake A,3") != std::string::npos &&
                 couplings.find(",1.231884057971014") != std::string::npos,
             couplings.c_str());
    QVERIFY(table({"joint-torques", "--state", "2"}).find("link 2,2") != std::string::npos);
    const QString folder = m_folder.filePath("gears");
    QCOMPARE(run({"export", file, "--to", "csv", "--all", "-o", folder}).status, 0);
    QVERIFY(QFile::exists(folder + "/shift-torques.csv"));
    const Run none = run({"export", kRobot, "--to", "csv", "--matrix", "shift-torques", "-o", "-"});
    QVERIFY(none.status != 0 && none.errors.find("needs states of a gearbox") != std::string::npos);
  }

  /// Drawings with the power under them; what cannot be drawn is rejected, and nothing is written.
  void drawingsWithPower() {
    Mechanism set = test::planetary(24, 18);
    set.inputs = std::vector<Input>{{set.turningJoints[0].id, Number(100), {}},
                                    {set.turningJoints[1].id, Number(0), {}}};
    set.balances = std::vector<HoldingTorque>{{set.turningJoints[1].id}, {set.turningJoints[2].id}};
    const QString unloaded = saved(set);
    set = *withLoad(set, {{}, JointTorque{set.turningJoints[0].id, Number(10)}});
    const QString file = saved(set);
    const auto drawn = [](const QString& of, const QString& view, const QString& observer) {
      return run({"export", of, "--to", "svg", "--view", view, "--power", observer, "-o", "-"});
    };
    for (const char* view : {"digraph", "schematic"}) {
      const Run call = drawn(file, view, "ground");
      QCOMPARE(call.status, 0);
      for (const char* text : {">1000 W<", ">T 10 N m<", ">seen from the ground<"})
        QVERIFY2(call.output.find(text) != std::string::npos, text);
      QVERIFY(drawn(file, view, "3").output.find(">seen from link 3<") != std::string::npos);
      QVERIFY(run({"export", file, "--to", "svg", "--view", view, "-o", "-"}).output.find(" W<") ==
              std::string::npos);
    }
    QCOMPARE(drawn(file, "schematic", "99").status, 2);
    QCOMPARE(drawn(file, "ttgraph", "ground").status, 2);
    const Run none = drawn(unloaded, "digraph", "ground");
    QCOMPARE(none.status, 1);
    QVERIFY(none.output.empty() &&
            none.errors.find("needs loads: this document has none") != std::string::npos);
    // What nothing holds is named.
    Mechanism open = set;
    open.balances = std::vector<HoldingTorque>{{set.turningJoints[1].id}};
    const Run unheld = drawn(saved(open), "digraph", "ground");
    QCOMPARE(unheld.status, 1);
    QVERIFY2(unheld.output.empty() && unheld.errors.find("[unbalanced]") != std::string::npos &&
                 unheld.errors.find("needs balances that hold the loads") != std::string::npos,
             unheld.errors.c_str());
    const Mechanism shared =
        *withLoad(test::example("three-planets"), {{}, JointTorque{JointId("7"), Number(1)}});
    // Where no force is determined the train is shown, and the picture says why there is none.
    const auto in3d = [&](const QString& document, const char* form) {
      return run({"export", document, "--to", form, "--view", "3d", "--show", "forces", "-o", "-"});
    };
    const Run open3d = in3d(saved(shared), "png");
    QCOMPARE(open3d.status, 0);
    QVERIFY(open3d.output.starts_with("\x89PNG"));
    QVERIFY2(
        open3d.errors.find("[statically-indeterminate]") != std::string::npos &&
            open3d.errors.find("--show forces: Not drawn, as shared in unknown parts: forces at meshes") !=
                std::string::npos,
        open3d.errors.c_str());
    const Run still = in3d(unloaded, "png");
    QCOMPARE(still.status, 0);
    QVERIFY(still.output.starts_with("\x89PNG") &&
            still.errors.find("--show forces: No forces without loads") != std::string::npos);
    // The caption is in the picture: without --show forces it is another one.
    QVERIFY(still.output != run({"export", unloaded, "--to", "png", "--view", "3d", "-o", "-"}).output);
    // So with power.
    const auto power3d = [&](const QString& document, const char* shown) {
      return run({"export", document, "--to", "png", "--view", "3d", "--show", shown, "-o", "-"});
    };
    const Run powered = power3d(saved(set), "power");
    QVERIFY2(powered.status == 0 && powered.errors.find("--show power") == std::string::npos,
             powered.errors.c_str());
    QVERIFY(powered.output.starts_with("\x89PNG") && powered.output != power3d(saved(set), "labels").output);
    QVERIFY(power3d(unloaded, "power").errors.find("--show power: No power without loads") !=
            std::string::npos);
    // What nothing holds is an error of the document: the picture is written all the same.
    const Run loose = in3d(saved(open), "png");
    QCOMPARE(loose.status, 1);
    QVERIFY(loose.output.starts_with("\x89PNG") && loose.errors.find("[unbalanced]") != std::string::npos &&
            loose.errors.find("the loads are not in balance") != std::string::npos);
  }

  /// Of every example under a load in each of its joints: two drawings, or a sentence that says why there is
  /// none. Where the meshes share the load in unknown parts, too.
  void powerOfAllExamples() {
    int drawings = 0;
    for (const std::string& name : test::exampleNames()) {
      const Mechanism plain = test::example(name);
      if (!plain.inputs) continue;
      for (std::size_t joint = 0; joint < plain.turningJoints.size(); ++joint) {
        const JointId id = plain.turningJoints[joint].id;
        const auto loaded = withLoad(plain, {{}, JointTorque{id, Number(-10)}});
        QVERIFY(loaded.has_value());
        const QString file = saved(*loaded);
        const json report = parsed(run({"statics", file, "--json"}));
        const json& power = report["power"];
        const bool flows = power.is_object() && !power["input"].is_null() && power["input"] != "0";
        const QByteArray which = QByteArray::fromStdString(name + ", joint " + id.text());
        for (const char* view : {"digraph", "schematic"}) {
          const Run call =
              run({"export", file, "--to", "svg", "--view", view, "--power", "ground", "-o", "-"});
          const bool isDrawn = call.output.find(">seen from the ground<") != std::string::npos;
          const bool isExplained = call.errors.find("Nothing was written.") != std::string::npos;
          QVERIFY2(isDrawn != isExplained && (isDrawn || !flows), which);
          drawings += flows ? 1 : 0;
        }
      }
    }
    QVERIFY2(drawings > 60, qPrintable(QString::number(drawings)));
  }

  /// What a document may not say: each is rejected with the place, none crashes or is read as something else.
  void documentsThatCannotBe() {
    const json robot = json::parse(writeMechanism(test::example("robot")));
    const auto rejected = [&](const json& document, const char* why) {
      const QString path = m_folder.filePath(QString::number(m_next++) + ".geargraph");
      QFile file(path);
      if (!file.open(QIODevice::WriteOnly)) qFatal("no file");
      file.write(QByteArray::fromStdString(document.dump()));
      file.close();
      const Run call = run({"statics", path, "--json"});
      QVERIFY2(call.status == 1, why);
      const json report = parsed(call);
      QVERIFY2(report["meshes"].is_null() && !codesOf(report).empty(), why);
      QVERIFY2(codesOf(report).contains("schema") || codesOf(report).contains("unknown-id"), why);
    };
    const auto withLoad = [&](const json& load) {
      json document = robot;
      document["loads"] = json::array({load});
      return document;
    };
    rejected(withLoad({{"link", "0"}, {"torque", 1}}), "a torque on the ground");
    rejected(withLoad({{"link", "0"}, {"force", {1, 2, 3}}, {"point", {0, 0, 0}}}), "a force on the ground");
    rejected(withLoad({{"link", "99"}, {"torque", 1}}), "a link that is not there");
    rejected(withLoad({{"joint", "99"}, {"torque", 1}}), "a joint that is not there");
    rejected(withLoad({{"joint", "14"}}), "nothing");
    rejected(withLoad({{"joint", "14"}, {"torque", "much"}}), "no number");
    rejected(withLoad({{"link", "3"}, {"force", {1, 2}}, {"point", {0, 0, 0}}}), "two components");
    rejected(withLoad({{"joint", "14"}, {"link", "3"}, {"torque", 1}}), "two places");
    for (const json& eta : {json(0), json(-1), json("101/100"), json("none"), json(nullptr)}) {
      json document = robot;
      document["gearMeshes"][0]["efficiency"] = eta;
      rejected(document, eta.dump().c_str());
      document = robot;
      document["gearDefaults"]["efficiency"] = eta;
      rejected(document, eta.dump().c_str());
    }
    json document = robot;
    document["gearMeshes"][0]["friction"] = 2;
    rejected(document, "friction above 1");
    document["gearMeshes"][0]["friction"] = "1/10";
    document["gearMeshes"][0]["efficiency"] = "9/10";
    rejected(document, "both");
    document = robot;
    document["balances"] = json::array({{{"link", "0"}}});
    rejected(document, "a balance on the ground");
  }

  /// A unit without a size: torques are there, forces are not.
  void aUnitThatDoesNotExist() {
    Mechanism robot = test::example("robot");
    robot.unit = "furlong";
    const Run call = run({"statics", saved(robot), "--load", "joint:14=10Nm", "--json"});
    QCOMPARE(call.status, 0);
    const json report = parsed(call);
    QVERIFY(codesOf(report).contains("unknown-unit"));
    QCOMPARE(report["balances"][0]["torque"], "80/27");
    QVERIFY(report["bearings"].is_null());
    QVERIFY(report["meshes"][0]["tangentialForce"].is_null());
    QVERIFY(report["meshes"][0]["groundPower"]["tail"].is_string());
  }

  void wordsThatAreNoLoads() {
    for (const char* load : {"joint:99=10Nm", "link:9=10Nm", "link:0=10Nm", "link:3@q=10Nm", "joint:14=10",
                             "joint:14=10lbf", "joint:14", "14=10Nm", "link:3=1,2N@0,0,0", "link:3=1,2,3N",
                             "joint:14=1,2,3N@0,0,0", "joint:14=1/0Nm"}) {
      const Run call = run({"statics", kRobot, "--load", load});
      QVERIFY2(call.status == 2, load);
      QVERIFY(call.errors.find("Usage") != std::string::npos);
    }
    for (const char* eta : {"0", "-1", "1.01", "much"})
      QCOMPARE(run({"statics", kRobot, "--eta", eta}).status, 2);
    QCOMPARE(run({"statics", kRobot, "--share", "evenly"}).status, 2);
    QCOMPARE(run({"statics", kRobot, "--state", "1"}).status, 2);
    QCOMPARE(run({"statics", kRobot, "--balance", "joint:8", "--balance", "joint:8"}).status, 2);
    QCOMPARE(run({"statics"}).status, 2);
  }

  void textForPeople() {
    const Run call = run({"statics", kRobot, "--load", "joint:14=10Nm"});
    QCOMPARE(call.status, 0);
    for (const char* part : {"joint 8", "80/27 (2.96296)", "Bearings", "Both methods agree."})
      QVERIFY2(call.output.find(part) != std::string::npos, part);
  }

  void aDocumentWithErrorsHasNoNumbers() {
    const Run call = run({"statics", QString::fromStdString(test::examplePath("robot-to-mend")), "--json"});
    QCOMPARE(call.status, 1);
    QVERIFY(parsed(call)["balances"].is_null());
    // Inputs that cannot be, too; in a state they do not count.
    const Run inputs = run({"statics", kRobot, "--inputs", "8,9", "--load", "joint:14=1Nm", "--json"});
    QCOMPARE(inputs.status, 1);
    QVERIFY(parsed(inputs)["balances"].is_null());
  }

 private:
  QString saved(const Mechanism& mechanism) {
    const QString path = m_folder.filePath(QString::number(m_next++) + ".geargraph");
    QFile file(path);
    if (!file.open(QIODevice::WriteOnly)) qFatal("no file");
    file.write(QByteArray::fromStdString(writeMechanism(mechanism)));
    return path;
  }

  QTemporaryDir m_folder;
  int m_next = 0;
};

QTEST_GUILESS_MAIN(CliStaticsTest)
#include "test_cli_statics.moc"

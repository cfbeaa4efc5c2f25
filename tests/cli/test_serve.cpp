#include <QDir>
#include <QFile>
#include <QProcess>
#include <QTemporaryDir>
#include <QTest>
#include <algorithm>
#include <cctype>
#include <nlohmann/json.hpp>
#include <set>
#include <utility>

using nlohmann::json;

namespace {

constexpr int kPatience = 60'000;  // ms

/// `geargraph-cli serve --stdio`, asked line by line.
class Served {
 public:
  explicit Served(const QStringList& options = {}) {
    m_program.start(GEARGRAPH_CLI, QStringList{"serve", "--stdio"} + options);
  }
  ~Served() {
    m_program.closeWriteChannel();
    m_program.waitForFinished(kPatience);
  }

  json ask(const std::string& line) {
    m_program.write(QByteArray::fromStdString(line + '\n'));
    while (!m_program.canReadLine()) {
      if (!m_program.waitForReadyRead(kPatience)) return {};
    }
    const QByteArray answer = m_program.readLine();
    return json::parse(answer.constData(), nullptr, false);
  }
  json ask(const std::string& method, const json& params) {
    return ask(json{{"id", ++m_asked}, {"method", method}, {"params", params}}.dump());
  }
  /// Opens a document; its number.
  std::string open(const json& text) { return ask("open", {{"text", text}}).at("result").at("document"); }

  QProcess& program() { return m_program; }

 private:
  QProcess m_program;
  int m_asked = 0;
};

json exampleDocument(const char* name) {
  QFile file(QString(SOURCE) + "/resources/examples/" + name + ".geargraph");
  if (!file.open(QIODevice::ReadOnly)) return {};
  return json::parse(file.readAll().constData());
}

json robot() {
  return exampleDocument("robot");
}

/// The edits that make a document of an empty one.
json editsMaking(const json& document) {
  json edits = json::array();
  const auto edit = [&](const char* name, json members) {
    members["edit"] = name;
    edits.push_back(std::move(members));
  };
  json whole = json::object();
  for (const char* const member : {"name", "notes", "unit", "gearDefaults", "density", "gravity"})
    if (document.contains(member)) whole[member] = document.at(member);
  edit("setDocument", whole);
  for (std::size_t i = 1; i < document.at("links").size(); ++i) edit("addLink", document.at("links").at(i));
  const std::pair<const char*, const char*> lists[] = {
      {"axes", "addAxis"},           {"turningJoints", "addTurningJoint"}, {"wheels", "addWheel"},
      {"gearMeshes", "addGearMesh"}, {"couplings", "addCoupling"},         {"states", "addState"},
      {"loads", "addLoad"}};
  for (const auto& [list, name] : lists) {
    for (const json& element : document.value(list, json::array())) edit(name, element);
  }
  if (document.contains("inputs")) edit("setInputs", {{"inputs", document.at("inputs")}});
  if (document.contains("balances")) edit("setDocument", {{"balances", document.at("balances")}});
  if (document.contains("engaged")) edit("engage", {{"couplings", document.at("engaged")}});
  return edits;
}

QByteArray printed(const QStringList& words) {
  QProcess program;
  program.start(GEARGRAPH_CLI, words);
  program.waitForFinished(kPatience);
  return program.readAllStandardOutput();
}

}  // namespace

class ServeTest : public QObject {
  Q_OBJECT

 private slots:
  void answersAreThoseOfTheCommandLine() {
    Served served;
    const std::string document = served.open(robot());
    for (const char* command : {"analyze", "validate", "inputs", "pose"}) {
      const json answer = served.ask(command, {{"document", document}, {"arguments", {"--json"}}});
      QCOMPARE(answer.at("result").at("status").get<int>(), 0);
      const QByteArray alone =
          printed({command, QString(SOURCE) + "/resources/examples/robot.geargraph", "--json"});
      QVERIFY(answer.at("result").at("output") == json::parse(alone.constData()));
    }
  }

  /// Wishes are members of requests; the answers are the bytes that the command line writes for their files.
  void designIsServed() {
    Served served;
    const auto fromFile = [](const char* name) {
      QFile file(QString(SOURCE) + "/tests/golden/files/" + name);
      return file.open(QIODevice::ReadOnly) ? json::parse(file.readAll().constData()) : json();
    };
    const auto path = [](const char* name) { return QString(SOURCE) + "/tests/golden/files/" + name; };
    for (const auto& [command, wish] :
         {std::pair("gearbox", "gearbox.wish.json"), std::pair("hardware", "hardware.wish.json")}) {
      const json answer = served.ask(command, {{"wish", fromFile(wish)}, {"arguments", {"--json"}}});
      QVERIFY2(answer.contains("result"), answer.dump().c_str());
      QCOMPARE(answer.at("result").at("status").get<int>(), 0);
      QVERIFY(answer.at("result").at("output") ==
              json::parse(printed({command, path(wish), "--json"}).constData()));
    }
    const std::string simpson = served.open(exampleDocument("simpson"));
    const QString file = QString(SOURCE) + "/resources/examples/simpson.geargraph";
    const json identity = served.ask("identify", {{"document", simpson},
                                                  {"with", served.open(exampleDocument("simpson"))},
                                                  {"arguments", {"--json"}}});
    QCOMPARE(identity.at("result").at("output").at("chains"),
             json::parse(printed({"identify", file, "--json"}).constData()).at("chains"));
    QVERIFY(identity.at("result").at("output").contains("with"));
    const json chain = served.ask("atlas", {{"number", "4-1.1.2"}, {"arguments", {"-o", "-"}}});
    QCOMPARE(chain.at("result").at("output").at("format"), json("geargraph"));
    const json list = served.ask("atlas", {{"arguments", {"--links", "4", "--json"}}});
    QCOMPARE(list.at("result").at("output").at("displacementCount"), json(3));
    const std::string train = served.open(fromFile("two-ring.geargraph"));
    const json teeth = served.ask(
        "teeth", {{"document", train}, {"wish", fromFile("two-ring-wish.json")}, {"arguments", {"--json"}}});
    QCOMPARE(teeth.at("result").at("output"),
             json::parse(printed({"teeth", path("two-ring.geargraph"), path("two-ring-wish.json"), "--json"})
                             .constData()));
  }

  void servedDesignReachesNoFiles() {
    Served served;
    const auto codeOf = [&](const char* method, const json& params) {
      return served.ask(method, params).at("error").at("code").get<std::string>();
    };
    const json wish{{"ratios", {"0.75", "1"}}};
    const std::string document = served.open(robot());
    QCOMPARE(codeOf("gearbox", {{"wish", wish}, {"arguments", {"--shard", "0/2"}}}), std::string("request"));
    QCOMPARE(codeOf("gearbox", {{"wish", wish}, {"arguments", {"-o", "folder"}}}), std::string("request"));
    QCOMPARE(
        codeOf("teeth", {{"document", document}, {"wish", wish}, {"arguments", {"--certificate", "file"}}}),
        std::string("request"));
    QCOMPARE(codeOf("identify", {{"document", document}, {"arguments", {"--with", "/etc/hostname"}}}),
             std::string("request"));
    QCOMPARE(codeOf("identify", {{"document", document}, {"with", "99"}}), std::string("unknown-document"));
    QCOMPARE(codeOf("atlas", {{"arguments", {"--file=/etc/hostname"}}}), std::string("request"));
    QCOMPARE(codeOf("atlas", {{"number", "--file"}}), std::string("request"));
    QCOMPARE(codeOf("hardware", {{"wish", "file"}}), std::string("request"));
    QCOMPARE(codeOf("hardware", {{"wish", wish}, {"document", document}}), std::string("request"));
  }

  void tablesAreOpened() {
    Served served;
    const QByteArray table =
        printed({"convert", QString(SOURCE) + "/resources/examples/robot.geargraph", "--to", "csv"});
    QVERIFY(table.startsWith("element,"));
    const std::string opened = served.open(table.toStdString());
    const json back = served.ask("text", {{"document", opened}}).at("result").at("text");
    QCOMPARE(json::parse(back.get<std::string>()).at("gearMeshes"), robot().at("gearMeshes"));
    const json wrong = served.ask("open", {{"text", "element,label\nturningJoint,a\n"}});
    QCOMPARE(wrong.at("error").at("code"), json("schema"));
  }

  void graphsAreOpened() {
    Served served;
    for (const char* const form : {"dot", "graphml", "node-link"}) {
      const QByteArray graph =
          printed({"convert", QString(SOURCE) + "/resources/examples/robot.geargraph", "--to", form});
      const json opened = served.ask("open", {{"text", graph.toStdString()}}).at("result");
      QVERIFY(!opened.contains("notes"));
      const json back = served.ask("text", {{"document", opened.at("document")}}).at("result").at("text");
      QCOMPARE(json::parse(back.get<std::string>()).at("gearMeshes"), robot().at("gearMeshes"));
    }
    const json assumed =
        served.ask("open", {{"text", "digraph { a -> b [kind=turning, axis=x] }"}}).at("result");
    QCOMPARE(assumed.at("notes").size(), std::size_t{2});
    const json wrong = served.ask("open", {{"text", "digraph { a -> b }"}});
    QCOMPARE(wrong.at("error").at("code"), json("schema"));
    QCOMPARE(wrong.at("error").at("diagnostics").at(0).at("column"), json(11));
  }

  void textsAndBytesAreExported() {
    Served served;
    const std::string document = served.open(robot().dump());
    const auto exported = [&](const json& words) {
      return served.ask("export", {{"document", document}, {"arguments", words}}).at("result");
    };
    const json csv = exported({"--to", "csv", "--matrix", "p", "-o", "-"});
    QVERIFY(csv.at("output").get<std::string>().starts_with(",8,9,10"));
    const json png = exported({"--to", "png", "--view", "digraph", "-o", "-"});
    const QByteArray bytes =
        QByteArray::fromBase64(QByteArray::fromStdString(png.at("base64").get<std::string>()));
    QVERIFY(bytes.startsWith("\x89PNG") && bytes.contains("IEND"));
  }

  void aFolderComesAsFiles() {
    QTemporaryDir place;  // of what the program keeps until it answers
    const QByteArray before = qgetenv("TMPDIR");
    qputenv("TMPDIR", place.path().toUtf8());
    Served served;
    before.isNull() ? qunsetenv("TMPDIR") : qputenv("TMPDIR", before);
    const std::string document = served.open(exampleDocument("spur-pair").dump());
    const auto ask = [&](const json& words) {
      return served.ask("export", {{"document", document}, {"arguments", words}});
    };
    const json kit = ask({"--to", "kit", "--play", "0.2", "-o", "-"}).at("result");
    QCOMPARE(kit.at("status"), json(0));
    QCOMPARE(kit.at("output"), json(""));
    std::set<std::string> names;
    for (const json& file : kit.at("files")) {
      const std::string name = file.at("name");
      names.insert(name);
      if (name == "assembly.html")
        QVERIFY(file.at("text").get<std::string>().find("0.2") != std::string::npos);
      if (name == "plate-1.3mf") {
        const auto bytes =
            QByteArray::fromBase64(QByteArray::fromStdString(file.at("base64").get<std::string>()));
        QVERIFY(bytes.startsWith("PK"));
      }
    }
    QCOMPARE(names, (std::set<std::string>{"assembly.3mf", "assembly.html", "plate-1.3mf"}));
    // Files in folders of their own.
    const json model = ask({"--to", "urdf", "-o", "-"}).at("result");
    QVERIFY(std::any_of(model.at("files").begin(), model.at("files").end(), [](const json& file) {
      return file.at("name").get<std::string>().find('/') != std::string::npos;
    }));
    // All of them or none: the plate is too small for the wheel.
    const json small = ask({"--to", "kit", "--bed", "50x50", "--scale", "3", "-o", "-"}).at("result");
    QCOMPARE(small.at("status"), json(3));
    QVERIFY(!small.contains("files"));
    QVERIFY(small.at("messages").get<std::string>().find("does not fit the plate") != std::string::npos);
    QCOMPARE(ask({"--to", "kit"}).at("error").at("code"), json("request"));
    QCOMPARE(ask({"--to", "kit", "-o", "/tmp/kit"}).at("error").at("code"), json("request"));
    QVERIFY(QDir(place.path()).isEmpty());  // nothing is left
  }

  void editsAreMadeTogetherOrNotAtAll() {
    Served served;
    const std::string document = served.open(
        {{"format", "geargraph"}, {"version", 1}, {"links", {{{"id", "0"}, {"name", "ground"}}}}});
    const json made = served.ask(
        "edit",
        {{"document", document},
         {"edits",
          {{{"edit", "addLink"}, {"name", "pinion"}},
           {{"edit", "addLink"}, {"name", "wheel"}},
           {{"edit", "addTurningJoint"}, {"tail", "0"}, {"head", "1"}},
           {{"edit", "addTurningJoint"}, {"tail", "0"}, {"head", "2"}},
           {{"edit", "addGearMesh"}, {"tail", "1"}, {"head", "2"}, {"tailTeeth", 18}, {"headTeeth", 36}}}}});
    QVERIFY(made.at("result").at("added").at("links") == json({"1", "2"}));
    const json before = served.ask("text", {{"document", document}});
    const json rejected = served.ask(
        "edit",
        {{"document", document},
         {"edits", {{{"edit", "addLink"}}, {{"edit", "addTurningJoint"}, {"tail", "1"}, {"head", "1"}}}}});
    QCOMPARE(rejected.at("error").at("code").get<std::string>(), std::string("self-joint"));
    QCOMPARE(rejected.at("error").at("diagnostics").at(0).at("pointer").get<std::string>(),
             std::string("/params/edits/1"));
    QVERIFY(served.ask("text", {{"document", document}}).at("result") == before.at("result"));
    const json speeds = served.ask("analyze", {{"document", document}, {"arguments", {"--json"}}});
    QCOMPARE(speeds.at("result").at("output").at("solution").at("exact").at(0).at(0).get<std::string>(),
             std::string("-1/2"));
  }

  void aSplitLinkIsWeldedAgain() {
    Served served;
    const std::string document = served.open(robot());
    const auto solution = [&] {
      const json answer = served.ask("analyze", {{"document", document}, {"arguments", {"--json"}}});
      return answer.at("result").at("output").at("solution");
    };
    const auto edited = [&](json edit) {
      return served.ask("edit", {{"document", document}, {"edits", json::array({std::move(edit)})}});
    };
    const json before = solution();
    const json split = edited({{"edit", "splitLink"}, {"link", "2"}, {"gearMeshes", json::array({"16"})}});
    QVERIFY(split.contains("result"));
    QVERIFY(solution() != before);
    const json part = split.at("result").at("added").at("links").at(0);
    QVERIFY(edited({{"edit", "mergeLinks"}, {"link", "2"}, {"other", part}}).contains("result"));
    QVERIFY(solution() == before);
  }

  void everyEditCanBeMadeAndRejected_data() {
    QTest::addColumn<QString>("edit");
    QTest::addColumn<QString>("code");
    const auto row = [](const char* name, const char* edit, const char* code = "") {
      QTest::newRow(name) << QString(edit) << QString(code);
    };
    row("remove", R"({"edit": "remove", "gearMeshes": ["18"], "links": ["3"]})");
    row("remove the ground", R"({"edit": "remove", "links": ["0"]})", "schema");
    row("setTeeth", R"({"edit": "setTeeth", "mesh": "15", "tailTeeth": 9, "headTeeth": 18})");
    row("setTeeth of none", R"({"edit": "setTeeth", "mesh": "99", "tailTeeth": 9, "headTeeth": 18})",
        "unknown-id");
    row("setTeeth without", R"({"edit": "setTeeth", "mesh": "15"})", "schema");
    row("setPitchPoint", R"({"edit": "setPitchPoint", "mesh": "15", "point": null})");
    row("setAxis", R"({"edit": "setAxis", "axis": "a", "point": ["1/3", 0, 0], "direction": [0, 0, 1]})");
    row("setAxis of two", R"({"edit": "setAxis", "axis": "a", "point": [0, 0]})", "schema");
    row("setInputs", R"({"edit": "setInputs", "inputs": [{"joint": "8", "speed": "1/2"}]})");
    row("setInputs of none", R"({"edit": "setInputs", "inputs": [{"joint": "8"}]})", "schema");
    row("engage", R"({"edit": "engage", "couplings": []})");
    row("engage none", R"({"edit": "engage", "couplings": ["Z"]})", "unknown-id");
    row("rename", R"({"edit": "rename", "link": "3", "name": "hand"})");
    row("mergeLinks of one", R"({"edit": "mergeLinks", "link": "3", "other": "3"})", "self-joint");
    row("mergeLinks of none", R"({"edit": "mergeLinks", "link": "3", "other": "99"})", "unknown-id");
    row("mergeLinks of gears in mesh", R"({"edit": "mergeLinks", "link": "5", "other": "2"})", "self-joint");
    row("mergeLinks on two axes", R"({"edit": "mergeLinks", "link": "3", "other": "6"})", "turning-loop");
    row("mergeLinks without", R"({"edit": "mergeLinks", "link": "3"})", "schema");
    row("splitLink", R"({"edit": "splitLink", "link": "2", "gearMeshes": ["16"]})");
    row("splitLink of none", R"({"edit": "splitLink", "link": "99", "gearMeshes": ["16"]})", "unknown-id");
    row("splitLink of the ground", R"({"edit": "splitLink", "link": "0"})", "schema");
    row("addAxis", R"({"edit": "addAxis", "point": [0, 0, 1], "direction": [1, 0, 0], "pinned": true})");
    row("addAxis of a point", R"({"edit": "addAxis", "point": 7})", "schema");
    row("addGearMesh of a kind",
        R"({"edit": "addGearMesh", "tail": "1", "head": "2", "tailTeeth": 9, "headTeeth": 18, "kind": "friction"})",
        "schema");
    row("addWheel", R"({"edit": "addWheel", "id": "7'", "link": "7", "bore": 8})");
    row("addWheel on none", R"({"edit": "addWheel", "link": "99"})", "unknown-id");
    row("addCoupling", R"({"edit": "addCoupling", "kind": "clutch", "links": ["1", "4"]})");
    row("addCoupling of the ground", R"({"edit": "addCoupling", "kind": "brake", "link": "0"})", "schema");
    row("addCoupling with links of a clutch",
        R"({"edit": "addCoupling", "kind": "brake", "link": "1", "links": ["1", "4"]})", "schema");
    row("addCoupling of one", R"({"edit": "addCoupling", "kind": "clutch", "links": ["1"]})", "schema");
    row("addState", R"({"edit": "addState", "drive": "1", "driven": "7"})");
    row("addState of none", R"({"edit": "addState", "engaged": ["Z"]})", "unknown-id");
    row("addLoad", R"({"edit": "addLoad", "joint": "14", "torque": "-5/2"})");
    row("addLoad of a force",
        R"({"edit": "addLoad", "link": "3", "force": [0, 0, -20], "point": [0, 40, 132]})");
    row("addLoad without", R"({"edit": "addLoad", "joint": "14"})", "schema");
    row("addLoad on the ground", R"({"edit": "addLoad", "link": "0", "torque": 1})", "schema");
    row("setLink", R"({"edit": "setLink", "link": "3", "mass": 0.2, "centerOfMass": [0, 0, 1]})");
    row("setLink of a mass below 0", R"({"edit": "setLink", "link": "3", "mass": -1})", "schema");
    row("setLink of none", R"({"edit": "setLink", "link": "99", "mass": 1})", "unknown-id");
    row("setTurningJoint",
        R"({"edit": "setTurningJoint", "joint": "8", "limits": [-170, null], "offset": "1/3"})");
    row("setTurningJoint beyond", R"({"edit": "setTurningJoint", "joint": "8", "limits": [10, 20]})",
        "schema");
    row("setGearMesh", R"({"edit": "setGearMesh", "mesh": "15", "efficiency": 0.9, "kind": null})");
    row("setGearMesh without teeth", R"({"edit": "setGearMesh", "mesh": "15", "tailTeeth": null})", "schema");
    row("setGearMesh of two losses",
        R"({"edit": "setGearMesh", "mesh": "15", "efficiency": 0.9, "friction": 0.1})", "schema");
    row("setDocument",
        R"({"edit": "setDocument", "density": 2700, "gravity": [0, 0, "-981/100"], "unit": null})");
    row("setDocument of a density", R"({"edit": "setDocument", "density": "heavy"})", "schema");
    row("setState of none", R"({"edit": "setState", "state": "9", "engaged": []})", "unknown-id");
    row("engageState of none", R"({"edit": "engageState", "state": "9"})", "unknown-id");
    row("remove a state of none", R"({"edit": "remove", "states": ["9"]})", "unknown-id");
    row("no edit", R"({"edit": "paint"})", "schema");
    row("a number", "7", "schema");
  }
  void everyEditCanBeMadeAndRejected() {
    QFETCH(QString, edit);
    QFETCH(QString, code);
    Served served;
    const std::string document = served.open(robot());
    const json answer = served.ask(
        "edit", {{"document", document}, {"edits", json::array({json::parse(edit.toStdString())})}});
    QCOMPARE(answer.contains("result"), code.isEmpty());
    if (!code.isEmpty())
      QCOMPARE(QString::fromStdString(answer.at("error").at("code").get<std::string>()), code);
  }

  void membersThatAreNotKnownAreRejectedByName_data() {
    QTest::addColumn<QString>("edit");
    QTest::addColumn<QString>("message");
    const auto row = [](const char* edit, const char* message) {
      QTest::newRow(edit) << QString(edit) << QString(message);
    };
    row(R"({"edit": "addGearMesh", "tail": "1", "head": "2", "tailTeeth": 9, "headTeeth": 18, "knid": "internal"})",
        R"("addGearMesh" has no member "knid". Is "kind" meant?)");
    row(R"({"edit": "setGearMesh", "mesh": "15", "efficency": 0.9})",
        R"("setGearMesh" has no member "efficency". Is "efficiency" meant?)");
    row(R"({"edit": "setTurningJoint", "joint": "8", "limit": [-1, 1]})",
        R"("setTurningJoint" has no member "limit". Is "limits" meant?)");
    row(R"({"edit": "setTeeth", "mesh": "15", "tail_teeth": 9, "headTeeth": 18})",
        R"("setTeeth" has no member "tail_teeth". Is "tailTeeth" meant?)");
    row(R"({"edit": "rename", "link": "3", "name": "hand", "colour": "red"})",
        R"("rename" has no member "colour".)");
    row(R"({"edit": "remove", "gearMesh": ["15"]})",
        R"("remove" has no member "gearMesh". Is "gearMeshes" meant?)");
    row(R"({"edit": "addLoad", "joint": "14", "torque": 1, "axis": "a"})",
        R"(/params/edits/0/axis: the member "axis" has no meaning here.)");
  }
  void membersThatAreNotKnownAreRejectedByName() {
    QFETCH(QString, edit);
    QFETCH(QString, message);
    Served served;
    const std::string document = served.open(robot());
    const json before = served.ask("text", {{"document", document}});
    const json answer = served.ask(
        "edit", {{"document", document}, {"edits", json::array({json::parse(edit.toStdString())})}});
    QCOMPARE(QString::fromStdString(answer.at("error").at("message").get<std::string>()), message);
    QVERIFY(answer.at("error")
                .at("diagnostics")
                .at(0)
                .at("pointer")
                .get<std::string>()
                .starts_with("/params/edits/0"));
    QVERIFY(served.ask("text", {{"document", document}}).at("result") == before.at("result"));
  }

  void membersOfRequestsThatAreNotKnownAreRejectedByName() {
    Served served;
    const std::string document = served.open(robot());
    const auto messageOf = [](const json& answer) {
      return answer.at("error").at("message").get<std::string>();
    };
    QCOMPARE(messageOf(served.ask("analyze", {{"document", document}, {"argument", {"--json"}}})),
             std::string(R"("analyze" has no member "argument". Is "arguments" meant?)"));
    QCOMPARE(messageOf(served.ask("open", {{"txt", "{}"}})),
             std::string(R"("open" has no member "txt". Is "text" meant?)"));
    QCOMPARE(
        messageOf(served.ask(json{
            {"id", 1}, {"method", "analyze"}, {"params", {{"document", document}}}, {"arguments", {"--json"}}}
                                 .dump())),
        std::string(R"("A request" has no member "arguments".)"));
    QVERIFY(served.ask(json{{"jsonrpc", "2.0"}, {"id", 1}, {"method", "help"}}.dump()).contains("result"));
  }

  void gearboxesAreBuiltByRequests_data() {
    QTest::addColumn<QString>("name");
    for (const char* const name :
         {"simpson", "ravigneaux", "eight-speed-gearbox", "robot", "bevel-differential", "three-planets"})
      QTest::newRow(name) << QString(name);
  }
  /// Edit for edit the same document, but for the places of nodes; and the same analysis.
  void gearboxesAreBuiltByRequests() {
    QFETCH(QString, name);
    json original = exampleDocument(name.toUtf8().constData());
    original.erase("view");
    original["loads"] = {{{"id", "L1"}, {"link", original.at("links").at(1).at("id")}, {"torque", "10/3"}}};
    original["links"][1]["mass"] = 0.25;
    original["gravity"] = {0, 0, -9.81};
    Served served;
    const std::string built =
        served.open({{"format", "geargraph"}, {"version", 1}, {"links", {original.at("links").at(0)}}});
    const json made = served.ask("edit", {{"document", built}, {"edits", editsMaking(original)}});
    QVERIFY2(made.contains("result"), made.dump().c_str());
    QCOMPARE(made.at("result").at("added").at("gearMeshes").size(), original.at("gearMeshes").size());
    QCOMPARE(made.at("result").at("added").value("states", json::array()).size(),
             original.value("states", json::array()).size());
    const json text = served.ask("text", {{"document", built}}).at("result").at("text");
    QCOMPARE(json::parse(text.get<std::string>()), original);
    const std::string drawn = served.open(original);
    for (const char* const command : {"analyze", "states", "statics", "dynamics"}) {
      const auto answer = [&](const std::string& document) {
        return served.ask(command, {{"document", document}, {"arguments", {"--json"}}}).at("result");
      };
      const json expected = answer(drawn);
      QVERIFY(expected.at("output").is_object());
      QVERIFY2(answer(built) == expected, command);
    }
  }

  void kindsOfNewMeshesCount() {
    Served served;
    for (const auto& [kind, expected] : {std::pair{"external", "-1/3"}, std::pair{"internal", "1/3"}}) {
      const std::string document =
          served.open({{"format", "geargraph"}, {"version", 1}, {"links", {{{"id", "0"}}}}});
      const json made = served.ask("edit", {{"document", document},
                                            {"edits",
                                             {{{"edit", "addLink"}},
                                              {{"edit", "addLink"}},
                                              {{"edit", "addTurningJoint"}, {"tail", "0"}, {"head", "1"}},
                                              {{"edit", "addTurningJoint"}, {"tail", "0"}, {"head", "2"}},
                                              {{"edit", "addGearMesh"},
                                               {"tail", "1"},
                                               {"head", "2"},
                                               {"tailTeeth", 20},
                                               {"headTeeth", 60},
                                               {"kind", kind}}}}});
      QVERIFY2(made.contains("result"), made.dump().c_str());
      const json speeds = served.ask("analyze", {{"document", document}, {"arguments", {"--json"}}});
      QCOMPARE(speeds.at("result").at("output").at("solution").at("exact").at(0).at(0).get<std::string>(),
               std::string(expected));
    }
  }

  void membersAreReplacedAndRemoved() {
    Served served;
    json original = robot();
    original["gearMeshes"][0]["finish"] = "ground";  // of another program
    const std::string document = served.open(original);
    const auto meshAfter = [&](const json& edit) {
      const json answer = served.ask("edit", {{"document", document}, {"edits", {edit}}});
      if (!answer.contains("result")) return answer;
      const json text = served.ask("text", {{"document", document}}).at("result").at("text");
      return json(json::parse(text.get<std::string>()).at("gearMeshes").at(0));
    };
    json expected = original.at("gearMeshes").at(0);
    expected["friction"] = "1/20";
    expected.erase("faceWidth");
    QCOMPARE(
        meshAfter({{"edit", "setGearMesh"}, {"mesh", "15"}, {"friction", "1/20"}, {"faceWidth", nullptr}}),
        expected);
    expected.erase("friction");
    QCOMPARE(meshAfter({{"edit", "setGearMesh"}, {"mesh", "15"}, {"friction", nullptr}}), expected);
  }

  /// What `help` lists is what the document's schema has, and what the manual of the command line shows.
  void everyMethodAndEditIsListed() {
    Served served;
    const json help = served.ask(R"({"method": "help"})").at("result");
    const std::string printedHelp = printed({"--language", "en", "serve", "--help"}).toStdString();
    QFile page(QString(SOURCE) + "/resources/schema/README.md");
    QVERIFY(page.open(QIODevice::ReadOnly));
    const std::string readme = page.readAll().toStdString();
    std::set<std::string> methods;
    for (const json& method : help.at("methods")) {
      methods.insert(method.at("method").get<std::string>());
      QVERIFY2(printedHelp.find("\n  " + method.at("method").get<std::string>()) != std::string::npos,
               method.dump().c_str());
    }
    QCOMPARE(methods,
             (std::set<std::string>{"analyze", "atlas",    "backlash", "close",  "dynamics", "edit",
                                    "export",  "gearbox",  "hardware", "help",   "identify", "inputs",
                                    "levers",  "open",     "pose",     "states", "statics",  "teeth",
                                    "text",    "validate", "vibration"}));
    QFile file(QString(SOURCE) + "/resources/schema/geargraph.schema.json");
    QVERIFY(file.open(QIODevice::ReadOnly));
    const json definitions = json::parse(file.readAll().constData()).at("$defs");
    QVERIFY(help.at("edits").size() >= 20);
    for (const json& edit : help.at("edits")) {
      const std::string name = edit.at("edit").get<std::string>();
      QVERIFY2(printedHelp.find("\n  " + name + ' ') != std::string::npos, name.c_str());
      QVERIFY2(readme.find('`' + name + '`') != std::string::npos, name.c_str());
      if (!name.starts_with("add")) continue;
      std::string kind = name.substr(3);
      kind.front() = static_cast<char>(std::tolower(kind.front()));
      std::set<std::string> expected;
      const auto collect = [&](const json& part) {
        const json properties = part.value("properties", json::object());
        for (const auto& property : properties.items()) expected.insert(property.key());
      };
      collect(definitions.at(kind));
      for (const json& part : definitions.at(kind).value("oneOf", json::array())) collect(part);
      std::set<std::string> listed;
      for (const json& member : edit.at("members")) listed.insert(member.at("name").get<std::string>());
      QVERIFY2(listed == expected, name.c_str());
    }
  }

  void whatIsNoRequestIsRejectedAndTheNextOneAnswered() {
    Served served;
    QCOMPARE(served.ask("{").at("error").at("code").get<std::string>(), std::string("syntax"));
    for (const char* line : {"7", "{}", R"({"id": [1], "method": "paint", "params": {}})",
                             R"({"method": "open"})", R"({"method": "open", "params": {"text": 7}})"}) {
      QVERIFY2(served.ask(line).contains("error"), line);
    }
    QVERIFY(served.ask(R"({"id": [1], "method": "text", "params": {"document": "9"}})").at("id") ==
            json({1}));
    const json broken = served.ask("open", {{"text", "{\"format\": \"other\"}"}});
    QCOMPARE(broken.at("error").at("code").get<std::string>(), std::string("format"));
    const std::string document = served.open(robot());
    QVERIFY(served.ask("close", {{"document", document}}).contains("result"));
    QVERIFY(served.ask("text", {{"document", document}}).contains("error"));
  }

  void nothingButTheAnswerIsWrittenOrRead() {
    const QTemporaryDir folder;
    Served served;
    const std::string document = served.open(robot());
    const std::string path = folder.filePath("out.csv").toStdString();
    for (const json& words :
         {json{"--to", "csv", "--all", "-o", path}, json{"--to", "csv", "--matrix", "p", "-o", path},
          json{"--to", "csv", "--matrix", "p", "-o" + path}, json{path}, json{"--json", "--", path},
          json{"--limit-seconds=9"}, json{7}}) {
      const json answer = served.ask("export", {{"document", document}, {"arguments", words}});
      QVERIFY2(answer.contains("error"), words.dump().c_str());
    }
    QVERIFY(QDir(folder.path()).isEmpty());
    QVERIFY(served.ask("serve", {{"document", document}}).contains("error"));
    QVERIFY(served.ask("summary", {{"document", document}}).contains("error"));
    const json two = served.ask("analyze", {{"document", document}, {"arguments", {"--json", path}}});
    QCOMPARE(two.at("result").at("status").get<int>(), 2);
  }

  void limitsEndACommandAndNotTheServer() {
    Served served({"--limit-seconds", "0.2"});
    const std::string document = served.open(robot());
    const json animation = served.ask(
        "export",
        {{"document", document},
         {"arguments", {"--to", "png", "--view", "3d", "--motion", "--frames", "10000", "-o", "-"}}});
    QCOMPARE(animation.at("result").at("status").get<int>(), 3);
    QVERIFY(served.ask("text", {{"document", document}}).contains("result"));
    Served small({"--limit-memory", "500"});
    const json starved = small.ask(
        "export", {{"document", small.open(robot())},
                   {"arguments", {"--to", "png", "--view", "digraph", "--size", "12000x12000", "-o", "-"}}});
    QVERIFY(starved.contains("error") || starved.at("result").at("status") == 3);
    QVERIFY(small.ask(R"({"method": "none", "params": {}})").contains("error"));
  }

  void itEndsWithStandardInput() {
    Served served;
    served.program().closeWriteChannel();
    QVERIFY(served.program().waitForFinished(kPatience));
    QCOMPARE(served.program().exitCode(), 0);
  }
};

QTEST_GUILESS_MAIN(ServeTest)
#include "test_serve.moc"

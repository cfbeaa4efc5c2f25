#include <QFile>
#include <QProcess>
#include <QTemporaryDir>
#include <QtTest>
#include <nlohmann/json.hpp>

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

json robot() {
  QFile file(QString(SOURCE) + "/resources/examples/robot.geargraph");
  if (!file.open(QIODevice::ReadOnly)) return {};
  return json::parse(file.readAll().constData());
}

QByteArray printed(const QStringList& words) {
  QProcess program;
  program.start(GEARGRAPH_CLI, words);
  program.waitForFinished(kPatience);
  return program.readAllStandardOutput();
}

}  // namespace

class TestServe : public QObject {
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

QTEST_GUILESS_MAIN(TestServe)
#include "test_serve.moc"

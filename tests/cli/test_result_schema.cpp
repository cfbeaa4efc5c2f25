#include <QTest>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <set>

#include "core/foundations/base/diagnostic.h"
#include "tests/cli/cli_run.h"
#include "tests/core/support/example_files.h"
#include "tests/core/support/json_schema.h"

using namespace geargraph;
using namespace geargraph::test;
using nlohmann::json;

namespace {

/// The published schema lets members be added; here every object has only those that it names.
void closeObjects(json& schema) {
  if (schema.is_object() && schema.contains("properties") && !schema.contains("additionalProperties"))
    schema["additionalProperties"] = false;
  for (json& each : schema) {
    if (each.is_structured()) closeObjects(each);
  }
}

const json& published() {
  static const json kSource = [] {
    std::ifstream file(sourcePath("resources/schema/results.schema.json"));
    return json::parse(file);
  }();
  return kSource;
}

/// The schema of one kind of answer, without members that it does not name.
const JsonSchema& closedSchema(const std::string& kind) {
  static std::map<std::string, JsonSchema> made;
  const auto found = made.find(kind);
  if (found != made.end()) return found->second;
  json definitions = published().at("$defs");
  closeObjects(definitions);
  return made.try_emplace(kind, json{{"$ref", "#/$defs/" + kind}, {"$defs", std::move(definitions)}})
      .first->second;
}

/// What the program prints, parsed; discarded where it is no JSON.
json answerOf(const QStringList& words, const QByteArray& input = {}) {
  return json::parse(run(words, input).output, nullptr, false);
}

/// Pointers to all values of an answer; of lists and of maps from labels or ids, to the first only.
void collectPointers(const json& value, const std::string& pointer, std::vector<std::string>& pointers) {
  if (!pointer.empty()) pointers.push_back(pointer);
  if (value.is_array() && !value.empty()) collectPointers(value.front(), pointer + "/0", pointers);
  if (!value.is_object()) return;
  for (const auto& [name, member] : value.items()) collectPointers(member, pointer + '/' + name, pointers);
}

struct Call {
  const char* kind;
  QStringList words;  ///< without the file
};

/// Every form of a command's answer.
std::vector<Call> callsOf(const json& document) {
  std::vector<Call> calls{{"analysis", {"analyze"}},
                          {"analysis", {"analyze", "--no-symbolic"}},
                          {"validation", {"validate"}},
                          {"inputs", {"inputs", "--limit", "5"}},
                          {"states", {"states"}},
                          {"levers", {"levers"}},
                          {"backlash", {"backlash"}},
                          {"vibration", {"vibration"}},
                          {"vibration", {"vibration", "--rpm", "1500", "--harmonics", "2"}},
                          {"statics", {"statics"}},
                          {"statics", {"statics", "--eta", "0.98", "--share", "stiffness"}},
                          {"staticsOfStates", {"statics", "--all-states", "--eta", "0.97"}},
                          {"dynamics", {"dynamics", "--seconds", "0.01"}},
                          {"pose", {"pose"}}};
  const json states = document.value("states", json::array());
  if (!states.empty()) {
    const QString name = QString::fromStdString(states.front().at("name"));
    calls.push_back({"analysis", {"analyze", "--state", name}});
    calls.push_back({"levers", {"levers", "--state", name}});
    calls.push_back({"backlash", {"backlash", "--state", name}});
    calls.push_back({"vibration", {"vibration", "--state", name}});
    calls.push_back({"statics", {"statics", "--state", name}});
    calls.push_back({"dynamics", {"dynamics", "--state", name}});
  }
  return calls;
}

}  // namespace

/// resources/schema/results.schema.json against what the built program prints.
class ResultSchemaTest : public QObject {
  Q_OBJECT

 private slots:
  void everyAnswerFits_data() {
    QTest::addColumn<QString>("name");
    for (const std::string& name : exampleNames())
      QTest::addRow("%s", name.c_str()) << QString::fromStdString(name);
  }
  void everyAnswerFits() {
    QFETCH(QString, name);
    static const JsonSchema kWhole(published());
    for (const Call& call : callsOf(json::parse(exampleText(name.toStdString())))) {
      const QStringList words =
          call.words + QStringList{"--json", QString::fromStdString(examplePath(name.toStdString()))};
      const Run answer = run(words);
      const std::string command = words.join(' ').toStdString();
      if (answer.status != 0 && answer.output.empty()) {
        // Poses are of mechanisms without errors, states of those that have some.
        const bool isExcused = words.front() == "pose" ? answer.status == 1 : words.contains("--all-states");
        QVERIFY2(isExcused, command.c_str());
        continue;
      }
      const json document = json::parse(answer.output, nullptr, false);
      const std::string complaint = closedSchema(call.kind).complaint(document);
      QVERIFY2(complaint.empty(), (command + ": " + complaint).c_str());
      QVERIFY2(kWhole.complaint(document).empty(), (command + ": fits several forms or none").c_str());
    }
  }

  void answersToBrokenDocumentsFit_data() {
    QTest::addColumn<QString>("file");
    for (const char* file : {"broken", "syntax", "loose"}) QTest::addRow("%s", file) << file;
  }
  void answersToBrokenDocumentsFit() {
    QFETCH(QString, file);
    const QString path =
        QString::fromStdString(sourcePath("tests/golden/files/")) + file + QStringLiteral(".geargraph");
    for (const Call& call :
         {Call{"analysis", {"analyze"}}, Call{"validation", {"validate", "--motion"}},
          Call{"inputs", {"inputs"}}, Call{"states", {"states"}}, Call{"statics", {"statics"}}}) {
      const json answer = answerOf(call.words + QStringList{"--json", path});
      QCOMPARE(closedSchema(call.kind).complaint(answer), std::string());
    }
  }

  void checksOfPapersFit() {
    const QString robot = QString::fromStdString(examplePath("robot"));
    const json matrix = answerOf({"check", robot, "-", "--matrix", "solution", "--json"},
                                 "-i15,0,0\n-i16*i15,i16,0\n-i17*i16*i15,-i17*i16,-i17\n0,-8/9,-8/9\n");
    QCOMPARE(closedSchema("check").complaint(matrix), std::string());
    QVERIFY(matrix.at("differences").size() >= 2);
    const json equations = answerOf({"check", robot, "-", "--json"}, "w40 = n14 w10\nw51 = w50 - w10\n");
    QCOMPARE(closedSchema("equationCheck").complaint(equations), std::string());
    QCOMPARE(equations.at("equations").size(), std::size_t{2});
    const JsonSchema whole(published());
    for (const json& answer : {matrix, equations}) QCOMPARE(whole.complaint(answer), std::string());
  }

  void atlasAndIdentityFit() {
    const JsonSchema whole(published());
    const auto file = [](const char* name) { return QString::fromStdString(examplePath(name)); };
    const QList<QPair<const char*, QStringList>> calls = {
        {"atlas", {"atlas", "--json"}},
        {"atlas", {"atlas", "--dof", "0", "--json"}},
        {"identity", {"identify", file("robot"), "--choices", "--json"}},
        {"identity", {"identify", file("eight-speed-gearbox"), "--with", file("simpson"), "--json"}},
        {"identity", {"identify", file("three-planets"), "--with", file("reverted-train"), "--json"}}};
    for (const auto& [kind, words] : calls) {
      const json answer = answerOf(words);
      QCOMPARE(closedSchema(kind).complaint(answer), std::string());
      QCOMPARE(whole.complaint(answer), std::string());
    }
    QCOMPARE(answerOf(calls[0].second).at("displacementCount"), 745);
    QVERIFY(answerOf(calls[3].second).at("with").is_null());
    QVERIFY(!answerOf(calls[4].second).at("with").is_null());
  }

  void teethFit() {
    const auto file = [](const char* name) {
      return QString::fromStdString(sourcePath("tests/golden/files/") + name);
    };
    QTemporaryDir folder;
    const QString certificate = folder.filePath("certificate.json");
    const json found = answerOf({"teeth", file("two-ring.geargraph"), file("two-ring-wish.json"), "--json",
                                 "--certificate", certificate});
    QCOMPARE(closedSchema("teeth").complaint(found), std::string());
    QCOMPARE(found.at("count").get<int>(), 12);
    const json none = answerOf({"teeth", file("two-ring.geargraph"), "-", "--json"},
                               R"({"ratios": [{"state": "1", "ratio": 1000}], "most": 30})");
    QCOMPARE(closedSchema("teeth").complaint(none), std::string());
    QVERIFY(none.at("nearest").is_object());
    const json checked = answerOf({"teeth", "--check", certificate, "--json"});
    QCOMPARE(closedSchema("teethCheck").complaint(checked), std::string());
    QVERIFY(checked.at("holds").get<bool>());
    const JsonSchema whole(published());
    for (const json& answer : {found, none, checked}) QCOMPARE(whole.complaint(answer), std::string());
  }

  void collisionsAndLimitsFit() {
    const json motion =
        answerOf({"validate", "--motion", "--json", QString::fromStdString(examplePath("robot"))});
    QCOMPARE(closedSchema("validation").complaint(motion), std::string());
    QVERIFY(motion.at("motion").is_object());
    json robot = json::parse(exampleText("robot"));
    robot["turningJoints"][0]["limits"] = {-10, 10};
    const QByteArray limited = QByteArray::fromStdString(robot.dump());
    const json pose = answerOf({"pose", "--angle", "8=90deg", "--json", "-"}, limited);
    QCOMPARE(closedSchema("pose").complaint(pose), std::string());
    QVERIFY(pose.contains("beyondLimits"));
    const json fall =
        answerOf({"dynamics", "--torque", "8=1000Nm", "--seconds", "5", "--json", "-"}, limited);
    QCOMPARE(closedSchema("dynamics").complaint(fall), std::string());
    QCOMPARE(fall.at("simulation").at("end").get<std::string>(), std::string("limit"));
  }

  void matricesAsTripletsFit() {
    json document = {{"format", "geargraph"}, {"version", 1}, {"links", {{{"id", "0"}}}}};
    constexpr int kLinks = 501;  // 501 x 501 entries are more than are written in full
    for (int i = 1; i <= kLinks; ++i) {
      document["links"].push_back({{"id", std::to_string(i)}});
      document["axes"].push_back(
          {{"id", std::to_string(i)}, {"point", {10 * i, 0, 0}}, {"direction", {0, 0, 1}}});
      document["turningJoints"].push_back({{"id", std::to_string(i)},
                                           {"tail", "0"},
                                           {"head", std::to_string(i)},
                                           {"axis", std::to_string(i)}});
    }
    const json answer =
        answerOf({"analyze", "--no-symbolic", "--json", "-"}, QByteArray::fromStdString(document.dump()));
    QCOMPARE(closedSchema("analysis").complaint(answer), std::string());
    QVERIFY(answer.at("matrices").at("path").contains("triplets"));
  }

  void linesOfTheServerFit() {
    const json open = {
        {"id", 1}, {"method", "open"}, {"params", {{"text", json::parse(exampleText("robot"))}}}};
    std::vector<json> requests{open};
    const auto ask = [&](const char* method, json params) {
      params["document"] = "1";
      requests.push_back({{"id", "a"}, {"method", method}, {"params", std::move(params)}});
    };
    ask("edit", {{"edits", {{{"edit", "addLink"}, {"name", "new"}}}}});
    ask("edit", {{"edits", {{{"edit", "setTeeth"}, {"mesh", "none"}, {"tailTeeth", 9}, {"headTeeth", 18}}}}});
    ask("edit", {{"edits",
                  {{{"edit", "setGearMesh"}, {"mesh", "15"}, {"friction", "1/20"}, {"pitchPoint", nullptr}},
                   {{"edit", "addCoupling"}, {"kind", "brake"}, {"link", "4"}},
                   {{"edit", "addState"}, {"engaged", {"A"}}, {"drive", "4"}},
                   {{"edit", "addLoad"}, {"link", "3"}, {"force", {0, 0, "-20"}}, {"point", {0, 40, 132}}},
                   {{"edit", "setLink"}, {"link", "3"}, {"mass", 0.2}, {"inertia", {1, 1, 1, 0, 0, 0}}}}}});
    requests.push_back({{"id", nullptr}, {"method", "help"}});
    ask("text", json::object());
    ask("validate", {{"arguments", {"--json"}}});
    ask("export", {{"arguments", {"--to", "png", "--view", "digraph", "-o", "-"}}});
    ask("close", json::object());
    ask("analyze", json::object());
    QByteArray lines;
    for (const json& request : requests) {
      QCOMPARE(closedSchema("request").complaint(request), std::string());
      lines += QByteArray::fromStdString(request.dump() + '\n');
    }
    lines += "{\"method\": 1}\n{\n";
    const QByteArray printed = QByteArray::fromStdString(run({"serve", "--stdio"}, lines).output);
    const QList<QByteArray> answers = printed.trimmed().split('\n');
    QCOMPARE(answers.size(), qsizetype(requests.size()) + 2);
    int errors = 0;
    for (const QByteArray& line : answers) {
      const json answer = json::parse(line.constData(), nullptr, false);
      QCOMPARE(closedSchema("answer").complaint(answer), std::string());
      errors += answer.contains("error") ? 1 : 0;
    }
    QCOMPARE(errors, 4);
  }

  /// The schema says something of every value: a foreign one in its place is rejected, and so is an answer
  /// without a member that it always has.
  void everyValueIsHeld_data() {
    QTest::addColumn<QString>("kind");
    QTest::addColumn<QStringList>("words");
    const auto add = [](const char* kind, const QStringList& words, const char* example) {
      QTest::addRow("%s of %s", kind, example)
          << kind << words + QStringList{"--json", QString::fromStdString(examplePath(example))};
    };
    add("analysis", {"analyze"}, "robot");
    add("analysis", {"analyze", "--state", "1"}, "simpson");
    add("validation", {"validate", "--motion"}, "robot");
    add("inputs", {"inputs"}, "robot");
    add("states", {"states"}, "simpson");
    add("statics", {"statics", "--state", "1", "--eta", "0.98"}, "simpson");
    add("dynamics", {"dynamics", "--seconds", "0.01"}, "robot");
    add("pose", {"pose"}, "robot");
    for (const char* command : {"gearbox", "hardware"}) {
      const std::string wish = sourcePath(std::string("tests/golden/files/") + command + ".wish.json");
      QTest::addRow("%s", command) << (QString(command) == "gearbox" ? "gearboxes" : command)
                                   << QStringList{command, "--json", QString::fromStdString(wish)};
    }
  }
  void everyValueIsHeld() {
    QFETCH(QString, kind);
    QFETCH(QStringList, words);
    const json answer = answerOf(words);
    const JsonSchema& schema = closedSchema(kind.toStdString());
    QCOMPARE(schema.complaint(answer), std::string());
    std::vector<std::string> pointers;
    collectPointers(answer, "", pointers);
    QVERIFY2(pointers.size() > 4, "hardly anything is there");
    const json foreign = {{"?", {{"?", json::array()}}}};
    for (const std::string& pointer : pointers) {
      json changed = answer;
      changed[json::json_pointer(pointer)] = foreign;
      QVERIFY2(!schema.complaint(changed).empty(), pointer.c_str());
    }
    const json required = published().at("$defs").at(kind.toStdString()).at("required");
    for (const std::string name : required) {
      json changed = answer;
      changed.erase(name);
      QVERIFY2(!schema.complaint(changed).empty(), name.c_str());
    }
  }

  void codesAreThoseOfTheProgram() {
    const json& definitions = published().at("$defs");
    std::vector<std::string> codes, details;
    for (const Code code : allCodes()) codes.emplace_back(codeName(code));
    for (const Detail detail : allDetails()) details.emplace_back(detailName(detail));
    QVERIFY(definitions.at("code").at("enum") == json(codes));
    QVERIFY(definitions.at("detail").at("enum") == json(details));
  }
};

QTEST_GUILESS_MAIN(ResultSchemaTest)
#include "test_result_schema.moc"

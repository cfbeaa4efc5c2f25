#include <QDir>
#include <QDirIterator>
#include <QRegularExpression>
#include <QTemporaryDir>
#include <QtTest>
#include <cmath>
#include <nlohmann/json.hpp>

#include "core/meshfile/mesh_reader.h"
#include "tests/cli/cli_run.h"
#include "tests/core/support/example_files.h"

using namespace geargraph;
using namespace geargraph::test;
using nlohmann::json;

namespace {

json robot() {
  return json::parse(exampleText("robot"));
}

/// Two wheels on parallel axes.
json pairOfWheels() {
  return json::parse(
      R"({"format": "geargraph", "version": 1, "links": [{"id": "0"}, {"id": "1"}, {"id": "2"}],
    "axes": [{"id": "a", "point": [0, 0, 0], "direction": [0, 0, 1]},
             {"id": "b", "point": [0, 60, 0], "direction": [0, 0, 1]}],
    "turningJoints": [{"id": "3", "tail": "0", "head": "1", "axis": "a"},
                      {"id": "4", "tail": "0", "head": "2", "axis": "b"}],
    "gearMeshes": [{"id": "5", "tail": "1", "head": "2", "tailTeeth": 20, "headTeeth": 40}],
    "inputs": [{"joint": "3", "speed": 1}]})");
}

json pairOfWheels(const std::string& path, const json& value) {
  json document = pairOfWheels();
  document[json::json_pointer(path)] = value;
  return document;
}

/// Shafts in a row, every wheel of 100,000 teeth driving one of 10: a ratio beyond all doubles.
json longChain(int shafts) {
  json document{{"format", "geargraph"}, {"version", 1}, {"links", {{{"id", "0"}}}}};
  for (int i = 1; i <= shafts; ++i) {
    const std::string id = std::to_string(i);
    document["links"].push_back({{"id", id}});
    document["axes"].push_back({{"id", id}});
    document["turningJoints"].push_back({{"id", "j" + id}, {"tail", "0"}, {"head", id}, {"axis", id}});
    if (i == 1) continue;
    document["gearMeshes"].push_back({{"id", "m" + id},
                                      {"tail", std::to_string(i - 1)},
                                      {"head", id},
                                      {"tailTeeth", 100'000},
                                      {"headTeeth", 10}});
  }
  document["inputs"] = {{{"joint", "j1"}, {"speed", 1}}};
  document["states"] = {
      {{"name", "1"}, {"engaged", json::array()}, {"drive", "1"}, {"driven", "2"}},
      {{"name", "2"}, {"engaged", json::array()}, {"drive", std::to_string(shafts)}, {"driven", "1"}}};
  return document;
}

json withLengths(json document, const std::function<json(double)>& to) {
  const auto each = [&](json& list) {
    for (json& value : list) value = to(value.get<double>());
  };
  for (json& axis : document["axes"]) each(axis["point"]);
  for (json& mesh : document["gearMeshes"])
    if (mesh.contains("pitchPoint")) each(mesh["pitchPoint"]);
  return document;
}

std::string digits(int count) {
  std::string text(static_cast<std::size_t>(count), '7');
  text.front() = '1';
  return text;
}

struct Odd {
  const char* name;
  json document;
};

const std::vector<Odd>& oddDocuments() {
  static const std::vector<Odd> all = [] {
    std::vector<Odd> list{
        {"robot", robot()},
        {"robot of a nanometre", withLengths(robot(), [](double x) { return json(x * 1e-12); })},
        {"robot of a million kilometres", withLengths(robot(), [](double x) { return json(x * 1e9); })},
        {"robot far away", withLengths(robot(), [](double x) { return json(x + 1e12); })},
        {"speeds at the end of the doubles", robot()},
        {"subnormal speeds", robot()},
        {"a chain beyond all doubles", longChain(80)},
        {"a subnormal distance", pairOfWheels("/axes/1/point", {0, 5e-324, 0})},
        {"one line", pairOfWheels("/axes/1/point", {0, 0, 0})},
        {"a direction of length 0", pairOfWheels("/axes/1/direction", {0, 0, 0})},
        {"a subnormal direction", pairOfWheels("/axes/1/direction", {0, 0, 5e-324})},
        {"a direction of 1e308", pairOfWheels("/axes/1/direction", {0, 0, 1e308})},
        {"a direction below the doubles",
         pairOfWheels("/axes/1/direction", {"0", "0", "1/1" + std::string(400, '0')})},
        {"nearly parallel axes", pairOfWheels("/axes/1/direction", {0, 1e-9, 1})},
        {"axes that meet far away", pairOfWheels("/axes/1/direction", {0, 1e-5, 1})},
        {"skew axes", pairOfWheels("/axes/1/direction", {1, 0, 0})},
        {"a pitch point on an axis", pairOfWheels("/gearMeshes/0/pitchPoint", {0, 0, 7})},
        {"a pitch point of 1e300", pairOfWheels("/gearMeshes/0/pitchPoint", {0, 1e300, 0})},
        {"fractions of 1,000 digits", pairOfWheels("/axes/1/point", {0, digits(1000) + "/" + digits(999),
                                                                     digits(999) + "/" + digits(1000)})},
        {"one tooth each", pairOfWheels("/gearMeshes/0/tailTeeth", 1)},
        {"a face of 1e-300", pairOfWheels("/gearMeshes/0/faceWidth", 1e-300)},
        {"a pressure angle of 0", pairOfWheels("/gearDefaults", {{"pressureAngle", 0}})},
        {"a pressure angle of 90", pairOfWheels("/gearDefaults", {{"pressureAngle", 90}})},
        {"a pressure angle of -1e9", pairOfWheels("/gearDefaults", {{"pressureAngle", -1e9}})},
        {"a backlash of 1e9 modules", pairOfWheels("/gearDefaults", {{"backlash", 1e9}})},
        {"nodes at the end of the doubles", pairOfWheels("/view", {{"nodes", {{"1", {1e308, -1e308}}}}})},
    };
    list[4].document["inputs"][0]["speed"] = 1.7e308;
    list[4].document["inputs"][1]["speed"] = 1.7e308;
    list[5].document["inputs"][0]["speed"] = 5e-324;
    return list;
  }();
  return all;
}

/// The first number in a text that is none, with what is around it.
QString nonNumberIn(const QString& text) {
  static const QRegularExpression embedded("data:[^\"') ]+|url\\([^)]*\\)");
  static const QRegularExpression nonNumber("(?<![a-z])(nan|inf|infinity|NaN|Infinity|-nan|-inf)(?![a-z])");
  const QString bare = QString(text).remove(embedded);
  const auto found = nonNumber.match(bare);
  if (!found.hasMatch()) return {};
  const auto at = std::max<qsizetype>(0, found.capturedStart() - 40);
  return bare.mid(at, 100);
}

/// Where JSON has a null in a list: members may be null where there is nothing, entries of a list are
/// numbers.
QString nullIn(const json& value, const QString& at = {}) {
  if (value.is_structured()) {
    for (const auto& [key, element] : value.items()) {
      if (value.is_array() && element.is_null()) return at + "/" + QString::fromStdString(key);
      if (const QString found = nullIn(element, at + "/" + QString::fromStdString(key)); !found.isEmpty())
        return found;
    }
  }
  return {};
}

bool isFinite(const MeshScene& scene) {
  for (const MeshNode& node : scene.nodes) {
    if (!node.pose.matrix().allFinite()) return false;
    for (const RotationKey& key : node.keys)
      if (!std::isfinite(key.seconds) || !key.rotation.coeffs().allFinite()) return false;
    if (!node.solid) continue;
    for (const Float3& vertex : node.solid->positions)
      for (const float component : vertex)
        if (!std::isfinite(component)) return false;
  }
  return true;
}

}  // namespace

/// Whatever numbers a document holds: no output of the program holds one that is none.
class OddNumbersTest : public QObject {
  Q_OBJECT
 private slots:
  void noOutputHasANumberThatIsNone_data() {
    QTest::addColumn<int>("position");
    for (std::size_t i = 0; i < oddDocuments().size(); ++i)
      QTest::newRow(oddDocuments()[i].name) << static_cast<int>(i);
  }
  void noOutputHasANumberThatIsNone() {
    QFETCH(int, position);
    const Odd& odd = oddDocuments()[static_cast<std::size_t>(position)];
    QTemporaryDir folder;
    const QString file = folder.filePath("odd.geargraph");
    QFile out(file);
    QVERIFY(out.open(QIODevice::WriteOnly));
    out.write(QByteArray::fromStdString(odd.document.dump()));
    out.close();

    for (const char* command : {"validate", "analyze", "inputs", "states", "pose"}) {
      checkPrinted({command, file});
      checkPrinted({command, file, "--json"});
    }
    const std::string input = odd.document["inputs"][0]["joint"].get<std::string>();
    if (input == "8" || input == "3") {
      for (const char* angle : {"1e300deg", "1e300rad", "5e-324rad", "1/3deg"})
        checkPrinted({"pose", file, "--json", "--angle", QString::fromStdString(input) + "=" + angle});
    }
    for (const char* form : {"latex", "md", "html"}) checkPrinted({"export", file, "--to", form, "-o", "-"});
    for (const char* view : {"digraph", "ttgraph", "schematic"})
      checkPrinted({"export", file, "--to", "svg", "--view", view, "-o", "-"});
    const Run tables = run({"export", file, "--to", "csv", "--all", "-o", folder.filePath("tables")});
    checkRun(tables, "csv --all");
    checkFolder(folder.filePath("tables"));
    if (position > 5) return;  // solids of the robot only: many bytes, and the same code for all
    for (const MeshFormat format : allMeshFormats()) {
      const QString name =
          QString::fromUtf8(meshFormatName(format).data(), qsizetype(meshFormatName(format).size()));
      const QString path = folder.filePath("solids." + name);
      checkRun(run({"export", file, "--to", name, "--tolerance", "0.1", "-o", path}), name);
      QFile written(path);
      if (!written.open(QIODevice::ReadOnly)) continue;
      const auto scene = readMesh(written.readAll().toStdString(), format);
      const auto* read = std::get_if<MeshScene>(&scene);
      QVERIFY2(read != nullptr && isFinite(*read), qPrintable(name));
    }
    checkRun(
        run({"export", file, "--to", "assembly", "--tolerance", "0.1", "-o", folder.filePath("assembly")}),
        "assembly");
    checkFolder(folder.filePath("assembly"));
  }

 private:
  static void checkRun(const Run& done, const QString& what) {
    QVERIFY2(done.status >= 0 && done.status <= 3,
             qPrintable(what + ": " + QString::fromStdString(done.errors)));
    const QString errors = nonNumberIn(QString::fromStdString(done.errors));
    QVERIFY2(errors.isEmpty(), qPrintable(what + " says: " + errors));
  }

  static void checkText(const QString& what, const std::string& text, bool isJson) {
    const QString found = nonNumberIn(QString::fromStdString(text));
    QVERIFY2(found.isEmpty(), qPrintable(what + ": " + found));
    if (!isJson || text.empty()) return;
    const json value = json::parse(text, nullptr, false);
    QVERIFY2(!value.is_discarded(), qPrintable(what + " is no JSON"));
    const QString null = nullIn(value);
    QVERIFY2(null.isEmpty(), qPrintable(what + " has null at " + null));
  }

  static void checkPrinted(const QStringList& words) {
    const Run done = run(words);
    const QString what = words.join(' ');
    checkRun(done, what);
    checkText(what, done.output, words.contains("--json"));
  }

  static void checkFolder(const QString& path) {
    QDirIterator files(path, {"*.csv", "*.json"}, QDir::Files);
    while (files.hasNext()) {
      QFile file(files.next());
      QVERIFY(file.open(QIODevice::ReadOnly));
      checkText(file.fileName(), file.readAll().toStdString(), file.fileName().endsWith(".json"));
    }
  }
};

QTEST_GUILESS_MAIN(OddNumbersTest)
#include "test_odd_numbers.moc"

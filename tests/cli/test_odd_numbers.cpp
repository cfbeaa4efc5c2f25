#include <QDir>
#include <QDirIterator>
#include <QRegularExpression>
#include <QTemporaryDir>
#include <QTest>
#include <algorithm>
#include <cmath>
#include <functional>
#include <nlohmann/json.hpp>

#include "core/presentation/meshfile/mesh_reader.h"
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

/// The pair with several members replaced.
json pairOfWheels(const json& members) {
  json document = pairOfWheels();
  for (const auto& [path, value] : members.items()) document[json::json_pointer(path)] = value;
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
  bool hasSolids = false;    ///< export its solids, too
  bool hasPictures = false;  ///< and its pictures
};

const std::vector<Odd>& oddDocuments() {
  static const std::vector<Odd> all = [] {
    std::vector<Odd> list{
        {"robot", robot()},
        {"robot of a nanometre", withLengths(robot(), [](double x) { return json(x * 1e-12); }), true},
        {"robot of a million kilometres", withLengths(robot(), [](double x) { return json(x * 1e9); }), true},
        {"robot far away", withLengths(robot(), [](double x) { return json(x + 1e12); }), true},
        {"speeds at the end of the doubles", robot()},
        {"subnormal speeds", robot(), true},
        {"a chain beyond all doubles", longChain(80)},
        {"a subnormal distance", pairOfWheels("/axes/1/point", {0, 5e-324, 0})},
        {"one line", pairOfWheels("/axes/1/point", {0, 0, 0})},
        {"a direction of length 0", pairOfWheels("/axes/1/direction", {0, 0, 0})},
        {"nearly parallel axes", pairOfWheels("/axes/1/direction", {0, 1e-9, 1})},
        {"axes that meet far away", pairOfWheels("/axes/1/direction", {0, 1e-5, 1})},
        {"skew axes", pairOfWheels("/axes/1/direction", {1, 0, 0})},
        {"a pitch point on an axis", pairOfWheels("/gearMeshes/0/pitchPoint", {0, 0, 7})},
        {"fractions of 1,000 digits", pairOfWheels("/axes/1/point", {0, digits(1000) + "/" + digits(999),
                                                                     digits(999) + "/" + digits(1000)})},
        {"one tooth each", pairOfWheels("/gearMeshes/0/tailTeeth", 1)},
        {"a face of 1e-300", pairOfWheels("/gearMeshes/0/faceWidth", 1e-300)},
        {"a pressure angle of 0", pairOfWheels("/gearDefaults", {{"pressureAngle", 0}})},
        {"a pressure angle of 90", pairOfWheels("/gearDefaults", {{"pressureAngle", 90}})},
        {"a pressure angle of -1e9", pairOfWheels("/gearDefaults", {{"pressureAngle", -1e9}})},
        {"a backlash of 1e9 modules", pairOfWheels("/gearDefaults", {{"backlash", 1e9}})},
    };
    list[4].document["inputs"][0]["speed"] = 1.7e308;
    list[4].document["inputs"][1]["speed"] = 1.7e308;
    list[5].document["inputs"][0]["speed"] = 5e-324;
    return list;
  }();
  return all;
}

/// Documents at the very edge of what lengths may be, for every output there is.
const std::vector<Odd>& edgeDocuments() {
  static constexpr double kMax = 1e15, kLeast = 1e-15;
  static const std::vector<Odd> all = [] {
    const auto edge = [](const char* name, json document) {
      return Odd{name, std::move(document), true, true};
    };
    const auto pair = [&](const char* name, const json& members) {
      return edge(name, pairOfWheels(members));
    };
    const json far = {0, kMax, 0};
    return std::vector<Odd>{
        edge("robot as large as it may be",
             withLengths(robot(), [](double x) { return json(std::clamp(x * 1e13, -kMax, kMax)); })),
        edge("robot as far as it may be", withLengths(robot(), [](double x) { return json(kMax - x); })),
        pair("an axis 1e15 away", {{"/axes/1/point", far}}),
        pair("axes 2e15 apart",
             {{"/axes/0/point", {-kMax, -kMax, -kMax}}, {"/axes/1/point", {kMax, kMax, kMax}}}),
        pair("a pair of 1e-15", {{"/axes/1/point", {0, kLeast, 0}}}),
        pair("a pair of 1e-15 at 1e15",
             {{"/axes/0/point", far}, {"/axes/1/point", {0, "1000000000000000", kLeast}}}),
        pair("directions of 1e-15 and 1e15",
             {{"/axes/0/direction", {0, 0, kLeast}}, {"/axes/1/direction", {0, 0, kMax}}}),
        pair("a direction of 1e-15 beside 1e15", {{"/axes/1/direction", {kLeast, 0, kMax}}}),
        pair("axes that meet 1e15 away", {{"/axes/1/direction", {0, kLeast, 1}}}),
        pair("axes that meet near 1e15", {{"/axes/1/point", {0, kMax, 0}}, {"/axes/1/direction", {0, 1, 0}}}),
        pair("a pitch point 1e15 along the axes", {{"/gearMeshes/0/pitchPoint", {0, 20, kMax}}}),
        pair("a pitch point 1e15 beside the axes", {{"/gearMeshes/0/pitchPoint", {kMax, 20, 0}}}),
        pair("bearings 2e15 apart", {{"/turningJoints/0/offset", -kMax}, {"/turningJoints/1/offset", kMax}}),
        pair("faces of 1e15", {{"/gearMeshes/0/faceWidth", kMax}}),
        pair("a backlash and an angle of 1e15",
             {{"/gearDefaults", {{"backlash", kMax}, {"pressureAngle", kMax}, {"faceWidth", kLeast}}}}),
        pair("wheels of 1e15",
             {{"/wheels", {{{"id", "w"}, {"link", "1"}, {"profileShift", kMax}, {"bore", kMax}}}},
              {"/gearMeshes/0/tailWheel", "w"}}),
        pair("nodes 2e15 apart", {{"/view", {{"nodes", {{"1", {kMax, -kMax}}, {"2", {-kMax, kMax}}}}}}}),
        pair("a camera at 1e15",
             {{"/view/camera",
               {{"target", {kMax, -kMax, kMax}}, {"azimuth", 30}, {"elevation", 30}, {"distance", kMax}}}}),
    };
  }();
  return all;
}

/// What the reader rejects, and the member that is to blame.
struct Rejected {
  const char* name;
  const char* pointer;
  json document;
};

const std::vector<Rejected>& rejectedDocuments() {
  static const std::vector<Rejected> all = [] {
    const auto pair = [](const char* name, const char* pointer, const char* path, const json& value) {
      return Rejected{name, pointer, pairOfWheels(path, value)};
    };
    return std::vector<Rejected>{
        pair("a coordinate of 1e308", "/axes/1/point/1", "/axes/1/point", {0, 1e308, 0}),
        pair("a coordinate just beyond 1e15", "/axes/1/point/0", "/axes/1/point",
             {-1.0000000000000002e15, 0, 0}),
        pair("a direction of 1e308", "/axes/1/direction/2", "/axes/1/direction", {0, 0, 1e308}),
        pair("a subnormal direction", "/axes/1/direction", "/axes/1/direction", {0, 0, 5e-324}),
        pair("a direction just below 1e-15", "/axes/1/direction", "/axes/1/direction", {0, 9.9e-16, 0}),
        pair("a direction below the doubles", "/axes/1/direction", "/axes/1/direction",
             {"0", "0", "1/1" + std::string(400, '0')}),
        pair("a pitch point of 1e300", "/gearMeshes/0/pitchPoint/1", "/gearMeshes/0/pitchPoint",
             {0, 1e300, 0}),
        pair("an offset of 1e17", "/turningJoints/0/offset", "/turningJoints/0/offset", 1e17),
        pair("a face of 1e308", "/gearMeshes/0/faceWidth", "/gearMeshes/0/faceWidth", 1e308),
        pair("a node at 1e308", "/view/nodes/1/0", "/view", {{"nodes", {{"1", {1e308, 0}}}}}),
    };
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
    for (const auto* list : {&node.solid->positions, &node.solid->normals})
      for (const Float3& vertex : *list)
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
  void noOutputHasANumberThatIsNone_data() { addRows(oddDocuments()); }
  void noOutputHasANumberThatIsNone() {
    QFETCH(int, position);
    checkOutputs(oddDocuments()[static_cast<std::size_t>(position)]);
  }

  void documentsAtTheEdgeOfTheRangeEndInNumbersOrErrors_data() { addRows(edgeDocuments()); }
  void documentsAtTheEdgeOfTheRangeEndInNumbersOrErrors() {
    QFETCH(int, position);
    checkOutputs(edgeDocuments()[static_cast<std::size_t>(position)]);
  }

  void numbersBeyondTheRangeAreRejectedWithTheirPlace_data() { addRows(rejectedDocuments()); }
  void numbersBeyondTheRangeAreRejectedWithTheirPlace() {
    QFETCH(int, position);
    constexpr int kErrors = 1;
    const Rejected& rejected = rejectedDocuments()[static_cast<std::size_t>(position)];
    QTemporaryDir folder;
    const QString file = written(folder, rejected.document);
    const Run validated = run({"validate", file, "--json"});
    QCOMPARE(validated.status, kErrors);
    const json diagnostics = json::parse(validated.output)["diagnostics"];
    QCOMPARE(diagnostics.size(), std::size_t{1});
    QCOMPARE(diagnostics[0]["code"].get<std::string>(), std::string("schema"));
    QCOMPARE(diagnostics[0]["pointer"].get<std::string>(), std::string(rejected.pointer));
    for (const char* command : {"analyze", "inputs", "pose"}) QCOMPARE(run({command, file}).status, kErrors);
    const QString out = folder.filePath("out");
    for (const QStringList& form : {QStringList{"md"}, {"csv", "--all"}, {"glb"}, {"assembly"}}) {
      QCOMPARE(run(QStringList{"export", file, "-o", out, "--to"} + form).status, kErrors);
      QVERIFY2(!QFileInfo::exists(out), qPrintable(form.front()));
    }
  }

 private:
  template <class Document>
  static void addRows(const std::vector<Document>& documents) {
    QTest::addColumn<int>("position");
    for (std::size_t i = 0; i < documents.size(); ++i)
      QTest::newRow(documents[i].name) << static_cast<int>(i);
  }

  static QString written(const QTemporaryDir& folder, const json& document) {
    const QString path = folder.filePath("odd.geargraph");
    QFile file(path);
    if (!file.open(QIODevice::WriteOnly)) return {};
    file.write(QByteArray::fromStdString(document.dump()));
    return path;
  }

  static void checkOutputs(const Odd& odd) {
    QTemporaryDir folder;
    const QString file = written(folder, odd.document);
    for (const char* command : {"validate", "analyze", "pose"}) checkPrinted({command, file});
    for (const char* command : {"validate", "analyze", "inputs", "pose"})
      checkPrinted({command, file, "--json"});
    checkPrinted({"validate", file, "--motion", "--json"});
    if (odd.document.contains("states")) {
      checkPrinted({"states", file});
      checkPrinted({"states", file, "--json"});
    }
    if (odd.document["inputs"][0]["joint"] == "8") {
      for (const char* angle : {"1e300deg", "1e300rad", "5e-324rad", "1/3deg"})
        checkPrinted({"pose", file, "--json", "--angle", QStringLiteral("8=") + angle});
    }
    for (const char* form : {"latex", "md", "html"}) checkPrinted({"export", file, "--to", form, "-o", "-"});
    for (const char* view : {"digraph", "ttgraph", "schematic"})
      checkPrinted({"export", file, "--to", "svg", "--view", view, "-o", "-"});
    const Run tables = run({"export", file, "--to", "csv", "--all", "-o", folder.filePath("tables")});
    checkRun(tables, "csv --all");
    checkFolder(folder.filePath("tables"));
    if (odd.hasPictures) checkPictures(file);
    if (odd.hasSolids) checkSolids(file, folder);
  }

  /// What cannot be searched for words: written whole, or nothing and an error.
  static void checkPictures(const QString& file) {
    const auto check = [&](QStringList options, const char* begin) {
      const QStringList words = QStringList{"export", file, "-o", "-"} + options;
      const Run done = run(words);
      checkRun(done, words.join(' '));
      const bool isWhole = done.output.starts_with(begin);
      QVERIFY2(isWhole || (done.output.empty() && done.status != 0), qPrintable(words.join(' ')));
    };
    check({"--to", "pdf"}, "%PDF");
    check({"--to", "pdf", "--view", "schematic"}, "%PDF");
    for (const char* view : {"digraph", "schematic"}) check({"--to", "png", "--view", view}, "\x89PNG");
    check({"--to", "png", "--view", "3d", "--size", "64x48"}, "\x89PNG");
    check({"--to", "glb", "--view", "3d"}, "glTF");
  }

  static void checkSolids(const QString& file, const QTemporaryDir& folder) {
    for (const MeshFormat format : allMeshFormats()) {
      const QString name =
          QString::fromUtf8(meshFormatName(format).data(), qsizetype(meshFormatName(format).size()));
      const QString path = folder.filePath("solids." + name);
      checkRun(run({"export", file, "--to", name, "--tolerance", "0.1", "-o", path}), name);
      QFile solids(path);
      if (!solids.open(QIODevice::ReadOnly)) continue;
      const auto scene = readMesh(solids.readAll().toStdString(), format);
      const auto* read = std::get_if<MeshScene>(&scene);
      QVERIFY2(read != nullptr && isFinite(*read), qPrintable(name));
    }
    checkRun(
        run({"export", file, "--to", "assembly", "--tolerance", "0.1", "-o", folder.filePath("assembly")}),
        "assembly");
    checkFolder(folder.filePath("assembly"));
  }

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

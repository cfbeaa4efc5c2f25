#include <QTest>

#include "core/mechanism/model/validate.h"
#include "tests/core/mechanism/document_format/broken_documents.h"
#include "tests/core/mechanism/document_format/support.h"

using namespace geargraph;
using namespace geargraph::test;

/// One row a fault: the document with one thing changed, and every diagnostic that it may give.
class MechanismReaderTest : public QObject {
  Q_OBJECT

 private slots:
  void oneFault_givesOneDiagnostic_data();
  void oneFault_givesOneDiagnostic();
  void allProblemsAreReportedTogether_inTheOrderOfTheFile();
  void syntaxErrors_sayLineAndColumn();
  void schemaErrors_sayPointerAndWhatWasExpectedAndFound();
  void diagnostics_knowTheirPlaceInTheFile();
  void treeFaults_areForTheEditorToFix_data();
  void treeFaults_areForTheEditorToFix();
  void manyLongLoops_areAllReported();
  void listsMayBeLeftOut_whereNothingNeedsThem();
  void limits_areRejected();
  void limits_areInclusive();
  void largeFiles_areReadInReasonableTime();
};

void MechanismReaderTest::oneFault_givesOneDiagnostic_data() {
  QTest::addColumn<QString>("from");
  QTest::addColumn<QString>("to");
  QTest::addColumn<QString>("expected");
  const auto fault = [](const char* name, const char* from, const char* to, const char* expected) {
    QTest::newRow(name) << from << to << expected;
  };
  fault("nothing wrong", "\"stage\"", "\"stage\"", "");
  for (const BrokenDocument& broken : brokenDocuments())
    fault(broken.name, broken.from, broken.to, broken.expected);
}

void MechanismReaderTest::oneFault_givesOneDiagnostic() {
  QFETCH(QString, from);
  QFETCH(QString, to);
  QFETCH(QString, expected);
  const std::string text = with(kEverything, from.toStdString(), to.toStdString());
  QCOMPARE(QString::fromStdString(diagnosticsFor(text)), expected);
}

void MechanismReaderTest::allProblemsAreReportedTogether_inTheOrderOfTheFile() {
  std::string text = with(kEverything, "\"stage\"", "17");
  text = with(text, "\"axis\": \"p\"", "\"axis\": \"q\"");
  text = with(text, "\"tailTeeth\": 20", "\"tailTeeth\": \"20\"");
  text = with(text, "[\"sun\", \"arm\"]", "[\"sun\", \"sun\"]");
  text = with(text, "\"zoom\": 1.50", "\"zoom\": 1.50, \"zoom\": 2");
  QCOMPARE(diagnosticsFor(text),
           std::string("schema /name; unknown-id /turningJoints/2/axis [turningJoints:6] [axes:q]; "
                       "schema /gearMeshes/0/tailTeeth [gearMeshes:7]; "
                       "self-joint /couplings/1/links/1 [couplings:C] [links:sun]; schema /view/grid/zoom"));
}

void MechanismReaderTest::syntaxErrors_sayLineAndColumn() {
  const auto place = [](const std::string& text) {
    const auto read = readMechanism(text);
    if (read || read.error().size() != 1 || read.error()[0].code != Code::syntax)
      return std::string("no syntax");
    const Diagnostic& d = read.error()[0];
    return std::to_string(d.line) + ":" + std::to_string(d.column) + " " + d.message;
  };
  QCOMPARE(place(""), std::string("1:1 Line 1, column 1: expected a value, found the end of the file."));
  QCOMPARE(place("{\n  \"a\": 1\n  \"b\": 2}"),
           std::string("3:3 Line 3, column 3: expected ',' or '}' in an object, found '\"'."));
  QCOMPARE(place("{\"Γ\": [1, 2,]}"), std::string("1:13 Line 1, column 13: expected a value, found ']'."));
  QCOMPARE(place("{\"a\": 01}"),
           std::string("1:8 Line 1, column 8: expected ',' or '}' in an object, found '1'."));
  QCOMPARE(place("{\"a\": 1.}"),
           std::string("1:9 Line 1, column 9: expected a digit of a number, found '}'."));
  QCOMPARE(place("{\"a\": NaN}"), std::string("1:7 Line 1, column 7: expected a value, found 'N'."));
  QCOMPARE(place("{'a': 1}"),
           std::string("1:2 Line 1, column 2: expected a member name in double quotes, found '''."));
  QCOMPARE(place("{\"a\": \"\xFF\"}"),
           std::string("1:8 Line 1, column 8: expected a character in UTF-8, found the byte 0xFF."));
  QCOMPARE(place("{\"a\": \"\\ud800\"}").substr(0, 4), std::string("1:8 "));
  QCOMPARE(place("{\"a\": \"\\x\"}").substr(0, 4), std::string("1:8 "));
  QCOMPARE(place("{\"a\": \"b").substr(0, 4), std::string("1:9 "));
  QCOMPARE(place("{} {}").substr(0, 4), std::string("1:4 "));
  QCOMPARE(place(std::string("{\"a\": \"\0\"}", 10)).substr(0, 4), std::string("1:8 "));
}

void MechanismReaderTest::schemaErrors_sayPointerAndWhatWasExpectedAndFound() {
  const auto message = [](const std::string& from, const std::string& to) {
    return readMechanism(with(kEverything, from, to)).error().at(0).message;
  };
  QCOMPARE(
      message("31", "-3"),
      std::string("/gearMeshes/0/headTeeth: expected a whole number from 1 to 100000, found the number -3."));
  QCOMPARE(message("\"stage\"", "[1, 2]"),
           std::string("/name: expected a string, found a list of 2 elements."));
  QCOMPARE(message("\"tail\": \"sun\",", ""),
           std::string(
               "/gearMeshes/0/tail: the member \"tail\" is missing; expected an id: a string of 1 to 1,000 "
               "characters or a whole number."));
  QCOMPARE(
      message("\"22/7\"", "\"ΓΓΓΓΓΓΓΓΓΓΓΓΓΓΓΓΓΓΓΓΓΓΓ\""),
      std::string("/axes/0/point/1: expected a number, or a fraction as a string like \"22/7\", found the "
                  "string \"ΓΓΓΓΓΓΓΓΓΓΓΓΓΓΓΓΓΓΓ...."));
}

void MechanismReaderTest::diagnostics_knowTheirPlaceInTheFile() {
  const auto read = readMechanism(with(kEverything, "\"axis\": \"p\"", "\"axis\": \"q\""));
  QCOMPARE(read.error().at(0).line, 10);
  QCOMPARE(read.error().at(0).column, 56);
}

void MechanismReaderTest::treeFaults_areForTheEditorToFix_data() {
  QTest::addColumn<QString>("from");
  QTest::addColumn<QString>("to");
  QTest::addColumn<QString>("expected");
  QTest::newRow("loose") << R"("turningJoints": [)"
                         << R"("x": [)"
                         << "";
  QTest::newRow("a link held by a mesh only")
      << R"({"id": 6, "tail": "arm", "head": "planet", "axis": "p", "kind": "sliding"})"
      << R"({"id": 6, "tail": "arm", "head": "sun", "axis": "p"})"
      << "disconnected  [links:planet]; turning-loop  [turningJoints:6] "
         "[turningJoints:5] [turningJoints:4]";
  QTest::newRow("redundant bearing")
      << R"({"id": 6, "tail": "arm", "head": "planet", "axis": "p", "kind": "sliding"})"
      << R"({"id": 6, "tail": "arm", "head": "planet", "axis": "p", "kind": "sliding"},
                                           {"id": 8, "tail": "planet", "head": "arm", "axis": "p"})"
      << "turning-loop  [turningJoints:8] [turningJoints:6]";
}

void MechanismReaderTest::treeFaults_areForTheEditorToFix() {
  QFETCH(QString, from);
  QFETCH(QString, to);
  QFETCH(QString, expected);
  const auto read = readMechanism(with(kEverything, from.toStdString(), to.toStdString()));
  if (expected.isEmpty()) {
    QVERIFY(!read.has_value());  // links without any list of joints: said once, as schema
    QCOMPARE(summary(read.error()), std::string("schema /turningJoints"));
    return;
  }
  QVERIFY(read.has_value());
  QCOMPARE(summary(treeDiagnostics(*read)), expected.toStdString());
}

/// A chain of links, and as many joints again from the ground to its far half.
void MechanismReaderTest::manyLongLoops_areAllReported() {
  Mechanism mechanism = emptyMechanism();
  mechanism.links.clear();
  constexpr int kLinks = 40'000;
  const auto id = [](int i) { return std::to_string(i); };
  for (int i = 0; i <= kLinks; ++i) mechanism.links.push_back({LinkId(id(i)), {}});
  for (int i = 1; i <= kLinks; ++i) {
    mechanism.turningJoints.push_back(
        {JointId(id(i)), LinkId(id(i - 1)), LinkId(id(i)), AxisId("a"), {}, {}});
  }
  for (int i = kLinks / 2; i < kLinks; ++i) {
    mechanism.turningJoints.push_back(
        {JointId(id(kLinks + i)), LinkId("0"), LinkId(id(i)), AxisId("b"), {}, {}});
  }
  const Diagnostics diagnostics = treeDiagnostics(mechanism);
  QCOMPARE(diagnostics.size(), std::size_t{kLinks / 2});
  QCOMPARE(diagnostics.front().elements.size(), std::size_t{kLinks / 2 + 1});
  QVERIFY(diagnostics.front().elements.at(1) == ElementId(JointId("1")));
  QCOMPARE(diagnostics.back().elements.size(), std::size_t{1});
  QVERIFY(diagnostics.back().detail == Detail::turningCycle);
}

void MechanismReaderTest::listsMayBeLeftOut_whereNothingNeedsThem() {
  QCOMPARE(diagnosticsFor(R"({"format": "geargraph", "version": 1, "links": [{"id": "0"}]})"), std::string());
  QCOMPARE(diagnosticsFor(R"({"format": "geargraph", "version": 1, "links": []})"),
           std::string("schema /links"));
  QCOMPARE(diagnosticsFor("[]"), std::string("format /format"));
  QCOMPARE(diagnosticsFor("\xEF\xBB\xBF" + kEverything), std::string());
}

void MechanismReaderTest::limits_areRejected() {
  const std::string deep(65, '[');
  QCOMPARE(diagnosticsFor(deep), std::string("schema "));
  QCOMPARE(readMechanism(deep).error().at(0).column, 65);
  QCOMPARE(diagnosticsFor(std::string(1'000'000, '[')), std::string("schema "));
  QCOMPARE(diagnosticsFor(std::string(kLargestFile + 1, ' ')), std::string("schema "));
  const std::string longName(1'001, 'x');
  QCOMPARE(diagnosticsFor(with(kEverything, "\"stage\"", '"' + longName + '"')), std::string("schema /name"));
  QCOMPARE(diagnosticsFor(with(kEverything, "\"ground\"", '"' + longName + '"')),
           std::string("schema /links/0/name [links:0]"));
  QCOMPARE(diagnosticsFor(with(kEverything, "{\"id\": \"p\"}", "{\"id\": \"" + longName + "\"}")),
           std::string("schema /axes/1/id"));
  std::string list = "[0";
  for (int i = 0; i < 100'000; ++i) list += ",0";
  QCOMPARE(diagnosticsFor(with(kEverything, "{\"zoom\": 1.50}", list + "]")),
           std::string("schema /view/grid"));
}

void MechanismReaderTest::limits_areInclusive() {
  std::string name;
  for (int i = 0; i < 1'000; ++i) name += "θ";
  QCOMPARE(diagnosticsFor(with(kEverything, "\"stage\"", '"' + name + '"')), std::string());
  QCOMPARE(diagnosticsFor(with(kEverything, "31", "100000")), std::string());
  QCOMPARE(diagnosticsFor(with(kEverything, "31", "1")), std::string());
  QCOMPARE(diagnosticsFor(with(kEverything, "-1.50", "-1e15")), std::string());
  QCOMPARE(diagnosticsFor(with(kEverything, "-1.50", "1e-300")), std::string());
  QCOMPARE(diagnosticsFor(with(kEverything, "[0, 0, 1e-3]", "[0, 0, 1e-15]")), std::string());
  std::string list = "[0";
  for (int i = 1; i < 100'000; ++i) list += ",0";
  QCOMPARE(diagnosticsFor(with(kEverything, "{\"zoom\": 1.50}", list + "]")), std::string());
  // The camera is at depth 3, so 61 more make 64.
  QCOMPARE(diagnosticsFor(with(kEverything, "{\"zoom\": 1.50}", std::string(62, '[') + std::string(62, ']'))),
           std::string());
}

void MechanismReaderTest::largeFiles_areReadInReasonableTime() {
  // Every joint names an axis that does not exist, and every wheel one link: nothing may be quadratic.
  std::string text =
      R"({"format": "geargraph", "version": 1, "links": [{"id": 0}], "axes": [], "turningJoints": [)";
  for (int i = 0; i < 50'000; ++i) {
    text += (i > 0 ? ",\n" : "") + std::string("{\"id\": ") + std::to_string(i) +
            R"(, "tail": 0, "head": 1, "axis": 2})";
  }
  const auto read = readMechanism(text + "]}");
  QCOMPARE(read.error().size(), std::size_t{100'000});
  QCOMPARE(read.error().back().line, 50'000);
}

QTEST_APPLESS_MAIN(MechanismReaderTest)
#include "test_mechanism_reader.moc"

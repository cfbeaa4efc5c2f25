#include <QTest>
#include <nlohmann/json.hpp>
#include <set>

#include "core/design/synthesis/planetary_set.h"
#include "core/design/synthesis/shifting_sets.h"
#include "core/mechanism/document_format/mechanism_file.h"
#include "core/mechanism/model/pins.h"
#include "core/mechanism/model/shapes.h"
#include "core/mechanism/model/unknown_members.h"
#include "tests/core/mechanism/document_format/broken_documents.h"
#include "tests/core/mechanism/document_format/support.h"
#include "tests/core/support/example_files.h"
#include "tests/core/support/json_schema.h"
#include "tests/core/support/mechanisms.h"
#include "tests/fuzz/mutations.h"

using namespace geargraph;
using namespace geargraph::test;

namespace {

/// resources/schema/geargraph.schema.json, held against texts.
class DocumentSchema {
 public:
  /// "" where the text fits; else the first thing that is wrong.
  [[nodiscard]] std::string complaint(const std::string& text) const {
    try {
      return m_schema.complaint(nlohmann::json::parse(text));
    } catch (const nlohmann::json::out_of_range&) {
      return "a number beyond a double";
    }
  }

 private:
  JsonSchema m_schema{
      nlohmann::json::parse(contentsOf(sourcePath("resources/schema/geargraph.schema.json")))};
};

const DocumentSchema& schema() {
  static const DocumentSchema only;
  return only;
}

}  // namespace

/// The published schema and the reader agree: what the program writes fits, what the reader rejects does not.
class SchemaTest : public QObject {
  Q_OBJECT

 private slots:
  void examplesFit() {
    const std::vector<std::string> names = exampleNames();
    QVERIFY(names.size() >= 17);
    for (const std::string& name : names) QCOMPARE(schema().complaint(exampleText(name)), std::string());
  }

  void everyMemberOfTheFormatFits() { QCOMPARE(schema().complaint(kEverything), std::string()); }

  /// The members that the reader knows by name are those of the schema.
  void memberNamesAreThoseOfTheSchema() {
    const nlohmann::json published =
        nlohmann::json::parse(contentsOf(sourcePath("resources/schema/geargraph.schema.json")));
    const nlohmann::json& definitions = published.at("$defs");
    const std::vector<std::pair<DocumentPart, const nlohmann::json*>> parts = {
        {DocumentPart::document, &published},
        {DocumentPart::link, &definitions.at("link")},
        {DocumentPart::shape, &definitions.at("shape")},
        {DocumentPart::axis, &definitions.at("axis")},
        {DocumentPart::turningJoint, &definitions.at("turningJoint")},
        {DocumentPart::gearMesh, &definitions.at("gearMesh")},
        {DocumentPart::wheel, &definitions.at("wheel")},
        {DocumentPart::gearDefaults, &definitions.at("gearDefaults")},
        {DocumentPart::input, &definitions.at("input")},
        {DocumentPart::coupling, &definitions.at("coupling")},
        {DocumentPart::state, &definitions.at("state")},
        {DocumentPart::load, &definitions.at("load")},
        {DocumentPart::balance, &definitions.at("balance")},
        {DocumentPart::view, &definitions.at("view")},
        {DocumentPart::note, &definitions.at("note")},
        {DocumentPart::camera, &definitions.at("camera")}};
    for (const auto& [part, definition] : parts) {
      std::set<std::string> expected;
      const auto collect = [&](const nlohmann::json& from) {
        const nlohmann::json properties = from.value("properties", nlohmann::json::object());
        for (const auto& member : properties.items()) expected.insert(member.key());
      };
      collect(*definition);
      for (const nlohmann::json& kind : definition->value("oneOf", nlohmann::json::array())) collect(kind);
      const std::span<const std::string_view> names = memberNames(part);
      const std::string where(partName(part));
      QVERIFY2(std::set<std::string>(names.begin(), names.end()) == expected, where.c_str());
    }
  }

  void whatTheProgramWritesFits() {
    std::vector<Mechanism> mechanisms{emptyMechanism(), readMechanism(kEverything).value(),
                                      planetarySet({24, 18}, 3), ravigneauxSet({}, 3).value()};
    for (const std::string& name : exampleNames()) mechanisms.push_back(example(name));
    for (int i = 0; i < 40; ++i)
      mechanisms.push_back(randomTree(static_cast<std::uint64_t>(i), 1 + i % 12, i % 7));
    for (Mechanism& mechanism : mechanisms) {
      QCOMPARE(schema().complaint(writeMechanism(mechanism)), std::string());
      // With all that views add, in numbers as they come from the mouse.
      const LinkId last = mechanism.links.back().id;
      mechanism.view.camera = ViewCamera{{1.0 / 3, -2e-9, 4e12}, -179.99, 89, 1e-4, {}};
      mechanism.view.nodes[last] = {-0.1, 1e14};
      mechanism.view.ttNodes[last] = {1.5, -3};
      mechanism.view.colors[last] = 25;
      mechanism = withPinMark(std::move(mechanism), last, true).value();
      mechanism = withShapes(std::move(mechanism), last,
                             {{"a/b c.stl", {}, {}, {}},
                              {"a/../ä.obj",
                               NumberTriple{Number(1), Number(2), Number(3)},
                               NumberTriple{Number(0), Number(0), Number(90)},
                               *Number::fromText("1/3"),
                               {{"finish", "[1]"}}}})
                      .value();
      QCOMPARE(schema().complaint(writeMechanism(mechanism)), std::string());
    }
  }

  /// All faults but those that no schema can state: references between members, names that are used twice,
  /// and numbers that vanish together.
  void whatTheReaderRejectsIsRejected() {
    const std::set<std::string> beyondSchemas{"direction of length 0",
                                              "direction too short for a double",
                                              "efficiency above 1",
                                              "inertia of no body",
                                              "load on the ground",
                                              "balance on the ground",
                                              "fraction beyond the range",
                                              "reference pose beyond a limit",
                                              "limits that leave no turn",
                                              "member twice",
                                              "note of blanks",
                                              "note with a control character",
                                              "member twice in an unknown one",
                                              "pressure angle of 90 degrees",
                                              "wheel of another link"};
    std::set<std::string> passed;
    int rejected = 0;
    for (const BrokenDocument& broken : brokenDocuments()) {
      const std::string expected = broken.expected;
      const bool isReference = expected.starts_with("duplicate-id") || expected.starts_with("unknown-id") ||
                               expected.starts_with("self-joint");
      const std::string complaint = schema().complaint(with(kEverything, broken.from, broken.to));
      if (!complaint.empty()) ++rejected;
      if (complaint.empty() && !isReference) passed.insert(broken.name);
    }
    QCOMPARE(passed, beyondSchemas);
    QVERIFY2(rejected >= 60, qPrintable(QString::number(rejected)));
  }

  /// What the reader accepts fits: seeded mutations of a document with every member.
  void whatTheReaderAcceptsFits() {
    Random random(20240608);
    int accepted = 0;
    for (int round = 0; round < 3'000; ++round) {
      std::string text = kEverything;
      mutate(text, random);
      if (!readMechanism(text)) continue;
      ++accepted;
      const std::string complaint = schema().complaint(text);
      QVERIFY2(complaint.empty(), (complaint + "\n" + text).c_str());
    }
    QVERIFY2(accepted > 100, qPrintable(QString::number(accepted)));
  }
};

QTEST_APPLESS_MAIN(SchemaTest)
#include "test_schema.moc"

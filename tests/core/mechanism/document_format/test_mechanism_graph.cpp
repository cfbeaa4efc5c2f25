// The digraph as a file: what is written is read back, whole, in every form.

#include <cgraph.h>

#include <QTest>
#include <QXmlStreamReader>

#include "core/foundations/files/json.h"
#include "core/mechanism/document_format/mechanism_graph.h"
#include "core/mechanism/document_format/mechanism_table.h"
#include "tests/core/mechanism/document_format/support.h"
#include "tests/core/support/example_files.h"

using namespace geargraph;
using namespace geargraph::test;

namespace {

constexpr std::array kForms = {GraphForm::dot, GraphForm::graphMl, GraphForm::nodeLink};

Mechanism readGraph(const std::string& text) {
  const auto form = graphFormOf(text);
  if (!form) qFatal("no form: %s", text.c_str());
  auto reading = readMechanismGraph(text, *form);
  if (!reading) qFatal("%s", reading.error()[0].message.c_str());
  if (!reading->notes.empty()) qFatal("%s", reading->notes[0].c_str());
  return reading->mechanism;
}

/// The text as Graphviz writes it after reading it.
std::string throughGraphviz(const std::string& dot) {
  Agraph_t* const graph = agmemread(dot.c_str());
  if (graph == nullptr) return "no graph";
  QTemporaryFile file;
  if (!file.open()) qFatal("no file");
  std::FILE* const out = std::fopen(file.fileName().toLocal8Bit().constData(), "w");
  agwrite(graph, out);
  std::fclose(out);
  agclose(graph);
  return file.readAll().toStdString();
}

}  // namespace

class MechanismGraphTest : public QObject {
  Q_OBJECT

 private slots:
  void everyExampleIsReadBack_data() {
    QTest::addColumn<QString>("name");
    for (const std::string& name : exampleNames())
      QTest::newRow(name.c_str()) << QString::fromStdString(name);
  }
  void everyExampleIsReadBack() {
    QFETCH(QString, name);
    const Mechanism mechanism = example(name.toStdString());
    for (const GraphForm form : kForms) {
      const std::string text = digraphFile(mechanism, form);
      QCOMPARE(graphFormOf(text), std::optional(form));
      QCOMPARE(readGraph(text), tablePart(mechanism).mechanism);
      QCOMPARE(digraphFile(readGraph(text), form), text);
      const auto any = readAnyMechanism(text);
      QVERIFY(any && any->mechanism == tablePart(mechanism).mechanism);
    }
  }

  void everyMemberIsReadBack() {
    for (const GraphForm form : kForms) {
      const std::string text = digraphFile(everything(), form);
      QCOMPARE(readGraph(text), tablePart(everything()).mechanism);
    }
  }

  void documentsAndTablesAreReadBesideGraphs() {
    const Mechanism mechanism = everything();
    const auto document = readAnyMechanism(writeMechanism(mechanism));
    QVERIFY(document && document->mechanism == mechanism && document->notes.empty());
    const auto table = readAnyMechanism(writeMechanismTable(mechanism));
    QVERIFY(table && table->mechanism == tablePart(mechanism).mechanism);
    for (const char* const none : {"", "{}", "[]", "{\"nodes\": 1}", "<", "graph", "digraph", "a,b\n1,2"})
      QVERIFY2(!readAnyMechanism(none), none);
    QCOMPARE(graphFormOf(writeMechanism(mechanism)), std::nullopt);
    QCOMPARE(graphFormOf(writeMechanismTable(mechanism)), std::nullopt);
    QCOMPARE(graphFormOf("# comment\n// another\n/* and\nthis */ STRICT digraph {}"), GraphForm::dot);
  }

  void textsSurvive_data() {
    QTest::addColumn<QString>("text");
    for (const char* const text : {"", " ", "a \"quoted\" \\ name", "ends in \\", "two\nlines\r\nand\ttab",
                                   "<b>&amp;</b>", "]]>", "\\n\\\"", "\xC3\xBC \xE2\x82\xAC \xF0\x9F\x98\x80",
                                   "graph", "// no comment", "-1.5", "true", "null"})
      QTest::newRow(text) << QString::fromUtf8(text);
  }
  void textsSurvive() {
    QFETCH(QString, text);
    Mechanism mechanism = everything();
    const std::string words = text.toStdString();
    mechanism.name = mechanism.notes = mechanism.links[1].name = words;
    if (!words.empty()) {
      mechanism.links[1].id = LinkId(words);
      mechanism.axes[1].id = AxisId(words);
      mechanism.turningJoints[0].id = JointId(words);
      mechanism.turningJoints[0].head = mechanism.wheels[0].link = LinkId(words);
      for (GearMesh& mesh : mechanism.gearMeshes) mesh.tail = LinkId(words);
      mechanism.turningJoints[2].axis = AxisId(words);
      mechanism.inputs->front().joint = JointId(words);
      mechanism.couplings[1].links[0] = mechanism.couplings[2].links[1] = LinkId(words);
      mechanism.states[0].drive = LinkId(words);
      mechanism.loads.clear();
      mechanism.balances.reset();
    }
    for (const GraphForm form : kForms)
      QCOMPARE(readGraph(digraphFile(mechanism, form)), tablePart(mechanism).mechanism);
  }

  void statedNoInputsStayStated() {
    for (const bool isStated : {true, false}) {
      Mechanism mechanism = emptyMechanism();
      if (isStated) mechanism.inputs.emplace();
      if (isStated) mechanism.balances.emplace();
      for (const GraphForm form : kForms) QCOMPARE(readGraph(digraphFile(mechanism, form)), mechanism);
    }
  }

  void graphvizReadsItAndWritesTheSame() {
    for (const Mechanism& mechanism : {everything(), example("robot"), example("simpson")}) {
      const std::string back = throughGraphviz(digraphFile(mechanism, GraphForm::dot));
      QCOMPARE(readGraph(back), tablePart(mechanism).mechanism);
    }
  }

  void theXmlIsWellFormedAndTyped() {
    const std::string text = digraphFile(everything(), GraphForm::graphMl);
    QXmlStreamReader xml(QByteArray::fromStdString(text));
    QMap<QString, QString> types;
    QStringList used;
    while (!xml.atEnd()) {
      if (xml.readNext() != QXmlStreamReader::StartElement) continue;
      if (xml.name() == QLatin1String("key"))
        types[xml.attributes().value("id").toString()] = xml.attributes().value("attr.type").toString();
      if (xml.name() == QLatin1String("data")) used += xml.attributes().value("key").toString();
    }
    QVERIFY(!xml.hasError());
    for (const QString& key : used) QVERIFY2(types.contains(key), qPrintable(key));
    QCOMPARE(types["edge.label"], QString("int"));
    QCOMPARE(types["edge.offset"], QString("double"));
    QCOMPARE(types["edge.faceWidth"], QString("string"));  // 3/8
    QCOMPARE(types["node.pinned"], QString("boolean"));
    QCOMPARE(types["graph.axes"], QString("string"));
  }

  void otherProgramsMayChangeOrderAndNames() {
    // NetworkX 3.4: "edges" for "links", texts as names of nodes, nodes and edges in another order.
    const std::string text =
        R"({"directed": true, "multigraph": true, "graph": {"name": "pair", "geargraph": 1,
      "axes": [{"id": "a"}, {"id": "b"}]},
      "edges": [
        {"source": "1", "target": "2", "key": 5, "label": 5, "kind": "mesh", "tailTeeth": 20, "headTeeth": 30.0},
        {"source": "0", "target": "2", "key": 4, "label": 4, "kind": "turning", "axis": "b"},
        {"source": "0", "target": "1", "key": 3, "label": 3, "kind": "turning", "axis": "a", "offset": "1/3"}],
      "nodes": [{"id": "2", "name": "gear", "mass": null}, {"id": "0"}, {"id": "1"}]})";
    const Mechanism mechanism = readGraph(text);
    QCOMPARE(mechanism.links[2].name, std::string("gear"));
    QCOMPARE(mechanism.turningJoints[0].id, JointId("3"));
    QCOMPARE(mechanism.turningJoints[0].axis, AxisId("a"));
    QCOMPARE(mechanism.turningJoints[0].offset.text(), std::string("1/3"));
    QCOMPARE(mechanism.gearMeshes[0].headTeeth, 30);
    QCOMPARE(mechanism.name, std::string("pair"));
  }
};

QTEST_APPLESS_MAIN(MechanismGraphTest)
#include "test_mechanism_graph.moc"

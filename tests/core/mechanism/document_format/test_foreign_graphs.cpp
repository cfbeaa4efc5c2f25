// Graphs of other programs and of other people: what is read, what was assumed, and what is rejected with its
// place; texts that are made to hurt.

#include <QTest>

#include "core/mechanism/document_format/mechanism_graph.h"
#include "core/mechanism/document_format/mechanism_table.h"
#include "tests/core/mechanism/document_format/support.h"
#include "tests/core/support/example_files.h"

using namespace geargraph;
using namespace geargraph::test;

namespace {

const std::string kPairInDot = R"(// by hand
digraph pair {
  rankdir = LR;
  node [shape=circle] edge [kind=turning]
  frame -> pinion:e [axis=a];
  frame -> wheel [axis="b" color=red];
  subgraph cluster_gears {
    edge [kind="me" + "sh", style=bold]
    pinion -> wheel [tailTeeth=20, headTeeth=30; weight=-.5]
  }
  wheel [name=<the <b>wheel</b>>, mass="22/7"]
}
)";

GraphReading readingOf(const std::string& text) {
  auto reading = readAnyMechanism(text);
  if (!reading) qFatal("%s", reading.error()[0].message.c_str());
  return std::move(reading).value();
}

/// "3:5 schema: sentence" of the first diagnostic, "" of a graph that is read.
QString fault(const std::string& text, GraphForm form) {
  const auto reading = readMechanismGraph(text, form);
  if (reading) return {};
  const Diagnostic& first = reading.error().front();
  return QString("%1:%2 %3: %4")
      .arg(first.line)
      .arg(first.column)
      .arg(QString::fromStdString(std::string(codeName(first.code))), QString::fromStdString(first.message));
}

std::string repeated(const std::string& text, std::size_t times) {
  std::string all;
  for (std::size_t i = 0; i < times; ++i) all += text;
  return all;
}

}  // namespace

class ForeignGraphsTest : public QObject {
  Q_OBJECT

 private slots:
  void aGraphByHandIsAMechanism() {
    const GraphReading reading = readingOf(kPairInDot);
    const Mechanism& mechanism = reading.mechanism;
    QCOMPARE(mechanism.name, std::string("pair"));
    QCOMPARE(mechanism.n(), 2);
    QCOMPARE(mechanism.links[0].id, LinkId("frame"));
    QCOMPARE(mechanism.links[2].name, std::string("the <b>wheel</b>"));
    QCOMPARE(mechanism.links[2].mass->mass.text(), std::string("22/7"));
    QCOMPARE(mechanism.t(), 2);
    QCOMPARE(mechanism.turningJoints[1].id, JointId("4"));
    QCOMPARE(mechanism.turningJoints[1].axis, AxisId("b"));
    QCOMPARE(mechanism.gearMeshes[0].tail, LinkId("pinion"));
    QCOMPARE(mechanism.gearMeshes[0].headTeeth, 30);
    QVERIFY(!mechanism.gearMeshes[0].kind && !mechanism.axes[0].point);
    QCOMPARE(
        reading.notes,
        (std::vector<std::string>{
            "The ground is the first node, \"frame\".",
            "The graph has no places of axes: a and b are placed from the tooth counts.",
            "1 mesh has no \"meshKind\": external between parallel axes, bevel between intersecting ones.",
            "Attributes without a meaning for the mechanism were not read: color, rankdir, shape, style and "
            "weight."}));
    const auto saved = readMechanism(writeMechanism(mechanism));
    QVERIFY(saved && *saved == mechanism);
  }

  void graphMlOfOthersIsRead() {
    // Prefixes, declared defaults, keys for all, values inside other elements, Latin-1.
    const std::string text =
        "<?xml version='1.0' encoding='ISO-8859-1'?>\n<g:graphml "
        "xmlns:g='http://graphml.graphdrawing.org/xmlns'>"
        "<g:key id='d0' for='edge' attr.name='kind' attr.type='string'><g:default>turning</g:default></g:key>"
        "<g:key id='d1' for='all' attr.name='name'/><g:key id='d2' for='node' attr.name='colour'/>"
        "<g:key id='axis' for='edge'/>"
        "<g:graph edgedefault='directed'><g:node id='n'/><g:node id='m'><g:data key='d1'>R\xE4"
        "der</g:data>"
        "<g:data key='d2'><shape><inner/>red</shape></g:data><g:port name='p'/></g:node>"
        "<g:edge source='n' target='m'><g:data key='axis'>a</g:data></g:edge></g:graph></g:graphml>";
    const GraphReading reading = readingOf(text);
    QCOMPARE(reading.mechanism.links[1].name, std::string("R\xC3\xA4"
                                                          "der"));
    QCOMPARE(reading.mechanism.turningJoints[0].axis, AxisId("a"));
    QCOMPARE(reading.notes.back(),
             std::string("Attributes without a meaning for the mechanism were not read: colour."));
  }

  void namesInLabelsAreKept() {
    const GraphReading dot = readingOf(R"(digraph g {
      label = "Two-stage\nreducer";
      node [label="\N"] edge [kind=turning, label=""]
      frame [label="Housing"]
      pinion [label="input\nshaft"]
      wheel [name=gear, label="other"]
      frame -> pinion [axis=a]; frame -> wheel [axis=b, label="bearing"];
      pinion -> wheel [kind=mesh, tailTeeth=20, headTeeth=30, meshKind=external];
      frame -> idler [axis=c, label=7]
      subgraph cluster_x { label="a group"; idler }
    })");
    QCOMPARE(dot.mechanism.name, std::string("Two-stage reducer"));
    const auto nameOf = [&](std::size_t link) { return dot.mechanism.links[link].name; };
    QCOMPARE(nameOf(0), std::string("Housing"));
    QCOMPARE(nameOf(1), std::string("input shaft"));
    QCOMPARE(nameOf(2), std::string("gear"));
    QCOMPARE(nameOf(3), std::string());
    QCOMPARE(dot.notes.back(),
             std::string("Attributes without a meaning for the mechanism were not read: label."));
    const std::string yEd =
        "<graphml><key id='d0' for='edge' attr.name='kind'/><key id='d1' for='edge' attr.name='axis'/>"
        "<key for='node' id='d6' yfiles.type='nodegraphics'/><key for='node' id='d7' attr.name='label'/>"
        "<graph id='G' edgedefault='directed'>"
        "<node id='n0'><data key='d6'><y:ShapeNode><y:Fill color='red'/><y:NodeLabel a='b'>ground<y:M/>\n"
        "</y:NodeLabel><y:NodeLabel>second</y:NodeLabel></y:ShapeNode></data></node>"
        "<node id='n1'><data key='d7'>sun</data></node>"
        "<edge source='n0' target='n1'><data key='d0'>turning</data><data key='d1'>a</data></edge>"
        "</graph></graphml>";
    const GraphReading graphMl = readingOf(yEd);
    QCOMPARE(graphMl.mechanism.links[0].name, std::string("ground"));
    QCOMPARE(graphMl.mechanism.links[1].name, std::string("sun"));
    QCOMPARE(graphMl.mechanism.name, std::string("G"));
  }

  void namesThatAreNoneAreListed() {
    const std::string text =
        "digraph { a [label=\"" + repeated("x", 1001) + "\"] a -> b [kind=turning, axis=c] }";
    const GraphReading reading = readingOf(text);
    QCOMPARE(reading.mechanism.links[0].name, std::string());
    QCOMPARE(reading.notes.back(),
             std::string("Attributes without a meaning for the mechanism were not read: label."));
  }

  void whatIsMissingIsNamedWithItsPlace_data() {
    QTest::addColumn<QString>("text");
    QTest::addColumn<QString>("expected");
    const auto dot = [](const char* name, const char* body, const char* expected) {
      QTest::newRow(name) << QString("digraph {\n  %1\n}").arg(body) << QString(expected);
    };
    dot("kind", "a -> b",
        "2:3 schema: The edge \"a\" -> \"b\" lacks the attribute \"kind\"; expected \"turning\" or "
        "\"mesh\".");
    dot("other kind", "a -> b [kind=prismatic]",
        "2:3 schema: The edge \"a\" -> \"b\": its \"kind\" is \"prismatic\"; expected \"turning\" or "
        "\"mesh\".");
    dot("T-T graph", "a -> b [kind=chord, label=7]",
        "2:3 schema: The edge \"7\" (\"a\" -> \"b\"): its \"kind\" is \"chord\", so this is a T-T graph; the "
        "digraph "
        "(--view digraph) is read back.");
    dot("axis", "a -> b [kind=turning]",
        "2:3 schema: The edge \"a\" -> \"b\" lacks the attribute \"axis\": the name of the axis that the "
        "joint turns "
        "about, the same for joints on one axis.");
    dot("teeth", "a -> b [kind=mesh, tailTeeth=20, edgeId=M]",
        "2:3 schema: The edge \"M\" (\"a\" -> \"b\") lacks the attribute \"headTeeth\": the number of teeth "
        "of the gear "
        "on its second node.");
    dot("no number of teeth", "a -> b [kind=mesh, tailTeeth=20, headTeeth=many]",
        "2:3 schema: The edge \"a\" -> \"b\", headTeeth: expected a whole number from 1 to 100000, found the "
        "string "
        "\"many\".");
    dot("no JSON", "a -> b [kind=mesh, tailTeeth=20, headTeeth=9, pitchPoint=\"1 2 3\"]",
        "2:3 schema: The edge \"a\" -> \"b\", pitchPoint: expected a list or an object as JSON, found \"1 2 "
        "3\".");
    dot("two coordinates", "a -> b [kind=mesh, tailTeeth=20, headTeeth=9, pitchPoint=\"[1, 2]\"]",
        "2:3 schema: The edge \"a\" -> \"b\", pitchPoint: expected a list of three numbers, found a list of "
        "2 elements.");
    dot("kind of mesh", "a -> b [kind=mesh, tailTeeth=20, headTeeth=9, meshKind=friction]",
        "2:3 schema: The edge \"a\" -> \"b\", meshKind: expected \"external\", \"internal\", \"bevel\", "
        "\"belt\", \"pins\", \"rack\", \"screw\", \"crossedHelical\", \"worm\", \"faceGear\" or \"hypoid\", "
        "found "
        "the string \"friction\".");
    dot("loop", "a -> a [kind=turning, axis=x]", "2:3 self-joint: ");
    dot("pinned", "a [pinned=maybe]",
        "2:3 schema: The node \"a\", pinned: expected true or false, found the string \"maybe\".");
    dot("axis of the graph", "graph [axes=\"[{}]\"] a -> b [kind=turning, axis=x]",
        "1:1 schema: The graph, axes/0/id: ");
    dot("unknown axis", "graph [axes=\"[]\"] a -> b [kind=turning, axis=x]", "2:21 unknown-id: ");
    dot("input", "a graph [inputs=\"[{\\\"joint\\\": 7, \\\"speed\\\": 1}]\"]", "1:1 unknown-id: ");
    dot("newer", "graph [geargraph=2]",
        "1:1 version: The graph has version \"2\", but this program reads version 1");
    dot("id twice", "a [linkId=x] b [linkId=x]", "2:16 duplicate-id: ");
    dot("nothing", "", "1:1 schema: The graph has no node; the first one is the ground.");
  }
  void whatIsMissingIsNamedWithItsPlace() {
    QFETCH(QString, text);
    QFETCH(QString, expected);
    const QString found = fault(text.toStdString(), GraphForm::dot);
    QVERIFY2(found.startsWith(expected), qPrintable(found));
  }

  void theCulpritsAreElements() {
    const auto reading = readMechanismGraph(
        "digraph { a -> b [kind=turning, axis=x, edgeId=J]\n b -> c [kind=mesh, edgeId=M] }", GraphForm::dot);
    QVERIFY(!reading);
    QCOMPARE(reading.error().size(), std::size_t{2});
    QCOMPARE(reading.error()[0].elements, std::vector<ElementId>{MeshId("M")});
    QCOMPARE(reading.error()[1].line, 2);
  }

  void faultsOfDotHaveTheirPlace_data() {
    QTest::addColumn<QByteArray>("text");
    QTest::addColumn<QString>("expected");
    const auto row = [](const char* name, const QByteArray& text, const char* expected) {
      QTest::newRow(name) << text << QString(expected);
    };
    row("undirected", "graph { a -- b }", "1:1 format: The graph is undirected");
    row("edge", "digraph { a -- b }", "1:13 syntax: An edge of a directed graph is written ->.");
    row("no head", "digraf {}", "1:1 syntax: Expected \"digraph\", found \"digraf\".");
    row("end", "digraph {\n a -> ", "2:7 syntax: Expected a name, found the end.");
    row("quote", "digraph {\n \"a }", "2:2 syntax: The quote has no end.");
    row("comment", "digraph { /* }", "1:11 syntax: The comment has no end.");
    row("brackets", "digraph { a [b=<c<d>] }", "1:16 syntax: The text in angle brackets has no end.");
    row("character", "digraph { a ? }", "1:13 syntax: This character is no part of DOT.");
    row("number", "digraph { - }", "1:11 syntax: This is no number.");
    row("attributes", "digraph { a [=] }", "1:14 syntax: Expected a name, found \"=\".");
    row("groups", "digraph { {a b} -> c }", "1:17 schema: An edge between groups is not read");
    row("group at the end", "digraph { a -> {b c} }", "1:16 schema: An edge between groups is not read");
    row("two", "digraph {} digraph {}", "1:12 syntax: Behind the graph is something else");
    row("strict", "strict digraph { a->b [kind=turning axis=x] a->b }", "1:45 schema: The graph is strict");
    row("UTF-8", "digraph { \"\xFF\" }", "1:12 syntax: The text is not UTF-8.");
    row("empty", "", "1:1 syntax: Expected \"digraph\", found the end.");
  }
  void faultsOfDotHaveTheirPlace() {
    QFETCH(QByteArray, text);
    QFETCH(QString, expected);
    const QString found = fault(text.toStdString(), GraphForm::dot);
    QVERIFY2(found.startsWith(expected), qPrintable(found));
  }

  void faultsOfGraphMlHaveTheirPlace_data() {
    QTest::addColumn<QString>("text");
    QTest::addColumn<QString>("expected");
    const auto graph = [](const char* name, const char* body, const char* expected) {
      QTest::newRow(name)
          << QString("<graphml>\n<graph edgedefault='directed'>%1</graph></graphml>").arg(body)
          << QString(expected);
    };
    graph("no id", "<node/>", "2:31 schema: The element <node> lacks the attribute \"id\".");
    graph("no target", "<edge source='a'/>",
          "2:31 schema: The element <edge> lacks the attribute \"target\".");
    graph("twice", "<node id='a'/><node id='a'/>",
          "2:45 duplicate-id: The node \"a\" is in the graph twice.");
    graph("no node",
          "<node id='0'/><edge source='0' target='b'><data key='kind'>turning</data><data "
          "key='axis'>a</data></edge>",
          "2:45 unknown-id: The edge \"0\" -> \"b\": there is no node \"b\".");
    graph("undirected", "<edge source='a' target='b' directed='false'/>",
          "2:31 format: The graph is undirected");
    graph("nested", "<node id='a'><graph/></node>", "2:44 schema: A file with one graph is read");
    graph("hyperedge", "<hyperedge/>", "2:31 schema: A hyperedge is not read");
    graph("cut off", "<node id='a'>", "2:46 syntax: This is no XML: mismatched tag.");
    QTest::newRow("undirected")
        << "<graphml><graph edgedefault='undirected'><edge source='a' target='b'/></graph></graphml>"
        << "1:42 format: The graph is undirected";
    QTest::newRow("no graph") << "<graphml/>"
                              << "1:11 format: There is no <graph> in the file.";
    QTest::newRow("HTML") << "<html></html>"
                          << "1:1 format: This is no GraphML: it begins with <html>.";
    QTest::newRow("document type") << "<!DOCTYPE g [<!ENTITY a 'aaa'>]><graphml/>"
                                   << "1:13 format: A file with a document type";
    QTest::newRow("no XML") << "<graphml"
                            << "1:1 syntax: This is no XML: unclosed token.";
  }
  void faultsOfGraphMlHaveTheirPlace() {
    QFETCH(QString, text);
    QFETCH(QString, expected);
    const QString found = fault(text.toStdString(), GraphForm::graphMl);
    QVERIFY2(found.startsWith(expected), qPrintable(found));
  }

  void faultsOfNodeLinkHaveTheirPlace_data() {
    QTest::addColumn<QString>("text");
    QTest::addColumn<QString>("expected");
    const auto row = [](const char* name, const char* text, const char* expected) {
      QTest::newRow(name) << QString(text) << QString(expected);
    };
    row("list", "[]", "1:1 format: This is no node-link graph");
    row("undirected", "{\"directed\": false, \"nodes\": []}", "1:14 format: The graph is undirected");
    row("nodes", "{\"nodes\": {}}", "1:11 format: This is no node-link graph");
    row("links", "{\"nodes\": [], \"links\": 1}", "1:24 format: This is no node-link graph");
    row("no id", "{\"nodes\": [{}]}", "1:12 schema: Expected an object with \"id\"");
    row("tuple", "{\"nodes\": [{\"id\": [1]}]}", "1:19 schema: Expected an object with \"id\"");
    row("number", "{\"nodes\": [3]}", "1:12 schema: Expected an object with \"id\"");
    row("twice", "{\"nodes\": [{\"id\": 1}, {\"id\": \"1\"}]}", "1:23 duplicate-id: ");
    row("member twice", "{\"nodes\": [{\"id\": 1, \"id\": 2}]}", "1:22 schema: /nodes/0/id: ");
    row("name", "{\"nodes\": [{\"id\": 1, \"name\": \"x\", \"linkId\": \"\"}]}",
        "1:12 schema: The node \"1\", linkId: ");
    row("syntax", "{\"nodes\": [}", "1:12 syntax: ");
  }
  void faultsOfNodeLinkHaveTheirPlace() {
    QFETCH(QString, text);
    QFETCH(QString, expected);
    const QString found = fault(text.toStdString(), GraphForm::nodeLink);
    QVERIFY2(found.startsWith(expected), qPrintable(found));
  }

  void atMostAHundredFaultsAreListed() {
    const auto reading = readMechanismGraph("digraph {" + repeated("a -> b\n", 1000) + "}", GraphForm::dot);
    QCOMPARE(reading.error().size(), std::size_t{100});
    QCOMPARE(reading.error().back().line, 100);
  }

  void hostileTextsAreRejected_data() {
    QTest::addColumn<int>("form");
    QTest::addColumn<QByteArray>("text");
    const auto row = [](const char* name, GraphForm form, const std::string& text) {
      QTest::newRow(name) << static_cast<int>(form) << QByteArray::fromStdString(text);
    };
    row("groups in groups", GraphForm::dot, "digraph " + repeated("{", 100'000));
    row("brackets", GraphForm::dot, "digraph { a [b=" + repeated("<", 100'000));
    row("all pairs", GraphForm::dot, "digraph { {" + repeated("a b ", 50'000) + "} -> {c d} }");
    row("a long chain", GraphForm::dot, "digraph { a" + repeated("->a", 300'000) + " }");
    row("long defaults", GraphForm::dot,
        "digraph { edge [kind=turning axis=\"" + std::string(1'000'000, 'x') + "\"] a" +
            repeated("->a", 100'000) + " }");
    row("many defaults", GraphForm::dot,
        "digraph { node [" + repeated("shape=b ", 200'000) + "] " + repeated("a ", 1000));
    row("elements in elements", GraphForm::graphMl, repeated("<graphml>", 100'000));
    row("many keys", GraphForm::graphMl,
        "<graphml>" + repeated("<key id='a' for='node' attr.name='name'><default>x</default></key>", 20'000) +
            "<graph>" + repeated("<node id='a'/>", 20'000) + "</graph></graphml>");
    row("entities", GraphForm::graphMl,
        "<!DOCTYPE a [<!ENTITY b 'bbbbbbbbbb'><!ENTITY c '&b;&b;&b;&b;&b;&b;&b;'>]><graphml>&c;</graphml>");
    row("another file", GraphForm::graphMl,
        "<!DOCTYPE a [<!ENTITY b SYSTEM 'file:///etc/passwd'>]><graphml><graph id='&b;'/></graphml>");
    row("lists in lists", GraphForm::nodeLink, "{\"nodes\": " + repeated("[", 100'000));
  }
  void hostileTextsAreRejected() {
    QFETCH(int, form);
    QFETCH(QByteArray, text);
    const auto reading = readMechanismGraph(text.toStdString(), static_cast<GraphForm>(form));
    QVERIFY(!reading);
    QVERIFY(!reading.error().front().message.empty());
  }

  void limitsAreStated() {
    std::string nodes = "digraph {";
    for (int i = 0; i <= 100'000; ++i) nodes += 'n' + std::to_string(i) + ' ';
    QVERIFY(fault(nodes + '}', GraphForm::dot).contains("at most 100,000 nodes"));
    QVERIFY(fault("digraph { a -> b; a" + repeated("->b;a", 200'000) + "}", GraphForm::dot)
                .contains("at most 200,000 edges"));
    QVERIFY(fault(std::string(kLargestFile + 1, ' '), GraphForm::graphMl).contains("at most 64 MiB"));
  }

  void aLargeTrainIsReadBack() {
    // 20,000 links in a row, each with a joint and a mesh.
    Mechanism mechanism = emptyMechanism();
    for (int i = 1; i <= 20'000; ++i) {
      const std::string id = std::to_string(i);
      mechanism.links.push_back({LinkId(id), "link " + id});
      mechanism.axes.push_back({AxisId(id), {}, {}});
      mechanism.turningJoints.push_back({JointId(id), mechanism.links[0].id, LinkId(id), AxisId(id), {}});
      if (i > 1)
        mechanism.gearMeshes.push_back(
            {MeshId(id), LinkId(std::to_string(i - 1)), LinkId(id), 20, 31, {}, {}, {}, {}, {}});
    }
    for (const GraphForm form : {GraphForm::dot, GraphForm::graphMl, GraphForm::nodeLink}) {
      const auto reading = readMechanismGraph(digraphFile(mechanism, form), form);
      QVERIFY(reading && reading->mechanism == mechanism);
    }
  }
};

QTEST_APPLESS_MAIN(ForeignGraphsTest)
#include "test_foreign_graphs.moc"

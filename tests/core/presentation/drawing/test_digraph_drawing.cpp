#include <QTest>
#include <QXmlStreamReader>
#include <cmath>
#include <limits>
#include <random>

#include "core/mechanism/model/edits.h"
#include "core/mechanism/model/shift_edits.h"
#include "core/presentation/drawing/coupling_marks.h"
#include "core/presentation/drawing/digraph_drawing.h"
#include "core/presentation/drawing/hit_test.h"
#include "core/presentation/drawing/layout.h"
#include "core/presentation/drawing/svg_writer.h"
#include "core/presentation/drawing/text_metrics.h"
#include "tests/core/presentation/drawing/drawing_checks.h"
#include "tests/core/support/aborts.h"
#include "tests/core/support/example_files.h"
#include "tests/core/support/mechanisms.h"

using namespace geargraph;

namespace {

/// Where the target drawing has the robot's nodes.
NodePositions robotPositions() {
  const std::array<CanvasPoint, 8> places{
      {{130, 330}, {300, 330}, {470, 250}, {660, 160}, {130, 190}, {300, 140}, {470, 400}, {660, 340}}};
  NodePositions positions;
  for (std::size_t i = 0; i < places.size(); ++i) positions[LinkId(std::to_string(i))] = places[i];
  return positions;
}

Mechanism drivenRobot() {
  const auto input = [](const char* joint) { return Input{JointId(joint), Number(1), {}}; };
  return withInputs(test::robotTopology(), std::vector<Input>{input("8"), input("9"), input("11")}).value();
}

/// Two links side by side, 200 apart, and one between them.
Mechanism threeLinks() {
  Mechanism mechanism = emptyMechanism();
  mechanism.view.nodes[mechanism.links.front().id] = {0, 0};
  mechanism = withLink(mechanism, {200, 0}).value();
  return withLink(mechanism, {100, 0}).value();
}

/// What lies on what in a drawing, found without the grid that placed it.
QString collisions(const DigraphGeometry& geometry) {
  struct Named {
    QString name;
    Extent box;
  };
  std::vector<Named> boxes;
  for (const EdgePlace& edge : geometry.edges) {
    boxes.push_back({QString("label %1").arg(edge.label), edgeLabelExtent(edge.labelCenter, edge.label)});
  }
  for (const ShiftElementPlace& coupling : geometry.couplings) {
    const double halfWidth = textWidth(coupling.name, kNameSize, true) / 2;
    boxes.push_back({QString("name of ") + QString::fromStdString(coupling.name),
                     {coupling.labelCenter, halfWidth, kNameSize / 2}});
  }
  for (const NodePlace& node : geometry.nodes) {
    if (node.input) boxes.push_back({QString("badge of %1").arg(node.label), badgeExtent(node.badgeCenter)});
    if (!node.name.empty()) {
      const double halfWidth = textWidth(node.name, kNameSize, false) / 2;
      boxes.push_back({QString("name of %1").arg(node.label), {node.nameCenter, halfWidth, kNameSize / 2}});
    }
  }
  QStringList found;
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    const bool badge = boxes[i].name.startsWith("badge");  // it leans on its own node
    for (const NodePlace& node : geometry.nodes) {
      const bool own = badge && boxes[i].name.endsWith(QString(" %1").arg(node.label));
      if (!own && boxes[i].box.meetsCircle(node.center, kNodeRadius + kRingWidth / 2)) {
        found << QString("%1 on node %2").arg(boxes[i].name).arg(node.label);
      }
    }
    for (const EdgePlace& edge : geometry.edges) {
      forEachChord(edge.curve, [&](CanvasPoint from, CanvasPoint to) {
        if (boxes[i].box.grown(kTurningWidth / 2).meetsSegment(from, to)) {
          found << QString("%1 on arrow %2").arg(boxes[i].name).arg(edge.label);
        }
      });
    }
    for (const ShiftElementPlace& coupling : geometry.couplings) {
      forEachChord(coupling.line, [&](CanvasPoint from, CanvasPoint to) {
        if (boxes[i].box.meetsSegment(from, to)) found << boxes[i].name + " on the line of a coupling";
      });
    }
    for (std::size_t j = 0; j < i; ++j) {
      if (boxes[i].box.meets(boxes[j].box)) found << boxes[i].name + " on " + boxes[j].name;
    }
  }
  return found.join(", ");
}

/// Arrows that run over a node.
QString arrowsOverNodes(const DigraphGeometry& geometry) {
  QStringList found;
  for (const EdgePlace& edge : geometry.edges) {
    for (const NodePlace& node : geometry.nodes) {
      if (node.label == edge.tail || node.label == edge.head) continue;
      if (distanceToCurve(node.center, edge.curve) < kNodeRadius + kRingWidth) {
        found << QString("arrow %1 on node %2").arg(edge.label).arg(node.label);
      }
    }
  }
  return found.join(", ");
}

struct Xml {
  QString error;
  QStringList texts;
  int groups = 0;
};
Xml parsed(const std::string& svg) {
  Xml xml;
  QXmlStreamReader reader(QByteArray::fromStdString(svg));
  while (!reader.atEnd()) {
    if (reader.readNext() != QXmlStreamReader::StartElement) continue;
    if (reader.name() == QLatin1String("g")) ++xml.groups;
    if (reader.name() == QLatin1String("text")) xml.texts << reader.readElementText();
  }
  xml.error = reader.errorString();
  return xml;
}

}  // namespace

class DigraphDrawingTest : public QObject {
  Q_OBJECT
 private slots:
  void robotIsDrawnAsInTheGoldenText() {
    Emphases emphases;
    emphases[JointId("9")].walk = 1;
    emphases[JointId("10")].walk = -1;
    emphases[JointId("12")].walk = -1;
    emphases[MeshId("16")].walk = 1;
    emphases[LinkId("3")].selected = true;
    emphases[LinkId("6")].hovered = true;
    const std::string drawn = textOf(digraphDrawing(drivenRobot(), robotPositions(), emphases));
    test::compareWithGolden(
        QString::fromStdString(test::sourcePath("tests/core/presentation/drawing/robot_digraph.txt")), drawn);
  }

  void nothingTouchesAnythingInTheRobot() {
    const DigraphGeometry geometry = digraphGeometry(drivenRobot(), robotPositions());
    QCOMPARE(collisions(geometry) + arrowsOverNodes(geometry), QString());
  }

  void nothingTouchesAnythingInLayouts_data() {
    QTest::addColumn<int>("links");
    QTest::addColumn<int>("meshes");
    QTest::newRow("8") << 7 << 4;
    QTest::newRow("20") << 19 << 12;
    QTest::newRow("40") << 39 << 16;
  }
  void nothingTouchesAnythingInLayouts() {
    QFETCH(int, links);
    QFETCH(int, meshes);
    for (std::uint64_t seed = 1; seed <= 25; ++seed) {
      const Mechanism mechanism = test::randomTree(seed, links, meshes);
      const DigraphGeometry geometry = digraphGeometry(mechanism, layoutOf(mechanism));
      const QString found = collisions(geometry) + arrowsOverNodes(geometry);
      QVERIFY2(found.isEmpty(), qPrintable(QString("seed %1: %2").arg(seed).arg(found)));
    }
  }

  void nothingTouchesAnythingInTheExamples_data() {
    QTest::addColumn<QString>("name");
    for (const std::string& name : test::exampleNames()) {
      QTest::newRow(name.c_str()) << QString::fromStdString(name);
    }
  }
  void nothingTouchesAnythingInTheExamples() {
    QFETCH(QString, name);
    const Mechanism mechanism = test::example(name.toStdString());
    for (const NodePositions& positions : {completedPositions(mechanism), layoutOf(mechanism)}) {
      const DigraphGeometry geometry = digraphGeometry(mechanism, positions);
      QCOMPARE(collisions(geometry) + arrowsOverNodes(geometry), QString());
    }
  }

  void arrowsRunFromRimToRim() {
    const NodePositions positions = robotPositions();
    const DigraphGeometry geometry = digraphGeometry(drivenRobot(), positions);
    QCOMPARE(geometry.edges.size(), std::size_t{11});
    for (const EdgePlace& edge : geometry.edges) {
      const CanvasPoint tail = positions.at(LinkId(std::to_string(edge.tail)));
      const CanvasPoint head = positions.at(LinkId(std::to_string(edge.head)));
      QVERIFY(std::abs(distance(tail, edge.curve.from) - 23.5) < 0.01);
      QVERIFY(std::abs(distance(head, edge.curve.to) - 23.5) < 0.01);
    }
  }

  void arrowsOfTheSameTwoLinksAreApart() {
    Mechanism mechanism = threeLinks();
    const LinkId a = mechanism.links[0].id;
    const LinkId b = mechanism.links[1].id;
    mechanism.view.nodes.erase(mechanism.links[2].id);
    mechanism = withTurningJoint(mechanism, a, b).value();
    mechanism = withGearMesh(mechanism, b, a).value();
    const DigraphGeometry geometry = digraphGeometry(mechanism, mechanism.view.nodes);
    QCOMPARE(geometry.edges.size(), std::size_t{2});
    QVERIFY(distance(geometry.edges[0].curve.at(0.5), geometry.edges[1].curve.at(0.5)) > 25);
    QCOMPARE(collisions(geometry), QString());
  }

  void anArrowIsBentAroundANodeInItsWay() {
    Mechanism mechanism = threeLinks();
    mechanism = withTurningJoint(mechanism, mechanism.links[0].id, mechanism.links[1].id).value();
    const DigraphGeometry geometry = digraphGeometry(mechanism, mechanism.view.nodes);
    QVERIFY(!geometry.edges.front().curve.isStraight());
    QVERIFY(distanceToCurve({100, 0}, geometry.edges.front().curve) >= kNodeRadius + 8);
  }

  void linksWithoutAPlaceAreLeftOut() {
    NodePositions positions = robotPositions();
    positions.erase(LinkId("2"));
    const DigraphGeometry geometry = digraphGeometry(drivenRobot(), positions);
    QCOMPARE(geometry.nodes.size(), std::size_t{7});
    QCOMPARE(geometry.edges.size(), std::size_t{7});
    QVERIFY(geometry.node(LinkId("2")) == nullptr);
    QVERIFY(geometry.edge(JointId("12")) == nullptr);
  }

  void touchingNodesMakeNoBrokenNumbers() {
    Mechanism mechanism = threeLinks();
    mechanism = withTurningJoint(mechanism, mechanism.links[0].id, mechanism.links[1].id).value();
    mechanism = withGearMesh(mechanism, mechanism.links[0].id, mechanism.links[2].id).value();
    for (const double apart : {0.0, 1.0, 40.0, 48.0}) {
      mechanism.view.nodes[mechanism.links[1].id] = {apart, 0};
      const std::string text = textOf(digraphDrawing(mechanism, mechanism.view.nodes, {}));
      QVERIFY2(text.find("nan") == std::string::npos && text.find("inf") == std::string::npos, text.c_str());
    }
  }

  void placesBeyondTheSheetAreDrawnAtItsEnd() {
    NodePositions positions = robotPositions();
    positions[LinkId("3")] = {1e300, -1e300};
    const DigraphGeometry geometry = digraphGeometry(drivenRobot(), positions);
    QCOMPARE(geometry.node(LinkId("3"))->center, (CanvasPoint{kSheetEnd, -kSheetEnd}));
    const std::string text = textOf(digraphDrawing(geometry, {}));
    QVERIFY(text.find("nan") == std::string::npos && text.find("inf") == std::string::npos);
  }

  void motorStandsAtTheLinkThatTheInputMoves() {
    Mechanism mechanism = drivenRobot();
    const auto driven = [](const Mechanism& m) {
      const DigraphGeometry geometry = digraphGeometry(m, robotPositions());
      QStringList links;
      for (const NodePlace& node : geometry.nodes) {
        if (node.input)
          links << QString::number(node.label) + ":" + QString::fromStdString(node.input->text());
      }
      return links.join(" ");
    };
    QCOMPARE(driven(mechanism), QString("4:8 5:9 6:11"));
    mechanism = withFlipped(mechanism, JointId("11")).value();
    QCOMPARE(driven(mechanism), QString("4:8 5:9 6:11"));
  }

  void emphasisIsShownAsTheStyleAsks() {
    const DigraphGeometry geometry = digraphGeometry(drivenRobot(), robotPositions());
    const EdgePlace& edge = geometry.edges.front();
    const auto count = [&](const Emphasis& emphasis, MarkRole role, std::string_view tint) {
      int marks = 0;
      for (const Mark& mark : edgeDrawing(edge, emphasis).marks) {
        const Tint& used = std::visit([](const auto& what) -> const Tint& { return what.tint; }, mark.what);
        marks += mark.role == role && nameOf(used) == tint ? 1 : 0;
      }
      return marks;
    };
    QCOMPARE(count({}, MarkRole::halo, "halo"), 0);
    QCOMPARE(count({.hovered = true}, MarkRole::halo, "halo"), 1);
    QCOMPARE(count({.hovered = true}, MarkRole::line, "ink"), 1);
    QCOMPARE(count({.selected = true}, MarkRole::halo, "halo"), 1);
    QCOMPARE(count({.selected = true}, MarkRole::line, "accent"), 1);
    QCOMPARE(count({.walk = -1}, MarkRole::walk, "accent"), 1);
  }

  void brakesAndClutchesAreDashedLinesOfTheirOwn() {
    Mechanism mechanism = withBrake(drivenRobot(), LinkId("3")).value();
    mechanism = withClutch(mechanism, LinkId("5"), LinkId("4")).value();
    const DigraphGeometry geometry = digraphGeometry(mechanism, robotPositions());
    QCOMPARE(geometry.edges.size(), digraphGeometry(drivenRobot(), robotPositions()).edges.size());
    QCOMPARE(geometry.couplings.size(), std::size_t{2});
    QCOMPARE(collisions(geometry), QString());
    const ShiftElementPlace& brake = geometry.couplings[0];
    QCOMPARE(brake.name, std::string("A"));
    QVERIFY(distance(brake.line.from, robotPositions().at(LinkId("3"))) < kNodeRadius + kRingWidth);
    const ShiftElementPlace& clutch = geometry.couplings[1];
    QVERIFY(distance(clutch.line.from, robotPositions().at(LinkId("5"))) < 2 * kNodeRadius);
    QVERIFY(distance(clutch.line.to, robotPositions().at(LinkId("4"))) < 2 * kNodeRadius);
    const DisplayList list = digraphDrawing(geometry, {});
    const auto count = [&](const ElementId& element, MarkRole role) {
      return std::count_if(list.marks.begin(), list.marks.end(),
                           [&](const Mark& mark) { return mark.element == element && mark.role == role; });
    };
    QVERIFY(count(brake.coupling, MarkRole::hatching) > 2);    // a piece of the frame
    QCOMPARE(count(clutch.coupling, MarkRole::hatching), 0);   // two plates alone
    QCOMPARE(count(clutch.coupling, MarkRole::arrowhead), 0);  // no mesh
    QCOMPARE(elementAt(list.outlines, clutch.plates, 1), std::optional<ElementId>(clutch.coupling));
    // The matrices know nothing of it.
    QCOMPARE(Digraph(mechanism).edgeCount(), Digraph(drivenRobot()).edgeCount());
  }

  void geometryAfterADragIsThatOfAFreshDrawing() {
    Mechanism mechanism = test::randomTree(9, 60, 40);
    for (const std::size_t link : {5, 17, 40})
      mechanism = withBrake(mechanism, mechanism.links[link].id).value();
    mechanism = withClutch(mechanism, mechanism.links[9].id, mechanism.links[30].id).value();
    NodePositions positions = layoutOf(mechanism);
    DigraphGeometry followed = digraphGeometry(mechanism, positions);
    std::mt19937 random(4);
    const auto step = [&] { return static_cast<double>(random() % 121) - 60; };
    for (int move = 0; move < 60; ++move) {
      const int nodes = move % 10 == 9 ? 20 : 1 + move % 3;  // few and many at once
      for (int i = 0; i < nodes; ++i) {
        CanvasPoint& place = positions[mechanism.links[random() % mechanism.links.size()].id];
        place = place + CanvasPoint{step(), step()};
      }
      followed = digraphGeometry(mechanism, positions, followed);
      const DigraphGeometry fresh = digraphGeometry(mechanism, positions);
      QVERIFY(followed.nodes == fresh.nodes);
      QVERIFY(followed.edges == fresh.edges);
      QVERIFY(followed.couplings == fresh.couplings);
    }
  }

  void geometryAfterEditsIsThatOfAFreshDrawing() {
    Mechanism mechanism = test::randomTree(8, 40, 30);
    mechanism.view.nodes = layoutOf(mechanism);
    DigraphGeometry followed = digraphGeometry(mechanism, mechanism.view.nodes);
    std::mt19937 random(7);
    int applied = 0;
    const auto pick = [&](std::size_t count) { return random() % count; };
    const auto step = [&] { return static_cast<double>(pick(1200)); };
    for (int i = 0; i < 80; ++i) {
      Expected<Mechanism> next = mechanism;
      const LinkId some = mechanism.links[pick(mechanism.links.size())].id;
      const LinkId other = mechanism.links[pick(mechanism.links.size())].id;
      const std::array<ElementId, 1> mesh{mechanism.gearMeshes[pick(mechanism.gearMeshes.size())].id};
      const std::array<ElementId, 1> link{some};
      if (i % 6 == 0) next = withLink(mechanism, {step(), step() - 600});
      if (i % 6 == 1) next = withGearMesh(mechanism, some, other);
      if (i % 6 == 2) next = withoutElements(mechanism, mesh);
      if (i % 6 == 3) next = withFlipped(mechanism, mechanism.turningJoints[pick(20)].id);
      if (i % 6 == 4) next = withGround(mechanism, some);
      if (i % 18 == 5) next = withoutElements(mechanism, link);
      if (!next) continue;
      ++applied;
      mechanism = *next;
      followed = digraphGeometry(mechanism, mechanism.view.nodes, followed);
      const DigraphGeometry fresh = digraphGeometry(mechanism, mechanism.view.nodes);
      QVERIFY2(followed.nodes == fresh.nodes && followed.edges == fresh.edges,
               qPrintable(QString::number(i)));
    }
    QVERIFY2(applied > 50, qPrintable(QString::number(applied)));
  }

  void geometryOfAnotherDigraphIsNoStart() {
    const DigraphGeometry robot = digraphGeometry(drivenRobot(), robotPositions());
    Mechanism flipped = withFlipped(drivenRobot(), JointId("11")).value();
    QVERIFY(digraphGeometry(flipped, robotPositions(), robot).edges ==
            digraphGeometry(flipped, robotPositions()).edges);
  }

  // --- picking ---
  void nodesLieAboveArrowsAndLabelsHitTheirArrow() {
    const DigraphGeometry geometry = digraphGeometry(drivenRobot(), robotPositions());
    const DisplayList list = digraphDrawing(geometry, {});
    QCOMPARE(elementAt(list.outlines, {130, 330}), std::optional<ElementId>(LinkId("0")));
    QCOMPARE(elementAt(list.outlines, {215, 333}), std::optional<ElementId>(JointId("10")));
    QCOMPARE(elementAt(list.outlines, geometry.edge(MeshId("17"))->labelCenter),
             std::optional<ElementId>(MeshId("17")));
    QCOMPARE(elementAt(list.outlines, geometry.node(LinkId("6"))->badgeCenter),
             std::optional<ElementId>(JointId("11")));
    QCOMPARE(elementAt(list.outlines, {30, 30}), std::optional<ElementId>());
    QCOMPARE(elementAt(list.outlines, {215, 338}), std::optional<ElementId>());
    QCOMPARE(elementAt(list.outlines, {215, 338}, 5), std::optional<ElementId>(JointId("10")));
  }

  void rubberBandTakesWhatLiesWhollyInside() {
    const DisplayList list = digraphDrawing(drivenRobot(), robotPositions(), {});
    const auto inside = [&](CanvasPoint from, CanvasPoint to) {
      QStringList names;
      for (const ElementId& element : elementsInside(list.outlines, Extent::spanning(from, to))) {
        names << QString::fromStdString(element.id.text());
      }
      names.sort();
      return names.join(" ");
    };
    QCOMPARE(inside({100, 300}, {330, 360}), QString("0 1 10"));
    QCOMPARE(inside({100, 300}, {299, 360}), QString("0 10"));
    QCOMPARE(inside({100, 300}, {250, 360}), QString("0"));
    QCOMPARE(inside({0, 0}, {1, 1}), QString());
  }

  // --- SVG ---
  void svgIsWellFormedWithTextAndElements() {
    Mechanism mechanism = drivenRobot();
    mechanism.links[3].name = "a<b>&\"c\"\x01";
    Emphases emphases;
    emphases[LinkId("3")].selected = true;
    const DisplayList list = digraphDrawing(mechanism, robotPositions(), emphases);
    const std::string svg = svgOf(list, {});
    const Xml xml = parsed(svg);
    QVERIFY2(xml.error.isEmpty(), qPrintable(xml.error));
    for (int label = 0; label <= 18; ++label) QVERIFY(xml.texts.contains(QString::number(label)));
    QCOMPARE(xml.texts.count("motor"), 3);
    QVERIFY(xml.texts.contains("a<b>&\"c\" "));  // what is no XML is a space
    QCOMPARE(xml.groups, static_cast<int>(list.marks.size()) + 1);
    QVERIFY(svg.find("stroke-dasharray") != std::string::npos);
    QVERIFY(svg != svgOf(list, {.theme = Theme::dark}));
  }

  void svgOfNumbersThatAreNotFiniteIsABrokenContract() {
    const auto circleAt = [](double x) {
      DisplayList list;
      list.marks.push_back({ElementId(), MarkRole::line, 0, Fill{Circle{{x, 0}, 1}, ColorRole::secondary}});
      return list;
    };
    const auto infinity = std::numeric_limits<double>::infinity();
    for (const double x : {infinity, -infinity, std::nan("")})
      QVERIFY(test::aborts([&] { (void)svgOf(circleAt(x), {}); }));
    QVERIFY(parsed(svgOf(circleAt(1e300), {})).error.isEmpty());
  }

  void emptyDrawingIsAnEmptySheet() {
    const Xml xml = parsed(svgOf({}, {}));
    QVERIFY2(xml.error.isEmpty(), qPrintable(xml.error));
    QVERIFY(xml.texts.isEmpty());
  }

  // --- text ---
  void longNamesAreCutBetweenCharacters() {
    QCOMPARE(elided("short", 8), std::string("short"));
    QCOMPARE(elided("exactly8", 8), std::string("exactly8"));
    QCOMPARE(elided("nine char", 8), std::string("nine ch…"));
    QCOMPARE(elided("äöüäöüäöü", 4), std::string("äöü…"));
  }
};

QTEST_GUILESS_MAIN(DigraphDrawingTest)
#include "test_digraph_drawing.moc"

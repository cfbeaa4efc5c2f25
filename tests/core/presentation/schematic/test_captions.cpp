#include <QTest>

#include "core/mechanism/model/edits.h"
#include "core/presentation/drawing/captions.h"
#include "core/presentation/drawing/digraph_drawing.h"
#include "core/presentation/drawing/layout.h"
#include "core/presentation/drawing/text_metrics.h"
#include "core/presentation/drawing/tt_graph_drawing.h"
#include "core/presentation/drawing/tt_graph_layout.h"
#include "core/presentation/schematic/schematic.h"
#include "core/theory/analysis/analysis.h"
#include "tests/core/support/example_files.h"

namespace geargraph {
namespace {

DisplayList drawingOf(const Mechanism& mechanism, const QString& view) {
  if (view == "digraph") return digraphDrawing(mechanism, completedPositions(mechanism), {});
  if (view == "schematic") return schematicDrawing(schematicGeometry(mechanism), {});
  const SnapshotPtr snapshot = analyzeLive(std::make_shared<const Mechanism>(mechanism));
  const TtGraph* graph = snapshot->kinematics ? snapshot->kinematics->ttGraph.get() : nullptr;
  return ttGraphDrawing(
      ttGraphGeometry(mechanism, graph, ttPositions(ttLayout(mechanism, graph), mechanism.view.ttNodes)), {});
}

double sizeFor(const QString& view) {
  return view == "schematic" ? 0 : kGraphNameSize;
}

/// The box of a text as it is read: capitals and digits.
Extent boxOf(const Text& text) {
  return {text.center, textWidth(text.text, text.size, text.bold) / 2, 0.45 * text.size};
}

/// Does a line, a disc, a box or a text of the drawing touch the box? Found without the grid that placed it.
bool touches(const Extent& box, const Mark& mark) {
  if (mark.role == MarkRole::halo) return false;
  if (const auto* text = std::get_if<Text>(&mark.what)) return boxOf(*text).meets(box);
  const auto* stroke = std::get_if<Stroke>(&mark.what);
  const Shape& shape = stroke != nullptr ? stroke->shape : std::get<Fill>(mark.what).shape;
  if (const auto* circle = std::get_if<Circle>(&shape))
    return box.meetsCircle(circle->center, circle->radius);
  if (const auto* other = std::get_if<Box>(&shape)) return other->extent.meets(box);
  bool found = false;
  const auto visit = [&](CanvasPoint from, CanvasPoint to) { found = found || box.meetsSegment(from, to); };
  if (const auto* curve = std::get_if<Curve>(&shape)) {
    forEachChord(*curve, visit);
  } else {
    const auto& points = std::get<Polyline>(shape).points;
    for (std::size_t i = 1; i < points.size(); ++i) visit(points[i - 1], points[i]);
  }
  return found;
}

QStringList textsOf(const std::vector<Mark>& marks, ElementKind kind) {
  QStringList texts;
  for (const Mark& mark : marks) {
    if (mark.element.kind == kind) texts << QString::fromStdString(std::get<Text>(mark.what).text);
  }
  return texts;
}

}  // namespace

/// Names and teeth beside the labels of drawings.
class CaptionsTest : public QObject {
  Q_OBJECT

 private slots:
  void theyTouchNothing_data() {
    QTest::addColumn<QString>("name");
    QTest::addColumn<QString>("view");
    for (const std::string& name : test::exampleNames()) {
      for (const char* view : {"digraph", "ttgraph", "schematic"})
        QTest::addRow("%s %s", name.c_str(), view) << QString::fromStdString(name) << QString(view);
    }
  }
  void theyTouchNothing() {
    QFETCH(QString, name);
    QFETCH(QString, view);
    const Mechanism mechanism = test::example(name.toStdString());
    const DisplayList drawing = drawingOf(mechanism, view);
    const std::vector<Mark> captions = captionsOf(drawing, mechanism, sizeFor(view));
    for (std::size_t i = 0; i < captions.size(); ++i) {
      const auto& text = std::get<Text>(captions[i].what);
      for (const Mark& mark : drawing.marks)
        QVERIFY2(!touches(boxOf(text), mark), qPrintable(QString::fromStdString(text.text)));
      for (std::size_t j = 0; j < i; ++j) QVERIFY(!touches(boxOf(text), captions[j]));
    }
    // The drawing itself stays as it is.
    const DisplayList whole = withCaptions(drawing, mechanism, sizeFor(view));
    QCOMPARE(whole.marks.size(), drawing.marks.size() + captions.size());
    for (const Mark& caption : captions)
      QVERIFY(std::find(whole.marks.begin(), whole.marks.end(), caption) != whole.marks.end());
    QVERIFY(whole.outlines == drawing.outlines);
  }

  void nearlyAllHaveRoom_data() {
    QTest::addColumn<QString>("view");
    for (const char* view : {"digraph", "ttgraph", "schematic"}) QTest::newRow(view) << QString(view);
  }
  void nearlyAllHaveRoom() {
    QFETCH(QString, view);
    for (const char* name : {"robot", "planetary-ring-held", "bevel-differential"}) {
      const Mechanism mechanism = test::example(name);
      const std::vector<Mark> captions = captionsOf(drawingOf(mechanism, view), mechanism, sizeFor(view));
      const auto meshes = std::count_if(mechanism.gearMeshes.begin(), mechanism.gearMeshes.end(),
                                        [](const GearMesh& mesh) { return statesTeeth(mesh); });
      const auto teeth = textsOf(captions, ElementKind::gearMesh).size();
      if (view != "schematic")  // of equal planets one is drawn there
        QVERIFY2(teeth >= (view == "ttgraph" ? 2 : 1) * meshes - 1, name);
      QVERIFY2(textsOf(captions, ElementKind::link).size() >= 2, name);
    }
  }

  void teethAreThoseOfTailAndHead() {
    const Mechanism robot = test::example("robot");
    QVERIFY(textsOf(captionsOf(drawingOf(robot, "digraph"), robot, kGraphNameSize), ElementKind::gearMesh)
                .contains("z 18 : 36"));
    const QStringList chords =
        textsOf(captionsOf(drawingOf(robot, "ttgraph"), robot, kGraphNameSize), ElementKind::gearMesh);
    QVERIFY(chords.contains("z 18") && chords.contains("z 36"));
  }

  void whatHasNoNameOrNoTeethHasNone() {
    Mechanism plain = test::example("spur-pair");
    for (Link& link : plain.links) link.name = {};
    plain.gearMeshes[0].kind = MeshKind::pins;
    settleWeights(plain.gearMeshes[0]);
    QVERIFY(captionsOf(drawingOf(plain, "digraph"), plain).empty());
    plain.links[1].name = "1";  // its label
    QVERIFY(captionsOf(drawingOf(plain, "digraph"), plain).empty());
    QVERIFY(captionsOf({}, plain).empty());
  }
};

}  // namespace geargraph

QTEST_APPLESS_MAIN(geargraph::CaptionsTest)
#include "test_captions.moc"

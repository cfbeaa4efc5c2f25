#include <QTest>
#include <set>

#include "core/mechanism/model/pins.h"
#include "core/presentation/drawing/hit_test.h"
#include "core/presentation/drawing/text_metrics.h"
#include "core/presentation/schematic/schematic.h"
#include "tests/core/presentation/drawing/drawing_checks.h"
#include "tests/core/support/example_files.h"
#include "tests/core/support/textbook_trains.h"
#include "tests/core/support/train_sketch.h"

using namespace geargraph;

namespace {

Mechanism example(const QString& name) {
  return test::example(name.toStdString());
}

QString nameOf(const ElementId& element) {
  return QString::fromStdString(std::string(listName(element.kind)) + "/" + element.id.text());
}

struct Segment {
  CanvasPoint from;
  CanvasPoint to;
  ElementId element;
  std::optional<int> link;  ///< whose colour it has
};

/// Every line of a drawing in straight pieces.
std::vector<Segment> segmentsOf(const SchematicGeometry& geometry) {
  std::vector<Segment> segments;
  for (const Mark& mark : geometry.marks) {
    const auto* stroke = std::get_if<Stroke>(&mark.what);
    if (stroke == nullptr) continue;
    const auto add = [&](CanvasPoint from, CanvasPoint to) {
      segments.push_back({from, to, mark.element, stroke->tint.link});
    };
    if (const auto* line = std::get_if<Polyline>(&stroke->shape)) {
      for (std::size_t i = 1; i < line->points.size(); ++i) add(line->points[i - 1], line->points[i]);
    }
    if (const auto* curve = std::get_if<Curve>(&stroke->shape)) forEachChord(*curve, add);
  }
  return segments;
}

struct Label {
  QString text;
  Extent box;
};

/// Texts and the discs that links' numbers stand in.
std::vector<Label> labelsOf(const SchematicGeometry& geometry) {
  std::vector<Label> labels;
  for (const Mark& mark : geometry.marks) {
    const auto* text = std::get_if<Text>(&mark.what);
    if (text == nullptr) continue;
    Extent box{text->center, textWidth(text->text, text->size, text->bold) / 2, text->size / 2};
    for (const Mark& other : geometry.marks) {
      const auto* disc = std::get_if<Fill>(&other.what);
      if (disc != nullptr && other.element == mark.element && other.role == MarkRole::node) {
        box = extentOf(disc->shape);
      }
    }
    labels.push_back({nameOf(mark.element) + " " + QString::fromStdString(text->text), box});
  }
  return labels;
}

QStringList labelsInTheWay(const SchematicGeometry& geometry) {
  QStringList found;
  const std::vector<Label> labels = labelsOf(geometry);
  const std::vector<Segment> segments = segmentsOf(geometry);
  for (std::size_t i = 0; i < labels.size(); ++i) {
    for (const Segment& segment : segments) {
      if (labels[i].box.meetsSegment(segment.from, segment.to)) {
        found << labels[i].text + " on a line of " + nameOf(segment.element);
      }
    }
    for (std::size_t j = 0; j < i; ++j) {
      if (labels[i].box.meets(labels[j].box)) found << labels[i].text + " on " + labels[j].text;
    }
  }
  return found;
}

/// Lines of different links that cut through each other; a clutch's arm may have no way round.
QStringList crossings(const SchematicGeometry& geometry) {
  QStringList found;
  const std::vector<Segment> segments = segmentsOf(geometry);
  const auto side = [](CanvasPoint p, const Segment& s) { return dot(turned(s.to - s.from), p - s.from); };
  for (std::size_t i = 0; i < segments.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      const Segment& a = segments[i];
      const Segment& b = segments[j];
      if (!a.link || !b.link || *a.link == *b.link) continue;
      if (a.element.kind == ElementKind::coupling || b.element.kind == ElementKind::coupling) continue;
      if (side(a.from, b) * side(a.to, b) >= -1e-3 || side(b.from, a) * side(b.to, a) >= -1e-3) continue;
      found << QString("link %1 across link %2 at %3, %4")
                   .arg(*a.link)
                   .arg(*b.link)
                   .arg((a.from.x + a.to.x) / 2)
                   .arg((a.from.y + a.to.y) / 2);
    }
  }
  return found;
}

/// Links, joints and meshes that cannot be seen and that no note and no equal one speaks for.
QStringList missing(const Mechanism& mechanism, const SchematicGeometry& geometry) {
  std::set<ElementId> shown;
  for (const Outline& outline : geometry.outlines) shown.insert(outline.element);
  for (const DrawnPart::Represented& represented : geometry.represented) shown.insert(represented.omitted);
  QStringList found;
  const auto check = [&](const ElementId& element) {
    if (!shown.contains(element)) found << nameOf(element);
  };
  for (std::size_t i = 1; i < mechanism.links.size(); ++i) check(mechanism.links[i].id);
  for (const TurningJoint& joint : mechanism.turningJoints) check(joint.id);
  for (const ShiftElement& coupling : mechanism.couplings) check(coupling.id);
  const Placement placement = placementOf(mechanism);
  for (std::size_t m = 0; m < mechanism.gearMeshes.size(); ++m) {
    if (placement.meshes[m]) check(mechanism.gearMeshes[m].id);
  }
  return found;
}

bool says(const SchematicGeometry& geometry, const QString& words) {
  return std::any_of(geometry.notes.begin(), geometry.notes.end(),
                     [&](const std::string& note) { return QString::fromStdString(note).contains(words); });
}

}  // namespace

/// The drawing as a whole.
class SchematicTest : public QObject {
  Q_OBJECT
 private slots:
  void examplesAreDrawnAsInTheGoldenText_data() {
    QTest::addColumn<QString>("name");
    for (const std::string& name : test::exampleNames()) {
      QTest::newRow(name.c_str()) << QString::fromStdString(name);
    }
  }
  void examplesAreDrawnAsInTheGoldenText() {
    QFETCH(QString, name);
    const QString folder =
        QString::fromStdString(test::sourcePath("tests/core/presentation/schematic/expected/"));
    test::compareWithGolden(folder + name + QStringLiteral(".txt"),
                            textOf(schematicDrawing(schematicGeometry(example(name)), {})));
  }

  void typeCanBeReadInASmallWindow_data() { examplesAreDrawnAsInTheGoldenText_data(); }
  void typeCanBeReadInASmallWindow() {
    QFETCH(QString, name);
    int texts = 0;
    constexpr double kWidth = 780;  // of the drawing in a window of 1366 x 768
    constexpr double kHeight = 345;
    constexpr double kReadable = 9;
    const DisplayList list = schematicDrawing(schematicGeometry(example(name)), {});
    Extent all = extentOf(list.marks.front());
    for (const Mark& mark : list.marks) all = all.united(extentOf(mark));
    const double shown = std::min({1.25, kWidth / (2 * all.halfWidth), kHeight / (2 * all.halfHeight)});
    for (const Mark& mark : list.marks) {
      const auto* text = std::get_if<Text>(&mark.what);
      if (text == nullptr) continue;
      ++texts;
      QVERIFY2(
          text->size * shown >= kReadable,
          qPrintable(
              QStringLiteral("%1: %2 px").arg(QString::fromStdString(text->text)).arg(text->size * shown)));
    }
    QVERIFY(texts > 0);
  }

  void nothingTouchesAnythingInTheExamples_data() { examplesAreDrawnAsInTheGoldenText_data(); }
  void nothingTouchesAnythingInTheExamples() {
    QFETCH(QString, name);
    const SchematicGeometry geometry = schematicGeometry(example(name));
    QCOMPARE(labelsInTheWay(geometry).join(", "), QString());
    QCOMPARE(crossings(geometry).join(", "), QString());
  }

  void everythingIsDrawnInTheExamples_data() { examplesAreDrawnAsInTheGoldenText_data(); }
  void everythingIsDrawnInTheExamples() {
    QFETCH(QString, name);
    const Mechanism mechanism = example(name);
    const SchematicGeometry geometry = schematicGeometry(mechanism);
    QStringList left = missing(mechanism, geometry);
    if (says(geometry, "closes a loop")) left.clear();  // one joint of it and its meshes are told of
    QCOMPARE(left.join(", "), QString());
  }

  /// A hole in the colour of the disc and a pin in that of the output, to which a line of the output comes.
  void pinsAreCirclesOnTheDisc() {
    const Mechanism drive = example("strain-wave");
    const SchematicGeometry geometry = schematicGeometry(drive);
    std::vector<std::optional<int>> colours;
    CanvasPoint centre;
    for (const Mark& mark : geometry.marks) {
      if (mark.element != ElementId(drive.gearMeshes[1].id)) continue;
      if (const auto* fill = std::get_if<Fill>(&mark.what)) {
        const auto* pin = std::get_if<Circle>(&fill->shape);
        if (pin == nullptr || !fill->tint.link) continue;
        centre = pin->center;
        colours.push_back(fill->tint.link);
      } else if (const auto* stroke = std::get_if<Stroke>(&mark.what)) {
        if (std::holds_alternative<Circle>(stroke->shape)) colours.push_back(stroke->tint.link);
      }
    }
    QCOMPARE(colours.size(), std::size_t{2});
    QVERIFY(colours[0] != colours[1]);
    const std::vector<Segment> segments = segmentsOf(geometry);
    QVERIFY(std::any_of(segments.begin(), segments.end(), [&](const Segment& segment) {
      return segment.link == colours[1] &&
             std::min(distance(segment.from, centre), distance(segment.to, centre)) < 4;
    }));
  }

  void labelsAreFreeInTextbookAndRandomTrains() {
    for (const test::TextbookTrain& train : test::textbookTrains()) {
      const SchematicGeometry geometry = schematicGeometry(train.mechanism);
      QVERIFY2(labelsInTheWay(geometry).isEmpty(), qPrintable(QString::fromStdString(train.name)));
      QCOMPARE(missing(train.mechanism, geometry).join(", "), QString());
    }
    for (std::uint64_t seed = 1; seed <= 40; ++seed) {
      const Mechanism mechanism =
          test::randomTrain(seed, 3 + static_cast<int>(seed % 12), 2 + static_cast<int>(seed % 7));
      const SchematicGeometry geometry = schematicGeometry(mechanism);
      QVERIFY2(labelsInTheWay(geometry).isEmpty(),
               qPrintable(QString("seed %1: ").arg(seed) + labelsInTheWay(geometry).join(", ")));
      QCOMPARE(missing(mechanism, geometry).join(", "), QString());
    }
  }

  void theDrawingDependsOnTheMechanismAlone() {
    const Mechanism mechanism = example("robot");
    QCOMPARE(textOf(schematicDrawing(schematicGeometry(mechanism), {})),
             textOf(schematicDrawing(schematicGeometry(mechanism), {})));
  }

  void oneOfEqualPlanetsIsDrawnAndStandsForTheOthers() {
    const Mechanism mechanism = example("three-planets");
    const SchematicGeometry geometry = schematicGeometry(mechanism);
    QVERIFY(says(geometry, "One of 3 equal planets is drawn: 4 and 5 are like 3."));
    const auto halos = [&](const ElementId& element) {
      Emphases emphases;
      emphases[element].hovered = true;
      const DisplayList list = schematicDrawing(geometry, emphases);
      return std::count_if(list.marks.begin(), list.marks.end(), [](const Mark& mark) {
        return mark.role == MarkRole::halo && mark.element == ElementId(LinkId("3"));
      });
    };
    QVERIFY(halos(LinkId("3")) > 0);
    QCOMPARE(halos(LinkId("5")), halos(LinkId("3")));
    QCOMPARE(halos(LinkId("2")), 0);
  }

  void aDrivenPlanetIsDrawnForItself() {
    Mechanism mechanism = example("three-planets");
    mechanism.inputs = std::vector<Input>{{JointId("9"), Number(1), {}}};
    const SchematicGeometry geometry = schematicGeometry(mechanism);
    QVERIFY(says(geometry, "One of 2 equal planets is drawn: 5 is like 3."));
  }

  void whatIsSelectedIsInAccentWithAHalo() {
    const SchematicGeometry geometry = schematicGeometry(example("robot"));
    Emphases emphases;
    emphases[MeshId("17")].selected = true;
    const DisplayList list = schematicDrawing(geometry, emphases);
    int accents = 0;
    int halos = 0;
    for (const Mark& mark : list.marks) {
      if (mark.element != ElementId(MeshId("17"))) continue;
      if (mark.role == MarkRole::halo) ++halos;
      const auto* stroke = std::get_if<Stroke>(&mark.what);
      if (stroke != nullptr && stroke->tint == Tint(ColorRole::accent)) ++accents;
    }
    QVERIFY(halos > 0 && accents > 0);
    const DisplayList plain = schematicDrawing(geometry, {});
    QVERIFY(std::none_of(plain.marks.begin(), plain.marks.end(),
                         [](const Mark& mark) { return mark.role == MarkRole::halo; }));
  }

  void pickingFindsLinksJointsMeshesAndAxes() {
    const SchematicGeometry geometry = schematicGeometry(example("robot"));
    std::set<ElementKind> kinds;
    for (const Mark& mark : geometry.marks) {
      const auto* text = std::get_if<Text>(&mark.what);
      if (text == nullptr) continue;
      const auto found = elementAt(geometry.outlines, text->center);
      QVERIFY(found.has_value());
      QCOMPARE(*found, mark.element);
      kinds.insert(mark.element.kind);
    }
    QCOMPARE(kinds.size(), std::size_t{4});
  }

  void notesSayWhatIsUnfoldedAndWhatDoesNotTouch() {
    QVERIFY(says(schematicGeometry(example("ravigneaux")), "Radii are not to scale"));
    QVERIFY(says(schematicGeometry(example("locked-train")), "dashed line"));
    for (const char* plane : {"robot", "simpson", "planetary-ring-held", "bevel-differential"}) {
      QVERIFY2(schematicGeometry(example(plane)).notes.empty(), plane);
    }
    test::TrainSketch sketch(3);
    sketch.axis("a", {"0", "0", "0"})
        .axis("b", {"0", "0", "0"}, {"0", "1", "0"})
        .axis("c", {"0", "0", "0"}, {"1", "0", "0"});
    sketch.joint(0, 1, "a", "-30").joint(0, 2, "b", "30").joint(0, 3, "c", "30");
    sketch.mesh(1, 2, 20, 20).mesh(1, 3, 20, 20);
    QVERIFY(says(schematicGeometry(sketch.build()), "turned into the sheet"));
  }

  void brakesAndClutchesHaveTwoPlates() {
    const Mechanism mechanism = example("simpson");  // B1 and B2 hold links, C ties two
    const SchematicGeometry geometry = schematicGeometry(mechanism);
    for (const ShiftElement& coupling : mechanism.couplings) {
      std::vector<Polyline> plates;
      int hatches = 0;
      for (const Mark& mark : geometry.marks) {
        if (mark.element != ElementId(coupling.id)) continue;
        if (mark.role == MarkRole::hatching) ++hatches;
        const auto* stroke = std::get_if<Stroke>(&mark.what);
        if (stroke != nullptr && stroke->width > 2.5) plates.push_back(std::get<Polyline>(stroke->shape));
      }
      QCOMPARE(plates.size(), std::size_t{2});
      const CanvasPoint across = unit(plates[0].points[1] - plates[0].points[0]);
      const CanvasPoint between = plates[1].points[0] - plates[0].points[0];
      QVERIFY(std::abs(dot(between, across)) < 1e-6 && length(between) > 3);  // they face each other
      QCOMPARE(hatches > 0, coupling.kind == ShiftElementKind::brake);
    }
    Mechanism without = mechanism;
    without.couplings.clear();
    const auto shafts = [](const SchematicGeometry& drawn) {
      return std::count_if(drawn.marks.begin(), drawn.marks.end(),
                           [](const Mark& mark) { return mark.element.kind != ElementKind::coupling; });
    };
    QCOMPARE(shafts(geometry), shafts(schematicGeometry(without)));
  }

  void whatIsPinnedSaysSo() {
    const Mechanism pinned = withPinMark(example("spur-pair"), AxisId("b"), true).value();
    const auto labels = labelsOf(schematicGeometry(pinned));
    QVERIFY(std::any_of(labels.begin(), labels.end(),
                        [](const Label& label) { return label.text.endsWith("b (pinned)"); }));
  }

  void whatHangsOnNoJointIsToldOf() {
    Mechanism mechanism = example("spur-pair");
    mechanism.links.push_back({LinkId("loose"), "", {}});
    QVERIFY(says(schematicGeometry(mechanism), "Link 3 is not drawn"));
    QVERIFY(says(schematicGeometry(example("robot-to-mend")), "closes a loop"));
    QVERIFY(schematicGeometry(emptyMechanism()).isEmpty());
  }

  void aTrainTooLargeForASheetIsNotDrawn() {
    const int most = static_cast<int>(kMaxDrawnLinks);
    QVERIFY(schematicGeometry(test::randomTrain(3, most, 5)).isTooLarge);
    QVERIFY(!schematicGeometry(example("robot")).isTooLarge);
  }

  void aDrawingThatNobodyWantsAnyMoreIsGivenUp() {
    std::stop_source source;
    source.request_stop();
    QVERIFY(schematicGeometry(example("robot"), source.get_token()).isEmpty());
  }

  /// A bearing that the document has far beyond everything else is drawn at the edge of the sheet.
  void bearingsFarAwayStayOnTheSheet() {
    for (const char* name : {"robot", "planetary-ring-held", "bevel-wrist", "bevel-differential"}) {
      for (const double offset : {1e5, 1e9, 1e15, 1e17, -1e5, -1e9, -1e15, -1e17}) {
        Mechanism mechanism = example(name);
        mechanism.turningJoints.front().offset = Number::fromDouble(offset);
        if (offset < 0) mechanism.turningJoints.back().offset = Number::fromDouble(-offset);
        const SchematicGeometry geometry = schematicGeometry(mechanism);
        QVERIFY(!geometry.isEmpty());
        for (const Mark& mark : geometry.marks) {
          const Extent extent = extentOf(mark);
          QVERIFY(std::abs(extent.center.x) + extent.halfWidth < 1e5 &&
                  std::abs(extent.center.y) + extent.halfHeight < 1e5);
        }
      }
    }
  }

  void anAxisWithoutJointsIsDrawn() {
    Mechanism mechanism = emptyMechanism();
    mechanism.axes.push_back({AxisId("a"),
                              NumberTriple{Number(0), Number(0), Number(0)},
                              NumberTriple{Number(0), Number(0), Number(1)},
                              {}});
    const SchematicGeometry geometry = schematicGeometry(mechanism);
    QVERIFY(std::any_of(geometry.outlines.begin(), geometry.outlines.end(),
                        [](const Outline& outline) { return outline.element == ElementId(AxisId("a")); }));
  }
};

QTEST_APPLESS_MAIN(SchematicTest)
#include "test_schematic.moc"

#include <QTest>

#include "core/machine/body_layout/derived_geometry.h"
#include "core/presentation/diagrams/band_marks.h"
#include "core/presentation/diagrams/band_network.h"
#include "core/presentation/diagrams/power_drawing.h"
#include "core/presentation/diagrams/torque_marks.h"
#include "core/presentation/drawing/digraph_drawing.h"
#include "core/presentation/drawing/layout.h"
#include "core/presentation/drawing/text_metrics.h"
#include "tests/core/support/example_files.h"
#include "tests/core/support/gearboxes.h"
#include "tests/core/support/statics_case.h"
#include "tests/core/support/train_sketch.h"

using namespace geargraph;
using namespace geargraph::test;

namespace {

struct Powered {
  StaticsCase train;
  StaticsReport report;

  Powered(Mechanism mechanism, const StaticsOptions& options)
      : train(std::move(mechanism)),
        report(*analyzeStatics(train.mechanism, train.model, train.placement, train.tt, train.analysis,
                               options)) {}

  [[nodiscard]] PowerPicture picture(int observer = 0) const {
    return powerPicture(train.mechanism, train.model, train.placement, report, observer);
  }
  [[nodiscard]] DisplayList digraph() const { return digraphDrawing(places(), {}); }
  [[nodiscard]] DisplayList digraphBands(int observer = 0) const {
    return digraphPower(picture(observer), train.mechanism, places());
  }
  [[nodiscard]] SchematicGeometry schematic() const { return schematicGeometry(train.mechanism); }
  [[nodiscard]] DisplayList schematicBands(int observer = 0) const {
    return schematicPower(picture(observer), train.mechanism, schematic());
  }
  [[nodiscard]] DisplayList chips(bool isSchematic, const DisplayList& under) const {
    const std::vector<ShownTorque> torques = shownTorques(train.mechanism, report);
    return isSchematic ? schematicTorques(torques, schematic(), under)
                       : digraphTorques(torques, places(), under);
  }

 private:
  [[nodiscard]] DigraphGeometry places() const {
    return digraphGeometry(train.mechanism, completedPositions(train.mechanism));
  }
};

/// Sun at 100 rad/s with 10 N m, ring held, 0.98 a mesh: 1000 W in, 971.7 W out.
Powered planetarySet(int planets = 1, const Rational& torque = 10, bool losses = true,
                     bool stiffness = false) {
  Mechanism set = planetary(24, 18, planets);
  set.inputs = std::vector<Input>{{set.turningJoints[0].id, Number(100), {}},
                                  {set.turningJoints[1].id, Number(0), {}}};
  StaticsOptions options;
  options.loads = {{{}, JointTorque{set.turningJoints[0].id, Number(torque)}}};
  options.balances = {{set.turningJoints[1].id}, {set.turningJoints[2].id}};
  options.losses = losses;
  if (stiffness) options.sharing = LoadSharing::stiffness;
  options.efficiency = Rational(98, 100);
  return {set, options};
}

/// Sun and carrier joined by a countershaft, ring driven, carrier out: power goes round.
Powered closedTrain(int carrierTeeth = 40, int shaftTeeth = 20) {
  Mechanism mechanism = TrainSketch(5)
                            .joint(0, 1, "a")
                            .joint(0, 2, "a")
                            .joint(0, 3, "a")
                            .joint(2, 4, "b")
                            .joint(0, 5, "c")
                            .mesh(1, 4, 24, 18, MeshKind::external)
                            .mesh(4, 3, 18, 60, MeshKind::internal)
                            .mesh(2, 5, carrierTeeth, shaftTeeth, MeshKind::external)
                            .mesh(5, 1, 30, 30, MeshKind::external)
                            .build();
  mechanism.inputs = std::vector<Input>{{mechanism.turningJoints[2].id, Number(1), {}}};
  StaticsOptions options;
  options.loads = {{{}, JointTorque{mechanism.turningJoints[2].id, Number(1)}}};
  options.balances = {{mechanism.turningJoints[1].id}};
  return {mechanism, options};
}

Powered gearboxIn(int state) {
  StaticsOptions options;
  options.state = state;
  return {eightSpeed(), options};
}

Powered robot() {
  Mechanism mechanism = example("robot");
  StaticsOptions options;
  options.loads = {{{}, JointTorque{JointId("14"), Number(10)}}};
  return {mechanism, options};
}

/// 10 N m at the right axle, held by the case and the left one: -20 N m at 1 rad/s, 10 N m at 3/2 rad/s.
Powered differential(bool stiffness = false) {
  StaticsOptions options;
  if (stiffness) options.sharing = LoadSharing::stiffness;
  options.loads = {{{}, JointTorque{JointId("8"), Number(10)}}};
  options.balances = {{JointId("6")}, {JointId("7")}};
  return {example("bevel-differential"), options};
}

/// A bevel wrist whose three motors turn, 0.98 a mesh.
Powered wrist() {
  Mechanism mechanism = example("bevel-wrist");
  mechanism.inputs = std::vector<Input>{
      {JointId("7"), Number(1), {}}, {JointId("8"), Number(2), {}}, {JointId("10"), Number(-1), {}}};
  StaticsOptions options;
  options.loads = {{{}, JointTorque{JointId("12"), Number(10)}}};
  options.losses = true;
  options.efficiency = Rational(98, 100);
  return {mechanism, options};
}

std::vector<std::string> textsOf(const DisplayList& list) {
  std::vector<std::string> texts;
  for (const Mark& mark : list.marks)
    if (const auto* text = std::get_if<Text>(&mark.what)) texts.push_back(text->text);
  return texts;
}

const std::string kUnknown = "? W: shared in unknown parts, not determined";
const std::string kAssumed = "* shared by equal stiffness: an assumption";

bool has(const DisplayList& list, const std::string& text) {
  const auto texts = textsOf(list);
  return std::find(texts.begin(), texts.end(), text) != texts.end();
}

/// The widths of the bands along an element, the widest first.
std::vector<double> widthsAt(const DisplayList& list, const ElementId& element) {
  std::vector<double> widths;
  for (const Mark& mark : list.marks) {
    const auto* stroke = std::get_if<Stroke>(&mark.what);
    if (stroke != nullptr && mark.element == element && mark.z == kBandDepth) widths.push_back(stroke->width);
  }
  std::sort(widths.rbegin(), widths.rend());
  return widths;
}

/// Texts of the bands on lines or texts of the drawing, or on each other.
QString overlaps(const DisplayList& bands, const DisplayList& drawing) {
  QStringList found;
  const auto boxOf = [](const Text& text) {
    return Extent{text.center, textWidth(text.text, text.size, text.bold) / 2, text.size / 2};
  };
  std::vector<std::pair<QString, Extent>> boxes;
  for (const Mark& mark : bands.marks) {
    const auto* text = std::get_if<Text>(&mark.what);
    if (text == nullptr) continue;
    const QString name = QString::fromStdString(text->text);
    const Extent box = boxOf(*text);
    for (const auto& [other, taken] : boxes)
      if (box.meets(taken)) found << name + " on " + other;
    boxes.emplace_back(name, box);
    for (const Mark& drawn : drawing.marks) {
      if (const auto* label = std::get_if<Text>(&drawn.what)) {
        if (box.meets(boxOf(*label))) found << name + " on " + QString::fromStdString(label->text);
        continue;
      }
      const auto* stroke = std::get_if<Stroke>(&drawn.what);
      if (stroke == nullptr) continue;
      const auto check = [&](CanvasPoint from, CanvasPoint to) {
        if (box.meetsSegment(from, to)) found << name + " on a line";
      };
      if (const auto* line = std::get_if<Polyline>(&stroke->shape))
        for (std::size_t i = 1; i < line->points.size(); ++i) check(line->points[i - 1], line->points[i]);
      if (const auto* curve = std::get_if<Curve>(&stroke->shape)) forEachChord(*curve, check);
    }
  }
  return found.join(", ");
}

}  // namespace

class PowerDrawingTest : public QObject {
  Q_OBJECT

 private slots:
  void whatIsDrawnOfAPlanetarySet() {
    const Powered set = planetarySet();
    const PowerPicture picture = set.picture();
    QCOMPARE(picture.fed, 1000.0);
    QCOMPARE(picture.largest, 1000.0);
    QVERIFY(picture.loops.empty());
    // Every link gets as much as it gives.
    std::map<int, double> sums;
    for (const DrawnFlow& flow : picture.flows)
      for (const DrawnPort& port : flow.ports) sums[port.link] += port.power;
    QVERIFY(sums.size() >= 3);
    for (const auto& [link, sum] : sums) QVERIFY2(std::abs(sum) < 1e-9, qPrintable(QString::number(link)));
  }

  void bandsOfADigraphAreAsWideAsTheirPower() {
    const Powered set = planetarySet();
    const DisplayList bands = set.digraphBands();
    const auto& joints = set.train.mechanism.turningJoints;
    QCOMPARE(widthsAt(bands, joints[0].id), std::vector<double>{kWidestBand});
    const std::vector<double> output = widthsAt(bands, joints[2].id);
    QVERIFY(output.size() == 1 && std::abs(output[0] - kWidestBand * 0.9717142857) < 1e-6);
    QVERIFY(widthsAt(bands, joints[1].id).empty());  // a held ring takes nothing
    for (const char* text : {"1000 W", "100 %", "971.7 W", "97.2 %", "seen from the ground"})
      QVERIFY2(has(bands, text), text);
    QVERIFY(has(bands, "14.29 W lost"));
  }

  /// The arrowhead is at the end that takes the power.
  void bandsPointWithTheFlow() {
    const auto tipOf = [](const DisplayList& bands, const ElementId& element) {
      for (const Mark& mark : bands.marks)
        if (const auto* fill = std::get_if<Fill>(&mark.what); fill != nullptr && mark.element == element)
          return std::get<Polyline>(fill->shape).points.front();
      return CanvasPoint{};
    };
    const Powered forward = planetarySet();
    const Powered backward = planetarySet(1, -10, false);
    const Mechanism& mechanism = forward.train.mechanism;
    const ElementId joint = mechanism.turningJoints[0].id;
    const DigraphGeometry places = digraphGeometry(mechanism, completedPositions(mechanism));
    const Curve& course = places.edge(joint)->curve;  // from the ground to the sun
    const CanvasPoint in = tipOf(forward.digraphBands(), joint);
    const CanvasPoint out = tipOf(backward.digraphBands(), joint);
    QVERIFY(distance(in, course.to) < 1 && distance(out, course.from) < 1);
  }

  void anotherObserverSeesOtherPowers() {
    const Powered set = planetarySet();
    const DisplayList bands = set.digraphBands(3);
    QVERIFY(has(bands, "seen from link 3"));
    QVERIFY(has(bands, "714.3 W"));  // the sun's mesh passes 5000/7 W seen from the carrier
    // The carrier is at rest and passes nothing.
    for (const DrawnFlow& flow : set.picture(3).flows)
      for (const DrawnPort& port : flow.ports) QVERIFY(port.link != 3);
  }

  void circulatingPowerIsDrawnAndNamed() {
    const Powered train = closedTrain();
    const PowerPicture picture = train.picture();
    QCOMPARE(picture.loops.size(), std::size_t{1});
    QCOMPARE(picture.loops[0].links, (std::vector{1, 2, 5}));
    for (const DisplayList& bands : {train.digraphBands(), train.schematicBands()}) {
      const bool isNamed = std::any_of(bands.marks.begin(), bands.marks.end(), [](const Mark& mark) {
        const auto* text = std::get_if<Text>(&mark.what);
        return text != nullptr && text->text == "circulates: links 1, 2 and 5, meshes 11, 12, 13 and 14";
      });
      QVERIFY(isNamed);
      const auto core = std::count_if(bands.marks.begin(), bands.marks.end(), [](const Mark& mark) {
        const auto* stroke = std::get_if<Stroke>(&mark.what);
        return stroke != nullptr && mark.z == kBandDepth + 1 &&
               stroke->tint == Tint(ColorRole::accent).softened();
      });
      QVERIFY(core >= 3);
    }
  }

  /// Also where flows add up along a line; the legend says how much the widest is.
  void noBandIsWiderThanTheScale() {
    const Powered train = closedTrain(20, 40);
    const DisplayList bands = train.schematicBands();
    double widest = 0;
    for (const Mark& mark : bands.marks)
      if (const auto* stroke = std::get_if<Stroke>(&mark.what))
        if (!mark.element.id.empty()) widest = std::max(widest, stroke->width);
    QCOMPARE(widest, kWidestBand);
    double most = 0;
    for (const std::string& text : textsOf(bands))
      if (text.ends_with(" W")) most = std::max(most, std::stod(text));
    QVERIFY2(most > train.picture().largest * 1.01, qPrintable(QString::number(most)));
    const std::vector<std::string> texts = textsOf(bands);
    const auto seenFrom = std::find(texts.begin(), texts.end(), "seen from the ground");
    QVERIFY(seenFrom != texts.begin() && seenFrom != texts.end());
    QCOMPARE(*(seenFrom - 1), powerText(most));
  }

  /// One planet is drawn for three, whose shares are not known, but whose sum is.
  void equalPlanetsAreDrawnTogether() {
    const Powered set = planetarySet(3, 10, false);
    QVERIFY(!set.report.flow->of(ElementPower::Kind::mesh, 0).isDetermined);
    QVERIFY(has(set.digraphBands(), kUnknown));
    const DisplayList bands = set.schematicBands();
    QVERIFY(!has(bands, kUnknown));
    QVERIFY(!widthsAt(bands, set.train.mechanism.links[1].id).empty());
    QCOMPARE(widthsAt(bands, set.train.mechanism.links[1].id).front(), kWidestBand);
  }

  /// The gears of a bevel differential share the load in unknown parts, but what goes in and out is known.
  void whatEntersSharedTrainsHasItsPower() {
    const Powered train = differential();
    const DisplayList bands = train.schematicBands();
    QVERIFY(has(bands, kUnknown));
    for (const char* power : {"20 W", "15 W", "5 W"}) QVERIFY2(has(bands, power), power);
  }

  /// Lines within a shared train say what is known of them: nothing, or by an assumption only.
  void linesOfSharedTrainsTellWhatIsKnown() {
    const auto count = [](const DisplayList& list, const std::string& end) {
      const auto texts = textsOf(list);
      return std::count_if(texts.begin(), texts.end(),
                           [&](const std::string& text) { return text.ends_with(end); });
    };
    // Six meshes of three planets: where there is room each has its label in the digraph.
    const DisplayList open = planetarySet(3, 10, false).digraphBands();
    QVERIFY(count(open, "? W") >= 5 && count(open, "? W") <= 6);
    QCOMPARE(count(open, " W*"), std::ptrdiff_t{0});
    QVERIFY(has(open, kUnknown) && !has(open, kAssumed));
    // By stiffness all have their power, marked, and the mark is explained.
    const Powered shared = planetarySet(3, 10, false, true);
    QVERIFY(shared.report.isShared);
    QVERIFY(shared.report.flow->of(ElementPower::Kind::mesh, 0).isAssumed);
    QVERIFY(!shared.report.flow->of(ElementPower::Kind::joint, 0).isAssumed);
    const DisplayList decided = shared.digraphBands();
    QCOMPARE(count(decided, "? W"), std::ptrdiff_t{0});
    QVERIFY(count(decided, " W*") >= 6);
    QVERIFY(has(decided, kAssumed) && !has(decided, kUnknown));
    QVERIFY(has(decided, "1000 W"));  // what the motor feeds needs no assumption
    // Drawn as one planet their sum is known without it.
    QVERIFY(!has(shared.schematicBands(), kAssumed));
    QVERIFY(count(differential().schematicBands(), "? W") >= 1);
    const DisplayList bevels = differential(true).schematicBands();
    QVERIFY(has(bevels, kAssumed) && count(bevels, " W*") >= 1);
    // A train that shares nothing has neither mark.
    for (const DisplayList& plain : {planetarySet().digraphBands(), planetarySet().schematicBands()})
      QVERIFY(!has(plain, kAssumed) && !has(plain, kUnknown) && count(plain, "*") == 0);
  }

  /// Balances are motors, with what was found; loads are none.
  void balancesAreMotorDiscs() {
    const Powered set = planetarySet();
    const std::vector<ShownTorque> torques = shownTorques(set.train.mechanism, set.report);
    QVERIFY(torques[0].tip.empty());
    QCOMPARE(torques[1].tip, std::string("Balance in joint 6: found, it holds the loads with 24.01 N m."));
    QCOMPARE(torques[2].tip, std::string("Balance in joint 7: found, it holds the loads with \xE2\x88\x92"
                                         "34.01 N m. It takes 971.7 W out of the train."));
    const auto shared = [](bool stiffness) {
      const Powered train = differential(stiffness);
      return shownTorques(train.train.mechanism, train.report);
    };
    QCOMPARE(shared(false).size(), shared(true).size());
    for (const bool isSchematic : {false, true}) {
      const DisplayList chips =
          set.chips(isSchematic, isSchematic ? set.schematicBands() : set.digraphBands());
      int discs = 0;
      for (const Mark& mark : chips.marks) {
        const auto* fill = std::get_if<Fill>(&mark.what);
        if (fill == nullptr || !std::holds_alternative<Circle>(fill->shape)) continue;
        ++discs;
        // The disc is inside the chip of its own element, and an M in it.
        const Circle& disc = std::get<Circle>(fill->shape);
        const auto chip =
            std::find_if(chips.outlines.begin(), chips.outlines.end(), [&](const Outline& each) {
              return each.element == mark.element && std::holds_alternative<Box>(each.shape);
            });
        QVERIFY(chip != chips.outlines.end());
        const Extent& box = std::get<Box>(chip->shape).extent;
        QVERIFY(disc.center.x - disc.radius > box.left() && disc.center.y - disc.radius > box.top());
        QVERIFY(std::any_of(chips.marks.begin(), chips.marks.end(), [&](const Mark& other) {
          const auto* text = std::get_if<Text>(&other.what);
          return text != nullptr && text->text == "M" && distance(text->center, disc.center) < 1e-9;
        }));
      }
      QCOMPARE(discs, 2);
    }
  }

  void labelsTouchNothing() {
    for (const Powered& each : {planetarySet(), planetarySet(3, 10, false), closedTrain(), robot(),
                                gearboxIn(0), gearboxIn(8), differential()}) {
      QCOMPARE(overlaps(each.digraphBands(), each.digraph()), QString());
      QCOMPARE(overlaps(each.schematicBands(), schematicDrawing(each.schematic(), {})), QString());
    }
  }

  /// Loads and what holds them have chips beside their elements; the lines to them cross no text.
  void torquesHaveChips() {
    const Powered set = planetarySet();
    const std::vector<ShownTorque> torques = shownTorques(set.train.mechanism, set.report);
    QCOMPARE(torques.size(), std::size_t{3});
    QVERIFY(torques[0].isGiven && torques[0].sense == 1 && torques[0].torque == "T 10 N m");
    QCOMPARE(torques[0].rate, std::string("100 rad/s"));
    // The torques that the program gives are told from those that it finds.
    QVERIFY(torques[1].rate.ends_with("found") && torques[2].rate.ends_with(" rad/s \xC2\xB7 found"));
    QVERIFY(!torques[2].isGiven && torques[2].sense == -1);
    QCOMPARE(torques[2].torque, std::string("T \xE2\x88\x92"
                                            "34.01 N m"));
    for (const bool isSchematic : {false, true}) {
      const DisplayList drawing = isSchematic ? schematicDrawing(set.schematic(), {}) : set.digraph();
      DisplayList under = isSchematic ? set.schematicBands() : set.digraphBands();
      const DisplayList chips = set.chips(isSchematic, under);
      QVERIFY(has(chips, "T 10 N m") && has(chips, torques[2].torque));
      DisplayList all = under;
      all.append(drawing);
      for (const Mark& mark : chips.marks) {
        const auto* line = std::get_if<Stroke>(&mark.what);
        if (line == nullptr || mark.role != MarkRole::line) continue;
        const std::vector<CanvasPoint>& ends = std::get<Polyline>(line->shape).points;
        for (const Mark& other : all.marks)
          if (std::holds_alternative<Text>(other.what))
            QVERIFY(!extentOf(other).meetsSegment(ends.front(), ends.back()));
      }
      const auto boxes = std::count_if(chips.outlines.begin(), chips.outlines.end(), [](const Outline& each) {
        return std::holds_alternative<Box>(each.shape);
      });
      QCOMPARE(boxes, std::ptrdiff_t{3});
    }
  }

  /// Also where lines and labels leave little room around a node.
  void chipsAreNearTheirElements() {
    Mechanism gearbox = eightSpeed();
    StaticsOptions options;
    options.state = 0;
    options.loads = {{{}, LinkTorque{gearbox.links[1].id, {}, Number(10)}},
                     {{}, LinkTorque{gearbox.links[2].id, {}, Number(10)}},
                     {{}, LinkTorque{gearbox.links[4].id, {}, Number(10)}}};
    const Powered train(std::move(gearbox), options);
    for (const bool isSchematic : {false, true}) {
      const DisplayList chips =
          train.chips(isSchematic, isSchematic ? train.schematicBands() : train.digraphBands());
      int lines = 0;
      for (const Mark& mark : chips.marks) {
        const auto* line = std::get_if<Stroke>(&mark.what);
        if (line == nullptr || mark.role != MarkRole::line) continue;
        const std::vector<CanvasPoint>& ends = std::get<Polyline>(line->shape).points;
        QVERIFY2(distance(ends.front(), ends.back()) < 210, "a chip is far from its element");
        ++lines;
      }
      QVERIFY(lines >= 3);
    }
  }

  /// The chip of a load in the middle of a Ravigneaux train stands beside its shaft, not beside another's.
  void chipsOfARavigneauxTrainAreBesideTheirShafts() {
    StaticsOptions options;
    options.loads = {{{}, JointTorque{JointId("9"), Number(-10)}}};
    options.losses = true;
    options.efficiency = Rational(98, 100);
    const Powered train(example("ravigneaux"), options);
    for (const bool isSchematic : {false, true}) {
      const DisplayList chips =
          train.chips(isSchematic, isSchematic ? train.schematicBands() : train.digraphBands());
      int lines = 0;
      for (const Mark& mark : chips.marks) {
        const auto* line = std::get_if<Stroke>(&mark.what);
        if (line == nullptr || mark.role != MarkRole::line) continue;
        const std::vector<CanvasPoint>& ends = std::get<Polyline>(line->shape).points;
        QVERIFY2(distance(ends.front(), ends.back()) < 90,
                 qPrintable(QString::number(distance(ends.front(), ends.back()))));
        ++lines;
      }
      QVERIFY(lines >= 2);
    }
  }

  /// Of a differential whose pinions share in unknown parts, the shafts are drawn.
  void shaftsOfADifferentialAreDrawn() {
    StaticsOptions options;
    options.loads = {{{}, JointTorque{JointId("8"), Number(-10)}}};
    const Powered train(example("bevel-differential"), options);
    const DisplayList digraph = train.digraphBands();
    for (const auto& [joint, part] : {std::pair("6", 1.0), std::pair("7", 0.75), std::pair("8", 0.25)}) {
      const std::vector<double> widths = widthsAt(digraph, JointId(joint));
      QVERIFY2(widths.size() == 1 && std::abs(widths[0] - part * kWidestBand) < 1e-9, joint);
    }
    for (const char* text : {"20 W", "100 %", "15 W", "75 %", "5 W", "25 %"})
      QVERIFY2(has(digraph, text), text);
    QVERIFY(has(train.schematicBands(), "20 W"));
    QCOMPARE(overlaps(train.digraphBands(), train.digraph()), QString());
    QCOMPARE(overlaps(train.schematicBands(), schematicDrawing(train.schematic(), {})), QString());
  }

  /// Arrows of losses cross no label of a band.
  void lossesCrossNoLabels() {
    for (const Powered& each : {planetarySet(), wrist()}) {
      const DisplayList bands = each.digraphBands();
      int arrows = 0;
      for (const Mark& mark : bands.marks) {
        const auto* stroke = std::get_if<Stroke>(&mark.what);
        if (stroke == nullptr || mark.element.id.empty() || mark.z != kBandDepth + 2) continue;
        ++arrows;
        const std::vector<CanvasPoint>& ends = std::get<Polyline>(stroke->shape).points;
        for (const Mark& other : bands.marks)
          if (const auto* text = std::get_if<Text>(&other.what))
            QVERIFY2(!extentOf(other).meetsSegment(ends.front(), ends.back()), text->text.c_str());
      }
      QVERIFY(arrows >= 2);
    }
  }

  void withoutPowerThereIsNothing() {
    StaticsOptions none;
    const Powered still(planetary(24, 18), none);
    QVERIFY(still.picture().isEmpty());
    QVERIFY(still.digraphBands().marks.empty() && still.schematicBands().marks.empty());
  }

  /// A bar with a branch: what enters at one end leaves at both others.
  void powerGoesAlongTheLinesOfALink() {
    BandNetwork lines;
    lines.addLine({0, 0}, {100, 0});
    lines.addLine({60, 0}, {60, 50});  // ends on the bar
    lines.addLine({0, 40}, {20, 40});  // apart: bridged
    const auto runs = lines.runs({{{0, 0}, 10, 0}, {{60, 50}, -6, 0}, {{100, 0}, -4, 0}});
    QCOMPARE(runs.size(), std::size_t{3});
    for (const BandNetwork::Run& run : runs) {
      const CanvasPoint from = run.course.front();
      const CanvasPoint to = run.course.back();
      if (from == CanvasPoint{0, 0}) QVERIFY((to == CanvasPoint{60, 0}) && run.power == 10);
      if (to == CanvasPoint{60, 50}) QVERIFY((from == CanvasPoint{60, 0}) && run.power == 6);
      if (to == CanvasPoint{100, 0}) QVERIFY((from == CanvasPoint{60, 0}) && run.power == 4);
    }
    QVERIFY((lines.nearest({70, 3}) == CanvasPoint{70, 0}));
    QVERIFY((lines.nearestEnd({90, 3}, 20) == CanvasPoint{100, 0}));
    QVERIFY((lines.nearestEnd({75, 3}, 20) == CanvasPoint{75, 0}));
    const auto bridged = lines.runs({{{0, 40}, 5, 0}, {{100, 0}, -5, 0}});
    double length = 0;
    for (const BandNetwork::Run& run : bridged) {
      QCOMPARE(run.power, 5.0);
      for (std::size_t i = 1; i < run.course.size(); ++i)
        length += distance(run.course[i - 1], run.course[i]);
    }
    QCOMPARE(length, 140.0);
  }

  void powersAreShownWithTheirUnits() {
    QCOMPARE(powerText(495.68), std::string("495.7 W"));
    QCOMPARE(powerText(1000), std::string("1000 W"));
    QCOMPARE(powerText(12345), std::string("12.35 kW"));
    QCOMPARE(powerText(2.5e6), std::string("2.5 MW"));
    QCOMPARE(powerText(0.0012), std::string("1.2 mW"));
    QCOMPARE(powerText(1e-7), std::string("1e-07 W"));
  }
};

QTEST_APPLESS_MAIN(PowerDrawingTest)
#include "test_power_drawing.moc"

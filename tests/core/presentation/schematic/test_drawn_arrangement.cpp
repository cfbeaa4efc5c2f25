#include <QTest>
#include <algorithm>
#include <cmath>
#include <map>

#include "core/machine/body_layout/arrangement.h"
#include "core/machine/body_layout/derived_geometry.h"
#include "core/presentation/schematic/drawn_train.h"
#include "core/presentation/schematic/schematic.h"
#include "core/presentation/schematic/shaft_plan.h"
#include "tests/core/support/example_files.h"
#include "tests/core/support/textbook_trains.h"
#include "tests/core/support/train_sketch.h"

using namespace geargraph;

namespace {

std::size_t at(int i) {
  return static_cast<std::size_t>(i);
}

/// A train as the 3D view shows it, and its schematic.
struct Drawn {
  explicit Drawn(const Mechanism& mechanism)
      : document(mechanism),
        part(drawnPart(document.placed())),
        train(*drawnTrain(part, document)),
        layout(sheetLayout(part, train.placement, train.wheels)),
        plan(shaftPlan(part, train, layout)) {}

  DerivedGeometry document;
  DrawnPart part;
  DrawnTrain train;
  SheetLayout layout;
  ShaftPlan plan;

  [[nodiscard]] const Arrangement& arrangement() const { return *document.arrangement(); }

  /// Positions in the part of what has this position in the document; -1: it is not drawn.
  [[nodiscard]] int link(int position) const { return find(part.linkLabels, position); }
  [[nodiscard]] int joint(int position) const {
    return find(part.jointLabels, document.mechanism().jointLabel(position));
  }
  [[nodiscard]] int mesh(int position) const {
    return find(part.meshLabels, document.mechanism().meshLabel(position));
  }
  /// The sheet's axis of a class of the document; -1: it is not drawn.
  [[nodiscard]] int axis(int axisGroup) const {
    const AxisGroups& classes = *document.placement().classes;
    for (std::size_t j = 0; j < classes.classOf.size(); ++j) {
      const int drawn = joint(static_cast<int>(j));
      if (classes.classOf[j] == axisGroup && drawn >= 0) return plan.bearings[at(drawn)].axis;
    }
    return -1;
  }

  /// px of something that the arrangement has on an axis; none: it is not drawn.
  [[nodiscard]] std::optional<double> onSheet(const AxisPlace& place, int onAxis) const {
    switch (place.kind) {
      case AxisPlace::Kind::wheel: {
        const SheetWheel* wheel = wheelOf(place.index);
        return wheel == nullptr ? std::nullopt : std::optional(wheel->at);
      }
      case AxisPlace::Kind::bearing: {
        const int drawn = joint(place.index);
        return drawn < 0 ? std::nullopt : std::optional(plan.bearings[at(drawn)].at);
      }
      case AxisPlace::Kind::arm: {
        const ArmPlan& arm = arrangement().arms[at(place.index)];
        const int held = joint(document.placement().tree->joint[at(arm.child)]);
        const auto found = std::find_if(plan.arms.begin(), plan.arms.end(), [&](const SheetArm& a) {
          return a.joint == held && a.axis == onAxis;
        });
        return held < 0 || found == plan.arms.end() ? std::nullopt : std::optional(found->at);
      }
      case AxisPlace::Kind::ringCarrier: {
        const SheetWheel* ring = wheelOf(place.index);
        const auto found = std::find_if(plan.ringCarriers.begin(), plan.ringCarriers.end(),
                                        [&](const RingCarrierSymbol& ringCarrier) {
                                          return &layout.wheels[at(ringCarrier.wheel)] == ring;
                                        });
        return found == plan.ringCarriers.end() ? std::nullopt : std::optional(found->at);
      }
    }
    return std::nullopt;
  }

 private:
  static int find(const std::vector<int>& labels, int label) {
    const auto found = std::find(labels.begin(), labels.end(), label);
    return found == labels.end() ? -1 : static_cast<int>(found - labels.begin());
  }
  [[nodiscard]] const SheetWheel* wheelOf(int gear) const {
    const TrainGear& whole = document.train()->gears[at(gear)];
    for (const SheetWheel& wheel : layout.wheels) {
      const bool sharesMesh = std::any_of(whole.meshes.begin(), whole.meshes.end(), [&](int m) {
        return std::find(wheel.meshes.begin(), wheel.meshes.end(), mesh(m)) != wheel.meshes.end();
      });
      if (sharesMesh && wheel.link == link(whole.link)) return &wheel;
    }
    return nullptr;
  }
};

struct NamedTrain {
  std::string name;
  Mechanism mechanism;
};

/// All examples with a train, the trains of textbooks, and 200 random ones.
std::vector<NamedTrain> allTrains() {
  std::vector<NamedTrain> trains;
  for (const std::string& name : test::exampleNames()) {
    Mechanism mechanism = test::example(name);
    if (placementOf(mechanism).tree) trains.push_back({name, std::move(mechanism)});
  }
  for (const test::TextbookTrain& train : test::textbookTrains())
    trains.push_back({train.name, train.mechanism});
  for (std::uint64_t seed = 1; seed <= 200; ++seed)
    trains.push_back({"seed " + std::to_string(seed), test::randomTrain(seed, 3 + static_cast<int>(seed % 6),
                                                                        2 + static_cast<int>(seed % 5))});
  return trains;
}

const char* nameOf(AxisPlace::Kind kind) {
  constexpr const char* kNames[] = {"wheel", "bearing", "arm", "ring carrier"};
  return kNames[static_cast<int>(kind)];
}

/// Where the bars of a joint's bearing are on the sheet.
std::optional<CanvasPoint> barsOf(const SchematicGeometry& drawing, const ElementId& joint) {
  for (const Mark& mark : drawing.marks) {
    const auto* stroke = std::get_if<Stroke>(&mark.what);
    if (stroke == nullptr || mark.element != joint || mark.role != MarkRole::line) continue;
    if (!stroke->tint.link) continue;
    const auto& points = std::get<Polyline>(stroke->shape).points;
    return between(points.front(), points.back(), 0.5);
  }
  return std::nullopt;
}

}  // namespace

/// The machine in the schematic is the machine in 3D.
class DrawnArrangementTest : public QObject {
  Q_OBJECT
 private slots:
  void orderAlongEachAxisIsTheArrangements() {
    int compared = 0;
    for (const auto& [name, mechanism] : allTrains()) {
      const Drawn drawn(mechanism);
      const Arrangement& arrangement = drawn.arrangement();
      for (std::size_t c = 0; c < arrangement.axes.size(); ++c) {
        const int axis = drawn.axis(static_cast<int>(c));
        if (axis < 0) continue;
        const Vector3 direction = drawn.layout.axes[at(axis)].direction;
        const Eigen::Vector3d& along = arrangement.axes[c].direction;
        const double way = along.dot(Eigen::Vector3d(direction[0], direction[1], direction[2])) < 0 ? -1 : 1;
        const AxisPlace* before = nullptr;
        std::optional<double> atBefore;
        const auto places = placesAlong(arrangement, *drawn.document.train(), static_cast<int>(c));
        for (const AxisPlace& place : places) {
          const bool isHatching = place.link == 0 && place.kind != AxisPlace::Kind::wheel;
          const auto x = isHatching ? std::nullopt : drawn.onSheet(place, axis);
          if (!x) continue;
          if (before != nullptr && arrangement.axes[c].isBelow(before->at, place.at)) {
            ++compared;
            // Not parallel: pitch lines are to scale, but not shorter than can be seen.
            const bool areWheels =
                place.kind == AxisPlace::Kind::wheel && before->kind == AxisPlace::Kind::wheel;
            const double slack = areWheels && !drawn.layout.parallel ? kBarHalf : 0;
            QVERIFY2(way * *atBefore < way * *x + slack,
                     qPrintable(QString("%1, axis %2: %3 of link %4 at %5 px, %6 of link %7 at %8 px")
                                    .arg(name.c_str())
                                    .arg(c)
                                    .arg(nameOf(before->kind))
                                    .arg(before->link)
                                    .arg(*atBefore)
                                    .arg(nameOf(place.kind))
                                    .arg(place.link)
                                    .arg(*x)));
          }
          before = &place;
          atBefore = x;
        }
      }
    }
    QVERIFY2(compared > 2000, qPrintable(QString::number(compared)));
  }

  void shaftsAreNestedAsInTheArrangement() {
    int compared = 0;
    int hollow = 0;
    for (const auto& [name, mechanism] : allTrains()) {
      const Drawn drawn(mechanism);
      const Arrangement& arrangement = drawn.arrangement();
      for (std::size_t c = 0; c < arrangement.axes.size(); ++c) {
        const int axis = drawn.axis(static_cast<int>(c));
        if (axis < 0) continue;
        std::map<int, int> deepest;  // by link of the part
        for (const SheetShaft& shaft : drawn.plan.shafts) {
          if (shaft.axis != axis) continue;
          int& lane = deepest.try_emplace(shaft.link, shaft.lane).first->second;
          lane = std::max(lane, shaft.lane);
        }
        for (std::size_t l = 1; l < mechanism.links.size(); ++l) {
          const auto found = deepest.find(drawn.link(static_cast<int>(l)));
          const int depth = nestingDepth(arrangement, static_cast<int>(c), static_cast<int>(l));
          if (found == deepest.end() || depth < 0) continue;
          ++compared;
          hollow += depth > 0 ? 1 : 0;
          QVERIFY2(found->second == depth, qPrintable(QString("%1, axis %2, link %3: lane %4, depth %5")
                                                          .arg(name.c_str())
                                                          .arg(c)
                                                          .arg(l)
                                                          .arg(found->second)
                                                          .arg(depth)));
        }
      }
    }
    QVERIFY2(compared > 1000 && hollow > 200, qPrintable(QString("%1 %2").arg(compared).arg(hollow)));
  }

  /// Every shaft of the machine that turns is drawn.
  void shaftsThatTurnAreDrawn() {
    int shafts = 0;
    for (const auto& [name, mechanism] : allTrains()) {
      const Drawn drawn(mechanism);
      for (const ShaftSegment& shaft : drawn.arrangement().shafts) {
        const int axis = drawn.axis(shaft.axisGroup);
        const bool turns = drawn.document.placement().classes->classOfLink(shaft.link) == shaft.axisGroup;
        if (axis < 0 || !turns || shaft.link == 0 || drawn.link(shaft.link) < 0) continue;
        ++shafts;
        QVERIFY2(drawn.plan.shaft(axis, drawn.link(shaft.link), 0) != nullptr,
                 qPrintable(QString("%1: link %2").arg(name.c_str()).arg(shaft.link)));
      }
    }
    QVERIFY(shafts > 1000);
  }

  /// The drawing itself, not only its plan: bars of bearings along their axes.
  void bearingsOfTheDrawingAreInTheArrangementsOrder() {
    int compared = 0;
    for (const auto& [name, mechanism] : allTrains()) {
      const Drawn drawn(mechanism);
      const SchematicGeometry drawing = schematicGeometry(drawn.document);
      for (std::size_t c = 0; c < drawn.arrangement().axes.size(); ++c) {
        const int axis = drawn.axis(static_cast<int>(c));
        if (axis < 0) continue;
        const SheetAxis& sheet = drawn.layout.axes[at(axis)];
        const AxisLayout& line = drawn.arrangement().axes[c];
        const Vector3 d = sheet.direction;
        const double way = line.direction.dot(Eigen::Vector3d(d[0], d[1], d[2])) < 0 ? -1 : 1;
        std::vector<std::pair<double, double>> places;  // in the machine, on the sheet
        for (const Bearing& b : line.bearings) {
          if (!b.isBoss() || drawn.joint(b.joint) < 0) continue;
          const auto bars = barsOf(drawing, mechanism.turningJoints[at(b.joint)].id);
          QVERIFY2(bars.has_value(), name.c_str());
          places.emplace_back(b.at, way * sheet.coordinateOf(*bars));
        }
        std::sort(places.begin(), places.end());
        for (std::size_t i = 1; i < places.size(); ++i) {
          if (!line.isBelow(places[i - 1].first, places[i].first)) continue;
          ++compared;
          QVERIFY2(places[i - 1].second < places[i].second, name.c_str());
        }
      }
    }
    QVERIFY2(compared > 300, qPrintable(QString::number(compared)));
  }

  /// What has no 3D bodies is drawn all the same: no meshes, too many wheels, a loop of turning joints.
  void whatHasNoTrainIsDrawn() {
    Mechanism bare = test::example("robot");
    bare.gearMeshes.clear();
    bare.wheels.clear();
    QVERIFY(!schematicGeometry(bare).isEmpty());
    QVERIFY(!schematicGeometry(test::example("robot-to-mend")).isEmpty());
    Mechanism closed = test::example("simpson");
    closed.turningJoints.push_back(closed.turningJoints.back());
    closed.turningJoints.back().id = JointId("closing");
    QVERIFY(!schematicGeometry(closed).isEmpty());
  }
};

QTEST_APPLESS_MAIN(DrawnArrangementTest)
#include "test_drawn_arrangement.moc"

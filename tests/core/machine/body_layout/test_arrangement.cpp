#include <QTest>
#include <algorithm>
#include <cmath>
#include <iterator>
#include <set>

#include "core/machine/body_layout/arrangement.h"
#include "core/machine/body_layout/complete_train.h"
#include "tests/core/support/example_files.h"
#include "tests/core/support/train_sketch.h"

using namespace geargraph;

namespace {

struct Arranged {
  explicit Arranged(const Mechanism& mechanism)
      : placement(placementOf(mechanism)),
        train(trainOf(mechanism, placement)),
        plan(arrangementOf(mechanism, placement, train)) {}

  Placement placement;
  GearTrain train;
  Arrangement plan;
};

/// All examples with a train, and 200 random trains.
std::vector<std::pair<std::string, Mechanism>> allTrains() {
  std::vector<std::pair<std::string, Mechanism>> trains;
  for (const std::string& name : test::exampleNames()) {
    Mechanism mechanism = test::example(name);
    if (placementOf(mechanism).tree) trains.emplace_back(name, std::move(mechanism));
  }
  for (std::uint64_t seed = 1; seed <= 200; ++seed)
    trains.emplace_back(
        "seed " + std::to_string(seed),
        test::randomTrain(seed, 3 + static_cast<int>(seed % 6), 2 + static_cast<int>(seed % 5)));
  return trains;
}

bool covers(const ShaftSegment& shaft, double coordinate, double slack) {
  return shaft.low - slack <= coordinate && coordinate <= shaft.high + slack;
}

}  // namespace

/// What the header of arrangement.h promises.
class ArrangementTest : public QObject {
  Q_OBJECT
 private slots:
  void everyJointHasOneBearingOnItsAxis() {
    for (const auto& [name, mechanism] : allTrains()) {
      const Arranged arranged(mechanism);
      std::multiset<int> joints;
      for (std::size_t c = 0; c < arranged.plan.axes.size(); ++c) {
        for (const Bearing& b : arranged.plan.axes[c].bearings) {
          joints.insert(b.joint);
          QCOMPARE(arranged.placement.classes->classOf[static_cast<std::size_t>(b.joint)],
                   static_cast<int>(c));
          QVERIFY2(b.placed && std::isfinite(b.at), name.c_str());
        }
      }
      QCOMPARE(joints.size(), mechanism.turningJoints.size());
      for (int j = 0; j < static_cast<int>(joints.size()); ++j) QCOMPARE(joints.count(j), std::size_t{1});
    }
  }

  void shaftsHoldWheelsArmsAndBearings() {
    int held = 0;
    for (const auto& [name, mechanism] : allTrains()) {
      const Arranged arranged(mechanism);
      for (std::size_t c = 0; c < arranged.plan.axes.size(); ++c) {
        const int axisGroup = static_cast<int>(c);
        const double slack = arranged.plan.axes[c].width();
        for (const AxisPlace& place : placesAlong(arranged.plan, arranged.train, axisGroup)) {
          if (place.link == 0) continue;
          const ShaftSegment* shaft = arranged.plan.shaftOf(axisGroup, place.link, place.at);
          const bool isRing =
              place.kind == AxisPlace::Kind::wheel &&
              arranged.train.gears[static_cast<std::size_t>(place.index)].spec.kind == GearKind::internal;
          if (isRing || shaft == nullptr) continue;
          ++held;
          QVERIFY2(covers(*shaft, place.at, slack),
                   qPrintable(QString("%1: link %2 at %3, its shaft [%4, %5]")
                                  .arg(name.c_str())
                                  .arg(place.link)
                                  .arg(place.at)
                                  .arg(shaft->low)
                                  .arg(shaft->high)));
        }
      }
    }
    QVERIFY(held > 2000);
  }

  void shaftsThatOverlapAreNested() {
    int nested = 0;
    for (const auto& [name, mechanism] : allTrains()) {
      const Arranged arranged(mechanism);
      for (const ShaftSegment& a : arranged.plan.shafts) {
        for (const ShaftSegment& b : arranged.plan.shafts) {
          if (&a == &b || a.axisGroup != b.axisGroup || a.link == b.link) continue;
          const AxisLayout& axis = arranged.plan.axes[static_cast<std::size_t>(a.axisGroup)];
          if (!axis.overlap(a.low, a.high, b.low, b.high)) continue;
          QVERIFY2(a.outer <= b.inner || b.outer <= a.inner,
                   qPrintable(QString("%1: links %2 [%3, %4] and %5 [%6, %7], radii %8 and %9")
                                  .arg(name.c_str())
                                  .arg(a.link)
                                  .arg(a.low)
                                  .arg(a.high)
                                  .arg(b.link)
                                  .arg(b.low)
                                  .arg(b.high)
                                  .arg(a.outer)
                                  .arg(b.outer)));
          const int depthA = nestingDepth(arranged.plan, a.axisGroup, a.link);
          const int depthB = nestingDepth(arranged.plan, a.axisGroup, b.link);
          QCOMPARE(a.outer < b.outer, depthA < depthB);
          ++nested;
        }
      }
    }
    QVERIFY(nested > 200);
  }

  /// Shafts run through wheels of others on their axis only where that is reported, and not where one order
  /// of nesting avoids it.
  void shaftsPassTheWheelsOfOthers() {
    int passed = 0;
    int reported = 0;
    for (const auto& [name, mechanism] : allTrains()) {
      const Arranged arranged(mechanism);
      const Arrangement& plan = arranged.plan;
      std::vector<AxisPlace> places;
      for (std::size_t c = 0; c < plan.axes.size(); ++c) {
        const auto onAxis = placesAlong(plan, arranged.train, static_cast<int>(c));
        std::copy_if(onAxis.begin(), onAxis.end(), std::back_inserter(places),
                     [](const AxisPlace& place) { return place.kind == AxisPlace::Kind::wheel; });
      }
      for (const AxisPlace& place : places) {
        const TrainGear& gear = arranged.train.gears[static_cast<std::size_t>(place.index)];
        if (gear.spec.kind == GearKind::internal) continue;
        const double at = place.at;
        const ShaftSegment* own = plan.shaftOf(gear.axisGroup, gear.link, at);
        if (own == nullptr || !covers(*own, at, 0)) continue;
        for (const std::size_t s : plan.shaftsOn[static_cast<std::size_t>(gear.axisGroup)]) {
          const ShaftSegment& other = plan.shafts[s];
          if (other.link == gear.link || !covers(other, at, 0)) continue;
          const bool isReported = std::any_of(
              plan.blocked.begin(), plan.blocked.end(), [&](const std::vector<LinkOrdinal>& links) {
                return std::count(links.begin(), links.end(), gear.link) > 0 &&
                       std::count(links.begin(), links.end(), other.link) > 0;
              });
          ++(other.outer <= own->inner ? passed : reported);
          QVERIFY2(other.outer <= own->inner || isReported,
                   qPrintable(QString("%1: shaft of link %2, wheel of link %3")
                                  .arg(name.c_str())
                                  .arg(other.link)
                                  .arg(gear.link)));
        }
      }
    }
    QVERIFY2(passed > 400, qPrintable(QString::number(passed)));
    QVERIFY2(reported < 120, qPrintable(QString::number(reported)));
  }

  /// Walls of routed links end at their wheels, shafts, pins and other walls.
  void wallsHaveNoDeadEnds() {
    int ends = 0;
    for (const auto& [name, mechanism] : allTrains()) {
      const Arranged arranged(mechanism);
      const Arrangement& plan = arranged.plan;
      for (const WallPlan& wall : plan.walls) {
        const AxisLayout& axis = plan.axes[static_cast<std::size_t>(wall.axisGroup)];
        const double same = 1e-6 * axis.module;
        const bool isLevel = wall.fromAt < wall.toAt;
        QVERIFY(isLevel ? wall.fromRadius == wall.toRadius
                        : wall.fromAt == wall.toAt && wall.fromRadius < wall.toRadius);
        const auto joinsWall = [&](double at, double radius) {
          return std::any_of(plan.walls.begin(), plan.walls.end(), [&](const WallPlan& other) {
            return &other != &wall && other.link == wall.link && other.fromAt - same <= at &&
                   at <= other.toAt + same && other.fromRadius - same <= radius &&
                   radius <= other.toRadius + same;
          });
        };
        const auto joinsWheel = [&](double at) {
          return std::any_of(arranged.train.gears.begin(), arranged.train.gears.end(),
                             [&](const TrainGear& gear) {
                               const double middle = axis.coordinate(gear.pose.translation());
                               return gear.link == wall.link && gear.axisGroup == wall.axisGroup &&
                                      std::abs(middle - at) < gear.spec.faceWidth / 2;
                             });
        };
        const auto joinsPlanets = [&](double at) {
          const auto ofPin = [&](const PinPlan& pin) {
            return pin.link == wall.link && std::abs(pin.level - at) < same;
          };
          return std::any_of(plan.pins.begin(), plan.pins.end(), ofPin);
        };
        const auto joinsDisc = [&](double at, double radius) {  // of a crank, whose hole the pin fills
          return std::any_of(
              plan.revolvedBodies.begin(), plan.revolvedBodies.end(), [&](const RevolvedPlan& body) {
                if (body.link != wall.link || body.axisGroup != wall.axisGroup) return false;
                return std::any_of(body.profiles.begin(), body.profiles.end(), [&](const auto& profile) {
                  const auto outer =
                      std::max_element(profile.begin(), profile.end(),
                                       [](const auto& a, const auto& b) { return a.radius < b.radius; });
                  const auto [low, high] =
                      std::minmax_element(profile.begin(), profile.end(),
                                          [](const auto& a, const auto& b) { return a.height < b.height; });
                  return radius <= outer->radius && low->height <= at && at <= high->height;
                });
              });
        };
        for (const bool isFirst : {true, false}) {
          const double at = isFirst ? wall.fromAt : wall.toAt;
          const double radius = isFirst ? wall.fromRadius : wall.toRadius;
          const bool joins = (isFirst && wall.isOnShaft) || joinsWall(at, radius) || joinsWheel(at) ||
                             joinsPlanets(at) || joinsDisc(at, radius);
          QVERIFY2(joins, qPrintable(QString("%1: link %2 at %3, radius %4")
                                         .arg(name.c_str())
                                         .arg(wall.link)
                                         .arg(at)
                                         .arg(radius)));
          ++ends;
        }
      }
    }
    QVERIFY2(ends > 30, qPrintable(QString::number(ends)));
  }

  void equalTrainsHaveEqualArrangements() {
    for (const char* name : {"robot", "simpson", "bevel-wrist"}) {
      const Arranged one(test::example(name)), other(test::example(name));
      QCOMPARE(one.plan.shafts.size(), other.plan.shafts.size());
      for (std::size_t s = 0; s < one.plan.shafts.size(); ++s) {
        QCOMPARE(one.plan.shafts[s].low, other.plan.shafts[s].low);
        QCOMPARE(one.plan.shafts[s].outer, other.plan.shafts[s].outer);
      }
    }
  }

  /// In no example is anything in the way of anything.
  void examplesAreNotBlocked() {
    for (const std::string& name : test::exampleNames()) {
      const Mechanism mechanism = test::example(name);
      if (!placementOf(mechanism).tree) continue;
      QVERIFY2(Arranged(mechanism).plan.blocked.empty(), name.c_str());
    }
  }

  /// From one bar the wrist's carrier goes up to both ends of the axis across, outside of the wheels on it.
  void aWristIsCarriedByAFork() {
    const Arranged arranged(test::example("bevel-wrist"));
    std::vector<const ArmPlan*> arms;
    for (const ArmPlan& arm : arranged.plan.arms) {
      if (arm.link == 1) arms.push_back(&arm);
    }
    QCOMPARE(arms.size(), std::size_t{2});
    QCOMPARE(arms[0]->to, arms[1]->to);
    QCOMPARE(arms[0]->level, arms[1]->level);
    const AxisLayout& across = arranged.plan.axes[arms[0]->to];
    const double middle = across.coordinate(arranged.plan.axes[arms[0]->from].point);  // at right angles
    QVERIFY((arms[0]->at - middle) * (arms[1]->at - middle) < 0);
    for (const ArmPlan* arm : arms) {
      const auto wheels = across.wheelsOf(arm->child);
      QVERIFY(wheels);
      QVERIFY(arm->at < middle ? arm->at < wheels->low : arm->at > wheels->high);
    }
  }

  /// The crank of a cycloidal drive: its own shaft ends before the disc, and the disc turns on a pin beside
  /// it.
  void aDiscTurnsOnAPinOfItsCrank() {
    for (const char* name : {"cycloidal-drive", "strain-wave"}) {
      const Arranged arranged(test::example(name));
      QVERIFY(arranged.plan.blocked.empty());
      QCOMPARE(arranged.plan.pins.size(), std::size_t{1});
      const PinPlan& pin = arranged.plan.pins.front();
      const AxisLayout& across = arranged.plan.axes[pin.axisGroup];
      QCOMPARE(across.bearings.size(), std::size_t{1});
      const Bearing& bearing = across.bearings.front();
      QVERIFY(bearing.form == BearingForm::pin);
      const auto wheels = across.wheelsOf(bearing.child);
      QVERIFY(wheels);
      const ShaftSegment* own = arranged.plan.shaftOf(pin.home, pin.link, pin.level);
      const ShaftSegment* held = arranged.plan.shaftOf(pin.axisGroup, pin.link, bearing.at);
      QVERIFY(own != nullptr && held != nullptr);
      QVERIFY(own->high < wheels->low || own->low > wheels->high);
      QVERIFY(held->low < wheels->low && held->high > wheels->high);
    }
  }

  /// The sun's shaft runs within the carrier's, the bearing of the carrier is nearer to its arm.
  void aDifferentialIsCarriedByAHollowShaft() {
    const Arranged arranged(test::example("bevel-differential"));
    QCOMPARE(nestingDepth(arranged.plan, 0, 2), 0);
    QCOMPARE(nestingDepth(arranged.plan, 0, 1), 1);
    QCOMPARE(nestingDepth(arranged.plan, 1, 1), -1);
    std::vector<int> bearings;
    for (const AxisPlace& place : placesAlong(arranged.plan, arranged.train, 0)) {
      if (place.kind == AxisPlace::Kind::bearing) bearings.push_back(place.link);
    }
    QCOMPARE(bearings, (std::vector<int>{2, 1, 3}));
  }
};

QTEST_APPLESS_MAIN(ArrangementTest)
#include "test_arrangement.moc"

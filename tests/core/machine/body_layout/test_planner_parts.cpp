#include <QTest>
#include <algorithm>
#include <cmath>
#include <set>

#include "core/machine/body_layout/body_planner.h"
#include "core/machine/body_layout/complete_train.h"
#include "core/machine/body_layout/cross_shaft_bosses.h"
#include "core/machine/body_layout/intersecting_arms.h"
#include "core/machine/body_layout/nested_shafts.h"
#include "core/machine/body_layout/parallel_arms.h"
#include "core/machine/body_layout/pedestals.h"
#include "core/machine/body_layout/ring_carriers.h"
#include "core/machine/body_layout/shaft_clearance.h"
#include "core/machine/body_layout/shaft_extents.h"
#include "core/machine/body_layout/simple_plan.h"
#include "tests/core/support/example_files.h"
#include "tests/core/support/train_sketch.h"

using namespace geargraph;

namespace {

/// A draft with all that it refers to.
struct Drafted {
  explicit Drafted(const Mechanism& mechanism, PlanTries former = {})
      : placement(placementOf(mechanism)),
        train(trainOf(mechanism, placement)),
        tries(std::move(former)),
        draft(mechanism, placement, train, tries, stop) {}

  Placement placement;
  GearTrain train;
  PlanTries tries;
  std::stop_token stop;
  PlanDraft draft;
};

/// All examples with a train, and 60 random trains.
std::vector<std::pair<std::string, Mechanism>> someTrains() {
  std::vector<std::pair<std::string, Mechanism>> trains;
  for (const std::string& name : test::exampleNames()) {
    Mechanism mechanism = test::example(name);
    if (placementOf(mechanism).tree) trains.emplace_back(name, std::move(mechanism));
  }
  for (std::uint64_t seed = 1; seed <= 60; ++seed)
    trains.emplace_back("seed " + std::to_string(seed),
                        test::randomTrain(seed, 3 + static_cast<int>(seed % 6), 4));
  return trains;
}

int axesOf(const PlanDraft& draft) {
  return static_cast<int>(draft.plan.axes.size());
}

/// A link of a spur pair and the axis that it turns about, with its wheel's place there.
struct Turning {
  int axisGroup = 0;
  int link = 0;
  Interval hub;
};

Turning firstOf(const PlanDraft& draft) {
  const TrainGear& gear = draft.train.gears.front();
  return {gear.axisGroup, gear.link, hubInterval(draft, gear.axisGroup, gear.link)};
}

}  // namespace

/// The parts of the planner, each by itself on a draft.
class PlannerPartsTest : public QObject {
  Q_OBJECT
 private slots:
  /// An intersection lies on both axes; parallel and skew axes have none.
  void intersectionsLieOnBothAxes() {
    int intersections = 0, none = 0;
    for (const auto& [name, mechanism] : someTrains()) {
      const Drafted drafted(mechanism);
      const PlanDraft& draft = drafted.draft;
      for (int a = 0; a < axesOf(draft); ++a) {
        for (int b = 0; b < axesOf(draft); ++b) {
          const auto intersection = draft.intersectionOf(a, b);
          if (draft.parallel(a, b)) QVERIFY2(!intersection, name.c_str());
          ++(intersection ? intersections : none);
          if (!intersection) continue;
          const double apart =
              (draft.axis(a).at(intersection->first) - draft.axis(b).at(intersection->second)).norm();
          QVERIFY2(apart < 0.02 * draft.axis(a).module, name.c_str());
        }
      }
    }
    QVERIFY(intersections > 20 && none > 20);
  }

  void aHubIsWhereItsGearIs() {
    const Drafted drafted(test::example("spur-pair"));
    for (const TrainGear& gear : drafted.train.gears) {
      const Interval hub = hubInterval(drafted.draft, gear.axisGroup, gear.link);
      const double at = drafted.draft.axis(gear.axisGroup).coordinate(gear.pose.translation());
      QVERIFY(hub.low < at && at < hub.high);
      QVERIFY(hub.high - hub.low >= gear.spec.faceWidth);
    }
    const Interval none = hubInterval(drafted.draft, drafted.train.gears.front().axisGroup, 0);
    QVERIFY(none.low > none.high);
  }

  /// Every ring whose axis has no plan of its own gets one plate, beyond the face that it closes.
  void ringCarriersStandBesideTheirRings() {
    int rings = 0;
    for (const auto& [name, mechanism] : someTrains()) {
      Drafted drafted(mechanism);
      placeRingCarriers(drafted.draft);
      std::size_t expected = 0;
      for (const TrainGear& gear : drafted.train.gears) expected += gear.spec.kind == GearKind::internal;
      QCOMPARE(drafted.draft.plan.ringCarriers.size(), expected);
      for (const RingCarrierPlan& ringCarrier : drafted.draft.plan.ringCarriers) {
        const TrainGear& ring = drafted.train.gears[static_cast<std::size_t>(ringCarrier.gear)];
        const AxisLayout& axis = drafted.draft.axis(ring.axisGroup);
        const double beyond =
            ringCarrier.side * (ringCarrier.plate - axis.coordinate(ring.pose.translation()));
        QVERIFY2(beyond - axis.width() / 2 > ring.spec.faceWidth / 2, name.c_str());
        QVERIFY2(!axis.slotIsFree(ringCarrier.plate), name.c_str());
        const Interval held = heldInterval(drafted.draft, ring.axisGroup, ring.link);
        QVERIFY2(held.low <= ringCarrier.plate && ringCarrier.plate <= held.high, name.c_str());
        ++rings;
      }
    }
    QVERIFY(rings >= 5);
  }

  /// On a spur pair's axis a bearing may stand beside the wheel; on pedestals it takes the place.
  void pedestalsTakeTheirPlace() {
    Drafted drafted(test::example("spur-pair"));
    PlanDraft& draft = drafted.draft;
    const Turning turning = firstOf(draft);
    AxisLayout& axis = draft.axis(turning.axisGroup);
    Bearing& bearing = axis.bearings.front();
    const auto place = pedestalPlace(draft, bearing);
    QVERIFY(place && axis.slotIsFree(*place) && shaftPasses(draft, bearing, *place));
    QVERIFY(*place < turning.hub.low || turning.hub.high < *place);
    putOnPedestal(draft, bearing, *place);
    QVERIFY(bearing.placed && !axis.slotIsFree(*place));
    QCOMPARE(bearing.at, *place);
    QVERIFY(draft.plan.blocked.empty());
  }

  /// A bearing with its boss within the wheels of another link parts these.
  void shaftsDoNotEndWithinTheWheelsOfOthers() {
    int cut = 0;
    for (const auto& [name, mechanism] : someTrains()) {
      const Drafted drafted(mechanism);
      const PlanDraft& draft = drafted.draft;
      for (int c = 0; c < axesOf(draft); ++c) {
        for (const Bearing& one : draft.axis(c).bearings) {
          const Interval own = heldInterval(draft, c, one.child);
          for (const Bearing& other : draft.axis(c).bearings) {
            const Interval held = heldInterval(draft, c, other.child);
            if (other.child == one.child || held.low >= held.high || own.low > own.high) continue;
            QVERIFY2(!shaftPasses(draft, one, (held.low + held.high) / 2), name.c_str());
            ++cut;
          }
        }
      }
    }
    QVERIFY(cut > 20);
  }

  /// Slots are reserved where a carrier found none, and released.
  void reservedSlotsAreReleased() {
    const Mechanism mechanism = test::example("planetary-ring-held");
    const Drafted free(mechanism);
    int carrier = -1;
    for (std::size_t link = 1; link < free.draft.heldBy.size(); ++link)
      if (!free.draft.heldBy[link].empty()) carrier = static_cast<int>(link);
    QVERIFY(carrier > 0);
    PlanTries tries;
    tries.slotsFor.insert(carrier);
    Drafted drafted(mechanism, tries);
    const int home = homeOf(drafted.draft, carrier);
    QCOMPARE(home, drafted.placement.classes->classOfLink(carrier));
    const AxisLayout& axis = drafted.draft.axis(home);
    const double outer = axis.outerSlot();
    const std::size_t before = axis.occupied.size();
    QVERIFY(axis.slotIsFree(outer));
    reserveSlots(drafted.draft);
    QVERIFY(!axis.slotIsFree(outer));
    releaseSlots(drafted.draft);
    QVERIFY(axis.slotIsFree(outer));
    QCOMPARE(axis.occupied.size(), before);
  }

  /// Bars join each axis of a round to the link's own, once, and start where another one has ended.
  void barsJoinEachAxisOnce() {
    int joined = 0;
    for (const auto& [name, mechanism] : someTrains()) {
      Drafted drafted(mechanism);
      PlanDraft& draft = drafted.draft;
      for (std::size_t link = 0; link < draft.heldBy.size(); ++link) {
        if (draft.heldBy[link].empty()) continue;
        const int home = homeOf(draft, static_cast<int>(link));
        for (const auto& round : roundsOf(draft, static_cast<int>(link), home)) {
          std::set<int> reached{home};
          for (const AxisBar& bar : barsOf(draft, static_cast<int>(link), home, round, 0)) {
            QVERIFY2(reached.contains(bar.from), name.c_str());
            QVERIFY2(reached.insert(bar.to).second, name.c_str());
            ++joined;
          }
          for (const Bearing* bearing : round)
            QVERIFY2(reached.contains(draft.classOf(*bearing)), name.c_str());
        }
      }
    }
    QVERIFY(joined > 100);
  }

  /// A round's bearings come to stand in one plane across the link's axis.
  void aRoundStandsInOnePlane() {
    int placed = 0;
    for (const auto& [name, mechanism] : someTrains()) {
      Drafted drafted(mechanism);
      PlanDraft& draft = drafted.draft;
      for (std::size_t link = 1; link < draft.heldBy.size(); ++link) {
        if (draft.heldBy[link].empty()) continue;
        const int home = homeOf(draft, static_cast<int>(link));
        const auto rounds = roundsOf(draft, static_cast<int>(link), home);
        if (rounds.empty()) continue;
        placeParallel(draft, static_cast<int>(link), home, rounds.front());
        const Bearing& first = *rounds.front().front();
        const double level = draft.carried(draft.classOf(first), first.at, home);
        for (const Bearing* bearing : rounds.front()) {
          QVERIFY2(bearing->placed, name.c_str());
          QVERIFY2(std::abs(draft.carried(draft.classOf(*bearing), bearing->at, home) - level) <
                       1e-6 * draft.axis(home).module,
                   name.c_str());
          ++placed;
        }
      }
    }
    QVERIFY(placed > 50);
  }

  /// A pin starts at the intersection and ends behind the wheels, which stand on one side of it.
  void pinsReachBehindTheirWheels() {
    int pins = 0;
    for (const auto& [name, mechanism] : someTrains()) {
      const Drafted drafted(mechanism);
      const PlanDraft& draft = drafted.draft;
      for (std::size_t link = 1; link < draft.heldBy.size(); ++link) {
        for (const auto& [c, b] : draft.heldBy[link]) {
          const int home = homeOf(draft, static_cast<int>(link));
          const Bearing& bearing = draft.axis(c).bearings[b];
          const auto pin = pinFor(draft, static_cast<int>(link), home, bearing);
          if (draft.parallel(home, c)) QVERIFY2(!pin, name.c_str());
          if (!pin) continue;
          ++pins;
          const auto wheels = draft.axis(c).wheelsOf(bearing.child);
          QVERIFY(wheels);
          const auto [low, high] = std::minmax({pin->from, pin->to});
          QVERIFY2(!draft.axis(c).isBelow(wheels->low, low) && !draft.axis(c).isBelow(high, wheels->high),
                   name.c_str());
        }
      }
    }
    QVERIFY(pins > 5);
  }

  /// A cross-shaft boss holds all that turns there on the link; the ground has none.
  void crossShaftBossesHoldAllOfTheirAxis() {
    int crossShaftBosses = 0;
    for (const auto& [name, mechanism] : someTrains()) {
      Drafted drafted(mechanism);
      PlanDraft& draft = drafted.draft;
      for (int c = 0; c < axesOf(draft); ++c) {
        for (std::size_t link = 0; link < draft.heldBy.size(); ++link) {
          const auto& held = draft.heldBy[link];
          const bool holds =
              std::any_of(held.begin(), held.end(), [c](const auto& h) { return h.first == c; });
          if (!holds) continue;
          const int home = homeOf(draft, static_cast<int>(link));
          const bool isPlaced = placeCrossShaftBoss(draft, static_cast<int>(link), home, c);
          QVERIFY2(!isPlaced || link != 0, name.c_str());
          if (!isPlaced) continue;
          ++crossShaftBosses;
          const CrossShaftBossPlan& boss = draft.plan.crossShaftBosses.back();
          int bosses = 0;
          for (const Bearing& bearing : draft.axis(c).bearings) {
            if (bearing.parent != static_cast<int>(link)) continue;
            QVERIFY2(bearing.placed && bearing.at == boss.at, name.c_str());
            bosses += bearing.isBoss();
          }
          QCOMPARE(bosses, 1);
        }
      }
    }
    QVERIFY(crossShaftBosses >= 2);
  }

  /// A shaft about its wheel and its bearing.
  void aShaftReachesFromWheelToBearing() {
    Drafted drafted(test::example("spur-pair"));
    PlanDraft& draft = drafted.draft;
    const Turning turning = firstOf(draft);
    Bearing& bearing = draft.axis(turning.axisGroup).bearings.front();
    putOnPedestalOrReport(draft, bearing);
    addShaft(draft, turning.axisGroup, turning.link);
    QCOMPARE(draft.plan.shafts.size(), std::size_t{1});
    const ShaftSegment& shaft = draft.plan.shafts.front();
    QVERIFY(shaft.low < turning.hub.low && turning.hub.high < shaft.high);
    QVERIFY(shaft.low < bearing.at && bearing.at < shaft.high);
    addFixedHubs(draft);  // both wheels turn
    QCOMPARE(draft.plan.shafts.size(), std::size_t{1});
  }

  /// Of three shafts over each other the longest is the inmost; one beside them keeps its radius.
  void longShaftsAreInside() {
    Drafted drafted(test::example("spur-pair"));
    PlanDraft& draft = drafted.draft;
    const int c = firstOf(draft).axisGroup;
    const double m = draft.axis(c).module;
    const double far = 1000 * m;  // from all wheels
    const auto add = [&](int link, double low, double high) {
      draft.addSegment({c, link, far + low * m, far + high * m});
    };
    add(11, 10, 20);
    add(12, 0, 60);
    add(13, 5, 40);
    add(14, 70, 80);
    // No link of these has wheels or arms: armsOf is asked for them.
    draft.armsOf.resize(15);
    nestShafts(draft, c);
    const auto& shafts = draft.plan.shafts;
    QCOMPARE(shafts[1].inner, 0.0);
    QVERIFY(shafts[1].outer < shafts[2].inner);
    QVERIFY(shafts[2].outer < shafts[0].inner);
    QCOMPARE(shafts[3].inner, 0.0);
    QCOMPARE(shafts[3].outer, shafts[1].outer);
  }

  /// Whatever the order of the parts has made, every bearing has a place, every arm ends at one.
  void whollyPlannedAndSimply() {
    for (const auto& [name, mechanism] : someTrains()) {
      for (const bool isSimple : {false, true}) {
        Drafted drafted(mechanism);
        PlanDraft& draft = drafted.draft;
        isSimple ? planWithoutRouting(draft) : planBodies(draft);
        QCOMPARE(draft.plan.isSimple, isSimple);
        for (const AxisLayout& axis : draft.plan.axes) {
          for (const Bearing& bearing : axis.bearings) QVERIFY2(bearing.placed, name.c_str());
        }
        for (const ShaftSegment& shaft : draft.plan.shafts)
          QVERIFY2(shaft.low < shaft.high && 0 <= shaft.inner && shaft.inner <= shaft.outer, name.c_str());
      }
    }
  }
};

QTEST_APPLESS_MAIN(PlannerPartsTest)
#include "test_planner_parts.moc"

#include <QTest>
#include <algorithm>
#include <cmath>
#include <set>

#include "core/machine/body_layout/carrier_flanges.h"
#include "tests/core/machine/body_layout/planned_train.h"
#include "tests/core/support/example_files.h"
#include "tests/core/support/train_sketch.h"

using namespace geargraph;
using Eigen::Vector3d;

namespace {

struct FlangedTrain : test::PlannedTrain {
  using PlannedTrain::PlannedTrain;

  [[nodiscard]] std::vector<FlangePlan> flanges() const { return carrierFlanges(plan, train, placement); }
};

/// The flange stands beyond the planets, on the other side than the arms, before the ring's plate.
void checkLevels(const FlangedTrain& planned, const FlangePlan& made) {
  const AxisLayout& own = planned.plan.axes[static_cast<std::size_t>(made.axisGroup)];
  const double side = made.level < made.arms ? -1 : 1, edge = made.level - side * own.width() / 2;
  QVERIFY(side * (made.level - made.arms) > own.width());
  for (const TrainGear& gear : planned.train.gears) {
    const double middle = own.coordinate(gear.pose.translation());
    QVERIFY(side * (edge - middle) > gear.spec.faceWidth / 2);
  }
  for (const RingCarrierPlan& ringCarrier : planned.plan.ringCarriers)
    QVERIFY(side * (ringCarrier.plate - made.level) < 0 ||
            std::abs(ringCarrier.plate - made.level) > own.width());
}

/// Pillars pass all gears in the plane of the arms.
void checkPillars(const FlangedTrain& planned, const FlangePlan& made) {
  const AxisLayout& own = planned.plan.axes[static_cast<std::size_t>(made.axisGroup)];
  const Eigen::Isometry3d frame = frameAlong(own.at(made.level), own.direction, Vector3d::UnitX());
  QVERIFY(made.pillars.size() >= 2);
  for (const Boss& pillar : made.pillars) {
    QVERIFY(pillar.radius > 0.5 * own.module);
    const Vector3d place = frame * Vector3d(pillar.centre.x(), pillar.centre.y(), 0);
    for (const TrainGear& gear : planned.train.gears) {
      const Vector3d apart = place - gear.pose.translation();
      const double away = (apart - apart.dot(own.direction) * own.direction).norm();
      const double tip = nominalTipRadius(gear.spec);
      if (gear.spec.kind == GearKind::internal)
        QVERIFY(away + pillar.radius < tip);
      else
        QVERIFY(away - pillar.radius > tip);
    }
  }
}

}  // namespace

/// The second flanges of planetary carriers.
class CarrierFlangesTest : public QObject {
  Q_OBJECT
 private slots:
  void planetaryExamplesHaveThem() {
    const std::set<std::string> expected{"cannot-be-assembled", "ferguson-paradox",    "planetary-ring-held",
                                         "ravigneaux",          "redundant-planetary", "three-planets"};
    for (const std::string& name : test::exampleNames()) {
      const Mechanism mechanism = test::example(name);
      if (!placementOf(mechanism).tree) continue;
      QVERIFY2(FlangedTrain(mechanism).flanges().size() == expected.count(name), name.c_str());
    }
  }

  void flangesAndPillarsPassTheGears() {
    int flanges = 0;
    for (const int sun : {15, 24, 40}) {
      for (const int planet : {12, 18, 30}) {
        for (const int planets : {1, 2, 3, 4}) {
          const FlangedTrain planned(test::planetary(sun, planet, planets));
          for (const FlangePlan& made : planned.flanges()) {
            ++flanges;
            QCOMPARE(made.ends.size(), static_cast<std::size_t>(planets));
            checkLevels(planned, made);
            checkPillars(planned, made);
          }
        }
      }
    }
    QVERIFY2(flanges >= 20, qPrintable(QString::number(flanges)));
  }

  void shaftsOfPlanetsReachThrough() {
    FlangedTrain planned(test::planetary(24, 18, 3));
    const std::vector<FlangePlan> flanges = planned.flanges();
    QCOMPARE(flanges.size(), std::size_t{1});
    const FlangePlan& made = flanges.front();
    const AxisLayout& own = planned.plan.axes[static_cast<std::size_t>(made.axisGroup)];
    const auto reaching = [&] {
      return std::count_if(planned.plan.shafts.begin(), planned.plan.shafts.end(),
                           [&](const ShaftSegment& s) {
                             const AxisLayout& on = planned.plan.axes[static_cast<std::size_t>(s.axisGroup)];
                             const double at = on.coordinate(own.at(made.level));
                             return std::count(made.children.begin(), made.children.end(), s.link) == 1 &&
                                    s.low < at - own.width() / 2 && at + own.width() / 2 < s.high;
                           });
    };
    QCOMPARE(reaching(), 0);
    reachFlanges(planned.plan, flanges);
    QCOMPARE(reaching(), 3);
  }

  /// Not where something stands on a planet's axis, nor where a bar of the frame passes.
  void nothingElseIsInTheWay() {
    const FlangedTrain free(test::planetary(24, 18, 3));
    const FlangePlan made = free.flanges().at(0);
    const AxisLayout& own = free.plan.axes[static_cast<std::size_t>(made.axisGroup)];
    FlangedTrain occupied = free;
    occupied.plan.axes[static_cast<std::size_t>(made.axisGroup)].occupy(made.level, made.link);
    QVERIFY(occupied.flanges().empty());
    FlangedTrain barred = free;
    const Vector3d across = own.direction.unitOrthogonal() * 100 * own.module;
    barred.plan.frame.bars.push_back({own.at(made.level) - across, own.at(made.level) + across, own.module});
    QVERIFY(barred.flanges().empty());
  }
};

QTEST_APPLESS_MAIN(CarrierFlangesTest)
#include "test_carrier_flanges.moc"

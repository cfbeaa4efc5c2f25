#include <QTest>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/machine/body_layout/carrier_cases.h"
#include "core/machine/solids/part_solids.h"
#include "tests/core/machine/body_layout/planned_train.h"
#include "tests/core/support/example_files.h"

using namespace geargraph;
using Eigen::Vector3d;

namespace {

struct CasedTrain : test::PlannedTrain {
  using PlannedTrain::PlannedTrain;

  [[nodiscard]] std::vector<CasePlan> cases() const { return carrierCases(plan, train, placement); }
  [[nodiscard]] const AxisLayout& axisOf(const CasePlan& made) const {
    return plan.axes[static_cast<std::size_t>(made.axisGroup)];
  }
  /// A shaft of another link on the case's axis, thick enough to be in its rings.
  void block(const CasePlan& made, double low, double high) {
    const auto bearing =
        std::find_if(axisOf(made).bearings.begin(), axisOf(made).bearings.end(),
                     [&](const Bearing& b) { return b.parent == 0 && b.child != made.link; });
    plan.shaftsOn[static_cast<std::size_t>(made.axisGroup)].push_back(plan.shafts.size());
    plan.shafts.push_back({made.axisGroup, bearing->child, low, high, 0, (made.inner + made.outer) / 2});
  }
};

}  // namespace

/// The cases of bevel differentials.
class CarrierCasesTest : public QObject {
  Q_OBJECT
 private slots:
  void onlyTheDifferentialOfTheExamplesHasACase() {
    int trains = 0;
    for (const std::string& name : test::exampleNames()) {
      const Mechanism mechanism = test::example(name);
      if (!placementOf(mechanism).tree) continue;
      ++trains;
      QVERIFY2(CasedTrain(mechanism).cases().size() == (name == "bevel-differential" ? 1 : 0), name.c_str());
    }
    QVERIFY(trains > 10);
  }

  /// The pinions and their shafts turn within the ring; its tubes end in it.
  void theRingGoesRoundThePinions() {
    const CasedTrain differential(test::example("bevel-differential"));
    const CasePlan made = differential.cases().at(0);
    const AxisLayout& own = differential.axisOf(made);
    QCOMPARE(made.rings.size(), std::size_t{2});
    QCOMPARE(made.tubes.size(), std::size_t{4});
    QVERIFY(made.inner < made.outer);
    const auto away = [&](const Vector3d& p) { return (p - own.at(own.coordinate(p))).norm(); };
    for (const CaseTube& tube : made.tubes) {
      QVERIFY(away(tube.from) < made.inner);
      QVERIFY(made.inner < away(tube.to) && away(tube.to) < made.outer);
    }
    const auto wide = [](const Vector3& v) { return Vector3d(v[0], v[1], v[2]); };
    int within = 0;
    for (const BodyHull& hull : bodyHulls(differential.plan, differential.train, {0, true})) {
      if (hull.link == 0 || hull.link == made.link || hull.axisGroup == made.axisGroup) continue;
      ++within;  // a pinion or its shaft
      for (const Disc& disc : hull.discs) {
        const Eigen::Isometry3d frame = frameAlong(wide(disc.centre), wide(disc.axis));
        for (int i = 0; i < 90; ++i) {
          const double angle = 2 * std::numbers::pi * i / 90;
          QVERIFY(away(frame * (disc.radius * Vector3d(std::cos(angle), std::sin(angle), 0))) < made.inner);
        }
      }
    }
    QVERIFY(within >= 4);
  }

  /// Where the second ring has no room there is one; where that has none, there is no case.
  void whatStandsInTheRingIsNotEnclosed() {
    const CasedTrain free(test::example("bevel-differential"));
    const CasePlan made = free.cases().at(0);
    const auto [low, high] = made.rings.at(1);
    CasedTrain second(test::example("bevel-differential"));
    second.block(made, low, high);
    QCOMPARE(second.cases().at(0).rings.size(), std::size_t{1});
    QCOMPARE(second.cases().at(0).tubes.size(), std::size_t{2});
    QCOMPARE(second.cases().at(0).rings.at(0), made.rings.at(0));
    CasedTrain first(test::example("bevel-differential"));
    first.block(made, made.rings.at(0).first, made.rings.at(0).second);
    QVERIFY(first.cases().empty());
  }

  /// The frame of the ground goes round the case.
  void theFrameStaysClearOfTheCase() {
    const CasedTrain differential(test::example("bevel-differential"));
    const CasePlan made = differential.cases().at(0);
    const SweptEnvelope swept = envelopeOf(made, differential.axisOf(made));
    QVERIFY(!differential.plan.frame.bars.empty());
    for (const FrameBar& bar : differential.plan.frame.bars)
      QVERIFY(!swept.isNear(bar.from, bar.to, bar.radius));
    QVERIFY(differential.plan.frame.top < swept.lowestAlong(Vector3d::UnitZ()));
    QVERIFY(differential.plan.frame.onPedestals.empty());
  }
};

QTEST_APPLESS_MAIN(CarrierCasesTest)
#include "test_carrier_cases.moc"

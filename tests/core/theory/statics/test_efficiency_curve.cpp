#include <QTest>

#include <cmath>

#include "core/theory/statics/efficiency_curve.h"
#include "core/theory/statics/locking_limits.h"
#include "tests/core/support/gearboxes.h"
#include "tests/core/support/statics_case.h"
#include "tests/core/support/train_sketch.h"

namespace geargraph {

using test::StaticsCase;

/// Efficiency over the ratio of two speeds, and over the efficiency of the meshes.
class EfficiencyCurveTest : public QObject {
  Q_OBJECT

  /// Sun 100 rad/s with 10 N m; the ring turns at `ring`; ring and carrier are held in balance.
  static Mechanism set(const Number& ring = Number(0)) {
    Mechanism mechanism = test::planetary(24, 18);
    const auto& joints = mechanism.turningJoints;
    mechanism.inputs = std::vector<Input>{{joints[0].id, Number(100), {}}, {joints[1].id, ring, {}}};
    mechanism.balances = std::vector<Balance>{{joints[1].id}, {joints[2].id}};
    mechanism.loads = {{{}, JointTorque{joints[0].id, Number(10)}}};
    return mechanism;
  }
  static StaticsOptions lossy(const Rational& efficiency) {
    StaticsOptions options;
    options.losses = true;
    options.efficiency = efficiency;
    options.symbolic = false;
    return options;
  }
  static StaticsReport reportOf(const StaticsCase& train, const StaticsOptions& options) {
    return *analyzeStatics(train.mechanism, train.model, train.placement, train.tt, train.analysis, options);
  }
  static std::optional<EfficiencyCurve> curveOf(const StaticsCase& train, const StaticsOptions& options,
                                                CurveAxis axis, const CurveRange& range,
                                                const std::stop_token& stop = {}) {
    return efficiencyCurve(train.mechanism, train.model, train.placement, train.analysis,
                           reportOf(train, options), options, axis, range, stop);
  }
  static std::optional<LockingLimits> limitsOf(const StaticsCase& train, const StaticsOptions& options,
                                               const std::stop_token& stop = {}) {
    return lockingLimits(train.mechanism, train.model, train.placement, train.analysis,
                         reportOf(train, options), options, stop);
  }

 private slots:
  void overTheEfficiencyOfTheMeshes() {
    const StaticsCase train(set());
    const StaticsOptions options = lossy(Rational(9, 10));
    const auto curve = curveOf(train, options, CurveAxis::meshEfficiency, {Rational(49, 50), Rational(1), 2});
    QVERIFY(curve.has_value());
    QCOMPARE(curve->points.size(), std::size_t{2});
    // (1 + eta^2 60/24) / (1 + 60/24), and its inverse for 1/eta.
    QCOMPARE(*curve->points[0].forward, Rational(3401, 3500).toDouble());
    QCOMPARE(*curve->points[0].backward, Rational(16807, 17302).toDouble());
    QCOMPARE(*curve->points[1].forward, 1.0);
    QCOMPARE(curve->held.size(), std::size_t{2});
    QCOMPARE(curve->points[0].torques, (std::vector{24.01, -34.01}));
    QCOMPARE(curve->points[1].torques, (std::vector{25.0, -35.0}));
  }

  /// Every point is what the document with these speeds has.
  void overTheRatioOfTwoSpeeds() {
    const StaticsCase train(set());
    const StaticsOptions options = lossy(Rational(49, 50));
    const auto curve = curveOf(train, options, CurveAxis::speedRatio, {Rational(-2), Rational(2), 17});
    QVERIFY(curve.has_value());
    QCOMPARE(curve->inputs.size(), std::size_t{2});
    int compared = 0;
    for (const EfficiencyPoint& point : curve->points) {
      const StaticsCase there(set(Number(Rational(100) * point.at)));
      const StaticsReport report = reportOf(there, options);
      const bool isSolved = report.lossy->outcome == LossySolution::Outcome::solved;
      const auto efficiency = isSolved ? report.sums->efficiency() : std::nullopt;
      QCOMPARE(point.forward.has_value(), efficiency.has_value());
      if (!efficiency) continue;
      QCOMPARE(*point.forward, efficiency->number());
      QVERIFY(*point.forward <= 1);
      ++compared;
    }
    QVERIFY(compared >= 15);
    // Turning as a block nothing is lost; with the ring held it is the set's efficiency.
    const auto at = [&](const Rational& ratio) {
      return *std::find_if(curve->points.begin(), curve->points.end(),
                           [&](const EfficiencyPoint& each) { return each.at == ratio; });
    };
    QCOMPARE(*at(Rational(1)).forward, 1.0);
    QCOMPARE(*at(Rational(0)).forward, Rational(3401, 3500).toDouble());
    QVERIFY(*at(Rational(2)).forward < 1);
  }

  void whatCanBeFollowed() {
    const StaticsCase train(set());
    const StaticsOptions options = lossy(Rational(49, 50));
    QCOMPARE(curveAxes(train.analysis, reportOf(train, options), options),
             (std::vector{CurveAxis::speedRatio, CurveAxis::meshEfficiency}));
    StaticsOptions lossless = options;
    lossless.efficiency.reset();
    QCOMPARE(curveAxes(train.analysis, reportOf(train, lossless), lossless),
             std::vector{CurveAxis::meshEfficiency});
    StaticsOptions unloaded = options;
    unloaded.documentLoads = false;
    QVERIFY(curveAxes(train.analysis, reportOf(train, unloaded), unloaded).empty());
    Mechanism unheld = set();
    unheld.balances = std::vector<Balance>{{unheld.turningJoints[1].id}};
    const StaticsCase loose(unheld);
    QVERIFY(curveAxes(loose.analysis, reportOf(loose, options), options).empty());
  }

  /// A carrier drives a sun beside a fixed one, nearly equal: below some efficiency it locks in one sense.
  void itLocksInOneSense() {
    Mechanism mechanism = test::TrainSketch(3)
                              .joint(0, 1, "a")
                              .joint(0, 2, "a")
                              .joint(1, 3, "b")
                              .mesh(0, 3, 99, 101, MeshKind::external)
                              .mesh(3, 2, 100, 100, MeshKind::external)
                              .build();
    mechanism.inputs = std::vector<Input>{{mechanism.turningJoints[0].id, Number(1), {}}};
    mechanism.loads = {{{}, JointTorque{mechanism.turningJoints[1].id, Number(1)}}};
    const StaticsCase train(mechanism);
    const StaticsOptions options = lossy(Rational(49, 50));
    QCOMPARE(curveAxes(train.analysis, reportOf(train, options), options),
             std::vector{CurveAxis::meshEfficiency});
    const CurveRange range = usualRange(CurveAxis::meshEfficiency);
    const auto curve = curveOf(train, options, CurveAxis::meshEfficiency, range);
    QVERIFY(curve.has_value());
    QCOMPARE(static_cast<int>(curve->points.size()), range.points);
    QCOMPARE(*curve->points.back().forward, 1.0);
    QCOMPARE(*curve->points.back().backward, 1.0);
    const EfficiencyPoint& worst = curve->points.front();
    QVERIFY(worst.isLocked != worst.isLockedBackward);
    for (const EfficiencyPoint& point : curve->points) {
      QCOMPARE(point.isLocked, !point.forward.has_value());
      QCOMPARE(point.isLockedBackward, !point.backward.has_value());
      QCOMPARE(point.torques.empty(), point.isLocked);
    }
    // It begins where the basic efficiency of both meshes is the basic ratio, 99/101.
    const auto limits = limitsOf(train, options);
    QVERIFY(limits.has_value() && limits->forward.has_value() != limits->backward.has_value());
    QCOMPARE(limits->forward.has_value(), worst.isLocked);
    const double limit = limits->forward ? *limits->forward : *limits->backward;
    QVERIFY2(std::abs(limit - std::sqrt(99.0 / 101)) < 1e-5, qPrintable(QString::number(limit, 'g', 10)));
  }

  /// A planetary set with its ring held moves at any efficiency, both ways.
  void aPlanetarySetNeverLocks() {
    const auto limits = limitsOf(StaticsCase(set()), lossy(Rational(49, 50)));
    QVERIFY(limits.has_value() && !limits->forward && !limits->backward);
    std::stop_source stop;
    stop.request_stop();
    QVERIFY(!limitsOf(StaticsCase(set()), lossy(Rational(49, 50)), stop.get_token()));
  }

  void itCanBeStopped() {
    const StaticsCase train(set());
    const StaticsOptions options = lossy(Rational(49, 50));
    std::stop_source stopped;
    stopped.request_stop();
    QVERIFY(!curveOf(train, options, CurveAxis::speedRatio, usualRange(CurveAxis::speedRatio),
                     stopped.get_token()));
  }
};

}  // namespace geargraph

QTEST_APPLESS_MAIN(geargraph::EfficiencyCurveTest)
#include "test_efficiency_curve.moc"

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
    mechanism.balances = std::vector<HoldingTorque>{{joints[1].id}, {joints[2].id}};
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
                                               const std::stop_token& stop = {}, int mostCheap = 8) {
    const StaticsReport report = reportOf(train, options);
    if (!hasLockingLimits(report)) return std::nullopt;
    return lockingLimits(train.mechanism, train.model, train.placement, report, options, stop, mostCheap);
  }

  /// A carrier drives a sun beside a fixed one, nearly equal, through one compound planet; `pairs` ordinary
  /// pairs of gears follow it. The meshes of the set first.
  static Mechanism lockingTrain(int pairs = 0) {
    test::TrainSketch sketch(3 + pairs);
    sketch.joint(0, 1, "a").joint(0, 2, "a").joint(1, 3, "b");
    std::vector<std::string> axes;
    for (int i = 0; i < pairs; ++i) axes.push_back("c" + std::to_string(i));
    for (int i = 0; i < pairs; ++i) sketch.joint(0, 4 + i, axes[static_cast<std::size_t>(i)].c_str());
    sketch.mesh(0, 3, 99, 101, MeshKind::external).mesh(3, 2, 100, 100, MeshKind::external);
    for (int i = 0; i < pairs; ++i) sketch.mesh(i == 0 ? 2 : 3 + i, 4 + i, 30, 40, MeshKind::external);
    Mechanism mechanism = sketch.build();
    mechanism.inputs = std::vector<Input>{{mechanism.turningJoints[0].id, Number(1), {}}};
    const std::size_t last = pairs == 0 ? 1 : static_cast<std::size_t>(2 + pairs);
    mechanism.loads = {{{}, JointTorque{mechanism.turningJoints[last].id, Number(1)}}};
    return mechanism;
  }
  /// `loss`: what the mesh that loses most loses for 1 of the scale.
  static bool isInBracket(const LockingBracket& bracket, double value, double loss = 1) {
    const double low = std::min(bracket.moves, bracket.locks), high = std::max(bracket.moves, bracket.locks);
    const bool isIn = low - 1e-12 <= value && value <= high + 1e-12;
    if (!isIn) qWarning("%.10g is not in %.10g to %.10g", value, low, high);
    return isIn && (high - low) * loss <= 1e-6;
  }
  static const LockingBracket& bracketOf(const LockingLimits& limits) {
    return limits.forward ? *limits.forward : *limits.backward;
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
    unheld.balances = std::vector<HoldingTorque>{{unheld.turningJoints[1].id}};
    const StaticsCase loose(unheld);
    QVERIFY(curveAxes(loose.analysis, reportOf(loose, options), options).empty());
  }

  /// A carrier drives a sun beside a fixed one, nearly equal: below some efficiency it locks in one sense.
  void itLocksInOneSense() {
    const StaticsCase train(lockingTrain());
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
    QVERIFY(limits->scale == LockingScale::sameEfficiency);
    QVERIFY(isInBracket(bracketOf(*limits), std::sqrt(99.0 / 101)));
    QVERIFY(bracketOf(*limits).moves > bracketOf(*limits).locks && bracketOf(*limits).isProven);
  }

  /// Different efficiencies: their losses grow by one factor x. The set locks where the product of what its
  /// meshes pass is the basic ratio: (1 - x a)(1 - x b) = 99/101.
  void differentEfficienciesGrowTogether() {
    for (const auto& [a, b] :
         {std::pair(Rational(1, 200), Rational(1, 1000)), std::pair(Rational(1, 50), Rational(3, 100)),
          std::pair(Rational(0), Rational(1, 100))}) {
      Mechanism mechanism = lockingTrain();
      mechanism.gearMeshes[0].efficiency = Number(Rational(1) - a);
      mechanism.gearMeshes[1].efficiency = Number(Rational(1) - b);
      StaticsOptions options = lossy(Rational(1));
      options.efficiency.reset();
      const auto limits = limitsOf(StaticsCase(mechanism), options);
      QVERIFY(limits.has_value() && limits->forward.has_value() != limits->backward.has_value());
      QVERIFY(limits->scale == LockingScale::statedLosses);
      const double p = a.toDouble(), q = b.toDouble(), rest = 1 - 99.0 / 101;
      const double factor =
          p == 0 ? rest / q : (p + q - std::sqrt((p + q) * (p + q) - 4 * p * q * rest)) / (2 * p * q);
      QVERIFY(isInBracket(bracketOf(*limits), factor, std::max(p, q)));
      QVERIFY(bracketOf(*limits).isProven && bracketOf(*limits).moves < bracketOf(*limits).locks);
    }
  }

  /// Ordinary pairs behind the set lose power but lock nothing: the limit is that of the set alone. Of ten
  /// and of fourteen meshes all patterns are tried at the end of the bracket; of twenty the bracket is not
  /// proven.
  void moreMeshesHaveTheSameLimit() {
    for (const int pairs : {8, 12, 18}) {
      const auto limits = limitsOf(StaticsCase(lockingTrain(pairs)), lossy(Rational(49, 50)));
      QVERIFY(limits.has_value() && limits->forward.has_value() != limits->backward.has_value());
      QVERIFY(isInBracket(bracketOf(*limits), std::sqrt(99.0 / 101)));
      QCOMPARE(bracketOf(*limits).isProven, pairs + 2 <= kMaxPatternMeshes);
    }
  }

  /// Against all patterns at many values, for random sets with different efficiencies; also the short way for
  /// many meshes against the long one.
  void bracketsAreWhatAllPatternsGive() {
    int locked = 0;
    for (int seed = 1; seed <= 12; ++seed) {
      Mechanism mechanism = lockingTrain(seed % 3);
      int loss = 0;
      for (GearMesh& mesh : mechanism.gearMeshes)
        mesh.efficiency = Number(Rational(1) - Rational(1 + (seed * 7 + 5 * loss++) % 11, 400));
      mechanism.gearMeshes[0].tailTeeth = 90 + seed;
      mechanism.gearMeshes[0].headTeeth = 110 - seed;
      const StaticsCase train(mechanism);
      StaticsOptions options = lossy(Rational(1));
      options.efficiency.reset();
      const auto limits = limitsOf(train, options);
      const auto shortWay = limitsOf(train, options, {}, 0);
      QVERIFY(limits.has_value() && shortWay.has_value());
      for (const bool isForward : {true, false}) {
        const auto& bracket = isForward ? limits->forward : limits->backward;
        const auto& other = isForward ? shortWay->forward : shortWay->backward;
        QCOMPARE(bracket.has_value(), other.has_value());
        if (bracket) QVERIFY(bracket->moves == other->moves && bracket->locks == other->locks);
        // All patterns, at values beyond and before.
        Mechanism scaled = mechanism;
        const auto locksAt = [&](double factor) {
          for (std::size_t i = 0; i < scaled.gearMeshes.size(); ++i) {
            const Rational stated = Rational(1) - mechanism.gearMeshes[i].efficiency->exact();
            scaled.gearMeshes[i].efficiency = Number(Rational(1) - Rational::fromDouble(factor) * stated);
          }
          const StaticsReport report = reportOf(StaticsCase(scaled), options);
          const auto& solution = isForward ? report.lossy : report.backward;
          return solution->outcome == LossySolution::Outcome::selfLocking;
        };
        if (!bracket) continue;
        ++locked;
        QVERIFY(!locksAt(bracket->moves * (1 - 1e-9)) && locksAt(bracket->locks * (1 + 1e-9)));
        for (int i = 1; i <= 8; ++i) QVERIFY(!locksAt(bracket->moves * i / 9));
      }
    }
    QVERIFY2(locked >= 8, qPrintable(QString::number(locked)));
  }

  /// Three planets share by stiffness; with the ring held they move at any efficiency.
  void sharedTrainsHaveLimitsToo() {
    Mechanism planets = test::planetary(24, 18, 3);
    const auto& joints = planets.turningJoints;
    planets.inputs = std::vector<Input>{{joints[0].id, Number(100), {}}, {joints[1].id, Number(0), {}}};
    planets.balances = std::vector<HoldingTorque>{{joints[1].id}, {joints[2].id}};
    planets.loads = {{{}, JointTorque{joints[0].id, Number(10)}}};
    const StaticsCase train(planets);
    StaticsOptions options = lossy(Rational(49, 50));
    options.sharing = LoadSharing::none;
    QVERIFY(!limitsOf(train, options));  // nothing is known of the shares
    options.sharing = LoadSharing::stiffness;
    const auto limits = limitsOf(train, options);
    QVERIFY(limits.has_value() && !limits->forward && !limits->backward);
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

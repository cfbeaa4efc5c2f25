#include <QTest>
#include <cmath>
#include <random>

#include "core/theory/ttgraph/tt_solution.h"
#include "tests/core/support/textbook_trains.h"
#include "tests/core/support/train_sketch.h"
#include "tests/core/support/trains.h"
#include "tests/core/support/tt_case.h"

namespace geargraph {
namespace {

/// A train of n links, standing anywhere, and the meshes that leave it some freedom.
test::TtCase randomCase(std::uint64_t seed, int n) {
  std::mt19937_64 random(seed);
  const auto below = [&](int limit) {
    return static_cast<int>(random() % static_cast<std::uint64_t>(limit));
  };
  const Mechanism train = test::randomTrain(seed, n, n / 2 + below(n));
  const Mechanism scaled = test::withDirectionsScaled(train, {1, Rational(2, 3), 7});
  return test::TtCase(test::moved(scaled, test::rotation(1 + below(3), below(4), below(4) - 2, below(3)),
                                  {below(100), Rational(below(100), 7), -below(50)}));
}

constexpr int kSmall = 60;

}  // namespace

/// Laws of the T-T method on random trains in general position.
class TtRandomTest : public QObject {
  Q_OBJECT

 private slots:
  void gearsTouchWithoutSliding_data() {
    QTest::addColumn<int>("links");
    QTest::addColumn<int>("seed");
    for (int seed = 1; seed <= 40; ++seed) QTest::addRow("8 links, %d", seed) << 8 << seed;
    for (int seed = 41; seed <= 60; ++seed) QTest::addRow("20 links, %d", seed) << 20 << seed;
    for (int seed = 61; seed <= 70; ++seed) QTest::addRow("100 links, %d", seed) << 100 << seed;
    for (int seed = 71; seed <= 72; ++seed) QTest::addRow("500 links, %d", seed) << 500 << seed;
  }

  void gearsTouchWithoutSliding() {
    QFETCH(int, links);
    QFETCH(int, seed);
    const test::TtCase found = randomCase(static_cast<std::uint64_t>(seed), links);
    QVERIFY(found.graph.isComplete());
    const SubstitutionPlan plan = substitutionPlan(found.graph, found.someInputs());
    QVERIFY(ttDetermination(found.graph, plan).value().valid());
    std::vector<Rational> speeds;
    for (std::size_t i = 0; i < plan.inputs.size(); ++i) speeds.emplace_back(static_cast<int>(i) % 7 + 1, 3);
    const std::vector<Rational> rates = ttRates(found.graph, plan, speeds).value();
    QVERIFY(found.rollsWithoutSliding(rates));
  }

  void longCircuitsAreSolvedByLevelsToTheSameEnd() {
    std::vector<Mechanism> mechanisms;
    for (const test::TextbookTrain& train : test::textbookTrains()) mechanisms.push_back(train.mechanism);
    for (int seed = 1; seed <= 40; ++seed) {
      mechanisms.push_back(randomCase(static_cast<std::uint64_t>(seed) + 400, 8 + 2 * seed).mechanism);
    }
    for (const Mechanism& mechanism : mechanisms) {
      const test::TtCase found(mechanism);
      std::vector<int> inputs = found.someInputs();
      const SubstitutionPlan circuits = substitutionPlan(found.graph, inputs);
      const SubstitutionPlan levels = substitutionPlan(found.graph, inputs, 0);
      QVERIFY(!circuits.byLevels);
      QVERIFY(levels.byLevels);
      QCOMPARE(levels.outputs, circuits.outputs);
      const auto byCircuits = ttSolution(found.graph, circuits).value();
      const auto byLevels = ttSolution(found.graph, levels).value();
      QVERIFY(byCircuits.determined);
      QVERIFY(byLevels.determined);
      QVERIFY(byLevels.entries == byCircuits.entries);
      const TtDetermination one = ttDetermination(found.graph, circuits).value();
      const TtDetermination other = ttDetermination(found.graph, levels).value();
      QVERIFY(one.valid());
      QVERIFY(other.valid());
      QCOMPARE(one.surplusEquations.size(), other.surplusEquations.size());

      if (!circuits.outputs.empty()) {  // one input too many, one too few
        std::vector<int> more = inputs;
        more.push_back(circuits.outputs.front());
        QVERIFY(ttDetermination(found.graph, substitutionPlan(found.graph, more, 0))->contradictory);
        QVERIFY(!ttSolution(found.graph, substitutionPlan(found.graph, more, 0))->determined);
      }
      if (!inputs.empty()) {
        inputs.pop_back();
        QVERIFY(!ttDetermination(found.graph, substitutionPlan(found.graph, inputs, 0))->openJoints.empty());
      }
    }
  }

  void aCircuitIsHowItsGearTurnsAgainstTheCarrier() {
    // Absolutely, not only one circuit against the other: all signs turned at once would still solve.
    for (int seed = 1; seed <= 20; ++seed) {
      const test::TtCase found = randomCase(static_cast<std::uint64_t>(seed) + 600, 8 + 2 * seed);
      std::vector<Rational> rates;
      for (int joint = 0; joint < found.mechanism.t(); ++joint) rates.emplace_back(joint * joint % 17 - 8, 3);
      const auto isVelocityOf = [&](int gear, int carrier, int level, std::span<const CircuitTerm> circuit) {
        Rational speed;
        for (const CircuitTerm& term : circuit) {
          speed += Rational(term.coefficient) * rates[static_cast<std::size_t>(term.joint)];
        }
        const int axis = found.graph.levels().axisOf(level);
        const test::ExactTriple along =
            test::unitDirection(found.mechanism.axes[static_cast<std::size_t>(axis)]);
        return found.angularVelocity(gear, rates) - found.angularVelocity(carrier, rates) == speed * along;
      };
      for (int mesh = 0; mesh < found.mechanism.c(); ++mesh) {
        const TerminalPair& pair = found.graph.terminal(mesh).value();
        const auto& vertex = *found.graph.transferVertices().ofMesh[static_cast<std::size_t>(mesh)];
        QVERIFY(isVelocityOf(pair.tail, pair.carrier, vertex.tailLevel, found.graph.tailCircuit(mesh)));
        QVERIFY(isVelocityOf(pair.head, pair.carrier, vertex.headLevel, found.graph.headCircuit(mesh)));
      }
    }
  }

  void theBoundOfCircuitTermsHolds() {
    for (int seed = 1; seed <= 20; ++seed) {
      const test::TtCase found = randomCase(static_cast<std::uint64_t>(seed) + 500, 50);
      long long terms = 0;
      for (int mesh = 0; mesh < found.mechanism.c(); ++mesh) {
        terms += static_cast<long long>(found.graph.tailCircuit(mesh).size() +
                                        found.graph.headCircuit(mesh).size());
      }
      QVERIFY(terms <= found.graph.longestCircuitTerms());
    }
  }

  void doublesAndResiduesFollowTheFractions() {
    for (int seed = 1; seed <= 40; ++seed) {
      const test::TtCase found = randomCase(static_cast<std::uint64_t>(seed) + 100, 8 + seed);
      const SubstitutionPlan plan = substitutionPlan(found.graph, found.someInputs());
      const ModularDoubleField field;
      std::vector<Rational> exactSpeeds;
      std::vector<ModularDouble> speeds;
      for (std::size_t i = 0; i < plan.inputs.size(); ++i) {
        exactSpeeds.emplace_back(static_cast<std::int64_t>(i) + 1);
        speeds.push_back(field.fromInteger(static_cast<std::int64_t>(i) + 1));
      }
      const std::vector<Rational> exact = ttRates(found.graph, plan, exactSpeeds).value();
      const std::vector<ModularDouble> live = ttRates(field, found.graph, plan, speeds).value();
      for (std::size_t joint = 0; joint < exact.size(); ++joint) {
        const double value = exact[joint].toDouble();
        QVERIFY(std::abs(live[joint].number - value) <= 1e-9 * (1 + std::abs(value)));
        QCOMPARE(live[joint].residue, field.prime().fromRational(exact[joint]).value());
      }
    }
  }

  void functionsTakeTheFractionsAtTheTeeth() {
    int compared = 0;
    for (int seed = 1; seed <= 40; ++seed) {
      const test::TtCase found = randomCase(static_cast<std::uint64_t>(seed) + 200, 6 + seed % 15);
      const SubstitutionPlan plan = substitutionPlan(found.graph, found.someInputs());
      const RatioRingPtr ring = ttRatioRing(found.graph, RatioNaming::matroid);
      const auto symbolic = ttSymbolicSolution(ring, found.graph, plan).value();
      const auto exact = ttSolution(found.graph, plan).value();
      QCOMPARE(symbolic.outputs, exact.outputs);
      for (std::size_t output = 0; output < exact.outputs.size(); ++output) {
        for (std::size_t input = 0; input < exact.inputs.size(); ++input) {
          const auto& function = symbolic.entries[output][input];
          if (!function) continue;
          QCOMPARE(function->valueAt(ring->values()).value(), exact.entries[output][input]);
          ++compared;
        }
      }
    }
    QVERIFY(compared > 1000);
  }

  void otherInputsDescribeTheSameMotion() {
    int exchanged = 0;
    for (int seed = 1; seed <= 30; ++seed) {
      const test::TtCase found = randomCase(static_cast<std::uint64_t>(seed) + 300, kSmall);
      const SubstitutionPlan plan = substitutionPlan(found.graph, found.someInputs());
      std::vector<Rational> speeds;
      for (std::size_t i = 0; i < plan.inputs.size(); ++i)
        speeds.emplace_back(static_cast<int>(i * i) % 11 - 5, 2);
      const std::vector<Rational> rates = ttRates(found.graph, plan, speeds).value();
      // Exchange inputs for outputs while the set stays valid, and drive it at the rates found.
      std::vector<int> inputs = plan.inputs;
      for (std::size_t i = 0; i < inputs.size() && i < 4; ++i) {
        for (const int output : plan.outputs) {
          std::vector<int> other = inputs;
          if (std::find(other.begin(), other.end(), output) != other.end()) continue;
          other[i] = output;
          if (!ttDetermination(found.graph, substitutionPlan(found.graph, other)).value().valid()) continue;
          inputs = other;
          ++exchanged;
          break;
        }
      }
      std::vector<Rational> driven;
      for (const int joint : inputs) driven.push_back(rates[static_cast<std::size_t>(joint)]);
      QCOMPARE(ttRates(found.graph, substitutionPlan(found.graph, inputs), driven).value(), rates);
    }
    QVERIFY2(exchanged > 30, qPrintable(QString::number(exchanged)));
  }

  void aSolutionIsTheSumOfItsColumns() {
    const test::TtCase found = randomCase(7, kSmall);
    const SubstitutionPlan plan = substitutionPlan(found.graph, found.someInputs());
    const auto matrix = ttSolution(found.graph, plan).value();
    std::vector<Rational> speeds;
    for (std::size_t i = 0; i < plan.inputs.size(); ++i) speeds.emplace_back(static_cast<int>(i) + 2, 5);
    const std::vector<Rational> rates = ttRates(found.graph, plan, speeds).value();
    for (std::size_t output = 0; output < matrix.outputs.size(); ++output) {
      Rational sum;
      for (std::size_t input = 0; input < speeds.size(); ++input) {
        sum += matrix.entries[output][input] * speeds[input];
      }
      QCOMPARE(sum, rates[static_cast<std::size_t>(matrix.outputs[output])]);
    }
  }
};

}  // namespace geargraph

QTEST_APPLESS_MAIN(geargraph::TtRandomTest)
#include "test_tt_random.moc"

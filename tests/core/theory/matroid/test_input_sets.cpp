#include <QTest>
#include <set>

#include "core/theory/matroid/input_sets.h"
#include "tests/core/support/matroid_fixture.h"
#include "tests/core/support/train_sketch.h"
#include "tests/core/support/trains.h"

using namespace geargraph;
using namespace geargraph::test;

namespace {

using Sets = std::vector<std::vector<int>>;

/// All valid sets by trying every set of E joints.
Sets tried(const Worked& worked) {
  const ModularDoubleField field;
  Sets sets;
  std::vector<int> set;
  const auto extend = [&](const auto& self, int from) -> void {
    if (static_cast<int>(set.size()) == worked.analysis.dof) {
      const std::vector<Rational> speeds(set.size(), Rational(1));
      if (solveLive(worked.model, field, set, speeds)) sets.push_back(set);
      return;
    }
    for (int joint = from; joint < worked.model.t(); ++joint) {
      set.push_back(joint);
      self(self, joint + 1);
      set.pop_back();
    }
  };
  extend(extend, 0);
  return sets;
}

InputSets setsOf(const Worked& worked) {
  return *InputSets::of(worked.model, ModularDoubleField(), worked.analysis.choice.joints);
}

Rational power(std::int64_t base, int exponent) {
  Rational result = 1;
  for (int i = 0; i < exponent; ++i) result *= Rational(base);
  return result;
}

/// A sun, a ring, a carrier and planets, each set on axes of its own. Two inputs; the planets turn alike.
void addPlanetarySet(TrainSketch& train, int firstLink, int planets) {
  const std::string name = std::to_string(firstLink);
  const int sun = firstLink;
  const int ring = firstLink + 1;
  const int carrier = firstLink + 2;
  for (const int link : {sun, ring, carrier}) train.joint(0, link, "a" + name);
  for (int k = 0; k < planets; ++k) {
    const int planet = carrier + 1 + k;
    train.joint(carrier, planet, "p" + name + "_" + std::to_string(k));
    train.mesh(sun, planet, 30, 20, MeshKind::external).mesh(planet, ring, 20, 70, MeshKind::internal);
  }
}

/// Differentials in a row, the carrier of one the sun of the next, every ring free. Link 1 is the first sun;
/// stage s has the ring 3s + 2, the carrier 3s + 3, the planet 3s + 4. Driven at the first sun and all
/// carriers.
Mechanism chainOfDifferentials(int stages) {
  TrainSketch train(1 + 3 * stages);
  train.joint(0, 1, "a");
  for (int s = 0; s < stages; ++s) {
    const int sun = s == 0 ? 1 : 3 * s;
    train.joint(0, 3 * s + 2, "a")
        .joint(0, 3 * s + 3, "a")
        .joint(3 * s + 3, 3 * s + 4, "p" + std::to_string(s));
    train.mesh(sun, 3 * s + 4, 20, 15, MeshKind::external);
    train.mesh(3 * s + 4, 3 * s + 2, 15, 50, MeshKind::internal);
  }
  Mechanism mechanism = train.build();
  mechanism.inputs.emplace();
  mechanism.inputs->push_back({mechanism.turningJoints[0].id, Number(1), {}});
  for (int s = 0; s < stages; ++s) {
    mechanism.inputs->push_back(
        {mechanism.turningJoints[static_cast<std::size_t>(3 * s) + 2].id, Number(1), {}});
  }
  return mechanism;
}

/// Of a stage's four joints (sun, ring, carrier, planet) any two fix the others. Two stages share a joint x:
/// of the sets of the whole, `with` contain the last carrier and `without` do not. Every set of the next
/// stage with x joins both, one without x only what is left of `with` when x is taken out.
Rational setsOfChain(int stages) {
  Rational with = 1;
  Rational without = 0;
  for (int s = 0; s < stages; ++s) {
    const Rational next = Rational(3) * with + without;
    without = Rational(3) * with + Rational(2) * without;
    with = next;
  }
  return with + without;
}

}  // namespace

class InputSetsTest : public QObject {
  Q_OBJECT
 private slots:
  void theRobotHas21SetsOfThree() {
    const Worked worked(robot());
    const InputSets sets = setsOf(worked);
    QCOMPARE(*sets.count(), Rational(21));
    const Sets all = sets.list(1000);
    QCOMPARE(all.size(), std::size_t{21});
    QVERIFY(all.front() == (std::vector<int>{0, 1, 3}));
    QVERIFY(all == tried(worked));
  }

  void countAndListAreThoseOfTryingEverySet() {
    for (std::uint64_t seed = 1; seed <= 60; ++seed) {
      const int n = 6 + static_cast<int>(seed % 5);
      const Worked worked(randomTrain(seed, n, n - 2 - static_cast<int>(seed % 4)));
      const InputSets sets = setsOf(worked);
      const Sets expected = tried(worked);
      QCOMPARE(*sets.count(), Rational(static_cast<std::int64_t>(expected.size())));
      QVERIFY(sets.list(100'000) == expected);
    }
  }

  void listsStopAtTheirLimit() {
    const Worked worked(robot());
    const Sets all = setsOf(worked).list(1000);
    const Sets few = setsOf(worked).list(5);
    QCOMPARE(few.size(), std::size_t{5});
    QVERIFY(std::equal(few.begin(), few.end(), all.begin()));
    QVERIFY(setsOf(worked).list(0).empty());
  }

  void anExchangeIsValidExactlyIfTheExchangedSetIs() {
    for (std::uint64_t seed = 1; seed <= 30; ++seed) {
      const Worked worked(randomTrain(seed, 10, 7));
      const InputSets sets = setsOf(worked);
      const Sets all = tried(worked);
      const std::vector<int>& inputs = worked.analysis.choice.joints;
      for (std::size_t i = 0; i < inputs.size(); ++i) {
        for (int y = 0; y < worked.model.t(); ++y) {
          if (std::find(inputs.begin(), inputs.end(), y) != inputs.end()) continue;
          std::vector<int> exchanged = inputs;
          exchanged[i] = y;
          std::sort(exchanged.begin(), exchanged.end());
          const bool valid = std::find(all.begin(), all.end(), exchanged) != all.end();
          QCOMPARE(sets.canReplace(inputs[i], y), valid);
        }
      }
    }
  }

  void whatMayReplaceAnInputOfTheRobot() {
    const Worked worked(robot());
    const InputSets sets = setsOf(worked);
    QVERIFY(sets.replacementsFor(3) == (std::vector<int>{5, 6}));        // 11: 13 or 14
    QVERIFY(sets.replacementsFor(0) == (std::vector<int>{2, 4, 5, 6}));  // 8: 10, 12, 13 or 14
  }

  void aLockedTrainHasTheEmptySetOnly() {
    const Worked worked(
        TrainSketch(2).joint(0, 1, "a").joint(0, 2, "b").mesh(1, 2, 20, 40).mesh(1, 2, 20, 41).build());
    QCOMPARE(*setsOf(worked).count(), Rational(1));
    QVERIFY(setsOf(worked).list(10) == Sets{{}});
  }

  void hundredsOfIndependentPairsMultiply() {
    TrainSketch train(400);
    for (int i = 0; i < 200; ++i) {
      const std::string name = std::to_string(i);
      train.joint(0, 2 * i + 1, "a" + name).joint(0, 2 * i + 2, "b" + name);
    }
    for (int i = 0; i < 200; ++i) train.mesh(2 * i + 1, 2 * i + 2, 20, 30);
    const Worked worked(train.build());
    Rational power = 1;
    for (int i = 0; i < 200; ++i) power *= Rational(2);
    QCOMPARE(*setsOf(worked).count(), power);  // one of each pair
  }

  void aChainOfDifferentialsIsCountedThoughItHasNoParts() {
    for (int stages = 1; stages <= 3; ++stages) {
      const Worked small(chainOfDifferentials(stages));
      QCOMPARE(setsOfChain(stages), Rational(static_cast<std::int64_t>(tried(small).size())));
      QCOMPARE(*setsOf(small).count(), setsOfChain(stages));
    }
    Mechanism undriven = chainOfDifferentials(60);
    undriven.inputs.reset();  // now every rate depends on the rings before it
    QCOMPARE(setsOf(Worked(undriven)).count().value(), setsOfChain(60));
  }

  void nineHundredLinksInOnePieceAreCountedExactly() {
    const Worked worked(chainOfDifferentials(300));
    QCOMPARE(setsOf(worked).count().value(), setsOfChain(300));
  }

  void aPlanetarySetHasThePairsOfItsMembers() {
    TrainSketch one(4);
    addPlanetarySet(one, 1, 1);
    TrainSketch three(6);
    addPlanetarySet(three, 1, 3);  // two planets fix each other, so a planet stands for all three
    QCOMPARE(tried(Worked(one.build())).size(), std::size_t{6});
    QCOMPARE(tried(Worked(three.build())).size(), std::size_t{12});
  }

  /// 1,666 sets with three planets and one with one: 10,000 links, 3,332 redundant meshes.
  void tenThousandLinksInClosedLoopsAreCountedExactly() {
    TrainSketch train(10'000);
    constexpr int kSets = 1'666;
    for (int set = 0; set < kSets; ++set) addPlanetarySet(train, 6 * set + 1, 3);
    addPlanetarySet(train, 6 * kSets + 1, 1);
    const Worked worked(train.build());
    QCOMPARE(worked.analysis.dof, 2 * (kSets + 1));
    QCOMPARE(static_cast<int>(worked.analysis.redundancies.size()), 2 * kSets);
    QCOMPARE(setsOf(worked).count().value(), power(12, kSets) * Rational(6));
  }

  void whereThereAreTooManyInputsNeighboursAreListed() {
    TrainSketch train(2000);
    for (int v = 1; v <= 2000; ++v) train.joint(0, v, "a" + std::to_string(v));
    train.mesh(1, 2, 20, 30).mesh(3, 4, 20, 30);
    const Worked worked(train.build());
    const Sets sets = setsOf(worked).list(1000);
    QCOMPARE(sets.size(), std::size_t{3});  // itself, 2 for 1, 4 for 3
    for (const auto& set : sets) {
      const std::vector<Rational> speeds(set.size(), Rational(1));
      QVERIFY(solveLive(worked.model, ModularDoubleField(), set, speeds).has_value());
    }
    QCOMPARE(*setsOf(worked).count(), Rational(4));
  }

  void aStopEndsTheCount() {
    const Worked worked(robot());
    std::stop_source stop;
    stop.request_stop();
    QVERIFY(!setsOf(worked).count(stop.get_token()).has_value());
  }
};

QTEST_APPLESS_MAIN(InputSetsTest)
#include "test_input_sets.moc"

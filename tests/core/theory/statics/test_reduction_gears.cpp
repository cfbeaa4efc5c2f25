#include <QTest>

#include "core/theory/statics/statics_report.h"
#include "tests/core/support/example_files.h"
#include "tests/core/support/statics_case.h"
#include "tests/core/support/train_sketch.h"

using namespace geargraph;
using namespace geargraph::test;

namespace {

/// Sun a, compound planet g and f on a free carrier, ring b held, ring e driven: Wolfrom's gear, 3K.
struct Teeth {
  int sun, planet, held, other, out;  // a, g, b, f, e
};

/// Links 1 sun, 2 carrier, 3 planet, 4 output; joints 5..8; the sun driven. Meshes a-g, b-g, f-e.
Mechanism wolfrom(const Teeth& z) {
  Mechanism mechanism = TrainSketch(4)
                            .joint(0, 1, "a")
                            .joint(0, 2, "a")
                            .joint(2, 3, "b")
                            .joint(0, 4, "a")
                            .mesh(1, 3, z.sun, z.planet, MeshKind::external)
                            .mesh(0, 3, z.held, z.planet, MeshKind::internal)
                            .mesh(3, 4, z.other, z.out, MeshKind::internal)
                            .build();
  mechanism.inputs = std::vector<Input>{{mechanism.turningJoints[0].id, Number(1), {}}};
  return mechanism;
}

struct Efficiencies {
  Rational first, second, third;  // of the meshes a-g, b-g, f-e
};

/// With 1 N m at the sun; the torque at the output is found.
StaticsReport solved(Mechanism mechanism, const Efficiencies& eta) {
  const std::array<Rational, 3> values{eta.first, eta.second, eta.third};
  for (std::size_t mesh = 0; mesh < 3; ++mesh) mechanism.gearMeshes[mesh].efficiency = Number(values[mesh]);
  const StaticsCase train(mechanism);
  StaticsOptions options;
  options.losses = true;
  options.loads = {{{}, JointTorque{mechanism.turningJoints[0].id, Number(1)}}};
  options.balances = {{mechanism.turningJoints[3].id}};
  return *analyzeStatics(train.mechanism, train.model, train.placement, train.tt, train.analysis, options);
}

/// The efficiency from the balance of the planet's torques seen from the carrier, and T_a + T_b + T_e = 0.
/// I1 = z_b / z_a, I2 = z_b z_f / (z_g z_e); the speeds are w_c = w_a / (1 + I1) and w_e = (1 - I2) w_c.
///
/// I2 < 1: a and e feed the planet, b takes: T_b = -(T_a + T_e),
///     |T_b| = eta2 (eta1 I1 T_a + eta3 I2 |T_e|)
/// I2 > 1: a and b feed, e takes: I2 T_e = eta3 (eta1 I1 T_a + eta2 (T_a + T_e)).
/// The first is the formula of Yada (JSME Int. J. C 40(1), 1997, 1-8), by which Matsuki, Nagano and Fujimoto
/// design their gear (T-Mech 24(6), 2019, 2661-2673); their text was not at hand, so it is derived here.
Rational byHand(const Rational& i1, const Rational& i2, const Efficiencies& eta) {
  const Rational one = 1;
  if (i2 < one)
    return (one + eta.first * eta.second * i1) * (one - i2) /
           ((one + i1) * (one - eta.second * eta.third * i2));
  return (eta.first * eta.third * i1 + eta.second * eta.third) * (i2 - one) /
         ((one + i1) * (i2 - eta.second * eta.third));
}

/// The output drives: all flows turn round. None where it locks itself.
std::optional<Rational> backwardByHand(const Rational& i1, const Rational& i2, const Efficiencies& eta) {
  const Rational one = 1;
  const Rational efficiency =
      i2 < one ? (one + i1) * (eta.second - i2 / eta.third) / ((eta.second + i1 / eta.first) * (one - i2))
               : (one + i1) * (i2 * eta.third - one / eta.second) /
                     ((i1 / eta.first + one / eta.second) * (i2 - one));
  return efficiency.sign() > 0 ? std::optional(efficiency) : std::nullopt;
}

void check(const Mechanism& mechanism, const Rational& i1, const Rational& i2, const Efficiencies& eta) {
  const StaticsReport forward = solved(mechanism, eta);
  QVERIFY(forward.agreement->equal);
  QCOMPARE((*forward.motion)[3], (Rational(1) - i2) / (Rational(1) + i1));
  QCOMPARE(forward.lossy->outcome, LossySolution::Outcome::solved);
  QCOMPARE(*forward.sums->efficiency()->fraction(), byHand(i1, i2, eta));
  const auto backward = backwardByHand(i1, i2, eta);
  QCOMPARE(forward.backward->outcome == LossySolution::Outcome::solved, backward.has_value());
  if (!backward) {
    QCOMPARE(forward.backward->outcome, LossySolution::Outcome::selfLocking);
    return;
  }
  QCOMPARE(*forward.backwardSums->efficiency()->fraction(), *backward);
}

const std::vector<Efficiencies>& manyEfficiencies() {
  static const std::vector<Efficiencies> all{
      {1, 1, 1},
      {Rational(98, 100), Rational(98, 100), Rational(98, 100)},
      {Rational(99, 100), Rational(998, 1000), Rational(997, 1000)},
      {Rational(9, 10), Rational(999, 1000), Rational(999, 1000)},
      {Rational(9, 10), Rational(8, 10), Rational(7, 10)},
  };
  return all;
}

}  // namespace

class ReductionGearsTest : public QObject {
  Q_OBJECT

 private slots:
  void wolfromsGear() {
    int locked = 0;
    for (const Teeth& z : {Teeth{18, 36, 90, 33, 87}, Teeth{12, 42, 96, 45, 99}, Teeth{24, 30, 84, 24, 78},
                           Teeth{15, 20, 55, 26, 61}, Teeth{30, 18, 66, 21, 69}}) {
      const Rational i1(z.held, z.sun);
      const Rational i2 = Rational(z.held, z.planet) * Rational(z.other, z.out);
      QVERIFY(i2 != Rational(1));
      for (const Efficiencies& eta : manyEfficiencies()) {
        check(wolfrom(z), i1, i2, eta);
        locked += backwardByHand(i1, i2, eta) ? 0 : 1;
      }
    }
    QVERIFY(locked > 5);  // gears of a high ratio do
    QVERIFY(locked < 20);
  }

  /// Humpage's bevel gear is 3K on cones: the same teeth, the same efficiencies, whatever the angles.
  void humpagesGearIsWolfromsOnCones() {
    const Mechanism humpage = example("humpage-reduction");
    const Rational i1(76, 20);
    const Rational i2 = Rational(76, 56) * Rational(24, 35);
    for (const Efficiencies& eta : manyEfficiencies()) {
      check(humpage, i1, i2, eta);
      const StaticsReport cones = solved(humpage, eta);
      const StaticsReport flat = solved(wolfrom({20, 56, 76, 24, 35}), eta);
      QCOMPARE(*cones.sums->efficiency()->fraction(), *flat.sums->efficiency()->fraction());
      QCOMPARE(*cones.latentRatio->fraction(), *flat.latentRatio->fraction());
      for (int mesh = 0; mesh < 3; ++mesh)
        QCOMPARE(cones.powers.mesh[static_cast<std::size_t>(mesh)].abs(),
                 flat.powers.mesh[static_cast<std::size_t>(mesh)].abs());
    }
  }

  /// In symbols: at the train's own ratios and efficiencies the function is the number.
  void theEfficiencyInSymbols() {
    for (const Teeth& z : {Teeth{18, 36, 90, 33, 87}, Teeth{12, 42, 96, 45, 99}}) {
      const StaticsReport report = solved(wolfrom(z), manyEfficiencies()[2]);
      QVERIFY(report.efficiency.has_value());
      const Rational ratios[] = {Rational(z.sun, z.planet), Rational(z.held, z.planet),
                                 Rational(z.other, z.out),  Rational(99, 100),
                                 Rational(998, 1000),       Rational(997, 1000)};
      QCOMPARE(*report.efficiency->valueAt(ratios), *report.sums->efficiency()->fraction());
      if (report.backwardSums)
        QCOMPARE(*report.backwardEfficiency->valueAt(ratios), *report.backwardSums->efficiency()->fraction());
      QVERIFY(report.efficiency->toText().find("eta11") != std::string::npos);
    }
    QCOMPARE(solved(wolfrom({18, 36, 90, 33, 87}), manyEfficiencies()[0]).efficiency->toText(),
             std::string("1"));
  }

  /// The load at the output instead of the input gives the same efficiency.
  void wherePowerIsKnownChangesNothing() {
    const Teeth z{18, 36, 90, 33, 87};
    const Efficiencies eta = manyEfficiencies()[2];
    Mechanism mechanism = wolfrom(z);
    const std::array<Rational, 3> values{eta.first, eta.second, eta.third};
    for (std::size_t mesh = 0; mesh < 3; ++mesh) mechanism.gearMeshes[mesh].efficiency = Number(values[mesh]);
    const StaticsCase train(mechanism);
    StaticsOptions options;
    options.losses = true;
    options.loads = {{{}, JointTorque{mechanism.turningJoints[3].id, Number(-70)}}};
    options.balances = {{mechanism.turningJoints[0].id}};
    const StaticsReport report =
        *analyzeStatics(train.mechanism, train.model, train.placement, train.tt, train.analysis, options);
    const StaticsReport other = solved(wolfrom(z), eta);
    QCOMPARE(*report.sums->efficiency()->fraction(), *other.sums->efficiency()->fraction());
  }
};

QTEST_APPLESS_MAIN(ReductionGearsTest)
#include "test_reduction_gears.moc"

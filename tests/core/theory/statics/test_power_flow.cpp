#include <QTest>
#include <random>

#include "core/theory/statics/statics_report.h"
#include "tests/core/support/deep_train.h"
#include "tests/core/support/example_files.h"
#include "tests/core/support/gearboxes.h"
#include "tests/core/support/statics_case.h"
#include "tests/core/support/train_sketch.h"
#include "tests/core/support/trains.h"

using namespace geargraph;
using namespace geargraph::test;

namespace {

Load inJoint(const Mechanism& mechanism, int joint, const Number& torque) {
  return {{}, JointTorque{mechanism.turningJoints[static_cast<std::size_t>(joint)].id, torque}};
}

/// Loads in joints, on links and at points, balances in the inputs that bear no load.
StaticsOptions randomOptions(const StaticsCase& train, std::uint64_t seed) {
  std::mt19937_64 random(seed);
  const auto number = [&] { return Number(Rational(static_cast<std::int64_t>(random() % 41) - 20, 3)); };
  StaticsOptions options;
  options.symbolic = false;
  const Mechanism& mechanism = train.mechanism;
  for (const int joint : train.analysis.choice.joints)
    options.balances.push_back({mechanism.turningJoints[static_cast<std::size_t>(joint)].id});
  for (int joint = 0; joint < train.model.t(); ++joint)
    if (random() % 2 == 0) options.loads.push_back(inJoint(mechanism, joint, number()));
  for (std::size_t link = 1; link < mechanism.links.size(); ++link) {
    const LinkId id = mechanism.links[link].id;
    if (random() % 3 == 0) options.loads.push_back({{}, LinkTorque{id, {}, number()}});
    if (random() % 3 == 0)
      options.loads.push_back(
          {{}, LinkForce{id, {number(), number(), number()}, {number(), number(), number()}}});
  }
  return options;
}

/// What is wrong with a flow: empty where every link's ports sum to 0, and every element feeds what its
/// torques do.
std::string faultOf(const StaticsCase& train, const StaticsReport& report, const PowerFlow& flow) {
  double size = 1;
  bool isExact = true;
  for (const ElementPower& element : flow.elements)
    for (const PowerPort& port : element.ports) {
      size = std::max(size, std::abs(port.power.number()));
      isExact = isExact && port.power.isExact();
    }
  const auto isZero = [&](const Real& value) {
    return isExact ? value.isZero() : std::abs(value.number()) <= 1e-9 * size;
  };
  const std::vector<Real> sums = flow.sums(train.model.n() + 1);
  for (std::size_t link = 0; link < sums.size(); ++link)
    if (!isZero(sums[link])) return "link " + std::to_string(link);
  Real fed;
  for (const ElementPower& element : flow.elements) {
    const Real own = element.fed();
    if (element.kind == ElementPower::Kind::coupling && !isZero(own)) return "coupling";
    if (element.kind == ElementPower::Kind::mesh) {
      const auto mesh = static_cast<std::size_t>(element.position);
      const Rational kept = report.losses().empty() || report.losses()[mesh].driver == MeshLoss::Driver::none
                                ? Rational(1)
                                : report.losses()[mesh].efficiency;
      if (!isZero(own + (Real(1) - Real(kept)) * report.powers.mesh[mesh].abs())) return "mesh";
      continue;
    }
    fed += own;
  }
  if (!isZero(fed - report.sums->lost)) return "the train";
  return {};
}

}  // namespace

class PowerFlowTest : public QObject {
  Q_OBJECT

 private slots:
  /// The power in the spec's planetary set: 1000 W at the sun, ring held, 0.98 a mesh.
  void aPlanetarySetByHand() {
    Mechanism set = planetary(24, 18);
    set.inputs = std::vector<Input>{{set.turningJoints[0].id, Number(100), {}},
                                    {set.turningJoints[1].id, Number(0), {}}};
    const StaticsCase train(set);
    StaticsOptions options;
    options.loads = {inJoint(set, 0, Number(10))};
    options.balances = {{set.turningJoints[1].id}, {set.turningJoints[2].id}};
    options.losses = true;
    options.efficiency = Rational(98, 100);
    const StaticsReport report = reportOf(train, options);
    QVERIFY(report.flow.has_value());
    QCOMPARE(faultOf(train, report, *report.flow), std::string());
    // Carrier 200/7 rad/s of the sun's 100: of 1000 W the sun's mesh passes 5000/7 seen from the carrier.
    QCOMPARE(*report.powers.mesh[0].abs().fraction(), Rational(5000, 7));
    const ElementPower& sun = report.flow->of(ElementPower::Kind::mesh, 0);
    QCOMPARE(*sun.ports[0].power.fraction(), Rational(-1000));  // all of it is taken from the sun
    QCOMPARE(*sun.fed().fraction(), Rational(-100, 7));         // 2 % of 5000/7
    // The output is 3401/35 N m times 200/7 ... of the whole 97.17 % arrive.
    QCOMPARE(*report.sums->efficiency()->fraction(), Rational(3401, 3500));
    QCOMPARE(*report.latentRatio->fraction(),
             (Rational(5000, 7) + Rational(5000, 7) * Rational(98, 100)) / Rational(1000));
    // The joint of the carrier takes what arrives, that of the ring nothing.
    QCOMPARE(*report.flow->of(ElementPower::Kind::joint, 2).fed().fraction(),
             Rational(-1000) * Rational(3401, 3500));
    QVERIFY(report.flow->of(ElementPower::Kind::joint, 1).fed().isZero());
    QVERIFY(report.circulations && report.circulations->empty());
  }

  /// Seen from the carrier, the carrier's own ports are nothing and a mesh passes its rolling power alone.
  void theCarriersFrame() {
    Mechanism set = planetary(24, 18);
    set.inputs = std::vector<Input>{{set.turningJoints[0].id, Number(100), {}},
                                    {set.turningJoints[1].id, Number(0), {}}};
    const StaticsCase train(set);
    StaticsOptions options;
    options.loads = {inJoint(set, 0, Number(10))};
    options.balances = {{set.turningJoints[1].id}, {set.turningJoints[2].id}};
    const StaticsReport report = reportOf(train, options);
    const PowerFlow flow = powerFlowSeenFrom(train.mechanism, train.model, train.placement, report, 3);
    QCOMPARE(faultOf(train, report, flow), std::string());
    for (int mesh = 0; mesh < 2; ++mesh) {
      const ElementPower& element = flow.of(ElementPower::Kind::mesh, mesh);
      QVERIFY(element.ports[2].power.isZero());
      QCOMPARE(*element.ports[1].power.fraction(),
               *report.powers.mesh[static_cast<std::size_t>(mesh)].fraction());
    }
    // The ring turns against the carrier: its reaction now has power, which the ground takes.
    QVERIFY(!flow.of(ElementPower::Kind::joint, 1).ports[0].power.isZero());
  }

  void everyNodeOfEveryExampleSumsToZero() {
    int states = 0;
    for (const std::string& name : exampleNames()) {
      if (name == "robot-to-mend") continue;
      const StaticsCase train(example(name));
      for (const bool losses : {false, true}) {
        StaticsOptions options = randomOptions(train, 7);
        options.losses = losses;
        options.efficiency = Rational(97, 100);
        const StaticsReport report = reportOf(train, options);
        if (report.motion) {
          QVERIFY2(report.flow.has_value(), name.c_str());
          for (const int observer : {0, train.model.n()})
            QVERIFY2(
                faultOf(train, report,
                        powerFlowSeenFrom(train.mechanism, train.model, train.placement, report, observer))
                    .empty(),
                name.c_str());
        }
        for (int state = 0; state < static_cast<int>(train.mechanism.states.size()); ++state) {
          StaticsOptions shifted;
          shifted.state = state;
          shifted.losses = losses;
          shifted.efficiency = Rational(97, 100);
          const StaticsReport gear = reportOf(train, shifted);
          if (!gear.flow) continue;
          QCOMPARE(faultOf(train, gear, *gear.flow), std::string());
          ++states;
        }
      }
    }
    QVERIFY(states > 10);
  }

  void everyNodeOfRandomTrainsSumsToZero() {
    int exact = 0;
    int lossy = 0;
    for (std::uint64_t seed = 1; seed <= 60; ++seed) {
      const int n = 4 + static_cast<int>(seed % 14);
      const StaticsCase train(seed % 3 == 0 ? deepTrain(seed, n)
                                            : randomTrain(seed, n, n - 1 - static_cast<int>(seed % 3)));
      StaticsOptions options = randomOptions(train, seed);
      options.losses = seed % 2 == 0;
      options.efficiency = Rational(97, 100);
      const StaticsReport report = reportOf(train, options);
      QVERIFY(report.flow.has_value());
      for (const int observer : {0, 1 + static_cast<int>(seed) % n}) {
        const PowerFlow flow =
            powerFlowSeenFrom(train.mechanism, train.model, train.placement, report, observer);
        QVERIFY2(faultOf(train, report, flow).empty(), faultOf(train, report, flow).c_str());
        exact += std::all_of(flow.elements.begin(), flow.elements.end(),
                             [](const ElementPower& each) { return each.fed().isExact(); });
      }
      lossy += !report.losses().empty();
    }
    QVERIFY2(exact > 40, qPrintable(QString::number(exact)));
    QVERIFY2(lossy > 8, qPrintable(QString::number(lossy)));
  }

  void largeTrainsToo() {
    for (const bool deep : {false, true}) {
      const StaticsCase train(deep ? deepTrain(3, 500) : randomTrain(3, 500, 498));
      StaticsOptions options = randomOptions(train, 3);
      options.loads.resize(20);
      const StaticsReport report = reportOf(train, options);
      QVERIFY(report.flow.has_value());
      QCOMPARE(faultOf(train, report, *report.flow), std::string());
    }
  }

  /// A clutch passes what it takes; its two ends turn as one.
  void clutchesPassPower() {
    const StaticsCase train(eightSpeed());
    for (int state = 0; state < static_cast<int>(train.mechanism.states.size()); ++state) {
      StaticsOptions options;
      options.state = state;
      const StaticsReport report = reportOf(train, options);
      QCOMPARE(faultOf(train, report, *report.flow), std::string());
      for (const int coupling : report.problem.engaged) {
        const ElementPower& element = report.flow->of(ElementPower::Kind::coupling, coupling);
        QVERIFY(element.fed().isZero());
        if (train.mechanism.couplings[static_cast<std::size_t>(coupling)].kind == ShiftElementKind::brake)
          QVERIFY(element.ports[0].power.isZero());
      }
    }
  }

  /// The closed train of one freedom: sun and carrier of a planetary set joined by a countershaft, the ring
  /// driven, the carrier out. Where the sun or the carrier brings power back to the set, that power goes
  /// round by the countershaft.
  void aClosedTrainCirculates() {
    // 1 sun, 2 carrier, 3 ring, 4 planet, 5 countershaft: 2 drives 5, 5 drives 1.
    struct Teeth {
      int carrier, fromCarrier, toSun, sun;
      MeshKind kind;
    };
    int circulating = 0;
    int split = 0;
    for (const Teeth& teeth :
         {Teeth{40, 20, 30, 30, MeshKind::external}, Teeth{20, 40, 30, 30, MeshKind::external},
          Teeth{30, 30, 20, 40, MeshKind::external}, Teeth{40, 20, 20, 80, MeshKind::internal},
          Teeth{20, 40, 30, 90, MeshKind::internal}, Teeth{45, 15, 50, 110, MeshKind::internal}}) {
      Mechanism mechanism = TrainSketch(5)
                                .joint(0, 1, "a")
                                .joint(0, 2, "a")
                                .joint(0, 3, "a")
                                .joint(2, 4, "b")
                                .joint(0, 5, "c")
                                .mesh(1, 4, 24, 18, MeshKind::external)
                                .mesh(4, 3, 18, 60, MeshKind::internal)
                                .mesh(2, 5, teeth.carrier, teeth.fromCarrier, MeshKind::external)
                                .mesh(5, 1, teeth.toSun, teeth.sun, teeth.kind)
                                .build();
      mechanism.inputs = std::vector<Input>{{mechanism.turningJoints[2].id, Number(1), {}}};
      const StaticsCase train(mechanism);
      StaticsOptions options;
      options.loads = {inJoint(mechanism, 2, Number(1))};
      options.balances = {{mechanism.turningJoints[1].id}};
      const StaticsReport report = reportOf(train, options);
      QVERIFY(report.flow && report.circulations);
      QCOMPARE(faultOf(train, report, *report.flow), std::string());
      // The set takes 1 W at its ring and gives the sun `sun`, the carrier the rest.
      const Rational sun = setTo(report, 1);
      const Rational carrier = setTo(report, 2);
      QCOMPARE(sun + carrier, Rational(1));
      // By hand: the ring's torque 1 has 24/60 on the sun, 84/60 on the carrier.
      QCOMPARE(sun, Rational(24, 60) * (*report.motion)[0] * Rational(-1));
      if (sun.sign() >= 0 && carrier.sign() >= 0) {
        QVERIFY(report.circulations->empty());
        ++split;
        continue;
      }
      QCOMPARE(report.circulations->size(), std::size_t{1});
      const Circulation& loop = report.circulations->front();
      QCOMPARE(*loop.power.fraction(), sun.sign() < 0 ? -sun : -carrier);
      QCOMPARE(loop.links, (std::vector{1, 2, 5}));
      QCOMPARE(loop.meshes, (std::vector{0, 1, 2, 3}));
      const auto named =
          std::find_if(report.diagnostics.begin(), report.diagnostics.end(), [](const Diagnostic& each) {
            return each.message.find(
                       " W of each W fed circulate through links 1, 2 and 5 and meshes 11, 12, "
                       "13 and 14.") != std::string::npos;
          });
      QVERIFY(named != report.diagnostics.end());
      QCOMPARE(named->code, Code::recirculation);
      ++circulating;
    }
    QVERIFY(circulating >= 2);
    QVERIFY(split >= 2);
  }

  /// With a brake on the ring instead of an input and its balance, the efficiency in symbols is the same.
  void symbolicEfficiencyWithEngagedCouplings() {
    Mechanism set = planetary(24, 18);
    addBrake(set, "B", 2);
    addState(set, "1", {"B"}, 1, 3);
    set.inputs = std::vector<Input>{{set.turningJoints[0].id, Number(100), {}},
                                    {set.turningJoints[1].id, Number(0), {}}};
    StaticsOptions options;
    options.losses = true;
    options.efficiency = Rational(98, 100);
    StaticsOptions inState = options;
    inState.state = 0;
    const StaticsReport report = reportOf(StaticsCase(set), inState);
    QVERIFY(report.efficiency && report.backwardEfficiency);
    QCOMPARE(report.efficiency->toText(), std::string("(i10*i9 + eta10*eta9)/(i10*i9 + 1)"));
    // A gearbox: in each state where it is short enough the function has the value of the solution.
    const StaticsCase gearbox(eightSpeed());
    int found = 0;
    for (int state = 0; state < static_cast<int>(gearbox.mechanism.states.size()); ++state) {
      inState.state = state;
      const StaticsReport solved = reportOf(gearbox, inState);
      if (!solved.efficiency) continue;
      ++found;
      std::vector<Rational> values;
      for (const GearMesh& mesh : gearbox.mechanism.gearMeshes)
        values.push_back(Rational(mesh.tailTeeth, mesh.headTeeth));
      for (const MeshLoss& loss : solved.lossy->losses)
        if (loss.driver != MeshLoss::Driver::none) values.emplace_back(98, 100);
      QCOMPARE(*solved.efficiency->valueAt(values), *solved.sums->efficiency()->fraction());
    }
    QVERIFY(found > 0);
  }

  /// Three planets share in unknown parts, but the set of all three passes what it passes.
  void planetsThatShareAreOneSet() {
    Mechanism set = planetary(24, 18, 3);
    set.inputs = std::vector<Input>{{set.turningJoints[1].id, Number(0), {}},
                                    {set.turningJoints[0].id, Number(1), {}}};
    const StaticsCase train(set);
    StaticsOptions options;
    options.loads = {inJoint(set, 0, Number(1))};
    options.balances = {{set.turningJoints[1].id}, {set.turningJoints[2].id}};
    const StaticsReport report = reportOf(train, options);
    QVERIFY(report.circulations && report.circulations->empty());
    QVERIFY(!report.flow->of(ElementPower::Kind::mesh, 0).isDetermined);
    QVERIFY(report.flow->of(ElementPower::Kind::joint, 0).isDetermined);
    QVERIFY(!report.latentRatio);
    QCOMPARE(faultOf(train, report, *report.flow), std::string());
  }

  /// A differential has two pinions that share in unknown parts. Its shafts pass what they pass in any case,
  /// and so do the bearings of the pinions: on each the torques of its two meshes cancel.
  void jointsBesideASelfStressAreDetermined() {
    const StaticsCase train(example("bevel-differential"));
    StaticsOptions options;
    options.loads = {inJoint(train.mechanism, 2, Number(-10))};
    const StaticsReport report = reportOf(train, options);
    QCOMPARE(report.lossless.indeterminate(), 1);
    QVERIFY(report.flow.has_value());
    const auto joint = [&](const PowerFlow& flow, int at) -> const ElementPower& {
      return flow.of(ElementPower::Kind::joint, at);
    };
    for (int at = 0; at < 5; ++at) QVERIFY(joint(*report.flow, at).isDetermined);
    QCOMPARE(*joint(*report.flow, 0).ports[1].power.fraction(), Rational(20));
    QCOMPARE(*joint(*report.flow, 1).ports[1].power.fraction(), Rational(-15));
    QCOMPARE(*joint(*report.flow, 2).ports[1].power.fraction(), Rational(-5));
    for (int mesh = 0; mesh < 4; ++mesh)
      QVERIFY(!report.flow->of(ElementPower::Kind::mesh, mesh).isDetermined);
    QCOMPARE(faultOf(train, report, *report.flow), std::string());
  }

  /// Of a robot's wrist the sets are no parts of fixed shafts.
  void aWristHasNoShafts() {
    const StaticsCase train(robot());
    StaticsOptions options;
    options.loads = {inJoint(train.mechanism, 6, Number(10))};
    const StaticsReport report = reportOf(train, options);
    QVERIFY(report.flow.has_value() && !report.circulations.has_value());
    QCOMPARE(faultOf(train, report, *report.flow), std::string());
  }

 private:
  /// By the meshes 0 and 1 and their planet's joint 3 to a link, W.
  static Rational setTo(const StaticsReport& report, int link) {
    Real sum;
    const auto add = [&](ElementPower::Kind kind, int position) {
      for (const PowerPort& port : report.flow->of(kind, position).ports)
        if (port.link == link) sum += port.power;
    };
    add(ElementPower::Kind::mesh, 0);
    add(ElementPower::Kind::mesh, 1);
    add(ElementPower::Kind::joint, 3);
    return *sum.fraction();
  }
};

QTEST_APPLESS_MAIN(PowerFlowTest)
#include "test_power_flow.moc"

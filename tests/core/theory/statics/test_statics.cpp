#include <QTest>
#include <random>

#include "core/theory/matroid/exact_solution.h"
#include "core/theory/matroid/input_sets.h"
#include "core/theory/states/state_solution.h"
#include "core/theory/statics/cutset_equations.h"
#include "core/theory/statics/symbolic_statics.h"
#include "tests/core/support/deep_train.h"
#include "tests/core/support/example_files.h"
#include "tests/core/support/gearboxes.h"
#include "tests/core/support/statics_case.h"
#include "tests/core/support/train_sketch.h"
#include "tests/core/support/trains.h"

using namespace geargraph;
using namespace geargraph::test;

namespace {

/// All examples but the one with errors.
std::vector<std::string> soundExamples() {
  std::vector<std::string> names;
  for (const std::string& name : exampleNames()) {
    if (name != "robot-to-mend") names.push_back(name);
  }
  return names;
}

/// Loads in all joints and on all links: whole and broken numbers, some about the axes of others, some
/// forces.
StaticsProblem randomLoads(const StaticsCase& train, std::uint64_t seed) {
  std::mt19937_64 random(seed);
  const auto number = [&] {
    return Rational(static_cast<std::int64_t>(random() % 41) - 20,
                    static_cast<std::int64_t>(random() % 7) + 1);
  };
  StaticsProblem problem = StaticsCase::balancedIn(train.analysis.choice.joints);
  for (int joint = 0; joint < train.model.t(); ++joint)
    if (random() % 3 == 0) problem.torques.push_back({StaticsCase::at(joint), number()});
  for (int link = 1; link <= train.model.n(); ++link) {
    if (random() % 4 == 0) problem.torques.push_back({train.on(link), number()});
    const AxisId axis = train.mechanism.axes[random() % train.mechanism.axes.size()].id;
    if (random() % 6 == 0)
      problem.torques.push_back({onLink(train.mechanism, train.placement, link, axis), number()});
    if (random() % 6 == 0)
      problem.forces.push_back({link, {number(), number(), number()}, {number(), number(), number()}});
  }
  return problem;
}

/// tau_balanced = -K_r^T tau_loaded, entry by entry.
void isTransposed(const StaticsCase& train, const std::vector<int>& inputs) {
  const std::vector<Rational> speeds(inputs.size(), Rational(1));
  const auto rates = solveExact(train.model, inputs, speeds);
  const auto torques = torqueMatrix(train.model, train.held(StaticsCase::balancedIn(inputs)), rates->outputs);
  QVERIFY(torques);
  QCOMPARE(torques->entries.size(), rates->matrix.size());
  for (std::size_t input = 0; input < inputs.size(); ++input) {
    for (std::size_t output = 0; output < rates->outputs.size(); ++output) {
      QCOMPARE(torques->entries[input * rates->outputs.size() + output],
               -rates->matrix[output * inputs.size() + input]);
    }
  }
}

void bothMethodsAgree(const StaticsCase& train, const StaticsProblem& problem) {
  const StaticsSolution matroid = train.solve(problem);
  const StaticsAgreement agreement = staticsAgreement(train.model, matroid, train.solveByTtGraph(problem));
  QVERIFY(agreement.equal);
  QVERIFY(!matroid.isBalanced() || agreement.compared > 0 || matroid.indeterminate() > 0 ||
          matroid.unknowns == 0);
  // The same by levels, one balance a link, and in doubles.
  QVERIFY(staticsAgreement(train.model, matroid, train.solveByTtGraph(problem, 0)).equal);
  const auto live =
      solveStaticsLive(train.model, ModularDoubleField(), train.held(problem), train.power(problem).byLink);
  QCOMPARE(live->isBalanced, matroid.isBalanced());
  QCOMPARE(live->rank, matroid.rank);
  QCOMPARE(live->indeterminate, matroid.indeterminate());
  QCOMPARE(live->determined, matroid.determined);
  for (std::size_t i = 0; i < live->values.size(); ++i) {
    const double exact = matroid.values[i].number();
    if (matroid.determined[i] != 0)
      QVERIFY(std::abs(live->values[i] - exact) <= 1e-6 * (1 + std::abs(exact)));
  }
}

}  // namespace

class StaticsTest : public QObject {
  Q_OBJECT

 private slots:
  // --- the paper's robot ----------------------------------------------------------------------------------

  /// (25*), typed from the page: rows 8, 9, 11, columns 10, 12, 13, 14.
  void theRobotsTorques_inTheGearRatios() {
    const StaticsCase train(robot());
    const CoefficientMatrix matrix(train.mechanism, train.model, train.placement);
    const std::vector<int> balanced{0, 1, 3};
    const std::vector<int> loaded{2, 4, 5, 6};
    const auto solution = solveStaticsSymbolic(train.mechanism, CutsetEquations(matrix),
                                               train.analysis.independentMeshes, balanced, loaded);
    QVERIFY(solution);
    const std::vector<std::string> expected{"i15", "i16*i15", "i17*i16*i15", "i18*i17*i16*i15",
                                            "0",   "i16",     "i17*i16",     "i18*i17*i16",
                                            "0",   "0",       "i17",         "i18*i17"};
    for (std::size_t i = 0; i < expected.size(); ++i) QCOMPARE(solution->matrix[i]->toText(), expected[i]);
    QCOMPARE(solution->lines.size(), std::size_t{7});
  }

  /// (43*): the same matrix by the T-T graph's cutsets, which know nothing of P.
  void theRobotsTorques_inTheGearRatiosByTheTtGraph() {
    const StaticsCase train(robot());
    const std::vector<int> balanced{0, 1, 3};
    const std::vector<int> loaded{2, 4, 5, 6};
    const auto solution = solveStaticsSymbolic(train.mechanism, CutsetEquations(train.tt),
                                               train.analysis.independentMeshes, balanced, loaded);
    QVERIFY(solution);
    const std::vector<std::string> expected{"i15", "i16*i15", "i17*i16*i15", "i18*i17*i16*i15",
                                            "0",   "i16",     "i17*i16",     "i18*i17*i16",
                                            "0",   "0",       "i17",         "i18*i17"};
    for (std::size_t i = 0; i < expected.size(); ++i) QCOMPARE(solution->matrix[i]->toText(), expected[i]);
  }

  /// (19*): the columns of P with the signs of the page.
  void theRobotsCutsets_haveTheSignsOfThePage() {
    const StaticsCase train(robot());
    const CoefficientMatrix matrix(train.mechanism, train.model, train.placement);
    const CutsetEquations cutsets(matrix);
    // By joint 8 .. 14: mesh labels with the sign of T, as printed.
    const std::vector<std::vector<int>> expected{{15}, {16}, {-15, -16}, {17}, {-16, -17}, {-17, 18}, {-18}};
    for (int joint = 0; joint < 7; ++joint) {
      std::vector<int> found;
      for (const CutsetEquations::Term& term : cutsets.terms(joint)) {
        const auto row = matrix.row(term.mesh);
        const auto same =
            std::find_if(row.begin(), row.end(), [&](const auto& entry) { return entry.joint == joint; });
        QVERIFY(same != row.end());
        QCOMPARE(term.length, same->length);
        // All joints are drawn outward: T is +1 on the way to the tail's gear, -1 on that to the head's.
        const int label = train.mechanism.meshLabel(term.mesh);
        const int tail = train.graph->meshEdge(term.mesh).tail;
        found.push_back(train.model.tree().isOnWalk(joint, tail) ? label : -label);
      }
      QCOMPARE(found, expected[static_cast<std::size_t>(joint)]);
    }
  }

  /// theory: 10 N m at joint 14, teeth 18/36, 20/30, 24/18, 16/24.
  void theRobotsMotors_holdALoadOnTheHand() {
    const StaticsCase train(robot());
    StaticsProblem problem = StaticsCase::balancedIn({0, 1, 3});
    problem.torques = {{StaticsCase::at(6), 10}};
    const StaticsSolution solution = train.solve(problem);
    QCOMPARE(*train.balance(solution, 0).fraction(), Rational(80, 27));
    QCOMPARE(*train.balance(solution, 1).fraction(), Rational(160, 27));
    QCOMPARE(*train.balance(solution, 2).fraction(), Rational(80, 9));
  }

  /// The chain (39*)...: a load on joint 14 alone, from the hand back to the motors.
  void theRobotsChain_runsFromTheLoadToTheMotors() {
    const StaticsCase train(robot());
    StaticsProblem problem = StaticsCase::balancedIn({0, 1, 3});
    problem.torques = {{StaticsCase::at(6), 1}};
    const TtTorques torques = train.solveByTtGraph(problem);
    const Rational n37 = Rational(16, 24);  // i18 = N7 / N3
    const Rational n67 = Rational(24, 18);
    // M'''' of mesh 18: -M_32 on gear 3, n73 M_32 on gear 7; then (28*), (27*) and the cutsets before them.
    QCOMPARE(*torques.headPorts[3].fraction(), Rational(-1));
    QCOMPARE(*torques.tailPorts[3].fraction(), n37);
    QCOMPARE(*torques.headPorts[2].fraction(), -n37);
    QCOMPARE(*torques.tailPorts[2].fraction(), -n67 * n37);
    QCOMPARE(*torques.chords[2].fraction(), n67 * n37);
    QCOMPARE(torques.steps.size(), std::size_t{7});
    QCOMPARE(torques.steps[0].mesh, 3);
    QCOMPARE(torques.steps[0].joint, 6);
    for (const TtStaticStep& step : torques.steps) QVERIFY(!step.coupled);
  }

  // --- transposition --------------------------------------------------------------------------------------

  void everyInputSetOfEveryExample_holdsByTheTransposedKinematics() {
    int sets = 0;
    for (const std::string& name : soundExamples()) {
      const StaticsCase train(example(name));
      const auto all = InputSets::of(train.model, ModularDoubleField(), train.analysis.choice.joints);
      for (const std::vector<int>& inputs : all->list(200)) {
        isTransposed(train, inputs);
        ++sets;
      }
    }
    QVERIFY(sets > 150);
  }

  void whereNoInputsCanBe_noLoadsAreHeld() {
    const StaticsCase train(robot());
    const auto all =
        InputSets::of(train.model, ModularDoubleField(), train.analysis.choice.joints)->list(1000);
    int held = 0;
    for (int a = 0; a < 7; ++a) {
      for (int b = a + 1; b < 7; ++b) {
        for (int c = b + 1; c < 7; ++c) {
          const std::vector<int> set{a, b, c};
          std::vector<int> others;
          for (int joint = 0; joint < 7; ++joint)
            if (joint != a && joint != b && joint != c) others.push_back(joint);
          const bool holds =
              torqueMatrix(train.model, train.held(StaticsCase::balancedIn(set)), others).has_value();
          QCOMPARE(holds, std::find(all.begin(), all.end(), set) != all.end());
          held += holds ? 1 : 0;
        }
      }
    }
    QCOMPARE(held, 21);
  }

  void randomTrains_transposeAndAgree() {
    int shared = 0;
    int coupled = 0;
    for (std::uint64_t seed = 1; seed <= 120; ++seed) {
      const int n = 5 + static_cast<int>(seed % 20);
      const StaticsCase train(
          randomTrain(seed, n, n / 3 + static_cast<int>(seed % static_cast<unsigned>(n))));
      isTransposed(train, train.analysis.choice.joints);
      const StaticsProblem problem = randomLoads(train, seed);
      bothMethodsAgree(train, problem);
      const StaticsSolution solution = train.solve(problem);
      QVERIFY(solution.isBalanced());
      shared += solution.indeterminate() > 0 ? 1 : 0;
      for (const TtStaticStep& step : train.solveByTtGraph(problem).steps) coupled += step.coupled ? 1 : 0;
    }
    QVERIFY(shared > 5 && coupled > 5);  // the sample covers what it should
  }

  void largeTrains_agree() {
    for (const int links : {120, 500}) {
      const StaticsCase train(deepTrain(7, links));
      bothMethodsAgree(train, randomLoads(train, 3));
      isTransposed(train, train.analysis.choice.joints);
    }
    const StaticsCase wide(randomTrain(11, 500, 480));
    bothMethodsAgree(wide, randomLoads(wide, 5));
  }

  /// d'Alembert: loads, balances and nothing else do no work in any motion.
  void loadsAndBalancesDoNoWork() {
    for (std::uint64_t seed = 1; seed <= 40; ++seed) {
      const int n = 6 + static_cast<int>(seed % 12);
      const StaticsCase train(randomTrain(seed, n, n - 2));
      const StaticsProblem problem = randomLoads(train, seed + 1000);
      const StaticsSolution solution = train.solve(problem);
      std::vector<Rational> speeds;
      for (std::size_t i = 0; i < train.analysis.choice.joints.size(); ++i)
        speeds.emplace_back(static_cast<std::int64_t>(i) * 3 - 4, static_cast<std::int64_t>(i) + 2);
      const auto rates = solveExact(train.model, train.analysis.choice.joints, speeds)->rates;
      const LoadPower power = train.power(problem);
      Real work;
      for (int joint = 0; joint < train.model.t(); ++joint)
        work += power.byJoint.at(joint) * Real(rates[static_cast<std::size_t>(joint)]);
      for (std::size_t i = 0; i < speeds.size(); ++i)
        work += train.balance(solution, static_cast<int>(i)) * Real(speeds[i]);
      QVERIFY(std::abs(work.number()) < 1e-6);
      if (work.isExact()) QVERIFY(work.isZero());
    }
  }

  // --- planetary trains -----------------------------------------------------------------------------------

  /// Willis: sun : ring : carrier = 1 : Nr/Ns : -(1 + Nr/Ns).
  void membersOfAPlanetarySet() {
    const StaticsCase train(planetary(24, 18));
    StaticsProblem problem = StaticsCase::balancedIn({1, 2});
    problem.torques = {{StaticsCase::at(0), 1}};
    const StaticsSolution solution = train.solve(problem);
    QCOMPARE(*train.balance(solution, 0).fraction(), Rational(60, 24));
    QCOMPARE(*train.balance(solution, 1).fraction(), -Rational(84, 24));
    bothMethodsAgree(train, problem);
  }

  void planetsShare_butTheMembersAreDetermined() {
    const StaticsCase train(planetary(24, 18, 3));
    StaticsProblem problem = StaticsCase::balancedIn({1, 2});
    problem.torques = {{StaticsCase::at(0), 1}};
    const StaticsSolution solution = train.solve(problem);
    QCOMPARE(solution.indeterminate(), 2);
    for (int mesh = 0; mesh < 6; ++mesh) QVERIFY(!solution.isDetermined(mesh));
    QVERIFY(solution.isDetermined(6) && solution.isDetermined(7));
    QCOMPARE(*train.balance(solution, 0).fraction(), Rational(60, 24));
    for (const auto& members : solution.selfStresses) {
      QCOMPARE(members.size(), std::size_t{4});  // two planets against each other
      for (const auto& [unknown, weight] : members) QVERIFY(weight == Rational(1) || weight == Rational(-1));
    }
    bothMethodsAgree(train, problem);
  }

  void aLoadThatNothingHolds_namesTheMotion() {
    const StaticsCase train(robot());
    StaticsProblem problem = StaticsCase::balancedIn({0, 1});
    problem.torques = {{StaticsCase::at(6), 1}};
    const StaticsSolution solution = train.solve(problem);
    QVERIFY(!solution.isBalanced());
    QVERIFY(solution.values.empty());
    QCOMPARE(solution.unheld->joints, (std::vector{3, 5, 6}));  // 11, 13 and 14
    bothMethodsAgree(train, problem);
  }

  // --- brakes and clutches --------------------------------------------------------------------------------

  /// All torques about the one axis of the shafts add up to nothing, and the output has ratio times the
  /// input.
  void couplingsOfTheEightSpeedGearbox() {
    const StaticsCase train(eightSpeed());
    const auto states = *solveStates(train.mechanism, train.model, train.placement);
    for (const StateSolution& state : states) {
      StaticsProblem problem;
      problem.engaged = state.engaged;
      problem.torques = {{train.on(1), 1}};
      problem.balances = {train.on(2)};
      const StaticsSolution solution = train.solve(problem);
      QVERIFY(solution.isBalanced());
      QCOMPARE(solution.indeterminate(), 0);
      QCOMPARE(*train.balance(solution, 0).fraction(), -*state.ratio);
      Rational sum = Rational(1) - *state.ratio;
      for (const int engaged : state.engaged) {
        const ShiftElement& coupling = train.mechanism.couplings[static_cast<std::size_t>(engaged)];
        if (coupling.kind == ShiftElementKind::brake)
          sum += *train.coupling(solution, coupling.id.text().c_str()).fraction();
      }
      QVERIFY(sum.isZero());
      bothMethodsAgree(train, problem);
    }
  }

  /// A brake in place of the ring's motor takes what the motor took; a clutch passes its torque on.
  void couplingsTakeWhatMotorsTook() {
    Mechanism set = planetary(24, 18);
    addBrake(set, "R", 2);
    addClutch(set, "L", 1, 3);
    const StaticsCase train(set);
    StaticsProblem braked = StaticsCase::balancedIn({2});
    braked.engaged = {0};
    braked.torques = {{StaticsCase::at(0), 2}};
    const StaticsSolution solution = train.solve(braked);
    QCOMPARE(*train.coupling(solution, "R").fraction(), Rational(5));
    QCOMPARE(*train.balance(solution, 0).fraction(), Rational(-7));
    bothMethodsAgree(train, braked);
    // Locked as one block: of 2 N m on the sun the clutch passes on what the teeth do not.
    StaticsProblem locked = StaticsCase::balancedIn({1});
    locked.engaged = {1};
    locked.torques = {{StaticsCase::at(0), 2}};
    const StaticsSolution block = train.solve(locked);
    QCOMPARE(*train.balance(block, 0).fraction(), Rational(-2));
    // The teeth turn the ring with 2 against its balance, and the sun with 24/60 of it, 4/5, in the same
    // sense: the clutch holds the sun against both.
    QCOMPARE(*train.coupling(block, "L").fraction(), Rational(-2) - Rational(4, 5));
    bothMethodsAgree(train, locked);
  }

  void couplingsAcrossAxes() {
    const StaticsCase train(bevelDifferential());
    for (int coupling = 0; coupling < 4; ++coupling) {
      QVERIFY(closesWithoutLinkage(train.mechanism, train.placement, coupling));
      for (const std::vector<int>& balanced : std::vector<std::vector<int>>{{0}, {0, 1}, {1}}) {
        StaticsProblem problem = StaticsCase::balancedIn(balanced);
        problem.engaged = {coupling};
        problem.torques = {{StaticsCase::at(2), 3}, {train.on(4), 2}};
        bothMethodsAgree(train, problem);
      }
    }
  }

  // --- loads -----------------------------------------------------------------------------------------------

  /// 20 N at 30 mm from the axis of a shaft is 0.6 N m, whatever the unit.
  void aForceActsWithItsArm() {
    for (const auto& [unit, arm] : std::vector<std::pair<std::string, Rational>>{
             {"mm", 30}, {"cm", 3}, {"m", Rational(3, 100)}, {"in", Rational(300, 254)}}) {
      Mechanism pair = TrainSketch(1).axis("a", {"0", "0", "0"}).joint(0, 1, "a").build();
      pair.unit = unit;
      const StaticsCase train(pair);
      StaticsProblem problem = StaticsCase::balancedIn({0});
      problem.forces = {{1, {0, 20, 5}, {arm, 0, 7}}};
      QCOMPARE(*train.balance(train.solve(problem), 0).fraction(), Rational(-3, 5));
    }
    Mechanism odd = TrainSketch(1).axis("a", {"0", "0", "0"}).joint(0, 1, "a").build();
    for (const char* unit : {"", "parsec", "e3 m"}) {
      odd.unit = unit;
      QVERIFY(!metresPerUnit(odd));
    }
  }

  /// Along an axis of irrational length torques stay exact; about a line at an angle they have its cosine.
  void torquesAboutObliqueDirections() {
    Mechanism shaft = TrainSketch(1)
                          .axis("a", {"0", "0", "0"}, {"1", "1", "0"})
                          .axis("b", {"0", "0", "0"}, {"1", "0", "0"})
                          .axis("c", {"0", "0", "0"}, {"3", "3", "0"})
                          .joint(0, 1, "a")
                          .build();
    const StaticsCase train(shaft);
    const auto balanced = [&](const char* axis) {
      StaticsProblem problem = StaticsCase::balancedIn({0});
      problem.torques = {{onLink(train.mechanism, train.placement, 1, AxisId(axis)), 4}};
      return train.balance(train.solve(problem), 0);
    };
    QCOMPARE(*balanced("a").fraction(), Rational(-4));
    QCOMPARE(*balanced("c").fraction(), Rational(-4));
    QVERIFY(!balanced("b").isExact());
    QVERIFY(std::abs(balanced("b").number() + 2 * std::sqrt(2.0)) < 1e-12);
  }

  /// Irrational arms that cancel hold exactly: no balance, and no rounding that would call it unheld.
  void irrationalLoadsThatCancel_areHeld() {
    Mechanism shaft = TrainSketch(1).axis("a", {"0", "0", "0"}, {"1", "1", "1"}).joint(0, 1, "a").build();
    const StaticsCase train(shaft);
    StaticsProblem problem;
    problem.forces = {{1, {5, 0, 0}, {0, 7, 0}}, {1, {0, 5, 0}, {7, 0, 0}}};
    QVERIFY(train.solve(problem).isBalanced());
    problem.forces.push_back({1, {0, 1, 0}, {1, 0, 0}});
    QVERIFY(!train.solve(problem).isBalanced());
  }

  void placeAndOrientationChangeNoTorque() {
    for (const char* name : {"robot", "bevel-wrist", "humpage-reduction"}) {
      const Mechanism original = example(name);
      const StaticsCase before(original);
      const StaticsCase after(moved(original, rotation(1, 2, -2, 4), {100, -20, Rational(1, 3)}));
      StaticsProblem problem = StaticsCase::balancedIn(before.analysis.choice.joints);
      for (int joint = 0; joint < before.model.t(); ++joint)
        problem.torques.push_back({StaticsCase::at(joint), joint + 1});
      const StaticsSolution one = before.solve(problem);
      const StaticsSolution other = after.solve(problem);
      for (std::size_t part = 0; part < one.held.size(); ++part) {
        const auto at = static_cast<std::size_t>(before.model.c()) + part;
        QCOMPARE(one.values[at], other.values[at]);
      }
    }
  }
};

QTEST_APPLESS_MAIN(StaticsTest)
#include "test_statics.moc"

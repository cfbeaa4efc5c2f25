#include <QTest>

#include "core/theory/ttgraph/equations.h"
#include "tests/core/support/textbook_trains.h"
#include "tests/core/support/trains.h"
#include "tests/core/support/tt_case.h"

namespace geargraph {
namespace {

using Stages = std::vector<std::string>;

/// A mechanism, solved for inputs, with its equations in print.
struct Printed {
  Printed(const Mechanism& mechanism, const std::vector<int>& inputs, RatioNaming naming, FormulaStyle style)
      : found(mechanism),
        plan(substitutionPlan(found.graph, inputs)),
        ring(ttRatioRing(found.graph, naming)),
        solution(ttSymbolicSolution(ring, found.graph, plan).value()),
        steps(substitutionSteps(ring, found.graph, plan, solution).value()),
        equations(found.graph, plan, naming, style) {}

  test::TtCase found;
  SubstitutionPlan plan;
  RatioRingPtr ring;
  RateMatrix<std::optional<RationalFunction>> solution;
  std::vector<SubstitutionStep> steps;
  TtEquations equations;
};

/// Sun, ring and carrier on axis a with one planet.
Mechanism planetary() {
  for (const test::TextbookTrain& train : test::textbookTrains()) {
    if (train.name == "planetary, ring held, planets 1") return train.mechanism;
  }
  return {};
}

}  // namespace

/// The equations as they are printed.
class TtEquationsTest : public QObject {
  Q_OBJECT

 private slots:
  void theRobotsChainReadsAsInThePaper() {
    const Printed robot(test::robot(), {0, 1, 3}, RatioNaming::ttGraph, FormulaStyle::text);
    QCOMPARE(robot.equations.stages(robot.steps[0]), (Stages{"w10", "w10'", "-n41 w40'", "-n41 w40"}));
    QCOMPARE(robot.equations.stages(robot.steps[1]),
             (Stages{"w21", "w21''", "-n52 w51''", "-n52 (w50 - w10)", "-n52*n41 w40 - n52 w50"}));
    QCOMPARE(robot.equations.stages(robot.steps[2]),
             (Stages{"w32", "w32''''", "n73 w72''''", "n73 w72", "n73 (-n67 w62''')",
                     "n73 (-n67 (w61 - w21))", "-n73*n67*n52*n41 w40 - n73*n67*n52 w50 - n73*n67 w61"}));
    QCOMPARE(robot.equations.stages(robot.steps[3]),
             (Stages{"w72", "n37 w32", "-n67*n52*n41 w40 - n67*n52 w50 - n67 w61"}));
  }

  void theSameInLatex() {
    const Printed robot(test::robot(), {0, 1, 3}, RatioNaming::ttGraph, FormulaStyle::latex);
    QCOMPARE(robot.equations.terminal(1), std::string("\\omega_{51}'' = -n_{25} \\omega_{21}''"));
    QCOMPARE(robot.equations.tailCircuit(1), std::string("\\omega_{51}'' = \\omega_{50} - \\omega_{10}"));
    QCOMPARE(robot.equations.headCircuit(0), std::string("\\omega_{10}' = \\omega_{10}"));
    QCOMPARE(robot.equations.stages(robot.steps[1]),
             (Stages{"\\omega_{21}", "\\omega_{21}''", "-n_{52} \\omega_{51}''",
                     "-n_{52} (\\omega_{50} - \\omega_{10})",
                     "-n_{52} n_{41} \\omega_{40} - n_{52} \\omega_{50}"}));
  }

  void labelsOfTwoDigitsAreKeptApart() {
    test::TrainBuilder train("row of wheels");
    int last = 0;
    for (int wheel = 0; wheel < 11; ++wheel) {
      const int axis = train.axis({50 * wheel, 0, 0}, {0, 0, 1});
      const int next = train.link(0, axis);
      if (wheel > 0) train.external(last, axis - 1, 20, next, axis, 30);
      last = next;
    }
    const Printed row(train.mechanism(), {8}, RatioNaming::ttGraph, FormulaStyle::latex);
    QCOMPARE(row.equations.terminal(9),
             std::string("\\omega_{10,0}^{(10)} = -n_{11,10} \\omega_{11,0}^{(10)}"));
    const auto step = std::find_if(row.steps.begin(), row.steps.end(),
                                   [](const SubstitutionStep& s) { return s.joint == 10; });
    QCOMPARE(row.equations.stages(*step).back(), std::string("n_{10,11} n_{9,10} \\omega_{90}"));
  }

  void gearRatiosAreWrittenWithTheirMeshes() {
    const Printed robot(test::robot(), {0, 1, 3}, RatioNaming::matroid, FormulaStyle::latex);
    QCOMPARE(robot.equations.terminal(0), std::string("\\omega_{40}' = -\\frac{1}{i_{15}} \\omega_{10}'"));
    QCOMPARE(robot.equations.stages(robot.steps[0]).back(), std::string("-i_{15} \\omega_{40}"));
  }

  void anUnknownAmongSeveralBranchesIsTakenOutOfItsCircuit() {
    // Inputs 10, 12, 11: then w50 stands beside the known w10 in the circuit of chord 51.
    const Printed robot(test::robot(), {2, 4, 3}, RatioNaming::ttGraph, FormulaStyle::text);
    const auto step = std::ranges::find_if(robot.steps, [&](const SubstitutionStep& each) {
      return branchName(*robot.found.digraph, each.joint).toText() == "w50";
    });
    QVERIFY(step != robot.steps.end());
    QCOMPARE(robot.equations.stages(*step),
             (Stages{"w50", "w51'' + w10", "-n25 w21'' + w10", "-n25 w21 + w10", "w10 - 1/n52 w21"}));
  }

  void aBranchDrawnAgainstTheWalkTurnsItsSign() {
    Mechanism mechanism = test::robot();
    std::swap(mechanism.turningJoints[2].tail, mechanism.turningJoints[2].head);
    const Printed robot(mechanism, {0, 1, 3}, RatioNaming::ttGraph, FormulaStyle::text);
    QCOMPARE(robot.equations.stages(robot.steps[0]), (Stages{"w01", "-w10'", "n41 w40'", "n41 w40"}));
    QCOMPARE(robot.equations.stages(robot.steps[1]).at(3), std::string("-n52 (w50 + w01)"));
  }

  void coupledMeshesAreSolvedTogetherAndSaid() {
    const Printed train(planetary(), {0, 1}, RatioNaming::ttGraph, FormulaStyle::text);
    QCOMPARE(train.plan.coupledUnknowns, 2);
    QCOMPARE(train.steps.size(), std::size_t(2));
    QVERIFY(train.steps[0].coupled);
    QCOMPARE(train.steps[0].equations, (std::vector<int>{0, 1}));
    QCOMPARE(train.steps[0].number, 33);
    // Every step holds at the ratios' own values, whatever its stages.
    const auto exact = ttSolution(train.found.graph, train.plan).value();
    for (const SubstitutionStep& step : train.steps) {
      for (std::size_t input = 0; input < 2; ++input) {
        const auto rateOf = [&](int joint) {
          if (joint < 2) return Rational(joint == static_cast<int>(input) ? 1 : 0);
          const auto output = std::find(exact.outputs.begin(), exact.outputs.end(), joint);
          return exact.entries[static_cast<std::size_t>(output - exact.outputs.begin())][input];
        };
        QCOMPARE(step.after[input]->valueAt(train.ring->values()).value(), rateOf(step.joint));
        Rational before;
        for (const SolvedTerm& term : step.before) {
          before += term.coefficient.valueAt(train.ring->values()).value() * rateOf(term.joint);
        }
        QCOMPARE(before, rateOf(step.joint));
      }
    }
  }
};

}  // namespace geargraph

QTEST_APPLESS_MAIN(geargraph::TtEquationsTest)
#include "test_tt_equations.moc"

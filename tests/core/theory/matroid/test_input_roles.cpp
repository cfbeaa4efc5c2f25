#include <QTest>

#include "core/theory/matroid/input_roles.h"
#include "tests/core/support/matroid_fixture.h"
#include "tests/core/support/train_sketch.h"
#include "tests/core/support/trains.h"

using namespace geargraph;
using namespace geargraph::test;

namespace {

/// The paper's robot with its inputs 8, 9 and 11; ordinals are labels less 8.
Mechanism drivenRobot() {
  Mechanism mechanism = robot();
  mechanism.inputs = std::vector<Input>{
      {JointId("8"), Number(1), {}}, {JointId("9"), Number(1), {}}, {JointId("11"), Number(1), {}}};
  return mechanism;
}

}  // namespace

class InputRolesTest : public QObject {
  Q_OBJECT

 private slots:
  void anInputCommandsWhatItsColumnOfEq25Holds() {
    const Worked worked(drivenRobot());
    const LiveSolution& solution = *worked.analysis.solution;
    QCOMPARE(commandedBy(solution, 0), (std::vector{2, 4, 5, 6}));  // 8: 10, 12, 13, 14
    QCOMPARE(commandedBy(solution, 1), (std::vector{4, 5, 6}));     // 9: 12, 13, 14
    QCOMPARE(commandedBy(solution, 3), (std::vector{5, 6}));        // 11: 13, 14
    QCOMPARE(commandersOf(solution, 2), std::vector{0});
    QCOMPARE(commandersOf(solution, 6), (std::vector{0, 1, 3}));
  }

  void whatAnInputCommandsMayTakeItsPlaceAndNothingElse() {
    const Worked worked(drivenRobot());
    const LiveSolution& solution = *worked.analysis.solution;
    for (const int input : solution.inputs) {
      const std::vector<int> commanded = commandedBy(solution, input);
      for (const int output : solution.outputs) {
        std::vector<int> set = solution.inputs;
        std::replace(set.begin(), set.end(), input, output);
        const bool may = std::find(commanded.begin(), commanded.end(), output) != commanded.end();
        const ModularDoubleField field;
        const std::vector<Rational> speeds(set.size(), 1);
        QCOMPARE(solveLive(worked.model, field, set, speeds).has_value(), may);
      }
    }
  }

  void tiedJointsTurnAtFixedRatios() {
    const Worked worked(drivenRobot());
    const auto exact = solveExact(worked.model, worked.analysis.choice.joints, worked.analysis.speeds);
    QCOMPARE(tiedJoints(*exact), (std::vector<std::vector<int>>{{0, 2}, {5, 6}}));  // 8-10 and 13-14
  }

  void theEndEffectorsJointsReadTheMotors() {
    const Worked worked(drivenRobot());
    const std::vector<int> chain = chainTo(*worked.tree, 3);  // link 3, the end-effector
    QCOMPARE(chain, (std::vector{2, 4, 6}));                  // 10, 12, 14
    const InputCompletion completion(worked.model);
    QCOMPARE(*completion.with(chain, worked.analysis.choice.joints), chain);
    const std::vector<int> tied{0, 2};  // 8 and 10 are no free choice
    QVERIFY(!completion.with(tied, worked.analysis.choice.joints));
    const std::vector<int> one{6};
    QCOMPARE(completion.with(one, worked.analysis.choice.joints)->front(), 6);
    QCOMPARE(completion.with(one, worked.analysis.choice.joints)->size(), std::size_t(3));
  }
};

QTEST_APPLESS_MAIN(InputRolesTest)
#include "test_input_roles.moc"

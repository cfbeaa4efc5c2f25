#include <QTest>
#include <algorithm>

#include "core/teaching/coupling_check/coupling_check.h"
#include "core/theory/matroid/joint_coupling.h"
#include "tests/core/support/example_files.h"
#include "tests/core/support/matroid_fixture.h"

using namespace geargraph;
using namespace geargraph::test;

namespace {

/// The paper's robot with its three motors, and the joints 10, 12, 14 of its chain.
struct RobotCoupling {
  Worked worked{example("robot")};
  ExactSolution exact = *solveExact(worked.model, worked.analysis.choice.joints, worked.analysis.speeds);
  std::vector<JointOrdinal> joints{JointOrdinal(2), JointOrdinal(4), JointOrdinal(6)};
  JointCoupling coupling = *jointCoupling(exact, joints);

  [[nodiscard]] std::vector<std::string> namesOf(const WrittenCoupling& written) const {
    std::vector<std::string> names;
    for (const CouplingFinding& each : checkWrittenCoupling(worked.mechanism, coupling, written))
      names.emplace_back(each.name);
    return names;
  }
  [[nodiscard]] std::vector<std::string> namesOf(const std::vector<Rational>& matrix,
                                                 CouplingMatrix which) const {
    WrittenCoupling written;
    written.size = coupling.size();
    std::vector<CouplingNumber> numbers;
    for (const Rational& each : matrix) numbers.push_back({each, 0, each.toString()});
    (which == CouplingMatrix::motorToJoint ? written.motorToJoint : written.jointToMotor) = numbers;
    return namesOf(written);
  }
};

std::vector<Rational> transposedMatrix(const std::vector<Rational>& matrix, std::size_t size) {
  std::vector<Rational> result(matrix.size());
  for (std::size_t i = 0; i < size; ++i) {
    for (std::size_t j = 0; j < size; ++j) result[j * size + i] = matrix[i * size + j];
  }
  return result;
}

using Names = std::vector<std::string>;

}  // namespace

class JointCouplingTest : public QObject {
  Q_OBJECT

 private slots:
  void bothMatricesAreInverse() {
    const RobotCoupling robot;
    const std::size_t size = 3;
    for (std::size_t i = 0; i < size; ++i) {
      for (std::size_t j = 0; j < size; ++j) {
        Rational sum;
        for (std::size_t k = 0; k < size; ++k)
          sum += robot.coupling.motorToJoint[i * size + k] * robot.coupling.jointToMotor[k * size + j];
        QCOMPARE(sum, Rational(i == j ? 1 : 0));
      }
    }
    // Joints of which one follows from the others determine no motors.
    QVERIFY(!jointCoupling(robot.exact, {robot.joints[0], robot.joints[0], robot.joints[1]}));
  }

  void writtenMatricesAreNamedByWhatIsWrongWithThem() {
    const RobotCoupling robot;
    const auto& a = robot.coupling.motorToJoint;
    const auto& b = robot.coupling.jointToMotor;
    const auto which = CouplingMatrix::motorToJoint;
    QCOMPARE(robot.namesOf(a, which), Names{"right"});
    QCOMPARE(robot.namesOf(b, CouplingMatrix::jointToMotor), Names{"right"});
    QCOMPARE(robot.namesOf(transposedMatrix(a, 3), which), Names{"transposed"});
    QCOMPARE(robot.namesOf(b, which), Names{"other-matrix"});
    QCOMPARE(robot.namesOf(transposedMatrix(b, 3), which), Names{"torque-matrix"});
    auto turned = a;  // the second motor turns the other way
    for (std::size_t row = 0; row < 3; ++row) turned[row * 3 + 1] = -turned[row * 3 + 1];
    QCOMPARE(robot.namesOf(turned, which), Names{"sign"});
    auto exchanged = a;  // the first two motors
    for (std::size_t row = 0; row < 3; ++row) std::swap(exchanged[row * 3], exchanged[row * 3 + 1]);
    QCOMPARE(robot.namesOf(exchanged, which), Names{"order"});
    auto scaled = a;  // the last joint in other units
    for (std::size_t k = 6; k < 9; ++k) scaled[k] *= Rational(7, 3);
    QCOMPARE(robot.namesOf(scaled, which), Names{"factor"});
    auto wrong = a;
    wrong[6] += Rational(1, 7);
    wrong[7] += Rational(1, 9);
    const Names names = robot.namesOf(wrong, which);
    QVERIFY(names.size() >= 2 &&
            std::all_of(names.begin(), names.end(), [](const std::string& name) { return name == "entry"; }));
  }

  void matricesHaveToBeInverseOfEachOther() {
    const RobotCoupling robot;
    WrittenCoupling written;
    written.size = 3;
    const auto numbers = [](const std::vector<Rational>& matrix) {
      std::vector<CouplingNumber> all;
      for (const Rational& each : matrix) all.push_back({each, 0, each.toString()});
      return all;
    };
    written.motorToJoint = numbers(robot.coupling.motorToJoint);
    written.jointToMotor = numbers(robot.coupling.jointToMotor);
    QCOMPARE(robot.namesOf(written), (Names{"right", "right"}));
    (*written.jointToMotor)[0].value += Rational(1);
    const Names names = robot.namesOf(written);
    QVERIFY(std::count(names.begin(), names.end(), "not-inverse") == 1);
    // Offsets: motors = A^-1 (joints - offsets).
    written.jointToMotor = numbers(robot.coupling.jointToMotor);
    written.jointOffsets = numbers({Rational(1, 2), Rational(-1), Rational(3)});
    std::vector<Rational> back(3);
    for (std::size_t i = 0; i < 3; ++i) {
      for (std::size_t k = 0; k < 3; ++k)
        back[i] -= robot.coupling.jointToMotor[i * 3 + k] * (*written.jointOffsets)[k].value;
    }
    written.motorOffsets = numbers(back);
    QCOMPARE(robot.namesOf(written), (Names{"right", "right"}));
    (*written.motorOffsets)[2].value += Rational(1);
    QCOMPARE(robot.namesOf(written), (Names{"right", "right", "offsets"}));
  }

  void decimalsStandForWhatRoundsToThem() {
    QVERIFY(writtenNumber("0.333")->standsFor(Rational(1, 3)));
    QVERIFY(!writtenNumber("0.334")->standsFor(Rational(1, 3)));
    QVERIFY(writtenNumber("0.3333333333333333")->standsFor(Rational(1, 3)));
    QVERIFY(writtenNumber("-3.3e-2")->standsFor(Rational(-33, 1000)));
    QVERIFY(writtenNumber("1/3")->standsFor(Rational(1, 3)));
    QVERIFY(!writtenNumber("2")->standsFor(Rational(201, 100)));
    QVERIFY(!writtenNumber("x") && !writtenNumber(""));
  }

  void filesAreReadOrRejectedWithTheirLine() {
    const auto lines = readWrittenCoupling("1, -1/2\n\n0.5; 2\n", CouplingMatrix::motorToJoint);
    QVERIFY(lines && lines->size == 2 && lines->motorToJoint && !lines->jointToMotor);
    QCOMPARE((*lines->motorToJoint)[1].value, Rational(-1, 2));
    const auto json =
        readWrittenCoupling(R"({"motorToJoint": [["1", 0], [2, 3.5]], "jointOffsets": [0, 1]})", {});
    QVERIFY(json && json->size == 2 && (*json->motorToJoint)[3].value == Rational(7, 2));
    QVERIFY(isWrittenCoupling(R"({"jointToMotor": []})") && !isWrittenCoupling("[[1]]") &&
            !isWrittenCoupling("1"));
    const auto ragged = readWrittenCoupling("1 2\n3\n", CouplingMatrix::jointToMotor);
    QVERIFY(!ragged && ragged.error().front().line == 2 && ragged.error().front().code == Code::schema);
    for (const char* wrong :
         {"{}", "[[1, 2]]", "{\"motorToJoint\": [[1, null], [0, 1]]}", "{\"motorToJoint\": 1}",
          "{\"motorToJoint\": [[1]], \"jointToMotor\": [[1, 0], [0, 1]]}",
          "{\"motorToJoint\": [[1]], \"jointOffsets\": [1, 2]}", "[", "one two"})
      QVERIFY2(!readWrittenCoupling(wrong, CouplingMatrix::motorToJoint), wrong);
  }
};

QTEST_APPLESS_MAIN(JointCouplingTest)
#include "test_joint_coupling.moc"

#include <QTest>
#include <numbers>

#include "core/theory/matroid/exact_solution.h"
#include "core/theory/matroid/screw.h"
#include "core/theory/matroid/symbolic_solution.h"
#include "tests/core/support/matroid_fixture.h"
#include "tests/core/support/robot_variants.h"
#include "tests/core/support/trains.h"

using namespace geargraph;
using namespace geargraph::test;

namespace {

// The robot's diameters, d = 2 N.
constexpr double kD1 = 72;
constexpr double kD2 = 60;
constexpr double kD3 = 48;
constexpr double kD4 = 36;
constexpr double kD5 = 40;
constexpr double kD6 = 48;
constexpr double kD7a = 36;  // d7'
constexpr double kD7b = 32;  // d7''

// Positions of the robot's joints 8..14 and meshes 15..18 in their lists.
constexpr int joint(int label) {
  return label - 8;
}
constexpr int mesh(int label) {
  return label - 15;
}

/// phi_k, the offset angles of the turning axes.
double phi(int label) {
  return label == 11 || label == 12 || label == 14 ? -std::numbers::pi / 2 : 0;
}

bool near(const Vector3& a, const Vector3& b) {
  return length(a - b) < 1e-12;
}

const Worked& paper() {
  static const Worked worked(robot());
  return worked;
}

/// The screw of a joint about a pitch point, by labels.
Screw<double> screw(int meshLabel, int jointLabel) {
  const Placement& placement = paper().placement;
  const AxisLine& line = placement.axes[placement.tree->axisOf[joint(jointLabel)]];
  return screwAbout(placement.meshes[mesh(meshLabel)]->pitchPoint, line.point, line.direction);
}

/// P_c,k, its component in the paper's x direction.
double coefficient(int meshLabel, int jointLabel) {
  return dot(paper().placement.meshes[mesh(meshLabel)]->normal, screw(meshLabel, jointLabel).moment);
}

CoefficientMatrix matrix() {
  return {paper().mechanism, paper().model, paper().placement};
}

SymbolicSolution symbolic() {
  return *solveSymbolic(paper().mechanism, paper().model, matrix(), paper().analysis.independentMeshes,
                        paper().analysis.choice.joints);
}

Vector3 meshVelocity(int label) {
  return meshVelocities(paper().model, paper().analysis.linkVelocities)[mesh(label)];
}

}  // namespace

class MatroidPaperTest : public QObject {
  Q_OBJECT
 private slots:
  void eq06_screwsHaveADirectionAndAMoment() {
    const Screw<double> s = screw(16, 12);
    QVERIFY(near(s.direction, {0, 1, 0}));      // L M N
    QVERIFY(near(s.moment, {-kD2 / 2, 0, 0}));  // P Q R
  }

  void eq07_directionsAreTheTurnedZAxis() {
    for (int label = 8; label <= 14; ++label) {
      QVERIFY(near(offsetDirection(phi(label)), screw(label == 14 ? 18 : 15, label).direction));
    }
  }

  void eq08_offsetRotation() {
    const double angle = 0.3;
    const Vector3Of<Vector3> rows = offsetRotation(angle);
    QVERIFY(near(rows[0], {1, 0, 0}));
    QVERIFY(near(rows[1], {0, std::cos(angle), -std::sin(angle)}));
    QVERIFY(near(rows[2], {0, std::sin(angle), std::cos(angle)}));
  }

  void eq09_componentsOfTheDirections() {
    for (const int label : {8, 9, 10, 13}) QVERIFY(near(screw(15, label).direction, {0, 0, 1}));
    for (const int label : {11, 12, 14}) QVERIFY(near(screw(15, label).direction, {0, 1, 0}));
    QVERIFY(near(offsetDirection(0.3), {0, -std::sin(0.3), std::cos(0.3)}));
  }

  void eq10_momentsAreDistanceTimesDirection() {
    // The paper calls r a position vector; it is the moment of the joint's axis about the pitch point.
    const Vector3 distance{3, 5, 7};
    const Vector3 direction{2, -1, 4};
    QVERIFY(
        near(screwAbout(Vector3{1, 1, 1}, Vector3{4, 6, 8}, direction).moment, cross(distance, direction)));
  }

  void eq11_distancesRunFromThePitchPointToTheJoint() {
    QVERIFY(near(screwAbout(Vector3{0, 0, 0}, Vector3{0, 1, 0}, Vector3{0, 0, 1}).moment, {1, 0, 0}));
  }

  void eq12_componentsOfTheMoments() {
    // Q = R = 0 holds because all x are 0; in general Q = -x cos phi, R = -x sin phi.
    for (const double angle : {0.0, 0.4, -1.1}) {
      const double x = 2, y = 3, z = 5;
      const Vector3 moment = screwAbout(Vector3{0, 0, 0}, Vector3{x, y, z}, offsetDirection(angle)).moment;
      QVERIFY(near(moment,
                   {z * std::sin(angle) + y * std::cos(angle), -x * std::cos(angle), -x * std::sin(angle)}));
    }
  }

  void table1_coefficientsOfCycle15() {
    QCOMPARE(coefficient(15, 8), -kD4 / 2);
    QCOMPARE(coefficient(15, 10), kD1 / 2);
  }
  void table1_coefficientsOfCycle16() {
    QCOMPARE(coefficient(16, 9), kD5 / 2);
    QCOMPARE(coefficient(16, 10), kD5 / 2);
    QCOMPARE(coefficient(16, 12), -kD2 / 2);
  }
  void table1_coefficientsOfCycle17() {
    // Erratum: Table 1 prints y17 = d2'/2, but there is no d2'; d7'/2 gives the P17,13 that the paper prints.
    QCOMPARE(paper().placement.meshes[mesh(17)]->pitchPoint[1], kD7a / 2);
    QCOMPARE(coefficient(17, 11), kD6 / 2);
    QCOMPARE(coefficient(17, 12), kD6 / 2);
    QCOMPARE(coefficient(17, 13), -kD7a / 2);
  }
  void table1_coefficientsOfCycle18() {
    QCOMPARE(coefficient(18, 13), -kD7b / 2);
    QCOMPARE(coefficient(18, 14), -kD3 / 2);
  }

  void eq13_twistsAreScrewsTimesRates() {
    const Twist<double> twist = screw(16, 12) * 2.0;
    QVERIFY(near(twist.angular, {0, 2, 0}));
    QVERIFY(near(twist.linear, {-kD2, 0, 0}));
  }

  void eq14_theTwistsOfEveryCycleAddUpToNothing() {
    // Erratum: the Hadamard product itself is not 0; its sum over the joints of each cycle is, mesh included.
    const auto& solution = *paper().analysis.solution;
    for (int label = 15; label <= 18; ++label) {
      Vector3 angular = meshVelocity(label);  // the cycle runs along the mesh: U
      Vector3 linear{};
      for (int j = 8; j <= 14; ++j) {
        const auto& edge = paper().graph->meshEdge(mesh(label));
        const int T =
            paper().tree->pathEntry(joint(j), edge.head) - paper().tree->pathEntry(joint(j), edge.tail);
        const Twist<double> twist = screw(label, j) * solution.rates[joint(j)];
        angular = angular + static_cast<double>(T) * twist.angular;
        linear = linear + static_cast<double>(T) * twist.linear;
      }
      QVERIFY(near(angular, {0, 0, 0}));
      QVERIFY(near(linear, {0, 0, 0}));
    }
  }

  void eq15_meshVelocitiesAreVectors() {
    // Erratum: the paper writes one scalar a mesh; gears on axes at right angles need two components.
    const Worked& p = paper();
    const auto& q = p.analysis.solution->rates;
    QVERIFY(near(meshVelocity(15), {0, 0, q[joint(10)] - q[joint(8)]}));
    QVERIFY(near(meshVelocity(16), {0, q[joint(12)], q[joint(10)] - q[joint(9)]}));
    QVERIFY(near(meshVelocity(17), {0, q[joint(12)] - q[joint(11)], q[joint(13)]}));
    QVERIFY(near(meshVelocity(18), {0, q[joint(14)], -q[joint(13)]}));
  }

  void eq16_momentsOfEveryCycleAddUpToNothing() {
    for (int label = 15; label <= 18; ++label) {
      const auto& edge = paper().graph->meshEdge(mesh(label));
      Vector3 sum{};
      for (int j = 8; j <= 14; ++j) {
        const int T =
            paper().tree->pathEntry(joint(j), edge.head) - paper().tree->pathEntry(joint(j), edge.tail);
        const double rate = paper().analysis.solution->rates[joint(j)];
        sum = sum + (T * rate) * screw(label, j).moment;
      }
      QVERIFY(near(sum, {0, 0, 0}));
    }
  }

  void eq17_oneScalarEquationACycle() {
    for (int row = 0; row < 4; ++row) {
      double sum = 0;
      for (const auto& entry : matrix().row(row)) {
        sum += entry.length * paper().analysis.solution->rates[entry.joint];
      }
      QVERIFY(std::abs(sum) < 1e-12);
    }
  }

  void eq18_eq19_coefficientMatrixInLengths() {
    // clang-format off
    const std::vector<std::vector<double>> expected{
        //     8        9       10       11       12       13       14
        {-kD4 / 2,        0, -kD1 / 2,       0,        0,        0,       0},   // C15
        {       0, kD5 / 2, -kD5 / 2,       0,  kD2 / 2,        0,       0},   // C16
        {       0,       0,        0, kD6 / 2, -kD6 / 2, kD7a / 2,       0},   // C17
        {       0,       0,        0,       0,        0, -kD7b / 2, kD3 / 2}};  // C18
    // clang-format on
    for (int row = 0; row < 4; ++row) {
      std::vector<double> found(7, 0);
      for (const auto& entry : matrix().row(row)) found[static_cast<std::size_t>(entry.joint)] = entry.length;
      QCOMPARE(found, expected[static_cast<std::size_t>(row)]);
    }
    QCOMPARE(*matrix().exactRadius(mesh(17), true), Rational(24));
  }

  void eq20_ratiosAreThoseOfTheDiameters() {
    QCOMPARE(matrix().ratio(mesh(15)), Rational(36, 72));
    QCOMPARE(matrix().ratio(mesh(16)), Rational(40, 60));
    QCOMPARE(matrix().ratio(mesh(17)), Rational(48, 36));
    QCOMPARE(matrix().ratio(mesh(18)), Rational(32, 48));
  }

  void eq21_inputsAreTurningPairsLessRank() {
    // Erratum: r is the rank of P; that of the cycle-basis matrix is always c.
    QCOMPARE(paper().analysis.rank, 4);
    QCOMPARE(paper().analysis.dof, 7 - 4);
  }

  void eq22_theInputsOfThePaperAreValid() {
    QVERIFY(paper().analysis.choice.joints == (std::vector<int>{joint(8), joint(9), joint(11)}));
    QVERIFY(paper().analysis.solution->outputs ==
            (std::vector<int>{joint(10), joint(12), joint(13), joint(14)}));
  }

  void eq23_outputsFollowFromTheInputs() {
    const auto exact = solveExact(paper().model, paper().analysis.choice.joints, paper().analysis.speeds);
    for (std::size_t i = 0; i < 4; ++i) {
      Rational sum;
      for (std::size_t j = 0; j < 3; ++j) sum += exact->matrix[i * 3 + j] * paper().analysis.speeds[j];
      QCOMPARE(sum, exact->rates[static_cast<std::size_t>(exact->outputs[i])]);
      QCOMPARE(paper().analysis.solution->rates[static_cast<std::size_t>(exact->outputs[i])], sum.toDouble());
    }
    QCOMPARE(exact->matrix[0], Rational(-1, 2));
    QCOMPARE(exact->matrix[9], Rational(-8, 27));  // -i18 i17 i16 i15 = -(2/3)(4/3)(2/3)(1/2)
  }

  void eq24_coefficientMatrixInRatios() {
    // Columns in the order of (24): 8 9 11 | 10 12 13 14.
    const std::vector<int> order{8, 9, 11, 10, 12, 13, 14};
    const std::vector<std::vector<QString>> expected{{"-i15", "0", "0", "-1", "0", "0", "0"},
                                                     {"0", "+i16", "0", "-i16", "+1", "0", "0"},
                                                     {"0", "0", "+i17", "0", "-i17", "+1", "0"},
                                                     {"0", "0", "0", "0", "0", "-i18", "+1"}};
    for (int row = 0; row < 4; ++row) {
      std::vector<QString> found(7, "0");
      for (const auto& entry : matrix().row(row)) {
        const auto column = std::find(order.begin(), order.end(), entry.joint + 8) - order.begin();
        found[static_cast<std::size_t>(column)] =
            QString(entry.sign > 0 ? "+" : "-") + (entry.tail ? QString("i%1").arg(row + 15) : QString("1"));
      }
      QCOMPARE(found, expected[static_cast<std::size_t>(row)]);
    }
  }

  void eq25_solutionInTheGearRatios() {
    // clang-format off
    const std::vector<QString> expected{
        //            8                   9              11
        "-i15",                "0",             "0",          // 10
        "-i16*i15",            "-i16",          "0",          // 12
        "-i17*i16*i15",        "-i17*i16",      "-i17",       // 13
        "-i18*i17*i16*i15",    "-i18*i17*i16",  "-i18*i17"};  // 14
    // clang-format on
    const SymbolicSolution solution = symbolic();
    QCOMPARE(solution.skipped, 0);
    for (std::size_t i = 0; i < expected.size(); ++i) {
      QCOMPARE(QString::fromStdString(solution.matrix[i]->toText()), expected[i]);
    }
  }

  void eq25_holdsForTheRobotAgainstItsArrows() {
    const Worked against(robotAgainstItsArrows());
    const std::vector<int> inputs{joint(8), joint(9), joint(11)};
    const auto exact = solveExact(against.model, inputs, std::vector<Rational>(3, Rational(1)));
    QCOMPARE(exact->matrix, solutionAgainstItsArrows());
    const CoefficientMatrix rows(against.mechanism, against.model, against.placement);
    const auto solved =
        solveSymbolic(against.mechanism, against.model, rows, against.analysis.independentMeshes, inputs);
    for (std::size_t i = 0; i < exact->matrix.size(); ++i) {
      QCOMPARE(solved->matrix[i]->valueAt(solved->ring->values()).value(), exact->matrix[i]);
    }
    for (int row = 0; row < 4; ++row) {  // (17)
      double sum = 0;
      for (const auto& entry : rows.row(row)) {
        sum += entry.length * exact->rates[static_cast<std::size_t>(entry.joint)].toDouble();
      }
      QVERIFY(std::abs(sum) < 1e-12);
    }
  }

  void eq25_linesAreFoundInThePapersOrder() {
    const SymbolicSolution solution = symbolic();
    QCOMPARE(solution.lines.size(), std::size_t{4});
    const std::vector<int> order{10, 12, 13, 14};
    for (std::size_t i = 0; i < 4; ++i) {
      QCOMPARE(solution.lines[i].joint, joint(order[i]));
      QCOMPARE(solution.lines[i].equation, static_cast<int>(i));
    }
    // The rows of (24), solved one by one.
    const std::vector<QString> expected{"-i15 q8", "-i16 q9 i16 q10", "-i17 q11 i17 q12", "i18 q13"};
    for (std::size_t i = 0; i < 4; ++i) {
      QStringList terms;
      for (const SymbolicLine::Term& term : solution.lines[i].terms) {
        terms << QString("%1 q%2").arg(QString::fromStdString(term.coefficient.toText())).arg(term.joint + 8);
      }
      QCOMPARE(terms.join(' '), expected[i]);
    }
  }
};

QTEST_APPLESS_MAIN(MatroidPaperTest)
#include "test_matroid_paper.moc"

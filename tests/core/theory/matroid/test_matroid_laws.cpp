#include <flint/fmpq_mat.h>

#include <QTest>

#include "core/theory/matroid/exact_solution.h"
#include "core/theory/matroid/symbolic_solution.h"
#include "tests/core/support/matroid_fixture.h"
#include "tests/core/support/train_sketch.h"
#include "tests/core/support/trains.h"

using namespace geargraph;
using namespace geargraph::test;

namespace {

constexpr int kTrains = 200;

/// Trains of 8 to 24 links, from loose to overconstrained.
Mechanism train(int number) {
  const int n = 8 + number % 17;
  return randomTrain(static_cast<std::uint64_t>(number) + 1, n, n / 3 + number % (n - n / 3));
}

/// The row of tooth counts over the joints' rates, from the coefficient matrix.
std::vector<std::pair<int, Rational>> toothRow(const Worked& worked, int mesh) {
  const CoefficientMatrix matrix(worked.mechanism, worked.model, worked.placement);
  std::vector<std::pair<int, Rational>> row;
  for (const auto& entry : matrix.row(mesh)) {
    row.emplace_back(entry.joint, Rational(entry.sign) * (entry.tail ? matrix.ratio(mesh) : Rational(1)));
  }
  return row;
}

/// The rank of P by FLINT's dense elimination of the joints' own rates: another route than phi.
int denseRank(const Worked& worked) {
  fmpq_mat_t dense;
  fmpq_mat_init(dense, worked.model.c(), worked.model.t());
  for (int mesh = 0; mesh < worked.model.c(); ++mesh) {
    for (const auto& [joint, value] : toothRow(worked, mesh)) {
      fmpq_set(fmpq_mat_entry(dense, mesh, joint), value.flint());
    }
  }
  const slong rank = fmpq_mat_rref(dense, dense);
  fmpq_mat_clear(dense);
  return static_cast<int>(rank);
}

}  // namespace

class MatroidLawsTest : public QObject {
  Q_OBJECT
 private slots:
  void rankIsThatOfADenseExactElimination() {
    int redundant = 0;
    int dead = 0;
    for (int i = 0; i < kTrains; ++i) {
      const Worked worked(train(i));
      QCOMPARE(worked.analysis.rank, denseRank(worked));
      QCOMPARE(worked.analysis.dof, worked.model.t() - worked.analysis.rank);
      QCOMPARE(static_cast<int>(worked.analysis.redundancies.size()),
               worked.model.c() - worked.analysis.rank);
      redundant += worked.analysis.redundancies.empty() ? 0 : 1;
      dead += worked.analysis.lockedLoops.empty() ? 0 : 1;
    }
    QVERIFY(redundant > 10 && dead > 10);  // the sample covers what it should
  }

  void exactRatesSolveEveryMeshEquation() {
    for (int i = 0; i < kTrains; ++i) {
      const Worked worked(train(i));
      const auto solution = solveExact(worked.model, worked.analysis.choice.joints, worked.analysis.speeds);
      for (int mesh = 0; mesh < worked.model.c(); ++mesh) {
        Rational sum;
        for (const auto& [joint, value] : toothRow(worked, mesh)) {
          sum += value * solution->rates[static_cast<std::size_t>(joint)];
        }
        QVERIFY(sum.isZero());
      }
      for (std::size_t j = 0; j < solution->inputs.size(); ++j) {
        QCOMPARE(solution->rates[static_cast<std::size_t>(solution->inputs[j])], worked.analysis.speeds[j]);
      }
    }
  }

  void doublesAreTheFractionsAndTheirZerosAreExact() {
    for (int i = 0; i < kTrains; ++i) {
      const Worked worked(train(i));
      const auto exact = solveExact(worked.model, worked.analysis.choice.joints, worked.analysis.speeds);
      const LiveSolution& live = *worked.analysis.solution;
      QVERIFY(live.outputs == exact->outputs);
      QCOMPARE(live.matrix.size(), exact->matrix.size());
      for (std::size_t k = 0; k < live.matrix.size(); ++k) {
        const double value = exact->matrix[k].toDouble();
        QVERIFY(std::abs(live.matrix[k] - value) <= 1e-9 * std::max(1.0, std::abs(value)));
        QCOMPARE(live.matrix[k] == 0, exact->matrix[k].isZero());
      }
      for (std::size_t k = 0; k < live.rates.size(); ++k) {
        QCOMPARE(live.rates[k] == 0, exact->rates[k].isZero());
        const double value = exact->rates[k].toDouble();
        QVERIFY(std::abs(live.rates[k] - value) <= 1e-9 * std::max(1.0, std::abs(value)));
      }
    }
  }

  void symbolsEvaluateToTheFractions() {
    int entries = 0;
    for (int i = 0; i < kTrains; ++i) {
      const Worked worked(train(i));
      const CoefficientMatrix matrix(worked.mechanism, worked.model, worked.placement);
      const auto exact = solveExact(worked.model, worked.analysis.choice.joints, worked.analysis.speeds);
      const auto symbolic = solveSymbolic(worked.mechanism, worked.model, matrix,
                                          worked.analysis.independentMeshes, worked.analysis.choice.joints);
      if (!symbolic) continue;
      QVERIFY(symbolic->outputs == exact->outputs);
      for (std::size_t k = 0; k < symbolic->matrix.size(); ++k) {
        if (!symbolic->matrix[k]) continue;
        const auto value = symbolic->matrix[k]->valueAt(symbolic->ring->values());
        QVERIFY(value.has_value());
        QCOMPARE(*value, exact->matrix[k]);
        ++entries;
      }
    }
    QVERIFY(entries > 5000);
  }

  void theLinesSolveTheMechanismInTheirOrder() {
    int lines = 0;
    for (int i = 0; i < kTrains; i += 4) {
      const Worked worked(train(i));
      const CoefficientMatrix matrix(worked.mechanism, worked.model, worked.placement);
      const auto exact = solveExact(worked.model, worked.analysis.choice.joints, worked.analysis.speeds);
      const auto symbolic = solveSymbolic(worked.mechanism, worked.model, matrix,
                                          worked.analysis.independentMeshes, worked.analysis.choice.joints);
      if (!symbolic) continue;
      std::vector<std::optional<Rational>> rates(static_cast<std::size_t>(worked.model.t()));
      for (std::size_t j = 0; j < exact->inputs.size(); ++j)
        rates[exact->inputs[j]] = worked.analysis.speeds[j];
      for (const SymbolicLine& line : symbolic->lines) {
        Rational sum;
        for (const auto& term : line.terms) {
          QVERIFY(rates[term.joint].has_value());
          sum += *term.coefficient.valueAt(symbolic->ring->values()) * *rates[term.joint];
        }
        QCOMPARE(sum, exact->rates[line.joint]);
        ++lines;
        rates[line.joint] = sum;
      }
    }
    QVERIFY2(lines > 200, qPrintable(QString::number(lines)));
  }

  void bothWheelsHaveOneVelocityAtEveryPitchPoint() {
    for (int i = 0; i < kTrains; ++i) {
      const Worked worked(train(i));
      // Velocities of points: walk out from the ground, each joint adds its rotation about its line.
      const auto& tree = *worked.placement.tree;
      std::vector<Vector3> angular(worked.mechanism.links.size(), Vector3{});
      std::vector<Vector3> atOrigin(worked.mechanism.links.size(), Vector3{});
      for (const int link : tree.order) {
        if (link == 0) continue;
        const int joint = tree.joint[link];
        const AxisLine& line = worked.placement.axes[tree.axisOf[joint]];
        const double speed =
            (tree.joints[joint].head == link ? 1 : -1) * worked.analysis.solution->rates[joint];
        const Vector3 spin = speed * line.direction;
        angular[link] = angular[tree.parent[link]] + spin;
        atOrigin[link] = atOrigin[tree.parent[link]] + cross(line.point, spin);
        QVERIFY(length(angular[link] - worked.analysis.linkVelocities[link]) <
                1e-6 * (1 + length(angular[link])));
      }
      for (const auto& mesh : worked.placement.meshes) {
        const auto velocity = [&](int link) {
          return atOrigin[link] + cross(angular[link], mesh->pitchPoint);
        };
        const double size = 1 + (length(angular[mesh->tail]) + length(angular[mesh->head])) * 1e6;
        QVERIFY(length(velocity(mesh->tail) - velocity(mesh->head)) < 1e-9 * size);
      }
    }
  }

  /// Eq. (15): what the head turns against the tail is what the joints of the cycle add up to, negated.
  void meshVelocitiesCloseTheirCycles() {
    for (int i = 0; i < kTrains; i += 3) {
      const Worked worked(train(i));
      const auto cycles = spanningTreeMatrix(worked.graph, worked.tree);
      const auto velocities = meshVelocities(worked.model, worked.analysis.linkVelocities);
      std::vector<MatrixEntry> row;
      for (int mesh = 0; mesh < worked.model.c(); ++mesh) {
        Vector3 sum = velocities[mesh];
        double size = 1;
        cycles->rowEntries(mesh, row);
        for (const MatrixEntry& entry : row) {
          const double rate = worked.analysis.solution->rates[entry.column];
          sum = sum + (entry.value * rate) *
                          worked.placement.axes[worked.placement.tree->axisOf[entry.column]].direction;
          size += std::abs(rate);
        }
        QVERIFY(length(sum) < 1e-9 * size);
      }
    }
  }

  void lengthsAndTeethAreTheSameRow() {
    for (int i = 0; i < kTrains; i += 3) {
      const Worked worked(train(i));
      const CoefficientMatrix matrix(worked.mechanism, worked.model, worked.placement);
      for (int mesh = 0; mesh < worked.model.c(); ++mesh) {
        const double head = std::abs(worked.placement.meshes[mesh]->headRadius);
        for (const auto& entry : matrix.row(mesh)) {
          const double normalised = entry.sign * (entry.tail ? matrix.ratio(mesh).toDouble() : 1);
          QVERIFY(std::abs(entry.length / head - normalised) < 1e-9 * (1 + std::abs(normalised)));
        }
        const auto exact = matrix.exactRadius(mesh, false);
        if (exact) QVERIFY(std::abs(exact->toDouble() - head) < 1e-9 * head);
      }
    }
  }

  void anAxisOrAJointTurnedRoundLeavesTheMotionAsItIs() {
    for (int i = 0; i < kTrains; i += 5) {
      Mechanism mechanism = train(i);
      const Worked before(mechanism);
      std::swap(mechanism.turningJoints[2].tail, mechanism.turningJoints[2].head);
      for (Number& component : *mechanism.axes[0].direction)
        component = Number(Rational(-2) * component.exact());
      const Worked after(mechanism);
      QCOMPARE(after.analysis.rank, before.analysis.rank);
      QVERIFY(after.analysis.dead == before.analysis.dead);
      QVERIFY(after.analysis.choice.joints == before.analysis.choice.joints);
    }
  }
};

QTEST_APPLESS_MAIN(MatroidLawsTest)
#include "test_matroid_laws.moc"

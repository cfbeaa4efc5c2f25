// What a C++ user would write instead, on the same trains: Eigen, KLU, FLINT's dense solver.

#include <benchmark/benchmark.h>
#include <flint/fmpz_mat.h>
#include <suitesparse/klu.h>

#include <Eigen/Dense>
#include <Eigen/Sparse>

#include "core/foundations/base/contract.h"
#include "core/theory/analysis/analysis.h"
#include "tests/bench/families.h"
#include "tests/core/support/trains.h"

namespace geargraph {
namespace {

using SparseMatrix = Eigen::SparseMatrix<double>;
using Triplets = std::vector<Eigen::Triplet<double>>;
using Family = Mechanism (*)(int links);

/// A train with its live analysis, and its mesh rows with the inputs' rows below: phi = solution of a square
/// system.
struct Problem {
  MechanismPtr mechanism;
  SnapshotPtr snapshot;

  explicit Problem(Mechanism train)
      : mechanism(std::make_shared<const Mechanism>(std::move(train))), snapshot(analyzeLive(mechanism)) {
    GEARGRAPH_REQUIRE(snapshot->matroid() != nullptr && snapshot->matroid()->solution);
  }
  [[nodiscard]] int n() const { return mechanism->n(); }
  [[nodiscard]] const std::vector<int>& inputs() const { return snapshot->matroid()->choice.joints; }
  [[nodiscard]] SparseRows<ModularDouble> rows() const {
    const KinematicModel& model = *snapshot->kinematics->model;
    const ModularDoubleField field;
    return inputRows(model, field, snapshot->matroid()->independentMeshes, inputs());
  }
};

/// The square system over the phi and its right-hand sides, one an input.
struct System {
  SparseMatrix matrix;
  Eigen::MatrixXd right;

  explicit System(const Problem& problem) {
    const SparseRows<ModularDouble> rows = problem.rows();
    Triplets triplets;
    for (int row = 0; row < rows.rows(); ++row) {
      for (int entry = rows.begin(row); entry < rows.end(row); ++entry) {
        if (rows.column(entry) < problem.n()) {
          triplets.emplace_back(row, rows.column(entry), rows.value(entry).number);
        }
      }
    }
    matrix.resize(rows.rows(), problem.n());
    matrix.setFromTriplets(triplets.begin(), triplets.end());
    const auto inputs = static_cast<Eigen::Index>(problem.inputs().size());
    right = Eigen::MatrixXd::Zero(rows.rows(), inputs);
    for (Eigen::Index i = 0; i < inputs; ++i) right(rows.rows() - inputs + i, i) = 1;
  }
};

SparseMatrix reducedIncidence(const Digraph& graph) {
  Triplets triplets;
  for (int e = 0; e < graph.edgeCount(); ++e) {
    if (graph.edge(e).tail > 0) triplets.emplace_back(graph.edge(e).tail - 1, e, -1.0);
    if (graph.edge(e).head > 0) triplets.emplace_back(graph.edge(e).head - 1, e, 1.0);
  }
  SparseMatrix gamma(graph.n(), graph.edgeCount());
  gamma.setFromTriplets(triplets.begin(), triplets.end());
  return gamma;
}

/// The whole analysis with sparse matrices: Γ, T from a factored G, the square system factored and solved. No
/// rank.
void eigenSparse(benchmark::State& state, Family family) {
  const Problem problem(family(static_cast<int>(state.range(0))));
  for (auto _ : state) {
    const Digraph graph(*problem.mechanism);
    const SparseMatrix gamma = reducedIncidence(graph);
    const SparseMatrix g = gamma.leftCols(graph.t());
    Eigen::SparseLU<SparseMatrix> tree(g);
    const SparseMatrix z = tree.solve(SparseMatrix(gamma.rightCols(graph.c())));  // -Tᵀ
    const System system(problem);
    Eigen::SparseLU<SparseMatrix> factored(system.matrix);
    const Eigen::MatrixXd phi = factored.solve(system.right);
    benchmark::DoNotOptimize(phi.data());
    benchmark::DoNotOptimize(z.valuePtr());
  }
}
BENCHMARK_CAPTURE(eigenSparse, tree, bench::drivenTree)->Arg(1'000)->Arg(10'000);
BENCHMARK_CAPTURE(eigenSparse, coupled, bench::coupledTree)->Arg(1'000)->Arg(10'000);

/// The paper's formulas with dense matrices: Z = -G⁻¹, T = G*ᵀ Zᵀ, P, and P_r⁻¹ P_E.
void eigenDenseRobot(benchmark::State& state) {
  const Problem problem(test::robot());
  const KinematicModel& model = *problem.snapshot->kinematics->model;
  const CoefficientMatrix coefficients(*problem.mechanism, model, problem.snapshot->kinematics->placement());
  for (auto _ : state) {
    const Digraph graph(*problem.mechanism);
    const Eigen::MatrixXd gamma(reducedIncidence(graph));
    const Eigen::MatrixXd z = -gamma.leftCols(graph.t()).inverse();
    const Eigen::MatrixXd treeBlock = gamma.rightCols(graph.c()).transpose() * z.transpose();
    Eigen::MatrixXd p = Eigen::MatrixXd::Zero(graph.c(), graph.t());
    for (int mesh = 0; mesh < graph.c(); ++mesh) {
      for (const CoefficientMatrix::Entry& entry : coefficients.row(mesh))
        p(mesh, int{entry.joint}) = entry.length;
    }
    const auto& solution = *problem.snapshot->matroid()->solution;
    const Eigen::MatrixXd theta =
        p(Eigen::all, solution.outputs).partialPivLu().solve(-p(Eigen::all, solution.inputs));
    benchmark::DoNotOptimize(theta.data());
    benchmark::DoNotOptimize(treeBlock.data());
  }
}
BENCHMARK(eigenDenseRobot);

/// KLU on the finished system: factor and solve, nothing else.
void kluAlone(benchmark::State& state, Family family) {
  const Problem problem(family(static_cast<int>(state.range(0))));
  System system(problem);
  system.matrix.makeCompressed();
  const auto size = static_cast<int>(system.matrix.cols());
  for (auto _ : state) {
    klu_common common;
    klu_defaults(&common);
    klu_symbolic* symbolic =
        klu_analyze(size, system.matrix.outerIndexPtr(), system.matrix.innerIndexPtr(), &common);
    klu_numeric* numeric = klu_factor(system.matrix.outerIndexPtr(), system.matrix.innerIndexPtr(),
                                      system.matrix.valuePtr(), symbolic, &common);
    Eigen::MatrixXd right = system.right;
    klu_solve(symbolic, numeric, size, static_cast<int>(right.cols()), right.data(), &common);
    benchmark::DoNotOptimize(right.data());
    klu_free_numeric(&numeric, &common);
    klu_free_symbolic(&symbolic, &common);
  }
}
BENCHMARK_CAPTURE(kluAlone, tree, bench::drivenTree)->Arg(1'000)->Arg(10'000);
BENCHMARK_CAPTURE(kluAlone, coupled, bench::coupledTree)->Arg(1'000)->Arg(10'000);

/// FLINT's dense rank and Dixon lifting on the same system.
void flintDense(benchmark::State& state, Family family) {
  const Problem problem(family(static_cast<int>(state.range(0))));
  const System system(problem);
  fmpz_mat_t matrix;
  fmpz_mat_t right;
  fmpz_mat_t solution;
  fmpz_t modulus;
  fmpz_mat_init(matrix, system.matrix.rows(), system.matrix.cols());
  fmpz_mat_init(right, system.right.rows(), system.right.cols());
  fmpz_mat_init(solution, system.right.rows(), system.right.cols());
  fmpz_init(modulus);
  for (int column = 0; column < system.matrix.outerSize(); ++column) {
    for (SparseMatrix::InnerIterator entry(system.matrix, column); entry; ++entry) {
      fmpz_set_si(fmpz_mat_entry(matrix, entry.row(), entry.col()), static_cast<slong>(entry.value()));
    }
  }
  for (Eigen::Index i = 0; i < system.right.rows(); ++i) {
    for (Eigen::Index j = 0; j < system.right.cols(); ++j) {
      fmpz_set_si(fmpz_mat_entry(right, i, j), static_cast<slong>(system.right(i, j)));
    }
  }
  for (auto _ : state) {
    benchmark::DoNotOptimize(fmpz_mat_rank(matrix));
    benchmark::DoNotOptimize(fmpz_mat_solve_dixon(solution, modulus, matrix, right));
  }
  fmpz_mat_clear(matrix);
  fmpz_mat_clear(right);
  fmpz_mat_clear(solution);
  fmpz_clear(modulus);
}
BENCHMARK_CAPTURE(flintDense, tree, bench::drivenTree)->Arg(1'000)->Iterations(1);
BENCHMARK_CAPTURE(flintDense, coupled, bench::coupledTree)->Arg(1'000)->Iterations(1);

}  // namespace
}  // namespace geargraph

BENCHMARK_MAIN();

#include <flint/fmpq_mat.h>

#include <QTest>
#include <random>

#include "core/foundations/exact/elimination.h"
#include "core/foundations/exact/expansion.h"
#include "core/foundations/exact/fields.h"

using namespace geargraph;

namespace {

using IntegerRows = std::vector<std::vector<std::int64_t>>;

/// Sparse whole numbers, some rows multiples of sums of others, so that ranks drop.
IntegerRows randomRows(std::mt19937_64& random, int rows, int columns, int entries) {
  IntegerRows matrix;
  for (int row = 0; row < rows; ++row) {
    std::vector<std::int64_t> values(static_cast<std::size_t>(columns), 0);
    if (row > 2 && random() % 4 == 0) {
      const auto& a = matrix[random() % matrix.size()];
      const auto& b = matrix[random() % matrix.size()];
      for (std::size_t i = 0; i < values.size(); ++i) values[i] = 2 * a[i] - 3 * b[i];
    } else {
      for (int i = 0; i < entries; ++i) {
        values[random() % values.size()] = static_cast<std::int64_t>(random() % 9) - 4;
      }
    }
    matrix.push_back(values);
  }
  return matrix;
}

template <class Field>
SparseRows<typename Field::Value> sparse(const Field& field, const IntegerRows& matrix) {
  SparseRows<typename Field::Value> rows;
  for (const auto& row : matrix) {
    for (std::size_t i = 0; i < row.size(); ++i) {
      if (row[i] != 0) rows.add(static_cast<int>(i), field.fromInteger(row[i]));
    }
    rows.endRow();
  }
  return rows;
}

/// The rank by FLINT's dense elimination.
int denseRank(const IntegerRows& matrix, int columns) {
  fmpq_mat_t dense;
  fmpq_mat_init(dense, static_cast<slong>(matrix.size()), columns);
  for (std::size_t i = 0; i < matrix.size(); ++i) {
    for (int j = 0; j < columns; ++j) {
      fmpq_set_si(fmpq_mat_entry(dense, static_cast<slong>(i), j), matrix[i][static_cast<std::size_t>(j)], 1);
    }
  }
  const slong rank = fmpq_mat_rref(dense, dense);
  fmpq_mat_clear(dense);
  return static_cast<int>(rank);
}

Rational rowSum(const std::vector<std::int64_t>& row, const std::vector<Rational>& x) {
  Rational sum;
  for (std::size_t i = 0; i < row.size(); ++i) sum += Rational(row[i]) * x[i];
  return sum;
}

/// A chain of n unknowns, each following from the one before, behind one given column.
IntegerRows chain(int n) {
  IntegerRows rows;
  for (int i = 0; i < n; ++i) {
    std::vector<std::int64_t> row(static_cast<std::size_t>(n) + 1, 0);
    row[static_cast<std::size_t>(i)] = 3;
    row[static_cast<std::size_t>(i == 0 ? n : i - 1)] = -2;
    rows.push_back(row);
  }
  return rows;
}

}  // namespace

class EliminationTest : public QObject {
  Q_OBJECT
 private slots:
  void rankIsThatOfADenseEliminationInEveryArithmetic() {
    std::mt19937_64 random(4);
    for (int round = 0; round < 200; ++round) {
      const int rows = 1 + static_cast<int>(random() % 14);
      const int columns = 1 + static_cast<int>(random() % 14);
      const IntegerRows matrix = randomRows(random, rows, columns, 3);
      const int rank = denseRank(matrix, columns);
      const RationalField rational;
      const ModularDoubleField fused;
      const auto exact = eliminate(rational, sparse(rational, matrix), columns, columns);
      const auto live = eliminate(fused, sparse(fused, matrix), columns, columns);
      QCOMPARE(exact->rank(), rank);
      QCOMPARE(live->rank(), rank);
      QCOMPARE(exact->rank() + static_cast<int>(exact->freeColumns.size()), columns);
      QCOMPARE(exact->rank() + static_cast<int>(exact->checks.size()), rows);
    }
  }

  void substitutionSolvesEveryRow() {
    std::mt19937_64 random(5);
    const RationalField field;
    for (int round = 0; round < 200; ++round) {
      const int columns = 2 + static_cast<int>(random() % 12);
      const IntegerRows matrix = randomRows(random, 1 + static_cast<int>(random() % 10), columns, 3);
      const auto system = eliminate(field, sparse(field, matrix), columns, columns);
      std::vector<Rational> x(static_cast<std::size_t>(columns));
      for (const int column : system->freeColumns) x[static_cast<std::size_t>(column)] = Rational(1 + column);
      substitute(field, *system, x);
      for (const auto& row : matrix) QVERIFY(rowSum(row, x).isZero());
    }
  }

  void givenColumnsStayGivenAndTheRelationsAmongThemAreFound() {
    // x0 = 2 g2, x0 = g3: so g3 = 2 g2 and nothing else.
    const RationalField field;
    const IntegerRows matrix{{1, 0, -2, 0}, {1, 0, 0, -1}, {1, 1, 0, 0}};
    const auto system = eliminate(field, sparse(field, matrix), 2, 4);
    QCOMPARE(system->rank(), 2);
    QCOMPARE(system->checks.size(), std::size_t{1});
    std::vector<Rational> x{0, 0, 5, 10};
    substitute(field, *system, x);
    QCOMPARE(x[0], Rational(10));
    QCOMPARE(x[1], Rational(-10));
    QVERIFY(checkValue(field, *system, system->checks[0], x).isZero());
    x[3] = 11;
    substitute(field, *system, x);
    QVERIFY(!checkValue(field, *system, system->checks[0], x).isZero());
  }

  void doublesAndFractionsGiveTheSameNumbers() {
    std::mt19937_64 random(6);
    const RationalField rational;
    const ModularDoubleField fused;
    int compared = 0;
    for (int round = 0; round < 100; ++round) {
      const int columns = 4 + static_cast<int>(random() % 10);
      const IntegerRows matrix = randomRows(random, columns - 2, columns, 4);
      const auto exact = eliminate(rational, sparse(rational, matrix), columns - 2, columns);
      std::vector<Rational> x(static_cast<std::size_t>(columns));
      x[static_cast<std::size_t>(columns) - 1] = Rational(3);
      x[static_cast<std::size_t>(columns) - 2] = Rational(-7);
      for (const int column : exact->freeColumns) x[static_cast<std::size_t>(column)] = Rational(column);
      const auto live = eliminate(fused, sparse(fused, matrix), columns - 2, columns);
      if (live->freeColumns != exact->freeColumns) continue;  // another choice of what is free
      ++compared;
      std::vector<ModularDouble> y;
      for (const Rational& value : x) {
        QVERIFY(value.isInteger());
        y.push_back(fused.fromInteger(static_cast<std::int64_t>(value.toDouble())));
      }
      substitute(rational, *exact, x);
      substitute(fused, *live, y);
      for (std::size_t i = 0; i < x.size(); ++i) {
        QCOMPARE(y[i].residue, *fused.prime().fromRational(x[i]));
        QVERIFY(std::abs(y[i].number - x[i].toDouble()) <= 1e-9 * (1 + std::abs(x[i].toDouble())));
      }
    }
    QVERIFY2(compared > 50, qPrintable(QString::number(compared)));
  }

  void aChainPeelsWithoutArithmetic() {
    const RationalField field;
    const auto system = eliminate(field, sparse(field, chain(50)), 50, 51);
    QCOMPARE(system->rank(), 50);
    QCOMPARE(system->coreSize, 0);
    std::vector<Rational> x(51);
    x[50] = Rational(1);
    substitute(field, *system, x);
    QCOMPARE(x[2], Rational(8, 27));
  }

  void symbolsEvaluateToTheFractions() {
    // a x0 - x1 = 0, x1 - b x0 - c g = 0 : x0 = c g/(a - b), a core of two rows.
    const std::vector<Rational> values{Rational(5, 2), Rational(1, 3), Rational(4, 7)};
    const auto ring =
        std::make_shared<RatioRing>(std::vector<std::string>{"i5", "i6", "i7"},
                                    std::vector<RatioRing::Teeth>{{50, 20}, {20, 60}, {40, 70}});
    const RationalFunctionField field(ring);
    SparseRows<RationalFunction> rows;
    rows.add(0, RationalFunction::variable(ring, 0));
    rows.add(1, field.fromInteger(-1));
    rows.endRow();
    rows.add(1, field.one());
    rows.add(0, -RationalFunction::variable(ring, 1));
    rows.add(2, -RationalFunction::variable(ring, 2));
    rows.endRow();
    const auto system = eliminate(field, rows, 2, 3);
    QCOMPARE(system->coreSize, 2);
    std::vector<std::optional<RationalFunction>> x(3);
    x[2] = field.one();
    ExpansionBudget budget;
    QVERIFY(expand(field, *system, {0, 0, 0}, x, budget));
    QCOMPARE(QString::fromStdString(x[0]->toText()), "i7/(i5 - i6)");
    QCOMPARE(*x[0]->valueAt(values), Rational(4, 7) / (Rational(5, 2) - Rational(1, 3)));
  }

  void aPivotThatVanishesAtTheRatiosOwnValuesIsNotTaken() {
    // (i3 - i4) x0 + x1 - g = 0, x0 + x1 - 2 g = 0 with i3 = i4: x1 = g must come first.
    const auto ring = std::make_shared<RatioRing>(std::vector<std::string>{"i3", "i4"},
                                                  std::vector<RatioRing::Teeth>{{10, 20}, {15, 30}});
    const RationalFunctionField field(ring);
    SparseRows<RationalFunction> rows;
    rows.add(0, RationalFunction::variable(ring, 0) - RationalFunction::variable(ring, 1));
    rows.add(1, field.one());
    rows.add(2, field.fromInteger(-1));
    rows.endRow();
    rows.add(0, field.one());
    rows.add(1, field.one());
    rows.add(2, field.fromInteger(-2));
    rows.endRow();
    const auto system = eliminate(field, rows, 2, 3);
    for (const auto& line : system->lines) {
      QVERIFY(!pivotOf(system->matrixOf(line.core), line.row, line.column).vanishesAtValues());
    }
    std::vector<std::optional<RationalFunction>> x(3);
    x[2] = field.one();
    ExpansionBudget budget;
    QVERIFY(expand(field, *system, {0, 0, 0}, x, budget));
    QCOMPARE(*x[0]->valueAt(ring->values()), Rational(1));
  }

  void anEntryOverTheBudgetIsLeftOutAndWhatNeedsItToo() {
    std::vector<std::string> names;
    for (int k = 0; k < 12; ++k) names.push_back("i" + std::to_string(20 + k));
    const auto ring = std::make_shared<RatioRing>(names);
    const RationalFunctionField field(ring);
    SparseRows<RationalFunction> rows;  // x_k = (1 + i_k) x_{k-1}
    for (int k = 0; k < 12; ++k) {
      rows.add(k, field.one());
      rows.add(k == 0 ? 12 : k - 1, -(field.one() + RationalFunction::variable(ring, k)));
      rows.endRow();
    }
    const auto system = eliminate(field, rows, 12, 13);
    std::vector<std::optional<RationalFunction>> x(13);
    x[12] = field.one();
    ExpansionBudget budget;
    QVERIFY(expand(field, *system, std::vector<char>(13, 0), x, budget));
    QCOMPARE(x[6]->termCount(), 129);  // 2^7 and the denominator 1
    QVERIFY(!x[7].has_value());
    QVERIFY(!x[11].has_value());
  }

  void aStopEndsTheElimination() {
    const RationalField field;
    std::stop_source stop;
    stop.request_stop();
    const IntegerRows core{{1, 2, 3}, {4, 5, 6}, {7, 8, 10}};
    QVERIFY(!eliminate(field, sparse(field, core), 3, 3, stop.get_token()).has_value());
  }
};

QTEST_APPLESS_MAIN(EliminationTest)
#include "test_elimination.moc"

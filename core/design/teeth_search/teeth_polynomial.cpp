#include "core/design/teeth_search/teeth_polynomial.h"

#include <flint/fmpz_mat.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>

#include "core/foundations/base/contract.h"

namespace geargraph {
namespace {

/// A matrix of whole numbers of any size, FLINT's.
class WholeMatrix {
 public:
  WholeMatrix(std::size_t rows, int columns) {
    fmpz_mat_init(m_matrix, static_cast<slong>(rows), static_cast<slong>(columns));
  }
  WholeMatrix(const WholeMatrix&) = delete;
  WholeMatrix& operator=(const WholeMatrix&) = delete;
  ~WholeMatrix() { fmpz_mat_clear(m_matrix); }

  void clearRow(std::size_t row) {
    for (slong column = 0; column < fmpz_mat_ncols(m_matrix); ++column)
      fmpz_zero(fmpz_mat_entry(m_matrix, static_cast<slong>(row), column));
  }
  void add(std::size_t row, int column, std::int64_t value) {
    fmpz* const entry = fmpz_mat_entry(m_matrix, static_cast<slong>(row), static_cast<slong>(column));
    if (value >= 0) fmpz_add_ui(entry, entry, static_cast<ulong>(value));
    if (value < 0) fmpz_sub_ui(entry, entry, static_cast<ulong>(-value));
  }
  [[nodiscard]] int rank() const { return static_cast<int>(fmpz_mat_rank(m_matrix)); }
  /// @pre it fits
  [[nodiscard]] std::int64_t determinant() const {
    fmpz_t value;
    fmpz_init(value);
    fmpz_mat_det(value, m_matrix);
    GEARGRAPH_REQUIRE(fmpz_fits_si(value) != 0);
    const std::int64_t result = fmpz_get_si(value);
    fmpz_clear(value);
    return result;
  }

 private:
  fmpz_mat_t m_matrix;
};

/// The row with these numbers for N_tail and N_head.
void setRow(WholeMatrix& matrix, std::size_t at, const SpeedRow& row, std::int64_t tail, std::int64_t head) {
  matrix.clearRow(at);
  for (const SpeedRow::Entry& entry : row.entries)
    matrix.add(at, entry.column, entry.factor * (row.isOfMesh() ? (entry.ofTail ? tail : head) : 1));
}

using Counts = std::map<int, int>;

Counts countsOf(const TeethPolynomial::Term& term) {
  Counts counts;
  for (const int wheel : term.wheels) ++counts[wheel];
  return counts;
}

void dropWheels(TeethPolynomial& polynomial, const Counts& common) {
  for (TeethPolynomial::Term& term : polynomial.terms) {
    for (const auto& [wheel, count] : common) {
      const auto first = std::find(term.wheels.begin(), term.wheels.end(), wheel);
      term.wheels.erase(first, first + count);
    }
  }
}

}  // namespace

double TeethPolynomial::sizeAt(std::span<const int> teeth) const {
  double sum = 0;
  for (const Term& term : terms) {
    double product = std::abs(static_cast<double>(term.factor));
    for (const int wheel : term.wheels) product *= teeth[static_cast<std::size_t>(wheel)];
    sum += product;
  }
  return sum;
}

void dropCommonWheels(TeethPolynomial& one, TeethPolynomial& other) {
  std::optional<Counts> common;
  for (const TeethPolynomial* each : {&one, &other}) {
    for (const TeethPolynomial::Term& term : each->terms) {
      const Counts counts = countsOf(term);
      if (!common) {
        common = counts;
        continue;
      }
      for (auto& [wheel, count] : *common) {
        const auto found = counts.find(wheel);
        count = found == counts.end() ? 0 : std::min(count, found->second);
      }
    }
  }
  if (!common) return;
  dropWheels(one, *common);
  dropWheels(other, *common);
}

TeethPolynomial determinantOf(std::span<const SpeedRow> rows) {
  std::vector<std::size_t> meshes;
  for (std::size_t row = 0; row < rows.size(); ++row)
    if (rows[row].isOfMesh()) meshes.push_back(row);
  GEARGRAPH_REQUIRE(meshes.size() <= kMaxVariedMeshes);
  WholeMatrix matrix(rows.size(), static_cast<int>(rows.size()));
  for (std::size_t row = 0; row < rows.size(); ++row) setRow(matrix, row, rows[row], 1, 0);
  std::map<std::vector<int>, std::int64_t> factors;
  std::vector<int> wheels(meshes.size());
  for (std::size_t choice = 0; choice < std::size_t{1} << meshes.size(); ++choice) {
    for (std::size_t i = 0; i < meshes.size(); ++i) {
      const SpeedRow& row = rows[meshes[i]];
      const bool isHead = (choice >> i & 1U) != 0;
      setRow(matrix, meshes[i], row, isHead ? 0 : 1, isHead ? 1 : 0);
      wheels[i] = isHead ? row.headWheel : row.tailWheel;
    }
    const std::int64_t factor = matrix.determinant();
    if (factor == 0) continue;
    std::vector<int> sorted = wheels;
    std::sort(sorted.begin(), sorted.end());
    factors[std::move(sorted)] += factor;
  }
  TeethPolynomial result;
  for (auto& [of, factor] : factors)
    if (factor != 0) result.terms.push_back({factor, of});
  return result;
}

int rankAt(std::span<const SpeedRow> rows, int columns, std::span<const int> teeth) {
  if (rows.empty()) return 0;
  WholeMatrix matrix(rows.size(), columns);
  for (std::size_t row = 0; row < rows.size(); ++row) {
    const SpeedRow& each = rows[row];
    const auto of = [&](int wheel) { return wheel < 0 ? 0 : teeth[static_cast<std::size_t>(wheel)]; };
    setRow(matrix, row, each, of(each.tailWheel), of(each.headWheel));
  }
  return matrix.rank();
}

}  // namespace geargraph

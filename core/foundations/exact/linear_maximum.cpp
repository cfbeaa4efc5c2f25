#include "core/foundations/exact/linear_maximum.h"

#include "core/foundations/base/contract.h"

namespace geargraph {
namespace {

/// The dictionary of the simplex method: basic variables, one a row, as linear functions of those that are 0.
/// An unknown of any sign is the difference of two variables; after these come the slacks of the bounds.
class Dictionary {
 public:
  Dictionary(std::span<const LinearBound> bounds, std::span<const Rational> objective) {
    const std::size_t unknowns = objective.size();
    for (std::size_t i = 0; i < 2 * unknowns; ++i) m_nonbasic.push_back(i);
    const auto split = [](std::span<const Rational> values) {
      std::vector<Rational> both(values.begin(), values.end());
      for (const Rational& value : values) both.push_back(-value);
      return both;
    };
    m_gain = split(objective);
    for (const LinearBound& bound : bounds) {
      GEARGRAPH_REQUIRE(bound.bound.sign() >= 0 && bound.coefficients.size() == unknowns);
      m_basic.push_back(2 * unknowns + m_basic.size());
      m_rows.push_back({split(bound.coefficients), bound.bound});
    }
  }

  /// The variable of the least number whose growth is a gain.
  [[nodiscard]] std::optional<std::size_t> entering() const {
    std::optional<std::size_t> best;
    for (std::size_t column = 0; column < m_nonbasic.size(); ++column)
      if (m_gain[column].sign() > 0 && (!best || m_nonbasic[column] < m_nonbasic[*best])) best = column;
    return best;
  }

  /// The basic variable that reaches 0 first while the one of this column grows; none: it grows for ever.
  [[nodiscard]] std::optional<std::size_t> leaving(std::size_t column) const {
    std::optional<std::size_t> best;
    Rational least;
    for (std::size_t row = 0; row < m_rows.size(); ++row) {
      const Rational& coefficient = m_rows[row].coefficients[column];
      if (coefficient.sign() <= 0) continue;
      Rational limit = m_rows[row].bound / coefficient;
      if (best && (limit > least || (limit == least && m_basic[row] > m_basic[*best]))) continue;
      best = row;
      least = std::move(limit);
    }
    return best;
  }

  void pivot(std::size_t row, std::size_t column) {
    LinearBound& pivotRow = m_rows[row];
    const Rational inverse = pivotRow.coefficients[column].inverse();
    pivotRow.coefficients[column] = 1;
    for (Rational& coefficient : pivotRow.coefficients) coefficient = coefficient * inverse;
    pivotRow.bound = pivotRow.bound * inverse;
    const auto eliminate = [&](std::vector<Rational>& coefficients) {
      const Rational factor = coefficients[column];
      if (factor.isZero()) return factor;
      coefficients[column] = 0;
      for (std::size_t i = 0; i < coefficients.size(); ++i)
        coefficients[i] -= factor * pivotRow.coefficients[i];
      return factor;
    };
    for (std::size_t other = 0; other < m_rows.size(); ++other) {
      if (other == row) continue;
      const Rational factor = eliminate(m_rows[other].coefficients);
      m_rows[other].bound -= factor * pivotRow.bound;
    }
    m_value += eliminate(m_gain) * pivotRow.bound;
    std::swap(m_basic[row], m_nonbasic[column]);
  }

  [[nodiscard]] const Rational& value() const { return m_value; }

 private:
  std::vector<std::size_t> m_nonbasic;  ///< by column
  std::vector<std::size_t> m_basic;     ///< by row
  std::vector<LinearBound> m_rows;
  std::vector<Rational> m_gain;
  Rational m_value = 0;
};

}  // namespace

std::optional<Rational> linearMaximum(std::span<const LinearBound> bounds,
                                      std::span<const Rational> objective, int mostPivots) {
  Dictionary dictionary(bounds, objective);
  for (int pivots = 0;; ++pivots) {
    const auto column = dictionary.entering();
    if (!column) return dictionary.value();
    const auto row = dictionary.leaving(*column);
    if (!row || pivots == mostPivots) return std::nullopt;
    dictionary.pivot(*row, *column);
  }
}

}  // namespace geargraph

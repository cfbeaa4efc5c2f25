#pragma once

#include <map>
#include <span>
#include <vector>

#include "core/foundations/exact/real.h"

namespace geargraph::inline exact {

/// A vector whose entries are sums of fractions times square roots, kept as one vector of fractions for each
/// root: sum over k of sqrt(square_k) * entries_k. No two roots are rational multiples of each other, so the
/// whole is 0, or solves linear equations with rational coefficients, exactly if every part does (square
/// roots of this kind are linearly independent over the rational numbers: A. S. Besicovitch, J. London Math.
/// Soc. 15, 1940, 3-6). So directions of irrational length spoil no decision.
class RadicalColumns {
 public:
  struct Column {
    Rational square = 1;
    std::map<int, Rational> entries;  ///< by place; none is 0
  };

  /// entry(place) += coefficient * sqrt(square). @pre square is above 0
  void add(int place, const Rational& coefficient, const Rational& square = 1);

  /// The first is that of fractions (square 1), whether it has entries or not.
  [[nodiscard]] const std::vector<Column>& columns() const { return m_columns; }
  [[nodiscard]] int count() const { return static_cast<int>(m_columns.size()); }
  /// The number whose parts are these, one for each column.
  [[nodiscard]] Real sumOf(std::span<const Rational> parts) const;
  /// The entry at a place.
  [[nodiscard]] Real at(int place) const;

 private:
  std::vector<Column> m_columns = std::vector<Column>(1);
};

}  // namespace geargraph::inline exact

#pragma once

#include <map>
#include <span>
#include <vector>

#include "core/foundations/exact/real.h"

namespace geargraph {

/// A vector whose entries are sums of fractions times square roots, stored as one vector of fractions per
/// root: sum over k of sqrt(square_k) * entries_k. No two roots are rational multiples of each other, so the
/// vector is 0, or solves linear equations with rational coefficients, if and only if every part does (such
/// square roots are linearly independent over the rational numbers: A. S. Besicovitch, J. London Math. Soc.
/// 15, 1940, 3-6). So decisions stay exact for directions of irrational length.
class RadicalColumns {
 public:
  struct Column {
    Rational square = 1;
    std::map<int, Rational> entries;  ///< by position; none is 0
  };

  /// entry(place) += coefficient * sqrt(square). @pre square is above 0
  void add(int place, const Rational& coefficient, const Rational& square = 1);

  /// The first one is that of the fractions (square 1), even if it has no entries.
  [[nodiscard]] const std::vector<Column>& columns() const { return m_columns; }
  [[nodiscard]] int count() const { return static_cast<int>(m_columns.size()); }
  /// The number with these parts, one for each column.
  [[nodiscard]] Real sumOf(std::span<const Rational> parts) const;
  /// The entry at a place.
  [[nodiscard]] Real at(int place) const;

 private:
  std::vector<Column> m_columns = std::vector<Column>(1);
};

}  // namespace geargraph

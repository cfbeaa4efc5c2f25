#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/foundations/base/rational.h"

namespace geargraph {

__extension__ using WideInteger = __int128;  ///< GCC and clang have it, ISO C++ does not

/// A polynomial in the teeth of wheels with whole coefficients.
struct TeethPolynomial {
  struct Term {
    std::int64_t factor = 0;
    std::vector<int> wheels;  ///< ascending; one that stands twice is squared
    friend bool operator==(const Term&, const Term&) = default;
  };
  std::vector<Term> terms;  ///< by wheels, none with a factor of 0

  [[nodiscard]] bool isZero() const { return terms.empty(); }
  /// The sum of the values of the terms without their signs. @pre an entry for each wheel
  [[nodiscard]] double sizeAt(std::span<const int> teeth) const;
  /// @pre an entry for each wheel; for WideInteger: sizeAt() is below 2^126
  template <class BigInteger>
  [[nodiscard]] BigInteger at(std::span<const int> teeth) const {
    BigInteger sum = 0;
    for (const Term& term : terms) {
      BigInteger product = static_cast<BigInteger>(term.factor);
      for (const int wheel : term.wheels)
        product *= static_cast<BigInteger>(teeth[static_cast<std::size_t>(wheel)]);
      sum += product;
    }
    return sum;
  }
  friend bool operator==(const TeethPolynomial&, const TeethPolynomial&) = default;
};

/// Divides both by the wheels that all their terms have in common, whose teeth are never 0.
void dropCommonWheels(TeethPolynomial& one, TeethPolynomial& other);

/// An equation of speeds: the entries of unknowns, and for the row of a mesh the wheels whose teeth multiply
/// them.
struct SpeedRow {
  struct Entry {
    int column = 0;
    int factor = 0;
    bool ofTail = false;  ///< of a mesh's row: times N_tail, else times N_head
  };
  std::vector<Entry> entries;
  int tailWheel = -1;  ///< -1: no mesh
  int headWheel = -1;

  [[nodiscard]] bool isOfMesh() const { return tailWheel >= 0; }
};

/// Gear pairs that may be in one determinant: it has up to 2^kMaxVariedMeshes terms.
constexpr std::size_t kMaxVariedMeshes = 14;

/// The determinant of a square system as a polynomial in the teeth. Each row is of degree 1 in the two wheels
/// of its mesh, so the coefficients are determinants of whole numbers, one for each choice of tail or head.
///
/// Cost: 2^m determinants, m the rows of meshes. @pre at most kMaxVariedMeshes rows are of meshes
[[nodiscard]] TeethPolynomial determinantOf(std::span<const SpeedRow> rows);

/// The rank of rows at these teeth. Cost: an elimination in whole numbers.
[[nodiscard]] int rankAt(std::span<const SpeedRow> rows, int columns, std::span<const int> teeth);

}  // namespace geargraph

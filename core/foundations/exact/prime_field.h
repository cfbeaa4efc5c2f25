#pragma once

#include <cstdint>
#include <optional>

#include "core/foundations/base/rational.h"

namespace geargraph {

__extension__ using Wide = unsigned __int128;  ///< GCC and clang have it, ISO C++ does not

/// Arithmetic modulo a 61-bit prime drawn from a seed. Residues are in Montgomery form: only 0 is represented
/// by itself.
///
/// What is not 0 here is not 0 over the rationals. What is 0 here is 0 there except with a probability near
/// 2^-60, which a second prime squares.
class PrimeField {
 public:
  using Residue = std::uint64_t;

  static constexpr std::uint64_t kFirstSeed = 0x6765617267726170U;  ///< the default
  static constexpr std::uint64_t kSecondSeed = 0x6d6174726f6964U;   ///< to confirm zeros of the first

  /// Uses the smallest prime above a 61-bit number derived from `seed`.
  explicit PrimeField(std::uint64_t seed = kFirstSeed);

  [[nodiscard]] std::uint64_t prime() const { return m_prime; }
  [[nodiscard]] Residue one() const { return m_one; }

  [[nodiscard]] Residue fromInteger(std::int64_t value) const {
    const std::uint64_t magnitude =
        value < 0 ? 0 - static_cast<std::uint64_t>(value) : static_cast<std::uint64_t>(value);
    // Whole numbers of a document are far below the prime: no division.
    const Residue residue = multiply(magnitude < m_prime ? magnitude : magnitude % m_prime, m_square);
    return value < 0 ? negate(residue) : residue;
  }
  /// std::nullopt if the prime divides the denominator.
  [[nodiscard]] std::optional<Residue> fromRational(const Rational& value) const;
  /// The number 0..p-1 of a residue.
  [[nodiscard]] std::uint64_t toNumber(Residue residue) const { return reduce(residue); }

  [[nodiscard]] Residue add(Residue a, Residue b) const {
    const std::uint64_t sum = a + b;
    return sum >= m_prime ? sum - m_prime : sum;
  }
  [[nodiscard]] Residue subtract(Residue a, Residue b) const { return a >= b ? a - b : a + m_prime - b; }
  [[nodiscard]] Residue negate(Residue a) const { return a == 0 ? 0 : m_prime - a; }
  [[nodiscard]] Residue multiply(Residue a, Residue b) const { return reduce(static_cast<Wide>(a) * b); }
  /// `sum` + b c, for sums of products that are reduced only at the end, by valueOf(). A sum starts with 0.
  [[nodiscard]] Wide addProduct(Wide sum, Residue b, Residue c) const {
    const Wide longer = sum + static_cast<Wide>(b) * c;
    const Wide whole = static_cast<Wide>(m_prime) << 64U;
    return longer >= whole ? longer - whole : longer;
  }
  [[nodiscard]] Residue valueOf(Wide sum) const { return reduce(sum); }
  /// @pre a is not 0
  [[nodiscard]] Residue inverse(Residue a) const;

 private:
  PrimeField(std::uint64_t prime, std::uint64_t minusInverse)
      : m_prime(prime), m_minusInverse(minusInverse) {}
  static PrimeField modulo(std::uint64_t prime);

  /// wide / 2^64 modulo the prime. @pre wide < prime * 2^64
  [[nodiscard]] std::uint64_t reduce(Wide wide) const {
    const std::uint64_t multiple = static_cast<std::uint64_t>(wide) * m_minusInverse;
    const auto folded = static_cast<std::uint64_t>((wide + static_cast<Wide>(multiple) * m_prime) >> 64U);
    return folded >= m_prime ? folded - m_prime : folded;
  }

  std::uint64_t m_prime = 0;
  std::uint64_t m_minusInverse = 0;  ///< -1/p modulo 2^64
  std::uint64_t m_square = 0;        ///< 2^128 modulo p
  Residue m_one = 0;                 ///< 2^64 modulo p
};

/// A pseudorandom sequence of residues, determined by its seed, for evaluations at random points.
class ResidueStream {
 public:
  ResidueStream(const PrimeField& field, std::uint64_t seed) : m_field(&field), m_state(seed) {}
  /// Never 0.
  [[nodiscard]] PrimeField::Residue next();

 private:
  const PrimeField* m_field;
  std::uint64_t m_state;
};

}  // namespace geargraph
